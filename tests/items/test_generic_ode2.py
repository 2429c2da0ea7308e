"""ObjectGenericODE2 and ObjectGenericODE1, and loads on them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateVectorConstraint,
    LoadCoordinate,
    MarkerNodeCoordinate,
    MarkerNodeCoordinates,
    MarkerNodePosition,
    MarkerSuperElementPosition,
    NodeGenericODE1,
    NodeGenericODE2,
    NodePoint,
    NodePoint2D,
    NodePointGround,
    ObjectGenericODE1,
    ObjectGenericODE2,
    SphericalJoint,
)

Variable = exu.OutputVariableType

MASS = np.array([[3.0, 0.5, 0], [0.5, 2, 0.1], [0, 0.1, 1]])
STIFFNESS = np.array([[40.0, -10, 0], [-10, 30, -5], [0, -5, 20]])
DAMPING = 0.02 * STIFFNESS + 0.1 * MASS
FORCE = np.array([1.0, -2, 0.5])
START, SPEED = np.array([0.1, 0, -0.2]), np.array([0, 0.3, 0])


def sparse(matrix: np.ndarray) -> Any:
    container = exu.MatrixContainer()
    rows, columns = np.nonzero(matrix)
    triplets = np.column_stack([rows, columns, matrix[rows, columns]])
    container.SetWithSparseMatrix(triplets, *matrix.shape)
    return container


def oscillator(mbs: Any, **parameters: Any) -> tuple[Any, Any]:
    node = mbs.AddNode(
        NodeGenericODE2(
            numberOfODE2Coordinates=3,
            referenceCoordinates=[7, 8, 9],
            initialCoordinates=START,
            initialCoordinates_t=SPEED,
        )
    )
    return node, mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], **parameters))


def run(mbs: Any, end: float = 0.5, steps: int = 500, **solver: Any) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = end
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    mbs.SolveDynamic(settings, **solver)


def exact(end: float = 0.5) -> np.ndarray:
    inverse = np.linalg.inv(MASS)
    matrix = np.block([[np.zeros((3, 3)), np.eye(3)], [-inverse @ STIFFNESS, -inverse @ DAMPING]])
    rest = np.linalg.solve(STIFFNESS, FORCE)
    state = expm(end * matrix) @ np.concatenate([START - rest, SPEED])
    return state[:3] + rest


def user_force(mbs: Any, t: float, item: int, q: Any, q_t: Any) -> np.ndarray:
    return -STIFFNESS @ np.array(q) - DAMPING @ np.array(q_t) + FORCE


def user_jacobian(mbs: Any, t: float, item: int, q: Any, q_t: Any, by_q: float, by_q_t: float) -> Any:
    return by_q * STIFFNESS + by_q_t * DAMPING


VARIANTS: dict[str, dict[str, Any]] = {
    "dense": {"massMatrix": MASS, "stiffnessMatrix": STIFFNESS, "dampingMatrix": DAMPING, "forceVector": FORCE},
    "sparse": {
        "massMatrix": sparse(MASS),
        "stiffnessMatrix": sparse(STIFFNESS),
        "dampingMatrix": sparse(DAMPING),
        "forceVector": FORCE,
    },
    "mixed": {
        "massMatrix": sparse(MASS),
        "stiffnessMatrix": STIFFNESS,
        "dampingMatrix": sparse(DAMPING),
        "forceVector": FORCE,
    },
    "force function": {"massMatrix": MASS, "forceUserFunction": user_force},
    "with its jacobian": {
        "massMatrix": MASS,
        "forceUserFunction": user_force,
        "jacobianUserFunction": user_jacobian,
    },
    "mass function": {
        "massMatrixUserFunction": lambda mbs, t, item, q, q_t: MASS,
        "stiffnessMatrix": STIFFNESS,
        "dampingMatrix": DAMPING,
        "forceVector": FORCE,
    },
}


@pytest.mark.parametrize("variant", list(VARIANTS))
def test_linear_oscillator(mbs: Any, variant: str) -> None:
    node, body = oscillator(mbs, **VARIANTS[variant])
    run(mbs)
    assert mbs.GetNodeOutput(node, Variable.Coordinates) == pytest.approx(exact(), abs=2e-6)
    assert mbs.GetObjectOutput(body, Variable.CoordinatesTotal) == pytest.approx(exact() + [7, 8, 9], abs=2e-6)
    q, v = (mbs.GetObjectOutput(body, name) for name in (Variable.Coordinates, Variable.Coordinates_t))
    force = STIFFNESS @ q + DAMPING @ v - FORCE
    assert mbs.GetObjectOutput(body, Variable.Force) == pytest.approx(force, abs=1e-10)


def test_repeated_triplets_add_up(mbs: Any) -> None:
    container = exu.MatrixContainer()
    container.SetWithSparseMatrix(np.array([[0, 0, 1.0], [1, 1, 2], [2, 2, 3], [0, 0, 4]]), 3, 3)
    node, _ = oscillator(mbs, stiffnessMatrix=container, forceVector=[10, 4, 6])
    mbs.Assemble()
    mbs.SolveStatic()
    assert mbs.GetNodeOutput(node, Variable.Coordinates) == pytest.approx([2, 2, 2])


@pytest.mark.parametrize("parameter", ["massMatrix", "stiffnessMatrix", "dampingMatrix", "forceVector"])
def test_wrong_sizes_are_refused(mbs: Any, parameter: str) -> None:
    oscillator(mbs, **{parameter: np.ones(2) if parameter == "forceVector" else np.eye(2)})
    with pytest.raises(ValueError, match="3 coordinates") as error:
        mbs.Assemble()
    assert parameter in str(error.value)


def test_nodes_of_several_types(mbs: Any) -> None:
    nodes = [
        mbs.AddNode(NodePoint()),
        mbs.AddNode(NodePoint2D()),
        mbs.AddNode(NodeGenericODE2(numberOfODE2Coordinates=2)),
    ]
    body = mbs.AddObject(
        ObjectGenericODE2(nodeNumbers=nodes, stiffnessMatrix=np.diag(np.arange(1.0, 8)), forceVector=np.ones(7))
    )
    mbs.Assemble()
    mbs.SolveStatic()
    assert mbs.GetObjectOutput(body, Variable.Coordinates) == pytest.approx(1 / np.arange(1.0, 8))
    assert mbs.GetObjectOutputSuperElement(body, Variable.Displacement, 1) == pytest.approx([1 / 4, 1 / 5, 0])


def test_ode1_step_response(mbs: Any) -> None:
    matrix = np.array([[-1.0, 0.2], [1, -2]])
    node = mbs.AddNode(
        NodeGenericODE1(numberOfODE1Coordinates=2, referenceCoordinates=[0, 0], initialCoordinates=[1, 0])
    )

    def rest(mbs: Any, t: float, item: int, q: Any) -> list[float]:
        return [0.2 * q[1], -2 * q[1]]

    mbs.AddObject(
        ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1, 0], [1, 0]], rhsVector=[1, 0], rhsUserFunction=rest)
    )
    run(mbs, 1.0, 100, solverType=exu.DynamicSolverType.RK44)
    steady = np.linalg.solve(matrix, [-1.0, 0])
    expected = expm(matrix) @ (np.array([1, 0]) - steady) + steady
    assert mbs.GetNodeOutput(node, Variable.Coordinates) == pytest.approx(expected, abs=1e-6)


def test_joint_on_mesh_nodes(mbs: Any) -> None:
    """A spherical joint holds the weighted mean of two springs' ends: their forces balance by the same weights."""
    nodes = [mbs.AddNode(NodePoint(referenceCoordinates=[x, 0, 0])) for x in (0, 1)]
    body = mbs.AddObject(
        ObjectGenericODE2(
            nodeNumbers=nodes, stiffnessMatrix=np.diag([1.0, 1, 1, 2, 2, 2]), forceVector=[0, 3, 0, 0, 0, 0]
        )
    )
    mean = mbs.AddMarker(
        MarkerSuperElementPosition(bodyNumber=body, meshNodeNumbers=[0, 1], weightingFactors=[0.25, 0.75])
    )
    fixed = mbs.AddMarker(
        MarkerNodePosition(nodeNumber=mbs.AddNode(NodePointGround(referenceCoordinates=[0.75, 0, 0])))
    )
    joint = mbs.AddObject(SphericalJoint(markerNumbers=[fixed, mean]))
    mbs.Assemble()
    mbs.SolveStatic()
    # y0 = 3 - lambda/4, y1 = -3 lambda/8, y0/4 + 3 y1/4 = 0
    reaction = 0.75 / (1 / 16 + 9 / 32)
    assert abs(mbs.GetObjectOutput(joint, Variable.Force)[1]) == pytest.approx(reaction)
    assert mbs.GetNodeOutput(nodes[0], Variable.Displacement)[1] == pytest.approx(3 - reaction / 4)
    assert mbs.GetMarkerOutput(mean, Variable.Position) == pytest.approx([0.75, 0, 0])


