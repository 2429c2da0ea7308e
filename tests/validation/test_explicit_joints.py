"""Explicit Runge-Kutta methods with joints: multipliers at each stage, and the way back onto the constraints after each step."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from bricard_reference import third_corners
from solving import Solver, Variable, new_system, settings
from test_andrews import END, Squeezer, angles
from test_bricard import Bricard

import dalembert as exu
from dalembert.solver import SolverError

NODE_TYPES = [
    exu.NodeType.RotationEulerParameters,
    exu.NodeType.RotationRxyz,
    exu.NodeType.RotationRotationVector,
]


def tolerances(end: float, tolerance: float, steps: int = 100) -> Any:
    s = settings(end, steps)
    s.timeIntegration.absoluteTolerance = s.timeIntegration.relativeTolerance = tolerance
    return s


def largest_gap(mbs: Any) -> float:
    state = exu._core.testing.State(mbs)
    return float(np.abs(exu._core.testing.gaps(mbs, state)).max())


@pytest.mark.parametrize("method", [Solver.DOPRI5, Solver.DOP853])
def test_the_squeezer_holds_a_tolerance(method: Any) -> None:
    squeezer = Squeezer()
    squeezer.mbs.SolveDynamic(tolerances(0.03, 1e-8), solverType=method)
    np.testing.assert_allclose(squeezer.angles(), angles(END), rtol=0, atol=1e-6)
    assert largest_gap(squeezer.mbs) < 1e-12


CART, MASS = 1.9997632825, -0.0216651897  # after 10 s: place along the rail, and height, by quadrature


def cart_pole() -> tuple[Any, Any, Any]:
    """A cart of 1 mg on a rail, and a mass of 1 kg on a rod of 1 m."""
    mbs = new_system()
    ground = mbs.AddNode(exu.NodePointGround())
    cart = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0, 0]))
    mass = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[1, 0]))
    bodies = [mbs.AddObject(exu.MassPoint2D(nodeNumber=node, physicsMass=m)) for node, m in ((cart, 1e-6), (mass, 1.0))]
    rail = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=i)) for n, i in ((ground, 0), (cart, 1))]
    mbs.AddObject(exu.CoordinateConstraint(markerNumbers=rail))
    ends = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body)) for body in bodies]
    mbs.AddObject(exu.DistanceConstraint(markerNumbers=ends, distance=1))
    mbs.AddLoad(exu.Force(markerNumber=ends[1], loadVector=[0, -9.81, 0]))
    mbs.Assemble()
    return mbs, cart, mass


@pytest.mark.parametrize(("method", "tolerance"), [(Solver.DOPRI5, 1e-9), (Solver.DOP853, 1e-8)])
def test_a_light_cart_with_a_heavy_pole(method: Any, tolerance: float) -> None:
    mbs, cart, mass = cart_pole()
    mbs.SolveDynamic(tolerances(10, tolerance), solverType=method)
    place = [mbs.GetNodeOutput(cart, Variable.Position)[0], mbs.GetNodeOutput(mass, Variable.Position)[1]]
    assert place == pytest.approx([CART, MASS], abs=1e-6)


def test_a_light_cart_with_the_default_solver() -> None:
    """The solution with tolerances meets the bound of the acceptance number P5; equal steps are too coarse, and say
    so."""
    mbs, cart, mass = cart_pole()
    s = tolerances(10, 1e-5, 1000)
    s.stepSizeControl.implicitSolvers = True
    s.timeIntegration.initialStepSize = 1e-5
    mbs.SolveDynamic(s)
    place = [mbs.GetNodeOutput(cart, Variable.Position)[0], mbs.GetNodeOutput(mass, Variable.Position)[1]]
    assert place == pytest.approx([CART, MASS], abs=1e-2)
    mbs, _, _ = cart_pole()
    (doubt,) = mbs.SolveDynamic(settings(10, 1000)).doubts
    assert doubt.startswith("constraints turn too far in ")


@pytest.mark.parametrize("freed", [{}, {5: 0}], ids=["redundant", "regular"])
def test_bricard(freed: dict[int, int]) -> None:
    bricard = Bricard(freed)
    bricard.mbs.SolveDynamic(tolerances(1, 1e-9), solverType=Solver.DOPRI5)
    assert bricard.third_corner() == pytest.approx(third_corners()[1.0], abs=1e-7)
    assert bricard.energy() == pytest.approx(0, abs=1e-7) and largest_gap(bricard.mbs) < 1e-11
    assert bricard.mbs.sys["dynamicSolver"].GetRedundantConstraints()["count"] == (0 if freed else 1)


@pytest.mark.parametrize(
    ("method", "order", "steps"), [(Solver.RK33, 3, 50), (Solver.RK44, 4, 50), (Solver.RK67, 6, 25)]
)
def test_orders(method: Any, order: int, steps: int) -> None:
    """Multipliers and projection leave the order of the method."""
    wanted = third_corners()[1.0]

    def error(steps: int) -> float:
        bricard = Bricard({5: 0})
        bricard.mbs.SolveDynamic(settings(1, steps), solverType=method)
        return float(np.linalg.norm(bricard.third_corner() - wanted))

    assert np.log2(error(steps) / error(2 * steps)) > order - 0.5


def carried_mass(by_velocity: bool = False) -> tuple[Any, Any]:
    """System and node of a mass that is carried along x = sin(3 t) / 2: the multiplier is the force that this takes."""
    mbs = new_system()
    ground = mbs.AddNode(exu.NodePointGround())
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0, 0], initialVelocities=[1.5, 0]))
    mbs.AddObject(exu.MassPoint2D(nodeNumber=node, physicsMass=2.0))
    markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, node)]
    mbs.AddObject(
        exu.CoordinateConstraint(
            markerNumbers=markers,
            velocityLevel=by_velocity,
            offsetUserFunction=lambda mbs, t, number, offset: 0.5 * np.sin(3 * t),
            offsetUserFunction_t=lambda mbs, t, number, offset: 1.5 * np.cos(3 * t),
        )
    )
    mbs.Assemble()
    return mbs, node


def test_a_driven_constraint() -> None:
    mbs, node = carried_mass()
    mbs.SolveDynamic(settings(1, 200), solverType=Solver.RK44)
    assert mbs.GetNodeOutput(node, Variable.Position)[0] == pytest.approx(0.5 * np.sin(3), abs=1e-9)
    assert mbs.GetNodeOutput(node, Variable.Velocity)[0] == pytest.approx(1.5 * np.cos(3), abs=1e-6)
    assert abs(mbs.systemData.GetAECoordinates()[0]) == pytest.approx(9 * np.sin(3), abs=1e-5)


@pytest.mark.parametrize("by_velocity", [False, True])
@pytest.mark.parametrize("solver", [Solver.RK44, Solver.DOPRI5, Solver.ESDIRK43])
def test_a_driven_motion(solver: Any, by_velocity: bool) -> None:
    """Second differences of a rate lag by steps, or follow another motion; one-sided first differences of positions
    gave velocity errors of 2e-6, for any tolerance."""
    mbs, node = carried_mass(by_velocity)
    s = settings(1, 200)
    s.timeIntegration.automaticStepSize = False
    mbs.SolveDynamic(s, solverType=solver)
    assert mbs.GetNodeOutput(node, Variable.Position)[0] == pytest.approx(0.5 * np.sin(3), abs=1e-9)
    assert mbs.GetNodeOutput(node, Variable.Velocity)[0] == pytest.approx(1.5 * np.cos(3), abs=1e-9)
    assert abs(mbs.systemData.GetAECoordinates()[0]) == pytest.approx(9 * np.sin(3), abs=1e-5)


@pytest.mark.parametrize("node", NODE_TYPES, ids=lambda node: node.name)
@pytest.mark.parametrize("solver", [Solver.RK44, Solver.DOPRI5, Solver.ESDIRK43])
def test_a_driven_rotation(solver: Any, node: Any) -> None:
    """The torque is that of the inertia. Straight ways of Euler parameters, which get longer there, changed accelerations by the square of the angle."""
    mbs = new_system()
    body = mbs.CreateRigidBody(inertia=exu.utilities.InertiaCuboid(1000, [0.6, 0.2, 0.1]), nodeType=node)
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b)) for b in (mbs.CreateGround(), body)]
    joint = mbs.AddObject(
        exu.GenericJoint(
            markerNumbers=markers,
            offsetUserFunction=lambda mbs, t, number, parameters: [0, 0, 0, 0, 0, 0.5 * (1 - np.cos(3 * t))],
            offsetUserFunction_t=lambda mbs, t, number, parameters: [0, 0, 0, 0, 0, 1.5 * np.sin(3 * t)],
        )
    )
    mbs.Assemble()
    s = settings(0.8, 80)
    s.timeIntegration.automaticStepSize = False
    mbs.SolveDynamic(s, solverType=solver)
    torque = 12 * (0.6**2 + 0.2**2) / 12 * 4.5 * np.cos(2.4)
    assert abs(mbs.GetObjectOutput(joint, Variable.TorqueLocal)[2]) == pytest.approx(abs(torque), rel=1e-6)


@pytest.mark.parametrize("solver", [Solver.RK44, Solver.DOPRI5, Solver.ESDIRK43])
def test_user_functions_are_not_asked_long_after_the_end(solver: Any) -> None:
    """Tables end there. Drives of constraints are detected at a few times, and by differences; loads are not
    affected."""
    mbs, node = carried_mass()
    times: dict[str, list[float]] = {"offset": [], "load": []}

    def offset(mbs: Any, t: float, number: int, offset: float) -> float:
        times["offset"].append(t)
        return float(0.5 * np.sin(3 * t))

    def load(mbs: Any, t: float, load: float) -> float:
        times["load"].append(t)
        return load

    mbs.SetObjectParameter(1, "offsetUserFunction", offset)
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=1))
    mbs.AddLoad(exu.LoadCoordinate(markerNumber=marker, load=1.0, loadUserFunction=load))
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.5, 20), solverType=solver)
    assert 0.5 < max(times["offset"]) < 0.501 and max(times["load"]) == pytest.approx(0.5, abs=1e-12)


def test_verlet_refuses_joints() -> None:
    with pytest.raises(ValueError, match="DOPRI5, which keeps all constraints"):
        Bricard({}).mbs.SolveDynamic(settings(1, 10), solverType=Solver.VelocityVerlet)


def test_gaps_that_cannot_be_closed() -> None:
    mbs, _, _ = cart_pole()
    mbs.SetNodeParameter(1, "initialVelocities", [1e9, 0])
    mbs.Assemble()
    with pytest.raises(SolverError):
        mbs.SolveDynamic(settings(1, 10), solverType=Solver.RK44)


@pytest.mark.parametrize("method", [Solver.ExplicitMidpoint, Solver.RK44])
@pytest.mark.parametrize("node", NODE_TYPES, ids=lambda node: node.name)
def test_long_steps_of_a_pendulum(node: Any, method: Any) -> None:
    """Steps of 10 ms, in which it turns by up to 0.07 rad: it keeps its energy as far as the order of the method goes."""
    mbs = new_system()
    body = mbs.CreateRigidBody(
        referencePosition=[0.5, 0, 0],
        inertia=exu.utilities.InertiaCuboid(1000, [0.1, 0.1, 0.1]),
        gravity=[0, -9.81, 0],
        nodeType=node,
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[mbs.CreateGround(), body], position=[0, 0, 0], axis=[0, 0, 1])
    mbs.Assemble()
    assert mbs.SolveDynamic(settings(1, 100), solverType=method) is True
    spin = mbs.GetObjectOutputBody(body, Variable.AngularVelocity)[2]
    height = mbs.GetObjectOutputBody(body, Variable.Position)[1]
    inertia = 0.5**2 + 0.1**2 / 6  # by the mass
    assert abs(0.5 * inertia * spin**2 + 9.81 * height) < {Solver.ExplicitMidpoint: 7e-3, Solver.RK44: 4e-6}[method]
    assert largest_gap(mbs) < 1e-12


@pytest.mark.parametrize(
    "method", [Solver.ExplicitEuler, Solver.RK44, Solver.DOPRI5, Solver.ODE23, Solver.ExplicitMidpoint]
)
def test_the_first_row_of_outputs(method: Any) -> None:
    """A swinging pendulum has the accelerations and the force of Newton's second law at the start, as in all other
    rows."""
    mbs = new_system()
    ground = mbs.CreateGround()
    inertia = exu.rigidBodyUtilities.InertiaCuboid(1000, [0.1, 0.1, 0.1])
    body = mbs.CreateRigidBody(
        referencePosition=[0.6, -0.8, 0],
        inertia=inertia,
        gravity=[0, -9.81, 0],
        initialVelocity=[1.6, 1.2, 0],
        initialAngularVelocity=[0, 0, 2],
    )
    hinge = mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    spring = mbs.CreateMassPoint(referencePosition=[2, 0, 0], physicsMass=3, create2D=True)
    mbs.CreateSpringDamper(bodyNumbers=[ground, spring], stiffness=60, referenceLength=1)
    sensors = [
        mbs.AddSensor(exu.SensorBody(bodyNumber=b, outputVariableType=Variable.Acceleration, storeInternal=True))
        for b in (body, spring)
    ]
    sensors.append(
        mbs.AddSensor(exu.SensorObject(objectNumber=hinge, outputVariableType=Variable.ForceLocal, storeInternal=True))
    )
    mbs.Assemble()
    s = settings(1e-3, 1)
    mbs.SolveDynamic(s, solverType=method)
    acceleration, of_spring, force = (mbs.GetSensorStoredData(sensor)[0, 1:] for sensor in sensors)
    position, mass = np.array([0.6, -0.8, 0]), inertia.Mass()
    alpha = -mass * 9.81 * 0.6 / (inertia.InertiaCOM()[2, 2] + mass)
    expected = np.cross([0, 0, alpha], position) - 4 * position
    assert acceleration == pytest.approx(expected, abs=1e-10)
    assert np.linalg.norm(force) == pytest.approx(mass * np.linalg.norm(expected + [0, 9.81, 0]), rel=1e-10)
    assert of_spring == pytest.approx([-20, 0, 0], abs=1e-12)
