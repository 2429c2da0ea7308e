"""Eigenmodes and static modes against theory, dense solutions, and constrained models."""

import meshes
import numpy as np
import pytest
import scipy.linalg
import scipy.sparse
from scipy.optimize import brentq

from dalembert import FEM
from dalembert._fem.cholesky import Cholesky, NotPositiveDefiniteError
from dalembert._fem.dissection import dissect
from dalembert._fem.eigen import rigid_motions
from dalembert._fem.lanczos import inverse_lanczos

E, NU, RHO = 2.1e11, 0.3, 7850.0
HCB = FEM.HCBstaticModeSelection


@pytest.fixture(scope="module")
def beam():
    """A bar of 1 m with a cross section of 30 mm x 20 mm."""
    return meshes.solid("Hex20", (48, 2, 2), (1.0, 0.03, 0.02))


@pytest.fixture
def bar():
    """A short block with two faces as interfaces."""
    fem = meshes.solid("Tet10", (6, 2, 2), (1.0, 0.2, 0.15))
    for name, x in (("left", 0.0), ("right", 1.0)):
        fem.AddBoundary(name, fem.GetNodesInPlane([x, 0, 0], [1, 0, 0]))
    return fem


def timoshenko_free_free(height, width, number):
    """Frequencies (Hz) of bending of a free bar of 1 m by Timoshenko's theory, with Cowper's coefficient of shear."""
    area, inertia = height * width, width * height**3 / 12
    shear = 10 * (1 + NU) / (12 + 11 * NU) * E / (2 * (1 + NU)) * area

    def determinant(omega):
        b2, r2, s2 = RHO * area * omega**2 / (E * inertia), inertia / area, E * inertia / shear
        root = np.sqrt((r2 - s2) ** 2 + 4 / b2)
        a, c = np.sqrt(b2 / 2 * (root - (r2 + s2))), np.sqrt(b2 / 2 * (root + r2 + s2))
        k1, k2 = (a**2 + b2 * s2) / a, (c**2 - b2 * s2) / c  # rotations of the section for cosh, cos
        # deflection A cosh + B sinh + C cos + D sin; moment phi', shear force w' - phi vanish at both ends
        rows = [
            [k1 * a, 0, -k2 * c, 0],
            [0, a - k1, 0, c - k2],
            [k1 * a * np.cosh(a), k1 * a * np.sinh(a), -k2 * c * np.cos(c), -k2 * c * np.sin(c)],
            [(a - k1) * np.sinh(a), (a - k1) * np.cosh(a), -(c - k2) * np.sin(c), (c - k2) * np.cos(c)],
        ]
        return np.linalg.det(np.array(rows) / np.cosh(a))

    thin = np.array([4.730040745, 7.853204624, 10.995607838])[number] ** 2 * np.sqrt(E * inertia / (RHO * area))
    return brentq(determinant, 0.9 * thin, 1.001 * thin) / (2 * np.pi)


def test_frequencies_of_a_free_bar(beam):
    beam.ComputeEigenmodes(8, excludeRigidBodyModes=6)
    frequencies = beam.GetEigenFrequenciesHz()
    theory = sorted(timoshenko_free_free(h, w, n) for h, w in ((0.03, 0.02), (0.02, 0.03)) for n in range(3))
    np.testing.assert_allclose(frequencies[:6], theory, rtol=1e-3)
    torsion = 0.5 * np.sqrt(E / (2 * (1 + NU)) / RHO * 0.19577 * 12 / (1.5 + 1 / 1.5) / 1.5)  # a/b = 1.5: 0.196 a b^3
    assert np.abs(frequencies / torsion - 1).min() < 0.01
    axial = 0.5 * np.sqrt(E / RHO)
    beam.ComputeEigenmodes(16, excludeRigidBodyModes=6)
    assert np.abs(beam.GetEigenFrequenciesHz() / axial - 1).min() < 3e-4


def test_sparse_and_dense_modes_agree_and_repeat(bar):
    bar.ComputeEigenmodes(6, excludeRigidBodyModes=6, useSparseSolver=False)
    values, modes = bar.eigenValues[6:12], bar.modeBasis["matrix"]
    assert len(bar.eigenValues) == bar.NumberOfCoordinates()
    bar.ComputeEigenmodes(6, excludeRigidBodyModes=6)
    np.testing.assert_allclose(bar.eigenValues, values, rtol=1e-8)
    np.testing.assert_allclose(bar.modeBasis["matrix"], modes, rtol=0, atol=1e-5 * np.abs(modes).max())
    gram = modes.T @ (bar.GetMassMatrix() @ modes)
    np.testing.assert_allclose(gram, np.eye(6), rtol=0, atol=1e-9)
    first = bar.modeBasis["matrix"].copy()
    bar.ComputeEigenmodes(6, excludeRigidBodyModes=6)
    assert (bar.modeBasis["matrix"] == first).all()


