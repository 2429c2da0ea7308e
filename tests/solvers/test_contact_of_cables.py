"""General contact of planar cable elements with circles."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from test_general_contact import EXPLICIT, IMPLICIT, World

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert._core import testing

K, HALF = 1e5, 0.01
TYPES = exu.ContactTypeIndex


def cable(world: World, ends: Any, velocities: Any = ((0,) * 4,) * 2, damping: float = 0.0) -> Any:
    """An element between (x, y, slope x, slope y) and another one; returns its object."""
    nodes = [
        world.mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=list(end), initialVelocities=list(velocity)))
        for end, velocity in zip(ends, velocities, strict=True)
    ]
    body = world.mbs.AddObject(
        eii.ObjectANCFCable2D(
            nodeNumbers=nodes, physicsLength=1.0, physicsMassPerLength=1.0, physicsBendingStiffness=1.0, physicsAxialStiffness=1e4
        )
    )  # fmt: skip
    assert world.contact.AddANCFCable(body, HALF, 2 * K, damping, 0) >= 0
    return body


STRAIGHT = ((-0.5, 0, 1, 0), (0.5, 0, 1, 0))
CURVED = ((-0.45, -0.03, 0.9, 0.5), (0.5, 0.05, 1.1, -0.4))
RATES = ((0.1, 0.4, -0.2, 0.3), (-0.3, 0.2, 0.5, 0.1))


@pytest.mark.parametrize("depth", [1e-4, 4e-4])
def test_force_of_a_straight_cable(depth: float) -> None:
    """Pressure per length along the chord of the circle, to the square of the small angle that it covers."""
    world, radius = World(), 0.2
    world.point([0.1, radius + HALF - depth, 0], radius=radius, stiffness=2 * K)
    cable(world, STRAIGHT)
    world.mbs.Assemble()
    height, reach = radius + HALF - depth, radius + HALF
    half = np.sqrt(reach**2 - height**2)
    exact = quad(lambda x: K * (reach - np.hypot(x, height)) * height / np.hypot(x, height), -half, half)[0]
    force = world.contact.GetSystemODE2RhsContactForces()
    assert force[1] == pytest.approx(exact, rel=2 * depth / reach)
    assert force[1] == pytest.approx(K * depth * 4 / 3 * half, rel=1e-9)  # the rule of Simpson: nothing at the ends
    np.testing.assert_allclose(force[[0, 2]], 0, atol=1e-9)


def test_three_stretches() -> None:
    """A wave dips into a large circle in three places: each has a contact of its own."""
    world = World()
    cable(world, ((-0.5, 0, 1, -1.2), (0.5, 0, 1, -1.2)))
    world.point([0, 5.0 + HALF - 0.03, 0], radius=5.0)
    world.mbs.Assemble()
    world.contact.UpdateContacts(world.mbs)
    x = np.linspace(0, 1, 100001)
    place = np.array([-0.5 + x, 1.2 * (-(x - 2 * x**2 + x**3) - (x**3 - x**2))])
    inside = np.hypot(place[0], place[1] - 5.0 - HALF + 0.03) < 5.0 + HALF
    expected = int(np.count_nonzero(np.diff(inside.astype(int)) == 1) + inside[0])
    assert expected >= 2
    assert list(world.contact.GetActiveContacts(TYPES.IndexANCFCable2D, 0)) == [0] * expected
    assert list(world.contact.GetActiveContacts(TYPES.IndexANCFCable2D, -1)) == [expected]
    assert list(world.contact.GetActiveContacts(TYPES.IndexSpheresMarkerBased, -1)) == [0]


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_action_is_reaction(friction: float) -> None:
    """A common translation and a common turn do no work."""
    world = World(friction=friction, zone=0.1)
    centre = np.array([0.05, 0.26, 0.0])
    world.ball(centre, [0.2, -0.5, 0], [0, 0, 3], radius=0.2, surface={"stiffness": 2 * K, "damping": 100.0})
    cable(world, CURVED, RATES, damping=50.0)
    world.mbs.Assemble()
    force = world.contact.GetSystemODE2RhsContactForces()
    circle, ends = force[:6], force[6:].reshape(2, 4)
    assert np.abs(circle[:2]).max() > 10
    np.testing.assert_allclose(circle[:2] + ends[:, :2].sum(axis=0), 0, atol=1e-11 * np.abs(force).max())
    q = np.array(CURVED)
    work = (ends[:, 1] * q[:, 0] - ends[:, 0] * q[:, 1] + ends[:, 3] * q[:, 2] - ends[:, 2] * q[:, 3]).sum()
    moment = circle[5] + centre[0] * circle[1] - centre[1] * circle[0]
    assert work + moment == pytest.approx(0, abs=1e-11 * np.abs(force).max())
    assert (abs(circle[5]) > 0.1) == (friction > 0)


@pytest.mark.parametrize("friction", [0.0, 0.3])
@pytest.mark.parametrize("weights", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
def test_tangent_is_the_derivative_of_the_residual(friction: float, weights: tuple[float, float, float]) -> None:
    """Also of the ends of stretches, which move."""
    world = World(friction=friction, zone=0.1)
    world.ball([0.05, 0.26, 0], [0.2, -0.5, 0], [0, 0, 3], radius=0.2, surface={"stiffness": 2 * K, "damping": 100.0})
    cable(world, CURVED, RATES, damping=50.0)
    world.mbs.Assemble()
    s = testing.State(world.mbs)
    testing.search(world.mbs, s)

    def of_contact(compute: Any) -> np.ndarray:
        results = []
        for active in (True, False):
            world.contact.isActive = active
            results.append(compute())
        world.contact.isActive = True
        return results[0] - results[1]

    tangent = of_contact(lambda: testing.tangent(world.mbs, s, cq=weights[0], cv=weights[1]))
    assert np.abs(tangent).max() > 10
    for j in range(len(s.q)):
        ends = []
        for step in (1e-7, -1e-7):
            other = s.copy()
            vector = np.array(other.q if weights[0] else other.v)
            vector[j] += step
            if weights[0]:
                other.q = vector
            else:
                other.v = vector
            ends.append(of_contact(lambda other=other: testing.residual(world.mbs, other)))
        np.testing.assert_allclose(tangent[:, j], (ends[0] - ends[1]) / 2e-7, atol=1e-6 * np.abs(tangent).max())


def test_implicit_and_explicit_integration_agree() -> None:
    """A heavy disc falls onto a cable that is held at its ends."""
    results = []
    for solver, steps in ((EXPLICIT, 8000), (IMPLICIT, 4000)):
        world = World(friction=0.2, zone=0.05)
        disc = world.ball([0.1, 0.215, 0], [0.3, -1, 0], mass=0.5, radius=0.2, surface={"stiffness": 2e4})
        body = cable(world, STRAIGHT)
        ground = world.mbs.AddMarker(
            eii.MarkerNodeCoordinate(nodeNumber=world.mbs.AddNode(eii.NodePointGround()), coordinate=0)
        )
        for node in world.mbs.GetObject(body)["nodeNumbers"]:
            for coordinate in (0, 1):
                marker = world.mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
                world.mbs.AddObject(
                    eii.ObjectConnectorCoordinateSpringDamper(markerNumbers=[ground, marker], stiffness=1e5)
                )
        world.solve(0.02, steps, solver)
        results.append(np.concatenate([world.output(disc, "Position"), world.output(disc, "Velocity")]))
    assert results[0][4] > -0.9  # it has been slowed
    np.testing.assert_allclose(results[1], results[0], atol=2e-3)


def test_lines_meet_the_axis() -> None:
    world = World()
    cable(world, CURVED, RATES)
    world.mbs.Assemble()
    x = np.linspace(0, 1, 200001)
    weights = np.array([1 - 3 * x**2 + 2 * x**3, x - 2 * x**2 + x**3, 3 * x**2 - 2 * x**3, x**3 - x**2])
    q, v = np.array(CURVED).reshape(4, 2), np.array(RATES).reshape(4, 2)
    place, rate = weights.T @ q, weights.T @ v
    start, along = np.array([0.1, 1.0, 0]), np.array([0.2, -1.0, 0]) / np.hypot(0.2, 1)
    aside = (place[:, 0] - start[0]) * along[1] - (place[:, 1] - start[1]) * along[0]
    hit = np.argmin(np.abs(aside))
    found = world.contact.ShortestDistanceAlongLine(start, along, 0, 10, asDictionary=True)
    assert found["typeIndex"] == int(TYPES.IndexANCFCable2D)
    assert found["distance"] == pytest.approx((place[hit] - start[:2]) @ along[:2], abs=1e-5)
    assert found["velocityAlongLine"] == pytest.approx(rate[hit] @ along[:2], abs=1e-4)
    assert list(world.contact.GetItemsInBox([-1, -1, -1], [1, 1, 1])["ANCFCable2D"]) == [0]


def test_only_planar_cables() -> None:
    world = World()
    with pytest.raises(ValueError, match="halfHeight"):
        world.contact.AddANCFCable(world.mbs.CreateGround(), -1.0, 1.0, 0.0, 0)
    world.contact.AddANCFCable(world.mbs.CreateGround(), 0.1, 1.0, 0.0, 0)
    with pytest.raises(ValueError, match="cable 0: objectIndex.*ObjectGround.*an ObjectANCFCable2D"):
        world.mbs.Assemble()
