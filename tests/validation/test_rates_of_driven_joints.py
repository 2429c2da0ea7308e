"""Joints that functions of time move: rates of their own are used as they are, and their lack is reported."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

AMPLITUDE = 0.3  # m


def lifted(rate: float, with_rate: bool) -> tuple[Any, Any]:
    """A block that a generic joint lifts by AMPLITUDE (1 - cos(rate t))."""

    def lift(mbs: Any, t: float, item: int, given: Any) -> list[float]:
        return [0, 0, AMPLITUDE * (1 - np.cos(rate * t)), 0, 0, 0]

    def rate_of_lift(mbs: Any, t: float, item: int, given: Any) -> list[float]:
        return [0, 0, AMPLITUDE * rate * np.sin(rate * t), 0, 0, 0]

    mbs = exu.SystemContainer().AddSystem()
    block = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [0.1, 0.1, 0.1]))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body)) for body in (mbs.CreateGround(), block)]
    functions = {"offsetUserFunction": lift} | ({"offsetUserFunction_t": rate_of_lift} if with_rate else {})
    mbs.AddObject(exu.GenericJoint(name="lift", markerNumbers=markers, constrainedAxes=[1] * 6, **functions))
    mbs.Assemble()
    return mbs, block


def settings(steps: int = 200) -> Any:
    made = exu.SimulationSettings()
    made.timeIntegration.endTime, made.timeIntegration.numberOfSteps = 1, steps
    made.timeIntegration.verboseMode = 0
    made.solutionSettings.writeSolutionToFile = False
    return made


def test_index_2_reports_functions_without_rates() -> None:
    mbs, block = lifted(5, with_rate=False)
    found = mbs.SolveDynamic(settings(), solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    assert "object 2 'lift' (ObjectJointGeneric), equation 2: a function of time moves the position" in str(found)
    assert "Give offsetUserFunction_t" in str(found)


@pytest.mark.parametrize(("solver", "with_rate"), [("TrapezoidalIndex2", True), ("GeneralizedAlpha", False)])
def test_prescribed_lifts_are_followed(solver: str, with_rate: bool) -> None:
    mbs, block = lifted(5, with_rate)
    found = mbs.SolveDynamic(settings(), solverType=exu.DynamicSolverType.__members__[solver])
    assert "a function of time" not in str(found)
    position = mbs.GetObjectOutput(block, exu.OutputVariableType.Position)
    # the trapezoidal rule integrates the rate: A w^3 h^2 / 12 per second = 8e-5
    np.testing.assert_allclose(position, [0, 0, AMPLITUDE * (1 - np.cos(5))], rtol=0, atol=8e-5 if with_rate else 1e-8)


@pytest.mark.parametrize(
    ("rate", "time", "with_rate", "tolerance"),
    [
        (2e4 * 2 * np.pi, 1e-6, True, 1e-12),  # the given function
        (5.0, 1e5, True, 1e-12),
        (
            5.0,
            1e4,
            False,
            2e-7,
        ),  # differences over 1e-4 s: (w h)^2 / 3 = 8e-8, round-off of the phase 1e-16 t / h = 2e-8
        (1e3 * 2 * np.pi, 1e-4, False, 3e-5),  # over 1e-6 s: (w h)^2 / 3 = 1.3e-5
    ],
)
def test_consistent_velocities(rate: float, time: float, with_rate: bool, tolerance: float) -> None:
    mbs, block = lifted(rate, with_rate)
    mbs.systemData.SetTime(time, exu.ConfigurationType.Initial)
    made = settings()
    made.timeIntegration.startTime = time
    made.timeIntegration.endTime = time + 1
    mbs.ComputeConsistentInitialConditions(made)
    velocity = mbs.systemData.GetODE2Coordinates_t(exu.ConfigurationType.Initial)[2]
    assert velocity == pytest.approx(AMPLITUDE * rate * np.sin(rate * time), rel=tolerance)
