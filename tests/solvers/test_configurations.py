"""Contents of the configurations after Assemble: the reference values, and the initial ones in all others."""

from __future__ import annotations

import numpy as np
import pytest

import dalembert as exu
from dalembert.itemInterface import NodeGenericODE2

Configuration = exu.ConfigurationType
BEGIN_WITH_INITIAL_VALUES = ["Initial", "Current", "StartOfStep", "Visualization"]


def two_coordinates() -> exu.MainSystem:
    mbs = exu.SystemContainer().AddSystem()
    mbs.AddNode(
        NodeGenericODE2(
            numberOfODE2Coordinates=2,
            referenceCoordinates=[1, 2],
            initialCoordinates=[0.1, 0.2],
            initialCoordinates_t=[3, 4],
        )
    )
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("name", BEGIN_WITH_INITIAL_VALUES)
def test_initial_values(name: str) -> None:
    data, where = two_coordinates().systemData, getattr(Configuration, name)
    assert np.array_equal(data.GetODE2Coordinates(where), [0.1, 0.2])
    assert np.array_equal(data.GetODE2Coordinates_t(where), [3, 4])
    assert np.array_equal(data.GetODE2Coordinates_tt(where), [0, 0])
    assert data.GetTime(where) == 0


def test_reference_values() -> None:
    data = two_coordinates().systemData
    assert np.array_equal(data.GetODE2Coordinates(Configuration.Reference), [1, 2])
    assert data.GetODE2Coordinates_t(Configuration.Reference).size == 0


@pytest.mark.parametrize("name", BEGIN_WITH_INITIAL_VALUES)
def test_each_is_set_alone(name: str) -> None:
    data, where = two_coordinates().systemData, getattr(Configuration, name)
    before = {other: data.GetODE2Coordinates(getattr(Configuration, other)) for other in BEGIN_WITH_INITIAL_VALUES}
    data.SetODE2Coordinates([7, 8], where)
    before[name] = [7, 8]
    for other, expected in before.items():
        assert np.array_equal(data.GetODE2Coordinates(getattr(Configuration, other)), expected)
