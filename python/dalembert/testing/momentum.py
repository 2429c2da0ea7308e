"""Forces between two bodies conserve linear and angular momentum."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dalembert._core import testing
from dalembert.testing.exemptions import GLOBAL_MARKER, NO_MOMENT
from dalembert.testing.scenes import ITEMS, Scene, is_ground, of_one_coordinate, rests
from dalembert.testing.tangents import random_state
from dalembert.testing.variants import ALL_VARIANTS, Variant

BETWEEN = [
    v
    for v in ALL_VARIANTS
    if ITEMS[v.item].kind == "object"
    and len(v.pairs) == 2
    and v.pairs[0][0]
    and "Coordinate" not in ITEMS[v.item].requested_markers
    and not any(not c[0] or rests(c) or is_ground(c) or of_one_coordinate(c) for _, c in v.pairs)
    and not v.uses & set(GLOBAL_MARKER)
]


def effect(scene: Scene, s: testing.State) -> np.ndarray:
    """Generalised forces of the item under test."""
    residuals = []
    for active in (True, False):
        scene.mbs.SetObjectParameter(scene.target[1], "activeConnector", active)
        residuals.append(testing.residual(scene.mbs, s)[: len(s.q)])
    return residuals[0] - residuals[1]


def in_touch(scene: Scene, s: testing.State, value: float = -0.2) -> testing.State:
    """Contacts act."""
    s.data = np.full(len(s.data), value)
    return s


def check_balance(variant: Variant, moments: bool) -> None:
    """Joints with their gaps closed: forces of an open joint have different points of application."""
    joint = ITEMS[variant.item].object_type in ("Constraint", "Joint")
    # Random states of elements do not close a joint, nor do small deformations.
    closed = joint and not any(
        "SuperElement" in marker or (body and ITEMS[body].object_type == "FiniteElement")
        for marker, (body, _) in variant.pairs
    )
    scene = variant.build(seed=21, closed=closed)
    s = in_touch(scene, scene.state())
    s.lam = np.random.default_rng(22).uniform(0.5, 1.5, len(s.lam))
    forces = effect(scene, s)
    if not forces.any():  # bodies separate so fast that there is no normal force: the other way round there is
        s.v = -np.asarray(s.v)
        forces = effect(scene, s)
    wrenches = scene.wrenches(forces)
    positions = np.array([motion.position for _, _, motion in scene.nodes])
    scale = np.abs(wrenches).max()
    assert scale > 0.01
    force = wrenches[:, :3].sum(axis=0)
    np.testing.assert_allclose(force, 0, atol=1e-12 * scale)
    if moments and (closed or not joint):
        moment = (np.cross(positions, wrenches[:, :3]) + wrenches[:, 3:]).sum(axis=0)
        np.testing.assert_allclose(moment[2:] if scene.planar else moment, 0, atol=1e-12 * scale)


@pytest.mark.parametrize("variant", BETWEEN, ids=lambda variant: variant.id)
def test_action_is_reaction(variant: Variant) -> None:
    check_balance(variant, moments=variant.item not in NO_MOMENT)


COORDINATE = [
    v
    for v in ALL_VARIANTS
    if ITEMS[v.item].kind == "object"
    and all(m.startswith("MarkerNode") and m.endswith("Coordinate") for m, _ in v.pairs)
]


@pytest.mark.parametrize("variant", COORDINATE, ids=lambda variant: variant.id)
def test_coordinates_feel_opposite_forces(variant: Variant) -> None:
    """Forces on coordinates, with the factors of both: the force on one is minus that on the other."""
    scene = variant.build(seed=23)
    s = in_touch(scene, random_state(scene, seed=24))
    item = dict(scene.mbs.GetObject(scene.target[1]))
    factors = [item.get("factor0", 1.0), item.get("factor1", item.get("factorValue1", 1.0))]
    r = effect(scene, s)
    assert np.abs(r).max() > 1e-3
    markers = [scene.mbs.GetMarker(number) for number in item["markerNumbers"]]
    numbers = [global_coordinate(scene, marker) for marker in markers]
    forces = [r[number] / factor for number, factor in zip(numbers, factors, strict=True) if number is not None]
    if len(forces) == 2:
        assert forces[0] == pytest.approx(-forces[1], rel=1e-12)
    elif not any("rotationCoordinate" in marker for marker in markers):
        assert np.count_nonzero(r) == 1  # nothing but the coordinate itself


def global_coordinate(scene: Scene, marker: dict[str, Any]) -> int | None:
    """None: ground, or a rotation that is none of the node's coordinates."""
    if "rotationCoordinate" in marker or scene.mbs.GetNode(marker["nodeNumber"])["nodeType"] == "PointGround":
        return None
    return int(scene.mbs.GetNodeODE2Index(marker["nodeNumber"]) + marker["coordinate"])


def test_free_pair_has_a_lie_node() -> None:
    """The list above is not empty by mistake."""
    assert any("NodeRigidBodyRotVecLG" in v.uses for v in BETWEEN)
