"""IFToMM benchmark A02: N loops of parallelograms that pass their flat, singular position."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from solving import Solver, Variable, new_system, settings
from tolerances import by_tolerance

import dalembert as exu

GRAVITY = 9.81
PUBLISHED = {  # N = 2: position of the first coupler's left end
    1: (-0.1950203019, -0.9807992057),
    5: (-0.8113104610, -0.5846155454),
    10: (0.3284581115, 0.9445185382),
}
VELOCITY = (1.423051470, -0.494868845)  # after 10 s


def parallelogram(loops: int, times: list[float], start: tuple[float, float] = (np.pi / 2, -1)) -> np.ndarray:
    """Position and velocity of B0 on the branch that stays a parallelogram, from an angle and its rate."""
    factor = ((loops + 1) / 2 + loops) / ((loops + 1) / 3 + loops)

    def rates(t: float, x: np.ndarray) -> list[float]:
        return [x[1], -GRAVITY * factor * np.cos(x[0])]

    x = solve_ivp(rates, [0, 10], start, "DOP853", times, rtol=1e-13, atol=1e-13).y
    return np.array([np.cos(x[0]), np.sin(x[0]), -np.sin(x[0]) * x[1], np.cos(x[0]) * x[1]]).T


class Bars:
    def __init__(self, loops: int, angle: float = np.pi / 2, rate: float = -1) -> None:
        self.mbs, self.loops = new_system(), loops
        ground = self.mbs.AddObject(exu.ObjectGround())
        along, across = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
        links = [self.bar([*([i, 0] + along / 2), angle], [*(rate * across / 2), rate]) for i in range(loops + 1)]
        couplers = [self.bar([*([i + 0.5, 0] + along), 0], [*(rate * across), 0]) for i in range(loops)]
        for i, link in enumerate(links):
            self.join((ground, [i, 0, 0]), (link, [-0.5, 0, 0]))
        for i, coupler in enumerate(couplers):
            self.join((links[i], [0.5, 0, 0]), (coupler, [-0.5, 0, 0]))
            self.join((links[i + 1], [0.5, 0, 0]), (coupler, [0.5, 0, 0]))
        self.tip = links[0]
        self.mbs.Assemble()

    def bar(self, reference: list[float], velocities: list[float]) -> Any:
        node = self.mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=reference, initialVelocities=velocities))
        body = self.mbs.AddObject(exu.RigidBody2D(physicsMass=1, physicsInertia=1 / 12, nodeNumber=node))
        mass = self.mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
        self.mbs.AddLoad(exu.Gravity(markerNumber=mass, loadVector=[0, -GRAVITY, 0]))
        return body

    def join(self, *ends: tuple[Any, list[float]]) -> None:
        markers = [self.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=p)) for b, p in ends]
        self.mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=markers))

    def tip_output(self, variable: Any) -> np.ndarray:
        return self.mbs.GetObjectOutputBody(self.tip, variable, [0.5, 0, 0])[:2]


def test_published_values() -> None:
    states = parallelogram(2, list(PUBLISHED))
    np.testing.assert_allclose(states[:, :2], list(PUBLISHED.values()), rtol=0, atol=1e-9)
    np.testing.assert_allclose(states[-1, 2:], VELOCITY, rtol=0, atol=1e-8)


@pytest.mark.parametrize("loops", [1, 2, 5])
@pytest.mark.parametrize("end", [1, 5, 10])
def test_parallelogram(loops: int, end: int) -> None:
    """Second order: h = 1 ms gives (omega h)^2 / 12 = 3e-6 per radian and some 4 rad per second, times up to four for numerical
    damping; passing the singular position must not add to it."""
    bars = Bars(loops)
    bars.mbs.SolveDynamic(settings(end, 1000 * end))
    wanted = parallelogram(loops, [end])[0]
    error = np.linalg.norm(bars.tip_output(Variable.Position) - wanted[:2])
    assert 1e-8 < error < 6e-5 * end
    np.testing.assert_allclose(bars.tip_output(Variable.Velocity), wanted[2:], rtol=0, atol=6e-4 * end)


@pytest.mark.parametrize("linear", [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenSparse])
def test_start_in_the_singular_position(linear: Any) -> None:
    """Flat, with three degrees of freedom at the start and one thereafter; it comes back there after 0.67 s."""
    bars = Bars(2, angle=0, rate=-3)
    assert bars.mbs.ComputeSystemDegreeOfFreedom()["degreeOfFreedom"] == 3
    s = settings(1, 250)
    s.linearSolverType = linear
    bars.mbs.SolveDynamic(s)
    np.testing.assert_allclose(bars.tip_output(Variable.Position), [-0.9245629518, 0.3810293271], rtol=0, atol=1e-4)
    angles = [bars.mbs.GetObjectOutputBody(bars.tip + i, Variable.Rotation, [0, 0, 0]) for i in range(3)]
    assert np.ptp(angles) < 1e-9
    assert bars.mbs.sys["dynamicSolver"].GetRedundantConstraints()["count"] == 0


def test_what_a_singular_start_shows_is_not_kept_by_explicit_solvers() -> None:
    """Reactions are unique as soon as it moves. Differences of gaps leave 1e-7 m where it comes back to that position."""
    bars = Bars(2, angle=0, rate=-3)
    bars.mbs.SolveDynamic(settings(1, 1000), solverType=exu.DynamicSolverType.DOPRI5)
    np.testing.assert_allclose(bars.tip_output(Variable.Position), [-0.9245629518, 0.3810293271], rtol=0, atol=2e-7)
    found = bars.mbs.sys["dynamicSolver"].GetRedundantConstraints()
    assert (found["count"], found["equations"]) == (0, [])


@pytest.mark.parametrize("loops", [2, 5])
@pytest.mark.parametrize("solver", [Solver.TrapezoidalIndex2, Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43])
def test_reactions_after_a_start_in_the_singular_position(solver: Any, loops: int) -> None:
    """Mean of starts 1e-4 rad next to it, on both sides; the trapezoidal rule keeps errors of the first multipliers for
    good."""

    def multipliers(angle: float) -> np.ndarray:
        bars = Bars(loops, angle, rate=-3)
        s = settings(0.3, 300)
        s.timeIntegration.automaticStepSize = False
        bars.mbs.SolveDynamic(s, solverType=solver)
        return np.array(bars.mbs.systemData.GetAECoordinates())

    wanted = (multipliers(1e-4) + multipliers(-1e-4)) / 2
    np.testing.assert_allclose(multipliers(0), wanted, rtol=0, atol=1e-5 * np.abs(wanted).max())


@pytest.mark.parametrize("loops", [1, 2, 5])
@pytest.mark.parametrize("solver", [Solver.TrapezoidalIndex2, Solver.GeneralizedAlpha])
def test_small_steps_lead_out_of_the_singular_position(solver: Any, loops: int) -> None:
    """Tolerances at which accelerations of another motion at the start would count as errors of any step."""
    bars = Bars(loops, angle=0, rate=-3)
    bars.mbs.SolveDynamic(by_tolerance(settings(0.03, 50), 1e-8), solverType=solver)
    wanted = parallelogram(loops, [0.03], (0, -3))[0][:2]
    np.testing.assert_allclose(bars.tip_output(Variable.Position), wanted, rtol=0, atol=1e-7)
