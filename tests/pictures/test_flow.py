"""Items that move as arrays have the same positions as when drawn anew."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator
from enum import Enum
from operator import attrgetter
from typing import Any

import numpy as np
import pytest
from page_reader import unpacked
from test_items import READY, run
from test_live_messages import messages

import dalembert as exu
import dalembert.itemInterface
import dalembert.robotics
from dalembert import _core, graphics
from dalembert._live.messages import Stage
from dalembert._pictures import looks
from dalembert._pictures.flow import Flow
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.places import Places
from dalembert._pictures.scene import Scene
from dalembert._pictures.studio import Studio
from dalembert.utilities import InertiaCuboid

Shown = exu.ConfigurationType.Visualization


def move(mbs: Any, seed: int) -> None:
    """Bring the system to another state: some that no solver would find, but small enough for all items."""
    rng = np.random.default_rng(seed)
    q = np.array(mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Initial), float)
    q += 0.05 * rng.uniform(-1, 1, q.shape)
    for node in range(mbs.systemData.NumberOfNodes()):
        parameters = mbs.GetNode(node)
        if parameters["nodeType"] == "RigidBodyEP":  # Euler parameters have the length 1
            part = slice(mbs.GetNodeODE2Index(node) + 3, mbs.GetNodeODE2Index(node) + 7)
            reference = np.asarray(parameters["referenceCoordinates"], float)[3:]
            q[part] = (q[part] + reference) / np.linalg.norm(q[part] + reference) - reference
    mbs.systemData.SetODE2Coordinates(q, Shown)


def points(scene: Scene) -> dict[str, list[Any]]:
    """Corners of meshes, spheres, lines and labels by item, in an order that does not depend on how they were drawn."""
    whole, found = scene.unbound(), defaultdict(list)
    name = [f"{i.kind}{i.number}" for i in whole.items]
    for part in whole.instances:
        color = part.color if part.mesh.colors is None else part.mesh.colors[0]
        if part.mesh.colors is None:  # a symbol, which may be turned about its own axis
            shape = [*part.matrix[:, 2], *(part.matrix @ part.matrix.T).ravel(), *part.place]
        else:
            shape = (part.mesh.points[[0, len(part.mesh.points) // 3, -1]] @ part.matrix.T + part.place).ravel()
        found[name[part.item]].append([*shape, *color])
    for center, radius, color, item in whole.spheres:
        found[name[item]].append([*center, radius, *color])
    for line, color, width, item in whole.lines:
        found[name[item]].append([*line.ravel(), width, *color])
    found["labels"] += [[*label.place, len(label.text)] for label in whole.labels]
    return {key: sorted(np.round(np.asarray(row, float), 12).tolist() for row in rows) for key, rows in found.items()}


def assert_same(moved: Scene, drawn: Scene, size: float, turning: bool) -> None:
    """Points of meshes that bend by modes are in single precision when they are drawn again: rounding leaves 1e-7 of the size, in a few sums."""
    a, b = points(moved), points(drawn)
    assert a.keys() == b.keys()
    bent = {f"Object{item.number}" for item in moved.items if item.type_name == "FFRFreducedOrder"}
    for key, rows in a.items():
        if turning and key.startswith("Load"):
            continue  # an arrow around an axis begins anywhere
        assert len(rows) == len(b[key]), key
        for one, other in zip(rows, b[key], strict=True):
            part = 1e-6 if key in bent else 1e-9
            assert np.asarray(one) == pytest.approx(np.asarray(other), abs=part * size, rel=part), key


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_moved_scenes_are_as_drawn_ones(item: Any) -> None:
    SC, mbs = run(item)
    for kind in ("nodes", "markers", "loads", "bodies", "connectors"):
        getattr(SC.visualizationSettings, kind).showNumbers = True
    SC.visualizationSettings.nodes.showBasis = True
    maker = SceneMaker(mbs, SC.visualizationSettings)
    if not maker.is_assembled():
        mbs.Assemble()
    flow = Flow(maker)
    for seed in range(3):
        move(mbs, seed)
        assert_same(flow.scene(), maker.scene(), maker.looks.size, "Torque" in item.name)


@pytest.mark.parametrize("variable", ["_None", "Displacement"])
def test_meshes_alone_are_drawn_again_in_single_precision(SC: Any, mbs: Any, variable: str) -> None:
    """Also where nothing else is drawn, which would move with items."""
    (item,) = (item for item in READY if item.name == "ObjectFFRFreducedOrder")
    SC, mbs = run(item)
    for kind in ("nodes", "markers", "loads", "sensors", "connectors"):
        getattr(SC.visualizationSettings, kind).show = False
    SC.visualizationSettings.contour.outputVariable = getattr(exu.OutputVariableType, variable)
    maker = SceneMaker(mbs, SC.visualizationSettings)
    flow = Flow(maker)
    for seed in range(2):
        move(mbs, seed)
        moved = flow.scene()
    assert_same(moved, maker.scene(), maker.looks.size, False)
    assert {part.mesh.points.dtype.name for part in moved.instances if part.mesh.triangles.any()} == {"float32"}


def test_many_that_look_alike_are_as_drawn_one_by_one(SC: Any, mbs: Any) -> None:
    """Equal graphics in different lists are shared; other colors, hidden bodies, and some with markers alone, are
    not."""
    rng = np.random.default_rng(2)
    for i in range(700):
        red = i % 100 == 7
        brick = graphics.Brick(size=[0.2, 0.1, 0.1], color=graphics.color.red if red else graphics.color.blue)
        mbs.CreateRigidBody(
            name="" if i % 3 else f"body {i} of many", inertia=InertiaCuboid(1000, [0.2, 0.1, 0.1]),
            referencePosition=rng.normal(size=3), initialAngularVelocity=[0, 0, 1], show=i % 50 != 3,
            graphicsDataList=[] if i % 90 == 5 else [brick],
        )  # fmt: skip
    mbs.Assemble()
    first = exu._core._ScenePlaces(mbs).alike(1)
    assert len(set(first.tolist())) == 4 and first[7] == 7 and (first[first != 7] < 6).all()
    maker = SceneMaker(mbs, SC.visualizationSettings)
    flow = Flow(maker)
    for seed in range(2):
        move(mbs, seed)
        moved, drawn = flow.scene(), maker.scene()
        assert sorted(len(herd.items) for herd in moved.herds) == [7, 8, 671]  # red ones, balls, blue ones
        assert sorted(moved.items) == sorted(drawn.items)
        assert_same(moved, drawn, maker.looks.size, False)


def test_many_masses_without_shapes_are_balls_together(SC: Any, mbs: Any) -> None:
    """Items with a marker have a rod to it, and are drawn separately; all are as they would be if all were."""
    rng = np.random.default_rng(3)
    for i in range(300):
        node = mbs.AddNode(dalembert.itemInterface.NodePoint(referenceCoordinates=rng.normal(size=3)))
        body = mbs.AddObject(dalembert.itemInterface.ObjectMassPoint(physicsMass=1, nodeNumber=node))
        if i % 100 == 9:
            mbs.AddMarker(dalembert.itemInterface.MarkerBodyPosition(bodyNumber=body, localPosition=[0, 0, 0]))
    mbs.Assemble()
    maker = SceneMaker(mbs, SC.visualizationSettings)
    together = maker.draw(Shown, crowded=True)[0]
    assert (len(together.balls.radii), len(together.spheres)) == (597, 3)
    flow = Flow(maker)
    for seed in range(2):
        move(mbs, seed)
        moved, drawn = flow.scene(), maker.scene()
        assert_same(moved, drawn, maker.looks.size, False)


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_places_of_all_items_are_those_of_each(item: Any) -> None:
    _, mbs = run(item)
    mbs.Assemble()
    move(mbs, 4)
    together, alone = Places(mbs, Shown, _core._ScenePlaces(mbs)), Places(mbs, Shown)
    for kind in ("Node", "Object", "Marker"):
        for number in range(getattr(mbs.systemData, f"NumberOf{kind}s")()):
            ways = [kind.lower()] if kind != "Object" else ["body", "object"]
            for name in [*ways, *(f"{way}_rotation" for way in ways if way != "object")]:
                one, other = getattr(together, name)(number), getattr(alone, name)(number)
                assert (one is None) == (other is None), (kind, number, name)
                assert one is None or one == pytest.approx(other, abs=1e-14, rel=1e-14), (kind, number, name)


def bricks(mbs: Any, count: int) -> None:
    shape = [graphics.Brick(size=[0.3, 0.2, 0.1])]
    inertia = exu.utilities.InertiaCuboid(1000, [0.3, 0.2, 0.1])
    for i in range(count):
        body = mbs.CreateRigidBody(
            referencePosition=[i % 10, i // 10, 0], inertia=inertia, gravity=[0, 0, -9.81], graphicsDataList=shape
        )
        node = mbs.GetObject(body)["nodeNumber"]
        mbs.SetNodeParameter(node, "Vshow", True)
        mbs.SetNodeParameter(node, "VdrawSize", 0.1)


def test_equal_bodies_are_one_herd(SC: Any, mbs: Any) -> None:
    bricks(mbs, 30)
    mbs.Assemble()
    scene = Flow(SceneMaker(mbs, SC.visualizationSettings)).scene()
    assert not scene.instances and not scene.spheres and not scene.lines
    assert [len(herd.items) for herd in scene.herds if herd.color is None] == [30]
    assert len(scene.balls.items) == 30  # nodes


def test_changes_of_items_are_seen(SC: Any, mbs: Any) -> None:
    bricks(mbs, 3)
    mbs.Assemble()
    maker = SceneMaker(mbs, SC.visualizationSettings)
    flow = Flow(maker)
    flow.scene()
    mbs.SetNodeParameter(1, "Vshow", False)
    assert len(flow.scene().balls.items) == 2
    mbs.SetNodeParameter(1, "Vshow", True)
    mbs.SetNodeParameter(1, "VdrawSize", 0.7)
    assert sorted(flow.scene().balls.radii)[-1] == pytest.approx(0.35)


def test_rods_of_trees_follow_markers_that_are_moved(SC: Any, mbs: Any) -> None:
    link = exu.robotics.RobotLink(mass=1, COM=[0.5, 0.1, 0], inertia=np.eye(3), preHT=np.eye(4))
    robot = exu.robotics.Robot()
    robot.AddLink(link)
    robot.CreateKinematicTree(mbs)
    tree = mbs.systemData.NumberOfObjects() - 1
    mbs.SetObjectParameter(tree, "VgraphicsDataList", [])
    marker = mbs.AddMarker(
        exu.itemInterface.MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=0, localPosition=[0, 0.5, 0])
    )
    mbs.Assemble()
    maker = SceneMaker(mbs, SC.visualizationSettings)
    flow = Flow(maker)
    flow.scene(), maker.scene()
    mbs.SetMarkerParameter(marker, "localPosition", [0, 0.9, 0])
    for scene in (flow.scene(), maker.scene()):
        ends = [i.place + i.matrix[:, 2] for i in scene.unbound().instances if scene.items[i.item].kind == "Object"]
        assert any(end == pytest.approx([0, 0.9, 0], abs=1e-12) for end in ends)


def settings_of(settings: Any, path: str = "") -> Iterator[tuple[str, Any]]:
    """Paths and other values of settings that may be on or off, or count; of one view and one light."""
    for name, value in settings.GetDictionary().items():
        if re.fullmatch("(view|light)[123]", name):
            continue
        below = getattr(settings, name)
        if isinstance(value, dict) and hasattr(below, "GetDictionary"):
            yield from settings_of(below, f"{path}{name}.")
        elif isinstance(value, bool):
            yield path + name, not value
        elif isinstance(value, int) and not isinstance(value, Enum):
            yield path + name, max(value + 1, 0)


OTHERS = {path: value for path, value in settings_of(exu.VisualizationSettings()) if "raytracer" not in path.lower()}


def test_crowds_look_as_each_of_their_members_would(SC: Any, mbs: Any) -> None:
    """Many bodies and nodes that are drawn as arrays look the same as drawn one by one, with any setting."""
    bricks(mbs, 3)
    mbs.AddNode(exu.itemInterface.NodePointSlope1(referenceCoordinates=[0, 0, 2, 1, 0, 0]))
    mbs.Assemble()
    move(mbs, 1)
    defaults = exu.VisualizationSettings()
    assert len(OTHERS) > 100
    for path, value in OTHERS.items():
        parent, _, name = path.rpartition(".")
        setattr(attrgetter(parent)(SC.visualizationSettings), name, value)
        maker = SceneMaker(mbs, SC.visualizationSettings)
        try:
            assert_same(Flow(maker).scene(), maker.scene(), maker.looks.size, turning=True)
        except AssertionError as error:
            raise AssertionError(path) from error
        setattr(attrgetter(parent)(SC.visualizationSettings), name, attrgetter(path)(defaults))


def test_boxes_are_those_of_drawn_scenes(SC: Any, mbs: Any) -> None:
    bricks(mbs, 12)
    mbs.Assemble()
    maker = SceneMaker(mbs, SC.visualizationSettings)
    moved, drawn = Flow(maker).scene(), maker.scene()
    assert moved.box() == pytest.approx(drawn.box(), abs=1e-12)
    assert moved.box_of([3]) == pytest.approx(drawn.box_of([3]), abs=1e-12)


def test_springs_that_become_much_longer_are_drawn_again(SC: Any, mbs: Any) -> None:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1)
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1)
    mbs.Assemble()
    maker = SceneMaker(mbs, SC.visualizationSettings)
    flow = Flow(maker)
    flow.scene()
    for x in (0.5, 1.5, 5.0, -0.9, 0.2):
        mbs.systemData.SetODE2Coordinates([x, 0, 0], Shown)
        moved, drawn = flow.scene().unbound(), maker.scene()
        springs = [[i for i in s.instances if len(i.mesh.points) > 300] for s in (moved, drawn)]
        assert len(springs[0]) == len(springs[1]) == 1
        assert springs[0][0].matrix[:, 2] == pytest.approx(springs[1][0].matrix[:, 2], abs=1e-12)


ALONE = ("ObjectMassPoint", "ObjectRigidBody", "NodeRigidBodyEP", "ObjectConnectorSpringDamper", "ObjectJointGeneric")


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_messages_of_moved_parts_are_those_of_drawn_scenes(item: Any) -> None:
    SC, mbs = run(item)
    SC.visualizationSettings.nodes.showNumbers = True
    maker = SceneMaker(mbs, SC.visualizationSettings)
    if not maker.is_assembled():
        mbs.Assemble()
    flow, quick, slow = Flow(maker), Stage(), Stage()
    told = [messages(stage, flow.scene())[0] for stage in (quick, slow)]
    assert told[0] == told[1]
    assert flow.moving() is not None or item.name not in ALONE
    for seed in range(3):
        move(mbs, seed)
        mbs.systemData.SetTime(0.1 * seed, Shown)
        moved = None if flow.moving() is None else quick.moved(flow)
        head, arrays = unpacked(messages(slow, flow.scene())[1])
        if moved is None or flow.moving() is None:
            return  # springs that become much longer, for one
        assert moved.whole() == told[0]
        quick_head, quick_arrays = unpacked(b"".join(moved.frame))
        kinds, told_kinds = quick_head.pop("arrays"), head.pop("arrays")
        assert quick_head == head
        for kind, told_kind, one, other in zip(kinds, told_kinds, quick_arrays, arrays, strict=True):
            if kind is not None and kind[0] == "r6":  # rotations in units of 1 / 32000
                assert [2 * kind[1], "f4"] == [told_kind[1], told_kind[0]]
                np.testing.assert_allclose(one, other, rtol=1e-7, atol=0.6 / 32000 * 2)
            else:
                assert kind == told_kind
                assert one is None or one.tobytes() == other.tobytes()


VARIABLES = [
    ("_None", -1),
    ("Displacement", 0),
    ("Displacement", -1),
    ("StressLocal", 5),
    ("StressLocal", -1),
    ("Velocity", 0),
]


@pytest.mark.parametrize(("variable", "component"), VARIABLES)
@pytest.mark.parametrize("settings", ["", "fixed", "reduced"])
def test_messages_of_colored_meshes_are_those_of_drawn_scenes(
    SC: Any, mbs: Any, variable: str, component: int, settings: str
) -> None:
    """Points, colors and their range, of a mesh of more than one block and of balls at nodes."""
    contour = SC.visualizationSettings.contour
    contour.outputVariable, contour.outputVariableComponent = getattr(exu.OutputVariableType, variable), component
    contour.automaticRange, contour.reduceRange = settings != "fixed", settings == "reduced"
    rng, two = np.random.default_rng(3), exu.MatrixContainer()
    two.SetWithDenseMatrix(np.eye(2))
    for x in range(2):
        frame = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[x, 0, 0, 1, 0, 0, 0]))
        modes = mbs.AddNode(
            exu.NodeGenericODE2(
                numberOfODE2Coordinates=2, referenceCoordinates=[0, 0], initialCoordinates=[0, 0],
                initialCoordinates_t=[0, 0],
            )
        )  # fmt: skip
        mbs.AddObject(
            exu.ObjectFFRFreducedOrder(
                nodeNumbers=[frame, modes], massMatrixReduced=two, stiffnessMatrixReduced=two, computeFFRFterms=False,
                referencePositions=rng.uniform(-1, 1, 1203), modeBasis=rng.normal(size=(1203, 2)),
                outputVariableModeBasis=rng.normal(size=(401, 12)),
                outputVariableTypeModeBasis=exu.OutputVariableType.StressLocal,
                visualization=exu.VObjectFFRFreducedOrder(triangleMesh=rng.integers(0, 401, (300, 3))),
            )
        )  # fmt: skip
    mbs.Assemble()
    move(mbs, 4)  # otherwise all numbers would be zero at first
    maker = SceneMaker(mbs, SC.visualizationSettings)
    flow, quick, slow = Flow(maker), Stage(), Stage()
    told = [messages(stage, flow.scene())[0] for stage in (quick, slow)]
    assert told[0] == told[1]
    for seed in range(4):
        move(mbs, seed)
        before = maker._range
        moved = quick.moved(flow) if flow.moving() is not None else None
        if variable == "Velocity":  # neither meshes nor messages contain this at once
            assert moved is None
            return
        assert moved is not None
        after, maker._range = maker._range, before
        head, arrays = unpacked(messages(slow, flow.scene())[1])
        assert maker._range == after == (None if variable == "_None" else pytest.approx(head["range"], rel=1e-15))
        assert moved.whole() == told[0]
        quick_head, quick_arrays = unpacked(b"".join(moved.frame))
        assert quick_head.pop("range") == pytest.approx(head.pop("range"), rel=1e-15)
        assert quick_head == head
        for one, other in zip(quick_arrays, arrays, strict=True):
            assert (one is None) == (other is None) and (one is None or one.tobytes() == other.tobytes())


def test_settings_are_asked_for_when_some_have_changed(SC: Any, mbs: Any, monkeypatch: Any) -> None:
    mbs.CreateMassPoint(physicsMass=1)
    mbs.Assemble()
    studio, asked, below = Studio(SC), [], looks._below
    studio.flow()
    monkeypatch.setattr(looks, "_below", lambda settings, path: asked.append(path) or below(settings, path))
    studio.flow()
    assert not asked
    SC.visualizationSettings.view0.scene.drawWorldBasis = True
    studio.flow()
    assert "view0.scene.drawWorldBasis" in asked


def test_settings_stay_as_they_are_while_a_scene_is_made(SC: Any) -> None:
    settings, seen = SC.visualizationSettings, looks.Looks(SC.visualizationSettings)
    with seen.kept():
        settings.nodes.defaultSize = 0.3
        assert seen.setting("nodes.defaultSize") == -1
    with seen.kept(), seen.kept():
        assert seen.setting("nodes.defaultSize") == pytest.approx(0.3)
    assert seen.setting("nodes.defaultSize") == pytest.approx(0.3)


def test_the_core_keeps_a_range_that_is_one_number(SC: Any, mbs: Any) -> None:
    for x in range(2):
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[x, 0, 0]))
        mbs.AddObject(exu.ObjectMassPoint(physicsMass=1, nodeNumber=node))
    mbs.Assemble()
    contour = SC.visualizationSettings.contour
    contour.outputVariable, contour.outputVariableComponent = exu.OutputVariableType.Displacement, 1
    contour.reduceRange = True
    SC.visualizationSettings.bodies.show = False
    flow, stage = Flow(SceneMaker(mbs, SC.visualizationSettings)), Stage()
    messages(stage, flow.scene())
    for y in ([0, -1], [0.5, 0.5], [0.5, 0.5 + 1e-15], [-2, 3]):
        mbs.systemData.SetODE2Coordinates([0, y[0], 0, 0, y[1], 0], exu.ConfigurationType.Visualization)
        parts = flow.moving()
        assert parts is not None and stage.moved(flow) is not None
        assert parts.range == pytest.approx((min(y), max(y)), rel=1e-14)
        assert (parts.range[0] == parts.range[1]) == (y[0] == 0.5)
