"""Meshes of super elements, which move with the frame of their body: nodes and items on them are drawn in the frame."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_scenes import is_of

import dalembert as exu
from dalembert._pictures.flow import Flow
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.studio import Studio
from dalembert.itemInterface import (
    CoordinateConstraint,
    LoadCoordinate,
    MarkerNodeCoordinate,
    NodeGenericODE2,
    NodePoint,
    NodePointGround,
    NodeRigidBodyRxyz,
    ObjectFFRF,
    ObjectFFRFreducedOrder,
    SensorNode,
    SensorSuperElement,
    VObjectFFRF,
    VObjectFFRFreducedOrder,
)
from dalembert.utilities import RotationMatrixZ

Configuration, Variable = exu.ConfigurationType, exu.OutputVariableType
FRAME = np.array([5.0, 1.0, 2.0])
MESH = np.array([[1.0, 0, 0], [0, 1, 0], [-1, 0, 0.5], [0, -1, -0.5]])


def add_mesh_in_a_frame(mbs: Any) -> tuple[Any, list[Any]]:
    """Add an ObjectFFRF that is turned by 90 degrees about z; return it and the nodes of its mesh."""
    frame = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[*FRAME, 0, 0, np.pi / 2]))
    mesh = [mbs.AddNode(NodePoint(referenceCoordinates=place)) for place in MESH]
    mass, stiffness = exu.MatrixContainer(), exu.MatrixContainer()
    mass.SetWithDenseMatrix(np.eye(3 * len(MESH)))
    stiffness.SetWithDenseMatrix(np.eye(3 * len(MESH)))
    looks = VObjectFFRF(triangleMesh=[[0, 1, 2], [0, 2, 3]])
    body = mbs.AddObject(
        ObjectFFRF(
            nodeNumbers=[frame, *mesh], massMatrixFF=mass, stiffnessMatrixFF=stiffness, visualization=looks
        )
    )  # fmt: skip
    return body, mesh


def spin(mbs: Any, mesh: list[Any]) -> None:
    """Let the frame of that mesh travel and turn with all nodes but the first one at rest in it; the first one swings."""
    mbs.SetNodeParameter(0, "initialVelocities", [1, 2, 3, 0, 0, 8])
    mbs.SetNodeParameter(mesh[0], "initialCoordinates", [0, 0, 0.01])
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    for node in mesh[1:]:
        for coordinate in range(3):
            held = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground, held]))


def centers(scene: Any, kind: str, number: int) -> Any:
    """Return the middles of the meshes and spheres that an item is drawn by."""
    whole = scene.unbound()
    found = [
        part.mesh.points @ part.matrix.T + part.place
        for part in whole.instances
        if is_of(scene, part.item, kind, number)
    ]
    found += [np.array([center]) for center, *_, item in whole.spheres if is_of(scene, item, kind, number)]
    return np.array([points.mean(axis=0) for points in found])


@pytest.mark.parametrize("when", ["before Assemble", "one by one", "many at once", "later"])
def test_nodes_of_a_mesh_move_with_its_frame(SC: Any, mbs: Any, when: str) -> None:
    """Coordinates of the nodes of an ObjectFFRF are in its frame; items on the nodes are drawn at the mesh."""
    body, mesh = add_mesh_in_a_frame(mbs)
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mesh[1], coordinate=0))
    load = mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=1))
    sensor = mbs.AddSensor(SensorNode(nodeNumber=mesh[2], outputVariableType=Variable.Position))
    nodes = SC.visualizationSettings.nodes
    nodes.showNumbers = nodes.showBasis = when != "many at once"
    turn, here = RotationMatrixZ(np.pi / 2), FRAME
    if when == "before Assemble":
        scene = Studio(SC).scene()
    else:
        mbs.Assemble()
        flow = Flow(SceneMaker(mbs, SC.visualizationSettings))
        scene = Studio(SC).scene() if when == "one by one" else flow.scene()
        if when == "later":
            q = mbs.systemData.GetODE2Coordinates()
            q[:6] = [0.5, 0, -1, 0, 0, 0.3]
            mbs.systemData.SetODE2Coordinates(q, Configuration.Visualization)
            scene = flow.scene()
            turn, here = RotationMatrixZ(np.pi / 2 + 0.3), FRAME + [0.5, 0, -1]
    places = here + MESH @ turn.T
    for number, place in zip(mesh, places, strict=True):
        *axes, ball = centers(scene, "Node", int(number))
        assert ball == pytest.approx(place, abs=1e-12)
        if axes:
            assert (axes[0] - place) / np.linalg.norm(axes[0] - place) == pytest.approx(turn[:, 0], abs=0.01)
        labels = [label.place for label in scene.labels if label.text == f"N{int(number)}"]
        assert labels == ([] if when == "many at once" else [pytest.approx(place)])
    assert centers(scene, "Marker", int(marker)) == pytest.approx(places[1:2], abs=1e-12)
    along = np.diff([places[1], *centers(scene, "Load", int(load))], axis=0)
    assert along / np.linalg.norm(along, axis=1)[:, None] == pytest.approx(np.tile(turn[:, 0], (2, 1)), abs=0.02)
    assert centers(scene, "Sensor", int(sensor)) == pytest.approx(places[2:3], abs=1e-12)
    assert centers(scene, "Object", int(body)) == pytest.approx(places.mean(axis=0)[None], abs=1e-12)


def test_nodes_of_a_mesh_have_its_colors(SC: Any, mbs: Any) -> None:
    """Displacements of the mesh are those in space, not those in its frame."""
    body, mesh = add_mesh_in_a_frame(mbs)
    mbs.Assemble()
    q = mbs.systemData.GetODE2Coordinates()
    q[:3], q[6:9] = [0.5, 0, 0], [0, 0, 0.1]
    mbs.systemData.SetODE2Coordinates(q, Configuration.Visualization)
    settings = SC.visualizationSettings.contour
    settings.outputVariable, settings.outputVariableComponent = Variable.Displacement, -1
    scene = Studio(SC).scene()
    values = {
        (scene.items[part.item].kind, scene.items[part.item].number): part.values for part in scene.instances
    }  # fmt: skip
    expected = [np.hypot(0.5, 0.1), 0.5, 0.5, 0.5]
    assert values["Object", int(body)] == pytest.approx(expected)
    assert [values["Node", int(node)][0] for node in mesh] == pytest.approx(expected)


def test_traces_of_nodes_in_a_frame_are_where_the_nodes_were(SC: Any, mbs: Any) -> None:
    """Path of a rotating and moving frame: it contains the position of the mesh at each time."""
    body, mesh = add_mesh_in_a_frame(mbs)
    spin(mbs, mesh)
    sensors = [
        mbs.AddSensor(SensorNode(nodeNumber=mesh[0], outputVariableType=variable, storeInternal=True))
        for variable in (Variable.Position, Variable.Displacement)
    ]
    seen = mbs.AddSensor(
        SensorSuperElement(
            bodyNumber=body, meshNodeNumber=0, outputVariableType=Variable.Position, storeInternal=True
        )
    )  # fmt: skip
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 20, 0.2
    settings.solutionSettings.sensorsWritePeriod = 0.01
    mbs.SolveDynamic(settings)
    traces = SC.visualizationSettings.sensors.traces
    traces.showPositionTrace = traces.showVectors = True
    traces.listOfPositionSensors, traces.listOfVectorSensors = [sensors[0]], [sensors[1]]
    scene = Studio(SC).scene()
    (line,) = [points for points, _, _, item in scene.lines if scene.items[item].kind == "Trace"]
    path = mbs.GetSensorStoredData(seen)[:, 1:]
    assert np.ptp(path[:, 0]) > 1 and len(line) == 21
    assert line == pytest.approx(path, abs=1e-9)
    own = mbs.GetSensorStoredData(sensors[0])
    assert own.shape == (21, 4) and np.abs(own[-1, 1:] - path[-1]).max() > 1  # sensors measure in the frame


def test_a_mesh_of_modes_stands_in_its_frame_before_assemble(SC: Any, mbs: Any) -> None:
    """The final position, without deformation."""
    frame = mbs.AddNode(NodeRigidBodyRxyz(referenceCoordinates=[*FRAME, 0, 0, np.pi / 2]))
    modal = mbs.AddNode(
        NodeGenericODE2(
            referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0], numberOfODE2Coordinates=1
        )
    )
    one = exu.MatrixContainer()
    one.SetWithDenseMatrix(np.eye(1))
    body = mbs.AddObject(
        ObjectFFRFreducedOrder(
            nodeNumbers=[frame, modal], massMatrixReduced=one, stiffnessMatrixReduced=one, computeFFRFterms=False,
            referencePositions=MESH.ravel(), modeBasis=np.ones((MESH.size, 1)),
            visualization=VObjectFFRFreducedOrder(triangleMesh=[[0, 1, 2], [0, 2, 3]]),
        )
    )  # fmt: skip
    before = centers(Studio(SC).scene(), "Object", int(body))
    assert before == pytest.approx(np.mean(FRAME + MESH @ RotationMatrixZ(np.pi / 2).T, axis=0)[None])
    mbs.Assemble()
    assert centers(Studio(SC).scene(), "Object", int(body)) == pytest.approx(before)
