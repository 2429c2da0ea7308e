"""User functions get their arguments in the order that the specs state: arguments with names of parameters have their
values."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from codegen.model import Item, UserFunction
from dalembert._core import testing
from dalembert.testing.outputs import find
from dalembert.testing.scenes import READY
from dalembert.testing.variants import variants_with

PASSED = [
    (item, function, names)
    for item in READY
    for function in item.user_functions
    if item.kind != "sensor"
    and function.name in {row.name for row in item.parameters}
    and (names := [a.name for a in function.arguments if a.name in {row.name for row in item.parameters}])
]


@pytest.mark.parametrize(
    ("item", "function", "names"), PASSED, ids=[f"{item.name}.{function.name}" for item, function, _ in PASSED]
)
def test_parameters_arrive_under_their_names(item: Item, function: UserFunction, names: list[str]) -> None:
    variant = next(v for v in variants_with(item) if v.functions)
    scene = variant.build(seed=83)
    mbs, number, kind = scene.mbs, find(scene, item), item.kind.title()
    get, put = getattr(mbs, f"Get{kind}Parameter"), getattr(mbs, f"Set{kind}Parameter")
    original, seen = get(number, function.name), []

    def recording(*arguments: Any) -> Any:
        seen.append(arguments)
        return original(*arguments)

    put(number, function.name, recording)
    call_all(mbs)
    assert seen
    passed = dict(zip(function.argument_names, seen[0], strict=True))
    values = {name: np.array(get(number, name), dtype=float) for name in names}
    for name, value in values.items():
        np.testing.assert_array_equal(np.array(passed[name], dtype=float), value, err_msg=name)
    numbers = [value.tobytes() for value in values.values()]
    assert len(set(numbers)) == len(numbers), "parameters with the same value tell nothing"


def call_all(mbs: exu.MainSystem) -> None:
    """Evaluate all that calls user functions of objects and loads."""
    state = testing.State(mbs)
    for rate_level in (False, True):
        state.rate_level = rate_level
        testing.residual(mbs, state)
    testing.tangent(mbs, state, cq=1, cv=1, ca=1)
    testing.post_newton(mbs, state)
