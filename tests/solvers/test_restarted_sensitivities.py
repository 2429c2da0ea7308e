"""Derivatives across events by generalized alpha in systems with constraints, where steps start again after each event."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
import pytest
import scipy.integrate
import scipy.optimize
from test_runge_kutta_sensitivities import driven, stopped
from test_sensitivities import (
    CENTRAL,
    Variable,
    ground_coordinate,
    new_system,
    refusal,
    thrown,
    with_events,
)

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateConstraint,
    CoordinateSpringDamperExt,
    GenericJoint,
    LoadMassProportional,
    MarkerBodyMass,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodeGenericData,
    NodeRigidBodyEP,
    NodeRigidBodyRotVecLG,
    NodeRigidBodyRxyz,
    ObjectContactCoordinate,
    ObjectGround,
    ObjectRigidBody,
    SensorBody,
)

NODES = {"RotVecLG": NodeRigidBodyRotVecLG, "EP": NodeRigidBodyEP, "Rxyz": NodeRigidBodyRxyz}


def swinging(node: str, mass: float = 2.0, stiffness: float = 1e4, edge: float = -0.2, rubs: bool = False) -> Any:
    """A body on a ball joint that falls on a spring, or swings through a friction element."""
    mbs = new_system()
    turned = [1, 0, 0, 0] if node == "EP" else [0, 0, 0]
    place = mbs.AddNode(NODES[node](referenceCoordinates=[0.5, 0, 0, *turned]))
    body = mbs.AddObject(
        ObjectRigidBody(
            physicsMass=mass,
            physicsInertia=[0.1, 0.3, 0.35, 0.02, 0.01, 0.03],
            physicsCenterOfMass=[0.05, 0.02, 0.01],
            nodeNumber=place,
            name="body",
        )
    )
    pins = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround()))),
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[-0.5, 0, 0])),
    ]
    mbs.AddObject(GenericJoint(markerNumbers=pins, constrainedAxes=[1, 1, 1, 0, 0, 0], name="joint"))
    center = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=center, loadVector=[0, -9.81, 0]))
    ends = [ground_coordinate(mbs), mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=place, coordinate=1))]
    if rubs:
        history = mbs.AddNode(NodeGenericData(initialCoordinates=[1, 0, 0], numberOfDataCoordinates=3))
        mbs.AddObject(
            CoordinateSpringDamperExt(
                markerNumbers=ends,
                nodeNumber=history,
                stiffness=150,
                fDynamicFriction=8,
                stickingStiffness=stiffness,
                stickingDamping=20,
                frictionProportionalZone=0,
                name="stop",
            )
        )
    else:
        history = mbs.AddNode(NodeGenericData(initialCoordinates=[-edge], numberOfDataCoordinates=1))
        mbs.AddObject(
            ObjectContactCoordinate(
                markerNumbers=ends,
                nodeNumber=history,
                contactStiffness=stiffness,
                contactDamping=5,
                offset=edge,
                name="stop",
            )
        )
    mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.Position, name="p"))
    mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.AngularVelocity, name="w"))
    mbs.Assemble()
    return mbs


class Case(NamedTuple):
    build: Callable[..., Any]
    parameters: dict[str, tuple[float, Any]]  # by argument of `build`: value, and place in the model
    outputs: dict[str, Any]
    end: float
    steps: int


MASS, CONTACT = ("body", "physicsMass"), ("stop", "contactStiffness")
MOTION = {
    "y": exu.At("p", component=1),
    "z": exu.At("p", component=2),
    "between": exu.At("p", 0.4321, component=1),
    "w": exu.At("w", component=2),
    "energy": exu.Integral("w", lambda w: w @ w),
    "force": exu.Reaction("joint", 1),
    "second": exu.EventTime("stop", 2),
}
CASES = {
    "pendulum": Case(
        stopped,
        {"mass": (2.0, ("mass", "physicsMass")), "stiffness": (1e4, CONTACT)},
        {"x": exu.At("p"), "y": exu.At("p", component=1), "t": exu.EventTime("stop", 2), "E": exu.Integral("p")},
        0.9,
        180,
    ),
    **{
        node: Case(
            lambda node=node, **given: swinging(node, **given),
            {"mass": (2.0, MASS), "stiffness": (1e4, CONTACT), "edge": (-0.2, ("stop", "offset"))},
            MOTION,
            0.6,
            120,
        )
        for node in NODES
    },
    "friction": Case(
        lambda **given: swinging("RotVecLG", rubs=True, **given),
        {"mass": (2.0, MASS), "stiffness": (1e4, ("stop", "stickingStiffness"))},
        MOTION,
        1.4,
        280,
    ),
}


def numbers_of(found: Any) -> Any:
    return np.concatenate([np.atleast_1d(value) for value in found.values.values()])


@pytest.mark.parametrize("name", CASES)
def test_derivatives_are_those_of_the_computed_solution(name: str) -> None:
    case, s = CASES[name], with_events(CASES[name].end, CASES[name].steps)
    parameters = {key: place for key, (_, place) in case.parameters.items()}
    duration = {"T": "timeIntegration.endTime"}
    forward, adjoint = (
        case.build().ComputeSensitivities(parameters | duration, case.outputs, s, method=method)
        for method in ("forward", "adjoint")
    )
    values = {key: value for key, (value, _) in case.parameters.items()} | {"T": case.end}
    sizes = np.abs(list(values.values()))
    largest = np.abs(forward.matrix * sizes).max(axis=1, keepdims=True)
    assert np.all(np.abs(forward.matrix - adjoint.matrix) * sizes < 1e-9 * largest)
    for k, (key, value) in enumerate(values.items()):
        total: Any = 0.0
        for multiple, weight in CENTRAL.items():
            varied = value * (1 + 1e-4 * multiple)
            mbs = case.build() if key == "T" else case.build(**{key: varied})
            own = with_events(varied if key == "T" else case.end, case.steps)
            found = mbs.ComputeSensitivities(dict(list(parameters.items())[:1]), case.outputs, own)
            total = total + weight / (1e-4 * value) * numbers_of(found)
        assert np.all(np.abs(forward.matrix[:, k] - total) * sizes[k] < 2e-6 * largest[:, 0]), (key, total)


def by_angle(mass: float, stiffness: float) -> tuple[float, float]:
    """Place of the pendulum of `stopped` after 0.9 s, by its angle and steps of high order between events."""
    length, weight, edge = 0.8, 20.0, -0.5

    def rates(touches: bool) -> Callable[[float, Any], Any]:
        def of(_: float, z: Any) -> list[float]:
            force = -weight + (stiffness * (edge - length * np.sin(z[0])) if touches else 0.0)
            return [z[1], force * np.cos(z[0]) / (mass * length)]

        return of

    def gap(_: float, z: Any) -> float:
        return float(length * np.sin(z[0]) - edge)

    gap.terminal = True  # type: ignore[attr-defined]
    time, z, touches = 0.0, [0.0, 0.0], False
    while time < 0.9:
        gap.direction = 1 if touches else -1  # type: ignore[attr-defined]
        part = scipy.integrate.solve_ivp(rates(touches), (time, 0.9), z, "DOP853", events=gap, rtol=1e-13, atol=1e-14)
        time, z, touches = part.t[-1], part.y[:, -1], not touches
    return float(length * np.cos(z[0])), float(length * np.sin(z[0]))


def test_derivatives_converge_to_those_in_minimal_coordinates() -> None:
    case = CASES["pendulum"]
    parameters = {key: place for key, (_, place) in case.parameters.items()}
    expected = []
    for key, (value, _) in case.parameters.items():
        given = {name: number for name, (number, _) in case.parameters.items()}
        expected.append(
            sum(
                weight / (1e-3 * value) * np.array(by_angle(**{**given, key: value * (1 + 1e-3 * multiple)}))
                for multiple, weight in CENTRAL.items()
            )
        )
    errors = []
    for steps in (720, 2880):
        found = stopped().ComputeSensitivities(parameters, {"x": exu.At("p"), "y": exu.At("p", component=1)},
                                               with_events(0.9, steps))  # fmt: skip
        np.testing.assert_allclose(numbers_of(found), by_angle(2.0, 1e4), rtol=2e-3 * (720 / steps) ** 2)
        size = np.abs(expected).max(axis=1)
        errors.append(np.max(np.abs(found.matrix.T - expected).max(axis=1) / size))
    assert errors[1] < 1e-3 and errors[1] < 0.4 * errors[0]  # at least of first order: steps are cut at events


def test_what_is_refused() -> None:
    mbs = driven()
    ends = [
        ground_coordinate(mbs),
        mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.GetNodeNumber("node"), coordinate=0)),
    ]
    history = mbs.AddNode(NodeGenericData(initialCoordinates=[1], numberOfDataCoordinates=1))
    mbs.AddObject(ObjectContactCoordinate(markerNumbers=ends, nodeNumber=history, contactStiffness=1e3, offset=-1))
    mbs.Assemble()
    found = refusal(mbs, {"m": ("mass", "physicsMass")}, {"x": "x"}, with_events(0.4, 40))
    assert found.item == "object 3 'drive' (ObjectConnectorCoordinate), equation 0"
    assert found.reason == "constraints that functions of time prescribe are not available together with events"
    s = with_events(0.9, 90)
    s.timeIntegration.generalizedAlpha.computeInitialAccelerations = False
    found = refusal(stopped(), {"m": ("mass", "physicsMass")}, {"x": exu.At("p")}, s)
    assert found.item.endswith("generalizedAlpha.computeInitialAccelerations")
    assert found.reason == "accelerations after events are not computed"


def test_grazing_events_are_refused() -> None:
    # A constraint elsewhere in the system does not matter.
    mbs = thrown(3e-7)
    node = mbs.AddNode(Node1D(referenceCoordinates=[0]))
    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))
    ends = [ground_coordinate(mbs), mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))]
    mbs.AddObject(CoordinateConstraint(markerNumbers=ends))
    mbs.Assemble()
    found = refusal(
        mbs, {"v": ("node 0", "initialVelocities", 0)}, {"t": exu.EventTime("stop 0")}, with_events(0.3, 30)
    )
    assert found.item == "event 'contact' of object 1 'stop 0' (ContactCoordinate)"
    assert found.reason.startswith("its switch grazes zero") and found.time == pytest.approx(0.2, rel=1e-5)
