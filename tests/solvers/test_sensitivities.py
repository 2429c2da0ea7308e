"""mbs.ComputeSensitivities and exu.DifferentiableModel: kinds of items, input, and what is refused."""

from __future__ import annotations

import tracemalloc
import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
import scipy.optimize
import scipy.sparse

import dalembert as exu
from dalembert._core import testing
from dalembert.itemInterface import (
    CoordinateConstraint,
    CoordinateSpringDamper,
    CoordinateSpringDamperExt,
    DistanceConstraint,
    GenericJoint,
    LoadCoordinate,
    LoadForceVector,
    LoadMassProportional,
    LoadTorqueVector,
    MarkerBodyMass,
    MarkerBodyPosition,
    MarkerBodyRigid,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    Mass1D,
    MassPoint,
    Node1D,
    NodeGenericData,
    NodePoint,
    NodePoint2DSlope1,
    NodePointGround,
    NodeRigidBodyEP,
    NodeRigidBodyRotVecLG,
    ObjectANCFCable2D,
    ObjectContactCoordinate,
    ObjectGenericODE2,
    ObjectGround,
    ObjectRigidBody,
    RigidBodySpringDamper,
    SensorBody,
    SensorMarker,
    SensorNode,
    SpringDamper,
    VObjectGround,
)
from dalembert.processing import ComputeSensitivities, Minimize
from dalembert.utilities import (
    CreateSymbolicUserFunction,
    InertiaCuboid,
    RotationMatrix2EulerParameters,
    RotationMatrixX,
    RotationMatrixY,
)

Variable = exu.OutputVariableType
CENTRAL = {-2: 1 / 12, -1: -8 / 12, 1: 8 / 12, 2: -1 / 12}


def new_system() -> Any:
    return exu.SystemContainer().AddSystem()


def settings(end: float = 0.4, steps: int = 40, radius: float = 0.6) -> Any:
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = end, steps
    s.timeIntegration.generalizedAlpha.spectralRadius = radius
    s.timeIntegration.verboseMode = 0
    s.timeIntegration.newton.relativeTolerance, s.timeIntegration.newton.absoluteTolerance = 1e-12, 1e-13
    s.solutionSettings.writeSolutionToFile = False
    return s


def ground_coordinate(mbs: Any) -> Any:
    return mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))


def oscillator(damping: float = 0.5, **spring: Any) -> Any:
    """A mass on a spring, pulled by a force."""
    mbs = new_system()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[0.1], name="node"))
    mbs.AddObject(Mass1D(physicsMass=2, nodeNumber=node, name="mass"))
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(
        CoordinateSpringDamper(
            markerNumbers=[ground_coordinate(mbs), marker], stiffness=50, damping=damping, name="spring", **spring
        )
    )
    mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=3, name="force"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="x"))
    mbs.Assemble()
    return mbs


# ---- kinds of items: derivatives are those of differences of whole solutions -------------------------------------------


def spatial(node: Any = NodeRigidBodyRotVecLG, connector: Any = None) -> Any:
    """A free body with a connector to the ground, and weight."""
    mbs = new_system()
    reference = [0.3, 0.1, -0.2, 1, 0, 0, 0] if node is NodeRigidBodyEP else [0.3, 0.1, -0.2, 0.1, -0.2, 0.3]
    if node is NodeRigidBodyEP:
        reference[3:] = RotationMatrix2EulerParameters(RotationMatrixX(0.3) @ RotationMatrixY(0.5))
    number = mbs.AddNode(
        node(referenceCoordinates=reference, initialVelocities=[0.2] * 3 + [0] * (len(reference) - 3), name="node")
    )
    body = mbs.AddObject(
        ObjectRigidBody(
            physicsMass=2, physicsInertia=[0.1, 0.2, 0.15, 0.01, 0, 0.02], physicsCenterOfMass=[0.05, 0, 0.02], nodeNumber=number,
            name="body",
        )
    )  # fmt: skip
    ground = mbs.AddObject(ObjectGround(referencePosition=[0.1, 0, 0], name="ground"))
    markers = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=[0, 0.1, 0], name="fixed")),
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=[0.1, 0.2, 0.3], name="point")),
    ]
    if connector is not None:
        connector(mbs, markers)
    mass = mbs.AddMarker(MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(LoadMassProportional(markerNumber=mass, loadVector=[0, 0, -9.81], name="weight"))
    mbs.AddLoad(LoadTorqueVector(markerNumber=markers[1], loadVector=[0.1, 0.2, 0.3], bodyFixed=True, name="torque"))
    mbs.AddSensor(SensorMarker(markerNumber=markers[1], outputVariableType=Variable.Position, name="p"))
    mbs.AddSensor(SensorBody(bodyNumber=body, outputVariableType=Variable.AngularVelocityLocal, name="w"))
    mbs.AddSensor(
        SensorBody(bodyNumber=body, localPosition=[0.2, 0, 0], outputVariableType=Variable.Acceleration, name="a")
    )
    mbs.Assemble()
    return mbs


def bushing(mbs: Any, markers: Any) -> None:
    mbs.AddObject(
        RigidBodySpringDamper(
            markerNumbers=markers, stiffness=np.diag([100, 120, 140, 10, 12, 14]), damping=np.diag([1, 1, 2, 0.1, 0.1, 0.2]),
            offset=[0.1, 0, 0, 0, 0.1, 0], name="connector",
        )
    )  # fmt: skip


def hinge(mbs: Any, markers: Any) -> None:
    mbs.AddObject(
        GenericJoint(
            markerNumbers=[
                mbs.AddMarker(MarkerBodyRigid(bodyNumber="ground", localPosition=[0.2, 0.1, -0.2])),
                mbs.AddMarker(MarkerBodyRigid(bodyNumber="body", localPosition=[0, 0, 0], name="pin")),
            ],
            constrainedAxes=[1, 1, 1, 0, 0, 0],
            name="joint",
        )
    )
    bushing(mbs, markers)


def cable() -> Any:
    mbs = new_system()
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[0.5 * i, 0, 1, 0], name=f"end {i}")) for i in range(3)]
    for i in range(2):
        mbs.AddObject(
            ObjectANCFCable2D(
                physicsLength=0.5, physicsMassPerLength=1, physicsBendingStiffness=2, physicsAxialStiffness=500, physicsBendingDamping=0.01,
                nodeNumbers=nodes[i : i + 2], name=f"cable {i}",
            )
        )  # fmt: skip
    for i in (0, 1, 3):
        marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=i))
        mbs.AddObject(CoordinateConstraint(markerNumbers=[ground_coordinate(mbs), marker], name=f"clamp {i}"))
    tip = mbs.AddMarker(MarkerNodePosition(nodeNumber=nodes[2]))
    mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=[0, -3, 0], name="force"))
    mbs.AddSensor(SensorNode(nodeNumber=nodes[2], outputVariableType=Variable.Position, name="p"))
    mbs.Assemble()
    return mbs


def matrices() -> Any:
    mbs = new_system()
    nodes = [mbs.AddNode(NodePoint(referenceCoordinates=[i, 0, 0], name=f"end {i}")) for i in range(2)]
    random = np.random.default_rng(1)
    part = random.normal(size=(6, 6))
    mbs.AddObject(
        ObjectGenericODE2(
            nodeNumbers=nodes, massMatrix=np.diag([1.0, 2, 3, 4, 5, 6]), stiffnessMatrix=part @ part.T + 10 * np.eye(6),
            dampingMatrix=0.1 * np.eye(6), forceVector=[1.0, 2, 3, 4, 5, 6], name="matrices",
        )
    )  # fmt: skip
    mbs.AddSensor(SensorNode(nodeNumber=nodes[1], outputVariableType=Variable.Position, name="p"))
    mbs.Assemble()
    return mbs