@pytest.mark.parametrize(
    ("parameters", "expected"),
    [({"meshNodeNumbers": [0, 2], "weightingFactors": [1, 1]}, "0 to 1"), ({"meshNodeNumbers": [0]}, "1 numbers")],
)
def test_mesh_marker_refuses(mbs: Any, parameters: dict[str, Any], expected: str) -> None:
    nodes = [mbs.AddNode(NodePoint()) for _ in range(2)]
    body = mbs.AddObject(ObjectGenericODE2(nodeNumbers=nodes))
    mbs.AddMarker(MarkerSuperElementPosition(bodyNumber=body, **parameters))
    with pytest.raises(ValueError, match=expected):
        mbs.Assemble()


BEAD = np.array([4, 1]) / np.sqrt(5)  # normal (1, 1)


def ellipse(mbs: Any, **parameters: Any) -> np.ndarray:
    """A bead on an ellipse, on springs to the origin; it rests where the force on it is normal to the ellipse."""
    node = mbs.AddNode(NodePoint2D(initialCoordinates=[1.7, 0.5]))
    mbs.AddObject(ObjectGenericODE2(nodeNumbers=[node], stiffnessMatrix=np.eye(2)))
    ground = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=mbs.AddNode(NodePointGround())))
    point = mbs.AddMarker(MarkerNodeCoordinates(nodeNumber=node))
    mbs.AddObject(CoordinateVectorConstraint(markerNumbers=[ground, point], **parameters))
    for coordinate, load in enumerate(BEAD + 0.5):
        marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))
        mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=load))
    mbs.Assemble()
    mbs.SolveStatic()
    return np.asarray(mbs.GetNodeOutput(node, Variable.CoordinatesTotal))


