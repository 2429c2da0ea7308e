"""Loads whose user functions read the state: a stiff controller of a double pendulum, with and without their derivatives."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from solving import Variable, new_system, settings

import dalembert as exu

MASS, LENGTH, INERTIA = 2.0, 1.0, 0.2
STIFFNESS, DAMPING = 2e4, 100.0
START = np.array([0.3, -0.2])
END, STEPS = 0.05, 100


def by_nodes(mbs: exu.MainSystem, nodes: list[Any], markers: list[Any]) -> tuple[list[float], list[float]]:
    """Angles and their rates."""
    return (
        [mbs.GetNodeOutput(n, Variable.Rotation)[-1] for n in nodes],
        [mbs.GetNodeOutput(n, Variable.AngularVelocity)[-1] for n in nodes],
    )


def by_markers(mbs: exu.MainSystem, nodes: list[Any], markers: list[Any]) -> tuple[list[float], list[float]]:
    return (
        [start + mbs.GetMarkerOutput(m, Variable.Coordinates)[0] for m, start in zip(markers, START, strict=True)],
        [mbs.GetMarkerOutput(m, Variable.Coordinates_t)[0] for m in markers],
    )


def controlled_pendulum(measure: Any = by_nodes) -> tuple[exu.MainSystem, list[Any]]:
    """Two rods without gravity; a torque on each holds both absolute angles near zero and couples them."""
    mbs = new_system()
    ends, bodies, nodes = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))], [], []
    joint = np.zeros(2)
    for angle in START:
        along = LENGTH * np.array([np.cos(angle), np.sin(angle)])
        nodes.append(mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[*(joint + along / 2), angle])))
        bodies.append(mbs.AddObject(exu.RigidBody2D(physicsMass=MASS, physicsInertia=INERTIA, nodeNumber=nodes[-1])))
        first, second = (
            mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=bodies[-1], localPosition=[x, 0, 0]))
            for x in (-LENGTH / 2, LENGTH / 2)
        )
        mbs.AddObject(exu.RevoluteJoint2D(markerNumbers=[ends[-1], first]))
        ends.append(second)
        joint = joint + along

    def torque(k: int) -> Any:
        def controlled(mbs: exu.MainSystem, t: float, load: list[float]) -> list[float]:
            angles, rates = measure(mbs, nodes, coordinates)
            return [0, 0, control(np.array(angles), np.array(rates))[k]]

        return controlled

    coordinates = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=2)) for n in nodes]
    loads = []
    for k, body in enumerate(bodies):
        marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body))
        loads.append(mbs.AddLoad(exu.Torque(markerNumber=marker, loadVectorUserFunction=torque(k))))
    mbs.Assemble()
    for load in loads:
        mbs.systemData.AddODE2LoadDependencies(load, [2, 5])
    return mbs, nodes


def control(angles: np.ndarray, rates: np.ndarray) -> np.ndarray:
    """Torques that depend on both angles and, cubically, on their difference."""
    apart = angles[1] - angles[0]
    push = STIFFNESS * apart * (1 + 3 * apart**2) + DAMPING * (rates[1] - rates[0])
    return np.array([push - STIFFNESS * angles[0], -push])


def exact() -> np.ndarray:
    """The angles at the end, from Lagrange's equations of the two angles."""

    def rates(_: float, state: np.ndarray) -> np.ndarray:
        angles, speeds = state[:2], state[2:]
        coupling = MASS * LENGTH**2 / 2
        c, s = np.cos(angles[1] - angles[0]), np.sin(angles[1] - angles[0])
        own = INERTIA + MASS * LENGTH**2 / 4
        mass = np.array([[own + MASS * LENGTH**2, coupling * c], [coupling * c, own]])
        force = control(angles, speeds) + coupling * s * np.array([speeds[1] ** 2, -(speeds[0] ** 2)])
        return np.concatenate([speeds, np.linalg.solve(mass, force)])

    solution = solve_ivp(rates, (0, END), [*START, 0, 0], method="DOP853", rtol=1e-11, atol=1e-12)
    return np.asarray(solution.y[:2, -1])