Given = dict[str, Any]
MODELS: dict[str, tuple[Callable[[], Any], Given, Given]] = {
    "oscillator": (
        oscillator,
        {"m": ("mass", "physicsMass"), "k": ("spring", "stiffness"), "d": ("spring", "damping"), "offset": ("spring", "offset"),
         "F": ("force", "load"), "x0": ("node", "initialCoordinates", 0), "reference": ("node", "referenceCoordinates", 0)},
        {"x": "x", "v": exu.Final(0, 1), "a": exu.Final(0, 2), "E": exu.Integral("x", lambda x: float(x @ x), start=0.1)},
    ),
    "bushing": (
        lambda: spatial(connector=bushing),
        {"m": ("body", "physicsMass"), "Jyz": ("body", "physicsInertia", 3), "com": ("body", "physicsCenterOfMass", 0),
         "com1": ("body", "physicsCenterOfMass", 1),
         "k": ("connector", "stiffness", (1, 1)), "coupling": ("connector", "stiffness", (0, 4)), "d": ("connector", "damping", (5, 5)),
         "offset": ("connector", "offset", 0), "place": ("point", "localPosition", 2), "ground": ("ground", "referencePosition", 1),
         "fixed": ("fixed", "localPosition", 0), "T": ("torque", "loadVector", 1), "g": ("weight", "loadVector", 2),
         "x0": ("node", "referenceCoordinates", 1), "turn": ("node", "referenceCoordinates", 4), "w0": ("node", "initialVelocities", 5)},
        {"p": "p", "w": exu.At("w", component=1), "a": exu.At("a", 0.2, component=2), "start": exu.At("a", 0.0, component=1),
         "E": exu.Integral("w", lambda w: float(w @ w))},
    ),
    "joint": (
        lambda: spatial(node=NodeRigidBodyEP, connector=hinge),
        {"m": ("body", "physicsMass"), "Jy": ("body", "physicsInertia", 1), "com": ("body", "physicsCenterOfMass", 1),
         "k": ("connector", "stiffness", (1, 1)), "T": ("torque", "loadVector", 1)},
        {"p": "p", "w": exu.At("w", component=1), "F": exu.Reaction("joint", 1), "F0": exu.Reaction("joint", 2, time=0.0)},
    ),
    "cable": (
        cable,
        {"EI": [("cable 0", "physicsBendingStiffness"), ("cable 1", "physicsBendingStiffness")], "EA": ("cable 0", "physicsAxialStiffness"),
         "rho": ("cable 1", "physicsMassPerLength"), "d": ("cable 0", "physicsBendingDamping"), "strain": ("cable 0", "physicsReferenceAxialStrain"),
         "L": ("cable 1", "physicsLength"), "F": ("force", "loadVector", 0), "y0": ("end 1", "initialCoordinates", 1)},
        {"y": exu.At("p", component=1), "F": exu.Reaction("clamp 1")},
    ),
    "matrices": (
        matrices,
        {"M": ("matrices", "massMatrix", (0, 0)), "K": ("matrices", "stiffnessMatrix", (3, 4)), "D": ("matrices", "dampingMatrix", (2, 2)),
         "f": ("matrices", "forceVector", 5)},
        {"x": "p"},
    ),
}  # fmt: skip


def varied(build: Callable[[], Any], given: Any, value: float) -> Any:
    """The model with another value, through its dictionary of parameters."""
    mbs = build()
    for item, parameter, *entry in given if isinstance(given, list) else [given]:
        kind = next(k for k in ("Object", "Node", "Load", "Marker") if int(getattr(mbs, f"Get{k}Number")(item)) >= 0)
        number = getattr(mbs, f"Get{kind}Number")(item)
        now = getattr(mbs, f"Get{kind}Parameter")(number, parameter)
        if entry:
            now = np.array(now, dtype=float)
            now[entry[0]] = value
        getattr(mbs, f"Set{kind}Parameter")(number, parameter, now if entry else value)
    mbs.Assemble()
    return mbs


def value_of(mbs: Any, given: Any) -> float:
    item, parameter, *entry = given[0] if isinstance(given, list) else given
    kind = next(k for k in ("Object", "Node", "Load", "Marker") if int(getattr(mbs, f"Get{k}Number")(item)) >= 0)
    now = getattr(mbs, f"Get{kind}Parameter")(getattr(mbs, f"Get{kind}Number")(item), parameter)
    return float(np.asarray(now)[entry[0]] if entry else now)


def outputs_of(mbs: Any, any_parameter: Given, outputs: Given, solver: Any, with_settings: Any) -> Any:
    values = mbs.ComputeSensitivities(any_parameter, outputs, with_settings, solver, "forward").values
    return np.array(list(values.values()))


@pytest.mark.filterwarnings("ignore:ComputeSensitivities. initial values do not fulfil")
@pytest.mark.parametrize(
    "solver",
    [exu.DynamicSolverType.GeneralizedAlpha, exu.DynamicSolverType.TrapezoidalIndex2],
    ids=["alpha", "trapezoidal"],
)
@pytest.mark.parametrize("name", MODELS)
def test_derivatives_by_parameters_of_items(name: str, solver: Any) -> None:
    build, parameters, outputs = MODELS[name]
    if solver == exu.DynamicSolverType.TrapezoidalIndex2 and name == "joint":
        build = lambda: spatial(connector=hinge)  # noqa: E731  Euler parameters are refused there
    s = settings()
    forward = build().ComputeSensitivities(parameters, outputs, s, solver, "forward")
    adjoint = build().ComputeSensitivities(parameters, outputs, s, solver, "adjoint")
    size = np.abs(forward.matrix).max(axis=1, keepdims=True)
    assert np.all(np.abs(forward.matrix - adjoint.matrix) < 1e-10 * size)
    cheap = dict([next(iter(parameters.items()))])
    for k, given in enumerate(parameters.values()):
        x = value_of(build(), given)
        step = 1e-3 * abs(x) if x else 1e-3
        if x == 0 and "amping" in str(given):
            continue
        differences = sum(
            weight / step * outputs_of(varied(build, given, x + multiple * step), cheap, outputs, solver, s)
            for multiple, weight in CENTRAL.items()
        )
        scale = np.maximum(np.abs(forward.matrix[:, k]), 1e-3 * size[:, 0])
        assert np.all(np.abs(forward.matrix[:, k] - differences) < 2e-6 * scale), (
            list(parameters)[k],
            forward.matrix[:, k],
            differences,
        )


def test_undamped_spring_has_a_derivative_by_its_damping() -> None:
    # A damping of 0 may not be negative: differences go to one side. m x.. + d x. + k x = F, x(0) = x0: with x_d = dx/dd,
    # m x_d.. + k x_d = -x.; for a free vibration A cos(w t) around F/k, x_d = -A/(2 m) (t cos(w t) - sin(w t)/w).
    mbs = oscillator(damping=0.0)
    end, w, amplitude = 0.4, np.sqrt(25.0), 0.1 - 3 / 50
    s = settings(end, 4000, radius=1.0)
    found = mbs.ComputeSensitivities({"d": ("spring", "damping")}, {"x": "x"}, s)
    exact = -amplitude / 4 * (end * np.cos(w * end) - np.sin(w * end) / w)
    assert found.Derivative("x", "d") == pytest.approx(exact, rel=1e-6)


