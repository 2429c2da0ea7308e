"""Equal steps of generalized alpha across constraints that turn: velocities stay right, or the solution says that the steps are too coarse.

The speeds below differ from the exact ones by factors of 10 to 1000 in all cases but the finest steps if velocities
have no lead (docs/theory/constrained_steps.rst).
"""

from __future__ import annotations

import os
import tempfile
from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings

import dalembert as exu
from dalembert.utilities import (
    CoordinateConstraint,
    InertiaCuboid,
    MarkerBodyPosition,
    MarkerNodeCoordinate,
    NodePoint,
    NodePointGround,
    ObjectMassPoint,
    RevoluteJoint2D,
    RigidBodyInertia,
    SensorBody,
)

Variable = exu.OutputVariableType
GRAVITY = 9.81


def settings_of(end: float, steps: int, rho: float = 0.9) -> Any:
    settings = dynamic_settings(end, steps)
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = rho
    settings.solutionSettings.sensorsWritePeriod = end / steps
    return settings


def solved(mbs: Any, settings: Any, **more: Any) -> list[str]:
    """The doubts about a solution that has to succeed."""
    result = mbs.SolveDynamic(settings, **more)
    assert result
    return list(getattr(result, "doubts", ()))


# ---- a mass on a circle: the speed is constant -------------------------------------------------------------------------

OMEGA = 40.0
NODES = {
    "rotation vector": exu.NodeType.RotationRotationVector,
    "Tait-Bryan": exu.NodeType.RotationRxyz,
    "Euler parameters": exu.NodeType.RotationEulerParameters,
}