def test_rigid_modes_come_first(bar):
    bar.ComputeEigenmodes(8)
    assert bar.eigenValues[:6].max() < 1e-6 * bar.eigenValues[6]
    motions = rigid_motions(bar.GetNodePositionsAsArray())
    rest = motions - bar.modeBasis["matrix"][:, :6] @ (
        bar.modeBasis["matrix"][:, :6].T @ (bar.GetMassMatrix() @ motions)
    )
    np.testing.assert_allclose(rest, 0, atol=1e-7)


def test_elastic_supports(bar):
    stiff = bar.GetStiffnessMatrix()
    for node in bar.GetBoundaryNodeSetsAsLists()[0][0]:
        bar.AddElasticSupportAtNode(node, [1e13] * 3)
    bar.ComputeEigenmodes(3)
    supported = bar.eigenValues
    bar.stiffnessMatrix = stiff
    bar.ComputeEigenModesWithBoundaryNodes(bar.GetBoundaryNodeSetsAsLists()[0][0], 3)
    np.testing.assert_allclose(supported, bar.eigenValues, rtol=2e-3)
    held = np.repeat(bar.GetBoundaryNodeSetsAsLists()[0][0], 3) * 3 + np.tile(
        range(3), len(bar.nodeSets[0]["NodeNumbers"])
    )
    assert (bar.modeBasis["matrix"][held] == 0).all()


def frequencies_of(fem, count):
    """Elastic frequencies of the free body with the modes, without interfaces left out."""
    modes = fem.modeBasis["matrix"]
    reduced = [modes.T @ (matrix @ modes) for matrix in (fem.GetStiffnessMatrix(), fem.GetMassMatrix())]
    values = scipy.linalg.eigh(*reduced, eigvals_only=True)
    assert np.abs(values[:6]).max() < 1e-6 * values[6]
    return np.sqrt(values[6 : 6 + count])


def free_frequencies(fem, count, rigid):
    """The same of the whole mesh, whose interfaces are rigid or not."""
    mass, stiffness = fem.GetMassMatrix(), fem.GetStiffnessMatrix()
    transform = np.eye(mass.shape[0])
    if rigid:
        lists, points = fem.GetBoundaryNodeSetsAsLists()[0], fem.GetNodePositionsAsArray()
        coordinates = [(3 * nodes[:, None] + np.arange(3)).ravel() for nodes in lists]
        inner = np.setdiff1d(np.arange(mass.shape[0]), np.concatenate(coordinates))
        transform = np.zeros((mass.shape[0], len(inner) + 6 * len(lists)))
        transform[inner, np.arange(len(inner))] = 1
        for i, (nodes, rows) in enumerate(zip(lists, coordinates, strict=True)):
            transform[rows, len(inner) + 6 * i : len(inner) + 6 * i + 6] = rigid_motions(points[nodes])
    reduced = [transform.T @ (matrix @ transform) for matrix in (stiffness, mass)]
    return np.sqrt(scipy.linalg.eigh(*reduced, eigvals_only=True, subset_by_index=(6, 5 + count)))


@pytest.mark.parametrize("mode", [HCB.RBE2, HCB.RBE3, HCB.allBoundaryNodes])
def test_hurty_craig_bampton_modes_converge_from_above(bar, mode):
    """The part of a motion that is left out has at most its kinetic energy, and frequencies above those that are kept:
    this bounds the additional frequency by half the square of their ratio. The fourth frequency is one of bending, of
    which the ends take little part, and is
    0.37 to 0.39 percent off with 16 modes."""
    exact = free_frequencies(bar, 4, mode == HCB.RBE2)
    lists, weights = bar.GetBoundaryNodeSetsAsLists()
    errors = []
    for count in (2, 6, 16):
        arguments = {"computationMode": mode, "excludeRigidBodyMotion": False}
        bar.ComputeHurtyCraigBamptonModes(lists, count, boundaryNodesWeights=weights, **arguments)
        static = 3 * sum(map(len, lists)) if mode == HCB.allBoundaryNodes else 12
        assert bar.modeBasis["matrix"].shape[1] == static + count
        assert bar.eigenValues.shape == (count,)
        errors.append(frequencies_of(bar, 4) / exact - 1)
        kept = (2 * np.pi * bar.GetEigenFrequenciesHz()[-1] / exact) ** 2
        assert (errors[-1] < np.where(kept > 1, 0.5 / (kept - 1), np.inf)).all()
    assert (np.diff(errors, axis=0) < 1e-9).all()
    assert np.min(errors) > -1e-8
    assert np.max(errors[0][:2]) < 0.02
    assert np.max(errors[-1]) == pytest.approx(0.0038, abs=0.0002)
    assert np.max(errors[1]) > 5e-3


