"""mbs.systemData: coordinates of all configurations, index tables, and rejected values."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu

CURRENT, INITIAL, REFERENCE = (getattr(exu.ConfigurationType, name) for name in ("Current", "Initial", "Reference"))


def make_system() -> Any:
    """A mass point and a rigid body (Euler parameters) with a spherical joint, two ODE1 coordinates and one data coordinate."""
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    point = mbs.AddNode(exu.NodePoint(referenceCoordinates=[1, 2, 3], initialVelocities=[1, 0, 0]))
    mass = mbs.AddObject(exu.ObjectMassPoint(physicsMass=10, nodeNumber=point))
    frame = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0]))
    body = mbs.AddObject(exu.ObjectRigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=frame))
    first = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mass))
    second = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
    mbs.AddNode(exu.NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[1, 2], numberOfODE1Coordinates=2))
    mbs.AddNode(exu.NodeGenericData(initialCoordinates=[7], numberOfDataCoordinates=1))
    mbs.AddObject(exu.ObjectJointSpherical(markerNumbers=[first, second]))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=first, loadVector=[1, 0, 0]))
    return mbs


@pytest.fixture
def mbs() -> Any:
    mbs = make_system()
    mbs.Assemble()
    return mbs


def test_sizes(mbs: Any) -> None:
    data = mbs.systemData
    methods = (data.ODE2Size, data.ODE1Size, data.AEsize, data.DataSize, data.SystemSize)
    assert [size() for size in methods] == [10, 2, 4, 1, 16]
    assert [size(REFERENCE) for size in methods] == [10, 2, 0, 0, 12]
    counts = (data.NumberOfNodes, data.NumberOfObjects, data.NumberOfMarkers, data.NumberOfLoads, data.NumberOfSensors)
    assert [count() for count in counts] == [4, 3, 2, 1, 0]


def test_coordinates(mbs: Any) -> None:
    data = mbs.systemData
    reference = [1, 2, 3, 0, 0, 0, 1, 0, 0, 0]
    np.testing.assert_array_equal(data.GetODE2Coordinates(REFERENCE), reference)
    np.testing.assert_array_equal(data.GetODE2CoordinatesTotal(REFERENCE), reference)
    np.testing.assert_array_equal(data.GetODE2CoordinatesTotal(), reference)
    np.testing.assert_array_equal(data.GetODE2Coordinates_t(), [1] + [0] * 9)
    np.testing.assert_array_equal(data.GetODE1Coordinates(INITIAL), [1, 2])
    np.testing.assert_array_equal(data.GetDataCoordinates(), [7])
    assert data.GetODE2Coordinates_t(REFERENCE).size == data.GetAECoordinates(REFERENCE).size == 0
    state = data.GetSystemState()
    assert [part.size for part in state] == [10, 10, 2, 4, 1]
    assert set(data.GetSystemStateDict()) == {
        "ODE1Coords", "ODE1Coords_t", "ODE2Coords", "ODE2Coords_t", "ODE2Coords_tt", "AECoords", "dataCoords",
    }  # fmt: skip


@pytest.mark.parametrize("kind", ["ODE2Coordinates", "ODE2Coordinates_t", "ODE2Coordinates_tt", "ODE1Coordinates",
                                  "ODE1Coordinates_t", "AECoordinates", "DataCoordinates"])  # fmt: skip
def test_set_and_get(mbs: Any, kind: str) -> None:
    get, put = getattr(mbs.systemData, "Get" + kind), getattr(mbs.systemData, "Set" + kind)
    values = np.arange(1.0, get().size + 1)
    before = get(INITIAL)
    put(values)
    np.testing.assert_array_equal(get(), values)
    np.testing.assert_array_equal(get(INITIAL), before)
    put(coordinates=list(-values), configuration=INITIAL)
    np.testing.assert_array_equal(get(INITIAL), -values)
    for wrong, text in (
        (values[:-1], f"but expected {len(values)} finite numbers, the {kind}"),
        (values * np.nan, "finite"),
        ("a", "received 'a'"),
    ):
        with pytest.raises((ValueError, TypeError), match=text):
            put(wrong)
    np.testing.assert_array_equal(get(), values)


def test_views_and_copies(mbs: Any) -> None:
    data = mbs.systemData
    copy, view = data.GetODE2Coordinates(), data.GetODE2Coordinates(copy=False)
    view[0] = 5
    assert copy[0] == 0 and data.GetODE2Coordinates()[0] == 5
    data.SetODE2Coordinates(np.full(10, 3.0))
    assert view[0] == 3
    data.GetSystemStateDict(reference=True)["dataCoords"][0] = 9
    assert data.GetDataCoordinates()[0] == 9


def test_views_survive_another_assembly(mbs: Any) -> None:
    view = mbs.systemData.GetODE2Coordinates(copy=False)
    view[:] = 4
    for _ in range(3):  # memory that were free would be used again
        mbs.AddNode(exu.NodePoint())
        mbs.Assemble()
    np.testing.assert_array_equal(view, np.full(10, 4.0))
    view[:] = 5
    np.testing.assert_array_equal(mbs.systemData.GetODE2Coordinates(), np.zeros(19))


def test_system_state(mbs: Any) -> None:
    data = mbs.systemData
    state = [part + 1 for part in data.GetSystemState()]
    data.SetSystemState(state, configuration=INITIAL)
    for part, other in zip(state, data.GetSystemState(INITIAL), strict=True):
        np.testing.assert_array_equal(part, other)
    with pytest.raises(ValueError, match="a list of 5 vectors"):
        data.SetSystemState([[1], [2]])
    with pytest.raises(ValueError, match="expected 1 finite numbers, the DataCoordinates"):
        data.SetSystemState([part + 1 for part in state[:4]] + [[1, 2]], INITIAL)
    np.testing.assert_array_equal(data.GetODE2Coordinates(INITIAL), state[0])


def test_time(mbs: Any) -> None:
    data = mbs.systemData
    data.SetTime(newTime=3)
    assert data.GetTime() == 3.0 and data.GetTime(INITIAL) == 0.0
    with pytest.raises(ValueError, match="parameter 'newTime': received nan"):
        data.SetTime(float("nan"))


def test_index_tables(mbs: Any, capsys: pytest.CaptureFixture[str]) -> None:
    data = mbs.systemData
    assert [data.GetObjectLTGODE2(i) for i in range(3)] == [[0, 1, 2], list(range(3, 10)), list(range(10))]
    assert [data.GetObjectLTGAE(i) for i in range(3)] == [[], [0], [1, 2, 3]]
    assert [data.GetNodeLTGODE2(i) for i in range(4)] == [[0, 1, 2], list(range(3, 10)), [], []]
    assert [data.GetNodeLTGODE1(i) for i in range(4)] == [[], [], [0, 1], []]
    assert data.GetNodeLTGAE(1) == [0] and data.GetNodeLTGData(3) == [0] and data.GetObjectLTGData(0) == []
    data.AddODE2LoadDependencies(0, [0, 1, 2])
    data.InfoLTG()
    output = capsys.readouterr().out
    assert "object 2 AE LTG=[1,2,3]" in output and "load 0 ODE2 dependencies=[0,1,2]" in output
    data.Info()
    assert "'nodeType': 'Point'" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("call", "error", "text"),
    [
        (lambda d: d.GetObjectLTGODE2(99), IndexError, "there is no object 99. The system has 3 objects"),
        (
            lambda d: d.GetObjectLTGODE2(exu.NodeIndex(0)),
            TypeError,
            "the number of an object: ObjectIndex, int or name",
        ),
        (lambda d: d.GetNodeLTGODE2(0.5), TypeError, "received 0.5"),
        (lambda d: d.GetODE2Coordinates(exu.ConfigurationType._None), ValueError, "ConfigurationType.Current, Initial"),
        (lambda d: d.GetODE2Coordinates(1), TypeError, "mbs.systemData.GetODE2Coordinates, parameter 'configuration'"),
        (lambda d: d.AddODE2LoadDependencies(5, [0]), IndexError, "there is no load 5"),
        (lambda d: d.AddODE2LoadDependencies(0, [20]), IndexError, "received 20, but expected numbers from 0 to 9"),
    ],
)
def test_errors(mbs: Any, call: Any, error: Any, text: str) -> None:
    with pytest.raises(error, match=text):
        call(mbs.systemData)


def test_not_available_before_assemble() -> None:
    mbs = make_system()
    data = mbs.systemData
    assert data.NumberOfNodes() == 4 and data.GetTime() == 0.0
    for call in (
        data.ODE2Size,
        data.GetODE2Coordinates,
        data.GetSystemState,
        lambda: data.GetObjectLTGODE2(0),
        lambda: data.SetTime(1),
    ):
        with pytest.raises(RuntimeError, match=r"mbs.systemData.*the system is not assembled. Call mbs.Assemble"):
            call()


def test_data_keeps_its_system_alive() -> None:
    mbs = make_system()
    mbs.Assemble()
    view = mbs.systemData.GetODE2Coordinates(copy=False)
    del mbs
    assert view.size == 10 and not view.any()