def stone(kind: str, joints: int = 1) -> tuple[Any, int]:
    """Radius 1 m, 40 m/s, without forces; returns the system and the sensor of the velocity."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    velocity: dict[str, Any] = {"referencePosition": [1, 0, 0], "initialVelocity": [0, OMEGA, 0]}
    spin: dict[str, Any] = {
        "inertia": InertiaCuboid(1000, [0.2, 0.1, 0.1]),
        "initialAngularVelocity": [0, 0, OMEGA],
        **velocity,
    }
    if kind == "point":
        body = mbs.CreateMassPoint(physicsMass=1, **velocity)
        for _ in range(joints):
            mbs.CreateDistanceConstraint(bodyNumbers=[ground, body], distance=1.0)
    elif kind == "two points":
        inner = mbs.CreateMassPoint(referencePosition=[0.5, 0, 0], initialVelocity=[0, OMEGA / 2, 0], physicsMass=1)
        body = mbs.CreateMassPoint(physicsMass=2, **velocity)
        mbs.CreateDistanceConstraint(bodyNumbers=[ground, inner], distance=0.5)
        mbs.CreateDistanceConstraint(bodyNumbers=[inner, body], distance=0.5)
    else:
        body = mbs.CreateRigidBody(
            **spin, **({"create2D": True} if kind == "planar" else {"nodeType": NODES[kind.removesuffix(", ball")]})
        )
        for k in range(joints):
            if kind.endswith("ball"):
                mbs.CreateSphericalJoint(bodyNumbers=[ground, body], position=[0, 0, 0])
            else:
                mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0.1 * k], axis=[0, 0, 1])
    speed = mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.Velocity, storeInternal=True))
    mbs.Assemble()
    return mbs, speed


def error_of_speed(mbs: Any, sensor: int) -> float:
    velocities = mbs.GetSensorStoredData(sensor)[:, 1:]
    return float(abs(np.linalg.norm(velocities, axis=1) - OMEGA).max())


@pytest.mark.parametrize("rho", [0.6, 0.9, 0.95, 1.0])
@pytest.mark.parametrize(
    "kind", ["point", "two points", "planar", *NODES, "rotation vector, ball", "Euler parameters, ball"]
)
def test_speed_on_a_circle(kind: str, rho: float) -> None:
    """20 revolutions with 40 steps each. Smaller radii damp more: 0.6 loses 0.02 m/s at 0.063 rad per step, and 20 times as much here."""
    mbs, speed = stone(kind)
    assert solved(mbs, settings_of(np.pi, 800, rho)) == []
    error = error_of_speed(mbs, speed)
    assert error < (0.5 if rho == 0.6 else 0.05)


def test_fine_steps_keep_their_velocities() -> None:
    """100 steps per revolution are stable: the constraint keeps its free velocity, which alternates and stays small."""
    mbs, _ = stone("point")
    assert solved(mbs, settings_of(np.pi, 2000)) == []
    q, v = mbs.systemData.GetODE2Coordinates() + [1, 0, 0], mbs.systemData.GetODE2Coordinates_t()
    assert 0 < abs(q @ v) < 0.1


@pytest.mark.parametrize("kind", ["point", "planar", "rotation vector", "Euler parameters"])
def test_redundant_joints(kind: str) -> None:
    """Two hinges, or two rods in one place."""
    mbs, speed = stone(kind, joints=2)
    assert solved(mbs, settings_of(np.pi, 800)) == []
    assert error_of_speed(mbs, speed) < 0.05


@pytest.mark.parametrize("rho", [0.9, 1.0])
def test_modified_newton(rho: float) -> None:
    mbs, speed = stone("planar")
    settings = settings_of(np.pi, 800, rho)
    settings.timeIntegration.newton.useModifiedNewton = True
    assert solved(mbs, settings) == []
    assert error_of_speed(mbs, speed) < 0.05


def test_newmark_without_constraints_of_velocities() -> None:
    mbs, speed = stone("point")
    settings = settings_of(np.pi, 800)
    settings.timeIntegration.generalizedAlpha.useNewmark = True
    assert solved(mbs, settings) == []
    assert error_of_speed(mbs, speed) < 0.05


def test_steps_that_are_too_coarse_are_not_trusted() -> None:
    """Five steps per revolution."""
    mbs, _ = stone("point")
    (doubt,) = solved(mbs, settings_of(np.pi, 100))
    assert doubt.startswith("constraints turn too far in ") and "use smaller steps" in doubt


# ---- spin on Euler parameters: the angular velocity is constant, or that of a torsion pendulum --------------------------


def spin(spring: bool, steps: int, rho: float) -> tuple[float, list[str]]:
    """The largest error of the angular velocity within 20 revolutions, or for the spring 2 pi/2 rad/s in one period."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    inertia = RigidBodyInertia(mass=1, inertiaTensor=np.diag([0.01] * 3))
    body = mbs.CreateRigidBody(inertia=inertia, initialAngularVelocity=[0, 0, OMEGA])
    if spring:
        mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
        mbs.CreateTorsionalSpringDamper(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1], stiffness=0.04)
    sensor = mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.AngularVelocity, storeInternal=True))
    mbs.Assemble()
    doubts = solved(mbs, settings_of(np.pi, steps, rho))
    data = mbs.GetSensorStoredData(sensor)
    exact = OMEGA * np.cos(2 * data[:, 0]) if spring else OMEGA
    return float(abs(data[:, 3] - exact).max()), doubts


@pytest.mark.parametrize("rho", [0.9, 0.95, 1.0])
@pytest.mark.parametrize("steps", [400, 800])
def test_free_spin_on_euler_parameters(steps: int, rho: float) -> None:
    error, doubts = spin(False, steps, rho)
    assert error < 0.1 and doubts == []


@pytest.mark.parametrize("rho", [0.9, 1.0])
def test_torsion_pendulum_on_euler_parameters(rho: float) -> None:
    """20 rad of amplitude; the error is that of the steps, and falls to a quarter."""
    coarse, _ = spin(True, 800, rho)
    fine, doubts = spin(True, 1600, rho)
    assert doubts == [] and fine < 0.06 and 3 < coarse / fine < 5


# ---- pendulums: energy -------------------------------------------------------------------------------------------------


def links(number: int, first_angle: float, planar_body: bool = False) -> Any:
    mbs = exu.SystemContainer().AddSystem()
    previous = ground = mbs.CreateGround()
    direction = np.array([np.sin(first_angle), -np.cos(first_angle), 0])
    for k in range(number):
        place = list((k + 1) / number * direction)
        if planar_body:
            body = mbs.CreateRigidBody(
                referencePosition=place, inertia=InertiaCuboid(1000, [0.1] * 3), gravity=[0, -GRAVITY, 0]
            )
            mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
        else:
            body = mbs.CreateMassPoint(referencePosition=place, physicsMass=1, gravity=[0, -GRAVITY, 0])
            mbs.CreateDistanceConstraint(bodyNumbers=[previous, body], distance=1 / number)
        previous = body
    mbs.Assemble()
    return mbs


