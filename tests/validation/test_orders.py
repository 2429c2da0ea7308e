"""Orders of convergence of all time integration methods, on an elastic pendulum and on bodies with rotations."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from solving import Solver, Variable, new_system, orders, self_orders, settings

import dalembert as exu

MASS, STIFFNESS, LENGTH, GRAVITY = 2.0, 80.0, 1.0, 9.81
START, SPEED = np.array([0.8, -0.7]), np.array([0.3, 0.5])
ORDERS = {
    "ExplicitEuler": (1, [800, 1600, 3200]),
    "ExplicitMidpoint": (2, [100, 200, 400]),
    "RK33": (3, [100, 200, 400]),
    "RK44": (4, [50, 100, 200]),
    "RK67": (6, [20, 40, 80]),
    "VelocityVerlet": (2, [100, 200, 400]),
    "GeneralizedAlpha": (2, [200, 400, 800]),
    "TrapezoidalIndex2": (2, [200, 400, 800]),
}


@cache
def exact() -> np.ndarray:
    """Position and velocity after one second, by a method of order 8 with tolerances near rounding."""

    def rates(t: float, x: np.ndarray) -> np.ndarray:
        length = np.linalg.norm(x[:2])
        spring = -STIFFNESS * (length - LENGTH) * x[:2] / length
        return np.concatenate([x[2:], spring / MASS + [0, -GRAVITY]])

    return solve_ivp(rates, [0, 1], [*START, *SPEED], "DOP853", rtol=1e-13, atol=1e-13).y[:, -1]


def elastic_pendulum(damping: float = 0.0) -> tuple[Any, Any]:
    mbs = new_system()
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=START, initialVelocities=SPEED))
    mbs.AddObject(exu.MassPoint2D(physicsMass=MASS, nodeNumber=node))
    ground = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    end = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    mbs.AddObject(
        exu.SpringDamper(markerNumbers=[ground, end], stiffness=STIFFNESS, referenceLength=LENGTH, damping=damping)
    )
    mbs.AddLoad(exu.Force(markerNumber=end, loadVector=[0, -MASS * GRAVITY, 0]))
    mbs.Assemble()
    return mbs, node


def final(mbs: Any, node: Any) -> np.ndarray:
    return np.concatenate([mbs.GetNodeOutput(node, v)[:2] for v in (Variable.Position, Variable.Velocity)])


@pytest.mark.parametrize("method", ORDERS)
def test_order(method: str) -> None:
    order, steps = ORDERS[method]

    def error(n: int) -> np.ndarray:
        mbs, node = elastic_pendulum()
        mbs.SolveDynamic(settings(1.0, n, tolerance=1e-13), solverType=getattr(Solver, method))
        return final(mbs, node) - exact()

    for observed in orders(error, steps):
        assert observed == pytest.approx(order, abs=0.15 * order)


@pytest.mark.parametrize("method", ["ODE23", "DOPRI5"])
def test_automatic_steps(method: str) -> None:
    """Errors follow the tolerances: at most a hundred times as large after a second, and not by chance far smaller."""
    errors = []
    for tolerance in (1e-6, 1e-8):
        mbs, node = elastic_pendulum()
        s = settings(1.0, 10)
        s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = tolerance
        s.timeIntegration.initialStepSize = 1e-3
        mbs.SolveDynamic(s, solverType=getattr(Solver, method))
        errors.append(np.linalg.norm(final(mbs, node) - exact()))
        assert 1e-4 * tolerance < errors[-1] < 100 * tolerance
    assert errors[1] < errors[0]


ROTATING = ["NodeRigidBodyRxyz", "NodeRigidBodyRotVecLG"]


def tumbling(node_type: str, gravity: bool = False) -> tuple[Any, Any]:
    """A free body without symmetry, near its unstable axis."""
    mbs = new_system()
    node = mbs.AddNode(getattr(exu, node_type)(initialVelocities=[0.1, 0.2, 0.3, 0.4, 2.5, 0.3]))
    rows = {"physicsInertia": [1.0, 2.0, 3.0, 0.1, -0.2, 0.3], "physicsCenterOfMass": [0.1, -0.2, 0.15]}
    body = mbs.AddObject(exu.RigidBody(physicsMass=1.5, nodeNumber=node, **rows))
    mbs.Assemble()
    return mbs, body


@pytest.mark.parametrize("node_type", ROTATING)
@pytest.mark.parametrize("method", ["ExplicitEuler", "ExplicitMidpoint", "RK33", "RK44", "RK67", "GeneralizedAlpha"])
def test_order_with_rotations(node_type: str, method: str) -> None:
    order, steps = ORDERS[method]

    def result(n: int) -> np.ndarray:
        mbs, body = tumbling(node_type)
        mbs.SolveDynamic(settings(0.5, n, tolerance=1e-13), solverType=getattr(Solver, method))
        outputs = (Variable.Position, Variable.RotationMatrix, Variable.AngularVelocity)
        return np.concatenate([mbs.GetObjectOutputBody(body, v, [0, 0, 0]) for v in outputs])

    assert self_orders(result, steps[0] // 2) == pytest.approx(order, abs=0.2 * order)


def test_all_nodes_make_the_same_motion() -> None:
    """Computed by RK67 with small steps, to rounding."""
    results = []
    for node_type in ROTATING:
        mbs, body = tumbling(node_type)
        mbs.SolveDynamic(settings(0.5, 400), solverType=Solver.RK67)
        outputs = (Variable.Position, Variable.Velocity, Variable.RotationMatrix, Variable.AngularVelocity)
        results.append(np.concatenate([mbs.GetObjectOutputBody(body, v, [0.3, 0.2, 0.1]) for v in outputs]))
    np.testing.assert_allclose(results[1], results[0], rtol=0, atol=1e-11)
