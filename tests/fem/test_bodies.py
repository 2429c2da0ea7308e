"""Flexible bodies from a mesh: created by one call, as generic object, and with all coordinates of the mesh."""

import meshes
import numpy as np
import pytest
import scipy.linalg

import dalembert as exu
from dalembert import FEM
from dalembert.itemInterface import LoadForceVector, MarkerBodyRigid, ObjectJointGeneric

HCB = FEM.HCBstaticModeSelection
LENGTH, WIDTH, FORCE = 1.0, 0.04, 50.0


@pytest.fixture(scope="module")
def fem():
    """A cantilever with two interfaces; no contraction across, so that the theory of beams holds at the clamp."""
    mesh = meshes.solid("Hex20", (16, 1, 1), (LENGTH, WIDTH, WIDTH), FEM.KirchhoffMaterial(2.1e11, 0.0, 7850.0))
    for name, x in (("left", 0.0), ("right", LENGTH)):
        mesh.AddBoundary(name, mesh.GetNodesInPlane([x, 0, 0], [1, 0, 0]))
    lists, weights = mesh.GetBoundaryNodeSetsAsLists()
    mesh.ComputeHurtyCraigBamptonModes(lists, 8, boundaryNodesWeights=weights, computationMode=HCB.RBE2)
    mesh.ComputePostProcessingModes(FEM.KirchhoffMaterial(2.1e11, 0.0, 7850.0), exu.OutputVariableType.StressLocal)
    return mesh


@pytest.fixture
def mbs():
    yield exu.SystemContainer().AddSystem()


def clamped(mbs, fem, **more):
    body = mbs.CreateFFRFReducedOrderObject("beam", fem, **more)
    ground = mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.CreateGround(), localPosition=[0, WIDTH / 2, WIDTH / 2]))
    mbs.AddObject(ObjectJointGeneric(markerNumbers=[ground, body["beam:left"]]))
    return body


def test_a_cantilever_under_a_force(fem, mbs):
    body = clamped(mbs, fem)
    number = body["FFRFReducedOrderObjectDict"]["oFFRFreducedOrder"]
    assert mbs.GetMarkerNumber("beam:right") == body["beam:right"]
    mbs.AddLoad(LoadForceVector(markerNumber=body["beam:right"], loadVector=[0, 0, -FORCE]))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.verboseMode = 0
    mbs.SolveStatic(settings)
    inertia = WIDTH**4 / 12
    expected = -FORCE * LENGTH**3 / (3 * 2.1e11 * inertia) - FORCE * LENGTH / (5 / 6 * 1.05e11 * WIDTH**2)
    variable = exu.OutputVariableType
    tip = fem.GetNodeAtPoint([LENGTH, WIDTH / 2, 0])
    displacement = mbs.GetObjectOutputSuperElement(number, variable.Displacement, tip)
    assert displacement[2] == pytest.approx(expected, rel=1e-3)
    node = fem.GetNodeAtPoint([LENGTH / 2, 0, WIDTH])
    stress = mbs.GetObjectOutputSuperElement(number, variable.StressLocal, node)
    assert stress[0] == pytest.approx(FORCE * LENGTH / 2 * WIDTH / 2 / inertia, rel=1e-3)


def test_frequencies_of_a_cantilever(fem, mbs):
    clamped(mbs, fem)
    mbs.Assemble()
    values = np.sort(mbs.ComputeODE2Eigenvalues()[0])
    frequencies = np.sqrt(values[values > 1]) / (2 * np.pi)
    theory = np.array([1.875104, 4.694091]) ** 2 * np.sqrt(2.1e11 * WIDTH**2 / 12 / 7850) / (2 * np.pi)
    np.testing.assert_allclose(frequencies[:2], theory[0], rtol=3e-3)
    np.testing.assert_allclose(frequencies[2:4], theory[1], rtol=2e-2)  # shear and rotary inertia are in the mesh


def test_weight_and_offsets(fem, mbs):
    offsets = [[0, 0, 0], [0.1, 0, 0]]
    body = mbs.CreateFFRFReducedOrderObject(
        name=None, femInterface=fem, gravity=[0, 0, -9.81], superElementRigidMarkersOffsets=offsets, verbose=True
    )
    numbers = body["FFRFReducedOrderObjectDict"]
    assert set(body) == {"left", "right", "FFRFReducedOrderObjectDict"}
    assert mbs.GetLoad(numbers["loadGravity"])["loadVector"].tolist() == [0, 0, -9.81]
    mbs.Assemble()
    position = mbs.GetMarkerOutput(body["right"], exu.OutputVariableType.Position)
    np.testing.assert_allclose(position, [LENGTH + 0.1, WIDTH / 2, WIDTH / 2], rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"name": ""}, "argument 'name': expected a name, or None"),
        ({"superElementRigidMarkersOffsets": [[0, 0, 0]]}, "expected 2 vectors with 3 components, one for each marker"),
        ({"femInterface": FEM.FEMinterface()}, "argument 'femInterface': expected a FEMinterface with modes"),
        ({"gravity": [0, 1]}, "argument 'gravity': expected a vector with 3 finite components"),
        (
            {"massProportionalDamping": -1},
            "argument 'massProportionalDamping': expected a finite number that is not neg",
        ),
    ],
)
def test_wrong_arguments(fem, mbs, arguments, message):
    with pytest.raises(ValueError, match=message):
        mbs.CreateFFRFReducedOrderObject(**({"name": "b", "femInterface": fem} | arguments))
    assert mbs.systemData.NumberOfObjects() == 0
    mbs.CreateFFRFReducedOrderObject("b", fem)
    with pytest.raises(ValueError, match="a new name, since the marker 'b:left' exists"):
        mbs.CreateFFRFReducedOrderObject("b", fem)


def test_free_modes_have_no_markers(mbs):
    mesh = meshes.solid("Tet4")
    mesh.ComputeEigenmodes(3, 6)
    assert set(mbs.CreateFFRFReducedOrderObject("free", mesh)) == {"FFRFReducedOrderObjectDict"}


def test_the_whole_mesh_as_generic_object(mbs):
    mesh = meshes.solid("Hex8", (3, 1, 1))
    number, nodes = mesh.CreateLinearFEMObjectGenericODE2(mbs)
    assert len(nodes) == mesh.NumberOfNodes()
    mbs.Assemble()
    values = np.sort(mbs.ComputeODE2Eigenvalues()[0])
    matrices = mesh.GetStiffnessMatrix(sparse=False), mesh.GetMassMatrix(sparse=False)
    np.testing.assert_allclose(values[6:], scipy.linalg.eigh(*matrices, eigvals_only=True)[6:], rtol=1e-9)
    assert len(mbs.GetObjectParameter(number, "nodeNumbers")) == len(nodes)