@pytest.mark.parametrize("mode", [HCB.RBE2, HCB.RBE3, HCB.allBoundaryNodes])
def test_static_modes_hold_rigid_motions_exactly(bar, mode):
    lists, weights = bar.GetBoundaryNodeSetsAsLists()
    arguments = {"computationMode": mode, "excludeRigidBodyMotion": False, "boundaryNodesWeights": weights}
    bar.ComputeHurtyCraigBamptonModes(lists, 0, **arguments)
    motions, basis = rigid_motions(bar.GetNodePositionsAsArray()), bar.modeBasis["matrix"]
    np.testing.assert_allclose(basis @ np.linalg.lstsq(basis, motions, rcond=None)[0], motions, rtol=0, atol=1e-9)
    bar.ComputeHurtyCraigBamptonModes(lists, 0, **(arguments | {"excludeRigidBodyMotion": True}))
    rest = bar.modeBasis["matrix"]
    assert rest.shape[1] == basis.shape[1] - 6 * (mode != HCB.allBoundaryNodes)
    np.testing.assert_allclose(rest, basis[:, basis.shape[1] - rest.shape[1] :], rtol=0, atol=1e-12)


def averages(fem, nodes, weights):
    """Mean displacement, and mean rotation by moments."""
    points = fem.GetNodePositionsAsArray()[nodes]
    motions = rigid_motions(points, weights @ points)
    weighted = motions.T * np.repeat(weights, 3)
    return np.linalg.solve(weighted @ motions, weighted)


def test_averages_of_interfaces_move_one_by_one(bar):
    lists, weights = bar.GetBoundaryNodeSetsAsLists()
    bar.ComputeHurtyCraigBamptonModes(lists, 3, boundaryNodesWeights=weights, computationMode=HCB.RBE3)
    rows = [(3 * nodes[:, None] + np.arange(3)).ravel() for nodes in lists]
    modes = bar.modeBasis["matrix"]
    moved = averages(bar, lists[1], weights[1]) @ modes[rows[1]]
    np.testing.assert_allclose(moved, np.eye(6, 9), rtol=0, atol=1e-9)
    np.testing.assert_allclose(averages(bar, lists[0], weights[0]) @ modes[rows[0]], 0, atol=1e-9)
    reduced = modes.T @ (bar.GetStiffnessMatrix() @ modes)
    np.testing.assert_allclose(reduced[:6, 6:], 0, atol=1e-9 * np.abs(reduced).max())  # static modes need no others
    bar.ComputeHurtyCraigBamptonModes(lists, 3, True, HCB.RBE3, weights, RBE3secondMomentOfAreaWeighting=False)
    other = bar.modeBasis["matrix"]
    np.testing.assert_allclose(modes @ np.linalg.lstsq(modes, other, rcond=None)[0], other, rtol=0, atol=1e-9)


def test_a_static_mode_is_the_bending_of_a_cantilever():
    """Displacement 1 and no rotation at the end needs a force of 12 E I / l^3, a little less by shear."""
    beam = meshes.solid("Hex20", (32, 2, 2), (1.0, 0.03, 0.02), FEM.KirchhoffMaterial(E, 0.0, RHO))
    ends = [beam.GetNodesInPlane([x, 0, 0], [1, 0, 0]) for x in (0, 1)]
    beam.ComputeHurtyCraigBamptonModes(ends, 0)
    modes = beam.modeBasis["matrix"]
    stiffness = modes.T @ (beam.GetStiffnessMatrix() @ modes)
    for axis, height, width in ((1, 0.03, 0.02), (2, 0.02, 0.03)):
        inertia, area = width * height**3 / 12, width * height
        shear = 5 / 6 * E / 2 * area
        expected = 12 * E * inertia / (1 + 12 * E * inertia / shear)
        assert stiffness[axis, axis] == pytest.approx(expected, rel=1e-3)
    assert stiffness[0, 0] == pytest.approx(E * 0.03 * 0.02, rel=1e-6)


def test_eigenmodes_alone(bar):
    lists = bar.GetBoundaryNodeSetsAsLists()[0]
    bar.ComputeHurtyCraigBamptonModes(lists, 4, computationMode=HCB.noStaticModes)
    alone = bar.modeBasis["matrix"]
    bar.ComputeEigenModesWithBoundaryNodes(np.concatenate(lists), 4)
    np.testing.assert_allclose(alone, bar.modeBasis["matrix"], rtol=0, atol=1e-8)
    bar.ComputeHurtyCraigBamptonModes([], 10)
    free = bar.eigenValues
    bar.ComputeEigenmodes(4, excludeRigidBodyModes=6)
    np.testing.assert_allclose(free, bar.eigenValues, rtol=1e-9)
    assert bar.modeBasis["type"] == "NormalModes"


