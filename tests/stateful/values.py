"""Values of item parameters: valid values, and values that are wrong in some way."""

from __future__ import annotations

from random import Random
from typing import Any

import numpy as np
from sample_values import INDEX, sample
from watchers import ITEM_FUNCTIONS

from codegen.model import Item, Parameter
from dalembert.testing.scenes import ITEMS, READY

KINDS = ("node", "object", "marker", "load", "sensor")
LARGE = 1e300
NUMBERS = (0.0, 1.0, -1.0, 1e-300, LARGE, -LARGE, float("nan"), float("inf"))
INTEGERS = (0, 1, 2, 3, 4, 7, -1, -2, 2**31 - 1, 2**31, 2**63, -(2**63), True)
WRONG = ("words", None, {"a": 1}, [], [[]], [1, "a"], object, "\ud800", np.zeros((0, 3)), np.float32(0.5), 1j, b"\0")


def some_argument(random: Random) -> Any:
    """Arguments of a container's method."""
    shape = random.choice(((3,), (2,), (6,), (3, 3), (6, 6), (0,), (2, 3), (4, 3)))
    triplets = [[random.choice((0, 1, 2, -1, 2**31 - 1, 1.5)), random.choice((0, 1, 2, 7)), 1.0] for _ in range(2)]
    integers = [i for i in INTEGERS if i != 2**31 - 1]  # a dense matrix of this size would fill the memory
    return random.choice((*WRONG, *integers, *NUMBERS, 0, 1, 2, 3, np.ones(shape), np.ones(shape).tolist(), triplets))


def some_index(random: Random, kind: str, counts: dict[str, int]) -> Any:
    """Mostly of an item that exists; a number, or an index."""
    last = counts[kind] - 1
    number = random.choice((0, last, random.randint(0, max(0, last)), random.randint(0, max(0, last)), last + 1, -1))
    wanted = INDEX[kind] if random.random() < 0.9 else INDEX[random.choice(KINDS)]
    return wanted(number) if random.random() < 0.5 and number >= 0 else number


def fitting(random: Random, row: Parameter, counts: dict[str, int]) -> Any:
    storage = row.type.storage
    if storage in INDEX:
        return some_index(random, storage, counts)
    if storage.removesuffix("s") in INDEX:
        return [some_index(random, storage.removesuffix("s"), counts) for _ in range(random.choice((1, 2, 2, 2, 3)))]
    if storage == "real":
        return random.choice((0.5, 2.0, random.uniform(0, 1), row.default if isinstance(row.default, float) else 1.0))
    if storage == "integer":
        return random.randint(0, 3)
    if storage == "user_function":
        return random.choice((0, *ITEM_FUNCTIONS))
    if storage == "boolean":
        return random.random() < 0.5
    return sample(row)


def strange(random: Random, row: Parameter) -> Any:
    storage = row.type.storage
    if random.random() < 0.3:
        return random.choice(WRONG)
    if storage == "real":
        return random.choice(NUMBERS)
    if storage.startswith(("vector", "matrix")):
        shape = [size if size is not None else random.randint(0, 4) for size in row.shape or (3,)]
        if random.random() < 0.5 and shape:
            shape[0] = max(0, shape[0] + random.choice((-1, 1)))
        return np.full(shape, random.choice(NUMBERS))
    return random.choice(INTEGERS)


def value_of(random: Random, row: Parameter, counts: dict[str, int], order: float = 0.8) -> Any:
    """A value that fits with the probability `order`."""
    return fitting(random, row, counts) if random.random() < order else strange(random, row)


def rows_of(item: Item) -> list[Parameter]:
    return [row for row in item.parameters if not row.internal and row.name != "name"]


def some_item(random: Random, kind: str) -> Item:
    return random.choice([item for item in READY if item.kind == kind])


def arguments_of(random: Random, item: Item, counts: dict[str, int]) -> dict[str, Any]:
    """Required arguments, and some others."""
    chosen = {}
    for row in rows_of(item):
        needed = row.type.index or row.type.storage == "output_variable" or row.default is None
        if needed or random.random() < 0.15:
            chosen[row.name] = value_of(random, row, counts, 0.97)
    return chosen


def item_of_dictionary(kind: str, entry: dict[str, Any]) -> Item:
    return next(item for item in ITEMS.values() if item.kind == kind and item.type_name == entry[f"{kind}Type"])
