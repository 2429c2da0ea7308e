"""Elements and their matrices: shape functions, exact fields, rigid motions, another implementation."""

import meshes
import numpy as np
import pytest
import scipy.linalg
import skfem
from skfem.helpers import dot
from skfem.models.elasticity import lame_parameters, linear_elasticity

from dalembert import FEM
from dalembert._fem.eigen import rigid_motions
from dalembert._fem.elements import KINDS

SKEW = np.array([[1.0, 0.2, 0.1], [0, 0.9, 0.3], [0.1, 0, 1.2]])


@pytest.mark.parametrize("kind", KINDS.values(), ids=KINDS)
def test_shape_functions(kind):
    np.testing.assert_allclose(kind.values(kind.nodes), np.eye(kind.count), rtol=0, atol=1e-13)
    points, h = kind.rule(2).points, 1e-6
    for axis in range(3):
        step = h * np.eye(3)[axis]
        differences = (kind.values(points + step) - kind.values(points - step)) / (2 * h)
        np.testing.assert_allclose(kind.gradients(points)[:, axis], differences, rtol=0, atol=1e-8)


@pytest.mark.parametrize("kind", KINDS)
def test_mass_of_a_skew_block(kind):
    positions, elements = meshes.block(kind, (2, 1, 2))
    fem = FEM.FEMinterface()
    fem.SetMesh(positions @ SKEW.T, elements)
    fem.AssembleMatrices(meshes.STEEL)
    inertia = fem.GetRigidBodyInertia()
    assert inertia.mass == pytest.approx(7850 * np.linalg.det(SKEW), rel=1e-12)
    np.testing.assert_allclose(inertia.com, SKEW @ np.full(3, 0.5), rtol=1e-12)
    second = 7850 * np.linalg.det(SKEW) * SKEW @ (np.full((3, 3), 0.25) + np.eye(3) / 12) @ SKEW.T
    np.testing.assert_allclose(inertia.inertiaTensor, np.trace(second) * np.eye(3) - second, rtol=1e-11, atol=1e-8)


@pytest.mark.parametrize("kind", KINDS)
def test_a_linear_field_is_in_equilibrium(kind):
    """Displacements that are linear in x, y and z need forces at the surface alone, wherever inner nodes lie."""
    positions, elements = meshes.block(kind, (3, 3, 3))
    inner = np.all((positions > 1e-9) & (positions < 1 - 1e-9), axis=1)
    corners = np.unique(elements[kind][:, : KINDS[kind].first_middle])
    moved = positions + 0.04 * np.sin(9 * positions[:, [1, 2, 0]]) * np.prod(np.sin(np.pi * positions), axis=1)[:, None]
    if len(corners) == len(positions):
        positions = moved
    fem = FEM.FEMinterface()
    fem.SetMesh(positions, elements)
    fem.AssembleMatrices(meshes.STEEL)
    gradient = np.array([[1.0, 2, 3], [0.5, -1, 2], [4, 1, -2]])
    forces = (fem.GetStiffnessMatrix() @ (positions @ gradient.T).ravel()).reshape(-1, 3)
    np.testing.assert_allclose(forces[inner], 0, atol=1e-9 * np.abs(forces).max())
    stress = meshes.STEEL.Strain2Stress(0.5 * (gradient + gradient.T))
    np.testing.assert_allclose(forces.T @ positions, stress, rtol=1e-10)  # stress times volume, by virtual work


@pytest.mark.parametrize("kind", KINDS)
def test_rigid_motions_have_no_stiffness(kind):
    fem = meshes.solid(kind, (2, 2, 1))
    motions = rigid_motions(fem.GetNodePositionsAsArray(), [0.1, 0.2, 0.3])
    stiffness = fem.GetStiffnessMatrix()
    np.testing.assert_allclose(stiffness @ motions, 0, atol=1e-13 * abs(stiffness).max())
    assert np.linalg.matrix_rank(stiffness.toarray(), tol=1e-8 * abs(stiffness).max()) == stiffness.shape[0] - 6


def skfem_frequencies(mesh, element):
    basis = skfem.Basis(mesh, skfem.ElementVector(element), intorder=6)
    stiffness = linear_elasticity(*lame_parameters(2.1e11, 0.3)).assemble(basis)
    mass = skfem.BilinearForm(lambda u, v, w: 7850.0 * dot(u, v)).assemble(basis)
    return scipy.linalg.eigh(stiffness.toarray(), mass.toarray(), eigvals_only=True)


