"""Geometrically exact beams in space: results do not depend on the frame of the model, on the order of the loads, nor on their increments."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from rods import Rod, section
from scipy.spatial.transform import Rotation
from solving import Variable, settings

import dalembert as exu

STIFFNESS = section([1e4, 5e3, 4e3, 3, 5, 8])
FORCE, TORQUE = np.array([0.4, -1.5, 2.0]), np.array([3.0, 1.0, -2.0])
TURN = Rotation.from_rotvec([2.1, -1.3, 0.8]).as_matrix()


def bent(turn: Any, path: Any, steps: int = 40, node: type = exu.NodeRigidBodyRotVecLG) -> np.ndarray:
    """Tip displacement and, as a matrix, the turn of the tip, in the axes of the model; `path` gives shares of force and torque."""
    rod = Rod(node)
    nodes = rod.add_leg(np.zeros(3), turn, 2.0, 6, STIFFNESS)
    rod.join(rod.ground, rod.marker(nodes[0]), turn)
    force, torque = turn @ FORCE, turn @ TORQUE
    rod.load(nodes[-1], exu.Force, [0, 0, 0], loadVectorUserFunction=lambda mbs, t, v: path(t)[0] * force)
    rod.load(nodes[-1], exu.Torque, [0, 0, 0], loadVectorUserFunction=lambda mbs, t, v: path(t)[1] * torque)
    rod.mbs.Assemble()
    chosen = settings(1, 1)
    static = chosen.staticSolver
    static.verboseMode, static.useLoadFactor, static.numberOfLoadSteps = 0, False, steps
    static.newton.relativeTolerance = static.newton.absoluteTolerance = 1e-13
    rod.mbs.SolveStatic(chosen)
    place = np.array(rod.mbs.GetNodeOutput(nodes[-1], Variable.Displacement))
    rotation = np.array(rod.mbs.GetNodeOutput(nodes[-1], Variable.RotationMatrix)).reshape(3, 3)
    return np.vstack([turn.T @ place, turn.T @ rotation])


def together(t: float) -> tuple[float, float]:
    return t, t


def force_first(t: float) -> tuple[float, float]:
    return min(1.0, 2 * t), max(0.0, 2 * t - 1)


def torque_first(t: float) -> tuple[float, float]:
    return max(0.0, 2 * t - 1), min(1.0, 2 * t)


each_node = pytest.mark.parametrize("node", [exu.NodeRigidBodyRotVecLG, exu.NodeRigidBodyEP])


@each_node
def test_turned_model(node: type) -> None:
    plain, turned = bent(np.eye(3), together, node=node), bent(TURN, together, node=node)
    assert np.linalg.norm(plain[0]) > 0.9  # m
    assert np.arccos((np.trace(plain[1:]) - 1) / 2) > 1  # rad
    np.testing.assert_allclose(turned, plain, rtol=0, atol=1e-10)


@each_node
@pytest.mark.parametrize("path", [force_first, torque_first])
def test_order_of_loads(node: type, path: Any) -> None:
    np.testing.assert_allclose(bent(TURN, path, node=node), bent(TURN, together, node=node), rtol=0, atol=1e-10)


def test_size_of_increments() -> None:
    np.testing.assert_allclose(bent(TURN, together, 90), bent(TURN, together, 40), rtol=0, atol=1e-10)


def test_nodes_of_two_kinds() -> None:
    """Strains are those of relative frames, so that rotation coordinates do not show."""
    vectors, parameters = (bent(TURN, together, node=n) for n in (exu.NodeRigidBodyRotVecLG, exu.NodeRigidBodyEP))
    np.testing.assert_allclose(vectors, parameters, rtol=0, atol=1e-10)


def clamped_arc(elements: int, force: float, steps: int) -> np.ndarray:
    """K. J. Bathe and S. Bolourchi, 1979: 45 degrees of a circle of radius 100, with a square section of side 1."""
    rod = Rod()
    angle = np.pi / 4 / elements
    of = section([1e7, 41.6667e5, 41.6667e5, 8.333e5, 8.333e5, 8.333e5])
    turns = [Rotation.from_rotvec([0, 0, i * angle]).as_matrix() for i in range(elements + 1)]
    nodes = [
        rod.add_node(100 * np.array([np.sin(i * angle), 1 - np.cos(i * angle), 0]), turn)
        for i, turn in enumerate(turns)
    ]
    for pair in zip(nodes[:-1], nodes[1:], strict=True):
        rod.mbs.AddObject(
            exu.ObjectBeamGeometricallyExact(physicsLength=100 * angle, sectionData=of, nodeNumbers=list(pair))
        )
    rod.nodes = nodes
    rod.clamp()
    rod.load(nodes[-1], exu.Force, [0, 0, force])
    rod.mbs.Assemble()
    rod.solve_static(steps, 1e-11)
    return rod.displacement(nodes[-1])


@pytest.mark.parametrize(
    ("force", "wanted"),
    [
        (300, (-11.9323642572, -7.0449803355, 40.1932664427)),
        (450, (-18.4731087858, -10.7816467345, 48.5042421389)),
        (600, (-23.5612967857, -13.6050230096, 53.4761081403)),
    ],
)
def test_limit_of_the_bend(force: float, wanted: Any) -> None:
    """Even powers of the element length, taken off one after the other, leave the solution of the differential equations."""
    table = [clamped_arc(n, force, 10) for n in (8, 16, 32, 64)]
    for factor in (4, 16, 64):
        table = [(factor * b - a) / (factor - 1) for a, b in zip(table[:-1], table[1:], strict=True)]
    np.testing.assert_allclose(table[0], wanted, rtol=0, atol=1e-9 * np.linalg.norm(wanted))
    np.testing.assert_allclose(clamped_arc(8, force, 7), clamped_arc(8, force, 10), rtol=0, atol=1e-8)
