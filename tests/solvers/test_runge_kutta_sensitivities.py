"""mbs.ComputeSensitivities with Runge-Kutta methods: ESDIRK43, and explicit methods in systems with constraints."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import scipy.integrate
from test_sensitivities import (
    CENTRAL,
    MODELS,
    Variable,
    falling,
    ground_coordinate,
    hinge,
    oscillator,
    pendulum,
    refusal,
    settings,
    spatial,
    value_of,
    varied,
    with_events,
)

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateConstraint,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodeGenericData,
    NodeGenericODE1,
    NodeRigidBodyEP,
    NodeRigidBodyRotVecLG,
    ObjectContactCoordinate,
    ObjectGenericODE1,
    SensorNode,
)
from dalembert.utilities import CreateSymbolicUserFunction

Solver = exu.DynamicSolverType


def equal_steps(end: float = 0.4, steps: int = 40) -> Any:
    s = settings(end, steps)
    s.timeIntegration.automaticStepSize = False
    return s


def at_rest(node: Any) -> Any:
    mbs = spatial(node=node, connector=hinge)
    count = len(mbs.GetNodeParameter("node", "initialVelocities"))
    mbs.SetNodeParameter("node", "initialVelocities", [0.0] * count)
    mbs.Assemble()
    return mbs


def stirred() -> Any:
    """A mass on a spring, and a linear system of first order beside it."""
    mbs = oscillator()
    node = mbs.AddNode(NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[1, 0.5],
                                           numberOfODE1Coordinates=2, name="heat"))  # fmt: skip
    matrix = [[-3.0, 1.0], [0.5, -20.0]]
    mbs.AddObject(ObjectGenericODE1(nodeNumbers=[node], systemMatrix=matrix, rhsVector=[1.0, 2.0], name="flow"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="T"))
    mbs.Assemble()
    return mbs


JOINT = {
    "m": ("body", "physicsMass"),
    "com": ("body", "physicsCenterOfMass", 1),
    "k": ("connector", "stiffness", (1, 1)),
    "T": ("torque", "loadVector", 1),
}
CASES: dict[str, tuple[Callable[[], Any], dict[str, Any], dict[str, Any], Any, float]] = {
    "oscillator": (*MODELS["oscillator"], Solver.ESDIRK43, 1e-8),
    "cable": (*MODELS["cable"], Solver.ESDIRK43, 2e-6),
    "first order": (
        stirred,
        {"A": ("flow", "systemMatrix", (0, 1)), "r": ("flow", "rhsVector", 1), "T0": ("heat", "initialCoordinates", 0)},
        {"T": "T", "E": exu.Integral("T", lambda T: float(T @ T))},
        Solver.ESDIRK43,
        1e-8,
    ),
    "rotation vector": (
        lambda: at_rest(NodeRigidBodyRotVecLG),
        JOINT,
        {"p": "p", "a": exu.At("a", component=0), "F": exu.Reaction("joint", 1), "F0": exu.Reaction("joint", 2, time=0.0)},
        Solver.ESDIRK43,
        1e-8,
    ),
    # The length of Euler parameters changes by the projection, whose direction is that of another matrix.
    "Euler parameters": (lambda: at_rest(NodeRigidBodyEP), JOINT, {"p": "p", "F": exu.Reaction("joint", 1)}, Solver.ESDIRK43, 1e-6),
    "explicit": (lambda: at_rest(NodeRigidBodyRotVecLG), JOINT, {"p": "p", "w": exu.At("w", component=1)}, Solver.RK44, 1e-8),
    "explicit, free": (
        lambda: spatial(),
        {"m": ("body", "physicsMass"), "Jyz": ("body", "physicsInertia", 3), "T": ("torque", "loadVector", 1)},
        {"p": "p", "w": "w"},
        Solver.DOPRI5,
        1e-8,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_forward_adjoint_and_differences_agree(name: str) -> None:
    """Differences of fourth order are those of the same run; tolerance: their truncation and rounding errors."""
    build, parameters, outputs, solver, tolerance = CASES[name]
    s = equal_steps(0.2, 20)
    forward, adjoint = (build().ComputeSensitivities(parameters, outputs, s, solver, m) for m in ("forward", "adjoint"))
    size = np.abs(forward.matrix).max(axis=1, keepdims=True)
    assert np.all(np.abs(forward.matrix - adjoint.matrix) < 1e-10 * size)
    assert forward.exactness == "differences"
    cheap = dict([next(iter(parameters.items()))])
    for k, given in enumerate(parameters.values()):
        x = value_of(build(), given)
        step = 1e-3 * abs(x) if x else 1e-3
        values = {m: flat(varied(build, given, x + m * step), cheap, outputs, solver, s) for m in CENTRAL}
        differences = sum(weight / step * values[multiple] for multiple, weight in CENTRAL.items())
        scale = np.maximum(np.abs(forward.matrix[:, k]), 1e-3 * size[:, 0])
        assert np.all(np.abs(forward.matrix[:, k] - differences) < tolerance * scale), list(parameters)[k]


def flat(mbs: Any, parameters: Any, outputs: Any, solver: Any, with_settings: Any) -> Any:
    values = mbs.ComputeSensitivities(parameters, outputs, with_settings, solver, "forward").values
    return np.concatenate([np.atleast_1d(each) for each in values.values()])


def falling_pendulum(end: float, mass: float = 2.0, weight: float = 20.0, length: float = 0.8) -> tuple[float, float]:
    """x of a mass on a rod that falls from the horizontal, and its derivative with respect to the weight."""

    def rates(_: float, z: Any) -> Any:
        angle, speed, by_angle, by_speed = z
        k = weight / (mass * length)
        return speed, -k * np.cos(angle), by_speed, k * np.sin(angle) * by_angle - np.cos(angle) / (mass * length)

    found = scipy.integrate.solve_ivp(rates, (0, end), np.zeros(4), rtol=1e-12, atol=1e-13, method="DOP853").y[:, -1]
    return length * np.cos(found[0]), -length * np.sin(found[0]) * found[2]


@pytest.mark.parametrize(
    ("solver", "tolerance"), [(Solver.ESDIRK43, 1e-8), (Solver.DOPRI5, 1e-9)], ids=["ESDIRK43", "DOPRI5"]
)
@pytest.mark.parametrize("method", ["forward", "adjoint"])
def test_adaptive_steps_of_a_pendulum(solver: Any, tolerance: float, method: Any) -> None:
    # The derivative with frozen steps differs from that of the exact solution by the error of the solution.
    s = settings(0.6, 1)
    s.timeIntegration.automaticStepSize = True
    s.timeIntegration.relativeTolerance, s.timeIntegration.absoluteTolerance = tolerance, 0.1 * tolerance
    found = pendulum().ComputeSensitivities({"F": ("weight", "loadVector", 1)}, {"x": "p"}, s, solver, method)
    value, by_weight = falling_pendulum(0.6)
    assert found.exactness == "frozen steps"
    assert found.values["x"] == pytest.approx(value, rel=1e-6)
    assert found.matrix[0, 0] == pytest.approx(-by_weight, rel=1e-5)


def test_contact_with_diagonally_implicit_steps() -> None:
    parameters = {"m": ("mass 0", "physicsMass"), "c": ("stop 0", "contactStiffness")}
    outputs = {"x": exu.At("x0", component=0), "t": exu.EventTime("stop 0", 1)}
    s = with_events(0.2, 80)
    s.timeIntegration.automaticStepSize = False
    found = [
        falling(0.05).ComputeSensitivities(parameters, outputs, s, Solver.ESDIRK43, m) for m in ("forward", "adjoint")
    ]
    np.testing.assert_allclose(found[0].matrix, found[1].matrix, rtol=1e-9, atol=1e-13)
    # The fall of 0.05 m takes sqrt(2 h m/F) = sqrt(0.1 m/20).
    assert found[0].values["t"] == pytest.approx(0.1, rel=1e-9)
    assert found[0].Derivative("t", "m") == pytest.approx(0.1 / (2 * 2), rel=1e-8)
    # While it touches: x = (F/c) (cos(w t) - 1) - v/w sin(w t) with v = sqrt(2 h F/m), w = sqrt(c/m).
    for name, x0 in (("m", 2.0), ("c", 1e3)):

        def at(value: float, name: str = name) -> float:
            m, c = (value, 1e3) if name == "m" else (2.0, value)
            t, v, w = 0.2 - np.sqrt(0.1 * m / 20), np.sqrt(2 * 0.05 * 20 / m), np.sqrt(c / m)
            return -(20 / c) * (1 - np.cos(w * t)) - v / w * np.sin(w * t)

        exact = sum(weight / (1e-3 * x0) * at(x0 * (1 + 1e-3 * k)) for k, weight in CENTRAL.items())
        assert found[0].Derivative("x", name) == pytest.approx(exact, rel=2e-5)


def stopped(mass: float = 2.0, stiffness: float = 1e4) -> Any:
    """A pendulum that swings against a spring."""
    mbs = pendulum()
    mbs.SetObjectParameter(mbs.GetObjectNumber("mass"), "physicsMass", mass)
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.GetNodeNumber("node"), coordinate=1))
    gap = mbs.AddNode(NodeGenericData(initialCoordinates=[0.5], numberOfDataCoordinates=1))
    ends = [ground_coordinate(mbs), marker]
    mbs.AddObject(
        ObjectContactCoordinate(
            markerNumbers=ends, nodeNumber=gap, contactStiffness=stiffness, offset=-0.5, name="stop"
        )
    )
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize(
    ("solver", "tolerance"),
    [(Solver.ESDIRK43, 1e-5), (Solver.RK44, 1e-5), (Solver.TrapezoidalIndex2, 1e-7)],  # the first two project
    ids=["ESDIRK43", "RK44", "trapezoidal"],
)
def test_events_in_systems_with_constraints(solver: Any, tolerance: float) -> None:
    # The mass falls by 0.5 m along a circle of 0.8 m; the time of contact, which does not depend on the stiffness, is
    # the elliptic integral of a pendulum, and proportional to the square root of the mass.
    parameters = {"m": ("mass", "physicsMass"), "c": ("stop", "contactStiffness")}
    outputs = {"x": exu.At("p"), "y": exu.At("p", component=1), "t": exu.EventTime("stop")}
    s = with_events(0.7, 140)
    s.timeIntegration.automaticStepSize = False
    forward, adjoint = (
        stopped().ComputeSensitivities(parameters, outputs, s, solver, m) for m in ("forward", "adjoint")
    )
    np.testing.assert_allclose(forward.matrix, adjoint.matrix, rtol=1e-9, atol=1e-15)
    rate = np.sqrt(2 * 20 / (2 * 0.8))
    exact = scipy.integrate.quad(lambda u: 2 / rate / np.sqrt(1 - u**4), 0, np.sqrt(np.sin(np.arcsin(0.5 / 0.8))))[0]
    assert forward.values["t"] == pytest.approx(exact, rel=5e-4)  # the error of second order of the trapezoidal rule
    assert forward.Derivative("t", "m") == pytest.approx(exact / (2 * 2), rel=5e-4)
    for k, (name, x) in enumerate({"mass": 2.0, "stiffness": 1e4}.items()):
        differences = sum(
            weight
            / (1e-3 * x)
            * flat(stopped(**{name: x * (1 + 1e-3 * step)}), {"m": parameters["m"]}, outputs, solver, s)
            for step, weight in CENTRAL.items()
        )
        scale = np.abs(forward.matrix[:, k]) + 1e-3 * np.abs(forward.matrix[:, k]).max()
        assert np.all(np.abs(forward.matrix[:, k] - differences) < tolerance * scale)


def test_what_is_refused() -> None:
    mass = {"m": ("body", "physicsMass")}
    found = refusal(spatial(connector=hinge), mass, {"p": "p"}, equal_steps(), solverType=Solver.ESDIRK43)
    assert found.reason.startswith("constraints are violated by 5.") and found.time is not None
    assert "initial velocities that fulfil all constraints" in found.advice

    found = refusal(oscillator(), None, {"a": exu.Final(0, 2)}, solverType=Solver.RK44)
    assert found.reason == "accelerations of explicit methods are not available"

    found = refusal(driven(), {"m": ("mass", "physicsMass")}, {"x": "x"}, equal_steps(), solverType=Solver.ESDIRK43)
    assert found.item == "object 3 'drive' (ObjectConnectorCoordinate), equation 0"
    assert found.reason == "constraints that functions of time prescribe are not available with Runge-Kutta methods"
    assert found.advice == "use generalized alpha without events"


def driven() -> Any:
    """A mass that a recorded function of time moves."""
    mbs = oscillator()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], name="driven"))
    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    item = mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), marker], name="drive"))

    def offset(mbs: Any, t: Any, itemNumber: Any, offset: Any) -> Any:
        return 0.1 * t * t

    mbs.SetObjectParameter(
        item, "offsetUserFunction", CreateSymbolicUserFunction(mbs, offset, "offsetUserFunction", item)
    )
    mbs.Assemble()
    return mbs
