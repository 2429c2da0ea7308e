"""Discs in steady rolling, a rack of balls, a ball that bounces for ever: numbers from closed forms and independent integration."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from solving import Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import RigidBodyInertia
from dalembert.utilities import InertiaSphere

G = 9.81


def disc(
    centre: np.ndarray, axis: np.ndarray, omega: np.ndarray, mass: float = 1.0, radius: float = 0.1
) -> tuple[exu.MainSystem, int]:
    """A thin disc that rolls on the plane z = 0 without slip; the centre is above its lowest point."""
    mbs = new_system()
    lower = (axis * axis[2] - [0, 0, 1]) / np.sqrt(1 - axis[2] ** 2)
    aside = np.cross([0, 0, 1], axis)
    aside /= np.linalg.norm(aside)
    body = mbs.CreateRigidBody(
        referencePosition=centre, referenceRotationMatrix=np.stack([axis, aside, np.cross(axis, aside)], axis=1),
        initialVelocity=np.cross(omega, -radius * lower), initialAngularVelocity=omega,
        inertia=RigidBodyInertia(mass=mass, inertiaTensor=mass * radius**2 * np.diag([0.5, 0.25, 0.25])),
        gravity=[0, 0, -G], nodeType=exu.NodeType.RotationEulerParameters,
    )  # fmt: skip
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (mbs.CreateGround(), body)]
    mbs.AddObject(exu.ObjectJointRollingDisc(markerNumbers=markers, discRadius=radius))
    mbs.Assemble()
    return mbs, body


def steady(tilt: float, circle: float, radius: float = 0.1) -> tuple[float, np.ndarray, np.ndarray, np.ndarray]:
    """Rate of turning in steady rolling, and centre, axis and angular velocity at its start.

    Moments about the contact, with J = m r^2 / 4 across and m r^2 / 2 along the axis:
    W^2 = m r g cos(tilt) / (sin(tilt) (J cos(tilt) + 2 J R / r + m r R)).
    """
    s, c = np.sin(tilt), np.cos(tilt)
    across, along = radius**2 / 4, radius**2 / 2
    turning = np.sqrt(radius * G * c / (s * (across * c + along * circle / radius + radius * circle)))
    axis = np.array([-s, 0, -c])
    spin = turning * circle / radius
    omega = spin * axis + turning * (np.array([0, 0, 1]) + c * axis)
    return turning, np.array([circle, 0, radius * s]), axis, omega


def test_rates_of_steady_rolling() -> None:
    """The formula against figures that were computed elsewhere, with an integration that returns to 9 decimals."""
    for tilt, circle, turning in ((60, 0.5, 2.72542519245574), (80, 1.0, 1.07231088281041)):
        assert steady(np.radians(tilt), circle)[0] == pytest.approx(turning, rel=1e-13)
    np.testing.assert_allclose(steady(np.radians(60), 0.5)[3], [-12.98158099, 0, -4.76949409], atol=5e-9)


@pytest.mark.parametrize(("tilt", "circle"), [(60, 0.5), (80, 1.0)])
def test_steady_rolling_returns_after_one_turn(tilt: float, circle: float) -> None:
    """The trapezoidal rule is late by (w h)^2 / 12 with the spin w, that is up to 2 pi R times as much, or 1e-4 m, and a quarter with twice the steps."""
    turning, centre, axis, omega = steady(np.radians(tilt), circle)
    errors = []
    for steps in (1000, 2000):
        mbs, body = disc(centre, axis, omega)
        mbs.SolveDynamic(
            settings(2 * np.pi / turning, steps), solverType=exu.DynamicSolverType.TrapezoidalIndex2
        )  # fmt: skip
        errors.append(np.linalg.norm(np.asarray(mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0])) - centre))
    step = 2 * np.pi / turning / 1000
    bound = 2 * np.pi * circle * (np.linalg.norm(omega) * step) ** 2 / 12
    assert errors[0] < 4 * bound
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)


def test_transient_rolling() -> None:
    """A disc that starts with a tilt of 15 degrees: its centre after 1 s, extrapolated from two solutions of second order."""
    radius, angle = 0.1, np.radians(15)
    axis = np.array([np.cos(angle), 0, np.sin(angle)])
    lower = (axis * axis[2] - [0, 0, 1]) / np.sqrt(1 - axis[2] ** 2)
    places = []
    for steps in (1000, 2000):
        mbs, body = disc(-radius * lower, axis, np.array([-12, 0, 1.5]))
        mbs.SolveDynamic(settings(1.0, steps), solverType=exu.DynamicSolverType.TrapezoidalIndex2)
        places.append(np.asarray(mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0])))
    expected = [-0.285875159, 1.077928174, 0.099927526]
    np.testing.assert_allclose((4 * places[1] - places[0]) / 3, expected, rtol=0, atol=2e-7)
    assert np.linalg.norm(places[0] - expected) > 1e-6


def test_a_ball_breaks_a_rack() -> None:
    """Six balls in rows of 1, 2 and 3, with gaps of 1 mm, and a seventh that hits them aside: f = 1e5 d^1.5, no friction, no gravity.

    The reference was integrated independently, to 1e-8.
    """
    mbs = new_system()
    places = [[-0.3, 0.013, 0.0]]
    places += [[0.101 * row * np.sqrt(3) / 2, 0.101 * (c - row / 2), 0.0] for row in range(3) for c in range(row + 1)]
    balls = [
        mbs.CreateRigidBody(
            referencePosition=p, initialVelocity=[2, 0, 0] if i == 0 else [0, 0, 0], inertia=InertiaSphere(0.5, 0.05),
            nodeType=exu.NodeType.RotationRotationVector,
        )
        for i, p in enumerate(places)
    ]  # fmt: skip
    for pair in itertools.combinations(balls, 2):
        mbs.CreateSphereSphereContact(
            bodyNumbers=list(pair), spheresRadii=[0.05, 0.05], contactStiffness=1e5, contactStiffnessExponent=1.5,
            contactDamping=0, impactModel=0,
        )  # fmt: skip
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.5, 10000), solverType=exu.DynamicSolverType.RK44)

    def plane(i: int, variable: exu.OutputVariableType) -> np.ndarray:
        return np.asarray(mbs.GetObjectOutputBody(balls[i], variable, [0, 0, 0]))[:2]

    # remaining error of fourth order for forces of d^1.5, at the two ends of nine impacts in 5e-5 s
    tolerance = 2e-6
    np.testing.assert_allclose(plane(0, Variable.Position), [-0.13576660, 0.14751533], atol=tolerance)
    np.testing.assert_allclose(plane(0, Variable.Velocity), [-0.14199197, 0.34569608], atol=10 * tolerance)
    np.testing.assert_allclose(plane(1, Variable.Position), [-0.06540317, -0.04455175], atol=tolerance)
    np.testing.assert_allclose(plane(4, Variable.Position), [0.67227823, -0.37991557], atol=tolerance)
    np.testing.assert_allclose(plane(4, Variable.Velocity), [1.32791373, -0.74458233], atol=10 * tolerance)
    momentum = 0.5 * sum(plane(i, Variable.Velocity) for i in range(7))
    np.testing.assert_allclose(momentum, [1, 0], atol=1e-12)


def on_plate(
    position: list[float],
    velocity: list[float],
    gravity: list[float],
    stiffness: float,
    friction: float,
    mass: float,
    damping: float = 0.0,
) -> tuple[exu.MainSystem, int]:
    mbs = new_system()
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[friction]])
    contact.SetFrictionBristles(1.0)
    surface = {"contactStiffness": 2 * stiffness, "contactDamping": damping, "frictionMaterialIndex": 0}
    ground = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    corners = [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]]
    contact.AddTrianglesRigidBodyBased(ground, pointList=corners, triangleList=[[0, 1, 2], [0, 2, 3]], **surface)
    body = mbs.CreateRigidBody(
        referencePosition=position, initialVelocity=velocity, gravity=gravity, inertia=InertiaSphere(mass, 0.1),
        nodeType=exu.NodeType.RotationRotationVector,
    )  # fmt: skip
    contact.AddSphereWithMarker(mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body)), radius=0.1, **surface)
    mbs.Assemble()
    return mbs, body


def test_a_ball_bounces_for_ever() -> None:
    """An elastic plane, k = 1e6 N/m, and gravity: falls and half swings alternate, with a period of 0.642534714762 s; its gap after 2 s.

    Steps end where contact begins and ends, so that the order of the method holds: the sixth at least, with 40 steps of w h = 0.08 for each impact.
    """
    mbs, body = on_plate([0, 0, 0.6], [0, 0, 0], [0, 0, -G], 1e6, 0.0, 1.6)
    s = settings(2.0, 20000)
    s.events.ofItems = True
    mbs.SolveDynamic(s, solverType=exu.DynamicSolverType.RK67)
    height = mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0])[2]
    assert height - 0.1 == pytest.approx(0.4742921106, abs=1e-7)


def test_a_ball_slides_and_rolls_down_a_slope() -> None:
    """10 degrees, mu = 0.15, 2 m/s without spin: it rolls from 0.59373 s on, and is at 5.46033603 m after 2 s.

    It sinks by 1e-6 m, a 1e-5th of its radius, and with h = 0.1 ms begins to roll within a step: both are 1e-5 of the way at most. Damping ends the
    swing on the bristle that follows.
    """
    slope = np.radians(10)
    sink = G * np.cos(slope) / 1e7
    gravity = [G * np.sin(slope), 0, -G * np.cos(slope)]
    mbs, body = on_plate([0, 0.1, 0.1 - sink], [2, 0, 0], gravity, 1e7, 0.15, 1.0, damping=500)
    mbs.SolveDynamic(settings(2.0, 20000, 1.0, 1e-8), solverType=exu.DynamicSolverType.GeneralizedAlpha)
    assert mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0])[0] == pytest.approx(5.46033603, abs=1e-4)
    x = mbs.GetObjectOutputBody(body, Variable.Velocity, [0, 0, 0])[0]
    assert x == pytest.approx(2.15101243 + G * np.sin(slope) * 5 / 7 * (2 - 0.593732998513734), abs=1e-4)
