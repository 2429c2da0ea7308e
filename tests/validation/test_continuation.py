"""Solutions that go on from a restart file: the same bytes as if they had not been stopped."""

from __future__ import annotations

import contextlib
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from solving import Solver, new_system, settings
from test_andrews import Squeezer
from test_bricard import Bricard
from test_four_bar import Bars
from test_joints_apart import OF_POSITIONS
from test_redundant import Door

import dalembert as exu
from dalembert import itemInterface as eii

NAME = "restart.txt"


@pytest.fixture(autouse=True)
def in_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


# ---- models: each has a sensor with a file ------------------------------------------------------------------------------


INTERRUPTED_AT = [np.inf]  # s


@contextlib.contextmanager
def ctrl_c_at(time: float) -> Iterator[None]:
    INTERRUPTED_AT[0] = time
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # processes in the background ignore it
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        INTERRUPTED_AT[0] = np.inf


def watch(mbs: Any, t: float, sensors: Any, factors: Any, configuration: Any) -> list[float]:
    """A sensor has no part in the steps, as functions of the user would have: Ctrl-C comes while it is asked."""
    if t >= INTERRUPTED_AT[0]:
        signal.raise_signal(signal.SIGINT)
    return [t]


def watched(mbs: Any, node: int = 0) -> Any:
    variable = exu.OutputVariableType.Coordinates
    sensor = mbs.AddSensor(eii.SensorNode(nodeNumber=node, fileName="sensor.txt", outputVariableType=variable))
    mbs.AddSensor(eii.SensorUserFunction(sensorNumbers=[sensor], sensorUserFunction=watch, storeInternal=True))
    mbs.Assemble()
    return mbs


def bricard() -> Any:
    """A model with a redundant equation."""
    return watched(Bricard({}).mbs)


def misplaced() -> Any:
    """Two hinges that do not quite fit."""
    return watched(Door(misplaced=1e-6).mbs)


def squeezer() -> Any:
    return watched(Squeezer().mbs)


def flat() -> Any:
    """Starts in a singular position, and passes it again."""
    return watched(Bars(2, angle=0, rate=-3).mbs, 1)


def slow() -> Any:
    """Still in a singular position, to round-off, when the restart file is written."""
    return watched(Bars(2, angle=0, rate=-0.1).mbs, 1)


def passing() -> Any:
    """Passes it after 0.7 s, behind the restart file."""
    return watched(Bars(2).mbs, 1)


def sliding() -> Any:
    """A mass that sticks and slips on a spring, driven by a load, and a first-order equation: data, ODE1 coordinates, steps that fail."""
    mbs = new_system()
    node = mbs.AddNode(eii.Node1D(referenceCoordinates=[0], initialVelocities=[1]))
    mbs.AddObject(eii.Mass1D(nodeNumber=node, physicsMass=1))
    markers = [
        mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=n, coordinate=0))
        for n in (mbs.AddNode(eii.NodePointGround()), node)
    ]
    history = mbs.AddNode(eii.NodeGenericData(initialCoordinates=[1, 0, 0], numberOfDataCoordinates=3))
    mbs.AddObject(
        eii.ObjectConnectorCoordinateSpringDamperExt(
            markerNumbers=markers, nodeNumber=history, stiffness=40, fDynamicFriction=2, stickingStiffness=1e4
        )
    )
    first = mbs.AddNode(
        eii.NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[1, 0], numberOfODE1Coordinates=2)
    )
    mbs.AddObject(eii.ObjectGenericODE1(nodeNumbers=[first], systemMatrix=[[-1, 4], [-4, -1]]))
    mbs.AddLoad(
        eii.LoadCoordinate(
            markerNumber=markers[1], load=3, loadUserFunction=lambda mbs, t, load: load * float(np.sin(7 * t))
        )
    )
    return watched(mbs, int(node))


def spring(damping: float = 0.3) -> Any:
    mbs = new_system()
    node = mbs.AddNode(eii.Node1D(referenceCoordinates=[0], initialVelocities=[1]))
    mbs.AddObject(eii.Mass1D(nodeNumber=node, physicsMass=1.7))
    markers = [
        mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=n, coordinate=0))
        for n in (mbs.AddNode(eii.NodePointGround()), node)
    ]
    mbs.AddObject(
        eii.ObjectConnectorCoordinateSpringDamper(markerNumbers=markers, stiffness=77, damping=damping, offset=0.1)
    )
    return watched(mbs, int(node))


