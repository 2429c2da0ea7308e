"""Spring-dampers are computed side by side; items with user functions are evaluated separately: each item agrees with
its formula."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from registers import each_width, numbers_in_registers

import dalembert as exu
from dalembert._core import testing
from dalembert.itemInterface import (
    MarkerNodePosition,
    NodePoint,
    NodePointGround,
    ObjectConnectorSpringDamper,
    ObjectMassPoint,
)

ROUNDING = 1e-13  # relative to the largest force: wide registers fuse products and sums
POSITION, VELOCITY = {"cq": 1.0, "cv": 0.0}, {"cq": 0.0, "cv": 1.0}  # the weights of a tangent


def law(i: int) -> dict[str, float]:
    """Each spring has numbers of its own."""
    return {
        "stiffness": 100 + 7 * i,
        "damping": 3 + 0.1 * i,
        "referenceLength": 0.5 + 0.01 * i,
        "force": 0.3 * i,
        "velocityOffset": 0.2 - 0.05 * i,
    }


def star(laws: list[dict[str, Any]], grounded: tuple[int, ...] = ()) -> exu.MainSystem:
    """Springs from one free point, node 0, to as many others, some of which are ground."""
    mbs = exu.SystemContainer().AddSystem()
    markers = []
    for i in range(len(laws) + 1):
        place = [np.cos(i), np.sin(i), 0.3 * i] if i else [0, 0, 0]
        if i in grounded:
            node = mbs.AddNode(NodePointGround(referenceCoordinates=place))
        else:
            node = mbs.AddNode(NodePoint(referenceCoordinates=place))
            mbs.AddObject(ObjectMassPoint(nodeNumber=node, physicsMass=1))
        markers.append(mbs.AddMarker(MarkerNodePosition(nodeNumber=node)))
    for marker, one in zip(markers[1:], laws, strict=True):
        mbs.AddObject(ObjectConnectorSpringDamper(markerNumbers=[markers[0], marker], **one))
    mbs.Assemble()
    return mbs


def residual(mbs: exu.MainSystem, q: np.ndarray, v: np.ndarray) -> np.ndarray:
    state = testing.State(mbs)
    state.q, state.v = q.ravel(), v.ravel()
    return testing.residual(mbs, state).reshape(-1, 3)


def expected(laws: list[dict[str, Any]], points: np.ndarray, v: np.ndarray) -> np.ndarray:
    """Minus the forces on the points."""
    r = np.zeros_like(points)
    for i, one in enumerate(laws, start=1):
        span = points[i] - points[0]
        length = np.linalg.norm(span)
        along = span if length > 0 else v[i] - v[0]
        axis = along / np.linalg.norm(along)
        rate = axis @ (v[i] - v[0]) - one["velocityOffset"]
        force = one["stiffness"] * (length - one["referenceLength"]) + one["damping"] * rate + one["force"]
        r[0] -= force * axis
        r[i] += force * axis
    return r


def motion(count: int) -> tuple[np.ndarray, np.ndarray]:
    q, v = np.random.default_rng(count).normal(scale=0.1, size=(2, count + 1, 3))
    return q, v


def reference(mbs: exu.MainSystem) -> np.ndarray:
    return np.array(mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Reference)).reshape(-1, 3)


def agree(values: np.ndarray, others: np.ndarray) -> bool:
    return bool(np.abs(values - others).max() < ROUNDING * np.abs(others).max())


@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 21], ids="{} springs".format)
def test_springs_side_by_side(count: int) -> None:
    laws = [law(i) for i in range(count)]
    mbs = star(laws)
    q, v = motion(count)
    assert agree(residual(mbs, q, v), expected(laws, reference(mbs) + q, v))


def test_user_functions_among_them() -> None:
    """A force that grows with the square of the elongation, by two of eleven; its formula has no law."""
    laws = [law(i) for i in range(11)]
    given: list[dict[str, Any]] = [dict(one) for one in laws]

    def square(mbs: Any, t: float, i: int, elongation: float, rate: float, k: float, d: float, f: float) -> float:
        return k * elongation * elongation

    for i in (2, 8):
        given[i]["springForceUserFunction"] = square
    mbs = star(given)
    q, v = motion(11)
    points = reference(mbs) + q
    r = expected([one if i not in (2, 8) else dict.fromkeys(one, 0.0) for i, one in enumerate(laws)], points, v)
    for i in (2, 8):
        span = points[i + 1] - points[0]
        length = np.linalg.norm(span)
        force = laws[i]["stiffness"] * (length - laws[i]["referenceLength"]) ** 2 * span / length
        r[0] -= force
        r[i + 1] += force
    assert agree(residual(mbs, q, v), r)


def test_laws_that_change() -> None:
    """One item gets another stiffness after assembly, one is switched off and on, one gets a user function and loses
    it."""
    laws = [law(i) for i in range(9)]
    mbs = star(laws)
    q, v = motion(9)
    points = reference(mbs) + q
    first_spring = 10  # after the mass points

    mbs.SetObjectParameter(first_spring + 3, "stiffness", 500)
    laws[3]["stiffness"] = 500
    assert agree(residual(mbs, q, v), expected(laws, points, v))

    without = [one if i != 8 else dict.fromkeys(one, 0.0) for i, one in enumerate(laws)]
    mbs.SetObjectParameter(first_spring + 8, "activeConnector", False)
    assert agree(residual(mbs, q, v), expected(without, points, v))
    mbs.SetObjectParameter(first_spring + 8, "activeConnector", True)
    assert agree(residual(mbs, q, v), expected(laws, points, v))

    mbs.SetObjectParameter(first_spring + 8, "springForceUserFunction", lambda *_: 0.0)
    assert agree(residual(mbs, q, v), expected(without, points, v))
    mbs.SetObjectParameter(first_spring + 8, "springForceUserFunction", 0)
    assert agree(residual(mbs, q, v), expected(laws, points, v))


def test_alike_until_one_changes() -> None:
    """Springs in groups that repeat share their numbers; who changes leaves the others as they are."""
    laws = [law(i % 4) for i in range(37)]
    mbs = star(laws)
    q, v = motion(37)
    points = reference(mbs) + q
    first_spring = 38  # after the mass points
    for i in (9, 9, 25, 36, 0):
        laws[i] = {**laws[i], "stiffness": 2 * laws[i]["stiffness"]}
        mbs.SetObjectParameter(first_spring + i, "stiffness", laws[i]["stiffness"])
        assert agree(residual(mbs, q, v), expected(laws, points, v))


def test_points_that_coincide() -> None:
    """Their force is along the relative velocity; the others pull as before."""
    laws = [law(i) for i in range(5)]
    mbs = star(laws)
    q, v = motion(5)
    points = reference(mbs)
    q[0], q[3] = 0, -points[3]  # both in the origin, exactly
    assert agree(residual(mbs, q, v), expected(laws, points + q, v))


def check_tangent(mbs: exu.MainSystem, q: np.ndarray, v: np.ndarray) -> None:
    """Derivatives by positions and velocities against central differences of second order, which are exact to about
    1e-10 of the largest entry."""
    state = testing.State(mbs)
    state.q, state.v = q.ravel(), v.ravel()
    h = 1e-5
    for weights, moved in ((POSITION, "q"), (VELOCITY, "v")):
        columns = []
        for k in range(q.size):
            sides = []
            for step in (h, -h):
                at = {"q": q.ravel().copy(), "v": v.ravel().copy()}
                at[moved][k] += step
                sides.append(residual(mbs, at["q"], at["v"]).ravel())
            columns.append((sides[0] - sides[1]) / (2 * h))
        differences = np.array(columns).T
        tangent = testing.tangent(mbs, state, **weights)
        np.testing.assert_allclose(tangent, differences, rtol=0, atol=1e-7 * np.abs(differences).max())


@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 21], ids="{} springs".format)
def test_tangents_side_by_side(count: int) -> None:
    mbs = star([law(i) for i in range(count)])
    check_tangent(mbs, *motion(count))


def test_tangents_of_all_kinds_of_ends() -> None:
    """Ground in the midst of points, at the end of a block and alone in one; a user function, and a connector that is off, among them."""
    laws: list[dict[str, Any]] = [law(i) for i in range(17)]
    laws[4]["springForceUserFunction"] = lambda mbs, t, i, elongation, rate, k, d, f: k * elongation**2 + d * rate
    laws[6]["activeConnector"] = False
    mbs = star(laws, grounded=(1, 3, 8, 17))
    q, v = np.random.default_rng(3).normal(scale=0.1, size=(2, 14, 3))
    check_tangent(mbs, q, v)


def test_tangents_where_points_coincide() -> None:
    """One spring of a block has zero length: its force changes with the velocity as stated, and not with the position;
    the others are not affected."""
    laws = [law(i) for i in range(5)]
    mbs = star(laws)
    q, v = motion(5)
    q[0], q[3] = 0, -reference(mbs)[3]
    state = testing.State(mbs)
    state.q, state.v = q.ravel(), v.ravel()
    by_position, by_velocity = (testing.tangent(mbs, state, **w).reshape(6, 3, 6, 3) for w in (POSITION, VELOCITY))

    rate = v[3] - v[0]
    speed = np.linalg.norm(rate)
    axis = rate / speed
    one = laws[2]
    tension = (
        -one["stiffness"] * one["referenceLength"] + one["damping"] * (speed - one["velocityOffset"]) + one["force"]
    )
    along = np.outer(axis, axis)
    np.testing.assert_allclose(by_position[3, :, 3], one["stiffness"] * along, rtol=1e-12, atol=1e-10)
    np.testing.assert_allclose(
        by_velocity[3, :, 3], one["damping"] * along + tension / speed * (np.eye(3) - along), rtol=1e-12, atol=1e-10
    )

    apart = star(laws)
    apart.SetObjectParameter(6 + 2, "activeConnector", False)
    state = testing.State(apart)
    state.q, state.v = q.ravel(), v.ravel()
    others = testing.tangent(apart, state, **POSITION).reshape(6, 3, 6, 3)
    for i in (1, 2, 4, 5):
        np.testing.assert_array_equal(others[i, :, i], by_position[i, :, i])


FORCES = """
from test_lawful_springs import law, motion, residual, star
print(*(value.hex() for value in residual(star([law(i) for i in range(21)]), *motion(21)).ravel()))
"""


@each_width
def test_registers_do_not_change_results(wide: str) -> None:
    """The forces are the same in registers of any width, but for rounding."""
    [portable], [forces] = (numbers_in_registers(FORCES, name) for name in ("portable", wide))
    assert portable.size == 66
    assert agree(forces, portable)
