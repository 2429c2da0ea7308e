"""Welds with half a turn, and static solutions of hinges with weight: texts of warnings and errors."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.utilities import (
    InertiaCuboid,
    RotationMatrixX,
    RotationMatrixZ,
    RotationVector2RotationMatrix,
)


def quiet() -> exu.SimulationSettings:
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.01, 2
    settings.timeIntegration.verboseMode = settings.staticSolver.verboseMode = 0
    return settings


def welded(rotation: np.ndarray, joint: str = "Generic", **more: Any) -> exu.MainSystem:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [0.1, 0.2, 0.3]), initialRotationMatrix=rotation)
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (ground, body)]
    mbs.AddObject(getattr(exu, f"ObjectJoint{joint}")(name="weld", markerNumbers=markers, **more))
    mbs.Assemble()
    return mbs


HALF_TURNS = [
    pytest.param(RotationMatrixX(np.pi), 180, "Generic", id="180"),
    pytest.param(RotationMatrixX(np.radians(170)), 170, "Generic", id="170"),
    pytest.param(RotationMatrixZ(np.pi), 180, "PrismaticX", id="slider"),
]


@pytest.mark.parametrize(("rotation", "angle", "joint"), HALF_TURNS)
def test_half_turns_are_named(rotation: np.ndarray, angle: float, joint: str) -> None:
    named = rf"object 2 'weld' \(Joint{joint}\): frames turned by {{}} degrees"
    if joint == "Generic":  # a slider moves freely
        with pytest.warns(UserWarning, match=r"SolveStatic: at the start(?s:.*)" + named.format(angle)):
            welded(rotation, joint).SolveStatic(quiet())
    with pytest.warns(UserWarning, match=r"SolveDynamic: at the start(?s:.*)" + named.format(angle)):
        welded(rotation, joint).SolveDynamic(quiet(), solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    with pytest.warns(UserWarning, match=r"as found, joints(?s:.*)" + named.format(180)):  # also from 170
        welded(rotation, joint).ComputeConsistentInitialConditions()


@pytest.mark.parametrize(
    ("rotation", "more"),
    [
        (np.eye(3), {}),
        (RotationMatrixX(np.radians(60)), {}),
        (RotationMatrixX(np.pi), {"rotationMarker0": RotationMatrixX(np.pi)}),
        (RotationMatrixX(np.pi), {"constrainedAxes": [1, 1, 1, 0, 1, 1]}),  # a hinge turns by any angle
        (RotationVector2RotationMatrix([1.0, 1, 1]), {"alternativeConstraints": True}),
    ],
)
def test_joints_that_are_meant_so_are_not_named(rotation: np.ndarray, more: dict[str, Any]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mbs = welded(rotation, **more)
        mbs.ComputeConsistentInitialConditions()
        if "constrainedAxes" not in more:
            mbs.SolveStatic(quiet())


def balance() -> tuple[exu.MainSystem, Any]:
    """A beam on a hinge above its centre, with a force at a side."""
    mbs = exu.SystemContainer().AddSystem()
    beam = mbs.CreateRigidBody(
        referencePosition=[0, -0.1, 0], inertia=InertiaCuboid(1000, [1, 0.05, 0.05]), gravity=[0, -9.81, 0]
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[mbs.CreateGround(), beam], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.CreateForce(bodyNumber=beam, localPosition=[0.4, 0, 0], loadVector=[0, -1, 0])
    mbs.Assemble()
    return mbs, beam


def test_advice_for_hanging_bodies_works() -> None:
    """tan(angle) = - F a / (h (F + m g)): the error names the settings, which find it."""
    mbs, beam = balance()
    settings = quiet()
    with pytest.raises(
        exu.SolverError, match="numberOfLoadSteps = 20 and staticSolver.stabilizerODE2term = 1"
    ) as error:
        mbs.SolveStatic(settings)
    assert any("stabilizerODE2term" in text for text in error.value.advice)
    settings.staticSolver.numberOfLoadSteps, settings.staticSolver.stabilizerODE2term = 20, 1
    assert mbs.SolveStatic(settings)
    angle = mbs.GetObjectOutputBody(beam, exu.OutputVariableType.Rotation, [0, 0, 0])[2]
    assert angle == pytest.approx(np.arctan2(-0.4, 0.1 * (1 + 2.5 * 9.81)), rel=1e-7)


def test_a_stabilizer_without_load_steps_is_named() -> None:
    mbs, _ = balance()
    settings = quiet()
    settings.staticSolver.stabilizerODE2term = 1
    with (
        pytest.warns(UserWarning, match="stabilizerODE2term has no effect with a single load step"),
        pytest.raises(exu.SolverError),
    ):
        mbs.SolveStatic(settings)
