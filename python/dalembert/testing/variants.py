"""Selection of random models for tests: every ready item on each node type or kind of marker, with all its options and
user functions, as
the [scene] tables of the specs say."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from codegen.model import Item
from codegen.scene import End
from dalembert.testing.exemptions import NEEDS_FUNCTIONS, NO_FORCES, WITHOUT_DATA
from dalembert.testing.motions import Place
from dalembert.testing.scenes import (
    BODIES,
    ITEMS,
    READY,
    RIGID,
    Scene,
    carriers_of,
    in_plane,
    is_ground,
    on_markers,
    placed,
)
from dalembert.testing.specs import TESTED

Pair = tuple[tuple[str, tuple[str, str]], ...]  # markers, each on a body and its node; without a name: another body
SHAPES = {"Position", "Orientation", "Coordinate", "BodyMass"}  # of what markers pass on


@dataclass(frozen=True)
class Variant:
    """A choice of classes for a test model: the item, its markers, and their carriers (body and node)."""

    item: str
    pairs: Pair = ()
    options: tuple[tuple[str, Any], ...] = ()
    functions: bool = False
    data: bool = False

    @property
    def id(self) -> str:
        words = [
            f"{marker.removeprefix('Marker')}({body.removeprefix('Object') or node}{'/' + node if body else ''})"
            for marker, (body, node) in self.pairs
        ]
        words += [f"{key}={value}".replace(" ", "") for key, value in self.options]
        return "-".join(
            [self.item, *words, *(["functions"] if self.functions else []), *(["data"] if self.data else [])]
        )

    @property
    def uses(self) -> set[str]:
        """Names of the items in the model, as far as the variant decides them."""
        names = {self.item, *(name for marker, carrier in self.pairs for name in (marker, *carrier))}
        names |= {node.type for name in names & ITEMS.keys() for node in ITEMS[name].scene.nodes}
        return (names | ({"NodeGenericData"} if self.data else set())) & ITEMS.keys()

    @property
    def planar(self) -> bool:
        return any(in_plane(carrier) for _, carrier in self.pairs)

    def build(self, seed: int = 0, place: Place | None = None, closed: bool = False, resting: bool = False) -> Scene:
        scene = Scene(seed, place or Place(), self.planar, resting)
        scene.build(self, closed)
        return scene


# ---- which models --------------------------------------------------------------------------------------------------------
def made(pair: Iterable[End]) -> Pair:
    return tuple(placed(end) for end in pair)


def shape(marker: str) -> set[str]:
    """Quantities that a marker provides, of those that connectors request."""
    return set(ITEMS[marker].provisions) & SHAPES


def shared(pair: Pair) -> set[str]:
    return set.intersection(*(shape(marker) for marker, _ in pair if marker))


def is_ready(pair: Pair) -> bool:
    return all(
        not name or ITEMS[name].ready for marker, carrier in pair for name in (marker, *carrier) if name in ITEMS
    )


def on_every_body(marker: Item) -> list[Pair]:
    beside = tuple(("", carrier) for _, carrier in made(marker.scene.beside))
    bodies = [body for body in BODIES if body[0] not in NO_FORCES] if marker.scene.every_body else []
    return [((marker.name, body), *beside) for body in bodies]


def all_pairs() -> list[Pair]:
    """Markers first, then bodies and nodes; variants with markers of one type are first."""
    owners = sorted((item for item in ITEMS.values() if not on_markers(item)), key=lambda item: item.kind != "marker")
    pairs = [pair for item in owners for pair in [*map(made, item.scene.pairs), *on_every_body(item)]]
    return sorted(filter(is_ready, pairs), key=lambda pair: len({marker for marker, _ in pair if marker}))


ALL_PAIRS = all_pairs()


def is_planar(pair: Pair) -> bool:
    """All that moves does so in the plane."""
    return all(in_plane(carrier) for _, carrier in pair if not is_ground(carrier))


def fitting(item: Item) -> list[Pair]:
    """Pairs whose markers provide the requested quantities, and as few others as possible."""
    asked = set(item.requested_markers if item.scene.fits is None else item.scene.fits) & SHAPES
    if not asked:
        return []
    enough = [pair for pair in ALL_PAIRS if asked <= shared(pair)]
    least = min(len(shared(pair)) for pair in enough)
    pairs = [pair for pair in enough if len(shared(pair)) == least]
    return [pair for pair in pairs if is_planar(pair)] if item.scene.planar else pairs


def pairs_of(item: Item) -> list[Pair]:
    """Its own, then those that fit. A load acts on the first marker; other bodies stand by."""
    pairs = list(dict.fromkeys([*filter(is_ready, map(made, item.scene.pairs)), *fitting(item)]))
    if item.kind != "load":
        return [pair for pair in pairs if all(marker for marker, _ in pair)]
    return [(pair[0], *(("", carrier) for _, carrier in pair[1:])) for pair in pairs if not is_ground(pair[0][1])]


def optional_data(item: Item) -> bool:
    """May the data node be left out?"""
    rows = [row for row in item.parameters if row.type.storage == "node"]
    return all(row.optional for row in rows) or item.name in WITHOUT_DATA


def variants_about(item: Item) -> Iterator[Variant]:
    """The models whose target is the item."""
    options = [tuple(option.items()) for option in item.scene.options]
    if on_markers(item):
        yield from on_pairs(item, options)
    elif item.kind == "object" and not is_ground((item.name, "")):
        carriers = [body for body in carriers_of(item) if body in BODIES or not item.nodes]
        copies = 1 if item.object_type == "Object" else 2
        yield from (Variant(item.name, (("", carrier),) * copies, o) for carrier in carriers for o in options)
        if any(row.type.function for row in item.parameters):
            yield Variant(item.name, (("", carriers[0]),), functions=True)
    elif item.kind == "node" and item.scene.options != ({},):
        yield from (Variant(item.name, (("", RIGID[item.name]),) * 2, o) for o in options)


def on_pairs(item: Item, options: list[tuple[tuple[str, Any], ...]]) -> Iterator[Variant]:
    """All options on the first pair of markers, and the first option on all others."""
    pairs = pairs_of(item)
    data, functions = "GenericData" in item.requested_nodes, item.name in NEEDS_FUNCTIONS
    yield from (Variant(item.name, pairs[0], o, functions, data) for o in options)
    optional = data and optional_data(item)
    if optional:
        yield Variant(item.name, pairs[0], options[0], functions)
    yield from (Variant(item.name, pair, options[0], functions, data and not optional) for pair in pairs[1:])
    if item.user_functions and not functions:
        yield Variant(item.name, pairs[0], options[0], functions=True, data=data)


# Items of a package are tested in all models that use them.
ALL_VARIANTS = [variant for item in READY for variant in variants_about(item) if variant.uses & TESTED]


def variants_with(item: Item) -> list[Variant]:
    """All models that use the item."""
    return [variant for variant in ALL_VARIANTS if item.name in variant.uses]
