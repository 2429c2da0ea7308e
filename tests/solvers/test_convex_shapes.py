"""Contact points of convex shapes against independent computations; outputs and rejected arguments of their methods."""

from __future__ import annotations

import copy
import itertools
import os
import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.spatial import ConvexHull
from test_convex_contact import ConvexWorld, K
from test_general_contact import EXPLICIT, IMPLICIT, check_tangent, grid_mesh

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert._core import testing
from dalembert.utilities import InertiaSphere, RotationMatrixX, RotationMatrixY, RotationMatrixZ

TYPES = exu.ContactTypeIndex


def turned(rng: np.random.Generator) -> np.ndarray:
    return RotationMatrixX(rng.uniform(0, 6)) @ RotationMatrixY(rng.uniform(0, 6)) @ RotationMatrixZ(rng.uniform(0, 6))


def placed(world: ConvexWorld, position: Any, rotation: Any) -> Any:
    return world.body(InertiaSphere(1, 0.1), position, (0, 0, 0), referenceRotationMatrix=rotation)[1]


def overlap(a: np.ndarray, b: np.ndarray) -> float:
    """Least distance that separates two hulls: that of the origin from the surface of all differences of their points."""
    differences = ConvexHull((a[:, None] - b[None]).reshape(-1, 3))
    return float(-differences.equations[:, 3].max())


BESIDE_ITS_FACE = (192, 208, 494, 606)  # position of the deepest point


@pytest.mark.parametrize("seed", [*range(30), *BESIDE_ITS_FACE])
def test_overlap_of_random_hulls(seed: int) -> None:
    """The same as the hull of all differences of points: a face is taken up to a sine of 0.1 from the best direction,
    so depths there are longer by up to 1 / cos."""
    rng, world = np.random.default_rng(seed), ConvexWorld()
    points = [rng.normal(0, 0.1, (rng.integers(4, 14), 3)) for _ in range(2)]
    places = [(np.zeros(3), turned(rng)), (rng.uniform(-0.15, 0.15, 3), turned(rng))]
    for own, (position, rotation) in zip(points, places, strict=True):
        world.contact.AddConvexHullWithMarker(placed(world, position, rotation), own, **world.surface)
    world.mbs.Assemble()
    a, b = (position + own @ rotation.T for own, (position, rotation) in zip(points, places, strict=True))
    depth, found = overlap(a, b), world.contact.GetConvexContacts()
    if depth <= 0:
        assert len(found["gaps"]) == 0
        return
    normals = found["normals"]
    assert np.abs(normals - normals[0]).max() < 1e-12
    deepest = -found["gaps"].min()
    assert depth * (1 - 1e-12) <= deepest <= depth / np.sqrt(1 - 0.1**2) * (1 + 1e-12)


Support = Callable[[np.ndarray], np.ndarray]


def shape_at_random(kind: str, rng: np.random.Generator, world: ConvexWorld) -> tuple[Callable[[Any], None], Support]:
    """A shape around the origin: how it is added at a marker, and how far it reaches along directions, in its own axes."""
    if kind == "cylinder":
        radius, length = rng.uniform(0.04, 0.2), rng.uniform(0.05, 0.4)
        return (
            lambda marker: world.contact.AddCylinderWithMarker(marker, radius, [0, 0, length], **world.surface),
            lambda u: radius * np.hypot(u[:, 0], u[:, 1]) + length / 2 * np.abs(u[:, 2]),
        )
    if kind == "capsule":
        radius, length = rng.uniform(0.04, 0.15), rng.uniform(0.05, 0.4)
        return (
            lambda marker: world.contact.AddCapsuleWithMarker(marker, radius, [0, 0, length], **world.surface),
            lambda u: radius + length / 2 * np.abs(u[:, 2]),
        )
    if kind == "box":
        size = rng.uniform(0.05, 0.3, 3)
        return (
            lambda marker: world.contact.AddBoxWithMarker(marker, size, **world.surface),
            lambda u: np.abs(u) @ size / 2,
        )
    points = rng.normal(0, 0.1, (rng.integers(4, 14), 3))
    return (
        lambda marker: world.contact.AddConvexHullWithMarker(marker, points, **world.surface),
        lambda u: (u @ points.T).max(axis=1),
    )


