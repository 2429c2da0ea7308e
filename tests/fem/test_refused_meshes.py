"""Wrong meshes, matrices and arguments are refused, and the element, node or argument is named."""

import meshes
import numpy as np
import pytest
import scipy.sparse

from dalembert import FEM

HCB = FEM.HCBstaticModeSelection


@pytest.fixture
def fem():
    return meshes.solid("Hex8", (3, 2, 2))


def mesh(change):
    positions, elements = meshes.block("Hex8")
    change(positions, elements)
    return lambda: FEM.FEMinterface().SetMesh(positions, elements)


def unknown_node(positions, elements):
    elements["Hex8"][3, 2] = 27


def flat(positions, elements):
    positions[:, 2] = 0


def nan(positions, elements):
    positions[4, 1] = np.nan


def other_kind(positions, elements):
    elements["Hex9"] = elements.pop("Hex8")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (unknown_node, r"element 3 has nodes \[.*27.*\], but there are 27 nodes"),
        (flat, "element 0 and 7 more of kind Hex8 is inverted or flat"),
        (nan, "positions: expected finite x, y and z of each node"),
        (other_kind, "kinds of Tet4, Tet10, Hex8, Hex20, Hex27, Wedge6, Wedge15, received 'Hex9'"),
    ],
)
def test_wrong_meshes(change, message):
    with pytest.raises(ValueError, match=message):
        mesh(change)()


def test_nodes_without_elements():
    positions, elements = meshes.block("Hex8")
    fem = FEM.FEMinterface()
    fem.SetMesh(np.vstack([[[5.0, 5, 5]], positions]), {"Hex8": elements["Hex8"] + 1})
    with pytest.raises(ValueError, match=r"node 0 belongs to no element; remove it \(RemoveUnconnectedNodes\)"):
        fem.AssembleMatrices(meshes.STEEL)
    assert fem.RemoveUnconnectedNodes().tolist() == list(range(1, 28))
    fem.AssembleMatrices(meshes.STEEL)
    assert abs(fem.GetStiffnessMatrix() - meshes.solid("Hex8").GetStiffnessMatrix()).max() == 0


@pytest.mark.parametrize(
    ("material", "message"),
    [
        (None, "element 0 and 11 more has no material"),
        (FEM.MaterialBaseClass(1, 0, 1), "material: expected a KirchhoffMaterial, or a dictionary with youngsModulus"),
        (
            {"youngsModulus": 1.0, "poissonsRatio": 0.5, "density": 1.0},
            "poissonsRatio: expected a number between -1 and",
        ),
        ({"youngsModulus": -1.0, "poissonsRatio": 0.3, "density": 1.0}, "youngsModulus: expected a positive number"),
        (
            {"youngsModulus": 1.0, "poissonsRatio": 0.3, "density": -1.0},
            "density: expected a number that is not negative",
        ),
    ],
)
def test_wrong_materials(fem, material, message):
    with pytest.raises(ValueError, match=message):
        fem.AssembleMatrices(material)


def smaller(fem):
    fem.massMatrix = fem.GetMassMatrix()[:6][:, :6]


def unsymmetric(fem):
    matrix = fem.GetStiffnessMatrix().tolil()
    matrix[7, 6] += 1e9
    fem.stiffnessMatrix = matrix.tocsr()


def infinite(fem):
    fem.stiffnessMatrix.data[fem.stiffnessMatrix.indptr[9]] = np.inf


def massless(fem):
    fem.massMatrix = (fem.GetMassMatrix() @ scipy.sparse.diags(np.repeat([1.0, 0, 1], [12, 3, 93]))).tocsr()
    fem.massMatrix = (fem.massMatrix + fem.massMatrix.T) / 2


def negative(fem):
    fem.stiffnessMatrix = fem.GetStiffnessMatrix() - 1e10 * scipy.sparse.eye(108)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (smaller, "the mass matrix has 6 rows and 6 columns; 36 nodes with 3 coordinates need 108 rows and columns"),
        (unsymmetric, "the stiffness matrix is not symmetric, at node"),
        (infinite, "the stiffness matrix has entries that are not finite, at node 3"),
        (massless, "the mass matrix has no positive diagonal entry at node 4"),
        (negative, "the eigenvalue -.* 1/s.2 is negative; the stiffness matrix is not positive semidefinite"),
    ],
)
def test_wrong_matrices(fem, change, message):
    change(fem)
    with pytest.raises(ValueError, match=message):
        fem.ComputeEigenmodes(4)


CALLS = {
    "empty": (
        lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 2], []], 2),
        r"boundaryNodesList\[1\]: expected a list",
    ),
    "no such node": (lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 99]], 2), "node numbers from 0 to 35"),
    "shared": (lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 3], [3, 9]], 2), "node 3 is listed twice"),
    "weights": (
        lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 3], [9]], 2, boundaryNodesWeights=[[1, 1, 1]]),
        "boundaryNodesWeights: expected one list of weights for each of the 2 interfaces",
    ),
    "weights of one": (
        lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 3]], 2, boundaryNodesWeights=[[1, -1, 1]]),
        r"boundaryNodesWeights\[0\]: expected 3 weights that are not negative",
    ),
    "free to turn": (
        lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 2]], 2),
        "lie on one line, about which the mesh",
    ),
    "line": (
        lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 2]], 2, computationMode=HCB.RBE3),
        r"boundaryNodesList\[0\]: RBE3: the interface has nodes on one line",
    ),
    "no mode": (
        lambda fem: fem.ComputeHurtyCraigBamptonModes([[0, 1, 3]], 0),
        "there is no mode: give another interface",
    ),
    "too many": (lambda fem: fem.ComputeEigenmodes(200), "200 modes are asked for, but there are 108 coordinates"),
    "no modes": (lambda fem: fem.ComputePostProcessingModes(meshes.STEEL), "there are no modes; compute them first"),
    "axis": (lambda fem: fem.GetGyroscopicMatrix(3), "rotationAxis: expected 0, 1 or 2, received 3"),
    "node": (lambda fem: fem.AddNodeMass(36, 1.0), "AddNodeMass: nodeNumber: expected a node number from 0 to 35"),
    "normal": (lambda fem: fem.GetNodesInPlane([0, 0, 0], [0, 0, 0]), "normal: expected a vector of non-zero length"),
    "mean": (lambda fem: fem.GetNodePositionsMean([]), "nodeNumberList has no nodes"),
    "area": (lambda fem: fem.GetNodeWeightsFromSurfaceAreas([0]), "nodes that make up at least one triangle"),
    "nothing": (lambda fem: FEM.FEMinterface().AssembleMatrices(meshes.STEEL), "there are no solid elements"),
    "no matrix": (lambda fem: FEM.FEMinterface().GetMassMatrix(), "there is no mass matrix yet"),
}


@pytest.mark.parametrize("case", CALLS)
def test_wrong_calls(fem, case):
    call, message = CALLS[case]
    with pytest.raises(ValueError, match=message):
        call(fem)


def test_stresses_need_a_material(fem):
    fem.ComputeEigenmodes(2, 6)
    with pytest.raises(ValueError, match=r"stresses need a material, KirchhoffMaterial\(...\); strains do not"):
        fem.ComputePostProcessingModes()
    with pytest.raises(ValueError, match="outputVariableType: expected OutputVariableType.StressLocal or StrainLocal"):
        fem.ComputePostProcessingModes(meshes.STEEL, "OutputVariableType.Position")
