"""Times of steps do not drift, and output has the requested times."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import START, dynamic_settings, exact_oscillation, friction_or_stop, mass, oscillator

import dalembert as exu
from dalembert.itemInterface import NodeGenericODE1, ObjectGenericODE1, SensorBody
from dalembert.utilities import InertiaCuboid, LoadSolutionFile

Solver = exu.DynamicSolverType
Variable = exu.OutputVariableType


@pytest.mark.parametrize("adaptive", [False, True])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.RK44, Solver.VelocityVerlet], ids=str)
def test_equal_steps_are_counted(solver: Any, adaptive: bool) -> None:
    """100 000 steps of 0.1 ms: their sum would be off by 1e-12, and the last step with it."""
    times: list[float] = []
    model = mass()
    model.mbs.Assemble()
    model.mbs.SetPostStepUserFunction(lambda mbs, t: times.append(t) is None)
    settings = dynamic_settings(10.0, 100_000)
    settings.timeIntegration.adaptiveStep = adaptive
    settings.timeIntegration.newton.useModifiedNewton = True
    model.mbs.SolveDynamic(settings, solverType=solver)
    assert times == [*(k * (10 / 100_000) for k in range(100_000)), 10.0]
    assert model.mbs.sys["dynamicSolver"].it.currentStepSize == 1e-4


def test_adaptive_steps_change_nothing_where_no_step_fails() -> None:
    ends = []
    for adaptive in (False, True):
        model = oscillator()
        model.mbs.Assemble()
        settings = dynamic_settings(1.0, 33)
        settings.timeIntegration.adaptiveStep = adaptive
        model.mbs.SolveDynamic(settings)
        ends.append((model.position, model.speed))
    assert ends[0] == ends[1]


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5], ids=str)
@pytest.mark.parametrize("scale", [1e-9, 1e-4, 1e4])
def test_any_unit_of_time(solver: Any, scale: float) -> None:
    """Steps of a picosecond, and of a minute: the same motion, as far as numbers go."""
    model = oscillator(stiffness=80 / scale**2, damping=1.5 / scale, position=START, speed=-0.7 / scale)
    model.mbs.Assemble()
    settings = dynamic_settings(scale, 1000)
    settings.timeIntegration.minimumStepSize = 1e-8 * scale
    settings.timeIntegration.automaticStepSize = solver == Solver.DOPRI5
    settings.timeIntegration.absoluteTolerance = 1e-9 / min(scale, 1)
    model.mbs.SolveDynamic(settings, solverType=solver)
    assert model.mbs.sys["dynamicSolver"].it.currentStepIndex == 1001
    assert len(model.table()) == 1001
    assert model.position == pytest.approx(exact_oscillation(1.0)[0], abs=1e-5)


# ---- output at requested times -------------------------------------------------------------------------------------------


def between_steps(settings: Any, period: float) -> Any:
    settings.denseOutput.atRequestedTimes = True
    settings.solutionSettings.sensorsWritePeriod = settings.solutionSettings.solutionWritePeriod = period
    return settings


@pytest.mark.parametrize(
    ("solver", "steps", "tolerance"),
    [
        (Solver.GeneralizedAlpha, 400, 2e-4),
        (Solver.TrapezoidalIndex2, 400, 1e-4),
        (Solver.VelocityVerlet, 400, 1e-3),
        (Solver.RK44, 30, 2e-4),
        (Solver.RK67, 30, 1e-6),
        (Solver.DOP853, 20, 1e-6),
    ],
    ids=str,
)
def test_an_oscillation_between_steps(solver: Any, steps: int, tolerance: float) -> None:
    model = oscillator()
    model.mbs.Assemble()
    model.mbs.SolveDynamic(between_steps(dynamic_settings(1.0, steps), 0.013), solverType=solver)
    times, positions = model.table().T
    assert times == pytest.approx([*(0.013 * k for k in range(77)), 1.0], rel=0, abs=1e-15)
    np.testing.assert_allclose(positions, [exact_oscillation(t)[0] for t in times], rtol=0, atol=tolerance)


def test_first_order_equations_between_steps() -> None:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(
        NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[1, 0], numberOfODE1Coordinates=2)
    )
    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1, 4], [-4, -1]]))
    mbs.Assemble()
    settings = between_steps(dynamic_settings(1.0, 40), 0.01)
    settings.solutionSettings.writeSolutionToFile = True
    settings.solutionSettings.coordinatesSolutionFileName = "solution.txt"
    mbs.SolveDynamic(settings, solverType=Solver.RK44)
    time, y0, y1 = LoadSolutionFile("solution.txt", verbose=False)["data"][:, :3].T
    assert time == pytest.approx(np.linspace(0, 1, 101), abs=1e-12)
    np.testing.assert_allclose(y0, np.exp(-time) * np.cos(4 * time), rtol=0, atol=2e-5)
    np.testing.assert_allclose(y1, -np.exp(-time) * np.sin(4 * time), rtol=0, atol=2e-5)


def spinning(node_type: Any, steps: int, solver: Any, period: float) -> list[np.ndarray]:
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [1, 0.1, 0.2]),
        initialAngularVelocity=[0.2, 2, 5],
        initialVelocity=[0, 0, 3],
        gravity=[0, 0, -9.81],
        nodeType=node_type,
    )
    variables = (
        Variable.Position,
        Variable.RotationMatrix,
        Variable.AngularVelocityLocal,
        Variable.AngularAccelerationLocal,
    )
    sensors = [
        mbs.AddSensor(SensorBody(bodyNumber=body, storeInternal=True, outputVariableType=each)) for each in variables
    ]
    mbs.Assemble()
    mbs.SolveDynamic(between_steps(dynamic_settings(1.0, steps), period), solverType=solver)
    return [np.asarray(mbs.GetSensorStoredData(sensor)) for sensor in sensors]


@pytest.mark.parametrize("node_type", ["RotationEulerParameters", "RotationRxyz", "RotationRotationVector"])
def test_rotations_between_steps(node_type: str) -> None:
    """Turns by an eighth of a radian in a step, against thousand steps."""
    kind = getattr(exu.NodeType, node_type)
    coarse = spinning(kind, 40, Solver.DOP853, 0.007)
    fine = spinning(kind, 1000, Solver.DOP853, 0.007)
    for few, many, tolerance in zip(coarse, fine, (1e-12, 1e-6, 4e-6, 4e-4), strict=True):
        assert few.shape == many.shape
        np.testing.assert_allclose(few, many, rtol=0, atol=tolerance * max(1, np.abs(many).max()))


def test_output_does_not_disturb() -> None:
    """It does not depend on previous requests."""
    ends = []
    for period in (0.0, 0.0013, 0.5):
        model = oscillator()
        friction_or_stop(model, stiffness=0.0, fDynamicFriction=0.5, stickingStiffness=1e3, stickingDamping=5.0)
        model.mbs.Assemble()
        model.mbs.SolveDynamic(between_steps(dynamic_settings(1.0, 100), period))
        ends.append((model.position, model.speed))
        assert len(model.table()) == {0.0: 101, 0.0013: 771, 0.5: 3}[period]
    assert ends[0] == ends[1] == ends[2]
