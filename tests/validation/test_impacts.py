"""A ball that hits the groove of a torus, against the first integral of the law of impact."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq
from solving import new_system, settings

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert.utilities import InertiaSphere

MASS, SPEED, RADIUS, CLEARANCE = 0.2, 1.5, 0.05, 0.01
VELOCITY = exu.OutputVariableType.Velocity


def rebound(friction: float = 0.0, **law: float) -> np.ndarray:
    """Velocity after the impact of a ball that flies outwards in the plane of the torus."""
    mbs = new_system()
    ball = mbs.CreateRigidBody(
        referencePosition=[1, 0, 0], initialVelocity=[SPEED, 0, 0], inertia=InertiaSphere(MASS, RADIUS)
    )
    markers = [mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body)) for body in (ball, mbs.CreateGround())]
    data = mbs.AddNode(eii.NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[CLEARANCE, 0, 0, 0]))
    mbs.AddObject(
        eii.ObjectContactSphereTorus(
            markerNumbers=markers, nodeNumber=data, radiusSphere=RADIUS, torusMajorRadius=1.0,
            torusMinorRadius=RADIUS + CLEARANCE, torusAxis=[0, 0, 1], contactStiffness=1e6, dynamicFriction=friction, **law,
        )
    )  # fmt: skip
    mbs.Assemble()
    s = settings(0.02, 8000, spectral_radius=1.0)
    s.timeIntegration.discontinuous.iterationTolerance = 1e-5
    mbs.SolveDynamic(s)
    return np.array(mbs.GetObjectOutputBody(ball, VELOCITY, [0, 0, 0]))


@pytest.mark.parametrize(
    ("model", "restitution", "exponent"), [(0, 1.0, 1.0), (1, 0.9, 1.5), (2, 0.6, 1.0), (2, 0.3, 1.5)]
)
def test_speed_after_an_impact(model: int, restitution: float, exponent: float) -> None:
    """m v dv = -k d^n (1 + chi v) dd: the integral of v / (1 + chi v) from the speed before to rest is that from rest to the
    speed after, for any power n. The force at the end of the contact ends within a step, of 1/200 of the impact."""
    e = restitution
    loss = {0: 0.0, 1: 1.5 * (1 - e)}.get(
        model, 1.5 * (1 - e) * (11 - e) / (1 + 9 * e) if e > 1 / 3 else (1 - e * e) / e
    )
    after = SPEED
    if loss:
        chi = loss / SPEED
        integral = lambda v: v / chi - np.log1p(chi * v) / chi**2  # noqa: E731
        after = brentq(lambda v: integral(-v) - integral(SPEED), 1e-6, min(SPEED, 0.999 / chi))
    velocity = rebound(impactModel=model, restitutionCoefficient=e, contactStiffnessExponent=exponent)
    np.testing.assert_allclose(velocity, [-after, 0, 0], atol=2e-3)
    assert after / SPEED == pytest.approx(e, abs=0.03)  # the published laws approximate the coefficient