def directions(count: int) -> np.ndarray:
    """Spread evenly over the sphere, on a spiral."""
    k = np.arange(count) + 0.5
    up, angle = 1 - 2 * k / count, np.pi * (1 + np.sqrt(5)) * k
    return np.stack([np.sqrt(1 - up**2) * np.cos(angle), np.sqrt(1 - up**2) * np.sin(angle), up], axis=1)


def least_over_directions(f: Support, starts: int = 6) -> tuple[float, np.ndarray]:
    """The least value, and where: the best of many directions, of ever smaller caps around some, and downhill from there."""
    spiral, cap = directions(4000), directions(120)
    best, where = np.inf, spiral[0]
    left = spiral[np.argsort(f(spiral))]
    for _ in range(starts):
        if not len(left):
            break
        u, size = left[0], 0.1
        left = left[left @ u < 0.97]
        value = f(u[None])[0]
        while size > 1e-13:
            around = u + size * cap
            around /= np.linalg.norm(around, axis=1)[:, None]
            values = f(around)
            if values.min() < value:
                value, u = values.min(), around[values.argmin()]
            else:
                size *= 0.6
        for size in (1e-2, 1e-5):
            across = np.linalg.svd(u[None])[2][1:]
            simplex = size * np.array([[0, 0], [1, 0], [0, 1]])
            point = lambda x: (u + x @ across) / np.linalg.norm(u + x @ across)  # noqa: B023, E731
            down = minimize(
                lambda x: f(point(x)[None])[0], np.zeros(2), method="Nelder-Mead",  # noqa: B023
                options={"initial_simplex": simplex, "xatol": 1e-10, "fatol": 1e-15, "maxiter": 400},
            )  # fmt: skip
            if down.fun < value:
                value, u = down.fun, point(down.x)
        if value < best:
            best, where = value, u
    return float(best), where


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("other", ["box", "hull", "cylinder", "capsule"])
def test_cylinders_touch_exactly_where_they_overlap(other: str, seed: int) -> None:
    """Depth of the least overlap over all directions, by support functions alone. A face is taken up to a sine of 0.1
    from the best direction, so depths there are longer by up to 1 / cos; chords of rims on faces may leave out 1 %."""
    rng = np.random.default_rng(seed)
    for case in range(4):
        world = ConvexWorld()
        (add0, reach0), (add1, reach1) = shape_at_random("cylinder", rng, world), shape_at_random(other, rng, world)
        turn0, turn1, way = turned(rng), turned(rng), rng.normal(size=3)
        way /= np.linalg.norm(way)
        u = directions(4000)
        reach = reach0(u @ turn0) + reach1(-u @ turn1)
        faces = u @ way > 0
        away = (reach[faces] / (u[faces] @ way)).min() + (-0.002, 0.001, -0.0005, -0.006)[case]
        first = case % 2 == 0
        for add, position, rotation in sorted(
            [(add0, np.zeros(3), turn0), (add1, away * way, turn1)], key=lambda x: (x[0] is add0) != first
        ):
            add(placed(world, position, rotation))
        world.mbs.Assemble()
        depth, normal = least_over_directions(
            lambda u: reach0(u @ turn0) + reach1(-u @ turn1) - away * (u @ way)  # noqa: B023
        )
        found = world.contact.GetConvexContacts()
        if depth < -1e-9:
            assert len(found["gaps"]) == 0
        elif depth > 1e-9:
            deepest = found["gaps"].argmin()
            assert 0.99 * depth * (1 - 1e-6) <= -found["gaps"][deepest] <= depth / np.sqrt(1 - 0.1**2) * (1 + 1e-6)
            assert (found["normals"][deepest] @ normal) * (1 if first else -1) > np.sqrt(1 - 0.1**2) * (1 - 1e-6)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("below", ["hull", "mesh"])