def bouncing() -> Any:
    """Contact that opens and closes, with a damper: forces jump."""
    mbs = new_system()
    ball = mbs.CreateMassPoint(referencePosition=[0, 0, 0.3], physicsMass=1, gravity=[0, 0, -9.81])
    mbs.CreateSphereSphereContact(
        bodyNumbers=[mbs.CreateGround(referencePosition=[0, 0, -0.2]), ball],
        spheresRadii=[0.1, 0.1],
        contactStiffness=1e4,
        contactDamping=10,
        dataInitialCoordinates=[0.3, 0, 0, 0],
    )
    return watched(mbs)


def gathering() -> Any:
    """Balls that fly together and apart again, and a pendulum on a joint: the pattern of the system matrix grows on the
    way."""
    mbs = new_system()
    ground = mbs.CreateGround()
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings(np.zeros((1, 1)))
    for angle in np.arange(8) * np.pi / 4 + 0.1:
        out = np.array([np.cos(angle), np.sin(angle), 0.01 * angle])
        ball = mbs.CreateMassPoint(referencePosition=2 * out, initialVelocity=-4 * out, physicsMass=1)
        marker = mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=ball))
        contact.AddSphereWithMarker(marker, radius=0.2, contactStiffness=1e4, contactDamping=1, frictionMaterialIndex=0)
    bob = mbs.CreateRigidBody(
        referencePosition=[5, 0, 0], inertia=exu.utilities.InertiaCuboid(1000, [0.1, 0.1, 0.1]), gravity=[0, -9.81, 0]
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, bob], position=[4.5, 0, 0], axis=[0, 0, 1])
    return watched(mbs, 1)


def throwing() -> Any:
    """An event function of the user, whose action changes velocities."""
    mbs = spring()

    def back(mbs: Any, t: float, event: int, direction: int) -> bool:
        speed = -0.9 * mbs.systemData.GetODE2Coordinates_t()
        mbs.systemData.SetODE2Coordinates_t(speed, configuration=exu.ConfigurationType.Current)
        return True

    mbs.SetEventsUserFunction(lambda mbs, t: [(mbs.systemData.GetODE2Coordinates()[0] - 0.05, 1)])
    mbs.SetEventActionUserFunction(back)
    return mbs


def top() -> Any:
    """A rotation vector that is composed on the group."""
    mbs = new_system()
    mbs.CreateRigidBody(
        inertia=exu.utilities.InertiaCuboid(1000, [1, 0.1, 0.2]),
        initialAngularVelocity=[0.2, 2, 5],
        gravity=[0, 0, -9.81],
        nodeType=exu.NodeType.RotationRotationVector,
    )
    return watched(mbs)


def by_tolerances(s: Any) -> None:
    s.stepSizeControl.implicitSolvers = True
    s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = 1e-5
    s.timeIntegration.initialStepSize = 1e-5


def modified(s: Any) -> None:
    s.timeIntegration.newton.useModifiedNewton = True


def dense_output(s: Any) -> None:
    s.denseOutput.atRequestedTimes = True
    s.solutionSettings.solutionWritePeriod = 0.0007
    s.solutionSettings.sensorsWritePeriod = 0.0011


def binary(s: Any) -> None:
    s.solutionSettings.binarySolutionFile = True
    s.solutionSettings.outputPrecision = 17


def sparse(s: Any) -> None:
    s.linearSolverType = exu.LinearSolverType.EigenSparse


def two_threads(s: Any) -> None:
    sparse(s)
    s.parallel.numberOfThreads = 2


def located(s: Any) -> None:
    s.events.ofItems = True


def stubborn(s: Any) -> None:
    """Steps fail, and grow again."""
    s.timeIntegration.discontinuous.maxIterations = 2
    s.timeIntegration.discontinuous.ignoreMaxIterations = False
    s.timeIntegration.discontinuous.iterationTolerance = 1e-5
    s.timeIntegration.minimumStepSize = 1e-10
    s.timeIntegration.adaptiveStepRecoverySteps = 3


