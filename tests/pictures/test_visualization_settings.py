"""Every setting of VisualizationSettings says something about pictures, or its spec says why it does not."""

from __future__ import annotations

import gzip
import json
import re
from collections.abc import Iterator
from operator import attrgetter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from test_items import READY, run

import dalembert as exu
import dalembert.itemInterface as items
import dalembert.robotics
import dalembert.utilities
from dalembert import graphics
from dalembert._pictures import notices
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.motion import Still
from dalembert._pictures.replay import pack

PACKAGE = Path(exu.__file__).resolve().parent
SOURCES = sorted([*PACKAGE.glob("_pictures/*.py"), *PACKAGE.glob("_live/*.py")])
TEXT = "\n".join(path.read_text() for path in SOURCES if path.name != "notices.py")
WITHOUT_EFFECT = notices.settings_without_effect()


def leaves(settings: Any, path: str = "") -> Iterator[str]:
    """Paths of all settings; views 1 to 3 have those of view 0."""
    for name, value in settings.GetDictionary().items():
        below = getattr(settings, name)
        if re.fullmatch("view[123]", name):
            continue
        if isinstance(value, dict) and hasattr(below, "GetDictionary"):
            yield from leaves(below, f"{path}{name}.")
        else:
            yield path + name


SETTINGS = list(leaves(exu.VisualizationSettings()))


def read(path: str) -> bool:
    """Whether the sources ask for a setting: its name stands there, or that of its numbered kind."""
    name = path.rpartition(".")[2]
    return re.search(rf"\b{re.sub('[0-9]$', '', name)}(\b|\{{)", TEXT) is not None


def test_there_are_all_of_them() -> None:
    assert len(SETTINGS) > 300
    assert 100 < len(WITHOUT_EFFECT) < len(SETTINGS)


@pytest.mark.parametrize("path", SETTINGS)
def test_a_setting_is_read_or_has_no_effect(path: str) -> None:
    assert (path in WITHOUT_EFFECT) or read(path)
    if path in WITHOUT_EFFECT:
        assert len(WITHOUT_EFFECT[path][1]) > 10
        assert re.search(rf'"{re.escape(path)}["./]', TEXT) is None