def test_histories_are_derivatives_in_time() -> None:
    mbs = oscillator(damping=0.0)
    found = mbs.ComputeSensitivities(
        {"F": ("force", "load")}, {"x": "x"}, settings(1.0, 2000, radius=1.0), storeHistories=True
    )
    history = found.Histories("F")["x"]
    exact = (1 - np.cos(5 * history[:, 0])) / 50
    assert np.max(np.abs(history[:, 1] - exact)) < 2e-6 * np.max(exact)
    assert history[-1, 1] == found.Derivative("x", "F")


def test_values_between_steps() -> None:
    # The error of a cubic polynomial falls with the fourth power of the step, 1e-8; a free vibration around F/k.
    mbs = oscillator(damping=0.0)
    times = [0.0034, 0.5011, 0.9967]
    found = mbs.ComputeSensitivities(
        {"F": ("force", "load")}, {"x": exu.At("x", times)}, settings(1.0, 1000, radius=1.0)
    )
    exact = 3 / 50 + (0.1 - 3 / 50) * np.cos(5 * np.array(times))
    np.testing.assert_allclose(found.values["x"], exact, atol=1e-6)
    np.testing.assert_allclose(found.matrix[:, 0], (1 - np.cos(5 * np.array(times))) / 50, atol=1e-6)
    fine = mbs.ComputeSensitivities(
        {"F": ("force", "load")}, {"x": exu.At("x", 0.5005)}, settings(1.0, 2000, radius=1.0)
    )
    coarse = mbs.ComputeSensitivities(
        {"F": ("force", "load")}, {"x": exu.At("x", 0.5005)}, settings(1.0, 1000, radius=1.0)
    )
    exact_rate = (1 - np.cos(5 * 0.5005)) / 50
    errors = [abs(each.Derivative("x", "F") - exact_rate) for each in (coarse, fine)]
    assert 3.5 < errors[0] / errors[1] < 4.5  # that of the solution


def test_outputs_of_equilibria_need_a_static_solution() -> None:
    found = refusal(oscillator(), outputs={"X": exu.FrequencyResponse("force", "x", 3.0)})
    assert found.reason == "FrequencyResponse belongs to a static equilibrium"
    with pytest.raises(ValueError, match="component: received 1, but the sensor has 1 values"):
        output = exu.FrequencyResponse("force", "x", 3.0, component=1)
        oscillator().ComputeSensitivities({"k": ("spring", "stiffness")}, {"X": output}, solverType="static")


def test_names_of_frequencies_are_those_of_parameters() -> None:
    def solve(parameters: Any, omega: Any) -> None:
        outputs = {"X": exu.Function(lambda x: 2 * x, outputs=[exu.FrequencyResponse("force", "x", omega)])}
        oscillator().ComputeSensitivities(parameters, outputs, solverType="static")

    with pytest.raises(ValueError, match="output 'X': received 'omega', but the parameters are w"):
        solve({"w": exu.DesignParameter(3.0)}, "omega")
    with pytest.raises(ValueError, match="parameter 'w': a DesignParameter without targets, which no output reads"):
        solve({"w": exu.DesignParameter(3.0)}, 2.0)
    with pytest.raises(ValueError, match="omega: parameter 'w' is -3, but expected 0 or more"):
        solve({"w": exu.DesignParameter(-3.0)}, "w")
    with pytest.raises(ValueError, match="a circular frequency in rad/s, or a name"):
        solve({"w": exu.DesignParameter(3.0)}, None)


def test_initial_values_that_systems_were_given_are_used() -> None:
    mbs = oscillator()
    other = oscillator()
    other.SetNodeParameter(0, "initialCoordinates", [0.3])
    other.Assemble()
    mbs.systemData.SetODE2Coordinates([0.3], exu.ConfigurationType.Initial)
    parameters = {"k": ("spring", "stiffness"), "x0": ("node", "initialCoordinates", 0)}
    first = mbs.ComputeSensitivities(parameters, {"x": "x"}, settings())
    second = other.ComputeSensitivities(parameters, {"x": "x"}, settings())
    np.testing.assert_allclose(first.matrix, second.matrix, rtol=1e-12)


def pendulum(length: float = 0.8) -> Any:
    mbs = new_system()
    node = mbs.AddNode(NodePoint(referenceCoordinates=[length, 0, 0], name="node"))
    body = mbs.AddObject(MassPoint(physicsMass=2, nodeNumber=node, name="mass"))
    ends = [mbs.AddMarker(MarkerBodyPosition(bodyNumber=b)) for b in (mbs.AddObject(ObjectGround()), body)]
    mbs.AddObject(DistanceConstraint(markerNumbers=ends, distance=length, name="rod"))
    mbs.AddLoad(LoadForceVector(markerNumber=ends[1], loadVector=[0, -20, 0], name="weight"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Position, storeInternal=True, name="p"))
    mbs.Assemble()
    return mbs


def test_start_follows_constraints_that_vary() -> None:
    # With a consistent start, the length alone gives what length and start together give.
    s, outputs = settings(0.5, 200), {"x": exu.At("p"), "y": exu.At("p", component=1)}
    both = {"L": [("rod", "distance"), ("node", "referenceCoordinates", 0)]}
    expected = pendulum().ComputeSensitivities(both, outputs, s)
    found = pendulum().ComputeSensitivities({"L": ("rod", "distance")}, outputs, s, consistentStart=True)
    np.testing.assert_allclose(found.matrix, expected.matrix, rtol=1e-9)
    with pytest.warns(UserWarning, match="initial values do not fulfil the constraints any more if 'L' vary"):
        pendulum().ComputeSensitivities({"L": ("rod", "distance")}, outputs, s)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pendulum().ComputeSensitivities(both, outputs, s)


# ---- DifferentiableModel -------------------------------------------------------------------------------------------


TIMES = np.linspace(0.05, 0.4, 8)


def identification() -> Any:
    parameters = {"k": ("spring", "stiffness"), "d": ("spring", "damping")}
    return exu.DifferentiableModel(oscillator(), parameters, {"x": exu.At("x", TIMES)}, settings())


def test_identification_finds_the_parameters_of_the_data() -> None:
    problem = identification()
    data = problem.Values([62.0, 0.9])
    residuals, jacobian = problem.LeastSquares(data)
    found = scipy.optimize.least_squares(
        residuals, problem.x0, jac=jacobian, bounds=problem.bounds, x_scale="jac", xtol=1e-14, ftol=1e-14, gtol=None
    )
    np.testing.assert_allclose(found.x, [62.0, 0.9], rtol=1e-7)
    sigma = 1e-3
    covariance = problem.Covariance(found.x, sigma)
    expected = np.linalg.inv(found.jac.T @ found.jac) * sigma**2
    np.testing.assert_allclose(covariance, expected, rtol=1e-5)


def test_model_as_a_function() -> None:
    problem = identification()
    np.testing.assert_array_equal(problem.x0, [50.0, 0.5])
    weighed = exu.DifferentiableModel(
        oscillator(), {"m": ("mass", "physicsMass"), "k": ("spring", "stiffness")}, {"x": "x"}, settings()
    )
    lower, upper = weighed.bounds
    np.testing.assert_array_equal(lower, [0.0, -np.inf])  # springs may have negative stiffness
    assert np.all(np.isinf(upper))
    weights = {"x": np.arange(8.0)}
    value, gradient = problem.ValueAndGradient([55.0, 0.7], weights)
    assert value == pytest.approx(np.arange(8.0) @ problem.Values({"k": 55.0, "d": 0.7})["x"], rel=1e-14)
    np.testing.assert_allclose(problem.Vjp([55.0, 0.7], weights), gradient, rtol=1e-14)
    change = problem.Jvp([55.0, 0.7], [1.0, -2.0])
    assert np.arange(8.0) @ change == pytest.approx(gradient @ [1.0, -2.0], rel=1e-12)
    error = scipy.optimize.check_grad(
        lambda x: problem.ValueAndGradient(x, weights)[0],
        lambda x: problem.ValueAndGradient(x, weights)[1],
        [55.0, 0.7],
    )
    assert error < 1e-5 * np.linalg.norm(gradient)  # forward differences
    assert problem.Check([55.0, 0.7]) == ""