CASES: list[tuple[Callable[[], Any], Any, float, int, list[Callable[[Any], None]]]] = [
    (bricard, Solver.GeneralizedAlpha, 0.5, 100, []),
    (bricard, Solver.GeneralizedAlpha, 0.5, 100, [modified]),
    (bricard, Solver.GeneralizedAlpha, 0.5, 100, [by_tolerances, dense_output]),
    (bricard, Solver.TrapezoidalIndex2, 0.5, 100, [modified]),
    (bricard, Solver.DOPRI5, 0.5, 10, [dense_output]),
    (bricard, Solver.RK44, 0.5, 30, []),
    *((misplaced, kind, 0.5, 125, []) for kind in OF_POSITIONS),
    *((flat, kind, 1.0, 250, []) for kind in (*OF_POSITIONS, Solver.TrapezoidalIndex2)),
    *((slow, kind, 1e-5, 50, []) for kind in (Solver.TrapezoidalIndex2, Solver.DOPRI5, Solver.ESDIRK43)),
    (squeezer, Solver.GeneralizedAlpha, 0.02, 20, [by_tolerances]),
    (squeezer, Solver.TrapezoidalIndex2, 0.02, 100, [by_tolerances, dense_output]),
    (squeezer, Solver.DOP853, 0.02, 20, [dense_output, binary]),
    (bricard, Solver.ESDIRK43, 0.5, 10, [dense_output]),
    (squeezer, Solver.ESDIRK43, 0.02, 20, [binary]),
    (sliding, Solver.ESDIRK43, 2.0, 300, []),
    (sliding, Solver.GeneralizedAlpha, 2.0, 300, []),
    (sliding, Solver.GeneralizedAlpha, 2.0, 300, [stubborn]),
    (sliding, Solver.TrapezoidalIndex2, 2.0, 300, [modified, binary]),
    (sliding, Solver.RK44, 2.0, 3000, []),
    *((sliding, kind, 2.0, 300, [located]) for kind in (Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43)),
    (bouncing, Solver.GeneralizedAlpha, 1.0, 200, []),
    (bouncing, Solver.GeneralizedAlpha, 1.0, 200, [located]),
    (bouncing, Solver.GeneralizedAlpha, 1.0, 200, [located, by_tolerances, dense_output]),
    (bouncing, Solver.TrapezoidalIndex2, 1.0, 200, [located, modified]),
    (bouncing, Solver.DOP853, 1.0, 20, [located, dense_output]),
    (bouncing, Solver.ESDIRK43, 1.0, 20, [located]),
    (bouncing, Solver.VelocityVerlet, 1.0, 500, [located]),
    *((throwing, kind, 1.0, 100, []) for kind in (Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43)),
    *((bricard, kind, 0.5, 50, [two_threads]) for kind in (Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43)),
    (passing, Solver.GeneralizedAlpha, 1.0, 50, [by_tolerances]),
    (passing, Solver.DOPRI5, 1.0, 50, []),
    (passing, Solver.ESDIRK43, 1.0, 50, []),
    *((gathering, kind, 1.0, 500, [sparse]) for kind in (Solver.GeneralizedAlpha, Solver.RK44, Solver.ESDIRK43)),
    *((gathering, kind, 1.0, 500, [sparse, located]) for kind in (Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.RK44)),
    (top, Solver.GeneralizedAlpha, 1.0, 77, [dense_output]),
    (top, Solver.RK67, 1.0, 77, [dense_output]),
    (top, Solver.ESDIRK43, 1.0, 20, [dense_output]),
    *((spring, kind, 1.0, 177, []) for kind in (Solver.ExplicitEuler, Solver.ExplicitMidpoint, Solver.RK33)),
    *((spring, kind, 1.0, 177, []) for kind in (Solver.ODE23, Solver.VelocityVerlet)),
]


def settings_of(end: float, steps: int, changes: list[Callable[[Any], None]]) -> Any:
    """A restart file after 0.6 of the time, and one at the end: the first of them is the one that is kept."""
    s = settings(end, steps)
    s.solutionSettings.writeSolutionToFile = True
    s.solutionSettings.coordinatesSolutionFileName = "solution.txt"
    s.solutionSettings.solutionWritePeriod = s.solutionSettings.sensorsWritePeriod = end / 50
    s.solutionSettings.outputPrecision = 16
    s.solutionSettings.exportAccelerations = s.solutionSettings.exportAlgebraicCoordinates = True
    s.solutionSettings.writeRestartFile = True
    s.solutionSettings.restartFileName = NAME
    s.solutionSettings.restartWritePeriod = 0.6 * end
    for change in changes:
        change(s)
    return s


def written() -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in Path().glob("*.txt")}


def without_times(files: dict[str, bytes]) -> dict[str, list[bytes]]:
    """File contents without the times of day in headers and footers, and without durations."""
    times = rb"\d{4}-\d\d-\d\d.?\d\d:\d\d:\d\d|cpuTime=[^,]*"
    return {name: re.sub(times, b"", content).splitlines() for name, content in files.items()}


def test_id(case: Any) -> str:
    model, solver, _, _, changes = case
    return "-".join([model.__name__, solver.name, *(change.__name__ for change in changes)])


test_id.__test__ = False  # type: ignore[attr-defined]


