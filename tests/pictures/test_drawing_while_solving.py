"""A viewer's thread draws the state of a solver in another thread: results do not depend on it, and no memory is shared
unguarded.

The second part is seen by ThreadSanitizer: .ci/sanitize thread pytest tests/pictures/test_drawing_while_solving.py
"""

from __future__ import annotations

import threading
import time
from typing import Any

import numpy as np
import pytest
from test_items import READY, run
from test_meshes_in_frames import add_mesh_in_a_frame, spin

import dalembert as exu
from dalembert import _core
from dalembert._live.histories import LONGEST, History
from dalembert._pictures.studio import Studio
from dalembert.itemInterface import SensorNode

STEPS = 100  # with 130 items, some 10^4 of them


class Drawing:
    """Draws a system in a thread of its own, as viewers do: it uses a copy of the state."""

    def __init__(self, SC: Any, mbs: Any) -> None:
        self._shadow = _core._Shadow(mbs)
        self._shadow.follow()
        self._studio = Studio(SC, [self._shadow.system])
        self._ends, self.scenes, self.states = threading.Event(), 0, 0
        self.error: Exception | None = None
        self._thread = threading.Thread(target=self._draw)

    def __enter__(self) -> Drawing:
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ends.set()
        self._thread.join()

    def _draw(self) -> None:
        try:
            used = 0.0
            while not self._ends.wait(3 * used):  # a quarter of the time, as viewers do: others need the interpreter
                begin = time.monotonic()
                self.states += self._shadow.follow()[0]
                scene = self._studio.flow()
                if not self.scenes % 8:
                    self._studio.image(scene, self._studio.camera(scene), size=(64, 48))
                self.scenes += 1
                used = time.monotonic() - begin
        except Exception as error:
            self.error = error


def solved(SC: Any, mbs: Any, draws: bool) -> tuple[Any, int]:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = STEPS, 1e-4 * STEPS
    settings.timeIntegration.verboseMode = settings.staticSolver.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.adaptiveStep = False  # an unsolvable task ends soon
    mbs.Assemble()

    def solve() -> Any:
        try:
            mbs.SolveDynamic(settings)
        except (RuntimeError, ValueError) as error:
            return str(error)  # systems of some examples can only be solved statically
        return np.concatenate([np.atleast_1d(part) for part in mbs.systemData.GetSystemState()])

    if not draws:
        return solve(), 0
    with Drawing(SC, mbs) as drawing:
        result = solve()
    assert drawing.error is None, drawing.error
    return result, drawing.scenes


@pytest.mark.parametrize("item", READY, ids=lambda item: item.name)
def test_drawing_changes_no_result(item: Any) -> None:
    results = [solved(*run(item), draws=draws)[0] for draws in (False, True)]
    np.testing.assert_array_equal(*results)


def test_states_are_drawn_while_they_are_computed(SC: Any, mbs: Any) -> None:
    ground = mbs.CreateGround()
    for i in range(20):
        mass = mbs.CreateMassPoint(referencePosition=[i + 1, 0, 0], physicsMass=1, initialVelocity=[0, 1, 0])
        mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=100)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 5_000_000, 500
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    with Drawing(SC, mbs) as drawing:
        mbs.SetPreStepUserFunction(lambda mbs, t: drawing.states <= 2)  # it ends as soon as they are
        mbs.SolveDynamic(settings)
    assert drawing.error is None and drawing.states > 2


