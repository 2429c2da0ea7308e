"""NodeIndex and its siblings: integers with a type for each kind of item."""

from __future__ import annotations

import copy
import operator
import pickle
from typing import Any

import pytest

import dalembert as exu

TYPES = (exu.NodeIndex, exu.ObjectIndex, exu.MarkerIndex, exu.LoadIndex, exu.SensorIndex)
each_type = pytest.mark.parametrize("index", TYPES, ids=lambda t: t.__name__)


@each_type
def test_behaves_like_an_integer(index: Any) -> None:
    three = index(3)
    assert (int(three), operator.index(three), repr(three), str(three), f"{three:03d}") == (
        3,
        3,
        f"{index.__name__}(3)",
        "3",
        "003",
    )
    assert [10, 11, 12, 13][three] == 13
    assert (three + 1, 1 + three, three - 1, 5 - three, three * 2, -three) == (4, 4, 2, 2, 6, -3)
    assert type(three + 1) is int
    assert three == 3
    assert three == index(3)
    assert three != index(4)
    assert hash(three) == hash(3)
    assert three < 4 <= index(4)
    assert {three: "a"}[3] == "a"
    assert list(range(three)) == [0, 1, 2]


@each_type
def test_kinds_are_not_equal_and_do_not_compare(index: Any) -> None:
    for other in TYPES:
        if other is not index:
            assert index(3) != other(3)
            with pytest.raises(TypeError):
                assert index(3) < other(4)


@each_type
def test_invalid_index_and_conversion(index: Any) -> None:
    assert int(index()) == exu.InvalidIndex() == -1
    assert index(index(5)) == 5
    with pytest.raises(TypeError, match=f"{index.__name__}: received 2.5 .float., but expected an integer"):
        index(2.5)


@each_type
def test_name_pickle_and_copy(index: Any) -> None:
    assert index(3).GetTypeString() == index.__name__
    assert index(3).GetIndex() == 3
    for other in (pickle.loads(pickle.dumps(index(3))), copy.copy(index(3)), copy.deepcopy(index(3))):
        assert other == index(3)
        assert type(other) is index


def test_lists_of_numbers_change_their_item() -> None:
    """Templates of elements are completed entry by entry."""
    cable = exu.ObjectALEANCFCable2D()
    cable.nodeNumbers[2] = exu.NodeIndex(7)
    assert cable.nodeNumbers[2] == 7
    assert isinstance(cable.nodeNumbers[2], exu.NodeIndex)
    joint = exu.ObjectJointSliding2D(slidingMarkerNumbers=[1])
    joint.slidingMarkerNumbers.append(exu.MarkerIndex(4))
    joint.slidingMarkerNumbers += [5, 6]
    del joint.slidingMarkerNumbers[0]
    assert joint.slidingMarkerNumbers == [4, 5, 6]
    assert joint.slidingMarkerNumbers.pop() == 6
    joint.slidingMarkerNumbers.reverse()
    assert joint.slidingMarkerNumbers == [5, 4]


def test_refused_changes_of_lists_are_taken_back() -> None:
    cable = exu.ObjectANCFCable2D(nodeNumbers=[1, 2])
    numbers = cable.nodeNumbers
    for change in (lambda: numbers.append(3), lambda: operator.setitem(numbers, 0, exu.MarkerIndex(0)), numbers.clear):
        with pytest.raises((TypeError, ValueError), match="nodeNumbers"):
            change()
        assert numbers == cable.nodeNumbers == [1, 2]


def test_copies_of_lists_are_lists() -> None:
    cable = exu.ObjectANCFCable2D(nodeNumbers=[1, 2])
    for copied in (
        copy.copy(cable.nodeNumbers),
        copy.deepcopy(cable.nodeNumbers),
        pickle.loads(pickle.dumps(cable.nodeNumbers)),
    ):
        assert type(copied) is list
        copied[0] = 5
    assert cable.nodeNumbers == [1, 2]
