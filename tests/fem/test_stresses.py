"""Stress and strain modes against fields that are known."""

import meshes
import numpy as np
import pytest

import dalembert as exu
from dalembert import FEM
from dalembert._fem.elements import KINDS

GRADIENT = np.array([[1.0, 2, 3], [0.5, -1, 2], [4, 1, -2]]) * 1e-4
STRAIN = 0.5 * (GRADIENT + GRADIENT.T)
VECTOR = [*np.diag(STRAIN), 2 * STRAIN[1, 2], 2 * STRAIN[0, 2], 2 * STRAIN[0, 1]]
Variable = exu.OutputVariableType


@pytest.mark.parametrize("kind", KINDS)
def test_linear_fields(kind):
    fem = meshes.solid(kind, (2, 1, 2))
    points = fem.GetNodePositionsAsArray()
    fem.modeBasis = {"matrix": np.column_stack([np.ones(points.size), (points @ GRADIENT.T).ravel()]), "type": "test"}
    fem.ComputePostProcessingModes(outputVariableType=Variable.StrainLocal)
    np.testing.assert_allclose(fem.postProcessingModes["matrix"][:, :6], 0, atol=1e-12)
    np.testing.assert_allclose(fem.postProcessingModes["matrix"][:, 6:], np.tile(VECTOR, (len(points), 1)), atol=1e-14)
    fem.ComputePostProcessingModes(meshes.STEEL, Variable.StressLocal)
    stress = meshes.STEEL.StrainVector2StressVector(VECTOR)
    np.testing.assert_allclose(fem.postProcessingModes["matrix"][:, 6:] - stress, 0, atol=1e-5)


@pytest.mark.parametrize("kind", ["Tet10", "Hex20", "Hex27", "Wedge15"])
def test_quadratic_elements_bend_exactly(kind):
    """Pure bending: strain -y/r along x, and Poisson's ratio times it across."""
    fem = meshes.solid(kind, (3, 1, 1), (3.0, 0.4, 0.3))
    x, y, z = fem.GetNodePositionsAsArray().T
    nu = 0.3
    bent = np.stack([-x * y, 0.5 * (x**2 + nu * (y**2 - z**2)), nu * y * z], axis=1)
    fem.modeBasis = {"matrix": bent.reshape(-1, 1), "type": "test"}
    fem.ComputePostProcessingModes(meshes.STEEL)
    expected = np.zeros((len(x), 6))
    expected[:, 0] = -2.1e11 * y
    np.testing.assert_allclose(fem.postProcessingModes["matrix"], expected, rtol=0, atol=1e-2)
    energy = bent.ravel() @ (fem.GetStiffnessMatrix() @ bent.ravel())
    assert energy == pytest.approx(2.1e11 * 3 * 0.3 * (0.4**3 / 3), rel=1e-10)


def test_a_single_tetrahedron():
    corners = np.array([[0, 0, 0], [1, 0.2, 0], [0.1, 1, 0], [0, 0.3, 1.1]])
    element = FEM.Tet4(meshes.STEEL)
    strain, stress, shape, gradient = element.ComputeMatrices(corners.ravel(), (corners @ GRADIENT.T).ravel())
    np.testing.assert_allclose(gradient, GRADIENT, rtol=0, atol=1e-15)
    np.testing.assert_allclose(strain, np.tile(VECTOR, (4, 1)), rtol=0, atol=1e-15)
    np.testing.assert_allclose(stress[2], meshes.STEEL.StrainVector2StressVector(VECTOR), rtol=1e-9)
    np.testing.assert_allclose(shape.sum(axis=0), 0, atol=1e-15)
    fem = meshes.solid("Tet4", (1, 1, 1))
    fem.ComputeEigenmodes(2, 6)
    fem.ComputePostProcessingModes(meshes.STEEL)
    data = [1, fem.nodes["Position"], fem.modeBasis["matrix"], fem.elements[0]["Tet4"], meshes.STEEL, False]
    one = fem.InternalComputePostprocessingMode(data)
    np.testing.assert_allclose(one, fem.postProcessingModes["matrix"][:, 6:], rtol=1e-12, atol=1e-3)


def test_materials_of_element_sets():
    fem = meshes.solid("Hex8", (2, 1, 1))
    fem.elementSets = [{"Name": "left", "ElementNumbers": [0]}, {"Name": "right", "ElementNumbers": [1]}]
    fem.modeBasis = {"matrix": (fem.GetNodePositionsAsArray() @ GRADIENT.T).reshape(-1, 1), "type": "test"}
    soft = {"youngsModulus": 1e9, "poissonsRatio": 0.0, "density": 1000.0}
    fem.ComputePostProcessingModes({"left": meshes.STEEL, "right": soft})
    expected = [meshes.STEEL.StrainVector2StressVector(VECTOR)[0], 1e9 * VECTOR[0]]
    np.testing.assert_allclose(fem.postProcessingModes["matrix"][[0, -1], 0], expected, rtol=1e-9)
    with pytest.raises(ValueError, match="element 1 has no material"):
        fem.ComputePostProcessingModes({"left": meshes.STEEL})