def test_studies_take_exact_derivatives() -> None:
    problem = identification()
    exact = problem.Sensitivities(problem.x0)
    sets, reference, table, slopes = ComputeSensitivities(problem, {"d": (0.5, 1e-3, 2), "k": 50.0}, showProgress=False)
    assert len(sets) == 5 and sets[0] == {"d": 0.5, "k": 50.0}
    np.testing.assert_array_equal(reference, exact.values["x"])
    np.testing.assert_array_equal(slopes, exact.matrix.T[::-1])
    assert table["d"].shape == (4, 8) and table["k"].shape == (0, 8)
    np.testing.assert_allclose((table["d"][2] - table["d"][1]) / 1e-3, slopes[0], rtol=1e-4)
    _, _, _, one = ComputeSensitivities(problem, {"d": 0.5}, scaledByReference=True, showProgress=False)
    np.testing.assert_array_equal(one[0], 0.5 * slopes[0])
    with pytest.raises(ValueError, match="received parameters \\['k', 'd', 'D'\\], but expected \\['k', 'd'\\]"):
        ComputeSensitivities(problem, {"D": 0.5}, showProgress=False)


@pytest.mark.parametrize("method", ["L-BFGS-B", "SLSQP"])
def test_minimize_takes_exact_gradients(method: str) -> None:
    wanted = identification().Values([62.0, 0.9])["x"]
    outputs = {"cost": exu.Function(lambda x: 1e6 * float(np.sum((x - wanted) ** 2)), outputs=[exu.At("x", TIMES)])}
    parameters = {"k": ("spring", "stiffness"), "d": ("spring", "damping")}
    problem = exu.DifferentiableModel(oscillator(), parameters, outputs, settings())
    bounds, options = {"k": (40.0, 90.0), "d": (0.0, 3.0)}, {"ftol": 1e-15, "gtol": 1e-10}
    if method == "SLSQP":
        options.pop("gtol")
    best, value, *_ = Minimize(problem, bounds, method=method, tol=None, options=options, showProgress=False)
    assert value < 1e-8
    assert best["k"] == pytest.approx(62.0, rel=1e-6) and best["d"] == pytest.approx(0.9, rel=1e-5)
    best, *_ = Minimize(
        problem, {"k": (40.0, 60.0), "d": (0.0, 3.0)}, method=method, showProgress=False, tol=None, options=options
    )
    assert best["k"] == 60.0  # a bound
    with pytest.raises(TypeError, match="expected a number"):
        Minimize(identification(), bounds, method=method, showProgress=False)


