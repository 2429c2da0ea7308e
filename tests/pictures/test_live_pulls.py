"""Bodies that are pulled with the mouse: the point that is held, what solvers are asked for, and when they are released."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from browser import Browser, Tab, running
from page_reader import Reader, settings, solving

import dalembert as exu
from dalembert import _core, graphics
from dalembert._live.viewer import Viewer, viewer_of
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.trees import distance

Shown = exu.ConfigurationType.Visualization
CONTROL, META = 2, 4


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """Calls of the functions that let a solver pull: object, held point, target, strength; "released"."""
    calls: list[Any] = []
    grab, pull, release = _core._Shadow.grab, _core._Shadow.pull, _core._Shadow.release
    held: list[Any] = []

    def noted_grab(shadow: Any, number: int, point: Any, link: int) -> None:
        grab(shadow, number, point, link)
        held[:] = [number, local_point(shadow.system, number, shadow.gripped)]

    def noted_pull(shadow: Any, target: Any, strength: float) -> None:
        pull(shadow, target, strength)
        calls.append((*held, target, strength))

    def noted_release(shadow: Any) -> None:
        release(shadow)
        calls.append("released")

    monkeypatch.setattr(_core._Shadow, "grab", noted_grab)
    monkeypatch.setattr(_core._Shadow, "pull", noted_pull)
    monkeypatch.setattr(_core._Shadow, "release", noted_release)
    return calls


def local_point(mbs: Any, body: int, point: Any) -> Any:
    """A point of a rigid body in its frame."""
    place, turned = pose(mbs)
    return turned.T @ (np.asarray(point) - place)


def begin(reader: Reader, head: dict[str, Any], kind: str, number: int, **words: Any) -> None:
    """Pull an item of a scene that is at (1, 0, 0)."""
    item = next(n for n, entry in enumerate(head["items"]) if entry[:2] == [kind, number])
    words = {"id": "a", "time": 0.0, "point": [1.1, 0, 0.05], "target": [2, 3, 4], "strength": 25.0} | words
    reader.send("pull", item=item, scene=head["scene"], **words)


def pose(mbs: Any) -> tuple[Any, Any]:
    """Position and rotation matrix of the brick as it is shown."""
    place, turned = (
        mbs.GetObjectOutputBody(1, variable, [0, 0, 0], Shown)
        for variable in (exu.OutputVariableType.Position, exu.OutputVariableType.RotationMatrix)
    )
    return place, np.reshape(turned, (3, 3))


# ---- messages


def test_a_drag_pulls_until_the_button_is_let_go(swinging: Any, viewer: Viewer, asked: list[Any]) -> None:
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    thread = solving(swinging, 10**9, 1.0)  # so slowly that it hardly moves
    reader.message("frame")
    begin(reader, head, "Object", 1)
    told = reader.message("grip")
    np.testing.assert_allclose(told["point"], [1.1, 0, 0.05], atol=1e-6)
    assert told["target"] == [2, 3, 4]
    reader.send("pull", id="a", target=[2, 3, 5], strength=50)
    while reader.message("grip")["target"] != [2, 3, 5]:  # each picture is followed by one
        pass
    reader.send("release", id="a")
    while reader.message("grip") != {"kind": "grip", "id": "a", "point": None}:
        pass
    for call, target, strength in zip(asked, ((2, 3, 4), (2, 3, 5)), (25, 50), strict=False):
        assert (call[0], *call[2:]) == (1, list(target), strength)
        np.testing.assert_allclose(call[1], [0.1, 0, 0.05], atol=1e-6)
    assert len(asked) == 3 and asked[2] == "released"
    reader.send("pull", id="a", target=[2, 3, 5], strength=50)  # comes too late
    reader.press("q")
    thread.join(10)
    assert len(asked) == 3


def test_the_point_is_held_that_readers_have_seen(swinging: Any, viewer: Viewer, asked: list[Any]) -> None:
    """The brick moves on while they take it: its point is that of the state in the picture."""
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    for end in (0.5, 1.0):
        swinging.SolveDynamic(settings(50, end))
        while reader.picture()[0]["time"] != end:
            pass
    thread = solving(swinging)
    reader.message("frame")
    times = viewer.past.record_of(0).times
    assert times[:2].tolist() == [0.0, 0.5]
    place, turned = viewer.past.record_of(0).at(0.5, lambda: pose(viewer.shadows[0].system))
    assert place[1] < -0.3  # far from where it was, and is
    begin(reader, head, "Object", 1, point=(place + turned @ [0.2, 0.1, 0]).tolist(), time=0.5)
    reader.until(lambda: asked)
    np.testing.assert_allclose(asked[0][1], [0.2, 0.1, 0], atol=1e-12)
    reader.press("q")
    thread.join(10)


def test_a_free_mass_comes_to_the_mouse(mbs: Any, SC: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its node is drawn in its place. It comes to rest at the target: a critically damped spring, in steps that are short for 10 rad/s."""
    mass = mbs.CreateMassPoint(physicsMass=2, referencePosition=[1, 0, 0], drawSize=0.3)
    mbs.Assemble()
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    SC.renderer.Start()
    viewer = viewer_of(SC)
    assert viewer is not None
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    thread = solving(mbs)
    reader.message("frame")
    begin(reader, head, "Node", 0, point=[1, 0, 0], target=[2, 3, 4], strength=100.0)
    while not np.allclose(reader.message("grip")["point"], [2, 3, 4], rtol=0, atol=1e-6):
        pass
    reader.send("pull", id="a", target=[-1, 0, 0], strength=100.0)
    while not np.allclose(reader.message("grip")["point"], [-1, 0, 0], rtol=0, atol=1e-6):
        pass
    reader.send("release", id="a")
    reader.press("q")
    thread.join(10)
    place = mbs.GetObjectOutputBody(mass, exu.OutputVariableType.Position)
    np.testing.assert_allclose(place, [-1, 0, 0], atol=1e-5)  # it was at rest
    SC.renderer.Stop()


