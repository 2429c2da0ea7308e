"""Steps that end where functions of the state change their sign, and their actions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings, mass

import dalembert as exu
from dalembert.itemInterface import ObjectConnectorCoordinateSpringDamper
from dalembert.solver import SolverError

Solver = exu.DynamicSolverType
Current = exu.ConfigurationType.Current
GRAVITY = 9.81
STIFFNESS, DAMPING, HEIGHT = 1e5, 50.0, 0.5
AFTER_TWO_SECONDS = 0.0074473638  # pieces of exact motion, twelve digits


class Ball:
    """1 kg that falls; `touches` selects whether the floor has contact."""

    def __init__(self, height: float = HEIGHT) -> None:
        self.model = mass(position=height, speed=0, physics_mass=1)
        self.model.load(-GRAVITY)
        self.mbs, self.touches, self.events = self.model.mbs, False, 0

    def state(self) -> tuple[float, float]:
        return self.model.position, self.model.speed

    def floor(self) -> None:
        """Contact begins at zero height on the way down, and ends when the floor would pull."""

        def force(mbs: Any, t: float, item: int, u: float, v: float, *parameters: float) -> float:
            return STIFFNESS * u + DAMPING * v if self.touches else 0.0

        def values(mbs: Any, t: float) -> list[tuple[float, int]]:
            u, v = self.state()
            return [(1.0, -1), (STIFFNESS * u + DAMPING * v, 1)] if self.touches else [(u, -1), (-1.0, 1)]

        def switch(mbs: Any, t: float, event: int, direction: int) -> bool:
            assert (event, direction) == ((1, 1) if self.touches else (0, -1))
            self.touches, self.events = not self.touches, self.events + 1
            return True

        self.mbs.AddObject(
            ObjectConnectorCoordinateSpringDamper(
                markerNumbers=[self.model.ground, self.model.marker], springForceUserFunction=force
            )
        )
        self.mbs.SetEventsUserFunction(values)
        self.mbs.SetEventActionUserFunction(switch)
        self.mbs.Assemble()

    def hard_floor(self, restitution: float) -> None:
        def bounce(mbs: Any, t: float, event: int, direction: int) -> bool:
            self.events += 1
            mbs.systemData.SetODE2Coordinates_t([-restitution * self.model.speed], configuration=Current)
            return True

        self.mbs.SetEventsUserFunction(lambda mbs, t: [(self.model.position, -1)])
        self.mbs.SetEventActionUserFunction(bounce)
        self.mbs.Assemble()

    def solve(self, end: float, steps: int, solver: Any = Solver.GeneralizedAlpha, **options: Any) -> Any:
        settings = dynamic_settings(end, steps)
        settings.timeIntegration.generalizedAlpha.spectralRadius = 0.8
        for name, value in options.items():
            setattr(settings.timeIntegration, name, value)
        self.mbs.SolveDynamic(settings, solverType=solver)
        return self.mbs.sys["dynamicSolver"].it


def ball_on_floor(steps: int) -> tuple[float, Any]:
    ball = Ball()
    ball.floor()
    it = ball.solve(2, steps)
    assert it.currentTime == 2 and it.eventsCount == ball.events > 4
    return abs(ball.model.position - AFTER_TWO_SECONDS), it


def test_second_order_although_forces_jump() -> None:
    """Acceptance number P8: contact with a damper, whose force jumps where it begins."""
    steps = [2000, 4000, 8000, 16000]
    results = [ball_on_floor(n) for n in steps]
    errors = [error for error, _ in results]
    for coarse, fine in zip(errors[:-1], errors[1:], strict=True):
        assert np.log2(coarse / fine) == pytest.approx(2, abs=0.2)
    error, it = results[-1]
    assert error < 3e-4
    assert it.currentStepIndex - 1 + it.eventSolutions - it.eventsCount <= 1.01 * steps[-1]


@pytest.mark.parametrize(
    "solver", [Solver.GeneralizedAlpha, Solver.RK44, Solver.VelocityVerlet, Solver.DOPRI5, Solver.ESDIRK43], ids=str
)
@pytest.mark.parametrize("steps", [15, 150])
def test_impacts(solver: Any, steps: int) -> None:
    """Three impacts in 1.5 s; parabolas between them are exact for all methods."""
    ball = Ball()
    ball.hard_floor(0.8)
    it = ball.solve(1.5, steps, solver, automaticStepSize=True)
    time, speed = np.sqrt(2 * HEIGHT / GRAVITY), 0.8 * np.sqrt(2 * HEIGHT * GRAVITY)
    while time + 2 * speed / GRAVITY < 1.5:
        time, speed = time + 2 * speed / GRAVITY, 0.8 * speed
    rest = 1.5 - time
    assert ball.events == it.eventsCount == 3
    assert ball.model.position == pytest.approx(speed * rest - GRAVITY * rest**2 / 2, abs=1e-10)


@pytest.mark.parametrize(("solver", "tolerance"), [(Solver.DOP853, 1e-12), (Solver.ESDIRK43, 1e-10)])
def test_steps_with_error_control_find_events(solver: Any, tolerance: float) -> None:
    ball = Ball()
    ball.floor()
    ball.solve(2, 20, solver, automaticStepSize=True, absoluteTolerance=tolerance, relativeTolerance=tolerance)
    assert ball.model.position == pytest.approx(AFTER_TWO_SECONDS, abs=1e-8)


def test_directions_and_the_end() -> None:
    """x = cos t: falling zeros at pi/2 + 2 pi n; the action ends the solution at the second one."""
    times: list[float] = []

    def act(mbs: Any, t: float, event: int, direction: int) -> bool:
        times.append(t)
        assert (event, direction) == (0, -1)
        return len(times) < 2

    model = mass(position=1, speed=0, physics_mass=1)
    model.mbs.AddObject(ObjectConnectorCoordinateSpringDamper(markerNumbers=[model.ground, model.marker], stiffness=1))
    model.mbs.SetEventsUserFunction(lambda mbs, t: [(model.position, -1)])
    model.mbs.SetEventActionUserFunction(act)
    model.mbs.Assemble()
    model.mbs.SolveDynamic(dynamic_settings(20, 200), solverType=Solver.RK67)
    assert times == pytest.approx([np.pi / 2, 5 * np.pi / 2], abs=1e-6)
    assert model.mbs.systemData.GetTime() == times[-1]
    assert abs(model.position) < 1e-10


def test_two_signs_within_a_step() -> None:
    """A parabola that dips below zero between the ends of a step of 1 s."""
    times: list[float] = []
    model = mass(position=0.1, speed=-1, physics_mass=1)
    model.load(2)
    model.mbs.SetEventsUserFunction(lambda mbs, t: [model.position])
    model.mbs.SetEventActionUserFunction(lambda mbs, t, event, direction: times.append(t) is None)
    model.mbs.Assemble()
    model.mbs.SolveDynamic(dynamic_settings(1, 1), solverType=Solver.RK44)
    assert times == pytest.approx([(1 - np.sqrt(0.6)) / 2, (1 + np.sqrt(0.6)) / 2], abs=1e-9)


def test_events_without_action_only_end_steps() -> None:
    model = mass(position=0, speed=1, physics_mass=1)
    model.mbs.SetEventsUserFunction(lambda mbs, t: [t - 0.123, model.position - 0.777])
    model.mbs.Assemble()
    settings = dynamic_settings(1, 10)
    settings.solutionSettings.sensorsWritePeriod = 0
    model.mbs.SolveDynamic(settings)
    assert model.position == pytest.approx(1, abs=1e-12)
    for event in (0.123, 0.777):
        assert np.abs(model.table()[:, 0] - event).min() < 1e-10


def test_events_at_ends_of_steps_cut_none() -> None:
    """Round-off puts some of them behind the end, in the first 1e-12 of the next step."""
    model = mass(position=0, speed=1, physics_mass=1)
    model.mbs.SetEventsUserFunction(lambda mbs, t: [np.sin(np.pi * (100 * t - 0.25))])
    model.mbs.SetEventActionUserFunction(lambda mbs, t, event, direction: True)
    model.mbs.Assemble()
    model.mbs.SolveDynamic(dynamic_settings(0.5, 200))
    it = model.mbs.sys["dynamicSolver"].it
    assert (it.eventsCount, it.currentStepIndex - 1) == (50, 200)


def test_ever_faster_events_end_with_an_error() -> None:
    ball = Ball()
    ball.hard_floor(0.5)
    with pytest.raises(SolverError, match="event 0 of mbs.EventsUserFunction") as caught:
        ball.solve(3, 100)
    assert caught.value.reason == "eventChatter"


@pytest.mark.parametrize("result", [None, "text", 3, [(1, 2, 3)]])
def test_wrong_values_are_refused(result: Any) -> None:
    model = mass()
    model.mbs.SetEventsUserFunction(lambda mbs, t: result)
    model.mbs.Assemble()
    with pytest.raises(ValueError, match=r"EventsUserFunction.*expected a list of numbers, or of pairs"):
        model.mbs.SolveDynamic(dynamic_settings(1, 10))


def test_the_number_of_events_stays() -> None:
    model = mass()
    model.mbs.SetEventsUserFunction(lambda mbs, t: [1.0] * (1 if t == 0 else 2))
    model.mbs.Assemble()
    with pytest.raises(ValueError, match="received 2 values; expected 1, as at the start"):
        model.mbs.SolveDynamic(dynamic_settings(1, 10))


@pytest.mark.parametrize(
    "solver",
    [
        exu.DynamicSolverType.GeneralizedAlpha,
        exu.DynamicSolverType.TrapezoidalIndex2,
        exu.DynamicSolverType.DOPRI5,
        exu.DynamicSolverType.ESDIRK43,
    ],
)
def test_impacts_act_on_the_whole_mechanism(solver: Any) -> None:
    """A pendulum of one meter gets 1 m/s along x where its rod is at 60 degrees: cos 30 degrees of it stay, and no velocity along the rod."""
    gravity = 10.0
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    bob = mbs.CreateMassPoint(physicsMass=1, referencePosition=[1, 0, 0], gravity=[0, -gravity, 0])
    mbs.CreateDistanceConstraint(bodyNumbers=[ground, bob])
    mbs.Assemble()

    def blow(mbs: Any, t: float, event: int, direction: int) -> bool:
        velocities = mbs.systemData.GetODE2Coordinates_t()
        velocities[0] += 1
        mbs.systemData.SetODE2Coordinates_t(velocities)
        return True

    mbs.SetEventsUserFunction(
        lambda mbs, t: [(mbs.GetObjectOutputBody(bob, exu.OutputVariableType.Position)[0] - 0.5, -1)]
    )
    mbs.SetEventActionUserFunction(blow)
    settings = dynamic_settings(0.6, 600)
    settings.timeIntegration.automaticStepSize = False
    assert mbs.SolveDynamic(settings, solverType=solver)
    position = mbs.GetObjectOutputBody(bob, exu.OutputVariableType.Position)
    velocity = mbs.GetObjectOutputBody(bob, exu.OutputVariableType.Velocity)
    before = np.sqrt(2 * gravity * np.sin(np.pi / 3))
    energy = (before - np.cos(np.pi / 6)) ** 2 / 2 - gravity * np.sin(np.pi / 3)
    # Second order: (omega h)^2 / 12 of 4 rad/s in steps of 1 ms is 1e-6 of 10 J.
    assert velocity @ velocity / 2 + gravity * position[1] == pytest.approx(energy, abs=1e-4)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43])
def test_a_lock_that_an_action_closes_is_a_plastic_impact(solver: Any) -> None:
    """Two free masses of 1 and 3 kg, at 4 and 0 m/s, couple where the first has come to one meter: together they go on at 1 m/s."""
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(exu.Node1D(initialVelocities=[v])) for v in (4.0, 0.0)]
    for node, physics_mass in zip(nodes, (1, 3), strict=True):
        mbs.AddObject(exu.Mass1D(nodeNumber=node, physicsMass=physics_mass))
    markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0)) for node in nodes]
    lock = mbs.AddObject(exu.CoordinateConstraint(markerNumbers=markers, offset=-1, activeConnector=False))
    mbs.Assemble()

    def close(mbs: Any, t: float, event: int, direction: int) -> bool:
        mbs.SetObjectParameter(lock, "activeConnector", True)
        return True

    mbs.SetEventsUserFunction(lambda mbs, t: [(mbs.systemData.GetODE2Coordinates()[0] - 1, 1)])
    mbs.SetEventActionUserFunction(close)
    settings = dynamic_settings(1.25, 7)
    settings.timeIntegration.automaticStepSize = False
    assert mbs.SolveDynamic(settings, solverType=solver)
    np.testing.assert_allclose(mbs.systemData.GetODE2Coordinates(), [2, 1], rtol=0, atol=1e-9)
    np.testing.assert_allclose(mbs.systemData.GetODE2Coordinates_t(), [1, 1], rtol=0, atol=1e-9)


def test_impacts_against_inconsistent_joints_are_reported(capsys: pytest.CaptureFixture[str]) -> None:
    """A free coordinate without mass leaves no metric in which the smallest change could be found."""
    mbs = exu.SystemContainer().AddSystem()
    nodes = [mbs.AddNode(exu.Node1D(initialVelocities=[0.0])) for _ in range(2)]
    mbs.AddObject(exu.Mass1D(nodeNumber=nodes[0], physicsMass=1))
    mbs.AddObject(exu.Mass1D(nodeNumber=nodes[1], physicsMass=0))
    rest, *markers = (
        mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        for node in (mbs.AddNode(exu.NodePointGround()), *nodes)
    )
    mbs.AddObject(exu.CoordinateConstraint(name="rail", markerNumbers=[rest, markers[0]]))
    mbs.AddObject(exu.CoordinateSpringDamper(markerNumbers=[rest, markers[1]], stiffness=10, damping=1))
    mbs.Assemble()

    def blow(mbs: Any, t: float, event: int, direction: int) -> bool:
        mbs.systemData.SetODE2Coordinates_t([1, 0])
        return True

    mbs.SetEventsUserFunction(lambda mbs, t: [(t - 0.5, 1)])
    mbs.SetEventActionUserFunction(blow)
    mbs.SolveDynamic(dynamic_settings(1, 10))
    told = "".join(capsys.readouterr())
    assert told.count("the action of an event contradicts 1 constraint equation") == 1
    assert "'rail'" in told and "mass matrix and constraints are singular at unknown 1" in told
