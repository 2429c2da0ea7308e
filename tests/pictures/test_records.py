"""Recorded states: the time slider of the viewer."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from page_reader import Reader, settings, solving

import dalembert as exu
from dalembert import _core
from dalembert._live.records import PARTS, Past, Plots, Record
from dalembert._live.viewer import Viewer
from dalembert._pictures.contour import Contour
from dalembert._pictures.looks import Looks
from dalembert.laws import connector

Shown = exu.ConfigurationType.Visualization


def state(mbs: Any) -> list[Any]:
    return [getattr(mbs.systemData, f"Get{name}")(Shown) for name in PARTS]


def solved(mbs: Any, shadow: Any, record: Record, ends: list[float]) -> list[list[Any]]:
    """States of solutions that end at these times, as they were recorded."""
    states = []
    for number, end in enumerate(ends):
        mbs.SolveDynamic(settings(20, end))
        assert shadow.follow()[0]
        record.add(float(number))
        states.append(state(shadow.system))
    return states


def test_a_recorded_state_is_shown_bit_for_bit(swinging: Any) -> None:
    """Coordinates, velocities, accelerations, multipliers and data are those that were recorded."""
    swinging.CreateSphericalJoint(bodyNumbers=[0, 1], position=[1, 0.1, 0])
    swinging.Assemble()
    shadow = _core._Shadow(swinging)
    shadow.follow()
    record = Record(shadow.system)
    states = solved(swinging, shadow, record, [0.1, 0.2, 0.3])
    assert record.times.tolist() == pytest.approx([0.1, 0.2, 0.3], abs=1e-14)
    for wanted, step, number in ((0.14, 0, 0), (0.16, 0, 1), (0.2, 1, 2), (0.2, -5, 0), (9.0, 0, 2)):
        assert record.show(wanted, step) == shadow.system.systemData.GetTime(Shown) == record.times[number]
        for part, expected in zip(state(shadow.system), states[number], strict=True):
            np.testing.assert_array_equal(part, expected)
    assert any(len(part) for part in states[0][5:6])  # multipliers


def test_an_earlier_time_begins_another_record(swinging: Any) -> None:
    shadow = _core._Shadow(swinging)
    shadow.follow()
    record = Record(shadow.system)
    solved(swinging, shadow, record, [0.2, 0.3])
    swinging.SolveDynamic(settings(20, 0.1))
    shadow.follow()
    assert record.add(9.0) and record.times.tolist() == pytest.approx([0.1], abs=1e-14)
    assert not record.add(9.0) and len(record.times) == 1  # the same time: the state is replaced


def test_a_function_is_evaluated_in_all_states_and_the_present_one_comes_back(swinging: Any) -> None:
    shadow = _core._Shadow(swinging)
    shadow.follow()
    record = Record(shadow.system)
    states = solved(swinging, shadow, record, [0.1, 0.2, 0.3])
    record.show(0.1)
    found = record.evaluated(lambda: shadow.system.systemData.GetODE2Coordinates(Shown).copy())
    for (time, values), recorded, expected in zip(found, record.times, states, strict=True):
        assert time == recorded
        np.testing.assert_array_equal(values, expected[0])
    assert shadow.system.systemData.GetTime(Shown) == record.times[0]


def test_large_systems_are_recorded_less_often_and_thinned(monkeypatch: pytest.MonkeyPatch, swinging: Any) -> None:
    monkeypatch.setattr("dalembert._live.records.ROOM", 8000.0)
    monkeypatch.setattr("dalembert._live.records.RATE", 1000.0)
    shadow = _core._Shadow(swinging)
    shadow.follow()
    record = Record(shadow.system)
    size = 8 * (2 + sum(map(len, state(shadow.system))))
    record.add(1.0)
    assert not record.is_due(1.0 + 0.9 * size / 1000) and record.is_due(1.0 + 1.1 * size / 1000)
    for time in np.arange(1, 200):
        shadow.system.systemData.SetTime(float(time), Shown)
        record.add(1.0)
    assert len(record.times) * size <= 8000 + size and record.times[-1] == 199
    spacing = np.diff(record.times[:-1])
    assert record.times[0] == 0 and (spacing == spacing[0]).all() and spacing[0] > 1


def test_the_replay_ends_at_the_present_state(monkeypatch: pytest.MonkeyPatch, swinging: Any) -> None:
    shadow, past = _core._Shadow(swinging), Past()
    shadow.follow()
    past.begin([shadow])
    for end in (0.1, 0.2, 0.3):
        swinging.SolveDynamic(settings(20, end))
        shadow.follow()
        past.take([True])
    clock = [100.0]
    monkeypatch.setattr("dalembert._live.records.time.monotonic", lambda: clock[0])
    past.seek(0.0, plays=True, speed=0.5)
    shown = []
    for _ in range(3):
        clock[0] += 0.22
        assert past.take([False])
        shown.append(shadow.system.systemData.GetTime(Shown))
    assert shown == pytest.approx([0.1, 0.2, 0.3], abs=1e-14)
    words = past.words()
    assert (words["count"], words["back"], words["plays"]) == (4, False, False)
    assert not past.take([False])


def test_readers_look_back_while_a_solver_pauses(swinging: Any, viewer: Viewer) -> None:
    reader = Reader(viewer)
    reader.message("scene")
    thread = solving(swinging)
    for _ in range(8):
        reader.message("frame")
    reader.press(" ")
    while reader.message("state")["text"] != "paused":
        pass
    while (told := reader.message("times"))["count"] < 5:
        pass
    system = viewer.shadows[0].system

    def time_after(**wanted: Any) -> float:
        before = system.systemData.GetTime(Shown)
        reader.send("seek", **wanted)
        while (now := float(reader.picture()[0]["time"])) == before:
            pass
        return now

    assert time_after(time=0.0) == told["first"] == 0.0
    assert viewer.past.words()["back"]
    assert 0.0 < time_after(time=0.0, step=1) < told["last"]
    place = system.GetNodeOutput(0, exu.OutputVariableType.Position, Shown)
    assert time_after(time=None) >= told["last"]
    assert not np.array_equal(place, system.GetNodeOutput(0, exu.OutputVariableType.Position, Shown))
    reader.send("seek", time="soon")
    assert "seek: could not convert" in reader.message("notice")["text"]
    reader.send("seek", time=0.0, speed=0)
    assert reader.message("notice")["text"] == "seek: expected finite numbers, and a positive speed"
    reader.send("seek", time=0.0)
    reader.press(" ")  # the solver goes on, and the view stays where it is
    last = viewer.past.words()["last"]
    reader.until(lambda: viewer.past.words()["last"] > last)
    assert system.systemData.GetTime(Shown) == 0.0
    swinging.SetRenderEngineStopFlag(True)
    thread.join(10)
    reader.until(lambda: viewer.past.words()["last"] == pytest.approx(swinging.systemData.GetTime(), abs=1e-12))
    assert system.systemData.GetTime(Shown) == 0.0


def test_an_output_is_plotted_over_all_recorded_states(swinging: Any) -> None:
    """Also over states from before it was chosen; it goes on with new ones, and begins anew with another solution."""
    shadow, past, plots = _core._Shadow(swinging), Past(), Plots()
    shadow.follow()
    past.begin([shadow])

    def solve(end: float) -> float:
        swinging.SolveDynamic(settings(20, end))
        shadow.follow()
        past.take([True])
        return float(swinging.GetNodeOutput(0, exu.OutputVariableType.Position)[1])

    heights = [0.0, *map(solve, (0.1, 0.2))]
    plots.choose(0, "Node", 0, "Position")
    plots.choose(0, "Node", 0, "Position")  # once
    (plot,) = plots.renewed([shadow], past) or []
    assert plot["title"] == "node 0 'brick': Position (m)" or plot["title"].endswith(": Position (m)")
    assert [curve["name"] for curve in plot["curves"]] == ["X", "Y", "Z"]
    assert plot["curves"][1]["x"] == pytest.approx([0, 0.1, 0.2], abs=1e-14)
    assert plot["curves"][1]["y"] == heights
    assert plots.renewed([shadow], past) is None
    heights.append(solve(0.3))
    past.seek(0.0)
    (plot,) = plots.renewed([shadow], past) or []
    assert plot["curves"][1]["y"] == heights and shadow.system.systemData.GetTime(Shown) == 0.0
    lower = solve(0.05)
    (plot,) = plots.renewed([shadow], past) or []
    assert plot["curves"][1]["y"] == [lower]
    plots.choose(0, "Object", 1, "KineticEnergy")
    assert [p["title"] for p in plots.renewed([shadow], past) or []][1] == "object 1 'brick': KineticEnergy (J)"
    plots.drop(0)
    assert [p["curves"][0]["name"] for p in plots.renewed([shadow], past) or []] == [""]
    plots.drop()
    assert plots.renewed([shadow], past) == []


def test_panels_have_units_and_plots(SC: Any, swinging: Any, viewer: Viewer) -> None:
    sensor = swinging.AddSensor(exu.SensorBody(bodyNumber=1, outputVariableType=exu.OutputVariableType.Velocity))
    swinging.Assemble()
    reader = Reader(viewer)
    head = reader.message("scene")[0]
    while all(item[0] != "Sensor" for item in head["items"]):
        head = reader.message("scene")[0]

    def select(kind: str, number: int) -> Any:
        names = [(item[0], item[1]) for item in head["items"]]
        reader.send("select", item=names.index((kind, number)), scene=head["scene"], depth=1.0)
        while (told := reader.message("details"))["title"] != f"{kind.lower()} {number}":
            pass
        return told

    units = select("Object", 1)["units"]
    assert (units["parameters"]["physicsMass"], units["outputs"]["Velocity"]) == ("kg", "m/s")
    assert select("Object", 2)["units"]["outputs"]["WrenchOnMarker0"] == "N, Nm"
    assert select("Sensor", int(sensor))["units"]["outputs"] == {"values": "m/s"}
    reader.send("plot", name="values")
    curves = reader.message("outputs")["curves"]
    assert curves[0]["title"] == "sensor 0 'sensor0' (m/s)" and curves[0]["xLabel"] == "t (s)"
    reader.send("plot", name="Mass")  # none of its outputs
    later = Reader(viewer)  # another page
    assert later.message("outputs")["curves"] == curves
    select("Object", 1)
    reader.send("plot", name="Nothing")
    assert reader.message("notice")["text"] == "plot: 'Nothing'"
    reader.send("plot", drop=None)
    assert reader.message("outputs")["curves"] == []


def test_the_bar_of_colors_has_a_unit(swinging: Any) -> None:
    swinging.GetSystemContainer().visualizationSettings.contour.outputVariable = exu.OutputVariableType.Velocity
    assert Contour(Looks(swinging.GetSystemContainer().visualizationSettings)).name == "Velocity, component 0 (m/s)"


def test_pages_change_numbers_of_items_between_two_steps(swinging: Any, viewer: Viewer) -> None:
    @connector("line")
    def law(L: Any, L_t: Any, t: Any, k: float = 3.0) -> Any:
        return k * L

    sprung = law(swinging.GetObject(2)["markerNumbers"])
    number = int(swinging.AddObject(sprung))
    swinging.Assemble()
    reader = Reader(viewer)
    head = reader.message("scene")[0]
    while ("Object", number) not in [(item[0], item[1]) for item in head["items"]]:
        head = reader.message("scene")[0]
    picked = [(item[0], item[1]) for item in head["items"]].index(("Object", number))
    reader.send("select", item=picked, scene=head["scene"], depth=1.0)
    told = reader.message("details")
    assert told["item"] == [0, "Object", number] and told["numbers"]["springForceUserFunction.k"] == 3.0
    assert "markerNumbers" not in told["numbers"] and "name" not in told["numbers"]
    thread = solving(swinging)
    reader.message("frame")

    def change(item: str, number: int, name: str, value: Any) -> None:
        reader.send("parameter", system=0, item=item, number=number, name=name, value=value)

    change("Object", 2, "stiffness", 500.0)
    change("Object", number, "springForceUserFunction.k", 4.0)
    reader.until(lambda: not viewer._changes)
    reader.until(lambda: swinging.GetObjectParameter(2, "stiffness") == 500.0)
    reader.until(lambda: swinging.GetObjectParameter(number, "springForceUserFunction.k") == 4.0)
    for item, name, value in (
        ("Object", "markerNumbers", 1.0),
        ("Item", "stiffness", 1.0),
        ("Object", "stiffness", "inf"),
    ):
        change(item, 2, name, value)
        text = f"parameter: {item} 2 has no number '{name}' that pages can change to {float(value)}"
        assert reader.message("notice")["text"] == text
    swinging.SetRenderEngineStopFlag(True)
    thread.join(10)
    change("Object", 2, "damping", 2.0)  # waits for the next solver, or until the script waits
    reader.until(lambda: bool(viewer._changes))
    viewer.idle(0.2, False)
    assert swinging.GetObjectParameter(2, "damping") == 2.0