def share_of_copies(count: int, wanted: int) -> float:
    """Part of the solver's time, by its own counter, that copies take for somebody who asks again at once, until so many were made."""
    mbs = exu.SystemContainer().AddSystem()
    for i in range(count):
        mbs.CreateMassPoint(referencePosition=[i % 100, i // 100 % 100, i // 10000], physicsMass=1)
    mbs.Assemble()
    shadow, ends, states = _core._Shadow(mbs), threading.Event(), 0
    shadow.follow()

    def look() -> None:
        nonlocal states
        while not ends.wait(0.001):
            states += bool(shadow.follow()[0])

    settings = exu.SimulationSettings()
    settings.displayComputationTime = True
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 10**9, 1e6
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.explicitIntegration.dynamicSolverType = exu.DynamicSolverType.ExplicitMidpoint
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SetPreStepUserFunction(lambda mbs, t: states < wanted)
    solver, thread = exu.MainSolverExplicit(), threading.Thread(target=look)
    thread.start()
    try:
        solver.SolveSystem(mbs, settings)
    finally:
        ends.set()
        thread.join()
    assert states >= wanted
    return float(solver.timer.visualization / solver.timer.total)


@pytest.mark.parametrize("count", [10, 1000, 100_000])
def test_copies_take_less_than_a_hundredth_however_many_bodies_there_are(count: int) -> None:
    """A copy of 100 000 masses takes a half of a millisecond: they are made so seldom that this does not count.

    A copy that the machine interrupts may take longer in one of three solutions, not in all.
    """
    shares = (share_of_copies(count, 40) for _ in range(3))
    assert any(share < 0.01 for share in shares)


def test_positions_without_other_outputs_are_reported(mbs: Any) -> None:
    """A mass that falls: its velocity follows from its place. A request for a single item has no velocity, with a
    message."""
    mass = mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, -2])
    mbs.Assemble()
    shadow, seen = _core._Shadow(mbs), []
    Shown = exu.ConfigurationType.Visualization

    def look(original: Any, t: float) -> bool:
        asks_for_places = t < 0.5
        if shadow.follow(asks_for_places)[0]:
            data = shadow.system.systemData
            q, v = (data.GetODE2Coordinates(Shown)[2], data.GetODE2Coordinates_t(Shown)[2])
            seen.append((t, shadow.complete, q, v))
        return True

    shadow.follow()
    mbs.SetPreStepUserFunction(look)
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 100_000, 1
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings)
    parts = [row for row in seen if not row[1]]
    whole = [row for row in seen if row[1] and row[0] > 0.5]
    assert len(parts) > 2 and len(whole) > 2
    assert all(q < 0 and v == 0 for _, _, q, v in parts)
    assert [v for *_, v in whole] == pytest.approx([-2 * np.sqrt(-q) for _, _, q, _ in whole], rel=1e-9)
    shadow.follow(places=True)
    assert shadow.complete  # no solver is at work
    assert shadow.system.GetObjectOutput(mass, exu.OutputVariableType.Velocity, Shown)[2] == pytest.approx(-2, rel=1e-9)


def test_traces_pass_all_shown_positions(mbs: Any) -> None:
    """A mass that falls is at -t**2 in all states that were seen; stored values of the sensor remain afterwards."""
    mass = mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, -2])
    sensor = mbs.AddSensor(
        exu.itemInterface.SensorBody(
            bodyNumber=mass, outputVariableType=exu.OutputVariableType.Position, storeInternal=True, writeToFile=False
        )
    )
    silent = mbs.AddSensor(
        exu.itemInterface.SensorBody(
            bodyNumber=mass, outputVariableType=exu.OutputVariableType.Position, writeToFile=False
        )
    )
    mbs.Assemble()
    shadow = _core._Shadow(mbs)
    history, seen = History(mbs, shadow, exu.VisualizationSettings()), []
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 4000, 1
    assert LONGEST >= 4000  # no state is dropped, however many are seen
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 0.1

    def look(original: Any, t: float) -> bool:
        if shadow.follow()[0]:
            seen.append(history.rows(sensor)[0])
            with pytest.raises(ValueError, match="stores nothing"):
                history.rows(silent)
        return True

    shadow.follow()
    mbs.SetPreStepUserFunction(look)
    for _ in range(2):
        seen.clear()
        mbs.SolveDynamic(settings)
        rows = seen[-1]
        assert len(rows) == len(seen) > 3 and (np.diff(rows[:, 0]) > 0).all()
        np.testing.assert_allclose(rows[:, 3], -(rows[:, 0] ** 2), rtol=1e-9, atol=1e-12)
        shadow.follow()
        stored = history.rows(sensor)[0]
        np.testing.assert_array_equal(stored, mbs.GetSensorStoredData(sensor))
        np.testing.assert_allclose(stored[:, 0], np.linspace(0, 1, 11), atol=1e-4)


def test_traces_of_nodes_in_a_frame_have_the_frames_of_their_time(mbs: Any) -> None:
    """While a solver works, as afterwards: values of a mesh node are in the frame of its body, which turns."""
    body, mesh = add_mesh_in_a_frame(mbs)
    spin(mbs, mesh)
    position = exu.OutputVariableType.Position
    sensor = mbs.AddSensor(SensorNode(nodeNumber=mesh[0], outputVariableType=position, storeInternal=True))
    mbs.Assemble()
    shadow = _core._Shadow(mbs)
    history, seen, places = History(mbs, shadow, exu.VisualizationSettings()), [], []
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 5000, 0.3
    settings.solutionSettings.writeSolutionToFile = False

    def look(original: Any, t: float) -> bool:
        if shadow.follow()[0]:
            seen.append(history.rows(sensor))
            shown = exu.ConfigurationType.Visualization
            places.append(shadow.system.GetObjectOutputSuperElement(body, position, 0, shown))
        return True

    shadow.follow()
    mbs.SetPreStepUserFunction(look)
    mbs.SolveDynamic(settings)
    for rows, frames in (seen[-1], history.rows(sensor)):
        assert rows.shape[1] == 4 and frames is not None and len(rows) == len(frames) > 3
    assert np.ptp(np.array(places), axis=0).max() > 1
    rows, frames = seen[-1]
    in_space = np.einsum("nij,nj->ni", frames[:, 3:].reshape(-1, 3, 3), rows[:, 1:]) + frames[:, :3]
    np.testing.assert_allclose(in_space, places, atol=1e-12)