def test_check_reports_what_disagrees() -> None:
    problem = identification()
    exact = problem.Sensitivities

    def wrong(x: Any) -> Any:
        found = exact(x)
        wrong_matrix = found.matrix.copy()
        wrong_matrix[:, 1] *= 1.01
        return type(found)(**{**vars(found), "matrix": wrong_matrix})

    problem.Sensitivities = wrong
    text = problem.Check([50.0, 0.5])
    assert text.startswith("d x[0]/d d: ") and "d x[7]/d d" in text and "/d k" not in text


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda p: p.Values([1.0]), "x"),
        (lambda p: p.Values({"k": 1.0}), "expected \\['k', 'd'\\]"),
        (lambda p: p.ValueAndGradient([50.0, 0.5], {"y": 1}), "received output 'y'"),
        (lambda p: p.Residuals([50.0, 0.5], {"x": [1.0, 2.0]}), "data\\['x'\\]"),
        (lambda p: p.Residuals([50.0, 0.5], {"y": [1.0]}), "data of 'y'"),
        (lambda p: p.Covariance([50.0, 0.5], -1.0), "positive standard deviations"),
    ],
)
def test_wrong_arguments_of_the_model(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call(identification())


def test_covariance_needs_outputs_that_determine_all_parameters() -> None:
    problem = exu.DifferentiableModel(
        oscillator(), {"k": ("spring", "stiffness"), "d": ("spring", "damping")}, {"x": "x"}, settings()
    )
    with pytest.raises(ValueError, match="do not determine all parameters"):
        problem.Covariance(problem.x0)


# ---- the model stays as it was ---------------------------------------------------------------------------------------


def contents(mbs: Any) -> Any:
    states = [
        mbs.systemData.GetSystemState(configuration)
        for configuration in (exu.ConfigurationType.Current, exu.ConfigurationType.Initial)
    ]
    items = [
        repr(getattr(mbs, f"Get{kind}")(i))
        for kind in ("Node", "Object", "Marker", "Load", "Sensor")
        for i in range(getattr(mbs.systemData, f"NumberOf{kind}s")())
    ]
    kept = [repr(mbs.variables), sorted(mbs.sys), mbs.GetSensorStoredData("p").tobytes(), mbs.systemData.GetTime()]
    return items, [[part.tobytes() for part in state] for state in states], kept


def test_model_does_not_change() -> None:
    mbs = pendulum()
    mbs.SolveDynamic(settings(0.1, 10))
    before = contents(mbs)
    mbs.ComputeSensitivities({"m": ("mass", "physicsMass")}, {"x": "p"}, settings())
    with pytest.raises(ValueError, match="no step ends"):
        mbs.ComputeSensitivities({"m": ("mass", "physicsMass")}, {"x": exu.Reaction("rod", time=0.123)}, settings())
    with pytest.raises(exu.SolverError):
        s = settings()
        s.timeIntegration.newton.maxIterations = 1
        s.timeIntegration.adaptiveStep = False
        mbs.ComputeSensitivities({"m": ("mass", "physicsMass")}, {"x": "p"}, s)
    after = contents(mbs)
    assert before == after


@pytest.mark.parametrize("method", ["forward", "adjoint"])
def test_model_does_not_change_whatever_happens(method: Any) -> None:
    mass: dict[str, Any] = {"m": ("mass", "physicsMass")}
    mbs = pendulum()
    mbs.SolveDynamic(settings(0.1, 10))
    before = contents(mbs)

    def call(parameters: Any = mass, outputs: Any = None, **options: Any) -> Any:
        return mbs.ComputeSensitivities(parameters, outputs or {"x": "p"}, settings(), method=method, **options)

    def failing(x: Any) -> float:
        raise RuntimeError("no value")

    call({**mass, "x0": ("node", "referenceCoordinates", 1)}, consistentStart=True, maximumMemory=1000)
    calls: list[tuple[type, Any]] = [
        (ValueError, lambda: call({"m": ("mass", "physicsMas")})),
        (exu.NotDifferentiable, lambda: call({"m": ("mass", "name")})),
        (exu.NotDifferentiable, lambda: call(solverType=exu.DynamicSolverType.DOP853)),
        (
            exu.NotDifferentiable,
            lambda: call(outputs={"F": exu.Reaction("rod")}, solverType=exu.DynamicSolverType.RK44),
        ),
        (exu.NotDifferentiable, lambda: call(outputs={"w": exu.Eigenvalue(0)})),
        (exu.SolverError, lambda: call(solverType="static")),
        (RuntimeError, lambda: call(outputs={"x": exu.Integral("p", failing)})),
    ]
    for error, function in calls:
        with pytest.raises(error):
            function()
    model = exu.DifferentiableModel(mbs, mass, {"x": "p"}, settings(), method=method)
    model.ValueAndGradient([3.0])
    with pytest.raises(ValueError, match="physicsMass"):
        model.Values([-3.0])
    assert contents(mbs) == before


def test_results_are_the_same_again() -> None:
    mbs = pendulum()
    first, second = (
        mbs.ComputeSensitivities({"m": ("mass", "physicsMass")}, {"x": "p"}, settings()).matrix for _ in range(2)
    )
    assert first.tobytes() == second.tobytes()


# ---- states in a file -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", ["forward", "adjoint"])
@pytest.mark.parametrize("name", ["constraint", "history", "explicit", "end"])
def test_states_in_a_file_give_the_same_bits(name: str, method: Any) -> None:
    mass = {"m": ("mass", "physicsMass")}
    given: dict[str, Any] = {
        "constraint": (pendulum(), mass, settings(0.5, 600)),
        "history": (rubbing(), mass, with_events()),
        "explicit": (oscillator(), mass, settings(), exu.DynamicSolverType.RK44),
        "end": (oscillator(), {**mass, "end": "timeIntegration.endTime"}, settings()),
    }
    mbs, parameters, *options = given[name]
    outputs = {
        "x": exu.At("p" if name == "constraint" else "x"),
        "E": exu.Integral("p" if name == "constraint" else "x"),
    }
    first, second, third = (
        mbs.ComputeSensitivities(parameters, outputs, *options, method=method, maximumMemory=memory)
        for memory in (None, 1, 5000)
    )
    assert first.matrix.tobytes() == second.matrix.tobytes() == third.matrix.tobytes()
    assert first.values == second.values == third.values


def test_memory_is_limited() -> None:
    # A state has 240 numbers: 1000 steps take 1.92 MB, and are written in blocks of at most 256 rows.
    size, steps = 60, 1000
    mbs = new_system()
    nodes = [mbs.AddNode(NodePoint(referenceCoordinates=[i, 0, 0])) for i in range(size // 3)]
    mbs.AddObject(
        ObjectGenericODE2(
            nodeNumbers=nodes, massMatrix=np.eye(size), stiffnessMatrix=10 * np.eye(size), forceVector=np.ones(size),
            name="matrices",
        )
    )  # fmt: skip
    mbs.AddSensor(SensorNode(nodeNumber=nodes[0], outputVariableType=Variable.Position, name="p"))
    mbs.Assemble()

    def peak(count: int, memory: float | None) -> float:
        tracemalloc.start()
        try:
            given = {"f": ("matrices", "forceVector", 0)}
            mbs.ComputeSensitivities(given, {"x": "p"}, settings(1.0, count), method="adjoint", maximumMemory=memory)
            return tracemalloc.get_traced_memory()[1]
        finally:
            tracemalloc.stop()

    peak(10, None)
    growth = peak(steps, 1e5) - peak(500, 1e5)
    assert peak(steps, None) - peak(500, None) > 500 * 8 * 240
    assert growth < 0.1 * 500 * 8 * 240  # times of steps alone


@pytest.mark.parametrize("memory", [0, -1e6, "much", [1e6]])
def test_wrong_memory(memory: Any) -> None:
    with pytest.raises((ValueError, TypeError), match="maximumMemory"):
        oscillator().ComputeSensitivities({"k": ("spring", "stiffness")}, {"x": "x"}, settings(), maximumMemory=memory)


# ---- what is refused --------------------------------------------------------------------------------------------------


def refusal(mbs: Any, parameters: Any = None, outputs: Any = None, with_settings: Any = None, **options: Any) -> Any:
    with pytest.raises(exu.NotDifferentiable) as raised:
        mbs.ComputeSensitivities(
            parameters or {"k": ("spring", "stiffness")}, outputs or {"x": "x"}, with_settings or settings(), **options
        )
    return raised.value


def test_functions_of_python_are_refused() -> None:
    mbs = oscillator(springForceUserFunction=lambda mbs, t, i, u, v, k, d, offset: k * u)
    found = refusal(mbs)
    assert found.item == "object 1 'spring' (ConnectorCoordinateSpringDamper)"
    assert found.reason == "springForceUserFunction is a function without derivative"
    assert "dalembert.symbolic" in found.advice
    assert str(found).startswith("object 1 'spring' (ConnectorCoordinateSpringDamper): springForceUserFunction is")
    assert isinstance(found, ValueError)


@pytest.mark.parametrize("name", ["PreStep", "PostStep", "PostNewton"])
def test_functions_in_steps_are_refused(name: str) -> None:
    mbs = oscillator()
    getattr(mbs, f"Set{name}UserFunction")(lambda mbs, t: True)
    assert refusal(mbs).item == f"mbs.{name}UserFunction"


def test_general_contact_is_refused() -> None:
    mbs = oscillator()
    mbs.AddGeneralContact()
    mbs.Assemble()
    assert refusal(mbs).item == "GeneralContact"


def test_drawing_functions_do_not_matter() -> None:
    mbs = oscillator()
    ground = mbs.AddObject(ObjectGround(visualization=VObjectGround(graphicsDataUserFunction=lambda mbs, item: [])))
    mbs.Assemble()
    found = mbs.ComputeSensitivities({"k": ("spring", "stiffness")}, {"x": "x"}, settings())
    assert found.matrix.shape == (1, 1) and int(ground) == 2


def test_euler_parameters_and_the_trapezoidal_rule_are_refused() -> None:
    mbs = spatial(node=NodeRigidBodyEP, connector=bushing)
    found = refusal(mbs, {"m": ("body", "physicsMass")}, {"p": "p"}, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
    assert found.item == "node 0 'node' (RigidBodyEP)"
    assert "normalized" in found.reason


def rubbing(mass: float = 2.0, friction: float = 0.3) -> Any:
    """A mass on a spring with dry friction by bristles, which sticks at each reversal."""
    mbs = new_system()
    node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[0.1], name="node"))
    mbs.AddObject(Mass1D(physicsMass=mass, nodeNumber=node, name="mass"))
    history = mbs.AddNode(NodeGenericData(initialCoordinates=[-1, 0.1, 0], numberOfDataCoordinates=3))
    marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(
        CoordinateSpringDamperExt(
            markerNumbers=[ground_coordinate(mbs), marker],
            stiffness=200,
            fDynamicFriction=friction,
            stickingStiffness=1e4,
            stickingDamping=20,
            frictionProportionalZone=0,
            nodeNumber=history,
            name="spring",
        )
    )
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name="x"))
    mbs.Assemble()
    return mbs


def with_events(end: float = 0.9, steps: int = 90) -> Any:
    s = settings(end, steps)
    s.events.ofItems = True
    return s


def test_history_needs_events() -> None:
    found = refusal(rubbing(), {"m": ("mass", "physicsMass")}, {"x": "x"}, settings(0.9, 90))
    assert found.item.startswith("object 1 'spring'") and "history" in found.reason
    assert "events.ofItems = True" in found.advice


