"""Result of Create functions: an index with the related items."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import Any

from dalembert._core import LoadIndex, MarkerIndex, NodeIndex, ObjectIndex, _created


class CreatedObject(ObjectIndex):
    """An ObjectIndex returned by a Create function. It can be used like a plain ObjectIndex.

    nodes: nodes with the coordinates of the body.
    markers: markers of a connector or joint, or markers on a body or on its nodes.
    loads: loads on these markers of a body, including its weight.
    """

    __slots__ = ("_mbs",)  # many are made: no dictionary each
    _mbs: Any

    @property
    def nodes(self) -> list[NodeIndex]:
        return _numbers(self._mbs.GetObject(self), "nodeNumber")

    @property
    def markers(self) -> list[MarkerIndex]:
        own: list[MarkerIndex] = _numbers(self._mbs.GetObject(self), "markerNumber")
        if own:
            return own
        nodes = [int(node) for node in self.nodes]
        return [
            MarkerIndex(number)
            for number, marker in _items(self._mbs, "Marker")
            if any(int(body) == int(self) for key in ("bodyNumber", "objectNumber") for body in _numbers(marker, key))
            or any(int(node) in nodes for node in _numbers(marker, "nodeNumber"))
        ]

    @property
    def loads(self) -> list[LoadIndex]:
        if _numbers(self._mbs.GetObject(self), "markerNumber"):
            return []
        markers = [int(marker) for marker in self.markers]
        loads = _items(self._mbs, "Load")
        return [LoadIndex(number) for number, load in loads if int(load["markerNumber"]) in markers]

    def __reduce__(self) -> Any:
        return ObjectIndex, (int(self),)


def _items(mbs: Any, kind: str) -> Iterator[tuple[int, dict[str, Any]]]:
    count = getattr(mbs.systemData, f"NumberOf{kind}s")()
    return ((number, getattr(mbs, f"Get{kind}")(number)) for number in range(count))


def _numbers(item: dict[str, Any], key: str) -> list[Any]:
    """Return the references of an item by `key` or its plural, without invalid indices."""
    single = [item[key]] if key in item else []
    return [index for index in [*single, *item.get(f"{key}s", [])] if int(index) >= 0]


# created(mbs, index): the index of an object as a CreatedObject, all else as it is.
created = partial(_created, CreatedObject)
