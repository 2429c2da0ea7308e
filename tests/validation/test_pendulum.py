"""IFToMM benchmark A01: a simple pendulum of 1 m that starts horizontally; references by elliptic functions."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.special import ellipj, ellipk
from solving import Variable, new_system, orders, settings

import dalembert as exu

GRAVITY = 9.81
PERIOD = 2.3678419475762373
PUBLISHED = {
    1: (0.986291751132, -0.165010853126),
    2: (-0.793566195343, -0.608483930444),
    5: (-0.942305435044, -0.334754338414),
    10: (-0.275087462576, -0.961419205099),
}
STRETCHES = {"NodeRigidBodyEP", "NodeRigidBodyRxyz", "NodeRigidBodyRotVecLG"}


def exact(t: float) -> np.ndarray:
    """Start from rest at the left: sin(angle / 2) = k cd(omega t), with the modulus k = sin(45 deg)."""
    m, omega = 0.5, np.sqrt(GRAVITY)
    sn, _, _, _ = ellipj(omega * t + ellipk(m), m)
    half = np.arcsin(np.sqrt(m) * sn)
    return np.array([-np.sin(2 * half), -np.cos(2 * half)])


def point_mass() -> tuple[Any, Any]:
    mbs = new_system()
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[-1, 0]))
    mbs.AddObject(exu.MassPoint2D(physicsMass=1, nodeNumber=node))
    pivot = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    end = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    mbs.AddObject(exu.DistanceConstraint(markerNumbers=[pivot, end], distance=1))
    mbs.AddLoad(exu.Force(markerNumber=end, loadVector=[0, -GRAVITY, 0]))
    mbs.Assemble()
    return mbs, lambda: mbs.GetNodeOutput(node, Variable.Position)[:2]


def rod(node_type: str) -> tuple[Any, Any]:
    """A body with the same motion: mass 1 at 0.5 m from the pivot, inertia 0.25, so that (J + m s^2) / (m s) = 1 m."""
    mbs = new_system()
    start: list[float] = [-0.5, 0, 0]
    start += {"NodeRigidBodyEP": [1, 0, 0, 0], "NodeRigidBody2D": []}.get(node_type, [0, 0, 0])
    node = mbs.AddNode(getattr(exu, node_type)(referenceCoordinates=start))
    if node_type == "NodeRigidBody2D":
        body = mbs.AddObject(exu.RigidBody2D(physicsMass=1, physicsInertia=0.25, nodeNumber=node))
    else:
        inertia = [0.1, 0.2, 0.25, 0, 0, 0]
        body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=inertia, nodeNumber=node))
    ground = mbs.AddObject(exu.ObjectGround())
    kind = exu.MarkerBodyPosition if node_type == "NodeRigidBody2D" else exu.MarkerBodyRigid
    pivot = mbs.AddMarker(kind(bodyNumber=ground))
    end = mbs.AddMarker(kind(bodyNumber=body, localPosition=[0.5, 0, 0]))
    joint = exu.RevoluteJoint2D if node_type == "NodeRigidBody2D" else exu.RevoluteJointZ
    mbs.AddObject(joint(markerNumbers=[pivot, end]))
    mass = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(exu.Gravity(markerNumber=mass, loadVector=[0, -GRAVITY, 0]))
    mbs.Assemble()
    return mbs, lambda: mbs.GetObjectOutputBody(body, Variable.Position, [-0.5, 0, 0])[:2]


MODELS = {"MassPoint2D": point_mass} | {
    name: (lambda name=name: rod(name)) for name in (*sorted(STRETCHES), "NodeRigidBody2D")
}


def test_published_values() -> None:
    """The published digits, and the period, are those of the elliptic functions."""
    for t, position in PUBLISHED.items():
        np.testing.assert_allclose(exact(t), position, rtol=0, atol=1e-11)
    np.testing.assert_allclose(exact(PERIOD), [-1, 0], rtol=0, atol=1e-12)


@pytest.mark.parametrize("model", MODELS.values(), ids=MODELS)
def test_second_order(model: Any) -> None:
    def error(steps: int) -> np.ndarray:
        mbs, position = model()
        mbs.SolveDynamic(settings(2.0, steps))
        return position() - exact(2.0)

    for order in orders(error, [400, 800, 1600]):
        assert order == pytest.approx(2, abs=0.1)


@pytest.mark.parametrize("model", MODELS.values(), ids=MODELS)
@pytest.mark.parametrize("index2", [False, True], ids=["index3", "index2"])
def test_ten_seconds(model: Any, index2: bool) -> None:
    """Phase errors are (omega h)^2 / 12 per radian: 1.6e-6 times 27 rad where omega = 4.4/s is the highest angular velocity and
    h = 1 ms, 4e-5 in all; numerical damping, with other constants, adds up to four times as much."""
    mbs, position = model()
    s = settings(10.0, 10000, spectral_radius=1.0 if index2 else 0.9)
    s.timeIntegration.generalizedAlpha.useIndex2Constraints = index2
    s.timeIntegration.generalizedAlpha.useNewmark = index2
    mbs.SolveDynamic(s)
    error = np.linalg.norm(position() - np.array(PUBLISHED[10]))
    assert 1e-7 < error < 2e-4