def test_derivatives_through_stick_and_slip() -> None:
    # Anchors of bristles are states: they depend on parameters. Slip turns twice.
    parameters = {
        "m": ("mass", "physicsMass"),
        "k": ("spring", "stiffness"),
        "f": ("spring", "fDynamicFriction"),
        "bristle": ("spring", "stickingStiffness"),
        "x0": ("node", "initialCoordinates", 0),
    }
    outputs = {"x": "x", "t": exu.EventTime("spring", 3), "between": exu.At("x", 0.123), "E": exu.Integral("x")}
    forward, adjoint = (
        rubbing().ComputeSensitivities(parameters, outputs, with_events(), method=method)
        for method in ("forward", "adjoint")
    )
    size = np.abs(forward.matrix * [2, 200, 0.3, 1e4, 0.1]).max(axis=1, keepdims=True)
    assert np.all(np.abs(forward.matrix - adjoint.matrix) * [2, 200, 0.3, 1e4, 0.1] < 1e-10 * size)
    for k, given in enumerate(parameters.values()):
        x = value_of(rubbing(), given)
        differences = sum(
            weight / (1e-4 * x)
            * outputs_of(varied(rubbing, given, x * (1 + 1e-4 * multiple)), {"m": parameters["m"]}, outputs,
                         exu.DynamicSolverType.GeneralizedAlpha, with_events())
            for multiple, weight in CENTRAL.items()
        )  # fmt: skip
        assert np.all(np.abs(forward.matrix[:, k] - differences) * x < 1e-6 * size[:, 0]), (
            k,
            forward.matrix[:, k],
            differences,
        )


def falling(*heights: float) -> Any:
    """Masses that fall on springs."""
    mbs = new_system()
    for i, height in enumerate(heights):
        node = mbs.AddNode(Node1D(referenceCoordinates=[0], initialCoordinates=[height], name=f"node {i}"))
        mbs.AddObject(Mass1D(physicsMass=2, nodeNumber=node, name=f"mass {i}"))
        gap = mbs.AddNode(NodeGenericData(initialCoordinates=[height], numberOfDataCoordinates=1))
        marker = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        ends = [ground_coordinate(mbs), marker]
        mbs.AddObject(
            ObjectContactCoordinate(markerNumbers=ends, nodeNumber=gap, contactStiffness=1e3, name=f"stop {i}")
        )
        mbs.AddLoad(LoadCoordinate(markerNumber=marker, load=-20))
        mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, name=f"x{i}"))
    mbs.Assemble()
    return mbs


def test_events_that_are_refused() -> None:
    parameters, outputs = {"m": ("mass 0", "physicsMass")}, {"x": "x0"}
    found = refusal(falling(0.05, 0.05), parameters, outputs, with_events(0.2, 40))
    assert found.reason == "two events come at the same time"
    with pytest.raises(ValueError, match="output 't': number: received 3, but the object has 2 events"):
        falling(0.05).ComputeSensitivities(parameters, {"t": exu.EventTime("stop 0", 3)}, with_events(0.4, 80))


def thrown(touch: float) -> Any:
    """A mass that gravity slows down at a distance of 0.2 m, where it reaches a spring with a small speed."""
    mbs, weight = falling(0.2), 20.0
    mbs.SetNodeParameter("node 0", "initialVelocities", [-np.sqrt(weight * 0.2 + touch**2)])
    mbs.SetLoadParameter(0, "load", weight)
    mbs.Assemble()
    return mbs


def test_events_that_graze_are_refused() -> None:
    # The mass of 2 kg touches at (v - w)/10 with v^2 = 4 + w^2: dt/d(-v) = (v/w - 1)/10, while rounding errors of the
    # place, 1e-16 m, are those of w^2/20.
    parameters, outputs = {"v": ("node 0", "initialVelocities", 0)}, {"t": exu.EventTime("stop 0")}
    for speed in (1e-2, 1e-4):
        found = thrown(speed).ComputeSensitivities(parameters, outputs, with_events(0.3, 30))
        assert found.Derivative("t", "v") == pytest.approx((np.sqrt(4 + speed**2) / speed - 1) / 10, rel=1e-6)
    refused = refusal(thrown(3e-7), parameters, outputs, with_events(0.3, 30))
    assert refused.item == "event 'contact' of object 1 'stop 0' (ContactCoordinate)"
    assert refused.reason.startswith("its switch grazes zero (rate -") and refused.time == pytest.approx(0.2, rel=1e-5)


def hardening(c3: float = 2e3) -> Any:
    mbs = oscillator()
    number, spring = exu.symbolic.Real("c3", c3), mbs.GetObjectNumber("spring")
    law = CreateSymbolicUserFunction(
        mbs, lambda mbs, t, i, x, v, k, d, offset: k * x + d * v + number * x * x * x, "springForceUserFunction", spring
    )
    mbs.SetObjectParameter(spring, "springForceUserFunction", law)
    mbs.Assemble()
    return mbs


def test_named_numbers_of_recorded_functions() -> None:
    where = ("spring", "springForceUserFunction", "c3")
    model = exu.DifferentiableModel(
        hardening(), {"c3": where, "end": "timeIntegration.endTime"}, {"x": "x"}, settings()
    )
    np.testing.assert_array_equal(model.x0, [2e3, 0.4])
    assert model.Values([3e3, 0.4])["x"] == pytest.approx(
        hardening(3e3).ComputeSensitivities({"c3": where}, {"x": "x"}, settings()).values["x"], rel=1e-12
    )
    assert model.Check(model.x0, digits=8) == ""
    for given in (("spring", "springForceUserFunction"), ("spring", "springForceUserFunction", "c4")):
        with pytest.raises(ValueError, match=r"is a recorded function; pass \(item, parameter, name\) with one of c3"):
            hardening().ComputeSensitivities({"p": given}, {"x": "x"}, settings())


def test_recorded_functions_have_exact_tangents() -> None:
    # Differences of 1e-8 would leave errors of 1e-9.
    mbs = hardening()
    derivatives = testing.SystemDerivatives(mbs)
    x, z = 0.3, np.array([0.3, 0.0, 0.0])
    derivatives.linearize(z, 0.0, 0.01)
    assert derivatives.product("K", np.eye(1))[0, 0] == pytest.approx(50 + 3 * 2e3 * x**2, rel=1e-14)


def test_jacobians_that_are_no_derivatives_are_refused() -> None:
    # Solvers hold a mass matrix of a user function fixed, which is enough for Newton's method.
    mbs = matrices()
    item = mbs.GetObjectNumber("matrices")

    def mass(mbs: Any, t: Any, i: Any, q: Any, v: Any) -> Any:
        diagonal = [1 + q[0] * q[0], 2, 3, 4, 5, 6]
        return exu.symbolic.Matrix([[diagonal[i] if i == j else 0 for j in range(6)] for i in range(6)])

    law = CreateSymbolicUserFunction(mbs, mass, "massMatrixUserFunction", item)
    mbs.ModifyObject(item, {"massMatrixUserFunction": law})
    mbs.Assemble()
    found = refusal(mbs, {"K": ("matrices", "stiffnessMatrix", (3, 4))}, {"x": "p"})
    assert found.reason.startswith("the Jacobian is not the derivative of these equations")


def test_settings_that_are_refused() -> None:
    s = settings()
    s.timeIntegration.automaticStepSize = s.stepSizeControl.implicitSolvers = True
    found = refusal(pendulum(), {"m": ("mass", "physicsMass")}, {"p": "p"}, s)
    assert found.item == "simulationSettings.stepSizeControl.implicitSolvers" and "ESDIRK43" in found.advice
    for solver in (exu.DynamicSolverType.VelocityVerlet, exu.DynamicSolverType.DOP853):
        found = refusal(oscillator(), solverType=solver)
        assert "generalized alpha" in found.reason


def adaptive(tolerance: float = 1e-9, end: float = 0.9) -> Any:
    s = settings(end, 1)
    s.timeIntegration.automaticStepSize = s.stepSizeControl.implicitSolvers = True
    s.timeIntegration.relativeTolerance, s.timeIntegration.absoluteTolerance = tolerance, 0.1 * tolerance
    return s