def test_a_link_of_a_tree_turns_to_the_mouse(mbs: Any, SC: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """The end of a link of 1 m that turns about z at the origin; the force has no moment if it points to the mouse."""
    node = mbs.AddNode(
        exu.NodeGenericODE2(
            numberOfODE2Coordinates=1, referenceCoordinates=[0.0], initialCoordinates=[0.0], initialCoordinates_t=[0.0]
        )
    )
    tree = mbs.AddObject(
        exu.ObjectKinematicTree(
            nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ], linkParents=[-1], linkMasses=[100.0],
            jointTransformations=[np.eye(3)], jointOffsets=[[0, 0, 0]], linkCOMs=[[0.5, 0, 0]],
            linkInertiasCOM=[np.diag([1.0, 8.0, 8.0])], jointDControlVector=[20.0], jointPControlVector=[0.0],
            jointVelocityOffsetVector=[0.0], visualization=exu.VObjectKinematicTree(
                graphicsDataList=[[graphics.Brick(centerPoint=[0.5, 0, 0], size=[1, 0.1, 0.1])]]
            ),
        )
    )  # fmt: skip
    mbs.Assemble()
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    SC.renderer.Start()
    viewer = viewer_of(SC)
    assert viewer is not None
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    thread = solving(mbs, 10**6, 1e4)
    reader.message("frame")
    begin(reader, head, "Object", tree, point=[1, 0, 0], target=[0.9, 1.2, 0], strength=100.0)
    while not np.allclose(reader.message("grip")["point"], [0.6, 0.8, 0], rtol=0, atol=1e-6):
        pass
    reader.press("q")
    thread.join(10)
    SC.renderer.Stop()