def test_a_rim_on_an_edge(below: str, seed: int) -> None:
    """A line touches a circle of any inclination where it is lowest, if the tangent there crosses it: closed form."""
    rng, world, radius, depth = np.random.default_rng(seed), ConvexWorld(), 0.1, 1e-4
    axis = np.array([rng.choice([-1, 1]) * rng.uniform(0.2, 0.5), rng.uniform(-0.5, 0.5), -1.0])
    axis /= np.linalg.norm(axis)
    out = np.array([0, 0, -1.0]) + axis[2] * axis
    sine = np.linalg.norm(out)
    lowest = radius * out / sine
    # The edge is the x-axis, of a prism or a roof below it; the circle is lowest over a point of it.
    center = np.array([rng.uniform(-0.1, 0.1), 0, -depth]) - lowest
    points = [[x, y, z] for y, z in ((0, 0), (-1, -1), (1, -1)) for x in (-1, 1)]
    if below == "hull":
        world.contact.AddConvexHullWithMarker(placed(world, [0, 0, 0], np.eye(3)), points, **world.surface)
    else:
        roof = [[0, 2, 3], [0, 3, 1], [0, 1, 5], [0, 5, 4]]
        world.contact.AddTrianglesRigidBodyBased(world.ground, pointList=points, triangleList=roof, **world.surface)
    marker = placed(world, center, np.eye(3))
    world.contact.AddCylinderWithMarker(marker, radius, -0.3 * axis, pAxis=[0, 0, 0], **world.surface)
    world.mbs.Assemble()
    found = world.contact.GetConvexContacts()
    np.testing.assert_allclose(found["gaps"], [-depth], rtol=1e-10)
    up = 1 if below == "hull" else -1  # of the first one: the cylinder, if the other is a mesh
    np.testing.assert_allclose(found["normals"], [[0, 0, up]], atol=1e-10)
    np.testing.assert_allclose(found["points"], [center + lowest + [0, 0, depth / 2]], atol=1e-10)


