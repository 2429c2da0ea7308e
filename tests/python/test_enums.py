"""Enumerations: names, numbers, texts and flags."""

from __future__ import annotations

import copy
import pickle
from enum import IntFlag
from typing import Any

import pytest

import dalembert as exu


def test_members_behave_as_numbers_with_names() -> None:
    node = exu.NodeType.RotationEulerParameters
    assert int(node) == node == 128 and hash(node) == hash(128)
    assert repr(node) == "<NodeType.RotationEulerParameters: 128>"
    assert str(node) == f"{node}" == "NodeType.RotationEulerParameters"
    assert (node.name, node.value) == ("RotationEulerParameters", 128)
    assert exu.NodeType(128) is node is exu.NodeType["RotationEulerParameters"]
    assert exu.NodeType.__members__["_None"] == 0
    assert ["a", "b"][exu.ItemType.Node] == "b"


@pytest.mark.parametrize("member", [exu.DynamicSolverType.RK44, exu.OutputVariableType.ConstraintEquation])
def test_copies_are_the_member_itself(member: Any) -> None:
    assert pickle.loads(pickle.dumps(member)) is member
    assert copy.deepcopy(member) is copy.copy(member) is member


def test_flags() -> None:
    both = exu.NodeType.Position | exu.NodeType.Orientation
    assert both == 48 and isinstance(both, exu.NodeType)
    assert exu.NodeType.Position in both and exu.NodeType.Ground not in both
    flags = {name for name, kind in vars(exu).items() if isinstance(kind, type) and issubclass(kind, IntFlag)}
    assert flags == {
        "AccessFunctionType",
        "LinearSolverType",
        "MarkerType",
        "NodeGroup",
        "NodeType",
        "ObjectType",
    }


def test_unknown_number() -> None:
    with pytest.raises(ValueError, match="99 is not a valid DynamicSolverType"):
        exu.DynamicSolverType(99)