@pytest.mark.parametrize("with_shapes", [False, True])
def test_links_of_trees_are_found_by_their_surface(mbs: Any, with_shapes: bool) -> None:
    """Three links of 1 m in a row; a rod before a joint belongs to the link before it, the first one to the base."""
    node = mbs.AddNode(
        exu.NodeGenericODE2(
            numberOfODE2Coordinates=3, referenceCoordinates=[0.0] * 3, initialCoordinates=[0.0, np.pi / 2, 0.0],
            initialCoordinates_t=[0.0] * 3,
        )
    )  # fmt: skip
    shapes = [[graphics.Brick(centerPoint=[0.5, 0, 0], size=[0.8, 0.2, 0.2])]] * 3 if with_shapes else []
    tree = mbs.AddObject(
        exu.ObjectKinematicTree(
            nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ] * 3, linkParents=[-1, 0, 1], linkMasses=[1.0] * 3,
            jointTransformations=[np.eye(3)] * 3, jointOffsets=[[1, 0, 0]] * 3, linkCOMs=[[0.5, 0, 0]] * 3,
            linkInertiasCOM=[np.eye(3)] * 3, visualization=exu.VObjectKinematicTree(graphicsDataList=shapes),
        )
    )  # fmt: skip
    mbs.Assemble()
    maker = SceneMaker(mbs, mbs.GetSystemContainer().visualizationSettings)
    maker.scene()  # the second link turns at (2, 0, 0) to the y axis
    found = [maker.link_at(tree, np.array(point)) for point in ([0.5, 0, 0], [1.5, 0, 0], [2, 0.5, 0], [2, 1.3, 0])]
    assert found == ([0, 0, 1, 2] if with_shapes else [-1, 0, 1, 2])
    corner = [[[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]]
    for point, expected in (([0.2, 0.2, 3], 3.0), ([-3, -4, 0], 5.0), ([0.5, -2, 0], 2.0), ([1, 1, 0], np.sqrt(0.5))):
        assert distance(np.array(corner), np.array(point)) == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize("how", ["page", "past", "systems", "stop", "another"])
def test_a_body_is_released(SC: Any, swinging: Any, viewer: Viewer, asked: list[Any], how: str) -> None:
    """The page is closed, an earlier state or another system is shown, the viewer ends, or another page pulls."""
    reader, other = Reader(viewer), Reader(viewer)
    head, _ = reader.message("scene")
    thread = solving(swinging)
    reader.message("frame")
    begin(reader, head, "Node", 0)  # the body on it
    reader.until(lambda: asked)
    assert asked[0][0] == 1 and "released" not in asked
    if how == "page":
        reader.socket.close()
    elif how == "past":
        reader.send("seek", time=0.0)
    elif how == "systems":
        SC.AddSystem().CreateMassPoint(physicsMass=1)
    elif how == "stop":
        viewer.stop()
    else:
        begin(other, head, "Object", 1, target=[0, 0, 7])
        other.until(lambda: len(asked) >= 3)
        while reader.message("grip")["point"] is not None:
            pass
        reader.send("pull", id="a", target=[9, 9, 9], strength=1)
        reader.send("release", id="a")  # of what it does not hold any more
        other.send("pull", id="a", target=[0, 0, 8], strength=25)
        other.until(lambda: asked[-1][2:] == ([0, 0, 8], 25))
        assert asked[1] == "released" and asked.count("released") == 1
        other.socket.close()
    other.until(lambda: asked[-1] == "released") if how in ("page", "past", "systems") else None
    for _ in range(200):
        if asked[-1] == "released":
            break
        thread.join(0.05)
    assert asked[-1] == "released"
    swinging.SetRenderEngineStopFlag(True)
    thread.join(10)


def test_what_cannot_be_pulled_is_refused_by_name(swinging: Any, viewer: Viewer, asked: list[Any]) -> None:
    reader = Reader(viewer)
    head, _ = reader.message("scene")

    def refused(kind: str, number: int, **words: Any) -> str:
        begin(reader, head, kind, number, **words)
        assert reader.message("grip")["point"] is None
        return str(reader.message("notice")["text"])

    assert refused("Object", 1) == "pull: no solver is running; bodies are pulled while one runs or is paused"
    thread = solving(swinging)
    reader.message("frame")
    spring = refused("Object", 2)
    assert spring.startswith("pull: object 2 ") and spring.endswith("cannot be pulled, because it has no position.")
    assert refused("Object", 0).endswith("(ObjectGround): cannot be pulled, because it does not move.")
    marker = refused("Marker", 0)
    assert marker.startswith("pull: marker 0 ") and marker.endswith("belongs to no body; pull a body")
    assert refused("Object", 1, strength=-1) == "pull: expected finite numbers, and a positive strength"
    assert refused("Object", 1, target=[0, 0, float("nan")]) == "pull: expected finite numbers, and a positive strength"
    reader.send("seek", time=0.0)
    assert refused("Object", 1).startswith("pull: an earlier state is shown")
    reader.send("pull", id="a", item=999, scene=head["scene"], time=0.0, point=[0, 0, 0], target=[0, 0, 0], strength=1)
    assert reader.message("notice")["text"] == "pull: the item is not there any more"
    assert asked == ["released"] * len(asked)
    reader.press("q")
    thread.join(10)


# ---- in a browser


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with running() as started:
        yield started


@pytest.fixture
def tab(browser: Browser, viewer: Viewer) -> Iterator[Tab]:
    opened = browser.tab(viewer.server.address)
    opened.wait("page.frames > 0 && page.drawn > 0")
    opened.value("page.look({ rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], center: [1, 0, 0], zoom: 1 })")
    yield opened
    assert opened.errors == []
    opened.close()


def mouse(tab: Tab, kind: str, x: float, y: float, held: int = CONTROL, **more: Any) -> None:
    down = kind != "mouseReleased"
    tab.call(
        "Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=int(down), clickCount=1,
        modifiers=held, **more,
    )  # fmt: skip


@pytest.mark.parametrize("held", [CONTROL, META])
def test_the_mouse_pulls_a_body_and_a_line_shows_it(
    swinging: Any, viewer: Viewer, tab: Tab, asked: list[Any], held: int
) -> None:
    """The mouse is in the plane through the point that is held; the force is in proportion to the length of the line,
    5 g per kg if that is half the height of the view."""
    thread = solving(swinging, 10**9, 1.0)  # so slowly that it hardly moves
    tab.wait("page.state.textContent === 'solving'")
    tab.press(" ")
    tab.wait("page.state.textContent === 'paused'")
    shown = viewer.shadows[0].system
    while tab.value("page.now") != shown.systemData.GetTime(Shown):
        thread.join(0.2)  # its last step is drawn
    place, turned = pose(shown)
    before = tab.value("JSON.stringify(page.looking())")
    x, y = tab.value(f"page.projected({(place + turned @ [0.1, 0, 0.05]).tolist()})")
    hit = tab.value(f"[...page.hit({x}, {y}).point]")
    mouse(tab, "mousePressed", x, y, held)
    mouse(tab, "mouseMoved", x + 2, y, held)
    assert not asked  # it may be a click
    mouse(tab, "mouseMoved", x + 60, y - 40, held)
    tab.wait("page.string?.isLine && page.grip.words.startsWith('pull: ')")
    target = tab.value("[...page.grip.held.target]")
    assert tab.value(f"page.projected({target})") == pytest.approx([x + 60, y - 40], abs=1e-3)
    assert target[2] == pytest.approx(hit[2], abs=1e-9)
    zoom = tab.value("page.looking().zoom")
    line = np.reshape(tab.value("[...page.string.geometry.getAttribute('position').array]"), (2, 3))
    np.testing.assert_allclose(line, [hit, target], atol=1e-6)
    while not asked:
        thread.join(0.02)
    number, local, pulled, strength = asked[-1]
    assert (number, pulled) == (1, target) and strength == pytest.approx(5 * 9.81 / zoom)
    np.testing.assert_allclose(place + turned @ local, hit, atol=1e-6)  # a picture is right to that
    length = np.linalg.norm(np.subtract(target, hit))
    text = tab.value("page.time.textContent.split('\\n').find((line) => line.startsWith('pull'))")
    assert float(text.split()[1]) == pytest.approx(strength * length, rel=5e-3) and text.split()[2] == "m/s²"
    mouse(tab, "mouseWheel", x + 60, y - 40, held, deltaX=0, deltaY=-100)
    tab.wait("page.grip.factor === 2")
    mouse(tab, "mouseMoved", x + 61, y - 40, held)
    tab.value("page.take({ kind: 'grip', id: 'one before', point: null })")  # comes late
    assert tab.value("!!page.grip.held && !!page.string")
    mouse(tab, "mouseReleased", x + 61, y - 40, held)
    tab.wait("!page.string && !page.grip.held && !page.time.textContent.includes('pull')")
    while asked[-1] != "released":
        thread.join(0.02)
    assert asked[-2][3] == pytest.approx(2 * strength)
    mouse(tab, "mousePressed", x, y, held)
    mouse(tab, "mouseMoved", x + 60, y, held)
    while asked[-1] == "released":
        thread.join(0.02)
    tab.value("page.split([])")  # a view in which the drag has begun may end
    while asked[-1] != "released":
        thread.join(0.02)
    mouse(tab, "mouseReleased", x + 60, y, held)
    assert tab.value("JSON.stringify(page.looking())") == before
    swinging.SetRenderEngineStopFlag(True)
    thread.join(10)


def test_without_a_drag_it_is_a_click_and_beside_bodies_the_view_moves(tab: Tab, asked: list[Any]) -> None:
    x, y = tab.value("page.projected([1, 0, 0.05])")
    mouse(tab, "mousePressed", x, y)
    mouse(tab, "mouseReleased", x, y)
    tab.wait("document.querySelector('[data-name=details] h2')?.textContent === 'object 1'")
    before = tab.value("JSON.stringify(page.looking().center)")
    for kind, shift in (("mousePressed", 0), ("mouseMoved", 20), ("mouseMoved", 40), ("mouseReleased", 40)):
        mouse(tab, kind, x - 200 + shift, y + 100)
    tab.wait(f"JSON.stringify(page.looking().center) !== '{before}'")
    assert not asked
    tab.press("?")
    assert "pull a body" in tab.wait("document.querySelector('[data-name=help]').textContent")


def test_a_refused_body_is_let_go(swinging: Any, tab: Tab, asked: list[Any]) -> None:
    """No solver runs: a notice says it, and the line goes."""
    x, y = tab.value("page.projected([1, 0, 0.05])")
    mouse(tab, "mousePressed", x, y)
    mouse(tab, "mouseMoved", x + 50, y)
    assert (
        tab.wait("page.notice.textContent")
        == "pull: no solver is running; bodies are pulled while one runs or is paused"
    )
    tab.wait("!page.grip.held && !page.string")
    mouse(tab, "mouseMoved", x + 60, y)
    mouse(tab, "mouseReleased", x + 60, y)
    assert not asked and tab.value("page.string ?? null") is None