@pytest.mark.parametrize("weights", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
@pytest.mark.parametrize("other", ["box", "hull", "cylinder", "capsule"])
def test_tangent_where_cylinders_touch(other: str, weights: tuple[float, float, float]) -> None:
    """The direction of least overlap of a rim is found by iterations, its derivatives are exact all the same."""
    touching = 0
    for seed in range(6):
        rng, world = np.random.default_rng(seed), ConvexWorld(0.3)
        world.contact.frictionProportionalZone = 0.5
        world.damped(5.0)
        (add0, reach0), (add1, reach1) = (shape_at_random(kind, rng, world) for kind in ("cylinder", other))
        turn0, turn1, way, u = turned(rng), turned(rng), rng.normal(size=3), directions(4000)
        way /= np.linalg.norm(way)
        faces = u @ way > 0
        away = ((reach0(u @ turn0) + reach1(-u @ turn1))[faces] / (u[faces] @ way)).min() - 0.002
        for add, position, rotation in ((add0, np.zeros(3), turn0), (add1, away * way, turn1)):
            speeds = {"initialVelocity": rng.uniform(-1, 1, 3), "initialAngularVelocity": rng.uniform(-5, 5, 3)}
            add(world.body(InertiaSphere(1, 0.1), position, (0, 0, 0), referenceRotationMatrix=rotation, **speeds)[1])
        world.mbs.Assemble()
        s = testing.State(world.mbs)
        testing.search(world.mbs, s)
        touching += len(world.contact.GetConvexContacts()["gaps"])
        check_tangent(world, s, weights)
    assert touching > 3


def test_separate_hulls_do_not_touch_and_close_ones_do() -> None:
    """A box that stands on its corner, on a face: its depth by hand, and nothing as soon as it is lifted."""
    corner = RotationMatrixY(np.arctan(np.sqrt(0.5))) @ RotationMatrixX(np.pi / 4)
    lowest = np.sqrt(3) / 2 * 0.2
    for lift, depth in ((-1e-3, 1e-3), (1e-9, 0.0)):
        world = ConvexWorld()
        world.floor("box")
        world.contact.AddBoxWithMarker(placed(world, [0.1, 0.2, lowest + lift], corner), [0.2] * 3, **world.surface)
        world.mbs.Assemble()
        found = world.contact.GetConvexContacts()
        np.testing.assert_allclose(found["gaps"], [-depth] if depth else [], atol=1e-12)
        np.testing.assert_allclose(found["forces"][:, 2], [-0.25 * depth * K / 2] if depth else [], rtol=1e-9)


def segment_distance(a: np.ndarray, b: np.ndarray) -> float:
    """Least distance of two segments, by a minimizer."""

    def square(x: np.ndarray) -> float:
        return float(np.sum((a[0] + x[0] * (a[1] - a[0]) - b[0] - x[1] * (b[1] - b[0])) ** 2))

    starts = itertools.product((0.1, 0.9), repeat=2)
    best = min(minimize(square, s, bounds=[(0, 1)] * 2, options={"ftol": 1e-16, "gtol": 1e-12}).fun for s in starts)
    return float(np.sqrt(best))


@pytest.mark.parametrize("seed", range(20))
def test_capsules_are_as_far_as_their_segments(seed: int) -> None:
    rng, world, radii = np.random.default_rng(seed), ConvexWorld(), (0.08, 0.05)
    ends = []
    for radius in radii:
        position, rotation, axis = rng.uniform(-0.06, 0.06, 3), turned(rng), rng.uniform(-0.2, 0.2, 3)
        world.contact.AddCapsuleWithMarker(placed(world, position, rotation), radius, axis, **world.surface)
        ends.append(position + np.outer([-0.5, 0.5], rotation @ axis))
    world.mbs.Assemble()
    gap = segment_distance(*ends) - sum(radii)
    found = world.contact.GetConvexContacts()["gaps"]
    assert (len(found) > 0) == (gap < 0)
    if gap < 0:
        assert found.min() == pytest.approx(gap, abs=1e-7)


def support_distance(points: np.ndarray, x: np.ndarray) -> float:
    """Distance of a point outside of a hull, by a quadratic program in the shares of the points."""
    n = len(points)
    best = minimize(
        lambda w: float(np.sum((w @ points - x) ** 2)), np.full(n, 1 / n), jac=lambda w: 2 * points @ (w @ points - x),
        bounds=[(0, 1)] * n, constraints={"type": "eq", "fun": lambda w: w.sum() - 1, "jac": lambda w: np.ones(n)},
        method="SLSQP", options={"ftol": 1e-15, "maxiter": 500},
    )  # fmt: skip
    return float(np.sqrt(best.fun))


@pytest.mark.parametrize("seed", range(20))
def test_balls_are_as_far_as_their_centers(seed: int) -> None:
    rng, world, radius = np.random.default_rng(seed), ConvexWorld(), 0.1
    points, rotation = rng.normal(0, 0.1, (8, 3)), turned(rng)
    world.contact.AddConvexHullWithMarker(placed(world, [0, 0, 0], rotation), points, **world.surface)
    center = rng.normal(0, 1, 3)
    center *= rng.uniform(0.15, 0.3) / np.linalg.norm(center)
    world.point(center, radius=radius, stiffness=K)
    world.mbs.Assemble()
    local = center @ rotation
    hull = ConvexHull(points)
    inside = (hull.equations[:, :3] @ local + hull.equations[:, 3]).max()
    gap = (inside if inside < 0 else support_distance(points, local)) - radius
    found = world.contact.GetConvexContacts()["gaps"]
    assert (len(found) > 0) == (gap < 0)
    if gap < 0:
        np.testing.assert_allclose(found, [gap], atol=1e-6)


@pytest.mark.parametrize("place", [(0.0, 0.0, 0.24), (0.14, 0.0, 0.05), (0.1, 0.12, 0.22), (0.03, 0.02, 0.0)])
def test_balls_on_cylinders(place: tuple[float, float, float]) -> None:
    """Points on the cap, on the lateral surface, on the rim and inside: closed forms in the cylinder's coordinates."""
    world, radius, length, ball = ConvexWorld(), 0.1, 0.4, 0.05
    world.contact.AddCylinderWithMarker(placed(world, [0, 0, 0], np.eye(3)), radius, [0, 0, length], **world.surface)
    world.point(place, radius=ball, stiffness=K)
    world.mbs.Assemble()
    aside, along = np.hypot(*place[:2]) - radius, abs(place[2]) - length / 2
    outside = np.hypot(max(aside, 0), max(along, 0))
    gap = (outside if outside > 0 else max(aside, along)) - ball
    found = world.contact.GetConvexContacts()["gaps"]
    np.testing.assert_allclose(found, [gap] if gap < 0 else [], atol=1e-12)


@pytest.mark.parametrize("angle", [0.0, 0.01, 0.5, np.pi / 2])
def test_cylinders_on_each_other(angle: float) -> None:
    """Crossing or side by side, mantles are round: 0.1 mm of overlap in any direction around the axis."""
    for around in np.linspace(0, 0.3, 5):
        world, radii, depth = ConvexWorld(), (0.1, 0.06), 1e-4
        away = RotationMatrixX(around) @ np.array([0, 0, sum(radii) - depth])
        turn = RotationMatrixX(around) @ RotationMatrixZ(angle)
        for position, rotation, radius in (([0, 0, 0], np.eye(3), radii[0]), (away, turn, radii[1])):
            marker = placed(world, position, rotation)
            world.contact.AddCylinderWithMarker(marker, radius, [0.4, 0, 0], **world.surface)
        world.mbs.Assemble()
        found = world.contact.GetConvexContacts()
        assert len(found["gaps"]) == (2 if angle < 0.05 else 1)
        np.testing.assert_allclose(found["gaps"], -depth, atol=0.2 * angle**2 if angle < 0.05 else 1e-12)


def test_shapes_on_edges_and_corners_of_a_mesh() -> None:
    """A box over the border of a plate: two corners stand on it, and its edges cross the border; a box on a spike stands on its tip."""
    world, depth = ConvexWorld(), 1e-3
    points, triangles = grid_mesh(0.5, 4)
    world.contact.AddTrianglesRigidBodyBased(world.ground, pointList=points, triangleList=triangles, **world.surface)
    box = placed(world, [0.53, 0.012, 0.05 - depth], np.eye(3))
    world.contact.AddBoxWithMarker(box, [0.2, 0.1, 0.1], **world.surface)
    world.mbs.Assemble()
    found = world.contact.GetConvexContacts()
    np.testing.assert_allclose(np.sort(found["points"][:, 0]), [0.43, 0.43, 0.5, 0.5], atol=1e-12)
    np.testing.assert_allclose(found["gaps"], -depth, atol=1e-12)
    np.testing.assert_allclose(found["normals"], [[0, 0, -1]] * 4, atol=1e-12)

    world = ConvexWorld()
    spike = [[-0.1, -0.1, -0.2], [0.1, -0.1, -0.2], [0, 0.1, -0.2], [0, 0, 0]]
    sides = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [0, 2, 1]]
    world.contact.AddTrianglesRigidBodyBased(world.ground, pointList=spike, triangleList=sides, **world.surface)
    world.contact.AddBoxWithMarker(
        placed(world, [0.01, 0.02, 0.05 - depth], np.eye(3)), [0.2] * 2 + [0.1], **world.surface
    )
    world.mbs.Assemble()
    found = world.contact.GetConvexContacts()
    np.testing.assert_allclose(found["points"], [[0, 0, -depth]], atol=1e-12)
    np.testing.assert_allclose(found["gaps"], [-depth], atol=1e-12)


