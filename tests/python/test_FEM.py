"""Conversions, node selection and materials of dalembert.FEM."""

import numpy as np
import pytest
import scipy.sparse

import dalembert as exu
from dalembert import FEM

TRIPLETS = np.array([[0, 0, 1.0], [1, 2, 3], [2, 1, 4]])
DENSE = np.array([[1.0, 0, 0], [0, 0, 3], [0, 4, 0]])


@pytest.fixture
def fem():
    fem = FEM.FEMinterface()
    fem.nodes = {"Position": np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0], [1, 1, 0]])}
    return fem


def test_sparse_matrices():
    np.testing.assert_array_equal(FEM.CompressedRowSparseToDenseMatrix(TRIPLETS), DENSE)
    np.testing.assert_array_equal(FEM.ScipySparseCSRtoCSR(scipy.sparse.csr_matrix(DENSE)), TRIPLETS)
    np.testing.assert_array_equal(FEM.ConvertDenseToCompressedRowMatrix(DENSE), TRIPLETS)
    assert FEM.CSRtoRowsAndColumns(TRIPLETS) == (2, 2)
    added = FEM.AddEntryToCompressedRowSparseArray(TRIPLETS.copy(), 1, 1, 7)
    assert FEM.CompressedRowSparseToDenseMatrix(added)[1, 1] == 7
    with pytest.raises(ValueError, match="where: expected a scipy sparse matrix"):
        FEM.CheckForSciPyMatrix(np.eye(4), "where")


def test_orders_of_coordinates():
    x = np.arange(6.0)
    assert FEM.ResortIndicesOfNGvector(x).tolist() == [0, 2, 4, 1, 3, 5]
    assert FEM.ResortIndicesExudyn2NGvector(FEM.ResortIndicesOfNGvector(x)).tolist() == x.tolist()
    matrix = np.column_stack((x, x, x))
    FEM.ResortIndicesOfCSRmatrix(matrix, 6)
    by_entry = np.zeros(6)
    by_entry[matrix[:, 0].astype(int)] = x
    assert by_entry.tolist() == FEM.ResortIndicesOfNGvector(x).tolist()


@pytest.mark.parametrize(("convert", "corners"), [(FEM.ConvertHexToTrigs, 8), (FEM.ConvertTetToTrigs, 4)])
def test_faces_are_closed(convert, corners):
    faces = convert(list(range(corners)))
    edges = [(f[i], f[(i + 1) % 3]) for f in faces for i in range(3)]
    assert len(set(edges)) == len(edges)
    assert {(b, a) for a, b in edges} == set(edges)


def test_material():
    material = FEM.KirchhoffMaterial(1e9, 0.3, 1e3)
    strain = np.array([[1, 0.5, 0.2], [0.5, 2, 0.1], [0.2, 0.1, 3]]) * 1e-3
    stress = material.Strain2Stress(strain)
    vector = [*np.diag(strain), 2 * strain[1, 2], 2 * strain[0, 2], 2 * strain[0, 1]]
    expected = [*np.diag(stress), stress[1, 2], stress[0, 2], stress[0, 1]]
    np.testing.assert_allclose(material.StrainVector2StressVector(vector), expected)
    np.testing.assert_allclose(material.StrainVector2StressVector2D([1, 0.3, 0])[1] / 1e9, (0.3 + 0.3) / (1 - 0.09))


def test_nodes_are_found(fem):
    assert fem.GetNodeAtPoint([1, 0, 0]) == 1
    assert fem.GetNodeAtPoint([3, 0, 0], raiseException=False) == -1
    with pytest.raises(ValueError, match="the closest is node 1 at a distance of 2"):
        fem.GetNodeAtPoint([3, 0, 0])
    assert fem.GetNodesInPlane([0, 0, 0], [0, 0, 2]) == [0, 1, 2, 4]
    assert fem.GetNodesInCube([0, 0, 0], [1, 1, 0.5]) == [0, 1, 2, 4]
    assert fem.GetNodesOnLine([0, 0, 0], [0.5, 0, 0]) == [0]
    assert fem.GetNodesOnCylinder([0, 0, 0], [0, 0, 1], 1) == [1, 2]
    assert fem.GetNodesOnCircle([0, 0, 0], [0, 0, 1], 1) == [1, 2]
    assert (fem.NumberOfNodes(), fem.NumberOfCoordinates()) == (5, 15)