@pytest.mark.parametrize(
    ("solver", "tolerance", "error"),
    [
        (exu.DynamicSolverType.DOPRI5, 1e-9, 1e-7),
        (exu.DynamicSolverType.ESDIRK43, 1e-9, 1e-7),
        (exu.DynamicSolverType.GeneralizedAlpha, 1e-6, 1e-3),
    ],
)
def test_adaptive_steps_are_frozen(solver: Any, tolerance: float, error: float) -> None:
    # The derivative of the exact solution, to the tolerance of the steps.
    forward, adjoint = (
        oscillator(damping=0.0).ComputeSensitivities(
            {"F": ("force", "load")}, {"x": "x"}, adaptive(tolerance), solver, method
        )
        for method in ("forward", "adjoint")
    )
    assert forward.exactness == adjoint.exactness == "frozen steps"
    assert forward.Derivative("x", "F") == pytest.approx((1 - np.cos(5 * 0.9)) / 50, rel=error)
    assert adjoint.Derivative("x", "F") == pytest.approx(forward.Derivative("x", "F"), rel=1e-10)


@pytest.mark.parametrize("bounces", [False, True], ids=["smooth", "events"])
@pytest.mark.parametrize(
    "solver",
    [exu.DynamicSolverType.DOPRI5, exu.DynamicSolverType.ESDIRK43, exu.DynamicSolverType.GeneralizedAlpha],
)
def test_steps_that_are_repeated(solver: Any, bounces: bool) -> None:
    # Coarse adaptive steps: differences of solutions with steps of their own scatter by the size of their errors.
    s = adaptive(1e-4, 0.4)
    s.events.ofItems = bounces
    mbs = falling(0.05) if bounces else oscillator()
    given: dict[str, Any] = {"m": ("mass 0" if bounces else "mass", "physicsMass"), "T": "timeIntegration.endTime"}
    outputs = {"x": exu.At("x0" if bounces else "x"), "E": exu.Integral("x0" if bounces else "x")}
    replay = exu.DifferentiableModel(mbs, given, outputs, s, solver, steps="replay")
    x = replay.x0.copy()
    first = replay.Sensitivities(x)
    assert first.exactness == "frozen steps"
    assert replay.Sensitivities(x * 1.001).values != first.values
    again = replay.Sensitivities(x)  # with the steps of the first solution
    for name, value in first.values.items():
        assert again.values[name] == pytest.approx(value, rel=1e-12)
    np.testing.assert_allclose(again.matrix, first.matrix, rtol=1e-9)
    for k in range(len(x)):
        step = 1e-4 * x[k] * np.eye(len(x))[k]
        differences = sum(
            weight * np.array(list(replay.Values(x + multiple * step).values())) for multiple, weight in CENTRAL.items()
        ) / (1e-4 * x[k])
        size = np.abs(again.matrix * x).max(axis=1)
        assert np.all(np.abs(again.matrix[:, k] - differences) * x[k] < 1e-7 * size), (again.matrix[:, k], differences)


def test_steps_that_cannot_be_repeated() -> None:
    model = exu.DifferentiableModel
    with pytest.raises(ValueError, match="steps: received 'again', but expected 'frozen' or 'replay'"):
        model(oscillator(), {"k": ("spring", "stiffness")}, {"x": "x"}, settings(), steps="again")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match="steps='replay' needs a time integration"):
        model(oscillator(), {"k": ("spring", "stiffness")}, {"x": "x"}, settings(), "static", steps="replay")
    with pytest.raises(ValueError, match="received ends of steps that do not increase"):
        exu.MainSolverExplicit().PrescribeEndsOfSteps([0.1, 0.1])


def test_redundant_constraints_are_refused() -> None:
    mbs = pendulum()
    ends = mbs.GetObjectParameter(mbs.GetObjectNumber("rod"), "markerNumbers")
    mbs.AddObject(DistanceConstraint(markerNumbers=ends, distance=0.8, name="second rod"))
    mbs.Assemble()
    found = refusal(mbs, {"m": ("mass", "physicsMass")}, {"x": "p"})
    assert "1 constraint equations follow from others" in found.reason
    assert "rod" in found.item


def snapping(place: float) -> Any:
    """The top of two bars, at rest under a load across: its stiffness vanishes at a limit point."""
    mbs = new_system()
    node = mbs.AddNode(NodePoint(referenceCoordinates=[0, 0.3, 0], initialCoordinates=[0, place - 0.3, 0], name="top"))
    body = mbs.AddObject(MassPoint(physicsMass=1, nodeNumber=node, name="mass"))
    ends = [MarkerBodyPosition(bodyNumber=mbs.AddObject(ObjectGround(referencePosition=[x, 0, 0]))) for x in (-1, 1)]
    middle = mbs.AddMarker(MarkerBodyPosition(bodyNumber=body))
    full = np.hypot(1, 0.3)
    for i, end in enumerate(ends):
        markers = [mbs.AddMarker(end), middle]
        mbs.AddObject(SpringDamper(markerNumbers=markers, referenceLength=full, stiffness=100, name=f"bar {i}"))
    mbs.AddObject(CoordinateSpringDamper(markerNumbers=[ground_coordinate(mbs), mbs.AddMarker(
        MarkerNodeCoordinate(nodeNumber=node, coordinate=2))], stiffness=50))  # fmt: skip
    load = 200 * place * (1 - full / np.hypot(1, place))
    mbs.AddLoad(LoadForceVector(markerNumber=middle, loadVector=[0, load, 0], name="force"))
    mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Position, name="p"))
    mbs.Assemble()
    return mbs


def test_limit_points_are_refused() -> None:
    # F = 2 k y (1 - l/sqrt(1 + y^2)), which is largest where (1 + y^2)^(3/2) = l.
    full = np.hypot(1, 0.3)
    limit = np.sqrt(full ** (2 / 3) - 1)
    parameters, outputs = {"F": ("force", "loadVector", 1)}, {"y": exu.At("p", component=1)}
    for place in (0.29, limit + 0.01):
        found = snapping(place).ComputeSensitivities(parameters, outputs, solverType="static")
        assert found.values["y"] == pytest.approx(place, rel=1e-9)
        slope = 200 * (1 - full / np.hypot(1, place) ** 3)
        assert found.Derivative("y", "F") == pytest.approx(1 / slope, rel=1e-6)
    refused = refusal(snapping(limit), parameters, outputs, solverType="static")
    assert refused.reason.startswith("the stiffness matrix is singular: a limit point")
    assert refused.item.startswith("node 0 'top'")


def test_inactive_connectors_have_no_influence() -> None:
    mbs = oscillator()
    mbs.SetObjectParameter("spring", "activeConnector", False)
    mbs.Assemble()
    given = {"k": ("spring", "stiffness"), "F": ("force", "load")}
    for method in ("forward", "adjoint"):
        found = mbs.ComputeSensitivities(given, {"x": "x"}, settings(), method=method)  # x = F t^2/(2 m)
        assert found.Derivative("x", "k") == 0.0
        assert found.Derivative("x", "F") == pytest.approx(0.04, rel=1e-9)


def test_integers_are_refused() -> None:
    mbs = rubbing()
    found = refusal(mbs, {"n": (mbs.GetNode(1)["name"], "numberOfDataCoordinates")}, with_settings=with_events())
    assert found.reason == "numberOfDataCoordinates is an integer: 3" and found.parameter == "n"


def test_singular_equilibrium_is_refused() -> None:
    mbs = oscillator()
    mbs.SetObjectParameter(1, "stiffness", 0.0)
    mbs.SetLoadParameter(0, "load", 0.0)
    mbs.Assemble()
    with pytest.raises((exu.NotDifferentiable, exu.SolverError)):
        mbs.ComputeSensitivities({"F": ("force", "load")}, {"x": "x"}, solverType="static")