def error_of_energy(mbs: Any, settings: Any, **more: Any) -> tuple[float, list[str]]:
    """The largest one at the ends of steps, in J."""
    with tempfile.TemporaryDirectory() as folder:
        settings.solutionSettings.writeSolutionToFile = True
        settings.solutionSettings.coordinatesSolutionFileName = os.path.join(folder, "solution.txt")
        settings.solutionSettings.solutionWritePeriod = settings.solutionSettings.sensorsWritePeriod
        doubts = solved(mbs, settings, **more)
        found = mbs.InspectSolution(settings.solutionSettings.coordinatesSolutionFileName)
    return float(abs(found.supplied).max()), doubts


@pytest.mark.parametrize("step", [0.05, 0.04, 0.03, 0.025])
@pytest.mark.parametrize("planar_body", [False, True])
def test_pendulum_from_horizontal(step: float, planar_body: bool) -> None:
    """48 to 96 steps per period. The scheme itself loses 0.005 m g l at 25 ms, which grows with the square of the step."""
    error, doubts = error_of_energy(links(1, np.pi / 2, planar_body), settings_of(20.0, round(20 / step)))
    assert doubts == []
    assert error / GRAVITY < 0.012 * (step / 0.025) ** 2


@pytest.mark.parametrize("step", [0.05, 0.1])
def test_pendulum_from_60_degrees(step: float) -> None:
    error, doubts = error_of_energy(links(1, np.pi / 3), settings_of(20.0, round(20 / step)))
    assert error / GRAVITY < 0.1 if doubts == [] else error / GRAVITY < 0.5


def test_double_pendulum_that_whips_is_not_trusted() -> None:
    """15 steps in the period of the single pendulum: the energy is off by more than a tenth."""
    period = 2 * np.pi * np.sqrt(1 / GRAVITY) * 1.18
    error, doubts = error_of_energy(links(2, np.pi / 2), settings_of(8 * period, 240))
    assert error / (2 * GRAVITY) > 0.05
    assert any(d.startswith("constraints turn too far") for d in doubts)
    error, doubts = error_of_energy(links(2, np.pi / 2), settings_of(8 * period, 8 * 400))
    assert error / (2 * GRAVITY) < 0.02 and doubts == []


def heavy_end(ratio: float) -> Any:
    """Ten planar links, and a heavy mass at the end."""
    mbs = exu.SystemContainer().AddSystem()
    previous = mbs.CreateGround()
    links, mass = 10, 0.01
    size = 1 / links
    for i in range(links):
        inertia = RigidBodyInertia(mass=mass, inertiaTensor=np.eye(3) * mass * size**2 / 12)
        body = mbs.CreateRigidBody(
            referencePosition=[(i + 0.5) * size, 0, 0], inertia=inertia, gravity=[0, -GRAVITY, 0], create2D=True
        )
        ends = [(previous, size / 2 if i else 0.0), (body, -size / 2)]
        mbs.AddObject(
            RevoluteJoint2D(
                markerNumbers=[
                    mbs.AddMarker(MarkerBodyPosition(bodyNumber=b, localPosition=[x, 0, 0])) for b, x in ends
                ]
            )
        )
        previous = body
    load = mbs.CreateMassPoint(
        referencePosition=[1, 0, 0], physicsMass=0.1 * ratio, gravity=[0, -GRAVITY, 0], create2D=True
    )
    ends = [(previous, size / 2), (load, 0.0)]
    mbs.AddObject(
        RevoluteJoint2D(
            markerNumbers=[mbs.AddMarker(MarkerBodyPosition(bodyNumber=b, localPosition=[x, 0, 0])) for b, x in ends]
        )
    )
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("rho", [0.8, 0.9])
@pytest.mark.parametrize("ratio", [1e3, 1e6])
def test_heavy_mass_on_a_light_chain(ratio: float, rho: float) -> None:
    error, doubts = error_of_energy(heavy_end(ratio), settings_of(1.0, 1000, rho))
    assert error / (0.1 * ratio * GRAVITY) < 1e-3 and doubts == []