def test_eigenmodes_of_two_masses(fem):
    fem.nodes = {"Position": np.array([[0, 0, 0], [1, 0, 0.0]])}
    fem.massMatrix = scipy.sparse.csr_matrix(2 * np.eye(6))
    spring = np.kron([[1, -1], [-1, 1]], np.diag([100.0, 0, 0]))
    fem.stiffnessMatrix = FEM.ConvertDenseToCompressedRowMatrix(spring)
    fem.ComputeEigenmodes(1, excludeRigidBodyModes=5, useSparseSolver=False)
    np.testing.assert_allclose(fem.GetEigenFrequenciesHz(), [0, 0, 0, 0, 0, 10 / (2 * np.pi)])


@pytest.fixture
def truss(fem):
    """Four points of 2 kg on springs between all of them."""
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
    fem.nodes, fem.massMatrix = {"Position": points}, scipy.sparse.csr_matrix(2 * np.eye(12))
    stiffness = np.zeros((4, 3, 4, 3))
    for i in range(4):
        for j in range(i):
            axis = (points[i] - points[j]) / np.linalg.norm(points[i] - points[j])
            for a, b, sign in ((i, i, 1), (j, j, 1), (i, j, -1), (j, i, -1)):
                stiffness[a, :, b] += sign * 500 * np.outer(axis, axis)
    fem.stiffnessMatrix = scipy.sparse.csr_matrix(stiffness.reshape(12, 12))
    fem.ComputeEigenmodes(3, excludeRigidBodyModes=6, useSparseSolver=False)
    return fem


FRAMES = ["NodeType.RotationEulerParameters", "NodeType.RotationRxyz", "NodeType.RotationRotationVector"]


@pytest.mark.parametrize("frame", FRAMES)
def test_flexible_body_and_its_user_functions(truss, frame):
    """The body of the core, the same equations by user functions, and free fall of the centre of mass."""
    modal = FEM.ObjectFFRFreducedOrderInterface(truss, rigidBodyNodeType=frame)
    assert modal.totalMass == pytest.approx(8)
    np.testing.assert_allclose(modal.chiU, [0.25] * 3)
    positions = []
    for with_functions in (False, True):
        mbs = exu.SystemContainer().AddSystem()
        where = {"positionRef": [1, 2, 3], "initialAngularVelocity": [1, 2, 4], "initialVelocity": [1, 0, 0]}
        functions = {
            "UFforce": lambda mbs, t, item, q, q_t: modal.UFforceFFRFreducedOrder(exu, mbs, t, q, q_t),
            "UFmassMatrix": lambda mbs, t, item, q, q_t: modal.UFmassFFRFreducedOrder(exu, mbs, t, q, q_t),
        }
        gravity = {"gravity": [0, 0, -9.81], "stiffnessProportionalDamping": 1e-3}
        if with_functions:
            made = modal.AddObjectFFRFreducedOrderWithUserFunctions(exu, mbs, **where, **gravity, **functions)
        else:
            made = modal.AddObjectFFRFreducedOrder(mbs, **where, **gravity, name="truss")
            assert mbs.GetObjectNumber("truss") == made["oFFRFreducedOrder"]
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps = 100
        settings.timeIntegration.endTime = 0.1
        mbs.SolveDynamic(settings)
        variable = exu.OutputVariableType.Position
        positions.append([mbs.GetObjectOutputSuperElement(made["oFFRFreducedOrder"], variable, i) for i in range(4)])
    np.testing.assert_allclose(positions[1], positions[0], rtol=0, atol=1e-7)
    centre = np.array([1.25, 2.25, 3.25]) + 0.1 * (np.array([1, 0, 0]) + np.cross([1, 2, 4], [0.25] * 3))
    np.testing.assert_allclose(np.mean(positions[0], axis=0), centre - [0, 0, 0.5 * 9.81 * 0.01], rtol=0, atol=1e-5)