def solved(level: int, measure: Any = by_nodes, **newton: Any) -> tuple[np.ndarray, int]:
    """The angles at the end and the number of Newton iterations."""
    mbs, nodes = controlled_pendulum(measure)
    chosen = settings(END, STEPS, tolerance=1e-9)
    chosen.timeIntegration.computeLoadsJacobian = level
    chosen.timeIntegration.generalizedAlpha.computeInitialAccelerations = True
    for name, value in newton.items():
        setattr(chosen.timeIntegration.newton.numericalDifferentiation, name, value)
    mbs.SolveDynamic(chosen)
    angles = [mbs.GetNodeOutput(n, Variable.Rotation)[-1] for n in nodes]
    return np.array(angles), mbs.sys["dynamicSolver"].it.newtonStepsCount


def test_derivatives_of_loads_save_iterations_and_keep_the_result() -> None:
    """Generalized alpha is of second order: 100 steps leave errors of 5e-5. Newton's tolerance leaves 1e-8."""
    results = [solved(level) for level in (0, 1, 2)]
    same = [
        solved(2, by_markers),
        solved(0, doSystemWideDifferentiation=True),
        solved(0, by_markers, doSystemWideDifferentiation=True),
    ]
    for angles, _ in [*results, *same]:
        np.testing.assert_allclose(angles, results[2][0], rtol=0, atol=1e-8)
        np.testing.assert_allclose(angles, exact(), rtol=0, atol=1e-4)
    without, positions, velocities = (iterations for _, iterations in results)
    assert 2 * STEPS <= velocities <= 3 * STEPS
    assert velocities < positions < without
    assert without > 4 * velocities
    for _, iterations in same:
        assert abs(iterations - velocities) < 0.1 * STEPS


@pytest.mark.parametrize("node", [exu.NodeType.RotationRotationVector, exu.NodeType.RotationEulerParameters], ids=str)
def test_loads_depend_on_the_coordinates_that_they_act_on(node: exu.NodeType) -> None:
    """Statics of a spring that a user function states; Newton's method converges in a few iterations."""
    mbs = new_system()
    body = mbs.CreateRigidBody(referencePosition=[1, 0, 0], inertia=exu.utilities.InertiaSphere(1, 1), nodeType=node)
    marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body))
    weight = np.array([30.0, 20, 10])

    def spring(mbs: exu.MainSystem, t: float, load: list[float]) -> Any:
        u = np.array(mbs.GetObjectOutputBody(body, Variable.Displacement))
        return weight - 100 * u * (1 + u @ u)

    mbs.AddLoad(exu.Force(markerNumber=marker, loadVectorUserFunction=spring))
    fixed = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    mbs.AddObject(exu.GenericJoint(markerNumbers=[fixed, marker], constrainedAxes=[0, 0, 0, 1, 1, 1]))
    mbs.Assemble()
    chosen = exu.SimulationSettings()
    chosen.solutionSettings.writeSolutionToFile = False
    chosen.staticSolver.newton.relativeTolerance = chosen.staticSolver.newton.absoluteTolerance = 1e-11
    mbs.SolveStatic(chosen)
    u = np.array(mbs.GetObjectOutputBody(body, Variable.Displacement))
    size = np.linalg.norm(u)
    np.testing.assert_allclose(100 * u * (1 + size**2), weight, rtol=0, atol=1e-9)
    assert mbs.sys["staticSolver"].it.newtonStepsCount <= 8


