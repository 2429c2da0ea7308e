"""No parameter is accepted and ignored: changing it has an effect on forces, equations, the start, the update of data
coordinates or an output of a model, or it does not fit the model."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item, Parameter
from dalembert._core import testing
from dalembert.testing.exemptions import WITHOUT_EFFECT
from dalembert.testing.outputs import find, reader
from dalembert.testing.refused_changes import ROWS, accessors
from dalembert.testing.scenes import Scene, output_of, random_direction
from dalembert.testing.variants import Variant, variants_with

Variable, Configuration = exu.OutputVariableType, exu.ConfigurationType
STARTS = ("GetODE2Coordinates", "GetODE2Coordinates_t", "GetODE1Coordinates", "GetDataCoordinates")
OF_MARKERS = (Variable.Position, Variable.Velocity, Variable.Rotation, Variable.Coordinates)
STORAGES = ("boolean", "integer", "real", "vector", "matrix3", "matrix6")
# Numbers and arrays; texts, functions and sections have separate tests, and selections of other items change the model.
# Parameters that act only in other models of the item, which have separate tests.
BESIDE_OTHERS = {
    ("ObjectConnectorReevingSystemSprings", "coordinateFactors"),  # test_reeving_coordinates.py
    ("ObjectJointALEMoving2D", "penaltyStiffness"),  # test_ale_ancf_cable_2d.py
}
NUMBERS = [
    (item, row)
    for item, row in ROWS
    if row.type.storage.startswith(STORAGES) and not row.type.index and (item.name, row.name) not in BESIDE_OTHERS
]


def effects(scene: Scene, item: Item) -> Iterator[Any]:
    """All that the item may act on, in states in which contacts touch, are open, slip and stick."""
    mbs, rng = scene.mbs, np.random.default_rng(91)
    for _ in range(12):
        s = testing.State(mbs)
        s.q, s.v = s.q + 0.05 * rng.normal(size=len(s.q)), s.v + 0.3 * rng.normal(size=len(s.v))
        s.a, s.lam = rng.normal(size=len(s.a)), rng.normal(size=len(s.lam))
        s.data = rng.choice([-1, -0.2, -0.05, 0, 0.1, 1], len(s.data))
        yield from (testing.residual(mbs, s), testing.gaps(mbs, s), testing.rates(mbs, s))
        yield from (testing.post_newton(mbs, s), s.data)
    for start in STARTS:
        yield from (getattr(mbs.systemData, start)(c) for c in (Configuration.Initial, Configuration.Reference))
    number = find(scene, item)
    for variable in OF_MARKERS if item.kind == "marker" else ():
        with suppress(ValueError):  # it has others
            yield mbs.GetMarkerOutput(number, variable)
    for output in item.outputs:
        value = output_of(reader(scene, item), getattr(Variable, output.name), Configuration.Current)
        if value is not None:
            yield value


def others(row: Parameter, value: Any, rng: np.random.Generator) -> list[Any]:
    """Values besides the present one, of which some should be valid."""
    match row.type.storage:
        case "boolean":
            return [not value]
        case "integer":
            return [n for n in range(8) if n != value]
        case "real":
            return [1.5 * value + 0.1, 0.5 * value, 1.0, 1e-3]
    if row.effective_check == "unit_vector":
        return [np.reshape([random_direction(rng) for _ in range(np.size(value) // 3)], np.shape(value))]
    if not row.type.real:
        entries = np.array(value, int)
        return [1 - entries, entries[::-1], entries + 1]
    if np.size(value) == 0:
        return [np.ones(n) for n in range(1, 8)]
    noise = 0.1 * rng.normal(size=np.shape(value))
    return [1.3 * np.array(value) + noise, 0.7 * np.array(value), 1 - np.array(value)]


def acts(item: Item, row: Parameter, variant: Variant) -> bool:
    """Whether one of the other values makes a difference, or all are refused."""
    scene = variant.build(seed=71)
    get, put = accessors(scene, item)
    number = find(scene, item)
    before, value, taken = list(effects(scene, item)), get(number, row.name), False
    for other in others(row, value, np.random.default_rng(5)):
        try:
            put(number, row.name, other)
            scene.mbs.Assemble()
            after = list(effects(scene, item))
        except (ValueError, RuntimeError):
            put(number, row.name, value)
            scene.mbs.Assemble()
            continue
        taken = True
        if not all(np.array_equal(a, b, equal_nan=True) for a, b in zip(before, after, strict=True)):
            return True
    return not taken


@pytest.mark.parametrize(("item", "row"), NUMBERS, ids=[f"{item.name}.{row.name}" for item, row in NUMBERS])
def test_parameters_act(item: Item, row: Parameter) -> None:
    """All but those whose specs say that they do not."""
    found = sorted(variants_with(item), key=lambda v: (v.functions, v.item != item.name, not v.data))
    found = found[:20] + [v for v in found if v.functions]
    assert any(acts(item, row, variant) for variant in found) == ((item.name, row.name) not in WITHOUT_EFFECT)