def test_a_hull_on_hills_stands_on_the_nearest_triangle() -> None:
    """A tetrahedron with one corner down: its depth is the height of the field there, less its own."""
    x, y = np.meshgrid(np.linspace(-1, 1, 41), np.linspace(-1, 1, 41), indexing="ij")
    heights = 0.1 * np.sin(3 * x) * np.cos(2 * y)
    tip = np.array([[0, 0, 0], [0.1, 0, 0.3], [-0.05, 0.1, 0.3], [-0.05, -0.1, 0.3]])
    for place in ([0.31, 0.22], [-0.43, 0.61], [0.02, -0.77]):
        world = ConvexWorld()
        world.contact.AddHeightField(world.ground, heights, [0.05, 0.05], origin=[-1, -1, 0], **world.surface)
        marker = placed(world, [*place, 0.1 * np.sin(3 * place[0]) * np.cos(2 * place[1]) - 2e-3], np.eye(3))
        world.contact.AddConvexHullWithMarker(marker, tip, **world.surface)
        world.mbs.Assemble()
        found = world.contact.GetConvexContacts()
        assert len(found["gaps"]) == 1
        ground = world.contact.ShortestDistanceAlongLine(
            [*place, 2.0], [0, 0, -1], 0, 9, typeIndex=TYPES.IndexTrigsRigidBodyBased
        )
        height = (2 - ground) - world.mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position)[2]
        np.testing.assert_allclose(found["gaps"], -height * -found["normals"][0, 2], atol=1e-12)


# ---- questions -------------------------------------------------------------------------------------------------------


