"""Contacts of few steps: those that add energy cause a warning, others do not; and contact that begins where a step
begins."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import dynamic_settings

import dalembert as exu
import dalembert.itemInterface as items
from dalembert.rigidBodyUtilities import InertiaSphere

Variable = exu.OutputVariableType
GAIN = "times as fast as they came"


def told(mbs: Any) -> list[str]:
    return [doubt for doubt in mbs.sys["dynamicSolver"].GetDoubts() if GAIN in doubt]


def between_stops(stiffness: float = 1e5, damping: float = 0.0, spring: float = 0.0) -> Any:
    """A mass of 1 kg with 1 m/s between stops, 0.2 m apart; pi sqrt(m/k) = 9.9 ms in contact."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddNode(items.NodePointGround())
    node = mbs.AddNode(items.Node1D(referenceCoordinates=[0], initialVelocities=[1.0]))
    mbs.AddObject(items.Mass1D(nodeNumber=node, physicsMass=1))
    markers = [mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, node)]
    data = mbs.AddNode(items.NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[0, 0, 0]))
    mbs.AddObject(
        items.CoordinateSpringDamperExt(
            name="stops",
            markerNumbers=markers,
            nodeNumber=data,
            stiffness=spring,
            useLimitStops=True,
            limitStopsUpper=0.1,
            limitStopsLower=-0.1,
            limitStopsStiffness=stiffness,
            limitStopsDamping=damping,
        )
    )
    mbs.Assemble()
    return mbs


def speed(mbs: Any) -> float:
    return abs(float(mbs.systemData.GetODE2Coordinates_t()[0]))


STEPS = [(step, radius) for step in (0.025, 0.01, 0.005) for radius in (0.6, 0.9, 1.0)]


@pytest.mark.parametrize(("step", "radius"), [*STEPS, (0.002, 0.9), (0.002, 1.0)])
def test_stops_that_add_energy(step: float, radius: float) -> None:
    """Half a step to five steps in contact: the energy grows by factors of 1.17 to 4000 within 10 s."""
    mbs = between_stops()
    settings = dynamic_settings(10.0, round(10 / step))
    settings.timeIntegration.generalizedAlpha.spectralRadius = radius
    result = mbs.SolveDynamic(settings)
    assert isinstance(result, exu.FinishedNotTrusted)
    (doubt,) = told(mbs)
    assert "'stop' of object 1 'stops'" in doubt and "Use more than 6 steps per contact" in doubt


@pytest.mark.parametrize("radius", [0.6, 0.9, 1.0])
@pytest.mark.parametrize("step", [1e-3, 5e-4])
def test_fine_steps_are_trusted(step: float, radius: float) -> None:
    """Ten steps in contact keep the energy within 0.3 percent."""
    mbs = between_stops()
    settings = dynamic_settings(10.0, round(10 / step))
    settings.timeIntegration.generalizedAlpha.spectralRadius = radius
    assert mbs.SolveDynamic(settings) is True
    assert speed(mbs) < 1.0015


def test_damped_stops_are_trusted() -> None:
    """Few steps in contact, but contact takes more energy than the steps add."""
    mbs = between_stops(damping=200.0)
    assert mbs.SolveDynamic(dynamic_settings(2.0, 500)) is True
    assert speed(mbs) < 1


@pytest.mark.parametrize("step", [1e-3, 1e-4])
def test_a_spring_that_shoots_is_trusted(step: float) -> None:
    """A mass between soft springs leaves stops as fast as it came; pressed against a stop at the start, it leaves faster."""
    mbs = between_stops(spring=300.0)
    mbs.systemData.SetODE2Coordinates([-0.101], exu.ConfigurationType.Initial)
    mbs.systemData.SetODE2Coordinates_t([0.0], exu.ConfigurationType.Initial)
    assert mbs.SolveDynamic(dynamic_settings(2.0, round(2 / step))) is True


@pytest.mark.parametrize("restitution", [1.0, 0.5])
def test_a_sphere_strikes_a_hollow_sphere(restitution: float) -> None:
    """Steps that end where contact begins go on: 2 m/s come back, or the part of an impact law.

    The impact takes 2000 steps, whose error of second order is below 1e-6. Hunt and Crossley's law with 0.5 returns 0.66.
    """
    radius, mass, stiffness, v, duration, steps = 0.1, 1.6, 1e8, 2.0, 0.00213322599820577, 2000
    h = duration / steps
    u = np.array([-2, 1, -2]) / 3
    mbs = exu.SystemContainer().AddSystem()
    body = mbs.CreateRigidBody(
        referencePosition=list(-(1 - radius - 20.5 * h * v) * u),
        initialVelocity=list(-v * u),
        inertia=InertiaSphere(mass, radius),
    )
    marker = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=body))
    ground = mbs.AddMarker(items.MarkerNodeRigid(nodeNumber=mbs.AddNode(items.NodePointGround())))
    data = mbs.AddNode(items.NodeGenericData(initialCoordinates=[0.1, 0, 0, 0], numberOfDataCoordinates=4))
    contact = mbs.AddObject(
        items.ObjectContactSphereSphere(
            markerNumbers=[marker, ground],
            nodeNumber=data,
            spheresRadii=[radius, 1],
            isHollowSphere1=True,
            contactStiffness=stiffness,
            contactStiffnessExponent=1.5,
            impactModel=1,
            restitutionCoefficient=restitution,
        )
    )
    force = mbs.AddSensor(
        items.SensorObject(objectNumber=contact, outputVariableType=Variable.Force, storeInternal=True)
    )
    mbs.Assemble()
    settings = dynamic_settings(1.1 * duration + 20 * h, int(1.1 * steps + 20))
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1.0
    settings.solutionSettings.sensorsWritePeriod = h
    assert mbs.SolveDynamic(settings) is True
    leaves = float(mbs.GetObjectOutputBody(body, Variable.Velocity) @ u)
    if restitution == 1:
        assert leaves == pytest.approx(v, rel=1e-6)
        largest = np.linalg.norm(mbs.GetSensorStoredData(force)[:, 1:], axis=1).max()
        # Hertz: F = k (5 m v^2 / (4 k))^(3/5)
        assert largest == pytest.approx(stiffness * (5 * mass * v**2 / (4 * stiffness)) ** 0.6, rel=1e-5)
    else:
        assert 0.6 * v < leaves < 0.7 * v