@pytest.mark.parametrize("kind", ["rotation vector", "Euler parameters"])
def test_heavy_top(kind: str) -> None:
    """A top that spins with 150 rad/s, 1 ms: its kinetic energy is 5.3 kJ."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    top = mbs.CreateRigidBody(
        referencePosition=[0, 1, 0], initialVelocity=[4.61538, 0, 0], initialAngularVelocity=[0, 150, -4.61538],
        inertia=RigidBodyInertia(15, np.diag([0.234375, 0.46875, 0.234375])), gravity=[0, 0, -GRAVITY], nodeType=NODES[kind],
    )  # fmt: skip
    mbs.CreateSphericalJoint(bodyNumbers=[ground, top], position=[0, 0, 0])
    mbs.Assemble()
    error, doubts = error_of_energy(mbs, settings_of(0.5, 500))
    assert error / 5.3e3 < 1e-3 and doubts == []


# ---- drives, switches, restart
# -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("by", ["function", "parameter"])
def test_driven_constraints_keep_their_velocity(by: str) -> None:
    """A constraint that moves has a velocity across it, which is no error of the scheme, whether a user function or a parameter moves it."""

    def offset(mbs: Any, t: float, item: int, value: float) -> float:
        return float(t - np.sin(t))

    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    body = mbs.CreateMassPoint(referencePosition=[1, 0, 0], initialVelocity=[0, OMEGA, 0], physicsMass=1)
    mbs.CreateDistanceConstraint(bodyNumbers=[ground, body], distance=1.0)
    node = mbs.AddNode(NodePoint())
    mbs.AddObject(ObjectMassPoint(nodeNumber=node, physicsMass=1))
    markers = [
        mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (mbs.AddNode(NodePointGround()), node)
    ]
    driven = mbs.AddObject(
        CoordinateConstraint(markerNumbers=markers, **({"offsetUserFunction": offset} if by == "function" else {}))
    )
    speed = mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.Velocity, storeInternal=True))
    mbs.Assemble()
    if by == "parameter":

        def set_offset(mbs: Any, t: float) -> bool:
            mbs.SetObjectParameter(driven, "offset", float(t - np.sin(t)))
            return True

        mbs.SetPreStepUserFunction(set_offset)
    settings = settings_of(np.pi, 800 if by == "function" else 2000)
    assert solved(mbs, settings) == []
    q = mbs.systemData.GetODE2Coordinates()[3]
    v = mbs.systemData.GetODE2Coordinates_t()[3]
    assert q == pytest.approx(np.pi, abs=1e-9) and v == pytest.approx(2.0, abs=1e-3)
    assert error_of_speed(mbs, speed) < 0.05


def test_oscillation_that_cannot_be_corrected_is_not_trusted() -> None:
    """A function that changes a constraint in each step prescribes a velocity that the solver cannot know."""
    mbs, _ = stone("point")

    def set_length(mbs: Any, t: float) -> bool:
        mbs.SetObjectParameter(2, "distance", 1.0)
        return True

    mbs.SetPreStepUserFunction(set_length)
    doubts = solved(mbs, settings_of(np.pi / 4, 200))
    assert any(d.startswith("velocities across constraints oscillate") and "TrapezoidalIndex2" in d for d in doubts)


def test_going_on_from_a_restart_file_has_the_same_bits() -> None:
    settings = settings_of(np.pi, 800)
    solution = settings.solutionSettings
    solution.writeRestartFile, solution.restartFileName, solution.restartWritePeriod = True, "restart.txt", 1.0
    mbs, _ = stone("point")
    solved(mbs, settings)
    whole = [
        mbs.systemData.GetODE2Coordinates(),
        mbs.systemData.GetODE2Coordinates_t(),
        mbs.systemData.GetAECoordinates(),
    ]
    os.replace("restart.txt.bck", "middle.txt")
    again = settings_of(np.pi, 800)
    again.continuation.restartFileName = "middle.txt"
    again.solutionSettings.writeRestartFile = True
    again.solutionSettings.restartFileName, again.solutionSettings.restartWritePeriod = "other.txt", 1.0
    mbs, _ = stone("point")
    solved(mbs, again)
    continued = [
        mbs.systemData.GetODE2Coordinates(),
        mbs.systemData.GetODE2Coordinates_t(),
        mbs.systemData.GetAECoordinates(),
    ]
    for a, b in zip(whole, continued, strict=True):
        np.testing.assert_array_equal(a, b)