def test_lines_meet_convex_shapes_and_planes() -> None:
    """A fan of lines from outside, against closed forms of a box, a ball at the end of a capsule, a mantle and a plane."""
    world = ConvexWorld()
    marker = placed(world, [1, 0, 0], RotationMatrixZ(np.pi / 4))
    world.contact.AddBoxWithMarker(marker, [0.2, 0.2, 0.4], **world.surface)
    world.contact.AddCapsuleWithMarker(placed(world, [0, 2, 0], np.eye(3)), 0.1, [0, 0, 1], **world.surface)
    world.contact.AddCylinderWithMarker(placed(world, [0, -2, 0], np.eye(3)), 0.1, [0, 0, 1], **world.surface)
    world.contact.AddPlane(world.ground, [0, 0, 1], point=[0, 0, -3], **world.surface)
    world.mbs.Assemble()
    line = world.contact.ShortestDistanceAlongLine
    convex, plane = int(TYPES.IndexConvexMarkerBased), int(TYPES.IndexPlanesRigidBodyBased)
    for direction, distance, number, kind in (
        ([1, 0, 0], 1 - 0.1 * np.sqrt(2), 0, convex),
        ([0, 1, 0], 1.9, 1, convex),
        ([0, -1, 0], 1.9, 2, convex),
        ([0, 0, -2], 3, 0, plane),
    ):
        found = line([0, 0, 0], direction, 0, 10, asDictionary=True)
        assert found["distance"] == pytest.approx(distance)
        assert (found["itemIndex"], found["typeIndex"]) == (number, kind)
    assert line([0, 2, 5], [0, 0, -1], 0, 9) == pytest.approx(5 - 0.6)
    assert line([0.05, -2, 5], [0, 0, -1], 0, 9) == pytest.approx(4.5)
    assert line([0, 0, 0], [1, 0, 0], 0, 10, typeIndex=TYPES.IndexPlanesRigidBodyBased) == 10
    items = world.contact.GetItemsInBox([0.5, -1, -1], [2, 1, 1])
    assert items["ConvexMarkerBased"].tolist() == [0]


