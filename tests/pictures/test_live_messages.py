"""Messages to live pages while a solver runs, without a browser."""

from __future__ import annotations

import copy
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from page_reader import Reader, settings, solving, unpacked
from scipy.spatial.transform import Rotation

import dalembert as exu
from dalembert import graphics
from dalembert._live import messages as sending
from dalembert._live.histories import LONGEST, Track
from dalembert._live.messages import Picture, Stage
from dalembert._live.viewer import Viewer
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


def test_frames_contain_moved_items() -> None:
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


def test_new_lines_are_searched_once_and_only_for_pages_with_the_scene(
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


def test_items_with_changing_shape_become_deformable() -> None:
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


def test_changes_other_than_of_points_make_a_new_scene() -> None:
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
    """The messages of tests/pictures/golden: a scene with all kinds of parts, and messages of their motion."""
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
    """Message after a rotation of a body about the z axis, with integer units."""
    mbs.CreateRigidBody(inertia=InertiaCuboid(1, [1, 1, 1]), graphicsDataList=[graphics.Brick(color=[1, 0, 0, 1])])
    line = graphics.Lines([[0, 0, 0], [0, 1, 0]])
    mbs.CreateGround(referencePosition=[40, 0, 0], graphicsDataList=[line])  # the body is small at this distance
    mbs.Assemble()
    SC.visualizationSettings.nodes.show = False
    SC.visualizationSettings.general.drawWorldBasis = False
    return moved_frame(SC, mbs, [1, 2, -3, np.sqrt(0.8) - 1, 0, 0, np.sqrt(0.2)])


def moved_frame(SC: Any, mbs: Any, coordinates: Any) -> bytes:
    """The message of motions since the message of the whole scene."""
    flow, stage = Flow(SceneMaker(mbs, SC.visualizationSettings)), Stage()
    messages(stage, flow.scene())
    mbs.systemData.SetODE2Coordinates(coordinates, Shown)
    mbs.systemData.SetTime(0.25, Shown)
    found = stage.moved(flow)
    assert found is not None
    return b"".join(found.frame)


@pytest.mark.parametrize("distance", [1.0, 4000.0])
def test_points_of_turned_bodies_are_right_to_a_millionth_of_the_scene(SC: Any, mbs: Any, distance: float) -> None:
    """Distances measured on a page are the same: a body of 100 m, alone and far from another one."""
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
    """Bytes that are stored: changing them breaks saved messages and other readers."""
    assert [*golden(), golden_turned(SC, mbs)] == [path.read_bytes() for path in GOLDEN]


def test_stored_messages_are_the_written_ones() -> None:
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
    """Times of the solver's clock: copies of states, which is all that happens in its thread, are rare enough."""
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
    """A page that does not confirm a frame gets no other one; the others do not wait for it."""
    silent, reader = Reader(viewer), Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    for _ in range(5):
        reader.message("frame")
    late = Reader(viewer)
    head, _ = late.message("scene")
    assert head["time"] > 0  # it gets the present state
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


def test_a_page_that_was_hidden_gets_the_present_state(swinging: Any, viewer: Viewer) -> None:
    """Browsers draw nothing while a tab is hidden: it is silent then, and says that it has drawn when it is seen again."""
    hidden = Reader(viewer)
    while not isinstance(hidden.socket.recv(timeout=20), bytes):
        pass
    swinging.SolveDynamic(settings(1000))
    hidden.send("shown")
    assert hidden.picture()[0]["time"] == pytest.approx(1, rel=1e-9)  # it gets the end, without earlier states