def test_there_is_one_notice_for_each_reason(SC: Any, mbs: Any, capfd: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr(notices, "_told", set())
    mbs.CreateGround()
    settings = SC.visualizationSettings
    mbs.Draw(windowSize=[40, 30])
    assert "no effect" not in capfd.readouterr().out
    settings.nodes.tiling, settings.general.sphereTiling, settings.contact.showTori = 8, 12, True
    mbs.Draw(windowSize=[40, 30])
    lines = [line for line in capfd.readouterr().out.splitlines() if "no effect" in line]
    assert len(lines) == 2
    assert "nodes.tiling, general.sphereTiling" in lines[0] and "spheres are round" in lines[0]
    mbs.Draw(windowSize=[40, 30])
    assert "no effect" not in capfd.readouterr().out


def test_pages_report_settings_of_pictures_only(SC: Any, mbs: Any, capfd: Any, monkeypatch: Any, tmp_path: Any) -> None:
    monkeypatch.setattr(notices, "_told", set())
    brick(mbs)
    settings = SC.visualizationSettings
    settings.openGL.lineWidth, settings.openGL.light0.shadow, settings.view0.camera.useRaytracer = 3, 0.5, True
    mbs.SaveHTML(str(tmp_path / "brick.html"))
    lines = [line for line in capfd.readouterr().out.splitlines() if "no effect" in line]
    assert len(lines) == 2
    of_lights, of_rays = sorted(lines, key=lambda line: "rays" in line)
    assert "no effect on pages of openGL.lineWidth, openGL.light0.shadow: pages have lights" in of_lights
    assert "view0.camera.useRaytracer: pages have no rays" in of_rays
    settings.view0.camera.useRaytracer = False
    mbs.Draw(windowSize=[40, 30])
    assert "no effect of openGL.light0.shadow: only the ray tracer has it" in capfd.readouterr().out


def test_saved_pages_see_through_colors_of_numbers(SC: Any, mbs: Any) -> None:
    cantilever(mbs)
    mbs.Assemble()
    contour = SC.visualizationSettings.contour
    contour.outputVariable = exu.OutputVariableType.Position
    clear = []
    for contour.alphaTransparency in (1.0, 0.5):
        packed = gzip.decompress(pack(Still(SC), {}))
        head = json.loads(packed[4 : 4 + int.from_bytes(packed[:4], "little")])
        clear.append({mesh["color"][3] for mesh in head["meshes"] if "frameColors" in mesh})
    assert clear == [{1.0}, {0.5}]


def cantilever(mbs: Any) -> None:
    nodes = [mbs.AddNode(items.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    mbs.AddObject(
        items.ObjectANCFCable2D(
            nodeNumbers=nodes,
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=100,
            visualization={"drawHeight": 0.05},
        )
    )


def tree(mbs: Any) -> None:
    link = exu.robotics.RobotLink(mass=1, COM=[0.5, 0.1, 0], inertia=np.eye(3), preHT=np.eye(4))
    robot = exu.robotics.Robot()
    robot.AddLink(link)
    robot.CreateKinematicTree(mbs)


def measured(mbs: Any) -> None:
    mass = mbs.CreateMassPoint(physicsMass=1)
    for sensor in (items.SensorBody(bodyNumber=mass), items.SensorNode(nodeNumber=0)):
        sensor.outputVariableType = exu.OutputVariableType.Position
        mbs.AddSensor(sensor)


def jointed(mbs: Any) -> None:
    cuboid = dalembert.utilities.InertiaCuboid(1000, [0.4, 0.2, 0.1])
    bodies = [mbs.CreateGround(), *(mbs.CreateRigidBody(referencePosition=[x, 0, 0], inertia=cuboid) for x in range(4))]
    joints = (mbs.CreateRevoluteJoint, mbs.CreatePrismaticJoint, mbs.CreateSphericalJoint, mbs.CreateGenericJoint)
    for number, joint in enumerate(joints):
        axis = {"axis": [0, 0, 1]} if number < 2 else {}
        joint(bodyNumbers=bodies[number : number + 2], position=[number, 0, 0], **axis)
    mbs.CreateRigidBodySpringDamper(bodyNumbers=bodies[:2], stiffness=np.eye(6), damping=np.eye(6))


def brick(mbs: Any) -> None:
    mbs.CreateGround(graphicsDataList=[graphics.Brick(size=[1, 1, 1])])


DRAWN: list[tuple[Any, dict[str, Any], dict[str, int]]] = [
    (cantilever, {"bodies.beams.drawVertical": True}, {"lines": 10}),  # the diagram, and nine lines from the axis
    (cantilever, {"bodies.beams.drawVertical": True, "bodies.beams.drawVerticalLines": False}, {"lines": 1}),
    (
        cantilever,
        {"bodies.beams.drawVertical": True, "bodies.beams.drawVerticalValues": True},
        {"lines": 10, "labels": 9},
    ),
    (cantilever, {"contour.nodesColored": False}, {"spheres": 2, "instances": -2}),
    (cantilever, {"nodes.showNodalSlopes": 1}, {"instances": 4}),  # two arrows of two parts
    (tree, {"bodies.kinematicTree.showCOMframes": True}, {"instances": 6}),
    (tree, {"bodies.kinematicTree.showFramesNumbers": True}, {"labels": 1}),
    (measured, {"sensors.showNumbers": True}, {"labels": 2}),
    (
        jointed,
        {"connectors.showJointAxes": True},
        {"instances": 60},
    ),  # five joints, two markers, three arrows of two parts
    (brick, {"openGL.drawFaceNormals": True}, {"lines": 12}),
    (brick, {"openGL.drawVertexNormals": True}, {"lines": 36}),
    (brick, {"openGL.advanced.showBoundingBox": True}, {"lines": 12}),
]


@pytest.mark.parametrize(
    ("build", "changes", "more"), DRAWN, ids=lambda part: "+".join(part) if isinstance(part, dict) else ""
)
def test_settings_add_their_objects(SC: Any, mbs: Any, build: Any, changes: Any, more: Any) -> None:
    """Numbers of parts that a setting adds to a scene."""
    build(mbs)
    mbs.Assemble()
    settings = SC.visualizationSettings
    settings.contour.outputVariable = (
        exu.OutputVariableType.Position if build is cantilever else exu.OutputVariableType._None
    )
    before = SceneMaker(mbs, settings).scene()
    for path, value in changes.items():
        parent, _, name = path.rpartition(".")
        setattr(attrgetter(parent)(settings), name, value)
    after = SceneMaker(mbs, settings).scene()
    parts = ("instances", "spheres", "lines", "labels")
    added = {part: len(getattr(after, part)) - len(getattr(before, part)) for part in parts}
    assert {part: count for part, count in added.items() if count} == more


def test_the_diagram_of_a_beam_has_the_height_of_its_numbers(SC: Any, mbs: Any) -> None:
    cantilever(mbs)
    mbs.Assemble()
    settings = SC.visualizationSettings
    settings.contour.outputVariable, settings.contour.outputVariableComponent = exu.OutputVariableType.Position, 0
    beams = settings.bodies.beams
    beams.drawVertical, beams.drawVerticalLines, beams.drawVerticalFactor, beams.drawVerticalOffset = (
        True,
        False,
        2,
        0.5,
    )
    line = SceneMaker(mbs, settings).scene().lines[-1][0]
    assert line[:, 1] == pytest.approx(2 * (line[:, 0] + 0.5), abs=1e-12)  # the number is the place along the beam


def test_a_range_that_only_grows(SC: Any, mbs: Any) -> None:
    cantilever(mbs)
    mbs.Assemble()
    settings, shown = SC.visualizationSettings, exu.ConfigurationType.Visualization
    settings.contour.outputVariable, settings.contour.outputVariableComponent = exu.OutputVariableType.Position, 1
    for shrinks, expected in ((True, 0.1), (False, 0.3)):
        settings.contour.reduceRange = shrinks
        maker = SceneMaker(mbs, settings)
        for height in (0.3, 0.1):
            mbs.systemData.SetODE2Coordinates([0, 0, 0, 0, 0, height, 0, 0], shown)
            limits = maker.scene().value_range
        assert limits[1] == pytest.approx(expected, rel=0.05)


def test_plates_have_a_thickness(SC: Any, mbs: Any) -> None:
    item = next(item for item in READY if item.name == "ObjectANCFThinPlate")
    SC, mbs = run(item)
    for solid, factor in ((True, 1.0), (True, 3.0), (False, 1.0)):
        SC.visualizationSettings.bodies.shells.drawSolid = solid
        SC.visualizationSettings.bodies.shells.thicknessFactor = factor
        plate = next(
            i for i in SceneMaker(mbs, SC.visualizationSettings).scene().instances if len(i.mesh.points) in (4, 8)
        )
        assert len(plate.mesh.points) == (8 if solid else 4)
        if solid:
            number = next(
                n for n in range(mbs.systemData.NumberOfObjects()) if "Plate" in mbs.GetObject(n)["objectType"]
            )
            thickness = factor * float(np.ravel(mbs.GetObject(number)["physicsThickness"])[0])
            assert np.linalg.norm(plate.mesh.points[0] - plate.mesh.points[4]) == pytest.approx(thickness)
