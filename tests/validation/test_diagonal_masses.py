"""Masses that are on the diagonal alone take no matrix in explicit integration, until they couple coordinates."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation
from solving import Solver, Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import RigidBodyInertia

END, SPIN = 0.4, np.array([1.0, 2.0, 3.0])
Node = exu.NodeType
TENSORS = {
    "round": np.eye(3),
    "principal": np.diag([1.0, 2.0, 3.0]),
    "full": np.array([[2.0, 0.3, 0.0], [0.3, 2.0, 0.1], [0.0, 0.1, 3.0]]),
}


def free_rotation(tensor: np.ndarray) -> np.ndarray:
    """Euler's equations and the rates of a quaternion (w last), by another integrator."""

    def rates(_: float, state: np.ndarray) -> np.ndarray:
        turn, spin = state[:4], state[4:]
        change = 0.5 * np.array([*(turn[3] * spin + np.cross(turn[:3], spin)), -turn[:3] @ spin])
        return np.concatenate([change, np.linalg.solve(tensor, np.cross(tensor @ spin, spin))])

    start = np.array([0, 0, 0, 1, *SPIN])
    found = solve_ivp(rates, (0, END), start, method="DOP853", rtol=1e-12, atol=1e-12)
    return Rotation.from_quat(found.y[:4, -1]).as_matrix()


@pytest.mark.parametrize("shape", TENSORS)
@pytest.mark.parametrize("node", [Node.RotationRxyz, Node.RotationRotationVector, Node.RotationEulerParameters])
def test_bodies_turn_as_by_the_equations_of_euler(node: Any, shape: str) -> None:
    """Masses of angles are diagonal where these are zero, at the start, and couple them from then on. Steps of 0.2 ms leave (|omega| h)^4 = 3e-13."""
    mbs = new_system()
    body = mbs.CreateRigidBody(
        inertia=RigidBodyInertia(1.0, TENSORS[shape], np.zeros(3)), initialAngularVelocity=SPIN, nodeType=node
    )
    mbs.Assemble()
    mbs.SolveDynamic(settings(END, 2000), solverType=Solver.RK44)
    turned = np.reshape(mbs.GetObjectOutputBody(body, Variable.RotationMatrix, [0, 0, 0]), (3, 3))
    np.testing.assert_allclose(turned, free_rotation(TENSORS[shape]), rtol=0, atol=1e-10)
    assert np.abs(turned - np.eye(3)).max() > 0.5


@pytest.mark.parametrize("beside", [0.0, 2.0])
def test_masses_at_one_node_add_up(beside: float) -> None:
    """Bodies on one node are pushed as one."""
    mbs = new_system()
    node = mbs.AddNode(exu.utilities.NodeRigidBodyRotVecLG(referenceCoordinates=[0] * 6))
    mbs.AddObject(exu.utilities.ObjectRigidBody(physicsMass=3.0, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    if beside:
        mbs.AddObject(
            exu.utilities.ObjectRigidBody(physicsMass=beside, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node)
        )
    marker = mbs.AddMarker(exu.utilities.MarkerNodeRigid(nodeNumber=node))
    mbs.AddLoad(exu.utilities.LoadForceVector(markerNumber=marker, loadVector=[6, 0, 0]))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1.0, 100), solverType=Solver.RK44)
    moved = mbs.GetNodeOutput(node, Variable.Displacement)
    np.testing.assert_allclose(moved, [0.5 * 6 / (3 + beside), 0, 0], rtol=0, atol=1e-12)
