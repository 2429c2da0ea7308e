"""The live page without a browser: who may connect, what is sent while a solver works, what keys and choices do."""

from __future__ import annotations

import copy
import json
import os
import socket
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

import dalembert as exu
from dalembert import graphics
from dalembert._live import messages as sending
from dalembert._live import server as serving
from dalembert._live.histories import LONGEST, Track
from dalembert._live.messages import Picture, Stage
from dalembert._live.viewer import Viewer, viewer_of
from dalembert._pictures.camera import Camera
from dalembert._pictures.flow import Flow
from dalembert._pictures.looks import Looks
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.meshes import Mesh
from dalembert._pictures.scene import DrawnItem, Herd, Instance, Label, Scene
from dalembert._pictures.studio import Studio
from dalembert.utilities import InertiaCuboid

Shown = exu.ConfigurationType.Visualization
FOLDER = Path(exu.__file__).resolve().parent / "_pictures/page"


def unpacked(data: bytes) -> tuple[dict[str, Any], list[Any]]:
    """Head and arrays of a message."""
    length = int(np.frombuffer(data[:4], "<u4")[0])
    head, offset, arrays = json.loads(data[4 : 4 + length]), 4 + length, []
    for entry in head["arrays"]:
        if entry is None:
            arrays.append(None)
            continue
        kind, count = entry
        part = np.frombuffer(data, {"f4": "<f4", "u4": "<u4", "u1": "u1", "r6": "<u4"}[kind], count, offset)
        offset += -(-part.nbytes // 4) * 4
        arrays.append(turned(part) if kind == "r6" else part)
    assert offset == len(data) and (4 + length) % 8 == 0
    return head, arrays


def turned(words: Any) -> Any:
    """Places in 12 numbers each, of six words."""
    words = words.reshape(-1, 6)
    rows = np.empty((len(words), 3, 4))
    rows[:, :, 3] = words[:, :3].copy().view("<f4")
    rows[:, :2, :3] = words[:, 3:].copy().view("<i2").reshape(-1, 2, 3) / 32000
    rows[:, 2, :3] = np.cross(rows[:, 0, :3], rows[:, 1, :3])
    return rows.ravel()


class Reader:
    """What a page is for the server."""

    def __init__(self, viewer: Viewer, token: str | None = None, **headers: str) -> None:
        port = viewer.server.port
        origin = headers.pop("origin", f"http://127.0.0.1:{port}")
        address = f"ws://{headers.pop('host', '127.0.0.1')}:{port}/socket"
        self.socket = connect(address, origin=origin, proxy=None, max_size=None, compression=None).__enter__()  # type: ignore[arg-type]
        self.send("hello", token=viewer.server.token if token is None else token)

    def send(self, kind: str, **words: Any) -> None:
        self.socket.send(json.dumps({"kind": kind, **words}))

    def press(self, key: str, **held: bool) -> None:
        self.send("key", key=key, control=held.get("control", False), shift=held.get("shift", False), action=1)

    def message(self, kind: str, seconds: float = 20) -> Any:
        """The next message of a kind; every picture is acknowledged."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            data = self.socket.recv(timeout=seconds)
            if isinstance(data, bytes):
                head, arrays = unpacked(data)
                self.send("shown")
                if head["kind"] == kind:
                    return head, arrays
            elif (words := json.loads(data))["kind"] == kind:
                return words
        raise AssertionError(f"no message '{kind}'")

    def picture(self) -> tuple[dict[str, Any], list[Any]]:
        """The next picture, whole or not."""
        while not isinstance(data := self.socket.recv(timeout=20), bytes):
            pass
        self.send("shown")
        return unpacked(data)

    def until(self, true: Any, seconds: float = 20) -> None:
        """Read until something is true."""
        end = time.monotonic() + seconds
        while not true():
            assert time.monotonic() < end
            try:
                if isinstance(self.socket.recv(timeout=0.05), bytes):
                    self.send("shown")
            except TimeoutError:
                pass


@pytest.fixture
def swinging(mbs: Any) -> Any:
    """A brick that swings below a spring."""
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(
        name="brick", referencePosition=[1, 0, 0], inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]), gravity=[0, -9.81, 0],
        graphicsDataList=[graphics.Brick(size=[0.4, 0.2, 0.1], color=graphics.color.orange)],
    )  # fmt: skip
    mbs.CreateSpringDamper(bodyNumbers=[ground, body], stiffness=1000, damping=1)
    mbs.Assemble()
    return mbs


@pytest.fixture
def viewer(SC: Any, swinging: Any, monkeypatch: pytest.MonkeyPatch) -> Iterator[Viewer]:
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    assert SC.renderer.Start()
    found = viewer_of(SC)
    assert found is not None
    yield found
    SC.renderer.Stop()
    assert viewer_of(SC) is None and not SC.renderer.IsActive()


def settings(steps: int, end: float = 1.0) -> Any:
    result = exu.SimulationSettings()
    result.timeIntegration.endTime = end
    result.timeIntegration.numberOfSteps = steps
    result.timeIntegration.verboseMode = 0
    result.solutionSettings.writeSolutionToFile = False
    return result


def solving(mbs: Any, steps: int = 1_000_000, end: float = 1000.0) -> threading.Thread:
    """A thread that solves, for a long time."""
    thread = threading.Thread(target=lambda: mbs.SolveDynamic(settings(steps, end)), daemon=True)
    thread.start()
    return thread


# ---- who may connect


def asked(viewer: Viewer, path: str, **headers: str) -> Any:
    request = urllib.request.Request(f"http://127.0.0.1:{viewer.server.port}{path}", headers=headers)
    return urllib.request.build_opener(urllib.request.ProxyHandler({})).open(request, timeout=10)


def test_the_port_is_of_this_machine_only(viewer: Viewer) -> None:
    addresses = {row[4][0] for row in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
    for address in addresses | {"127.0.0.2"}:  # which Linux has, so that a server of all addresses answers there
        with pytest.raises(OSError):
            socket.create_connection((address, viewer.server.port), timeout=2).close()
    socket.create_connection(("127.0.0.1", viewer.server.port), timeout=2).close()


def test_the_page_tells_nothing_of_the_model_and_allows_nothing(viewer: Viewer) -> None:
    answer = asked(viewer, "/")
    text = answer.read().decode()
    assert viewer.server.token not in text and "brick" not in text and "@" not in text
    policy = answer.headers["Content-Security-Policy"]
    assert "default-src 'none'" in policy and "script-src 'self';" in policy and "frame-ancestors 'none'" in policy
    assert answer.headers["Referrer-Policy"] == "no-referrer" and answer.headers["Cache-Control"] == "no-store"
    assert asked(viewer, "/bundle.js").read() == (FOLDER / "bundle.js").read_bytes()


@pytest.mark.parametrize("path", ["/server.py", "/../html.py", "/%2e%2e/html.py", "//etc/passwd", "/page.html", "/?x"])
def test_there_are_no_other_files(viewer: Viewer, path: str) -> None:
    with pytest.raises(urllib.error.HTTPError, match="404"):
        asked(viewer, path)


def test_another_name_of_the_host_is_refused(viewer: Viewer) -> None:
    """A page of elsewhere whose name is made to lead here (DNS rebinding)."""
    for path in ("/", "/bundle.js"):
        with pytest.raises(urllib.error.HTTPError, match="403"):
            asked(viewer, path, Host="evil.example:80")


@pytest.mark.parametrize("origin", ["http://evil.example", "null", None])
def test_pages_of_elsewhere_are_refused(viewer: Viewer, origin: str | None) -> None:
    with pytest.raises(InvalidStatus, match="403"):
        Reader(viewer, origin=origin)  # type: ignore[arg-type]


@pytest.mark.parametrize("token", ["", "x" * 32, "wrong"])
def test_without_the_token_nothing_is_told(viewer: Viewer, token: str) -> None:
    reader = Reader(viewer, token)
    with pytest.raises(ConnectionClosed) as closed:
        reader.socket.recv(timeout=10)
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1008
    assert viewer.server.pages == 0 and len(viewer.server.token) == 32


def test_tokens_differ_and_are_compared_in_constant_time(
    SC: Any, viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    compared: list[tuple[bytes, bytes]] = []
    monkeypatch.setattr(serving.hmac, "compare_digest", lambda a, b: compared.append((a, b)) or a == b)
    with pytest.raises(ConnectionClosed):
        Reader(viewer, "wrong").socket.recv(timeout=10)
    assert compared == [(b"wrong", viewer.server.token.encode())]
    other = serving.PageServer(lambda page, message: None, 0)
    try:
        assert other.token != viewer.server.token
    finally:
        other.stop()


def test_who_says_nothing_is_sent_away(viewer: Viewer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serving, "PATIENCE", 0.2)
    port = viewer.server.port
    address, origin = f"ws://127.0.0.1:{port}/socket", f"http://127.0.0.1:{port}"
    with connect(address, origin=origin, proxy=None) as silent, pytest.raises(ConnectionClosed):  # type: ignore[arg-type]
        silent.recv(timeout=10)


def test_there_are_not_too_many_pages(viewer: Viewer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serving, "PAGES", 2)
    first, second = Reader(viewer), Reader(viewer)
    first.message("scene")
    second.message("scene")
    with pytest.raises(ConnectionClosed) as closed:
        Reader(viewer).message("scene")
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1013


def test_long_messages_are_refused(viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    reader.send("set", path="x" * (serving.LONGEST + 1), value="")
    with pytest.raises(ConnectionClosed) as closed:
        while True:
            reader.socket.recv(timeout=10)
    assert closed.value.rcvd is not None and closed.value.rcvd.code == 1009
    assert Reader(viewer).message("scene")  # others go on


HOSTILE = [
    "", "no json", "[]", "3", '{"kind": 3}', '{"kind": "opened.__class__"}', '{"kind": "__init__"}', "[" * 10000,
    '{"kind": "key"}', '{"kind": "key", "key": {}, "control": [], "shift": null}', '{"kind": "select", "item": 1e99, "scene": 1}',
    '{"kind": "select", "item": 99999, "scene": 1, "depth": 0}', '{"kind": "camera", "rotation": [], "center": 0, "zoom": 0}',
    '{"kind": "camera", "rotation": [1,0,0,0,1,0,0,0,1], "center": [NaN,0,0], "zoom": 1}', '{"kind": "mouse"}',
    '{"kind": "set", "path": "__class__.__name__", "value": "x"}', '{"kind": "set", "path": "", "value": "1"}',
    '{"kind": "control", "name": "x", "value": {"__reduce__": 1}}',
]  # fmt: skip


def test_nonsense_is_answered_or_ignored(viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    for text in HOSTILE:
        reader.socket.send(text)
    reader.socket.send(b"\x80\x04cos\nsystem\n.")  # a pickle
    reader.press("n")
    reader.until(lambda: not viewer.settings.nodes.show)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("exportImages.saveImageFileName", "/tmp/elsewhere"),
        ("interactive.openVR.actionManifestFileName", "/etc/passwd"),
        ("interactive.keyPressUserFunction", "print"),
        ("nodes.defaultSize", "__import__('os').getpid()"),
        ("nodes.nothing", "1"),
        ("nodes", "1"),
    ],
)
def test_what_pages_may_not_set(viewer: Viewer, path: str, value: str) -> None:
    before = repr(viewer.settings.GetDictionary())
    reader = Reader(viewer)
    reader.send("set", path=path, value=value)
    assert reader.message("notice")["text"]
    assert repr(viewer.settings.GetDictionary()) == before


def test_what_pages_may_set(viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.send("settings")
    rows = {row["path"]: row for row in reader.message("settings")["rows"]}
    assert rows["nodes.show"]["choices"] == ["True", "False"] and rows["nodes"]["branch"]
    assert "Displacement" in rows["contour.outputVariable"]["choices"]
    assert "exportImages.saveImageFileName" not in rows and len(rows) > 400
    reader.send("set", path="contour.outputVariable", value="Displacement")
    reader.send("set", path="nodes.defaultColor", value="[0, 1, 0, 1]")
    while not ((contour := reader.picture()[0].get("contour")) and contour["name"].startswith("Displacement")):
        pass
    reader.until(lambda: list(viewer.settings.nodes.defaultColor) == [0, 1, 0, 1])
    assert viewer.settings.contour.outputVariable == exu.OutputVariableType.Displacement


# ---- what is sent


def moved_scene(shift: float = 0.0) -> Scene:
    """A triangle, a sphere, a line and a text."""
    scene = Scene(items=[DrawnItem("Object", 0, "RigidBody", "<b>"), DrawnItem("Node", 1, "Point", "n")], time=shift)
    mesh = TRIANGLE
    scene.instances = [Instance(mesh, np.eye(3), np.array([shift, 0, 0]), (1, 0, 0, 1), 0)]
    scene.spheres = [(np.array([0.0, 1.0, 2.0]), 0.5, (0, 0, 1, 1), 1)]
    scene.lines = [(np.array([[0, 0, 0], [1, 1, shift]]), (0, 1, 0, 1), 0.0, 1)]
    scene.labels = [Label(np.zeros(3), "N1", (0, 0, 0, 1))]
    return scene


TRIANGLE = Mesh(np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]]), np.array([[0, 1, 2]]))


def messages(stage: Stage, scene: Scene) -> tuple[bytes, bytes]:
    _, whole, frame, _ = stage.messages(scene, Looks(exu.VisualizationSettings()), {"background": [1, 1, 1]}, Camera)
    return whole(), b"".join(frame)


def test_frames_hold_what_has_moved() -> None:
    stage = Stage()
    whole, frame = messages(stage, moved_scene())
    head, arrays = unpacked(whole)
    assert (head["kind"], head["scene"], head["items"][0][:4]) == ("scene", 1, ["Object", 0, "RigidBody", "<b>"])
    np.testing.assert_array_equal(arrays[0], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0])
    assert head["meshes"][0]["color"] == [1, 0, 0, 1] and head["labels"] == [["N1", [0, 0, 0, 1]]]
    assert all(part is None for part in unpacked(frame)[1])
    head, arrays = unpacked(messages(stage, moved_scene(2))[1])
    assert (head["scene"], head["time"]) == (1, 2)
    np.testing.assert_array_equal(arrays[0], [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0])
    assert arrays[1] is None  # the sphere
    np.testing.assert_array_equal(arrays[2], [0, 0, 0, 1, 1, 2])
    assert (
        unpacked(messages(stage, moved_scene())[1])[1][0] is not None
    )  # back again: pages may have missed that it went


def test_what_lines_have_gained_is_looked_for_once_and_only_for_pages_that_have_the_rest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    looks: list[int] = []
    known = sending._grown
    monkeypatch.setattr(sending, "_grown", lambda *arguments: (looks.append(1), known(*arguments))[1])
    stage, nothing = Stage(), Looks(exu.VisualizationSettings())
    for count in (60, 80):
        scene = moved_scene(count)
        scene.lines = [(np.arange(3.0 * count).reshape(-1, 3), (1, 0, 0, 1), 0.0, 0)]
        picture = stage.messages(scene, nothing, {}, Camera)
    assert picture.after(False) is picture.frame and not looks
    assert picture.after(True) is picture.after(True) is not picture.frame and len(looks) == 1


def test_what_changes_its_shape_becomes_deformable() -> None:
    stage = Stage()
    messages(stage, moved_scene())
    scene = moved_scene()
    scene.instances[0].mesh = Mesh(2 * TRIANGLE.points, TRIANGLE.triangles)
    whole, _ = messages(stage, scene)
    head, arrays = unpacked(whole)
    assert head["scene"] == 2 and head["meshes"][0]["deforms"]
    np.testing.assert_array_equal(arrays[0], (2 * TRIANGLE.points).ravel())
    scene = moved_scene()
    scene.instances[0].mesh = Mesh(3 * TRIANGLE.points, TRIANGLE.triangles)
    head, arrays = unpacked(messages(stage, scene)[1])
    assert head["scene"] == 2
    np.testing.assert_array_equal(arrays[0], (3 * TRIANGLE.points).ravel())


def test_what_changes_more_than_its_points_is_another_scene() -> None:
    stage, shades = Stage(), np.array([[1.0, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]])
    for number in range(5):
        scene = moved_scene()
        triangles = TRIANGLE.triangles if number < 3 else TRIANGLE.triangles[:, ::-1]
        mesh = Mesh((1 + number) * TRIANGLE.points, triangles, None, np.roll(shades, number, 0))
        scene.instances[0].color, scene.instances[0].mesh = None, mesh
        head, arrays = unpacked(messages(stage, scene)[0])
        sent = head["meshes"][0]
        assert head["scene"] == 1 + number
        assert arrays[sent["triangles"]].tolist() == triangles[0].tolist()
        assert mesh.colors is not None
        np.testing.assert_array_equal(arrays[sent["colors"]], 255 * mesh.colors.ravel())


def test_another_color_is_another_scene() -> None:
    stage = Stage()
    messages(stage, moved_scene())
    scene = moved_scene()
    scene.instances[0].color = (0, 0, 1, 1)
    assert unpacked(messages(stage, scene)[0])[0]["scene"] == 2


def golden() -> list[bytes]:
    """The messages of tests/pictures/golden: a scene with parts of all kinds, and what follows when they move."""
    stage, sent = Stage(), []
    herd_items, rows = np.array([0]), np.arange(12.0).reshape(1, 3, 4)
    for number, shift in enumerate((0.0, 2.0)):
        scene = moved_scene(shift)
        scene.herds = [Herd(TRIANGLE, (0, 1, 1, 0.5), herd_items, rows + shift)]
        scene.value_name, scene.value_range = "Displacement, norm", (0.0, 0.5 + shift)
        sent.append(messages(stage, scene)[number])
    return sent


GOLDEN = [Path(__file__).parent / "golden" / name for name in ("scene.bin", "frame.bin", "turned.bin")]


def golden_turned(SC: Any, mbs: Any) -> bytes:
    """What follows when a body has turned about the z axis, by a rotation of whole units."""
    mbs.CreateRigidBody(inertia=InertiaCuboid(1, [1, 1, 1]), graphicsDataList=[graphics.Brick(color=[1, 0, 0, 1])])
    line = graphics.Lines([[0, 0, 0], [0, 1, 0]])
    mbs.CreateGround(referencePosition=[40, 0, 0], graphicsDataList=[line])  # so far away that the body is small
    mbs.Assemble()
    SC.visualizationSettings.nodes.show = False
    SC.visualizationSettings.general.drawWorldBasis = False
    return moved_frame(SC, mbs, [1, 2, -3, np.sqrt(0.8) - 1, 0, 0, np.sqrt(0.2)])


def moved_frame(SC: Any, mbs: Any, coordinates: Any) -> bytes:
    """The message of what has moved since the message of the whole scene."""
    flow, stage = Flow(SceneMaker(mbs, SC.visualizationSettings)), Stage()
    messages(stage, flow.scene())
    mbs.systemData.SetODE2Coordinates(coordinates, Shown)
    mbs.systemData.SetTime(0.25, Shown)
    found = stage.moved(flow)
    assert found is not None
    return b"".join(found.frame)


@pytest.mark.parametrize("distance", [1.0, 4000.0])
def test_points_of_turned_bodies_are_right_to_a_millionth_of_the_scene(SC: Any, mbs: Any, distance: float) -> None:
    """So are distances that are measured on a page: a body of 100 m, alone and far from another one."""
    size = [100, 1, 1]
    for x in (0, distance):
        mbs.CreateRigidBody(
            inertia=InertiaCuboid(1, size), referencePosition=[x, 0, 0], graphicsDataList=[graphics.Brick(size=size)]
        )
    mbs.Assemble()
    SC.visualizationSettings.nodes.show = False
    turn = Rotation.from_rotvec([0.3, -1.1, 0.7])
    x, y, z, w = turn.as_quat()
    head, arrays = unpacked(moved_frame(SC, mbs, [0, 0, 0, w - 1, x, y, z] + 7 * [0]))
    assert [entry[0] for entry in head["arrays"] if entry] == ["f4" if distance < 100 else "r6"]
    rows = np.reshape(arrays[0], (-1, 3, 4))[0]
    ends = np.array([[-50, 0, 0.5], [50, 0, 0.5]])
    seen = ends @ rows[:, :3].T + rows[:, 3]
    assert seen == pytest.approx(turn.apply(ends), abs=1e-6 * max(distance, 10))


def test_messages_are_those_that_pages_were_made_for(SC: Any, mbs: Any) -> None:
    """Bytes that are stored: who changes them changes what saved messages and other readers rely on."""
    assert [*golden(), golden_turned(SC, mbs)] == [path.read_bytes() for path in GOLDEN]


def test_stored_messages_say_what_was_written() -> None:
    (head, arrays), (after, moved), (quick, places) = (unpacked(path.read_bytes()) for path in GOLDEN)
    assert [kind for kind in quick["arrays"] if kind] == [["r6", 6]] and quick["time"] == 0.25
    assert places[0] == pytest.approx([0.6, -0.8, 0, 1, 0.8, 0.6, 0, 2, 0, 0, 1, -3])
    assert (head["kind"], after["kind"], after["scene"], after["time"]) == ("scene", "frame", head["scene"], 2.0)
    assert after["range"] == [0.0, 2.5]
    assert [mesh["items"] for mesh in head["meshes"]] == [[0], [0]]
    assert [mesh["color"] for mesh in head["meshes"]] == [[0, 1, 1, 0.5], [1, 0, 0, 1]]
    np.testing.assert_array_equal(arrays[0], np.arange(12))
    np.testing.assert_array_equal(moved[0], np.arange(2, 14))
    np.testing.assert_array_equal(moved[1], [1, 0, 0, 2, 0, 1, 0, 0, 0, 0, 1, 0])
    np.testing.assert_array_equal(moved[3], [0, 0, 0, 1, 1, 2])
    assert [moved[k] is None for k in (2, 4, 5)] == [True, True, True]  # the sphere, counts of points, the text


def test_a_page_sees_the_motion_while_it_is_computed(SC: Any, swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    assert {item[0] for item in head["items"]} >= {"Node", "Object", "Marker", "Load"}
    thread = solving(swinging)
    times = [reader.message("frame")[0]["time"] for _ in range(8)]
    assert times == sorted(times) and times[-1] > times[0]
    assert thread.is_alive() and SC.renderer.IsActive() and SC.renderer.GetRenderCount() >= 8
    reader.press("q")
    thread.join(10)
    assert not thread.is_alive()


def test_settings_that_change_back_before_the_next_look(
    SC: Any, viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A scene is drawn without bodies, which are hidden only as long as it is being drawn: the next one has them."""
    reader = Reader(viewer)
    reader.message("scene")
    assert viewer.studio is not None
    bodies, flow = SC.visualizationSettings.bodies, viewer.studio.flow
    drawn = []

    def hidden_meanwhile() -> Scene:
        if not drawn:
            bodies.show = False
        scene = flow()
        drawn.append(len(scene.instances) + len(scene.herds))
        return scene

    monkeypatch.setattr(viewer.studio, "flow", hidden_meanwhile)
    publish = viewer.server.publish

    def shown_again(picture: Picture) -> None:
        publish(picture)
        bodies.show = True

    monkeypatch.setattr(viewer.server, "publish", shown_again)
    SC.visualizationSettings.nodes.defaultSize = 0.3
    reader.until(lambda: len(drawn) > 1)
    assert drawn[0] < drawn[-1]


def test_traces_that_are_hidden_as_long_as_the_last_state_is_drawn(
    SC: Any, swinging: Any, viewer: Viewer, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Scenes that are moved draw traces anew, with settings of the moment: these may change back as soon as they are seen."""
    position, traces = exu.OutputVariableType.Position, SC.visualizationSettings.sensors.traces
    swinging.AddSensor(exu.itemInterface.SensorBody(bodyNumber=1, outputVariableType=position, storeInternal=True))
    swinging.Assemble()
    swinging.SolveDynamic(settings(100))
    traces.showPositionTrace = True
    reader, lines = Reader(viewer), []
    flow, publish = Studio.flow, viewer.server.publish

    def noted(self: Studio) -> Scene:
        if hidden := "hide" in lines:
            lines.remove("hide")
            traces.showPositionTrace = False
        scene = flow(self)
        lines.append("hidden" if hidden else len(scene.lines))
        return scene

    def shown_again(picture: Picture) -> None:
        publish(picture)
        traces.showPositionTrace = True

    monkeypatch.setattr(Studio, "flow", noted)
    monkeypatch.setattr(viewer.server, "publish", shown_again)
    viewer.redraw()
    reader.until(lambda: lines and not viewer._dirty)
    with_trace = lines[-1]
    lines.append("hide")
    swinging.SendRedrawSignal()
    reader.until(lambda: "hidden" in lines and lines[-1] == with_trace)


def test_a_viewer_changes_no_result(swinging: Any, viewer: Viewer) -> None:
    alone = copy.copy(swinging)
    alone.Assemble()
    alone.SolveDynamic(settings(20000))
    reader = Reader(viewer)
    reader.message("scene")
    thread = threading.Thread(target=lambda: swinging.SolveDynamic(settings(20000)))
    thread.start()
    while thread.is_alive():
        reader.until(lambda: True)
        time.sleep(0.005)
    np.testing.assert_array_equal(swinging.systemData.GetODE2Coordinates(), alone.systemData.GetODE2Coordinates())


def test_copies_take_little_of_the_time_of_the_solver(swinging: Any, viewer: Viewer) -> None:
    """By the solver's own clock: copies of states, which is all that happens in its thread, are rare enough."""
    reader = Reader(viewer)
    reader.message("scene")
    solver = exu.MainSolverImplicitSecondOrder()
    long = settings(200_000, 100.0)
    long.displayComputationTime = True
    thread = threading.Thread(target=lambda: solver.SolveSystem(swinging, long))
    thread.start()
    while thread.is_alive():
        reader.until(lambda: True)
        time.sleep(0.005)
    assert viewer.pictures > 1
    assert solver.timer.visualization < 0.01 * solver.timer.total


def test_tracks_become_thinner_and_not_longer() -> None:
    track = Track(2)
    for number in range(10 * LONGEST):
        track.add(np.array([number, -number], float))
        times, values = track.rows().T
        assert times[0] == 0 and times[-1] == number and len(times) <= LONGEST + 1
    np.testing.assert_array_equal(values, -times)
    np.testing.assert_array_equal(times[:-1], np.arange(0, number, 16))  # the least power of 2 that is not below 10
    assert len(times) > LONGEST / 2


def test_tracks_of_a_span_of_time_are_as_dense_as_they_were() -> None:
    track = Track(2)
    for number in range(3 * LONGEST):
        track.add(np.array([number, number], float), number - 1000)
        assert len(track.rows()) <= LONGEST + 1
    times = track.rows()[:, 0]
    np.testing.assert_array_equal(times[times >= 3 * LONGEST - 1001], np.arange(3 * LONGEST - 1001, 3 * LONGEST))


def test_sensors_leave_traces_while_it_is_solved(SC: Any, swinging: Any, viewer: Viewer) -> None:
    position = exu.OutputVariableType.Position
    swinging.AddSensor(exu.itemInterface.SensorBody(bodyNumber=1, outputVariableType=position, storeInternal=True))
    swinging.Assemble()
    SC.visualizationSettings.sensors.traces.showPositionTrace = True
    reader = Reader(viewer)
    thread = solving(swinging)
    while True:
        head, _ = reader.message("scene")
        if "Trace" in {head["items"][item][0] for item in head["lines"]["items"] if item >= 0}:
            break
    assert thread.is_alive()
    reader.press("q")
    thread.join(20)


def test_two_pages_and_one_that_does_not_answer(swinging: Any, viewer: Viewer) -> None:
    """Who does not tell that a frame was shown gets no other one; the others do not wait for it."""
    silent, reader = Reader(viewer), Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    for _ in range(5):
        reader.message("frame")
    late = Reader(viewer)
    head, _ = late.message("scene")
    assert head["time"] > 0  # it sees what is now
    binary = 0
    try:
        while True:
            binary += isinstance(silent.socket.recv(timeout=0.3), bytes)
    except TimeoutError:
        pass
    assert binary == 1
    silent.socket.close()
    late.press("q")
    thread.join(10)
    assert not thread.is_alive()


def test_the_solver_goes_on_without_its_page(swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    reader.message("frame")
    reader.socket.socket.close()  # killed, without a word
    again = Reader(viewer)
    first = again.message("scene")[0]["time"]
    assert again.message("frame")[0]["time"] > first and thread.is_alive()
    again.press("q")
    thread.join(10)


def test_a_page_that_was_hidden_sees_what_is_now(swinging: Any, viewer: Viewer) -> None:
    """Browsers draw nothing while a tab is hidden: it is silent then, and says that it has drawn when it is seen again."""
    hidden = Reader(viewer)
    while not isinstance(hidden.socket.recv(timeout=20), bytes):
        pass
    swinging.SolveDynamic(settings(1000))
    hidden.send("shown")
    assert hidden.picture()[0]["time"] == pytest.approx(1, rel=1e-9)  # the end, and nothing of what has passed


# ---- keys


def test_space_pauses_a_solver(swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    reader.message("frame")
    reader.press(" ")
    while reader.message("state")["text"] != "paused":
        pass
    shadow = viewer.shadows[0]
    reader.press("n")  # draws again
    time.sleep(0.3)
    now = shadow.system.systemData.GetTime(exu.ConfigurationType.Visualization)
    reader.press("n")
    time.sleep(0.3)
    assert shadow.system.systemData.GetTime(exu.ConfigurationType.Visualization) == now
    reader.press(" ")
    reader.until(lambda: shadow.system.systemData.GetTime(exu.ConfigurationType.Visualization) > now)
    reader.press("Escape")
    thread.join(10)
    assert not thread.is_alive() and viewer_of(viewer.container) is None


def test_space_pauses_no_solver_if_it_is_not_wanted(swinging: Any, viewer: Viewer) -> None:
    viewer.settings.interactive.advanced.pauseWithSpacebar = False
    reader = Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    reader.press(" ")
    reader.press("n")
    reader.until(lambda: not viewer.settings.nodes.show)  # keys are obeyed one after the other
    now = viewer.shadows[0].system.systemData.GetTime(exu.ConfigurationType.Visualization)
    reader.until(lambda: viewer.shadows[0].system.systemData.GetTime(exu.ConfigurationType.Visualization) > now + 0.01)
    reader.press("q")
    thread.join(10)
    assert not thread.is_alive()


def test_keys_show_and_hide(viewer: Viewer) -> None:
    reader = Reader(viewer)
    groups = {"n": "nodes", "c": "connectors", "b": "bodies", "m": "markers", "l": "loads", "s": "sensors"}
    for key, name in groups.items():
        group = getattr(viewer.settings, name)
        shown, numbers = group.show, group.showNumbers
        reader.press(key)
        reader.press(key, control=True)
        reader.until(lambda g=group, s=shown, n=numbers: (g.show, g.showNumbers) == (not s, not n))
    scene = viewer.settings.view0.scene
    seen = set()
    for _ in range(5):
        before = (scene.facesTransparent, scene.showFaceEdges, scene.showFaces)
        seen.add(before)
        reader.press("t")
        reader.until(lambda b=before: (scene.facesTransparent, scene.showFaceEdges, scene.showFaces) != b)
    assert len(seen) == 5
    reader.press("3")
    reader.until(lambda: viewer.settings.general.graphicsUpdateInterval == 0.5)


def test_idle_tasks_wait_for_space(SC: Any, swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    begin = time.monotonic()
    assert SC.renderer.DoIdleTasks(0.2) and 0.2 <= time.monotonic() - begin < 2
    for wait in (SC.renderer.DoIdleTasks, swinging.WaitForUserToContinue, SC.WaitForRenderEngineStopFlag):
        thread = threading.Thread(target=wait)
        thread.start()
        while "waits" not in reader.message("state")["text"]:
            pass
        assert thread.is_alive()
        reader.press(" ")
        thread.join(5)
        assert not thread.is_alive()


def test_idle_tasks_end_when_the_last_page_is_closed(SC: Any, viewer: Viewer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("dalembert._live.viewer.RETURN", 0.3)
    reader = Reader(viewer)
    reader.message("scene")
    assert SC.renderer.IsActive()
    reader.socket.close()
    assert SC.renderer.DoIdleTasks() is False
    assert not SC.renderer.IsActive()


def test_what_a_script_visualizes_is_seen(SC: Any, swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    whole, arrays = reader.message("scene")
    coordinates = swinging.systemData.GetODE2Coordinates()
    coordinates[0] = 5.0
    swinging.systemData.SetODE2Coordinates(coordinates, exu.ConfigurationType.Visualization)
    swinging.systemData.SetTime(3.0, exu.ConfigurationType.Visualization)
    SC.renderer.SendRedrawSignal()
    swinging.SendRedrawSignal()
    while reader.picture()[0]["time"] != 3.0:
        pass


def test_a_function_for_keys_may_change_the_system(swinging: Any, viewer: Viewer) -> None:
    """It is called once per key, in the thread of the solver, between two steps."""
    calls: list[tuple[int, int, int, int]] = []

    def pressed(key: int, action: int, mods: int) -> bool:
        calls.append((key, action, mods, threading.get_ident()))
        swinging.SetObjectParameter(2, "stiffness", 500.0)
        return True

    viewer.settings.interactive.keyPressUserFunction = pressed
    reader = Reader(viewer)
    reader.message("scene")
    reader.press("F2")
    reader.until(lambda: viewer.settings.interactive.ignoreKeys)
    thread = solving(swinging)
    reader.message("frame")
    reader.press("w", shift=True)
    reader.press("ArrowLeft")
    reader.until(lambda: len(calls) == 2)
    assert calls == [(ord("W"), 1, 1, thread.ident), (int(exu.KeyCode.LEFT), 1, 0, thread.ident)]
    assert swinging.GetObjectParameter(2, "stiffness") == 500.0
    reader.until(lambda: viewer.shadows[0].system.GetObjectParameter(2, "stiffness") == 500.0)
    reader.press("q")  # is ignored
    time.sleep(0.3)
    assert thread.is_alive()
    swinging.SetRenderEngineStopFlag(True)
    thread.join(10)


def test_an_error_of_the_user_is_shown_and_stops_nothing(swinging: Any, viewer: Viewer) -> None:
    def pressed(key: int, action: int, mods: int) -> bool:
        raise ZeroDivisionError("of the user")

    viewer.settings.interactive.keyPressUserFunction = pressed
    viewer.settings.interactive.ignoreKeys = True
    reader = Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    reader.press("x")
    assert reader.message("notice")["text"] == "ZeroDivisionError: of the user"
    assert thread.is_alive()
    swinging.SetRenderEngineStopFlag(True)
    thread.join(10)


# ---- views and selection


def test_views_go_both_ways(SC: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    SC.renderer.SetModelView(2.5, [0, 0, np.pi / 2], [1, 2, 3])
    while (camera := reader.message("camera")["camera"])["zoom"] != 2.5:
        pass
    np.testing.assert_allclose(np.reshape(camera["rotation"], (3, 3)), [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-12)
    assert camera["center"] == [1, 2, 3]
    reader.send("camera", rotation=np.eye(3).ravel().tolist(), center=[0, 0, 1], zoom=4.0)
    reader.until(lambda: SC.renderer.GetState()["zoom"] == 4.0)
    np.testing.assert_array_equal(SC.renderer.GetState()["modelRotation"], np.eye(3))
    reader.send("mouse", pixels=[10, 20], place=[0.5, -0.5])
    reader.until(lambda: SC.renderer.GetMouseCoordinates() == [10, 20])
    assert SC.renderer.GetMouseCoordinates(True) == [0.5, -0.5]


def test_selection(SC: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    assert SC.renderer.GetItemSelection() == (-1, -1, -1, 0.0)
    brick = next(n for n, item in enumerate(head["items"]) if item[3] == "brick")
    reader.send("select", item=brick, scene=head["scene"], depth=2.5)
    told = reader.message("details")
    assert told["title"] == "object 1"
    assert ["name", "brick"] in told["parameters"] and "VgraphicsData" not in dict(told["parameters"])
    assert dict(told["outputs"])["Position"].startswith("[1.")
    assert SC.renderer.GetItemSelection(False) == (0, int(exu.ItemType.Object), 1, 2.5)
    assert SC.renderer.GetItemSelection() == (0, int(exu.ItemType.Object), 1, 2.5)
    assert SC.renderer.GetItemSelection()[0] == -1
    viewer.settings.interactive.advanced.selectionRightMouseGraphicsData = True
    reader.send("select", item=brick, scene=head["scene"], depth=2.5)
    while "VgraphicsData" not in dict(reader.message("details")["parameters"]):
        pass
    viewer.settings.interactive.advanced.selectionLeftMouseItemTypes = 1
    reader.send("select", item=brick, scene=head["scene"], depth=2.5)
    reader.press("n")
    reader.until(lambda: not viewer.settings.nodes.show)
    assert SC.renderer.GetItemSelection()[0] == -1
    viewer.settings.interactive.advanced.selectionLeftMouseItemTypes = 31
    for wanted in (True, False):
        viewer.settings.interactive.advanced.selectionLeftMouse = wanted
        reader.send("select", item=brick, scene=head["scene"], depth=2.5)
        reader.press("n")
        reader.until(lambda wanted=wanted: viewer.settings.nodes.show == wanted)  # by then, it is selected or not
        assert (SC.renderer.GetItemSelection()[0] == 0) is wanted


def test_what_was_picked_in_a_scene_before_is_selected_if_it_is_still_there(SC: Any, viewer: Viewer) -> None:
    """A page may answer a scene that has been replaced meanwhile, whose numbers are others."""
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    names = [item[3] for item in head["items"]]
    node = next(n for n, item in enumerate(head["items"]) if item[0] == "Node")
    reader.press("n")
    later, _ = reader.message("scene")
    assert [item[3] for item in later["items"]] != names
    reader.send("select", item=names.index("brick"), scene=head["scene"], depth=2.5)
    assert reader.message("details")["title"] == "object 1"
    assert SC.renderer.GetItemSelection()[1:3] == (int(exu.ItemType.Object), 1)
    reader.send("select", item=node, scene=head["scene"], depth=2.5)
    reader.press("b")
    reader.until(lambda: not viewer.settings.bodies.show)
    assert SC.renderer.GetItemSelection()[0] == -1


def test_every_item_has_details(SC: Any, swinging: Any, viewer: Viewer) -> None:
    swinging.AddSensor(exu.itemInterface.SensorBody(bodyNumber=1, outputVariableType=exu.OutputVariableType.Position))
    swinging.Assemble()
    reader = Reader(viewer)
    head, _ = reader.message("scene")
    kinds = set()
    for number, item in enumerate(head["items"]):
        if item[0] != "Trace":
            reader.send("select", item=number, scene=head["scene"], depth=1.0)
            while (told := reader.message("details"))["title"] != f"{item[0].lower()} {item[1]}":
                pass
            assert len(told["parameters"]) > 2
            kinds.add(item[0])
    assert kinds == {"Node", "Object", "Marker", "Load", "Sensor"}


# ---- systems that change


def test_another_structure_is_another_scene(SC: Any, swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    before = len(reader.message("scene")[0]["items"])
    swinging.CreateMassPoint(referencePosition=[0, 1, 0], physicsMass=1)
    swinging.Assemble()
    assert len(reader.message("scene")[0]["items"]) > before
    other = SC.AddSystem()
    other.CreateMassPoint(referencePosition=[0, 2, 0], physicsMass=1)
    other.Assemble()
    assert {item[4] for item in reader.message("scene")[0]["items"]} == {0, 1}
    swinging.SetObjectParameter(1, "Vshow", False)
    while any(item[3] == "brick" for item in reader.picture()[0].get("items", [["", 0, "", "brick", 0]])):
        pass


def test_functions_that_draw_see_the_state_that_is_shown(SC: Any, viewer: Viewer, swinging: Any) -> None:
    seen: list[float] = []

    def drawn(mbs: Any, itemNumber: int) -> list[Any]:
        place = mbs.GetNodeOutput(0, exu.OutputVariableType.Position, exu.ConfigurationType.Visualization)
        seen.append(float(place[1]))
        return [graphics.Sphere(point=[0, 0, 0], radius=0.1)]

    swinging.AddObject(
        exu.itemInterface.ObjectGround(visualization=exu.itemInterface.VObjectGround(graphicsDataUserFunction=drawn))
    )
    swinging.Assemble()
    reader = Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    reader.until(lambda: min(seen, default=0.0) < -0.01)
    reader.press("q")
    thread.join(10)


def colors_of(scene: Any) -> list[list[float]]:
    return [mesh["color"][:3] for mesh in scene[0]["meshes"]]


def test_the_last_of_many_changes_of_an_item_is_shown(swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    for color in ([1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]):
        swinging.SetObjectParameter(1, "VgraphicsData", [graphics.Brick(size=[0.4, 0.2, 0.1], color=color)])
        while color[:3] == [1, 0, 0] and color[:3] not in colors_of(reader.message("scene")):
            pass
        time.sleep(0.1)
    while [0, 0, 1] not in colors_of(reader.message("scene")):
        pass


def test_bodies_without_colors_have_the_color_of_the_settings(swinging: Any, viewer: Viewer) -> None:
    brick = graphics.Brick(size=[0.4, 0.2, 0.1])
    del brick["colors"]
    swinging.SetObjectParameter(1, "VgraphicsData", [brick])
    reader = Reader(viewer)
    for color in ([0, 1, 1, 1], [1, 1, 0, 1]):
        viewer.settings.bodies.defaultColor = color
        while color[:3] not in colors_of(reader.message("scene")):
            pass


# ---- dialogs


def test_a_dialog_runs_a_simulation(SC: Any, swinging: Any, viewer: Viewer) -> None:
    sensor = swinging.AddSensor(
        exu.itemInterface.SensorNode(nodeNumber=0, outputVariableType=exu.OutputVariableType.Position)
    )
    swinging.Assemble()
    pressed, seen = [], []
    items = [
        {"type": "label", "text": "<b>a spring</b>", "grid": (0, 0, 2)},
        {"type": "button", "text": "count", "callFunction": lambda: pressed.append(1), "grid": (1, 0)},
        {"type": "radio", "textValueList": [("soft", 0), ("hard", 1)], "value": 0, "variable": "mode", "grid": [(2, 0), (2, 1)]},
        {"type": "slider", "range": (0, 100), "value": 10, "steps": 100, "variable": "stiffness", "grid": (3, 0)},
    ]  # fmt: skip
    plots = {"nPoints": 50, "sensors": [[(sensor, 0), (sensor, 2), "time", "height"]]}
    reader = Reader(viewer)
    reader.message("scene")

    def simulate(mbs: Any, dialog: Any) -> None:
        seen.append((mbs.variables["stiffness"], mbs.variables["mode"]))

    dialog = threading.Thread(
        target=lambda: exu.interactive.InteractiveDialog(
            swinging, settings(100), simulate, items, plots=plots, period=0.02, title="springs"
        )
    )
    dialog.start()
    told = reader.message("controls")
    assert told["title"] == "springs"
    assert [w["type"] for w in told["widgets"]] == ["button", "label", "button", "radio", "slider"]
    assert told["widgets"][4] | {"step": 1.0} == told["widgets"][4] and told["widgets"][4]["value"] == 10
    time.sleep(0.2)
    assert not seen  # nothing runs yet
    reader.send("control", name="stiffness", value=42.5)
    reader.send("control", name="mode", value=1)
    reader.send("control", name="nonsense", value=1)
    reader.send("control", name="1", pressed=True)
    reader.send("control", name="start or stop", pressed=True)
    (curve,) = reader.message("plots")["curves"]
    assert curve["title"] == "height over time" and len(curve["x"]) == len(curve["y"][0]) > 0
    assert seen[0] == (42.5, 1) and pressed == [1] and "nonsense" not in swinging.variables
    reader.press("q")
    while reader.message("controls").get("widgets"):
        pass
    dialog.join(10)
    assert not dialog.is_alive() and swinging.systemData.GetTime() > 0


# ---- where there is no page


def test_without_display_nothing_starts(SC: Any, swinging: Any) -> None:
    assert SC.renderer.Start() is False
    assert SC.renderer.IsActive() is False and SC.renderer.DoIdleTasks() is False
    SC.renderer.Stop()


def test_nothing_of_it_is_imported_before_start() -> None:
    code = "import sys, dalembert; print([m for m in sys.modules if m.startswith(('websockets', 'asyncio', 'dalembert._live'))])"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


STARTED = """
import time
import dalembert as exu
SC = exu.SystemContainer()
begin = time.process_time()
assert SC.renderer.Start()
print("took", time.process_time() - begin)
SC.renderer.Stop()
"""


def test_start_is_quick(tmp_path: Path) -> None:
    """The first time in a process, with all that it imports, as it is where the package is installed: its files are compiled."""
    settings = {
        **os.environ,
        "DALEMBERT_VIEWER": "on",
        "PYTHONPYCACHEPREFIX": str(tmp_path),
        "PYTHONDONTWRITEBYTECODE": "",
    }
    took = []
    for _ in range(3):
        done = subprocess.run([sys.executable, "-c", STARTED], env=settings, capture_output=True, text=True, check=True)
        took.append(float(done.stdout.rpartition("took ")[2]))
    assert min(took[1:]) < 0.3


def test_large_systems_are_copied_for_the_first_page(SC: Any, mbs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not before: the script that starts the viewer would wait."""
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    monkeypatch.setattr("dalembert._live.viewer.LARGE", 2)
    for _ in range(2):
        mbs.CreateMassPoint(physicsMass=1)
    mbs.Assemble()
    prepared = threading.Event()
    prepare = Viewer._prepare
    monkeypatch.setattr(Viewer, "_prepare", lambda viewer: (prepare(viewer), prepared.set()))
    SC.renderer.Start()
    viewer = viewer_of(SC)
    assert viewer is not None and prepared.wait(10) and not viewer.shadows
    head, _ = Reader(viewer).message("scene")
    assert sum(kind == "Node" for kind, *_ in head["items"]) == 2
    SC.renderer.Stop()


def test_the_port_can_be_chosen(SC: Any, mbs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    monkeypatch.setenv("DALEMBERT_VIEWER_PORT", str(port))
    SC.renderer.Start()
    found = viewer_of(SC)
    assert found is not None and found.server.port == port
    SC.renderer.Stop()
    monkeypatch.setenv("DALEMBERT_VIEWER_PORT", "many")
    with pytest.raises(ValueError, match="DALEMBERT_VIEWER_PORT: expected a number"):
        SC.renderer.Start()


def test_a_browser_is_not_told_the_token_by_its_arguments(SC: Any, mbs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """Arguments of programs are seen by all users of a machine."""
    opened: list[str] = []
    monkeypatch.setattr("dalembert._pictures.showing.has_display", lambda: True)
    monkeypatch.setattr("webbrowser.open", opened.append)
    monkeypatch.delenv("DALEMBERT_VIEWER", raising=False)
    SC.renderer.Start()
    found = viewer_of(SC)
    assert found is not None
    path = Path(opened[0].removeprefix("file://"))
    assert found.server.token not in opened[0] and found.server.token in path.read_text()
    assert path.parent.stat().st_mode & 0o077 == 0
    SC.renderer.Stop()


def test_the_address_is_printed_on_other_machines(
    SC: Any, mbs: Any, monkeypatch: pytest.MonkeyPatch, capfd: Any
) -> None:
    monkeypatch.setenv("DALEMBERT_VIEWER", "on")
    monkeypatch.setenv("SSH_CONNECTION", "10.0.0.1 5000 10.0.0.2 22")
    SC.renderer.Start()
    found = viewer_of(SC)
    assert found is not None
    port, told = found.server.port, capfd.readouterr().out
    assert f"http://127.0.0.1:{port}/#" in told and f"ssh -L {port}:127.0.0.1:{port} 10.0.0.2" in told
    SC.renderer.Stop()