def test_active_contacts_of_convex_shapes() -> None:
    """Global numbers: a sphere, two triangles, then boxes 3 and 4, then plane 5."""
    world, sink = ConvexWorld(0.3), 1e-4
    world.floor("plane")
    world.box([0.2, 0.2, 0.2], [0, 0, 0.1 - sink])
    world.box([0.2, 0.2, 0.2], [0, 0, 0.3 - 2 * sink])
    world.point([0.0, 0, 0.5 - 3 * sink], radius=0.1, stiffness=K)
    world.mesh([[5, 0, 0], [6, 0, 0], [6, 1, 0], [5, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    world.mbs.Assemble()
    world.contact.UpdateContacts(world.mbs)
    active = world.contact.GetActiveContacts
    assert active(TYPES.IndexConvexMarkerBased, -1).tolist() == [2, 2]
    assert sorted(active(TYPES.IndexConvexMarkerBased, 0).tolist()) == [4, 5]
    assert sorted(active(TYPES.IndexConvexMarkerBased, 1).tolist()) == [0, 3]
    assert active(TYPES.IndexSpheresMarkerBased, 0).tolist() == [4]


# ---- copies and restart ----------------------------------------------------------------------------------------------


def tower(friction: float = 0.4) -> tuple[ConvexWorld, list[Any]]:
    world = ConvexWorld(friction)
    world.damped(20.0)
    world.contact.SetFrictionBristles(0.5, 1.0)
    bodies = [world.box([0.1, 0.12, 0.14], [0.02 * i, 0, 0.08 + 0.15 * i]) for i in range(2)]
    bodies.append(world.cylinder(0.05, 0.2, [0, 0, 0.5]))
    marker = placed(world, [0.3, 0, 0.2], np.eye(3))
    world.contact.AddConvexHullWithMarker(marker, [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]], **world.surface)
    world.contact.AddCapsuleWithMarker(placed(world, [0, 0.4, 0.2], np.eye(3)), 0.05, [0.1, 0, 0], **world.surface)
    world.floor("plane")
    return world, bodies


@pytest.mark.parametrize("make", [copy.copy, lambda m: pickle.loads(pickle.dumps(m))], ids=["copy", "pickle"])
def test_copies_have_the_same_contacts(make: Any) -> None:
    world, bodies = tower()
    world.mbs.Assemble()
    results = []
    for mbs in (world.mbs, make(world.mbs)):
        world.mbs = mbs
        world.solve(0.2, 200, EXPLICIT)
        results.append(b"".join(world.output(b, "Position").tobytes() for b in bodies))
    assert results[0] == results[1]


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_a_restart_goes_on_bit_for_bit(solver: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Some bristles stick and some slide at that moment."""
    monkeypatch.chdir(tmp_path)
    settings = exu.SimulationSettings()
    time, solution = settings.timeIntegration, settings.solutionSettings
    time.endTime, time.numberOfSteps = 0.2, 200
    solution.writeSolutionToFile = False
    solution.writeRestartFile, solution.restartFileName, solution.restartWritePeriod = True, "restart.txt", 0.12
    ends = []
    for number in range(2):
        world, _ = tower()
        world.mbs.Assemble()
        world.mbs.SolveDynamic(settings, solverType=solver)
        assert len(world.contact.GetConvexContacts()["gaps"]) > 5
        state = world.mbs.systemData
        ends.append(state.GetODE2Coordinates().tobytes() + state.GetODE2Coordinates_t().tobytes())
        if number == 0:
            os.replace("restart.txt.bck", "middle.txt")
            settings.continuation.restartFileName = "middle.txt"
    assert ends[0] == ends[1]


# ---- bad input -------------------------------------------------------------------------------------------------------

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
SURFACE = {"contactStiffness": 1.0, "contactDamping": 0.0, "frictionMaterialIndex": 0}
REFUSED = {
    "flat box": ("AddBoxWithMarker", {"size": [1, 0, 1]}, r"AddBoxWithMarker.*'?size'?.*\[1, 0, 1\].*3 positive numbers"),
    "box without number": ("AddBoxWithMarker", {"size": [1, np.nan, 1]}, "size.*3"),
    "two sides": ("AddBoxWithMarker", {"size": [1, 2]}, r"size.*\[1, 2\]"),
    "no stiffness": ("AddBoxWithMarker", {"size": [1, 1, 1], "contactStiffness": 0}, "contactStiffness.*positive"),
    "negative radius": ("AddCylinderWithMarker", {"radius": -1, "vAxis": [1, 0, 0]}, "AddCylinder.*radius.*-1.*positive"),
    "no axis": ("AddCapsuleWithMarker", {"radius": 1, "vAxis": [0, 0, 0]}, "AddCapsule.*vAxis.*not zero"),
    "points in a plane": ("AddConvexHullWithMarker", {"pointList": SQUARE}, "pointList.*plane.*at least 4 points"),
    "three points": ("AddConvexHullWithMarker", {"pointList": SQUARE[:3]}, "pointList.*3 points.*at least 4 points"),
    "two columns": ("AddConvexHullWithMarker", {"pointList": [[0, 1]] * 5}, "pointList.*3 columns"),
    "no number": ("AddConvexHullWithMarker", {"pointList": [*SQUARE, [0, 0, np.inf]]}, r"pointList\[4\].*inf.*finite"),
    "no normal": ("AddPlane", {"normal": [0, 0, 0]}, "AddPlane.*normal.*not zero"),
    "one row": ("AddHeightField", {"heights": [[1, 2]], "cellSize": [1, 1]}, "AddHeightField.*heights.*at least 2 rows"),
    "no cells": ("AddHeightField", {"heights": [[1, 2], [1, 2]], "cellSize": [1, 0]}, "cellSize.*2 positive"),
    "no height": ("AddHeightField", {"heights": [[1, 2], [1, np.nan]], "cellSize": [1, 1]}, r"heights\[1,1\].*nan"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_bad_shapes_are_refused_by_name(case: str) -> None:
    world, (method, arguments, text) = ConvexWorld(), REFUSED[case]
    before = world.contact.GetPythonObject()
    with pytest.raises(ValueError, match=f"(?s){text}"):
        getattr(world.contact, method)(world.ground, **(SURFACE | arguments))
    assert str(world.contact.GetPythonObject()) == str(before)


def test_markers_without_orientation_are_refused() -> None:
    world = ConvexWorld()
    node = world.mbs.AddNode(eii.NodePoint())
    marker = world.mbs.AddMarker(eii.MarkerNodePosition(nodeNumber=node))
    world.contact.AddBoxWithMarker(marker, [1, 1, 1], **SURFACE)
    with pytest.raises(ValueError, match="(?s)convex shape 0: markerIndex.*a marker with an orientation"):
        world.mbs.Assemble()
    with pytest.raises(IndexError, match="(?s)AddBoxWithMarker"):
        world.contact.AddBoxWithMarker(99, [1, 1, 1], **SURFACE)


def test_reset_removes_them() -> None:
    world = ConvexWorld()
    world.floor("plane")
    world.box([1, 1, 1], [0, 0, 0.5])
    assert repr(world.contact).endswith("0 triangles, 1 convex shapes, 1 planes>")
    world.contact.Reset()
    now = world.contact.GetPythonObject()
    assert (now["numberOfConvexMarkerBased"], now["numberOfPlanesRigidBodyBased"]) == (0, 0)
