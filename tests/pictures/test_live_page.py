"""The live page without a browser: keys and choices, dialogs, changing systems, and systems without a page."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from page_reader import Reader, settings, solving

import dalembert as exu
from dalembert import graphics
from dalembert._live.viewer import Viewer, viewer_of

Shown = exu.ConfigurationType.Visualization
FOLDER = Path(exu.__file__).resolve().parent / "_pictures/page"


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
    reader.press("r")
    reader.until(lambda: viewer.settings.nodes.showBasis)
    reader.press("j")
    reader.until(lambda: viewer.settings.connectors.showJointAxes)
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


def test_a_state_visualized_by_a_script_is_drawn(SC: Any, swinging: Any, viewer: Viewer) -> None:
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
        reader.until(lambda wanted=wanted: viewer.settings.nodes.show == wanted)  # it is selected at this time or not
        assert (SC.renderer.GetItemSelection()[0] == 0) is wanted


def test_a_picked_item_stays_selected_in_a_new_scene(SC: Any, viewer: Viewer) -> None:
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


# ---- without a page


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


def test_the_token_is_not_in_the_arguments_of_a_browser(SC: Any, mbs: Any, monkeypatch: pytest.MonkeyPatch) -> None:
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
