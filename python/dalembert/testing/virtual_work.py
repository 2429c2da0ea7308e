"""Reactions agree with the virtual work of the constraint equations, and do no work on admissible motions."""

from __future__ import annotations

import numpy as np
import pytest

from dalembert._core import testing
from dalembert.testing.exemptions import (
    NO_FORCES,
    NONHOLONOMIC,
    NOT_OF_RATES,
    NOT_OF_VALUES,
    VELOCITY_LEVEL,
    WITH_COORDINATES,
)
from dalembert.testing.scenes import ITEMS, Scene
from dalembert.testing.tangents import moved, random_state
from dalembert.testing.variants import ALL_VARIANTS, Variant

ALL_CONSTRAINTS = [
    v for v in ALL_VARIANTS if ITEMS[v.item].object_type in ("Constraint", "Joint") and not v.uses & set(NO_FORCES)
]
CONSTRAINTS = [v for v in ALL_CONSTRAINTS if v.item not in WITH_COORDINATES]


def at_velocity_level(variant: Variant) -> bool:
    return variant.item in VELOCITY_LEVEL and dict(variant.options).get("velocityLevel", False)


def holonomic(variant: Variant) -> bool:
    return (
        not variant.uses & {*NOT_OF_VALUES, *NOT_OF_RATES}
        and variant.item not in NONHOLONOMIC
        and not dict(variant.options).get("velocityLevel", False)
    )


def reactions(scene: Scene, s: testing.State) -> np.ndarray:
    """The forces of unit multipliers as columns."""
    columns = []
    for unit in np.eye(len(s.lam)):
        forces = []
        for factor in (1.0, 0.0):
            s.lam = factor * unit
            forces.append(testing.residual(scene.mbs, s)[: len(s.q)])
        columns.append(forces[0] - forces[1])
    return np.array(columns).T


def free_equations(scene: Scene, s: testing.State) -> np.ndarray:
    """Equations that set their multiplier to zero, such as those of free directions: their gap is the multiplier."""
    sides = []
    for step in (0.0, 1.0):
        other = s.copy()
        other.lam = s.lam + step
        sides.append(testing.gaps(scene.mbs, other))
    return sides[0] != sides[1]


def prescribed_equations(scene: Scene, variant: Variant) -> int:
    """How many equations of the item hold something, by its parameters."""
    axes = dict(variant.options).get("constrainedAxes")
    return len(scene.mbs.systemData.GetObjectLTGAE(scene.target[1])) if axes is None else sum(axes)


def check_rates(variant: Variant) -> None:
    """Rates of gaps are linear in the velocities: differences of any step are exact but for rounding."""
    scene = variant.build(seed=11)
    s = random_state(scene, seed=12)
    forces, free = reactions(scene, s), free_equations(scene, s)
    rows = scene.mbs.systemData.GetObjectLTGAE(scene.target[1])
    assert np.count_nonzero(~free[rows]) == prescribed_equations(scene, variant)
    s.rate_level, s.lam = True, 0 * s.lam
    gradient = np.empty_like(forces.T)
    v = s.v
    for i, unit in enumerate(np.eye(len(v))):
        sides = []
        for sign in (1.0, -1.0):
            s.v = v + sign * unit
            sides.append(testing.gaps(scene.mbs, s))
        gradient[:, i] = (sides[0] - sides[1]) / 2
    scale = np.abs(forces).max()
    assert scale > 0.01
    np.testing.assert_allclose(forces.T, np.where(free[:, None], 0, gradient), rtol=0, atol=1e-12 * scale)


@pytest.mark.parametrize(
    "variant",
    [v for v in CONSTRAINTS if not at_velocity_level(v) and not v.uses & set(NOT_OF_RATES)],
    ids=lambda variant: variant.id,
)
def test_reaction_is_the_virtual_work_of_the_rates(variant: Variant) -> None:
    check_rates(variant)


def check_gaps(variant: Variant) -> None:
    """Central differences of step 1e-5: errors of 1e-10 times third derivatives, and of rounding. Euler parameters keep
    their norm: along it, virtual work is not defined."""
    scene = variant.build(seed=13)
    s = scene.state()
    forces, free = reactions(scene, s), free_equations(scene, s)
    s.lam = 0 * s.lam
    gradient = np.empty_like(forces.T)
    for i in range(len(s.q)):
        up, down = (testing.gaps(scene.mbs, moved(scene.mbs, s, "q", i, h, {})) for h in (1e-5, -1e-5))
        gradient[:, i] = (up - down) / 2e-5
    rows = scene.mbs.systemData.GetObjectLTGAE(scene.target[1])
    along = np.eye(len(s.q))
    for number, kind, motion in scene.nodes:
        if kind.frame == "ep":
            first = scene.mbs.GetNodeODE2Index(number) + 3
            p = kind.total(motion)[3:]
            along[first : first + 4, first : first + 4] -= np.outer(p, p)
    scale = np.abs(forces).max()
    assert scale > 0.01
    wanted = np.where(free[:, None], 0, gradient)
    np.testing.assert_allclose((forces.T @ along)[rows], (wanted @ along)[rows], rtol=0, atol=1e-8 * scale)


@pytest.mark.parametrize("variant", [v for v in CONSTRAINTS if holonomic(v)], ids=lambda variant: variant.id)
def test_reaction_is_the_virtual_work_of_the_gaps(variant: Variant) -> None:
    check_gaps(variant)


@pytest.mark.parametrize("variant", ALL_CONSTRAINTS, ids=lambda variant: variant.id)
def test_inactive_constraints_set_their_multipliers_to_zero(variant: Variant) -> None:
    scene = variant.build(seed=13)
    s = random_state(scene, seed=14)
    rows = scene.mbs.systemData.GetObjectLTGAE(scene.target[1])
    assert len(rows) > 0
    scene.mbs.SetObjectParameter(scene.target[1], "activeConnector", False)
    np.testing.assert_array_equal(testing.gaps(scene.mbs, s)[rows], s.lam[rows])
    before = testing.residual(scene.mbs, s)[: len(s.q)]
    lam = s.lam
    lam[rows] += 1.0
    s.lam = lam
    np.testing.assert_array_equal(testing.residual(scene.mbs, s)[: len(s.q)], before)
