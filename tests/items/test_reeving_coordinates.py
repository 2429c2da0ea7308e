"""Ropes whose ends are wound up: coordinates that make them longer, and the generalized forces on these."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.testing.tangents import WEIGHTS, differences

FACTORS, LENGTH, STIFFNESS, DAMPING = [0.3, -0.7], 1.2, 500.0, 20.0
AT, VELOCITY = np.array([[0.0, 0, 0], [2.0, 0.5, 0.3]]), np.array([[0.2, -0.1, 0.4], [0.7, 0.3, -0.2]])
WOUND, RATES = np.array([0.4, -0.5]), np.array([1.1, 0.8])


def rope() -> tuple[Any, Any, list[Any]]:
    """Rope between two points, without sheaves, with two winches; the connector, and the first coordinates of points
    and winches."""
    mbs = exu.SystemContainer().AddSystem()
    markers, nodes = [], []
    for position, velocity in zip(AT, VELOCITY, strict=True):
        body = mbs.CreateRigidBody(
            referencePosition=position, initialVelocity=velocity, inertia=exu.utilities.InertiaSphere(1, 0.1)
        )
        markers.append(mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body)))
        nodes.append(mbs.GetObject(body)["nodeNumber"])
    for angle, rate in zip(WOUND, RATES, strict=True):
        nodes.append(mbs.AddNode(exu.Node1D(initialCoordinates=[angle], initialVelocities=[rate])))
        mbs.AddObject(exu.Mass1D(physicsMass=1, nodeNumber=nodes[-1]))
        markers.append(mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=nodes[-1], coordinate=0)))
    number = mbs.AddObject(
        exu.ReevingSystemSprings(
            markerNumbers=markers, hasCoordinateMarkers=True, coordinateFactors=FACTORS, referenceLength=LENGTH,
            stiffnessPerLength=STIFFNESS, dampingPerLength=DAMPING, sheavesRadii=[0, 0],
            sheavesAxes=exu.Vector3DList([[0, 0, 1], [0, 0, 1]]),
        )
    )  # fmt: skip
    mbs.Assemble()
    return mbs, number, [mbs.GetNodeODE2Index(node) for node in nodes]


def test_winches_make_the_rope_longer() -> None:
    """f = (k (l - l0 - sum c q) + d (l' - sum c q')) / (l0 + sum c q) pulls the points together, and turns winches by c f."""
    mbs, number, first = rope()
    span, closing = AT[1] - AT[0], VELOCITY[1] - VELOCITY[0]
    distance = np.linalg.norm(span)
    along = span / distance
    own, own_rate = LENGTH + np.dot(FACTORS, WOUND), np.dot(FACTORS, RATES)
    force = (STIFFNESS * (distance - own) + DAMPING * (along @ closing - own_rate)) / own
    assert mbs.GetObjectOutput(number, exu.OutputVariableType.ForceLocal) == pytest.approx(force, rel=1e-13)
    r = testing.residual(mbs, testing.State(mbs))
    for node, sign in zip(first[:2], (-1, 1), strict=True):
        np.testing.assert_allclose(r[node : node + 3], sign * force * along, rtol=0, atol=1e-11 * force)
    np.testing.assert_allclose([r[node] for node in first[2:]], -force * np.array(FACTORS), rtol=1e-12)


@pytest.mark.parametrize("weights", WEIGHTS)
def test_tangent(weights: str) -> None:
    """Differences of second order, extrapolated, leave 1e-7 of the largest entry."""
    mbs, _, _ = rope()
    s = testing.State(mbs)
    tangent = testing.tangent(mbs, s, **WEIGHTS[weights])
    fine, coarse = (differences(mbs, s, WEIGHTS[weights], h) for h in (1e-4, 2e-4))
    wanted = fine + (fine - coarse) / 3
    np.testing.assert_allclose(tangent, wanted, rtol=0, atol=1e-7 * np.abs(wanted).max())