def fewer_iterations(mbs: exu.MainSystem, sparse: bool = False) -> int:
    """Linearization of the controlled pendulum with derivatives by all coordinates: about two a step, and four times as
    many without."""
    chosen = settings(END, STEPS, tolerance=1e-9)
    chosen.timeIntegration.computeLoadsJacobian = 2
    if sparse:
        chosen.linearSolverType = exu.LinearSolverType.EigenSparse
    mbs.SolveDynamic(chosen)
    return int(mbs.sys["dynamicSolver"].it.newtonStepsCount)


def test_dependencies_outlive_assemble_until_coordinates_are_numbered_anew() -> None:
    mbs, _ = controlled_pendulum()
    few = fewer_iterations(mbs)
    assert few <= 3 * STEPS
    mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=mbs.AddNode(exu.NodePoint())))
    mbs.Assemble()
    assert fewer_iterations(mbs) == few
    spare = mbs.AddLoad(exu.LoadCoordinate(markerNumber=mbs.GetMarkerNumber("marker1"), load=0))
    mbs.DeleteLoad(spare, deleteDependentMarkers=False)
    mbs.Assemble()
    assert fewer_iterations(mbs) == few
    mbs.DeleteObject(mbs.systemData.NumberOfObjects() - 1)  # with its node
    mbs.Assemble()
    assert fewer_iterations(mbs) > 3 * STEPS


@pytest.mark.parametrize("sparse", [False, True])
def test_a_load_that_gets_its_function_after_assemble_is_differentiated(sparse: bool) -> None:
    """Also after a first solution, when the entries of the system matrix are known."""
    counts = []
    for late in (False, True):
        mbs, _ = controlled_pendulum()
        functions = [mbs.GetLoadParameter(i, "loadVectorUserFunction") for i in range(2)]
        if late:
            for i in range(2):
                mbs.SetLoadParameter(i, "loadVectorUserFunction", 0)
            mbs.Assemble()
            mbs.systemData.AddODE2LoadDependencies(0, [2])
            assert fewer_iterations(mbs, sparse) <= 3 * STEPS
            for i, function in enumerate(functions):
                mbs.SetLoadParameter(i, "loadVectorUserFunction", function)
                mbs.systemData.AddODE2LoadDependencies(i, [2, 5])
        counts.append(fewer_iterations(mbs, sparse))
    assert counts[0] == counts[1] <= 3 * STEPS


def test_a_solver_that_has_begun_goes_on_when_dependencies_are_added() -> None:
    """It keeps its matrix; the new derivatives are those of the solver that begins then."""
    angles = []
    for interrupted in (False, True):
        mbs, nodes = controlled_pendulum()
        chosen = settings(END, STEPS, tolerance=1e-9)
        chosen.linearSolverType = exu.LinearSolverType.EigenSparse
        chosen.timeIntegration.computeLoadsJacobian = 2
        functions = [mbs.GetLoadParameter(i, "loadVectorUserFunction") for i in range(2)]
        for i in range(2):
            mbs.SetLoadParameter(i, "loadVectorUserFunction", 0)
        mbs.DeleteNode(mbs.AddNode(exu.NodePoint()))  # forgets the dependencies
        mbs.Assemble()
        solver = exu.MainSolverImplicitSecondOrder()
        solver.InitializeSolver(mbs, chosen)
        start, accelerations = mbs.systemData.GetSystemState(), mbs.systemData.GetODE2Coordinates_tt()
        for i, function in enumerate(functions):
            mbs.SetLoadParameter(i, "loadVectorUserFunction", function)
            mbs.systemData.AddODE2LoadDependencies(i, [2, 5])
        if interrupted:
            assert fewer_iterations(mbs, sparse=True) <= 3 * STEPS
            mbs.systemData.SetSystemState(start)
            mbs.systemData.SetODE2Coordinates_tt(accelerations)
        assert solver.SolveSteps(mbs, chosen)
        solver.FinalizeSolver(mbs, chosen)
        angles.append([mbs.GetNodeOutput(n, Variable.Rotation)[-1] for n in nodes])
    np.testing.assert_allclose(angles[1], angles[0], rtol=0, atol=1e-8)
