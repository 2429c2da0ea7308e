"""User functions of items: kept as they are, called with the system, and their errors keep their own type."""

from __future__ import annotations

import gc
import weakref
from typing import Any

import pytest

import dalembert as exu


def load(mbs: exu.MainSystem, function: Any) -> exu.LoadIndex:
    node = mbs.AddNode(exu.NodePoint())
    body = mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
    return mbs.AddLoad(exu.Force("wind", markerNumber=marker, loadVector=[1, 2, 3], loadVectorUserFunction=function))


def test_function_is_kept_and_gets_the_system(mbs: exu.MainSystem) -> None:
    calls = []

    def wind(system: exu.MainSystem, t: float, vector: Any) -> list[float]:
        calls.append((system, t, list(vector)))
        return [2 * x for x in vector]

    number = load(mbs, wind)
    assert mbs.GetLoadParameter(number, "loadVectorUserFunction") is wind
    assert mbs.GetLoad(number)["loadVectorUserFunction"] is wind
    mbs.Assemble()
    assert mbs.GetLoadValues(number).tolist() == [2, 4, 6]
    assert calls[-1][0] is mbs
    assert calls[-1][1:] == (0.0, [1, 2, 3])


@pytest.mark.parametrize("nothing", [0, None, 0.0 == 1])
def test_no_function(mbs: exu.MainSystem, nothing: Any) -> None:
    number = load(mbs, nothing)
    assert mbs.GetLoadParameter(number, "loadVectorUserFunction") == 0
    mbs.Assemble()
    assert mbs.GetLoadValues(number).tolist() == [1, 2, 3]


def test_set_and_remove(mbs: exu.MainSystem) -> None:
    number = load(mbs, 0)
    mbs.Assemble()
    mbs.SetLoadParameter(
        number, "loadVectorUserFunction", lambda system, t, vector: [7, 8, 9] if system is mbs else None
    )
    assert mbs.GetLoadValues(number).tolist() == [7, 8, 9]
    mbs.SetLoadParameter(number, "loadVectorUserFunction", 0)
    assert mbs.GetLoadValues(number).tolist() == [1, 2, 3]


def test_exception_keeps_its_type_and_says_where(mbs: exu.MainSystem) -> None:
    class Calm(Exception):
        pass

    def wind(system: exu.MainSystem, t: float, vector: Any) -> list[float]:
        raise Calm("no wind today")

    number = load(mbs, wind)
    mbs.Assemble()
    with pytest.raises(Calm, match="no wind today") as caught:
        mbs.GetLoadValues(number)
    assert caught.value.__notes__ == [
        "in user function 'loadVectorUserFunction' of load 0 'wind' (LoadForceVector), at time 0.000000"
    ]


@pytest.mark.parametrize(
    ("result", "error", "text"),
    [
        (
            [1, 2],
            ValueError,
            "received [1, 2] (list of length 2) as result, but expected a list or array of 3 numbers.",
        ),
        (None, TypeError, "received None as result, but expected a list or array of 3 numbers"),
        ([1, 2, "x"], TypeError, "Entry 2 is 'x' (str), not a number."),
        ([1, 2, float("nan")], ValueError, "Entry 2 is nan (float), not a finite number."),
    ],
)
def test_wrong_results(mbs: exu.MainSystem, result: Any, error: type[Exception], text: str) -> None:
    number = load(mbs, lambda system, t, vector: result)
    mbs.Assemble()
    with pytest.raises(error) as caught:
        mbs.GetLoadValues(number)
    assert str(caught.value).startswith("user function 'loadVectorUserFunction' of load 0 'wind' (LoadForceVector): ")
    assert text in str(caught.value)


def test_functions_are_released_with_the_system() -> None:
    def make() -> weakref.ref[Any]:
        mbs = exu.SystemContainer().AddSystem()

        def wind(system: exu.MainSystem, t: float, vector: Any) -> Any:
            return vector

        load(mbs, wind)
        return weakref.ref(wind)

    reference = make()
    gc.collect()
    assert reference() is None