def test_corrected_velocities_are_refused() -> None:
    # Coarse steps of a pendulum with much remembrance: the solver takes away velocities across the constraint.
    mbs = pendulum()
    found = refusal(mbs, {"m": ("mass", "physicsMass")}, {"x": "p"}, settings(8.0, 100, radius=0.99))
    assert found.item == "time integration" and found.time is not None


@pytest.mark.parametrize(
    ("parameter", "error", "message"),
    [
        (("sprang", "stiffness"), ValueError, "parameter 'p': received 'sprang'"),
        (("spring", "stifness"), ValueError, "parameter 'p'"),
        (("spring", "stiffness", 0), ValueError, "entry 0 of stiffness, which has the shape \\(\\)"),
        (("node", "initialCoordinates"), ValueError, "has the shape \\(1,\\); pass \\(item, parameter, entry\\)"),
        (("node", "initialCoordinates", 1), ValueError, "entry 1 of initialCoordinates"),
        (("spring", "activeConnector"), exu.NotDifferentiable, "activeConnector is not a real number"),
        (("spring", "name"), exu.NotDifferentiable, "name is not a real number"),
        (
            "timeIntegration.startTime",
            exu.NotDifferentiable,
            "timeIntegration.startTime, parameter 'p': it is a setting",
        ),
        ("timeIntegration.nothing", ValueError, "'timeIntegration.nothing', which is no setting"),
        ("spring", ValueError, r"but expected \(item, parameter\), such as \('spring', 'stiffness'\)"),
        (("spring",), ValueError, "expected \\(item, parameter\\)"),
        ((1, "stiffness"), ValueError, "received 1 as item"),
        ([], ValueError, "received an empty list"),
        ([("spring", "stiffness"), ("spring", "damping")], ValueError, "its places have different values"),
        (
            exu.DesignParameter(7.0, {("spring", "stiffness"): 1.0}),
            ValueError,
            "is 50.0, but the value of the DesignParameter makes it 7.0",
        ),
    ],
)
def test_wrong_parameters(parameter: Any, error: type, message: str) -> None:
    with pytest.raises(error, match=message):
        oscillator().ComputeSensitivities({"p": parameter}, {"x": "x"}, settings())


@pytest.mark.parametrize(
    ("output", "message"),
    [
        ("y", "output 'o': received 'y'"),
        (exu.At("x", 7.0), "no step ends at time 7 s; .*; it has to lie within the computed time"),
        (exu.Integral("x", end=0.123), "no step ends at time 0.123 s; .*; choose steps that end there"),
        (exu.At("x", float("nan")), "no step ends at time nan s; .*; it has to lie within the computed time"),
        (
            exu.Function(lambda x: float("nan"), ["x"]),
            "output 'o': its function returned nan, but expected a finite number",
        ),
        (
            exu.Integral("x", lambda x: np.array([1.0, 2.0])),
            "its function returned array.*, but expected a finite number",
        ),
        (exu.EventTime("spring"), "number: received 1, but the object has 0 events"),
        (exu.At("x", component=2), "component: received 2, but the sensor has 1 values"),
        (exu.Final(5), "received 5, but the system has 1 ODE2 coordinates"),
        (exu.Reaction("spring"), "the object has 0 constraint equations"),
        (exu.At, "expected At\\(...\\), with arguments, received <class"),
    ],
)
def test_wrong_outputs(output: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        oscillator().ComputeSensitivities({"k": ("spring", "stiffness")}, {"o": output}, settings())


def test_wrong_arguments() -> None:
    mbs = oscillator()
    with pytest.raises(ValueError, match="parameters"):
        mbs.ComputeSensitivities({}, {"x": "x"}, settings())
    with pytest.raises(ValueError, match="outputs"):
        mbs.ComputeSensitivities({"k": ("spring", "stiffness")}, {}, settings())
    with pytest.raises(ValueError, match="expected one of auto, forward, adjoint"):
        mbs.ComputeSensitivities({"k": ("spring", "stiffness")}, {"x": "x"}, settings(), method="backward")
    found = mbs.ComputeSensitivities({"k": ("spring", "stiffness")}, {"x": "x"}, settings())
    with pytest.raises(ValueError, match="received output 'y'"):
        found.Derivative("y", "k")
    with pytest.raises(ValueError, match="received parameter 'K'"):
        found.Derivative("x", "K")
    with pytest.raises(ValueError, match="storeHistories=True"):
        found.Histories("k")


# ---- matrices -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("bodies", [2, 12], ids=["dense", "sparse"])
def test_factors_of_transposed_matrices(bodies: int) -> None:
    # A chain with gyroscopic forces and reactions, whose matrices are not symmetric.
    mbs = new_system()
    last = mbs.CreateGround()
    for i in range(bodies):
        body = mbs.CreateRigidBody(
            referencePosition=[i + 0.5, 0, 0], inertia=InertiaCuboid(100, [1, 0.2, 0.1]), initialAngularVelocity=[1, 2, 3],
            gravity=[0, -9.81, 0],
        )  # fmt: skip
        mbs.CreateSphericalJoint(bodyNumbers=[last, body], position=[i, 0, 0])
        last = body
    mbs.Assemble()
    derivatives = testing.SystemDerivatives(mbs)
    n, n1, m, _ = derivatives.sizes
    random = np.random.default_rng(2)
    z = 0.1 * random.normal(size=3 * n + 2 * n1 + m)
    derivatives.linearize(z, 0.0, 0.01)
    size = n + n1 + m
    unit = np.eye(size)
    stiffness = derivatives.product("K", unit).T
    damping, mass = derivatives.product("D", np.eye(n)).T, derivatives.product("M", np.eye(n)).T
    np.testing.assert_allclose(derivatives.product("K", unit, transposed=True), stiffness, rtol=1e-13)
    np.testing.assert_allclose(derivatives.product("D", unit, transposed=True), damping, rtol=1e-13)
    matrix = stiffness.copy()
    matrix[:, :n] += 50 * damping
    matrix[:n, :n] += 4e4 * mass
    right = random.normal(size=(3, size))
    for transposed in (False, True):
        assert derivatives.factorize((1.0, 50.0, 4e4, 1.0, 50.0, 1.0, 0.0), scale=2.5e-5, transposed=transposed) == -1
        exact = np.linalg.solve(matrix.T if transposed else matrix, right.T).T
        np.testing.assert_allclose(derivatives.solve(right), exact, rtol=1e-9, atol=1e-9 * np.abs(exact).max())


def test_matrices_are_derivatives_of_the_residual() -> None:
    mbs = spatial(connector=bushing)
    derivatives = testing.SystemDerivatives(mbs)
    n, _, m, _ = derivatives.sizes
    z = 0.1 * np.random.default_rng(3).normal(size=3 * n + m)
    derivatives.linearize(z, 0.0, 0.01)
    for matrix, begin, size in (("K", 0, n + m), ("D", n, n), ("M", 2 * n, n)):
        found = derivatives.product(matrix, np.eye(size))[:n]
        for i in range(n):

            def residual(e: float, i: int = i, begin: int = begin) -> Any:
                moved = z.copy()
                unit = e * np.eye(n)[i]
                if begin == 0:
                    moved[:n] = derivatives.compose(z[:n], unit)
                else:
                    moved[begin : begin + n] += unit
                return derivatives.residual(moved, 0.0, 0.01)

            expected = sum(weight / 1e-3 * residual(multiple * 1e-3) for multiple, weight in CENTRAL.items())
            np.testing.assert_allclose(found[i], expected[: found.shape[1]], atol=1e-8 * np.abs(found).max())