@pytest.mark.parametrize("case", CASES, ids=test_id)
def test_interrupted_and_continued(case: Any) -> None:
    """Acceptance number P10: Ctrl-C after 0.8 of the time, where the restart file of 0.6 is the last one."""
    model, solver, end, steps, changes = case
    s = settings_of(end, steps, changes)
    model().SolveDynamic(s, solverType=solver)
    whole = without_times(written())
    assert set(whole) == {"solution.txt", "sensor.txt", NAME}
    Path(NAME).unlink()
    Path(NAME + ".bck").unlink()
    with ctrl_c_at(0.8 * end), pytest.raises(KeyboardInterrupt):
        model().SolveDynamic(s, solverType=solver)
    for name in ("solution.txt", "sensor.txt"):  # it was writing when it was stopped
        with Path(name).open("ab") as file:
            file.write(b"something else" * 40)
    s.continuation.restartFileName = NAME
    model().SolveDynamic(s, solverType=solver)
    assert without_times(written()) == whole


def test_static_solutions_go_on() -> None:
    def cable() -> Any:
        mbs = new_system()
        cable = exu.utilities.Cable2D(physicsMassPerLength=1, physicsBendingStiffness=1, physicsAxialStiffness=1e4)
        made = exu.utilities.GenerateStraightLineANCFCable2D(
            mbs, [0, 0, 0], [2, 0, 0], 8, cable, fixedConstraintsNode0=[1, 1, 0, 1]
        )
        tip = mbs.AddMarker(eii.MarkerNodePosition(nodeNumber=made[0][-1]))
        mbs.AddLoad(eii.LoadForceVector(markerNumber=tip, loadVector=[0, -1, 0]))
        return watched(mbs, int(made[0][-1]))

    s = settings_of(1, 1, [])
    s.staticSolver.numberOfLoadSteps = 7
    cable().SolveStatic(s)
    whole = without_times(written())
    os.replace(NAME + ".bck", "middle.txt")
    s.continuation.restartFileName = "middle.txt"
    cable().SolveStatic(s)
    Path("middle.txt").unlink()
    assert without_times(written()) == whole


def test_earlier_warnings_are_repeated_at_the_end() -> None:
    """Steps that are too large for the tolerances come before and after the restart file; the end counts both."""
    s = settings_of(1.0, 20, [by_tolerances])
    s.timeIntegration.minimumStepSize = 0.04
    s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = 1e-12
    whole = spring().SolveDynamic(s)
    with ctrl_c_at(0.8), pytest.raises(KeyboardInterrupt):
        spring().SolveDynamic(s)
    s.continuation.restartFileName = NAME
    mbs = spring()
    assert mbs.SolveDynamic(s).doubts == whole.doubts
    assert mbs.sys["dynamicSolver"].it.stepsAboveTolerance > 10


def frequent() -> Any:
    """Settings with restart files at many times."""
    s = settings_of(0.02, 200, [])
    s.solutionSettings.restartWritePeriod = 0.003
    return s


SCRIPT = """
import os, sys
sys.path[:0] = {path!r}
from test_continuation import *
mbs = squeezer()
mbs.SetPostStepUserFunction(lambda mbs, t: t < 0.0137 or os._exit(9))
mbs.SolveDynamic(frequent())
"""


def test_a_process_that_dies(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Outputs between two restart files; they differ by the time of the start in comments only.
    Another process goes on."""
    results = []
    for dies in (False, True):
        place = tmp_path / str(dies)
        place.mkdir()
        monkeypatch.chdir(place)
        s = frequent()
        if dies:
            done = subprocess.run(
                [sys.executable, "-c", SCRIPT.format(path=sys.path)], capture_output=True, timeout=100
            )
            assert done.returncode == 9, done.stderr.decode()
            s.continuation.restartFileName = NAME
        squeezer().SolveDynamic(s)
        files = without_times(written())
        results.append([line for name in ("solution.txt", "sensor.txt", NAME) for line in files[name]])
    assert len(results[0]) > 100
    assert results[0] == results[1]


def test_another_solver_is_refused() -> None:
    s = settings_of(1, 20, [])
    spring().SolveDynamic(s)
    s.continuation.restartFileName = NAME
    with pytest.raises(ValueError, match=r"was written by implicit .*; expected explicit time integration \(RK44\)"):
        spring().SolveDynamic(s, solverType=Solver.RK44)
    s.timeIntegration.startTime = 0.5
    with pytest.raises(ValueError, match="has begun at time 0; received a start time of 0.5"):
        spring().SolveDynamic(s)
    s.timeIntegration.startTime = 0
    with pytest.raises(ValueError, match="numbers of coordinates are not those of this system"):
        flat().SolveDynamic(s)
    Path("solution.txt").write_text("too short")
    with pytest.raises(ValueError, match=r"solution.txt': expected at least \d+ bytes"):
        spring().SolveDynamic(s)