def test_quadratic_constraint(mbs: Any) -> None:
    position = ellipse(mbs, quadraticTermMarker1=np.array([[0.25, 1.0]]), offset=[1])
    assert position == pytest.approx(BEAD, abs=1e-7)


def test_constraint_user_functions(mbs: Any) -> None:
    def gap(mbs: Any, t: float, item: int, q: Any, q_t: Any, velocity_level: bool) -> list[float]:
        assert not velocity_level
        return [0.25 * q[0] ** 2 + q[1] ** 2 - 1]

    def gradient(mbs: Any, t: float, item: int, q: Any, q_t: Any, velocity_level: bool) -> list[list[float]]:
        return [[0.5 * q[0], 2 * q[1]]]

    position = ellipse(mbs, scalingMarker0=np.zeros((1, 1)), constraintUserFunction=gap, jacobianUserFunction=gradient)
    assert position == pytest.approx(BEAD, abs=1e-7)


def test_calls_of_a_force_function() -> None:
    """Its differences begin from the value that the residual has asked for: 2 n calls for a Jacobian, one for a residual."""
    calls = []

    def force(mbs: Any, t: float, item: int, q: Any, v: Any) -> Any:
        calls.append(t)
        return FORCE - STIFFNESS @ q - DAMPING @ v - 10 * np.asarray(q) ** 3

    mbs = exu.SystemContainer().AddSystem()
    oscillator(mbs, massMatrix=MASS, forceUserFunction=force)
    run(mbs, end=0.1, steps=20)
    it = mbs.sys["dynamicSolver"].it
    assert it.newtonJacobiCount >= 20
    jacobians = 2 * 3 * it.newtonJacobiCount
    # one residual at the start of each step, one after each iteration, and those of the initial accelerations
    assert jacobians < len(calls) <= jacobians + 20 + it.newtonStepsCount + 4