@pytest.mark.parametrize(
    ("kind", "mesh", "element"),
    [
        ("Tet4", skfem.MeshTet, skfem.ElementTetP1()),
        ("Tet10", skfem.MeshTet, skfem.ElementTetP2()),
        ("Hex8", skfem.MeshHex, skfem.ElementHex1()),
        ("Hex27", skfem.MeshHex, skfem.ElementHex2()),
    ],
)
def test_all_eigenvalues_are_those_of_scikit_fem(kind, mesh, element):
    positions, elements = meshes.block(kind, (2, 2, 1), (1.0, 0.8, 0.5))
    fem = FEM.FEMinterface()
    fem.SetMesh(positions, elements)
    fem.AssembleMatrices(meshes.STEEL)
    corners = elements[kind][:, : KINDS[kind].first_middle]
    used, numbers = np.unique(corners, return_inverse=True)
    order = [0, 1, 2, 3] if kind.startswith("Tet") else [0, 3, 1, 4, 2, 7, 5, 6]
    other = mesh(positions[used].T, numbers.reshape(corners.shape)[:, order].T)
    matrices = fem.GetStiffnessMatrix(sparse=False), fem.GetMassMatrix(sparse=False)
    ours = scipy.linalg.eigh(*matrices, eigvals_only=True)
    np.testing.assert_allclose(ours, skfem_frequencies(other, element), rtol=1e-9, atol=1e-9 * ours[-1])


@pytest.mark.parametrize("kind", KINDS)
def test_the_surface_is_closed_and_points_outwards(kind):
    fem = meshes.solid(kind, (2, 1, 3), (2.0, 1.0, 1.5))
    triangles = np.array(fem.GetSurfaceTriangles())
    edges = {(a, b) for t in triangles.tolist() for a, b in zip(t, t[1:] + t[:1], strict=True)}
    assert len(edges) == 3 * len(triangles)
    assert {(b, a) for a, b in edges} == edges
    a, b, c = fem.GetNodePositionsAsArray()[triangles].transpose(1, 0, 2)
    assert np.einsum("ti,ti->", a, np.cross(b, c)) / 6 == pytest.approx(3.0, rel=1e-12)


def test_kinds_may_be_mixed():
    positions, corners = meshes.hexahedra((2, 1, 1), (2.0, 1.0, 1.0))
    wedges = np.array([corners[1][[0, 1, 2, 4, 5, 6]], corners[1][[0, 2, 3, 4, 6, 7]]])
    fem = FEM.FEMinterface()
    fem.SetMesh(positions, {"Hex8": corners[:1], "Wedge6": wedges})
    fem.AssembleMatrices(meshes.STEEL)
    assert fem.NumberOfElements() == 3
    assert fem.GetRigidBodyInertia().mass == pytest.approx(2 * 7850, rel=1e-12)
    assert len(fem.GetSurfaceTriangles()) == 2 * 10
    motions = rigid_motions(positions)
    np.testing.assert_allclose(fem.GetStiffnessMatrix() @ motions, 0, atol=1e-3)


def test_materials_of_element_sets():
    fem = FEM.FEMinterface()
    fem.SetMesh(*meshes.block("Hex8", (4, 1, 1), (4.0, 1.0, 1.0)))
    fem.elementSets = [{"Name": "left", "ElementNumbers": [0, 1]}, {"Name": "right", "ElementNumbers": [2, 3]}]
    soft = {"youngsModulus": 1e9, "poissonsRatio": 0.0, "density": 1000.0}
    fem.AssembleMatrices(materials={"left": meshes.STEEL, "right": soft})
    assert fem.GetRigidBodyInertia().mass == pytest.approx(2 * 7850 + 2 * 1000, rel=1e-12)
    with pytest.raises(ValueError, match=r"element 2 and 1 more has no material; give `material`, or `materials`"):
        fem.AssembleMatrices(materials={"left": meshes.STEEL})
    with pytest.raises(ValueError, match=r"there is no element set 'middle'; there are: 'left', 'right'"):
        fem.AssembleMatrices(materials={"middle": meshes.STEEL})


def test_areas_of_nodes():
    fem = meshes.solid("Tet10", (2, 2, 2), (1.0, 2.0, 3.0))
    nodes = fem.GetNodesInPlane([0, 0, 0], [1, 0, 0])
    areas = fem.GetNodeWeightsFromSurfaceAreas(nodes, normalizeWeights=False)
    assert areas.sum() == pytest.approx(6, rel=1e-12)
    assert fem.GetNodeWeightsFromSurfaceAreas(nodes).sum() == pytest.approx(1, rel=1e-12)
    np.testing.assert_allclose(areas @ fem.GetNodePositionsAsArray()[nodes] / 6, [0, 1, 1.5], rtol=0, atol=0.02)
    fem.AddBoundary("left", nodes)
    assert fem.GetBoundaryNodeSetsAsLists()[0][0].tolist() == nodes
