"""Frequencies of rotors: a mass on springs, whose frequencies are known, and a bar."""

import matplotlib.pyplot as plt
import meshes
import numpy as np
import pytest
import scipy.sparse

from dalembert import FEM

OMEGA = 2 * np.pi * 7.0


@pytest.fixture
def mass():
    fem = FEM.FEMinterface()
    fem.nodes = {"Position": np.zeros((1, 3))}
    fem.massMatrix = 2.0 * scipy.sparse.eye(3, format="csr")
    fem.stiffnessMatrix = 2.0 * OMEGA**2 * scipy.sparse.diags([1.0, 1.0, 9.0], format="csr")
    return fem


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_mass_on_springs(mass, axis):
    mass.stiffnessMatrix = 2.0 * OMEGA**2 * scipy.sparse.diags(np.where(np.arange(3) == axis, 9.0, 1.0), format="csr")
    speeds, lists = mass.ComputeCampbellDiagram(5.0, 2, 5, rotationAxis=axis)
    half = np.array(speeds) / 2  # w^2 -+ W w - k/m = 0
    root = np.sqrt(49 + half**2)
    np.testing.assert_allclose(np.array(lists), np.stack([root - half, root + half, 0 * root + 21], axis=1), rtol=1e-9)
    options = {"rotationAxis": axis, "useCorotationalFrame": True, "centrifugalTerms": True}
    speeds, lists = mass.ComputeCampbellDiagram(5.0, 2, 5, **options)
    expected = np.stack([7 - np.array(speeds), 7 + np.array(speeds), 0 * root + 21], axis=1)
    np.testing.assert_allclose(np.array(lists), expected, rtol=1e-9)


def test_sparse_and_dense_solutions_agree():
    fem = meshes.solid("Hex8", (8, 2, 2), (1.0, 0.1, 0.1))
    for node in fem.GetNodesInPlane([0, 0, 0], [1, 0, 0]) + fem.GetNodesInPlane([1, 0, 0], [1, 0, 0]):
        fem.AddElasticSupportAtNode(node, [1e7, 1e7, 1e7])
    options = {"nEigenfrequencies": 5, "frequencySteps": 2, "rotationAxis": 0}
    _, dense = fem.ComputeCampbellDiagram(200.0, **options)
    _, sparse = fem.ComputeCampbellDiagram(200.0, **options, useSparseSolver=True)
    np.testing.assert_allclose(sparse, dense, rtol=1e-7)
    assert np.all(np.diff(np.array(dense)[:, 0]) < 0)  # backward whirl falls
    fem.ComputeEigenmodes(6)
    np.testing.assert_allclose(dense[0], fem.GetEigenFrequenciesHz(), rtol=1e-7)


def test_a_free_rotor_has_one_zero():
    fem = meshes.solid("Hex8", (4, 1, 1), (1.0, 0.2, 0.2))
    _, lists = fem.ComputeCampbellDiagram(0.0, 3, 1)
    fem.ComputeEigenmodes(3, 6)
    np.testing.assert_allclose(lists[0], [0, *fem.GetEigenFrequenciesHz()], rtol=1e-6)


def test_the_diagram_is_drawn(mass, monkeypatch, capsys):
    monkeypatch.setattr(plt, "show", lambda: None)
    mass.ComputeCampbellDiagram(5.0, 2, 1, plotDiagram=True, verbose=2)
    assert [line.get_xdata()[-1] for line in plt.gca().lines] == [5.0] * 4
    assert "speed 5 Hz: [" in capsys.readouterr().out
    plt.close("all")
    with pytest.raises(ValueError, match="6003 coordinates are too many for dense matrices"):
        large = FEM.FEMinterface()
        large.nodes = {"Position": np.zeros((2001, 3))}
        large.massMatrix = large.stiffnessMatrix = scipy.sparse.eye(6003, format="csr")
        large.ComputeCampbellDiagram(1.0)
