"""Every setting that is not said to be without effect changes a picture, a page, or an image by rays, of a scene that has something of all."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from hashlib import sha256
from operator import attrgetter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_visualization_settings import SETTINGS, WITHOUT_EFFECT, tree

import dalembert as exu
import dalembert.itemInterface as items
from dalembert import graphics
from dalembert._live import views
from dalembert._live.messages import Stage
from dalembert._pictures.draw import camera_for
from dalembert._pictures.notices import settings_of_pictures
from dalembert._pictures.studio import Studio
from dalembert.utilities import InertiaCuboid, RotationMatrixX

SETTINGS_OF_PICTURES = settings_of_pictures()
Variable = exu.OutputVariableType
# Settings without effect in this scene, with the name of their test.
ELSEWHERE = (
    "bodies.shells.", "contact.contact",
    "contact.showContactForces", "contour.reduceRange", "exportImages.", "general.graphicsUpdateInterval",
    "interactive.ignoreKeys", "interactive.advanced.pauseWithSpacebar", "interactive.advanced.selectionL",
    "interactive.advanced.selectionR",
    "raytracer.numberOfThreads", "raytracer.advanced.tilesPerThread", "raytracer.verbose", "view0.window.renderWindowSize",
)  # fmt: skip
COLORED = {"contour.outputVariable": Variable.Displacement, "contour.outputVariableComponent": -1}
CHOSEN = {"contour.automaticRange": False, "contour.minValue": 0.05, "contour.maxValue": 0.2}
TRACED = {f"sensors.traces.show{what}": True for what in ("PositionTrace", "Vectors", "Triads")} | {
    "sensors.traces.listOfPositionSensors": [0, 0],
    "sensors.traces.listOfVectorSensors": [1, 1],
    "sensors.traces.listOfTriadSensors": [2, 2],
    "sensors.traces.vectorScaling": 0.1,
}
TRACKED = {"view0.camera.trackMarker": 1, "view0.camera.trackMarkerOrientation": [1.0, 1, 1]}
FIXED = {"general.autoFitScene": False, "openGL.advanced.initialZoom": 3.0}
MARKED = {"interactive.highlightItemIndex": 1, "interactive.highlightItemType": exu.ItemType.Object}
LIT = {f"openGL.light{i}.{name}": value for i in range(4) for name, value in (
    ("enable", True), ("position", [1.0 + i, 2, 10, 1]), ("shadow", 1.0),
)}  # fmt: skip
SOFT = {"raytracer.lightRadiusVariations": 4}
FOGGY = {"raytracer.globalFogDensity": 0.1}
# Test data of a setting: the last entry whose beginning fits the path.
GIVEN: dict[str, dict[str, Any]] = {
    "bodies.beams.draw": COLORED | {"bodies.beams.drawVertical": True, "bodies.beams.drawVerticalValues": True},
    "bodies.deformationScaleFactor": COLORED,
    "bodies.kinematicTree.frameSize": {"bodies.kinematicTree.showCOMframes": True},
    "connectors.jointAxesLength": {"connectors.showJointAxes": True},
    "contact.": {f"contact.show{what}": True for what in ("BoundingBoxes", "SearchTree", "Spheres", "Triangles")},
    "contour.": COLORED,
    "contour.m": COLORED | CHOSEN,
    "contour.advanced.contourColorM": COLORED | CHOSEN,
    "general.axesTiling": {"nodes.showBasis": True},
    "general.backgroundColorBottom": {"general.useGradientBackground": True},
    "general.rendererPrecision": {"view0.window.showComputationInfo": True},
    "general.text": {"bodies.showNumbers": True},
    "interactive.": MARKED,
    "loads.loadSizeFactor": {"loads.fixedLoadSize": False},
    "nodes.basisSize": {"nodes.showBasis": True},
    "openGL.advanced.faceNormalsColor": {"openGL.drawFaceNormals": True},
    "openGL.advanced.initial": FIXED,
    "openGL.advanced.vertexNormalsColor": {"openGL.drawVertexNormals": True},
    "openGL.drawNormalsLength": {"openGL.drawFaceNormals": True},
    "openGL.faceEdgesColor": {"view0.scene.showFaceEdges": True},
    "openGL.faceTransparencyGlobal": {"view0.scene.facesTransparent": True},
    "openGL.light": LIT | SOFT,
    "openGL.lineWidth": {"view0.scene.showFaceEdges": True},
    "raytracer.": FOGGY | LIT,
    "raytracer.advanced.showText": {"bodies.showNumbers": True},
    "raytracer.advanced.zBiasLines": {"view0.scene.showFaceEdges": True},
    "raytracer.advanced.background": {},
    "sensors.traces.": TRACED,
    "sensors.traces.showCurrent": TRACED | {"sensors.traces.vectorsShowEvery": 7},
    "sensors.traces.showFuture": TRACED | {"sensors.traces.showPast": False},
    "view0.camera.clippingPlaneDistance": {"view0.camera.clippingPlaneNormal": [0.0, 1, 0]},
    "view0.camera.track": TRACKED,
    "view0.scene.worldBasisSize": {"view0.scene.drawWorldBasis": True},
}
# Settings for which the value of other() is equal or out of range.
OTHER: dict[str, Any] = {
    "contour.alphaTransparency": 0.5,
    "contour.outputVariable": Variable.Position,
    "contour.outputVariableComponent": 0,
    "general.coordinateSystemSize": 9.0,
    "general.rendererPrecision": 1,
    "interactive.highlightItemType": exu.ItemType.Node,
    "interactive.highlightMbsNumber": 3,
    "loads.loadSizeFactor": 0.01,
    "nodes.showNodalSlopes": 1,
    "openGL.advanced.initialModelRotation": RotationMatrixX(0.7),
    "openGL.multiSampling": 16,
    "raytracer.globalFogColor": [0.9, 0.1, 0.1, 1],
    "raytracer.multiSampling": 3,
    "sensors.traces.listOfPositionSensors": [0],
    "sensors.traces.listOfTriadSensors": [],
    "sensors.traces.listOfVectorSensors": [],
    "sensors.traces.sensorsMbsNumber": 2,
    "sensors.traces.timeSpan": 0.01,
    "sensors.traces.triadsShowEvery": 7,
    "sensors.traces.vectorsShowEvery": 7,
    "view0.camera.clippingPlaneNormal": [0.0, 1, 0],
    "view0.camera.trackMarkerMbsNumber": 1,
    "view0.camera.trackMarkerOrientation": [0.0, 0, 0],
    "view0.camera.trackMarkerPosition": [0.0, 0, 0],
    "view0.scene.drawCoordinateSystem": 0,
} | {f"openGL.light{i}.shadow": 0.0 for i in range(4)}
RAYS = ("raytracer.", "openGL.light", "view0.camera.useRaytracer")
BEFORE: dict[tuple[bool, str], list[str]] = {}  # result for given settings
MATERIALS = "raytracer.material"  # test_raytracer.py tries all settings of each
DRAWN = [s for s in SETTINGS if s not in WITHOUT_EFFECT and not s.startswith((*ELSEWHERE, MATERIALS))]


def other(path: str, value: Any) -> Any:
    """Another value of a setting."""
    if path in OTHER:
        return OTHER[path]
    if isinstance(value, bool):
        return not value
    if isinstance(value, str):
        return f"{value} other"
    if isinstance(value, int):
        return value + 1 if value >= 0 else 0
    if isinstance(value, float):
        return 1.7 * value + 0.1 if value >= 0 else 0.3
    array = np.array(value, float)
    is_color = (array.size in (3, 4) and array.min() >= 0 and array.max() <= 1) or path.endswith("traceColors")
    if is_color:  # opacities stay
        array.reshape(-1, 3 + (array.size % 4 == 0))[:, :3] = (
            1 - array.reshape(-1, 3 + (array.size % 4 == 0))[:, :3] + 0.05
        )
        return np.clip(array, 0, 1).tolist()
    return (array + 0.4).tolist()


@contextmanager
def changed(settings: Any, changes: dict[str, Any]) -> Iterator[None]:
    """Give settings other values for a while."""
    before = []
    for path, value in changes.items():
        above, _, name = path.rpartition(".")
        group = attrgetter(above)(settings)
        before.append((group, name, getattr(group, name)))
        setattr(group, name, value)
    try:
        yield
    finally:
        for group, name, value in reversed(before):
            setattr(group, name, value)


@pytest.fixture(scope="module")
def model() -> Any:
    """A container with something of all: materials, a contour, traces, a tree, joints, springs, loads, lines."""
    SC = exu.SystemContainer()
    mbs = SC.AddSystem()
    ground = mbs.CreateGround(graphicsDataList=[graphics.CheckerBoard(point=[0, 0, -1.2], size=5, nTiles=4)])
    for i in range(10):
        color = [-1, -1, -1, graphics.material.indexBase + i]
        mbs.CreateRigidBody(
            referencePosition=[i % 5 - 2, i // 5, 0.2 * i], referenceRotationMatrix=RotationMatrixX(0.4 * i), inertia=InertiaCuboid(1000, [0.4, 0.3, 0.2]),
            initialAngularVelocity=[1, 9, 0], initialVelocity=[0, 0, 1], gravity=[0, 0, -9.81 * (i == 0)],
            graphicsDataList=[graphics.Sphere(radius=0.35, color=color, nTiles=16), graphics.Brick(size=[0.7, 0.1, 0.1], color=color)],
        )  # fmt: skip
    mbs.CreateRigidBody(referencePosition=[-1, -2, 0], inertia=InertiaCuboid(1000, [0.4, 0.3, 0.2]),
                        graphicsDataList=[graphics.Brick(size=[0.4, 0.3, 0.2], color=[-1, -1, -1, 1])])  # fmt: skip
    markers = [mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body)) for body in (3, ground)]
    assert markers[0] == TRACKED["view0.camera.trackMarker"]
    mass = mbs.CreateMassPoint(referencePosition=[1, -1, 0], physicsMass=1)
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], localPosition0=[-1, -1.3, 0], stiffness=100)
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, 5], position=[2, 0, 0.8], axis=[0, 0, 1])
    mbs.CreateForce(bodyNumber=4, loadVector=[0, 0, 5])
    slope = {"physicsLength": 1, "physicsMassPerLength": 1, "physicsBendingStiffness": 1, "physicsAxialStiffness": 100}
    for at, node, cable, ahead, looks in (
        (-1.5, items.NodePoint2DSlope1, items.ObjectANCFCable2D, [1, 0], {"drawHeight": 0.05}),
        (-2.2, items.NodePointSlope1, items.ObjectANCFCable, [0, 1, 0, 0], {"radius": 0.1}),
    ):
        size = 2 + len(ahead)
        nodes = [
            mbs.AddNode(node(referenceCoordinates=[x, at, *ahead], initialCoordinates=[0, 0.2 * x, *[0] * (size - 2)]))
            for x in (0, 1)
        ]
        mbs.AddObject(cable(nodeNumbers=nodes, visualization=looks, **slope))
    corners = [mbs.AddNode(items.NodePoint(referenceCoordinates=[x, y, 1.5])) for x, y in ((-2, 2), (-1, 2), (-2, 3))]
    stiffness = exu.MatrixContainer()
    stiffness.SetWithDenseMatrix(np.eye(9))
    mbs.AddObject(items.ObjectGenericODE2(
        nodeNumbers=corners, massMatrix=stiffness, stiffnessMatrix=stiffness, visualization={"triangleMesh": [[0, 1, 2]]},
    ))  # fmt: skip
    tree(mbs)
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    contact.AddSphereWithMarker(markers[0], 0.6, 1e3, 0, 0)
    contact.AddTrianglesRigidBodyBased(markers[1], 1e3, 0, 0, [[-2.0, -2, -1], [2, -2, -1], [0, 2, -1]], [[0, 1, 2]])
    contact.SetSearchTreeBox([-3, -3, -2], [3, 3, 2])
    contact.SetSearchTreeCellSize([2, 2, 1])
    mbs.SetObjectParameter(mbs.systemData.NumberOfObjects() - 1, "VgraphicsDataList", [])
    for variable in (Variable.Position, Variable.Velocity, Variable.RotationMatrix):
        mbs.AddSensor(items.SensorBody(
            bodyNumber=2, localPosition=[0.6, 0, 0], outputVariableType=variable, storeInternal=True, writeToFile=False,
        ))  # fmt: skip
    mbs.Assemble()
    other = SC.AddSystem()
    for _ in markers:
        other.AddMarker(items.MarkerBodyRigid(bodyNumber=other.CreateGround()))
    other.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 40, 0.2
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile, settings.solutionSettings.sensorsWritePeriod = False, 0.005
    mbs.SolveDynamic(settings)
    mbs.systemData.SetTime(0.1234, exu.ConfigurationType.Visualization)
    SC.visualizationSettings.view0.window.renderWindowSize = [240, 180]
    return SC


def seen(container: Any, rays: bool) -> list[str]:
    """Digests of the picture, of the messages to a page, and of a ray-traced image if requested."""
    studio = Studio(container)
    scene = studio.scene()
    camera, looks = studio.camera(scene), studio.makers[0].looks
    words = views.words(container.visualizationSettings, scene, looks)
    shown = camera_for(studio, scene, None, (1024, 768), 1.0)
    found = [studio.image(scene, camera).tobytes(), Stage().messages(scene, looks, words, lambda: shown).whole()]
    if rays:
        found.append(studio.image(scene, camera, raytracer=True).tobytes())
    return [sha256(part).hexdigest() for part in found]


@pytest.mark.parametrize("path", DRAWN)
def test_a_setting_changes_the_picture(model: Any, path: str) -> None:
    settings = model.visualizationSettings
    fitting = [beginning for beginning in GIVEN if path.startswith(beginning)]
    given = GIVEN[max(fitting, key=len)] if fitting else {}
    with changed(settings, given):
        rays, key = path.startswith(RAYS), repr(given)
        before = BEFORE[rays, key] = BEFORE.get((rays, key)) or seen(model, rays)
        with changed(settings, {path: other(path, attrgetter(path)(settings))}):
            after = seen(model, rays)
    assert before != after
    assert (before[1] == after[1]) is (path in SETTINGS_OF_PICTURES or path.startswith("raytracer."))


@pytest.mark.parametrize("number", [1, 2, 3])
def test_settings_of_each_view_change_its_picture(model: Any, number: int) -> None:
    """Settings of the scene, which all views share, have no effect in other views than the first, with a message."""
    settings, view = model.visualizationSettings, f"view{number}."

    def picture() -> bytes:
        studio = Studio(model)
        scene = studio.scene()
        return studio.image(scene, studio.camera(scene, number), number).tobytes()

    with changed(settings, {f"{view}window.renderWindowSize": [240, 180]}):
        for first in (path for path in SETTINGS if path.startswith("view0.") and not path.startswith(ELSEWHERE)):
            path = view + first.removeprefix("view0.")
            fitting = [beginning for beginning in GIVEN if first.startswith(beginning)]
            given = GIVEN[max(fitting, key=len)] if fitting else {}
            with changed(settings, {name.replace("view0.", view): value for name, value in given.items()}):
                before = picture()
                with changed(settings, {path: other(first, attrgetter(path)(settings))}):
                    assert (picture() == before) is (path in WITHOUT_EFFECT), path


def test_settings_that_are_tested_elsewhere_are() -> None:
    texts = "".join(
        path.read_text() for path in sorted(Path(__file__).parent.glob("test_*.py")) if path != Path(__file__)
    )
    for beginning in ELSEWHERE:
        for path in (s for s in SETTINGS if s.startswith(beginning) and s not in WITHOUT_EFFECT):
            assert re.search(rf"\b{path.rpartition('.')[2]}\b", texts), path
