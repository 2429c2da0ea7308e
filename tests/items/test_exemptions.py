"""Every exemption is needed: the test fails if an exempted item is tested nevertheless."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

import pytest
from test_data_nodes import check_number_of_data_coordinates

from dalembert.testing import exemptions
from dalembert.testing.invariance import check_accelerations, check_forces
from dalembert.testing.momentum import BETWEEN, check_balance
from dalembert.testing.output_rates import check_rates_of_outputs
from dalembert.testing.repeated_solves import joins
from dalembert.testing.scenes import ITEMS
from dalembert.testing.tangents import check_tangent
from dalembert.testing.variants import ALL_VARIANTS, Variant
from dalembert.testing.virtual_work import (
    ALL_CONSTRAINTS,
    CONSTRAINTS,
    check_gaps,
    check_rates,
    free_equations,
    reactions,
)

LISTS = {name: table for name, table in vars(exemptions).items() if isinstance(table, dict) and name.isupper()}


def fails(check: Callable[[Variant], Any], variants: Iterable[Variant]) -> bool:
    """Whether the check fails for one of the models at least."""
    for variant in variants:
        try:
            check(variant)
        except AssertionError:
            return True
    return False


def using(name: str, variants: Iterable[Variant]) -> list[Variant]:
    return [variant for variant in variants if name in variant.uses]


@pytest.mark.parametrize("name", LISTS)
def test_names_and_reasons(name: str) -> None:
    for entry, reason in LISTS[name].items():
        item = entry if isinstance(entry, str) else entry[0]
        assert ITEMS[item].ready and len(reason.split()) > 4, entry


@pytest.mark.parametrize("name", exemptions.NO_MOMENT)
def test_moments(name: str) -> None:
    assert fails(lambda v: check_balance(v, moments=True), [v for v in BETWEEN if v.item == name])


@pytest.mark.parametrize("name", [*exemptions.GLOBAL_AXES, *exemptions.GLOBAL_MARKER])
def test_rotations_of_the_whole(name: str) -> None:
    assert fails(check_forces, using(name, [v for v in ALL_VARIANTS if v.pairs]))


@pytest.mark.parametrize("name", [*exemptions.NONHOLONOMIC, *exemptions.NOT_OF_VALUES])
def test_work_of_the_gaps(name: str) -> None:
    assert fails(check_gaps, using(name, CONSTRAINTS))


@pytest.mark.parametrize("name", [*exemptions.NOT_OF_RATES, *exemptions.VELOCITY_LEVEL])
def test_work_of_the_rates(name: str) -> None:
    assert fails(check_rates, using(name, CONSTRAINTS))


@pytest.mark.parametrize("name", exemptions.WITH_COORDINATES)
def test_work_with_coordinates(name: str) -> None:
    assert fails(check_rates, using(name, ALL_CONSTRAINTS))


@pytest.mark.parametrize("name", exemptions.GLOBAL_WHEN_PARTIAL)
def test_rotations_with_free_axes(name: str) -> None:
    partial = [v for v in ALL_VARIANTS if v.item == name and not all(dict(v.options)["constrainedAxes"])]
    assert fails(check_forces, partial) or fails(check_accelerations, partial)


@pytest.mark.parametrize("name", exemptions.GLOBAL_FUNCTIONS)
def test_rotations_with_user_functions(name: str) -> None:
    variants = [v for v in ALL_VARIANTS if v.item == name and v.functions]
    assert fails(check_forces, variants) or fails(check_accelerations, variants)


@pytest.mark.parametrize("name", exemptions.NO_FORCES)
def test_work_on_points_without_forces(name: str) -> None:
    joints = [
        v for v in ALL_VARIANTS if name in v.uses and joins(v) and "Coordinate" not in ITEMS[v.item].requested_markers
    ]
    assert fails(check_rates, joints)


@pytest.mark.parametrize("name", exemptions.OUT_OF_THE_PLANE)
def test_equations_out_of_the_plane(name: str) -> None:
    """At least one reaction of a plane model does no work."""
    scene = next(v for v in ALL_VARIANTS if v.item == name and v.planar).build()
    s = scene.state()
    assert (~reactions(scene, s).any(axis=0) & ~free_equations(scene, s)).any()


@pytest.mark.parametrize("name", exemptions.DATA_OF_ANY_SIZE)
def test_data_of_another_size_are_accepted(name: str) -> None:
    with pytest.raises(pytest.fail.Exception, match="DID NOT RAISE"):
        check_number_of_data_coordinates(ITEMS[name], more=1)


@pytest.mark.parametrize("name", exemptions.WITHOUT_DATA)
def test_data_may_be_left_out(name: str) -> None:
    next(v for v in ALL_VARIANTS if v.item == name and not v.data).build()


@pytest.mark.parametrize("name", exemptions.NEEDS_FUNCTIONS)
def test_no_force_without_functions(name: str) -> None:
    variants = [replace(v, functions=False) for v in ALL_VARIANTS if v.item == name]
    assert fails(lambda v: check_balance(v, moments=False), variants[:1])


@pytest.mark.parametrize("name", exemptions.HOLDS_JACOBIAN)
def test_tangent_with_the_jacobian_of_a_user(name: str) -> None:
    variants = [v for v in ALL_VARIANTS if v.item == name and v.functions]
    assert fails(lambda v: check_tangent(v, 0, ["together"], exempt=False), variants)


@pytest.mark.parametrize("name", exemptions.ODD_IN_JOINTS)
def test_odd_in_joints(name: str) -> None:
    """There are joints on these items at all, which are tested but not solved."""
    assert using(name, filter(joins, ALL_VARIANTS))


@pytest.mark.parametrize(("name", "output"), exemptions.RATE_OF_OUTPUTS, ids=".".join)
def test_rates_of_outputs(name: str, output: str) -> None:
    assert fails(lambda v: check_rates_of_outputs(v, exempt=set()), using(name, ALL_VARIANTS))