@pytest.mark.parametrize("ending", ["", ".npz", ".pkl"])
def test_flexible_body_is_kept_in_files(truss, ending, tmp_path):
    truss.postProcessingModes = {"matrix": np.ones((4, 18)), "outputVariableType": "OutputVariableType.StressLocal"}
    modal, loaded = FEM.ObjectFFRFreducedOrderInterface(truss), FEM.ObjectFFRFreducedOrderInterface()
    modal.SaveToFile(str(tmp_path / f"truss{ending}"))
    assert loaded.LoadFromFile(str(tmp_path / f"truss{ending}")) == 1
    mbs = exu.SystemContainer().AddSystem()
    body = loaded.AddObjectFFRFreducedOrder(mbs)["oFFRFreducedOrder"]
    mbs.Assemble()
    mbs.systemData.SetODE2Coordinates([0] * 7 + [1, 2, 3])
    norm = lambda name, *rest: FEM.CMSObjectComputeNorm(mbs, body, getattr(exu.OutputVariableType, name), *rest)  # noqa: E731
    np.testing.assert_allclose(norm("StressLocal"), [6] * 6)
    assert norm("StressLocal", "Mises") == pytest.approx(6 * np.sqrt(9))
    u = modal.modeBasis @ [1, 2, 3]
    assert norm("DisplacementLocal", "maxNorm", [1, 2]) == pytest.approx(
        np.linalg.norm(u.reshape(4, 3)[1:3], axis=1).max()
    )
    with pytest.raises(ValueError, match="norm must be max, min, maxNorm"):
        norm("DisplacementLocal", "Mises")


def test_names_that_are_misspelt(fem):
    with pytest.raises(AttributeError, match="has no attribute 'ComputeEigenmode'"):
        fem.ComputeEigenmode()


def test_files(tmp_path):
    order = tmp_path / "order.txt"
    order.write_text("% comment\n2 1\n2\n1\n")
    assert FEM.ReadMatrixDOFmappingVectorFromAnsysTxt(str(order)).tolist() == [3, 4, 5, 0, 1, 2]
    nodes = tmp_path / "nodes.txt"
    nodes.write_text("Node\tX\tY\tZ\n2\t1,5\t0\t0\n1\t0\t2.\t0\n")
    assert FEM.ReadNodalCoordinatesFromAnsysTxt(str(nodes)).tolist() == [[0, 2, 0], [1.5, 0, 0]]
    matrix = tmp_path / "matrix.mmf"
    matrix.write_text("%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 5\n2 1 7\n")
    assert FEM.CompressedRowSparseToDenseMatrix(FEM.ReadMatrixFromAnsysMMF(str(matrix))).tolist() == [[5, 7], [7, 0]]


@pytest.mark.parametrize("triplets", [[[0, 0.5, 1]], [[-1, 0, 1]], [[0, np.nan, 1]], [[0, 1]], [0, 1, 2], "text", None])
def test_lines_of_sparse_matrices_that_are_none_are_named(triplets):
    for function in (FEM.CSRtoScipySparseCSR, FEM.CompressedRowSparseToDenseMatrix, FEM.CSRtoRowsAndColumns):
        with pytest.raises(ValueError, match=r"expected lines \[row, column, value\]"):
            function(triplets)


def test_orders_of_coordinates_that_do_not_fit_are_named():
    with pytest.raises(ValueError, match="ResortIndicesOfNGvector: vXXYYZZ: expected three numbers for each node"):
        FEM.ResortIndicesOfNGvector([1, 2, 3, 4])
    with pytest.raises(ValueError, match="ResortIndicesExudyn2NGvector: vXYZXYZ: expected a vector"):
        FEM.ResortIndicesExudyn2NGvector(np.eye(3))
    for rows in (7, 3):
        with pytest.raises(ValueError, match="numberOfRows: expected three rows for each node"):
            FEM.ResortIndicesOfCSRmatrix(np.array([[0.0, 4.0, 1.0]]), rows)
    with pytest.raises(ValueError, match="ConvertTetToTrigs: nodeNumbers: expected 4 numbers of nodes or more"):
        FEM.ConvertTetToTrigs([1, 2])
    with pytest.raises(ValueError, match="ConvertHexToTrigs: nodeNumbers: expected 8 numbers of nodes or more"):
        FEM.ConvertHexToTrigs(range(7))
    with pytest.raises(ValueError, match="CyclicCompareReversed: list1: expected a list of numbers, received 1"):
        FEM.CyclicCompareReversed(1, [1])
    with pytest.raises(ValueError, match="VectorDiadicUnitMatrix3D: v: expected an array of numbers"):
        FEM.VectorDiadicUnitMatrix3D("text")
    with pytest.raises(ValueError, match="RoundMatrix: matrix: expected an array of numbers"):
        FEM.RoundMatrix([[1, 2], [3, 4]])
    with pytest.raises(ValueError, match="RoundMatrix: treshold: expected a finite number"):
        FEM.RoundMatrix(np.eye(2), "text")
    with pytest.raises(ValueError, match="ComputeSkewMatrix: v: expected a vector with 3"):
        FEM.ComputeSkewMatrix([])
