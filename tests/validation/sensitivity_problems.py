"""Models whose derivatives are known: each is built for given numbers, with the parameters that these numbers are in the model.

Reference values (tests/data/sensitivities.txt) come from closed forms and from own integrations in minimal coordinates, by complex
steps.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from validation.solving import new_system, settings

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateConstraint,
    CoordinateSpringDamper,
    CoordinateSpringDamperExt,
    DistanceConstraint,
    LoadCoordinate,
    LoadForceVector,
    LoadMassProportional,
    MarkerBodyMass,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    Mass1D,
    MassPoint,
    MassPoint2D,
    Node1D,
    NodeGenericData,
    NodeGenericODE1,
    NodeGenericODE2,
    NodePoint,
    NodePoint2DSlope1,
    NodePointGround,
    NodeRigidBody2D,
    NodeRigidBodyEP,
    NodeRigidBodyRotVecLG,
    NodeRigidBodyRxyz,
    ObjectANCFCable2D,
    ObjectContactCoordinate,
    ObjectGenericODE1,
    ObjectGenericODE2,
    ObjectGround,
    ObjectRigidBody,
    RevoluteJoint2D,
    RigidBody2D,
    RigidBodySpringDamper,
    SensorBody,
    SensorNode,
    SensorObject,
    SphericalJoint,
    SpringDamper,
)
from dalembert.utilities import (
    AngularVelocity2EulerParameters_t,
    AngularVelocity2RotXYZ_t,
    CreateSymbolicUserFunction,
    RotationMatrix2EulerParameters,
    RotationMatrix2RotXYZ,
    RotationMatrixX,
)

Numbers = dict[str, float]
Variable = exu.OutputVariableType
Design = exu.DesignParameter


@dataclass(frozen=True)
class Problem:
    """build: numbers to model; parameters: numbers to what ComputeSensitivities takes; outputs: by name."""

    numbers: Numbers
    build: Callable[[Numbers], Any]
    parameters: Callable[[Numbers], dict[str, Any]]
    outputs: dict[str, Any]
    end: float = 1.0
    steps: int = 100
    radius: float = 0.6
    solver: Any = exu.DynamicSolverType.GeneralizedAlpha
    change: Callable[[Any], None] = field(default=lambda _: None)

    def settings(self, steps: int | None = None, numbers: Numbers | None = None) -> Any:
        end = (numbers or self.numbers).get("T", self.end)
        made = settings(end, self.steps if steps is None else steps, self.radius, 1e-12)
        self.change(made)
        return made

    def solve(self, steps: int | None = None, numbers: Numbers | None = None, method: str = "auto") -> Any:
        numbers = self.numbers if numbers is None else numbers
        mbs = self.build(numbers)
        return mbs.ComputeSensitivities(
            self.parameters(numbers), self.outputs, self.settings(steps, numbers), self.solver, method
        )


def reference(name: str) -> dict[str, tuple[float, dict[str, float]]]:
    """Return {output: (value, {parameter: derivative})} of the block with this name."""
    lines = (Path(__file__).parents[1] / "data" / "sensitivities.txt").read_text().splitlines()
    begin = lines.index(f"## {name}") + 1
    found: dict[str, tuple[float, dict[str, float]]] = {}
    output = ""
    for line in lines[begin:]:
        if line.startswith("##"):
            break
        if line.startswith(" "):
            for entry in line.split(","):
                parameter, value = entry.split()
                found[output][1][parameter.removeprefix("d/d")] = float(value)
        elif line:
            output, value = (part.strip() for part in line.rsplit("=", 1))
            found[output] = float(value), {}
    return found


def entries(item: Any, parameter: str, function: Callable[[float], Any], size: int) -> dict[Any, Any]:
    """Targets of a vector that is a function of a parameter."""
    return {(item, parameter, i): (lambda x, i=i: float(function(x)[i])) for i in range(size)}


def opposite(output: Any) -> Any:
    return exu.Function(lambda x: -x, outputs=[output])


def coordinate(mbs: Any, node: Any, number: int) -> Any:
    return mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=number))


def ground_coordinate(mbs: Any) -> Any:
    return coordinate(mbs, mbs.AddNode(NodePointGround()), 0)


def weight(mbs: Any, body: Any, name: str, g: float) -> None:
    marker = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=marker, loadVector=[0, -g, 0], name=name))


# ---- P11: oscillator ------------------------------------------------------------------------------------------------


def oscillator(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(
        Node1D(referenceCoordinates=[0], initialCoordinates=[p["x0"]], initialVelocities=[p["v0"]], name="node")
    )
    mbs.AddObject(Mass1D(physicsMass=p["m"], nodeNumber=node, name="mass"))
    markers = [ground_coordinate(mbs), coordinate(mbs, node, 0)]
    mbs.AddObject(CoordinateSpringDamper(markerNumbers=markers, stiffness=p["k"], damping=p["d"], name="spring"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="x"))
    mbs.Assemble()
    return mbs


TIMES = 0.1 * np.arange(1, 21)


def data() -> Any:
    """Positions at TIMES with another stiffness and damping."""
    k, d, m, x0, v0 = 820.0, 7.5, 2.0, 0.05, 0.3
    rate = d / (2 * m)
    w = np.sqrt(k / m - rate**2)
    return np.exp(-rate * TIMES) * (x0 * np.cos(w * TIMES) + (v0 + rate * x0) / w * np.sin(w * TIMES))


P11 = Problem(
    {"k": 800.0, "d": 8.0, "m": 2.0, "x0": 0.05, "v0": 0.3},
    oscillator,
    lambda _: {
        "k": ("spring", "stiffness"),
        "d": ("spring", "damping"),
        "m": ("mass", "physicsMass"),
        "x0": ("node", "initialCoordinates", 0),
        "v0": ("node", "initialVelocities", 0),
    },
    {
        "S": exu.Function(lambda x: float(np.sum((x - data()) ** 2)), outputs=[exu.At("x", TIMES)]),
        "x(0.5)": exu.At("x", 0.5),
        "x(2)": exu.At("x", 2.0),
    },
    end=2.0,
    steps=2000,
    radius=1.0,
)


# ---- P12: equations of first order ----------------------------------------------------------------------------------


def first_order(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(
        NodeGenericODE1(
            referenceCoordinates=[0, 0], initialCoordinates=[p["y0"], p["y1"]], numberOfODE1Coordinates=2, name="node"
        )
    )
    matrix = [[p["A00"], p["A01"]], [p["A10"], p["A11"]]]
    mbs.AddObject(
        ObjectGenericODE1(nodeNumbers=[node], systemMatrix=matrix, rhsVector=[p["b0"], p["b1"]], name="system")
    )
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="y"))
    mbs.Assemble()
    return mbs


P12 = Problem(
    {"A00": -1.0, "A01": 2.0, "A10": -3.0, "A11": -0.5, "b0": 0.3, "b1": -0.2, "y0": 1.0, "y1": 0.5},
    first_order,
    lambda _: {
        **{f"A{i}{j}": ("system", "systemMatrix", (i, j)) for i in range(2) for j in range(2)},
        **{f"b{i}": ("system", "rhsVector", i) for i in range(2)},
        **{f"y{i}": ("node", "initialCoordinates", i) for i in range(2)},
    },
    {"y0(T)": exu.At("y", component=0), "y1(T)": exu.At("y", component=1)},
    end=0.9,
    steps=400,
)


# ---- P14: pendulum --------------------------------------------------------------------------------------------------


def pendulum_start(length: float, phi: float, omega: float) -> tuple[Any, Any]:
    """Displacements, from the reference at the pivot, and velocities of a body at the end of a rod."""
    s, c = np.sin(phi), np.cos(phi)
    return np.array([length * s, -length * c, phi]), omega * np.array([length * c, length * s, 1])


def pendulum(p: Numbers) -> Any:
    mbs = new_system()
    displacement, velocity = pendulum_start(p["L"], p["phi0"], p["omega0"])
    node = mbs.AddNode(
        NodeRigidBody2D(
            referenceCoordinates=[0, 0, 0], initialCoordinates=displacement, initialVelocities=velocity, name="node"
        )
    )
    body = mbs.AddObject(RigidBody2D(physicsMass=p["m"], physicsInertia=0, nodeNumber=node, name="body"))
    ground = mbs.AddObject(ObjectGround())
    markers = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground)),
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[0, p["L"], 0], name="pivot")),
    ]
    mbs.AddObject(RevoluteJoint2D(markerNumbers=markers, name="joint"))
    damped = [ground_coordinate(mbs), coordinate(mbs, node, 2)]
    mbs.AddObject(CoordinateSpringDamper(markerNumbers=damped, damping=p["d"], name="damper"))
    weight(mbs, body, "weight", p["g"])
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="phi"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates_t, name="omega"))
    mbs.Assemble()
    return mbs


def pendulum_parameters(p: Numbers) -> dict[str, Any]:
    def start(x: float, name: str) -> tuple[Any, Any]:
        q = {**p, name: x}
        return pendulum_start(q["L"], q["phi0"], q["omega0"])

    def targets(name: str) -> dict[Any, Any]:
        return entries("node", "initialCoordinates", lambda x: start(x, name)[0], 3) | entries(
            "node", "initialVelocities", lambda x: start(x, name)[1], 3
        )

    return {
        "L": Design(p["L"], targets("L") | {("pivot", "localPosition", 1): 1.0}),
        "g": Design(p["g"], {("weight", "loadVector", 1): -1.0}),
        "m": ("body", "physicsMass"),
        "d": ("damper", "damping"),
        "phi0": Design(p["phi0"], targets("phi0")),
        "omega0": Design(p["omega0"], targets("omega0")),
    }


P14 = Problem(
    {"L": 0.8, "g": 9.81, "m": 1.5, "d": 0.4, "phi0": 2.0, "omega0": 0.5},
    pendulum,
    pendulum_parameters,
    {"phi": exu.At("phi", component=2), "omega": exu.At("omega", component=2)},
    end=1.7,
    steps=800,
)


# ---- P15: slider-crank ----------------------------------------------------------------------------------------------


def crank_start(p: Numbers) -> tuple[Any, Any]:
    """Displacements and velocities of crank, rod and slider, 3 x 3."""
    theta, omega, r, length = 0.5, 2.0, p["r"], p["l"]
    s, c = np.sin(theta), np.cos(theta)
    sine = r * s / length
    cosine = np.sqrt(1 - sine**2)
    beta, rate = np.arcsin(sine), r * c / (length * cosine) * omega
    q = [[0, 0, theta], [r * c + length / 2 * cosine, r * s / 2, -beta], [r * c + length * cosine, 0, 0]]
    v = [
        [0, 0, omega],
        [-r * s * omega - length / 2 * sine * rate, r * c / 2 * omega, -rate],
        [-r * s * omega - length * sine * rate, 0, 0],
    ]
    return np.array(q), np.array(v)


def slider_crank(p: Numbers) -> Any:
    mbs = new_system()
    q, v = crank_start(p)
    ground = mbs.AddObject(ObjectGround())
    masses, inertias = [1.0, p["m2"], p["m3"]], [p["J1"], p["m2"] * p["l"] ** 2 / 12, 0.01]
    nodes, bodies = [], []
    for i, name in enumerate(("crank", "rod", "slider")):
        nodes.append(
            mbs.AddNode(
                NodeRigidBody2D(
                    referenceCoordinates=[0, 0, 0], initialCoordinates=q[i], initialVelocities=v[i], name=f"{name}Node"
                )
            )
        )
        bodies.append(
            mbs.AddObject(
                RigidBody2D(physicsMass=masses[i], physicsInertia=inertias[i], nodeNumber=nodes[i], name=name)
            )
        )
        weight(mbs, bodies[i], f"{name}Weight", p["g"])

    def marker(body: Any, x: float, name: str) -> Any:
        return mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0, 0], name=name))

    pins = [
        (marker(ground, 0, "pin0"), marker(bodies[0], 0, "pin1")),
        (marker(bodies[0], p["r"], "pin2"), marker(bodies[1], -p["l"] / 2, "pin3")),
        (marker(bodies[1], p["l"] / 2, "pin4"), marker(bodies[2], 0, "pin5")),
    ]
    for pair in pins:
        mbs.AddObject(RevoluteJoint2D(markerNumbers=list(pair)))
    fixed = ground_coordinate(mbs)
    for i in (1, 2):
        mbs.AddObject(CoordinateConstraint(markerNumbers=[fixed, coordinate(mbs, nodes[2], i)]))
    mbs.AddLoad(LoadCoordinate(markerNumber=coordinate(mbs, nodes[0], 2), load=p["Tq"], name="torque"))
    mbs.AddSensor(SensorNode(nodeNumber=nodes[0], outputVariableType=Variable.Coordinates, name="theta"))
    mbs.AddSensor(SensorNode(nodeNumber=nodes[0], outputVariableType=Variable.Coordinates_t, name="omega"))
    mbs.AddSensor(SensorNode(nodeNumber=nodes[2], outputVariableType=Variable.Coordinates, name="x"))
    mbs.Assemble()
    return mbs


def slider_crank_parameters(p: Numbers) -> dict[str, Any]:
    def moved(name: str) -> dict[Any, Any]:
        found = {}
        for i, body in ((1, "rodNode"), (2, "sliderNode")):
            for row, parameter in ((0, "initialCoordinates"), (1, "initialVelocities")):
                found |= entries(body, parameter, lambda x, i=i, row=row: crank_start({**p, name: x})[row][i], 3)
        return found

    return {
        "r": Design(p["r"], moved("r") | {("pin2", "localPosition", 0): 1.0}),
        "l": Design(
            p["l"],
            moved("l")
            | {("pin3", "localPosition", 0): -0.5, ("pin4", "localPosition", 0): 0.5}
            | {("rod", "physicsInertia"): lambda x: p["m2"] * x**2 / 12},
        ),
        "J1": ("crank", "physicsInertia"),
        "m2": Design(p["m2"], {("rod", "physicsMass"): 1.0, ("rod", "physicsInertia"): p["l"] ** 2 / 12}),
        "m3": ("slider", "physicsMass"),
        "Tq": ("torque", "load"),
        "g": Design(p["g"], {(f"{body}Weight", "loadVector", 1): -1.0 for body in ("crank", "rod", "slider")}),
    }


P15 = Problem(
    {"r": 0.2, "l": 0.7, "J1": 0.05, "m2": 1.2, "m3": 0.8, "Tq": 0.6, "g": 9.81},
    slider_crank,
    slider_crank_parameters,
    {
        "theta": exu.At("theta", component=2),
        "omega": exu.At("omega", component=2),
        "x(slider)": exu.At("x", component=0),
    },
    end=1.2,
    steps=800,
)


# ---- P16: double pendulum of point masses ---------------------------------------------------------------------------


def double_start(p: Numbers) -> Any:
    first = p["l1"] * np.array([np.sin(p["a0"]), -np.cos(p["a0"]), 0])
    return first, first + p["l2"] * np.array([np.sin(p["b0"]), -np.cos(p["b0"]), 0])


def double_pendulum(p: Numbers) -> Any:
    mbs = new_system()
    markers = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=mbs.AddObject(ObjectGround())))]
    for i, position in enumerate(double_start(p), 1):
        node = mbs.AddNode(NodePoint(referenceCoordinates=position, name=f"point{i}"))
        body = mbs.AddObject(MassPoint(physicsMass=p[f"m{i}"], nodeNumber=node, name=f"mass{i}"))
        markers.append(mbs.AddMarker(MarkerBodyPosition(bodyNumber=body)))
        mbs.AddObject(DistanceConstraint(markerNumbers=markers[-2:], distance=p[f"l{i}"], name=f"rod{i}"))
        weight(mbs, body, f"weight{i}", p["g"])
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), coordinate(mbs, node, 2)]))
        mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Position, name=f"place{i}"))
    mbs.Assemble()
    return mbs


def double_pendulum_parameters(p: Numbers) -> dict[str, Any]:
    def moved(name: str) -> dict[Any, Any]:
        return entries("point1", "referenceCoordinates", lambda x: double_start({**p, name: x})[0], 3) | entries(
            "point2", "referenceCoordinates", lambda x: double_start({**p, name: x})[1], 3
        )

    return {
        "m1": ("mass1", "physicsMass"),
        "m2": ("mass2", "physicsMass"),
        "l1": Design(p["l1"], moved("l1") | {("rod1", "distance"): 1.0}),
        "l2": Design(p["l2"], moved("l2") | {("rod2", "distance"): 1.0}),
        "g": Design(p["g"], {("weight1", "loadVector", 1): -1.0, ("weight2", "loadVector", 1): -1.0}),
        "a0": Design(p["a0"], moved("a0")),
        "b0": Design(p["b0"], moved("b0")),
    }


P16 = Problem(
    {"m1": 1.0, "m2": 0.7, "l1": 0.9, "l2": 0.6, "g": 9.81, "a0": 1.2, "b0": 0.4},
    double_pendulum,
    double_pendulum_parameters,
    {
        "a": exu.Function(lambda x: np.arctan2(x[0], -x[1]), sensors=["place1"]),
        "b": exu.Function(lambda x, y: np.arctan2(y[0] - x[0], x[1] - y[1]), sensors=["place1", "place2"]),
        "y(tip)": exu.At("place2", component=1),
    },
    end=2.0,
    steps=1600,
)


# ---- P19: heavy top -------------------------------------------------------------------------------------------------

_START = RotationMatrixX(0.9)


def top_start(p: Numbers, node: str) -> tuple[Any, Any]:
    """Reference coordinates and initial velocities of a node."""
    omega = np.array([0, p["wy"], p["wz"]])
    place, velocity = _START @ [0, 0, p["L"]], _START @ np.cross(omega, [0, 0, p["L"]])
    if node == "EP":
        parameters = RotationMatrix2EulerParameters(_START)
        return [*place, *parameters], [*velocity, *AngularVelocity2EulerParameters_t(_START @ omega, parameters)]
    if node == "Rxyz":
        angles = RotationMatrix2RotXYZ(_START)
        return [*place, *angles], [*velocity, *AngularVelocity2RotXYZ_t(_START @ omega, angles)]
    return [*place, 0.9, 0, 0], [*velocity, *omega]


def heavy_top(p: Numbers, node: str) -> Any:
    mbs = new_system()
    kinds = {"EP": NodeRigidBodyEP, "Rxyz": NodeRigidBodyRxyz, "RotVecLG": NodeRigidBodyRotVecLG}
    coordinates, velocities = top_start(p, node)
    number = mbs.AddNode(kinds[node](referenceCoordinates=coordinates, initialVelocities=velocities, name="node"))
    body = mbs.AddObject(
        ObjectRigidBody(
            physicsMass=p["m"], physicsInertia=[p["Jx"], p["Jy"], p["Jz"], 0, 0, 0], nodeNumber=number, name="body"
        )
    )
    markers = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=mbs.AddObject(ObjectGround()))),
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[0, 0, -p["L"]], name="pivot")),
    ]
    mbs.AddObject(SphericalJoint(markerNumbers=markers, name="joint"))
    damping = np.diag([0, 0, 0, p["d"], p["d"], p["d"]])
    mbs.AddObject(RigidBodySpringDamper(markerNumbers=markers, damping=damping, name="damper"))
    mass = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=mass, loadVector=[0, 0, -p["g"]], name="weight"))
    mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.Position, name="place"))
    mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.AngularVelocity, name="omega"))
    mbs.Assemble()
    return mbs


def heavy_top_parameters(p: Numbers, node: str) -> dict[str, Any]:
    def moved(name: str) -> dict[Any, Any]:
        size = [len(part) for part in top_start(p, node)]
        return entries("node", "referenceCoordinates", lambda x: top_start({**p, name: x}, node)[0], size[0]) | entries(
            "node", "initialVelocities", lambda x: top_start({**p, name: x}, node)[1], size[1]
        )

    return {
        "m": ("body", "physicsMass"),
        **{f"J{axis}": ("body", "physicsInertia", i) for i, axis in enumerate("xyz")},
        "L": Design(p["L"], moved("L") | {("pivot", "localPosition", 2): -1.0}),
        "g": Design(p["g"], {("weight", "loadVector", 2): -1.0}),
        "d": [("damper", "damping", (i, i)) for i in (3, 4, 5)],
        "wz": Design(p["wz"], moved("wz")),
        "wy": Design(p["wy"], moved("wy")),
    }


def top(node: str) -> Problem:
    return Problem(
        {"m": 2.0, "Jx": 0.05, "Jy": 0.06, "Jz": 0.02, "L": 0.7, "g": 9.81, "d": 0.01, "wz": 5.0, "wy": 0.3},
        lambda p: heavy_top(p, node),
        lambda p: heavy_top_parameters(p, node),
        {
            **{axis: exu.At("place", component=i) for i, axis in enumerate("xyz")},
            "int w^2": exu.Integral("omega", lambda w: float(w @ w), derivative=lambda w: 2 * w),
        },
        end=1.0,
        steps=400,
    )


# ---- P20: arm with prescribed angles --------------------------------------------------------------------------------


def arm_start(p: Numbers) -> Any:
    return [p["c1"], 0, 0], [p["l1"] + p["c2"], 0, 0]


def arm(p: Numbers) -> Any:
    mbs = new_system()
    ground = mbs.AddObject(ObjectGround())
    bodies, angles = [], []
    for i, position in enumerate(arm_start(p), 1):
        node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=position, name=f"point{i}"))
        bodies.append(
            mbs.AddObject(
                RigidBody2D(physicsMass=p[f"m{i}"], physicsInertia=p[f"J{i}"], nodeNumber=node, name=f"link{i}")
            )
        )
        angles.append(coordinate(mbs, node, 2))
        weight(mbs, bodies[-1], f"weight{i}", p["g"])

    def marker(body: Any, x: float, name: str) -> Any:
        return mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0, 0], name=name))

    mbs.AddObject(RevoluteJoint2D(markerNumbers=[marker(ground, 0, "pin0"), marker(bodies[0], -p["c1"], "pin1")]))
    mbs.AddObject(
        RevoluteJoint2D(
            markerNumbers=[marker(bodies[0], p["l1"] - p["c1"], "pin2"), marker(bodies[1], -p["c2"], "pin3")]
        )
    )
    motors = {"motor1": ([ground_coordinate(mbs), angles[0]], 1.0), "motor2": ([angles[0], angles[1]], -0.8)}
    for name, (pair, factor) in motors.items():
        motor = mbs.AddObject(CoordinateConstraint(markerNumbers=pair, offset=factor * p["A"], name=name))
        law = CreateSymbolicUserFunction(
            mbs,
            lambda mbs, t, number, offset: offset * exu.symbolic.sin(np.pi / 2 * t) ** 2,
            "offsetUserFunction",
            motor,
        )
        mbs.SetObjectParameter(motor, "offsetUserFunction", law)
        mbs.AddSensor(SensorObject(objectNumber=motor, outputVariableType=Variable.Force, name=f"tau{name[-1]}"))
    mbs.Assemble()
    return mbs


def arm_parameters(p: Numbers) -> dict[str, Any]:
    def moved(name: str) -> dict[Any, Any]:
        found = {}
        for i in range(2):
            found |= entries(f"point{i + 1}", "referenceCoordinates", lambda x, i=i: arm_start({**p, name: x})[i], 3)
        return found

    return {
        "m1": ("link1", "physicsMass"),
        "m2": ("link2", "physicsMass"),
        "J1": ("link1", "physicsInertia"),
        "J2": ("link2", "physicsInertia"),
        "l1": Design(p["l1"], moved("l1") | {("pin2", "localPosition", 0): lambda x: x - p["c1"]}),
        "c1": Design(
            p["c1"],
            moved("c1") | {("pin1", "localPosition", 0): -1.0, ("pin2", "localPosition", 0): lambda x: p["l1"] - x},
        ),
        "c2": Design(p["c2"], moved("c2") | {("pin3", "localPosition", 0): -1.0}),
        "g": Design(p["g"], {("weight1", "loadVector", 1): -1.0, ("weight2", "loadVector", 1): -1.0}),
        "A": Design(p["A"], {("motor1", "offset"): 1.0, ("motor2", "offset"): -0.8}),
    }


P20 = Problem(
    {"m1": 3.0, "m2": 2.0, "J1": 0.1, "J2": 0.06, "l1": 0.6, "c1": 0.3, "c2": 0.25, "g": 9.81, "A": 1.0},
    arm,
    arm_parameters,
    {
        "int tau^2": exu.Function(
            lambda first, second: first + second,
            outputs=[exu.Integral("tau1", lambda x: float(x @ x)), exu.Integral("tau2", lambda x: float(x @ x))],
        ),
        "tau1(0.5)": opposite(exu.At("tau1", 0.5)),
        "tau2(0.5)": opposite(exu.At("tau2", 0.5)),
    },
    end=2.0,
    steps=400,
)

# ---- P2: slider-crank at a prescribed angle -------------------------------------------------------------------------


def held_crank(p: Numbers) -> Any:
    mbs = slider_crank({"J1": 0.05, "m2": 1.2, "m3": 0.8, "Tq": 0.0, "g": 0.0, **p})
    angle = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.GetNodeNumber("crankNode"), coordinate=2))
    mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), angle], offset=p["theta"], name="holder"))
    mbs.Assemble()
    return mbs


P2 = Problem(
    {"r": 0.2, "l": 0.7, "theta": 1.1},
    held_crank,
    lambda p: {
        "r": ("pin2", "localPosition", 0),
        "l": Design(p["l"], {("pin3", "localPosition", 0): -0.5, ("pin4", "localPosition", 0): 0.5}),
        "theta": ("holder", "offset"),
    },
    {"x": exu.At("x", component=0)},
    solver="static",
)


# ---- P3: four-bar linkage -------------------------------------------------------------------------------------------


def four_bar_start(p: Numbers) -> Any:
    """Places of the pins between the bars, of ground and rocker, and angles of the bars."""
    a, b, c = p["a"], p["b"], p["c"]
    first = a * np.array([np.cos(p["theta"]), np.sin(p["theta"])])
    last = np.array([p["d"], 0.0])
    e = last - first
    length = np.linalg.norm(e)
    along = e / length
    cosine = (b**2 + length**2 - c**2) / (2 * b * length)
    sine = np.sqrt(1 - cosine**2)
    second = first + b * np.array([along[0] * cosine - along[1] * sine, along[1] * cosine + along[0] * sine])
    bars = [(np.zeros(2), first), (first, second), (last, second)]
    return [(0.5 * (x + y), np.arctan2(*(y - x)[::-1])) for x, y in bars]


def four_bar(p: Numbers) -> Any:
    mbs = new_system()
    lengths = [p["a"], p["b"], p["c"]]
    ground = mbs.AddObject(ObjectGround())
    ends = []
    for i, (center, angle) in enumerate(four_bar_start(p)):
        node = mbs.AddNode(
            NodeRigidBody2D(referenceCoordinates=[0, 0, 0], initialCoordinates=[*center, angle], name=f"center{i}")
        )
        body = mbs.AddObject(
            RigidBody2D(physicsMass=p[f"m{i + 1}"], physicsInertia=0.1, nodeNumber=node, name=f"bar{i}")
        )
        weight(mbs, body, f"weight{i}", p["g"])
        ends.append(
            [
                mbs.AddMarker(
                    MarkerBodyRigid(bodyNumber=body, localPosition=[s * lengths[i] / 2, 0, 0], name=f"end{i}{k}")
                )
                for k, s in enumerate((-1, 1))
            ]
        )
    fixed = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground))
    far = mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[p["d"], 0, 0], name="pin D"))
    for name, pair in (
        ("A", [fixed, ends[0][0]]),
        ("B", [ends[0][1], ends[1][0]]),
        ("C", [ends[1][1], ends[2][1]]),
        ("D", [far, ends[2][0]]),
    ):
        mbs.AddObject(RevoluteJoint2D(markerNumbers=pair, name=name))
    angle = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.GetNodeNumber("center0"), coordinate=2))
    mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), angle], offset=p["theta"], name="holder"))
    for i in range(3):
        node = mbs.GetNodeNumber(f"center{i}")
        mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Position, name=f"position {i}"))
    mbs.Assemble()
    return mbs


P3 = Problem(
    {"a": 0.3, "b": 0.9, "c": 0.7, "d": 1.0, "theta": 0.8, "m1": 1.0, "m2": 2.0, "m3": 1.5, "g": 9.81},
    four_bar,
    lambda p: {
        **{
            name: Design(p[name], {(f"end{i}0", "localPosition", 0): -0.5, (f"end{i}1", "localPosition", 0): 0.5})
            for i, name in enumerate("abc")
        },
        "d": ("pin D", "localPosition", 0),
        "theta": ("holder", "offset"),
        **{f"m{i + 1}": (f"bar{i}", "physicsMass") for i in range(3)},
        "g": Design(p["g"], {(f"weight{i}", "loadVector", 1): -1.0 for i in range(3)}),
    },
    {
        "T": opposite(exu.Reaction("holder")),
        "Ax": opposite(exu.Reaction("A", 0)),
        "Ay": opposite(exu.Reaction("A", 1)),
        "Dx": opposite(exu.Reaction("D", 0)),
        "Dy": opposite(exu.Reaction("D", 1)),
    },
    solver="static",
)


# ---- P7: weight on two springs --------------------------------------------------------------------------------------


def two_springs(p: Numbers) -> Any:
    mbs = new_system()
    ground = mbs.AddObject(ObjectGround())
    node = mbs.AddNode(NodePoint(referenceCoordinates=[0, -3, 0]))
    body = mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))
    end = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))
    for i, sign in enumerate((-1, 1)):
        top = mbs.AddMarker(MarkerBodyPosition(bodyNumber=ground, localPosition=[sign * p["a"], 0, 0], name=f"top{i}"))
        spring = mbs.AddObject(
            SpringDamper(markerNumbers=[top, end], stiffness=p["k"], referenceLength=p["L0"], name=f"spring{i}")
        )
    for i in (0, 2):
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), coordinate(mbs, node, i)]))
    mbs.AddLoad(LoadForceVector(markerNumber=end, loadVector=[0, -p["F"], 0], name="weight"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Position, name="y"))
    mbs.AddSensor(SensorObject(objectNumber=spring, outputVariableType=Variable.ForceLocal, name="tension"))
    mbs.Assemble()
    return mbs


P7 = Problem(
    {"k": 100.0, "L0": 4.0, "F": 160.0, "a": 3.0},
    two_springs,
    lambda p: {
        "k": [("spring0", "stiffness"), ("spring1", "stiffness")],
        "L0": [("spring0", "referenceLength"), ("spring1", "referenceLength")],
        "F": Design(p["F"], {("weight", "loadVector", 1): -1.0}),
        "a": Design(p["a"], {("top0", "localPosition", 0): -1.0, ("top1", "localPosition", 0): 1.0}),
    },
    {"y": exu.At("y", component=1), "tension": exu.At("tension")},
    solver="static",
)

STATIC = {"P2": P2, "P3": P3, "P7": P7}

DYNAMIC = {
    "P11": P11,
    "P12": P12,
    "P14": P14,
    "P15": P15,
    "P16": P16,
    "P19 EP": top("EP"),
    "P19 Rxyz": top("Rxyz"),
    "P19 RotVecLG": top("RotVecLG"),
    "P20": P20,
}


# ---- P1: frequency of a compound pendulum ---------------------------------------------------------------------------


def hanging(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(NodeRigidBody2D(referenceCoordinates=[0, -p["s"], 0], name="node"))
    body = mbs.AddObject(RigidBody2D(physicsMass=p["m"], physicsInertia=p["J"], nodeNumber=node, name="body"))
    ground = mbs.AddObject(ObjectGround())
    pins = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground)),
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[0, p["s"], 0], name="pin")),
    ]
    mbs.AddObject(RevoluteJoint2D(markerNumbers=pins))
    weight(mbs, body, "weight", p["g"])
    mbs.Assemble()
    return mbs


def held_by_weight(made: Any) -> None:
    """Load steps with inertia that fades out: nothing else holds a pendulum."""
    made.staticSolver.numberOfLoadSteps, made.staticSolver.stabilizerODE2term = 20, 1
    made.staticSolver.newton.useModifiedNewton = True


P1 = Problem(
    {"m": 2.0, "J": 0.3, "s": 0.4, "g": 9.81},
    hanging,
    lambda p: {
        "m": ("body", "physicsMass"),
        "J": ("body", "physicsInertia"),
        "s": ("pin", "localPosition", 1),  # the equilibrium moves
        "g": Design(p["g"], {("weight", "loadVector", 1): -1.0}),
    },
    {"omega": exu.Function(np.sqrt, outputs=[exu.Eigenvalue(0)])},
    solver="static",
    change=held_by_weight,
)
STATIC["P1"] = P1


# ---- P4a: linear beam -----------------------------------------------------------------------------------------------


def beam_stiffness(p: Numbers) -> Any:
    """A cantilever with cubic shape functions: deflection and slope of its end."""
    length = p["L"]
    return p["EI"] / length**3 * np.array([[12, -6 * length], [-6 * length, 4 * length**2]])


def linear_beam(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(NodeGenericODE2(referenceCoordinates=[0, 0], initialCoordinates=[0, 0], initialCoordinates_t=[0, 0],
                                       numberOfODE2Coordinates=2))  # fmt: skip
    mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.eye(2), stiffnessMatrix=beam_stiffness(p), name="beam"))  # fmt: skip
    mbs.AddLoad(LoadCoordinate(markerNumber=coordinate(mbs, node, 0), load=p["F"], name="force"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="tip"))
    mbs.Assemble()
    return mbs


def linear_beam_parameters(p: Numbers) -> dict[str, Any]:
    def moved(name: str) -> Any:
        return Design(
            p[name],
            {
                ("beam", "stiffnessMatrix", (i, j)): (lambda x, i=i, j=j: beam_stiffness({**p, name: x})[i, j])
                for i in range(2)
                for j in range(2)
            },
        )

    return {"F": ("force", "load"), "L": moved("L"), "EI": moved("EI")}


STATIC["P4a"] = Problem(
    {"F": 1.0, "L": 2.0, "EI": 1000.0}, linear_beam, linear_beam_parameters, {"w": exu.At("tip")}, solver="static"
)


# ---- P8: vibration absorber ------------------------------------------------------------------------------------------


def absorber(p: Numbers) -> Any:
    mbs = new_system()
    nodes = [mbs.AddNode(Node1D(referenceCoordinates=[0])) for _ in range(2)]
    for i, node in enumerate(nodes, 1):
        mbs.AddObject(Mass1D(physicsMass=p[f"m{i}"], nodeNumber=node, name=f"mass{i}"))
    markers = [ground_coordinate(mbs), *(coordinate(mbs, node, 0) for node in nodes)]
    for i in (1, 2):
        mbs.AddObject(
            CoordinateSpringDamper(
                markerNumbers=markers[i - 1 : i + 1], stiffness=p[f"k{i}"], damping=p["c2"] if i == 2 else 0, name=f"spring{i}"
            )
        )  # fmt: skip
    mbs.AddLoad(LoadCoordinate(markerNumber=markers[1], load=1, name="force"))
    mbs.AddSensor(SensorNode(nodeNumber=nodes[0], outputVariableType=Variable.Coordinates, name="x"))
    mbs.Assemble()
    return mbs


OPTIMUM = {"k2": 181.40589569160997, "c2": 2.5453451610707085}  # of the absorber
_ABSORBER = {"m1": 10.0, "k1": 4000.0, "m2": 0.5, **OPTIMUM}
FIXED_POINTS = {-1: 17.929239094803, 1: 20.986832714494}


def absorber_parameters(_: Numbers) -> dict[str, Any]:
    return {
        "m1": ("mass1", "physicsMass"),
        "k1": ("spring1", "stiffness"),
        "m2": ("mass2", "physicsMass"),
        "k2": ("spring2", "stiffness"),
        "c2": ("spring2", "damping"),
    }


def absorber_problem(omega: float) -> Problem:
    return Problem(
        _ABSORBER, absorber, absorber_parameters, {"X": exu.FrequencyResponse("force", "x", omega)}, solver="static"
    )


# ---- P4b, P6: cantilevers of cable elements -------------------------------------------------------------------------


def cantilever(p: Numbers, elements: int) -> Any:
    """A cantilever; F: force across its tip, M: mass there."""
    mbs = new_system()
    places = np.linspace(0, p["L"], elements + 1)
    nodes = [
        mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0], name=f"end {i}")) for i, x in enumerate(places)
    ]
    for i in range(elements):
        mbs.AddObject(
            ObjectANCFCable2D(
                physicsLength=p["L"] / elements,
                physicsMassPerLength=p["rhoA"],
                physicsBendingStiffness=p["EI"],
                physicsAxialStiffness=p["EA"],
                nodeNumbers=nodes[i : i + 2],
                name=f"beam {i}",
            )
        )
    for k in (0, 1, 3):
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), coordinate(mbs, nodes[0], k)]))
    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[-1]))
    mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[0, p["F"], 0], name="force"))
    mbs.AddObject(MassPoint2D(physicsMass=p["M"], nodeNumber=nodes[-1], name="mass"))
    mbs.AddSensor(SensorNode(nodeNumber=nodes[-1], outputVariableType=Variable.Position, name="tip"))
    mbs.Assemble()
    return mbs


def cantilever_parameters(p: Numbers, elements: int) -> dict[str, Any]:
    length = {(f"end {i}", "referenceCoordinates", 0): i / elements for i in range(1, elements + 1)}
    return {
        "F": ("force", "loadVector", 1),
        "L": Design(p["L"], length | {(f"beam {i}", "physicsLength"): 1 / elements for i in range(elements)}),
        **{
            name: [(f"beam {i}", parameter) for i in range(elements)]
            for name, parameter in (
                ("EI", "physicsBendingStiffness"),
                ("EA", "physicsAxialStiffness"),
                ("rhoA", "physicsMassPerLength"),
            )
        },
        "M": ("mass", "physicsMass"),
    }


def cantilever_problem(numbers: Numbers, elements: int, outputs: dict[str, Any]) -> Problem:
    def in_steps(made: Any) -> None:
        made.staticSolver.numberOfLoadSteps = 10

    return Problem(
        numbers,
        lambda p: cantilever(p, elements),
        lambda p: cantilever_parameters(p, elements),
        outputs,
        solver="static",
        change=in_steps,
    )


def of_cantilever(numbers: Numbers, others: Numbers, elements: int, outputs: dict[str, Any]) -> Problem:
    """A cantilever with some of its numbers as parameters."""
    problem = cantilever_problem({**numbers, **others}, elements, outputs)

    def parameters(p: Numbers) -> dict[str, Any]:
        found = problem.parameters({**others, **p})
        return {name: found[name] for name in numbers}

    return replace(
        problem, numbers=numbers, build=lambda p: cantilever({**others, **p}, elements), parameters=parameters
    )


def elastica(elements: int) -> Problem:
    """P4b."""
    slope = exu.Function(lambda q: float(np.arctan2(q[3], 1 + q[2])), sensors=["slope"])
    outputs = {"w(tip)": exu.At("tip", component=1), "x(tip)": exu.At("tip"), "angle": slope}
    others = {"EA": 2e6, "rhoA": 1.0, "M": 1.0}
    problem = of_cantilever({"F": 4.0, "L": 1.0, "EI": 2.0}, others, elements, outputs)

    def build(p: Numbers) -> Any:
        mbs = problem.build(p)
        tip = mbs.GetNodeNumber(f"end {elements}")
        mbs.AddSensor(SensorNode(nodeNumber=tip, outputVariableType=Variable.Coordinates, name="slope"))
        mbs.Assemble()
        return mbs

    return replace(problem, build=build)


def buckling(elements: int) -> Problem:
    """P5."""
    others = {"F": 0.0, "EA": 1e7, "rhoA": 1.0, "M": 1.0}
    problem = of_cantilever({"L": 1.5, "EI": 20.0}, others, elements, {"P": exu.BucklingLoad()})

    def build(p: Numbers) -> Any:
        mbs = problem.build(p)
        tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=mbs.GetNodeNumber(f"end {elements}")))
        mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[-1, 0, 0], name="pressure"))
        mbs.Assemble()
        return mbs

    return replace(problem, build=build)


def vibrating_cantilever(elements: int) -> Problem:
    """P6."""
    outputs = {f"omega_{k + 1}": exu.Function(np.sqrt, outputs=[exu.Eigenvalue(k)]) for k in (0, 1)}
    return of_cantilever({"EI": 50.0, "L": 1.2, "rhoA": 2.0, "M": 0.8}, {"F": 0.0, "EA": 1e7}, elements, outputs)


# ---- P9: block that slides to rest -------------------------------------------------------------------------------------


def block(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialVelocities=[p["v0"]], name="node"))
    mbs.AddObject(Mass1D(physicsMass=1.5, nodeNumber=node))
    slides = mbs.AddNode(NodeGenericData(initialCoordinates=[1, 0, 0], numberOfDataCoordinates=3))
    mbs.AddObject(
        CoordinateSpringDamperExt(
            markerNumbers=[ground_coordinate(mbs), coordinate(mbs, node, 0)],
            nodeNumber=slides,
            fDynamicFriction=1.5 * p["mu"] * p["g"],
            frictionProportionalZone=0,
            stickingStiffness=1e9,
            name="friction",
        )
    )
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="x"))
    mbs.Assemble()
    return mbs


def with_events(made: Any) -> None:
    made.events.ofItems = True


P9 = Problem(
    {"v0": 3.0, "mu": 0.25, "g": 9.81},
    block,
    lambda p: {
        "v0": ("node", "initialVelocities", 0),
        "mu": Design(p["mu"], {("friction", "fDynamicFriction"): 1.5 * p["g"]}),
        "g": Design(p["g"], {("friction", "fDynamicFriction"): 1.5 * p["mu"]}),
    },
    {"t": exu.EventTime("friction"), "x": exu.At("x", exu.EventTime("friction"))},
    end=1.3,
    steps=130,
    change=with_events,
)


# ---- P10: drop on a spring-damper -------------------------------------------------------------------------------------


def drop(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[p["h"]], name="node"))
    mbs.AddObject(Mass1D(physicsMass=p["m"], nodeNumber=node, name="mass"))
    gap = mbs.AddNode(NodeGenericData(initialCoordinates=[p["h"]], numberOfDataCoordinates=1))
    marker = coordinate(mbs, node, 0)
    mbs.AddObject(
        ObjectContactCoordinate(
            markerNumbers=[ground_coordinate(mbs), marker],
            nodeNumber=gap,
            contactStiffness=p["k"],
            contactDamping=p["d"],
            name="contact",
        )
    )
    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=-p["m"] * p["g"], name="weight"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="x"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates_t, name="v"))
    mbs.Assemble()
    return mbs


P10 = Problem(
    {"h": 0.5, "k": 20000.0, "d": 30.0, "m": 1.5, "g": 9.81},
    drop,
    lambda p: {
        "h": ("node", "initialCoordinates", 0),
        "k": ("contact", "contactStiffness"),
        "d": ("contact", "contactDamping"),
        "m": Design(p["m"], {("mass", "physicsMass"): 1.0, ("weight", "load"): -p["g"]}),
        "g": Design(p["g"], {("weight", "load"): -p["m"]}),
    },
    {
        "t(touch)": exu.EventTime("contact", 1),
        "t(leave)": exu.EventTime("contact", 2),
        "gap at t=0.7": exu.At("x"),
        "speed": exu.At("v", exu.EventTime("contact", 2)),
    },
    end=0.7,
    steps=1400,
    radius=0.9,
    change=with_events,
)


# ---- P13: planet ---------------------------------------------------------------------------------------------------------


def planet(p: Numbers) -> Any:
    mbs = new_system()
    node = mbs.AddNode(NodePoint(referenceCoordinates=[p["r0"], 0, 0], initialVelocities=[0, p["v0"], 0], name="node"))
    body = mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node))
    ends = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=b)) for b in (mbs.AddObject(ObjectGround()), body)]
    number = exu.symbolic.Real("mu", p["mu"])
    sun = mbs.AddObject(SpringDamper(markerNumbers=ends, referenceLength=1, name="sun"))
    law = CreateSymbolicUserFunction(
        mbs,
        lambda mbs, t, item, stretch, rate, k, d, force: number / (1 + stretch) ** 2,
        "springForceUserFunction",
        sun,
    )
    mbs.SetObjectParameter(sun, "springForceUserFunction", law)
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Position, name="place"))
    mbs.Assemble()
    return mbs


P13 = Problem(
    {"mu": 1.0, "r0": 1.0, "v0": 1.2, "T": 3.0},
    planet,
    lambda p: {
        "mu": ("sun", "springForceUserFunction", "mu"),
        "r0": ("node", "referenceCoordinates", 0),
        "v0": ("node", "initialVelocities", 1),
        "T": "timeIntegration.endTime",
    },
    {"x": exu.At("place"), "y": exu.At("place", component=1)},
    end=3.0,
    steps=800,
    radius=0.9,
)


# ---- P18: pendulum of one cable element -----------------------------------------------------------------------------


def cable_pendulum(p: Numbers) -> Any:
    mbs = new_system()
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0], name=f"end {i}")) for i, x in enumerate((0, p["L"]))]  # fmt: skip
    cable = mbs.AddObject(
        ObjectANCFCable2D(
            physicsLength=p["L"],
            physicsMassPerLength=p["rhoA"],
            physicsBendingStiffness=p["EI"],
            physicsAxialStiffness=p["EA"],
            nodeNumbers=nodes,
            useReducedOrderIntegration=False,
            name="cable",
        )
    )
    for k in (0, 1):
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), coordinate(mbs, nodes[0], k)]))
    weight(mbs, cable, "weight", p["g"])
    mbs.AddSensor(SensorNode(nodeNumber=nodes[1], outputVariableType=Variable.Position, name="tip"))
    mbs.Assemble()
    return mbs


DYNAMIC["P18"] = Problem(
    {"EA": 2000.0, "EI": 2.0, "rhoA": 1.0, "L": 1.0, "g": 9.81},
    cable_pendulum,
    lambda p: {
        "EA": ("cable", "physicsAxialStiffness"),
        "EI": ("cable", "physicsBendingStiffness"),
        "rhoA": ("cable", "physicsMassPerLength"),
        "L": [("end 1", "referenceCoordinates", 0), ("cable", "physicsLength")],
        "g": Design(p["g"], {("weight", "loadVector", 1): -1.0}),
    },
    {"x(tip)": exu.At("tip"), "y(tip)": exu.At("tip", component=1)},
    end=0.8,
    steps=3200,
)


# ---- P17: cart-pole with forces in eight intervals --------------------------------------------------------------------

INTERVAL = 0.15


def window(k: int) -> Any:
    """A load in one interval; the end of a step at which the force jumps has the force of that step."""
    begin, end = k * INTERVAL + 1e-9, (k + 1) * INTERVAL + 1e-9

    def law(mbs: Any, t: Any, load: Any) -> Any:
        return load * exu.symbolic.IfThenElse(t > begin, 1, 0) * exu.symbolic.IfThenElse(t > end, 0, 1)

    return law


def cart_pole(p: Numbers) -> Any:
    mbs = new_system()
    places = {"cart": [0, 0, 0], "pole": [0, -p["l"], 0]}
    bodies, ends = {}, []
    for name, mass in (("cart", p["M"]), ("pole", p["m"])):
        node = mbs.AddNode(NodePoint(referenceCoordinates=places[name], name=f"{name}Node"))
        bodies[name] = mbs.AddObject(MassPoint(physicsMass=mass, nodeNumber=node, name=name))
        ends.append(mbs.AddMarker(MarkerBodyPosition(bodyNumber=bodies[name])))
        for i in (1, 2) if name == "cart" else (2,):
            mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), coordinate(mbs, node, i)]))
        for kind, variable in (("place", Variable.Position), ("speed", Variable.Velocity)):
            mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=variable, name=f"{kind} of {name}"))
    mbs.AddObject(DistanceConstraint(markerNumbers=ends, distance=p["l"], name="rod"))
    weight(mbs, bodies["pole"], "weight", p["g"])
    pushed = coordinate(mbs, mbs.GetNodeNumber("cartNode"), 0)
    for k in range(8):
        load = mbs.AddLoad(LoadCoordinate(markerNumber=pushed, load=p[f"u{k}"], name=f"push{k}"))
        law = CreateSymbolicUserFunction(mbs, window(k), "loadUserFunction", load)
        mbs.SetLoadParameter(load, "loadUserFunction", law)
    mbs.Assemble()
    return mbs


def cart_pole_end(cart: Any, pole: Any, cart_t: Any, pole_t: Any) -> float:
    """The cost of the end of the motion."""
    d, d_t = pole - cart, pole_t - cart_t
    length = d @ d
    rate = (d[0] * d_t[1] - d[1] * d_t[0]) / length
    return 10 * (cart[0] ** 2 + (1 - d[1] / np.sqrt(length)) ** 2 + 0.1 * (cart_t[0] ** 2 + rate**2))


_SENSORS = ["place of cart", "place of pole", "speed of cart", "speed of pole"]
P17 = Problem(
    {"M": 1.0, "m": 0.3, "l": 0.5, "g": 9.81}
    | {f"u{k}": u for k, u in enumerate((6.0, -4.0, 3.0, 5.0, -7.0, -2.0, 4.0, 1.0))},
    cart_pole,
    lambda p: {
        "M": ("cart", "physicsMass"),
        "m": ("pole", "physicsMass"),
        "l": Design(p["l"], {("rod", "distance"): 1.0, ("poleNode", "referenceCoordinates", 1): -1.0}),
        "g": Design(p["g"], {("weight", "loadVector", 1): -1.0}),
        **{f"u{k}": (f"push{k}", "load") for k in range(8)},
    },
    {
        "cost": exu.Function(
            lambda *x: cart_pole_end(*x[:4]) + x[4],
            sensors=_SENSORS,
            outputs=[exu.Integral("place of cart", lambda x: float(x[0] ** 2))],
        ),
        "x(T)": exu.At("place of cart"),
        "q(T)": exu.Function(lambda x, y: np.arctan2(y[0] - x[0], x[1] - y[1]), sensors=_SENSORS[:2]),
    },
    end=1.2,
    steps=400,
)
DYNAMIC["P17"] = P17
DYNAMIC["P13"] = P13

EVENTS = {"P9": P9, "P10": P10}