def test_shapes_of_the_users_choice(bar):
    bar.ComputeEigenmodes(4, excludeRigidBodyModes=6)
    own = bar.GetNodePositionsAsArray()[:, [0]] ** 2 * [0, 0, 1.0]
    assert bar.AddModes(np.column_stack([own.ravel(), bar.modeBasis["matrix"][:, 0]])) == 1
    modes = bar.modeBasis["matrix"]
    np.testing.assert_allclose(modes.T @ (bar.GetMassMatrix() @ modes), np.eye(5), rtol=0, atol=1e-9)
    np.testing.assert_allclose(modes @ np.linalg.lstsq(modes, own.ravel(), rcond=None)[0], own.ravel(), atol=1e-9)
    assert len(bar.eigenValues) == 4


def test_cholesky_factors():
    fem = meshes.solid("Hex8", (12, 6, 5), (2.0, 1.0, 0.7))
    mass, stiffness, points = fem.GetMassMatrix(), fem.GetStiffnessMatrix(), fem.GetNodePositionsAsArray()
    matrix, progress = stiffness + 1e6 * mass, []
    factors = Cholesky(matrix, points, progress.append)
    right = np.random.default_rng(1).standard_normal((matrix.shape[0], 3))
    scale = abs(matrix).max()
    np.testing.assert_allclose(matrix @ factors.solve(right * scale), right * scale, rtol=0, atol=1e-8 * scale)
    np.testing.assert_allclose(factors.solve(right[:, 0]), factors.solve(right)[:, 0], rtol=1e-10, atol=1e-18)
    assert factors.entries < 0.5 * matrix.shape[0] ** 2
    assert progress[-1].startswith("factorization: ")
    with pytest.raises(NotPositiveDefiniteError, match="near node"):
        Cholesky(stiffness - 1e9 * mass, points)


def test_a_mesh_is_cut_where_it_has_the_fewest_nodes():
    # across the bar, at a plane between elements: 3 x 3 corners and 12 middles of edges
    points, elements = meshes.block("Hex20", (8, 2, 2), (4.0, 1.0, 1.0))
    nodes = elements["Hex20"]
    pairs = np.repeat(nodes, 20, axis=1).ravel(), np.tile(nodes, (1, 20)).ravel()
    graph = scipy.sparse.csr_matrix((np.ones(len(pairs[0])), pairs), shape=(len(points), len(points)))
    order, fronts = dissect(points, graph)
    np.testing.assert_array_equal(np.sort(order), np.arange(len(points)))
    last = order[fronts[-1].begin : fronts[-1].end]
    assert len(last) == 21
    np.testing.assert_array_equal(points[last, 0], points[last[0], 0])
    below, above = (np.setdiff1d(np.flatnonzero(s * (points[:, 0] - points[last[0], 0]) > 0), last) for s in (-1, 1))
    assert len(below) + len(above) + 21 == len(points)
    assert graph[below][:, above].nnz == 0


def test_modes_of_the_same_frequency_are_all_found():
    # 15 modes, more than the vectors of a block
    squares = np.concatenate([np.ones(15), np.geomspace(100.0, 1e6, 385)])
    mass = scipy.sparse.diags(np.linspace(1.0, 2.0, len(squares))).tocsr()
    stiffness = mass.diagonal() * squares
    values, modes = inverse_lanczos(mass, lambda forces: forces / stiffness[:, None], 0.0, 16)
    np.testing.assert_allclose(values, squares[:16], rtol=1e-12)
    np.testing.assert_allclose(modes.T @ (mass @ modes), np.eye(16), rtol=0, atol=1e-12)
    np.testing.assert_allclose(stiffness[:, None] * modes, (mass @ modes) * values, rtol=0, atol=1e-9 * values.max())


def test_more_modes_than_have_a_mass():
    mass = scipy.sparse.diags(np.where(np.arange(400) < 7, 1.0, 0.0)).tocsr()
    solve = lambda forces: forces / np.arange(1.0, 401.0)[:, None]  # noqa: E731
    np.testing.assert_allclose(inverse_lanczos(mass, solve, 0.0, 7)[0], np.arange(1.0, 8.0), rtol=1e-12)
    with pytest.raises(ValueError, match="8 modes are asked for, but there are only 7 with a mass"):
        inverse_lanczos(mass, solve, 0.0, 8)
