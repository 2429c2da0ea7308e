"""Laws in Python against analytic derivatives, built-in items and closed forms; they are kept by files and pickles."""

from __future__ import annotations

import inspect
import math
import pickle
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.interpolate import CubicSpline

import dalembert as exu
from dalembert._core import testing
from dalembert.laws import atan2, connector, constraint, interpolate, load, maximum, minimum, norm, sign, where
from dalembert.utilities import CreateSymbolicUserFunction

Array = np.ndarray
STIFFNESS, RADIUS = 300.0, 1.0


@connector("points")
def Hertz(u, v, t, radius=RADIUS, stiffness=STIFFNESS):
    """Contact of a sphere with a point."""
    length = norm(u)
    depth = maximum(radius - length, 0.0)
    return -stiffness * depth**1.5 * u / length


def two_points(make: Callable[[list[Any]], Any], at: Any = (0.3, -0.5, 0.2), mass: float = 2.0) -> tuple[Any, Any]:
    """A mass point at some place, and an item between the origin and it."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    node = mbs.AddNode(exu.NodePoint(referenceCoordinates=list(at), initialVelocities=[0.5, 0.1, -0.3]))
    mbs.AddObject(exu.MassPoint(physicsMass=mass, nodeNumber=node))
    tip = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node, name="tip"))
    item = mbs.AddObject(make([ground, tip]))
    mbs.AddSensor(exu.SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position, name="x"))
    mbs.Assemble()
    return mbs, item


def settings(steps: int = 50, end: float = 0.5) -> Any:
    s = exu.SimulationSettings()
    s.timeIntegration.numberOfSteps, s.timeIntegration.endTime = steps, end
    s.solutionSettings.writeSolutionToFile = False
    s.solutionSettings.sensorsWriteFileHeader = False
    return s


# ---- derivatives -------------------------------------------------------------------------------------------------------
def test_the_tangent_of_hertz_is_exact() -> None:
    """df/du of f = -k d^(3/2) u / L with d = R - L: k (3/2 d^(1/2) n n^T - d^(3/2) / L (I - n n^T))."""
    for at in ([0.3, -0.5, 0.2], [0.01, 0.02, -0.9], [0.6, 0.6, 0.1]):
        mbs, item = two_points(Hertz, at)
        tangent = testing.tangent(mbs, testing.State(mbs), cq=1.0)
        length = np.linalg.norm(at)
        n, depth = np.array(at) / length, RADIUS - length
        force = mbs.GetObjectOutput(item, exu.OutputVariableType.Force)
        np.testing.assert_allclose(force, -STIFFNESS * depth**1.5 * n, rtol=1e-14)
        along, across = 1.5 * depth**0.5 * np.outer(n, n), depth**1.5 / length * (np.eye(3) - np.outer(n, n))
        exact = STIFFNESS * (along - across)
        assert np.abs(tangent - exact).max() < 1e-14 * np.abs(exact).max()


def test_the_tangent_without_contact_is_zero() -> None:
    """The root of zero has no derivative, but the depth rests."""
    mbs, _ = two_points(Hertz, [1.5, 0, 0])
    np.testing.assert_array_equal(testing.tangent(mbs, testing.State(mbs), cq=1.0), np.zeros((3, 3)))


K3, D3 = np.diag([100.0, 200.0, 50.0]), np.diag([1.0, 2.0, 5.0])
RANDOM = np.random.default_rng(4)
K6, D6 = (root @ root.T + np.eye(6) for root in RANDOM.normal(size=(2, 6, 6)))


@connector("points")
def LinearPoints(u, v, t):
    return K3 @ u + D3 @ v


@connector("line")
def LinearLine(L, L_t, t, k=120.0, d=3.0, L_0=0.4):
    return k * (L - L_0) + d * L_t


@connector("coordinates")
def LinearCoordinates(q, q_t, t, k=120.0, d=3.0):
    return k * q + d * q_t


@connector("frames")
def LinearFrames(u, phi, v, omega, t):
    f = K6 @ np.array([*u, *phi]) + D6 @ np.array([*v, *omega])
    return f[:3], f[3:]


@connector("rotation")
def LinearRotation(phi, omega, t, k=120.0, d=3.0):
    return k * phi + d * omega


PAIRS = {
    "points": (LinearPoints, exu.CartesianSpringDamper, {"stiffness": np.diag(K3), "damping": np.diag(D3)}, {}),
    "line": (LinearLine, exu.SpringDamper, {"stiffness": 120.0, "damping": 3.0, "referenceLength": 0.4}, {}),
    "coordinates": (LinearCoordinates, exu.CoordinateSpringDamper, {"stiffness": 120.0, "damping": 3.0}, {}),
    "frames": (
        LinearFrames,
        exu.RigidBodySpringDamper,
        {"stiffness": K6, "damping": D6},
        {"rotationMarker0": exu.utilities.RotationMatrixX(0.3)},
    ),
    "rotation": (LinearRotation, exu.TorsionalSpringDamper, {"stiffness": 120.0, "damping": 3.0}, {}),
}


def two_bodies(kind: str, item: Any) -> Any:
    """Two bodies in general positions and motions."""
    mbs = exu.SystemContainer().AddSystem()
    rng = np.random.default_rng(7)
    markers = []
    for _ in range(2):
        body = mbs.CreateRigidBody(
            referencePosition=rng.normal(size=3), initialVelocity=rng.normal(size=3),
            referenceRotationMatrix=exu.utilities.RotXYZ2RotationMatrix(0.5 * rng.normal(size=3)),
            initialAngularVelocity=rng.normal(size=3),
            inertia=exu.utilities.InertiaCuboid(1000, [0.1, 0.2, 0.3]),
        )  # fmt: skip
        node = mbs.GetObject(body)["nodeNumber"]
        if kind == "coordinates":
            markers.append(mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=1)))
        else:
            markers.append(mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=[0.1, 0.2, 0.3])))
    mbs.AddObject(item(markers))
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("kind", PAIRS)
def test_linear_laws_are_the_built_in_items(kind: str) -> None:
    law, item, parameters, common = PAIRS[kind]
    own = two_bodies(kind, lambda markers: law(markers, **common))
    other = two_bodies(kind, lambda markers: item(markerNumbers=markers, **parameters, **common))
    for f in (testing.residual, lambda mbs, s: testing.tangent(mbs, s, cq=0.7, cv=1.3)):
        found, wanted = (f(mbs, testing.State(mbs)) for mbs in (own, other))
        np.testing.assert_allclose(found, wanted, rtol=0, atol=2e-14 * np.abs(wanted).max())


# ---- what Python means -------------------------------------------------------------------------------------------------
XS, YS = [-1.0, 0.0, 2.0], [1.0, 3.0, -1.0]
SPLINE = (np.array([-1.0, -0.5, 0.5, 1.0, 2.0]), np.array([1.0, 0.2, 0.3, -1.0, 0.0]))
OPERATIONS: dict[str, Callable[[Any], Any]] = {
    "modulo": lambda x: x % 0.7,
    "modulo of negatives": lambda x: x % -0.7,
    "quotient": lambda x: x // 0.7,
    "round": lambda x: round(x),
    "power": lambda x: abs(x) ** 1.7,
    "where": lambda x: where(x > 0.5, x * x, -x),
    "minimum": lambda x: minimum(x, 0.3),
    "maximum": lambda x: maximum(x, 0.3),
    "atan2": lambda x: atan2(x, 0.4),
    "sign": lambda x: sign(x),
    "interpolate": lambda x: interpolate(x, XS, YS),
    "spline": lambda x: interpolate(x, *SPLINE, smooth=True),
    "both conditions": lambda x: (x > -1) * (x < 1) * x,
    "numpy": lambda x: np.sin(x) + np.exp(x) * np.cos(x) - np.tanh(x) + np.sqrt(1 + x * x) + np.arctan(x),
    "floor": lambda x: math.floor(x) + np.floor(x) + np.rint(x) + math.ceil(x),
    "in place": lambda x: in_place(x),
    "arrays": lambda x: np.cross([x, 1, 2], [3, x, 4]) @ np.array([x, 2, -x]),
}


def in_place(x: Any) -> Any:
    y = x
    y += 1
    y *= 3
    return y - x


@pytest.mark.parametrize("name", OPERATIONS)
def test_operators_mean_what_they_mean_in_python(name: str) -> None:
    operation = OPERATIONS[name]

    def law(q, q_t, t):
        return operation(q) + 0 * q

    made = connector("coordinates")(law)
    for x in (-2.5, -1.3, -0.5, 0.0, 0.25, 0.5, 1.5, 2.5, 7.1):
        found = made.recorded["springForceUserFunction"](None, 0.0, 0, x, 0.0, 0.0, 0.0, 0.0)
        assert found == pytest.approx(float(operation(x)), rel=1e-15, abs=1e-15), x


def test_interpolation_has_the_slope_of_its_piece() -> None:
    law = connector("coordinates")(lambda q, q_t, t: interpolate(q, XS, YS))
    for x, slope in ((-2, 0), (-0.5, 2), (1, -2), (3, 0)):
        mbs = exu.SystemContainer().AddSystem()
        node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0.0], initialCoordinates=[x]))
        mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=1))
        ground = mbs.AddNode(exu.NodePointGround())
        markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, node)]
        mbs.AddObject(law(markers))
        mbs.Assemble()
        assert testing.tangent(mbs, testing.State(mbs), cq=1.0)[0, 0] == pytest.approx(slope, rel=1e-15)


def test_a_spline_is_that_of_scipy() -> None:
    """Values and slopes between the ends; constant beyond."""
    points, values = SPLINE
    law = connector("coordinates")(lambda q, q_t, t: interpolate(q, points, values, smooth=True))
    spline = CubicSpline(points, values)
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0.0]))
    mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=1))
    ground = mbs.AddNode(exu.NodePointGround())
    mbs.AddObject(law([mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, node)]))
    mbs.Assemble()
    state = testing.State(mbs)
    for x in (-3.0, -1.0, -0.4, 0.0, 0.7, 1.9, 2.0, 5.0):
        state.q = [x]
        inside = points[0] < x < points[-1]
        assert testing.forces(mbs, state)[0] == pytest.approx(-spline(np.clip(x, points[0], points[-1])), rel=1e-13)
        assert testing.tangent(mbs, state, cq=1.0)[0, 0] == pytest.approx(inside * spline(x, 1), rel=1e-13, abs=1e-13)


def test_a_constraint_follows_a_table() -> None:
    """The rate of the gap and its derivative are those of the spline: v = y'(t), also on velocity level."""
    times, heights = np.linspace(0, 1, 21), np.sin(2 * np.linspace(0, 1, 21))
    follow = constraint(0, 1)(lambda q0, q1, t: q1[0] - interpolate(t, times, heights, smooth=True))
    mbs = exu.SystemContainer().AddSystem()
    slope = CubicSpline(times, heights)(0, 1)
    node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0.0], initialVelocities=[slope]))
    mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=1))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinates(nodeNumber=mbs.AddNode(exu.NodePointGround())))
    mbs.AddObject(follow([ground, mbs.AddMarker(exu.MarkerNodeCoordinates(nodeNumber=node))]))
    mbs.Assemble()
    state = testing.State(mbs)
    state.q, state.v, state.t = [0.0], [0.5], 0.33
    state.rate_level = True
    assert testing.residual(mbs, state)[-1] == pytest.approx(0.5 - CubicSpline(times, heights)(0.33, 1), abs=1e-13)
    mbs.SolveDynamic(settings(200, 0.8))
    assert mbs.systemData.GetODE2Coordinates()[0] == pytest.approx(CubicSpline(times, heights)(0.8), abs=1e-12)


def test_long_tables_are_stored() -> None:
    xs = np.linspace(0, 1, 5000)
    law = load("coordinate")(lambda t: interpolate(t, xs, np.sin(xs)))
    function = law.recorded["loadUserFunction"]
    copied = pickle.loads(pickle.dumps(function))
    assert copied(None, 0.123, 0.0) == function(None, 0.123, 0.0) == pytest.approx(np.sin(0.123), abs=1e-8)


# ---- constants ---------------------------------------------------------------------------------------------------------
def test_constants_are_parameters() -> None:
    name = "springForceUserFunction.stiffness"
    mbs, item = two_points(lambda markers: Hertz(markers, stiffness=500))
    assert mbs.GetObjectParameter(item, name) == 500
    mbs.SetObjectParameter(item, name, 250.0)
    assert mbs.GetObjectParameter(item, name) == 250
    force = np.linalg.norm(mbs.GetObjectOutput(item, exu.OutputVariableType.Force))
    assert force == pytest.approx(250 * (RADIUS - np.linalg.norm([0.3, -0.5, 0.2])) ** 1.5, rel=1e-14)
    assert mbs.GetObjectParameter(item, "springForceUserFunction.radius") == RADIUS
    assert Hertz.constants == {"radius": RADIUS, "stiffness": STIFFNESS}


def test_variations_of_constants() -> None:
    """Two constants of one function vary together, in threads."""
    stiffness, radius = [200.0, 300.0, 400.0, 500.0], [1.0, 0.9, 0.95, 1.1]
    wanted = []
    for k, r in zip(stiffness, radius, strict=True):
        mbs, _ = two_points(lambda markers, k=k, r=r: Hertz(markers, stiffness=k, radius=r))
        mbs.SolveDynamic(settings())
        wanted.append(mbs.GetSensorValues("x"))
    mbs, item = two_points(Hertz)
    name = "springForceUserFunction"
    varied = {(item, f"{name}.stiffness"): stiffness, (item, f"{name}.radius"): radius}
    found = mbs.SolveVariations(varied, settings(), numberOfThreads=2)
    np.testing.assert_allclose(found.SensorValues("x"), wanted, rtol=1e-12)
    assert mbs.GetObjectParameter(item, f"{name}.stiffness") == STIFFNESS


def test_sensitivities_of_constants() -> None:
    """Exact derivatives against the fourth-order difference of whole solutions."""
    mbs, item = two_points(Hertz)
    where_ = (item, "springForceUserFunction.stiffness")
    found = mbs.ComputeSensitivities({"k": where_}, {"end": exu.At("x", component=0)}, settings())

    def end(k: float) -> float:
        mbs.SetObjectParameter(*where_, k)
        mbs.SolveDynamic(settings())
        return float(mbs.GetSensorValues("x")[0])

    h = 1.0
    wanted = (8 * (end(STIFFNESS + h) - end(STIFFNESS - h)) - end(STIFFNESS + 2 * h) + end(STIFFNESS - 2 * h)) / (
        12 * h
    )
    assert found.Derivative("end", "k") == pytest.approx(wanted, rel=1e-5)


# ---- loads and constraints ---------------------------------------------------------------------------------------------
def test_loads() -> None:
    mbs, _ = two_points(Hertz)
    marker = mbs.GetMarkerNumber("tip")

    @load("force")
    def turning(t, amplitude=3.0):
        return amplitude * np.cos(2 * t), amplitude * np.sin(2 * t), 0

    @load("coordinate")
    def ramp(t, rate=2.0):
        return minimum(rate * t, 1.0)

    number = mbs.AddLoad(turning(marker, amplitude=4.0))
    node = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=0, coordinate=1))
    other = mbs.AddLoad(ramp(node))
    mbs.Assemble()
    for t in (0.0, 0.3, 1.1):
        mbs.systemData.SetTime(t)
        np.testing.assert_allclose(mbs.GetLoadValues(number), [4 * np.cos(2 * t), 4 * np.sin(2 * t), 0], atol=1e-15)
        assert mbs.GetLoadValues(other) == pytest.approx(min(2 * t, 1.0), rel=1e-15)
    mbs.SetLoadParameter(number, "loadVectorUserFunction.amplitude", 1.0)
    assert mbs.GetLoadValues(number)[1] == pytest.approx(np.sin(2.2), rel=1e-14)


@constraint(0, 2)
def Rod(q0, q1, t, length=1.0, growth=0.0):
    """A point at a distance of the origin that grows."""
    return q1 @ q1 - (length + growth * t) ** 2


def pendulum(**constants: float) -> Any:
    return pendulum_of(Rod, **constants)


def pendulum_of(law: Any, **constants: float) -> Any:
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0.6, -0.8], initialVelocities=[0.8, 0.6]))
    mbs.AddObject(exu.MassPoint2D(physicsMass=2, nodeNumber=node))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinates(nodeNumber=mbs.AddNode(exu.NodePointGround())))
    item = law([ground, mbs.AddMarker(exu.MarkerNodeCoordinates(nodeNumber=node))], **constants)
    mbs.AddObject(item)
    mbs.AddSensor(exu.SensorNode(nodeNumber=node, outputVariableType=exu.OutputVariableType.Position, name="x"))
    mbs.Assemble()
    return mbs


def test_equations_of_constraints_and_their_derivatives() -> None:
    """g = q.q - (L + c t)^2, g_q = 2 q, the reaction is 2 q lambda with the derivative 2 lambda; g_t = 2 q.v - 2 c (L + c t)."""
    mbs = pendulum(growth=0.25)
    s = testing.State(mbs)
    s.q, s.v, s.lam, s.t = np.array([0.1, 0.3]), np.array([0.7, -0.4]), np.array([5.0]), 0.5
    q, length = np.array([0.6, -0.8]) + s.q, 1 + 0.25 * 0.5
    np.testing.assert_allclose(testing.residual(mbs, s)[-1], q @ q - length**2, rtol=1e-14)
    tangent = testing.tangent(mbs, s, cq=1.0)
    np.testing.assert_allclose(tangent[:2, :2], 2 * 5.0 * np.eye(2), rtol=1e-14, atol=1e-14)
    np.testing.assert_allclose(tangent[2, :2], 2 * q, rtol=1e-14)
    np.testing.assert_allclose(tangent[:2, 2], 2 * q, rtol=1e-14)
    s.rate_level = True
    np.testing.assert_allclose(testing.residual(mbs, s)[-1], 2 * q @ s.v - 2 * 0.25 * length, rtol=1e-14)


@constraint(0, 2)
def Ellipse(q0, q1, t, a=2.0, b=1.0):
    return (q1[0] / a) ** 2 + (q1[1] / b) ** 2 - 1


def test_constants_of_constraints_change_equations_and_derivatives() -> None:
    """Both recorded functions have the constant: g_q = 2 [x / a^2, y / b^2]."""
    mbs = pendulum_of(Ellipse)
    mbs.SetObjectParameter(1, "constraintUserFunction.a", 4.0)
    tangent = testing.tangent(mbs, testing.State(mbs), cq=1.0)
    np.testing.assert_allclose(tangent[2, :2], [2 * 0.6 / 16, -2 * 0.8], rtol=1e-14)
    assert mbs.GetObjectParameter(1, "jacobianUserFunction.a") == 4.0
    found = mbs.SolveVariations({(exu.ObjectIndex(1), "constraintUserFunction.b"): [1.0, 0.8]}, settings())
    for k, b in enumerate((1.0, 0.8)):
        mbs.SetObjectParameter(1, "constraintUserFunction.b", b)
        mbs.SolveDynamic(settings())
        np.testing.assert_allclose(found.SensorValues("x")[k], mbs.GetSensorValues("x"), rtol=0, atol=1e-12)


def test_a_pendulum_of_a_law_keeps_length_and_energy() -> None:
    mbs = pendulum()
    mbs.AddLoad(
        exu.LoadMassProportional(markerNumber=mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=0)), loadVector=[0, -10, 0])
    )
    mbs.Assemble()
    mbs.SolveDynamic(settings(2000, 2.0))
    x, v = (mbs.GetNodeOutput(0, getattr(exu.OutputVariableType, name)) for name in ("Position", "Velocity"))
    assert np.linalg.norm(x) == pytest.approx(1, rel=1e-10)
    energy = 0.5 * 2 * v @ v + 2 * 10 * x[1]
    assert energy == pytest.approx(0.5 * 2 * 1 - 2 * 10 * 0.8, rel=1e-5)  # second order: steps of 1 ms


# ---- stored ------------------------------------------------------------------------------------------------------------
def end_of(mbs: Any) -> Array:
    mbs.Assemble()
    mbs.SolveDynamic(settings())
    return np.asarray(mbs.systemData.GetODE2Coordinates())


@pytest.mark.parametrize("make", [lambda: two_points(lambda m: Hertz(m, stiffness=412.5))[0], pendulum])
def test_files_and_pickles_keep_laws(make: Callable[[], Any], tmp_path: Path) -> None:
    """Bit by bit, in another process without the law, and without permission to run code."""
    mbs = make()
    mbs.Save(tmp_path / "model.json")
    wanted = end_of(mbs)
    loaded = exu.SystemContainer().AddSystem()
    loaded.Load(tmp_path / "model.json")
    np.testing.assert_array_equal(end_of(loaded), wanted)
    copied = pickle.loads(pickle.dumps(mbs))
    np.testing.assert_array_equal(end_of(copied), wanted)
    code = (
        "import pickle, sys, numpy as np; mbs = pickle.load(open('model.pickle', 'rb')); mbs.Assemble(); "
        "import dalembert as exu; s = exu.SimulationSettings(); s.timeIntegration.numberOfSteps = 50; "
        "s.timeIntegration.endTime = 0.5; s.solutionSettings.writeSolutionToFile = False; mbs.SolveDynamic(s); "
        "np.save('end.npy', mbs.systemData.GetODE2Coordinates())"
    )
    (tmp_path / "model.pickle").write_bytes(pickle.dumps(make()))
    subprocess.run([sys.executable, "-c", code], cwd=tmp_path, check=True)
    np.testing.assert_array_equal(np.load(tmp_path / "end.npy"), wanted)


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (lambda data: data.pop("nodes"), "'nodes' is missing"),
        (lambda data: data.update(result=999), "there is no earlier node 999"),
        (lambda data: data["nodes"].append(["dance", 0]), "there is no operation 'dance' of 1 operands"),
        (lambda data: data["nodes"].append(["sin", -1]), "there is no earlier node -1"),
        (lambda data: data["nodes"].append(["element", 2, 7]), "there is no component 7"),
        (lambda data: data["nodes"].append(["+", 0, 2]), "is not defined for a scalar and a vector"),
        (lambda data: data["nodes"].append("x"), "unexpected 'x'"),
        (
            lambda data: data["nodes"].extend(
                [{"name": "", "shape": [6, 0], "values": [1.0] * 6, "open": False}, ["table", 0, len(data["nodes"])]]
            ),
            "points of a table have to increase",
        ),
        (
            lambda data: data["nodes"].append({"name": "a", "shape": [2, 0], "values": [1.0], "open": True}),
            "number of values",
        ),
    ],
)
def test_stored_functions_are_checked(change: Callable[[Any], Any], text: str) -> None:
    data = Hertz.recorded["springForceUserFunction"]._Stored()
    change(data)
    with pytest.raises(ValueError, match=f"the stored function is not valid: .*{text}"):
        exu.symbolic.UserFunction._FromStored(data)


# ---- mistakes ----------------------------------------------------------------------------------------------------------
def branch(q, q_t, t):
    if q > 0:
        return q
    return 0.0


def built_in_maximum(q, q_t, t):
    return max(q, 0.0)


def mathematical(q, q_t, t):
    return math.sin(q)


def numpy_maximum(q, q_t, t):
    return np.maximum(q, 0.0)


def numpy_function(q, q_t, t):
    return np.cbrt(q)


def filled_array(q, q_t, t):
    f = np.zeros(3)
    f[0] = q
    return f[0]


def truth_of_time(q, q_t, t):
    return q if t else 0.0


def missing_name(q, q_t, t):
    return sinus(q)  # noqa: F821


@pytest.mark.parametrize(
    ("law", "line", "text"),
    [
        (branch, "if q > 0:", r"Use where\(condition, a, b\), minimum"),
        (built_in_maximum, "return max(q, 0.0)", r"maximum\(a, b\) or interpolate"),
        (mathematical, "return math.sin(q)", r"Use functions of numpy, such as np.sin\(x\)"),
        (numpy_maximum, "return np.maximum(q, 0.0)", r"Use where\(condition, a, b\)"),
        (numpy_function, "return np.cbrt(q)", r"cbrt.*Use operators, np.sin"),
        (filled_array, "f[0] = q", r"np.array\(\[a, b, c\]\)"),
        (truth_of_time, "return q if t else 0.0", r"Use where\(condition"),
        (missing_name, "return sinus(q)", "name 'sinus' is not defined"),
    ],
)
def test_what_cannot_be_recorded_is_told_with_its_line(law: Any, line: str, text: str) -> None:
    lines, first = inspect.getsourcelines(law)
    number = first + next(i for i, each in enumerate(lines) if line in each)
    with pytest.raises(TypeError, match=f"the law {law.__name__} cannot be recorded: .*{text}") as caught:
        connector("coordinates")(law)
    assert str(caught.value).startswith(f"test_laws.py, line {number} ('{line}")


def test_values_are_not_known_while_functions_are_recorded() -> None:
    """Not in user functions of items either: sin(0) would be recorded for all times."""
    mbs, _ = two_points(Hertz)
    spring = mbs.AddObject(exu.SpringDamper(markerNumbers=[0, 1]))
    for f in (math.sin, float, lambda x: x.Evaluate(), lambda x: x.value):

        def law(mbs, t, i, u, v, k, d, f0):
            return k * u + f(t)  # noqa: B023

        with pytest.raises(TypeError, match="'t' has no value while a function of 't' is recorded"):
            CreateSymbolicUserFunction(mbs, law, "springForceUserFunction", spring)


WRONG: list[tuple[Callable[[], Any], type[Exception], str]] = [
    (lambda: connector("springs"), ValueError, r"connector\(...\): received 'springs', but expected one of 'points', 'line'"),
    (lambda: connector(branch), ValueError, "received a function, but expected one of 'points'"),
    (lambda: load("wind"), ValueError, "expected one of 'force', 'torque', 'acceleration', 'coordinate'"),
    (lambda: connector("points")(3), TypeError, "expected a function, but received 3"),
    (lambda: connector("points")(lambda u, v: u), TypeError, r"is called with \(u, v, t\), but has \(u, v\)"),
    (lambda: connector("points")(lambda u, v, *t: u), TypeError, r"but has \(u, v, \*t\)"),
    (lambda: connector("points")(lambda u, v, t, k=[1]: k * u), TypeError, r"k: received \[1\], but constants of laws are finite"),
    (lambda: connector("points")(lambda u, v, t, offset=1.0: offset * u), TypeError, "'offset' is a parameter of ObjectConnectorCart"),
    (lambda: connector("points")(lambda u, v, t, k=1.0: u), TypeError, "does not read its constant 'k'"),
    (lambda: connector("points")(lambda u, v, t: u[0]), TypeError, "returned 1 numbers, but expected a force with 3 numbers"),
    (lambda: connector("frames")(lambda u, p, v, w, t: u), TypeError, "a force with 3 numbers and a torque with 3 numbers"),
    (lambda: connector("line")(lambda L, L_t, t: None), TypeError, "returned None instead of numbers"),
    (lambda: constraint(1, -1), TypeError, "received -1, but expected the number of coordinates of a marker"),
    (lambda: constraint(0, 0)(lambda q0, q1, t: t), TypeError, "there are no coordinates"),
    (lambda: Hertz([0, 1], radus=2.0), TypeError, "no constant or parameter 'radus'. Did you mean 'radius'?"),
    (lambda: Hertz([0, 1], damping=[1, 1, 1]), TypeError, "'damping' of ObjectConnectorCartesianSpringDamper has no effect"),
    (lambda: Hertz([0, 1], stiffness="soft"), TypeError, "stiffness: received 'soft', but constants of laws are finite numbers"),
    (lambda: connector("line")(lambda t, L, L_t: L), TypeError, "in this order, but 't' is in the place of 'L'"),
    (lambda: interpolate(0.5, [0, 0], [1, 2]), ValueError, "the first one increasing"),
]  # fmt: skip


@pytest.mark.parametrize(("wrong", "error", "text"), WRONG)
def test_mistakes(wrong: Callable[[], Any], error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        wrong()


def test_mistakes_in_names_of_constants() -> None:
    mbs, item = two_points(Hertz)
    name = "springForceUserFunction"
    with pytest.raises(ValueError, match=r"there is no constant 'stiffnes'. Did you mean 'stiffness'\?"):
        mbs.SetObjectParameter(item, f"{name}.stiffnes", 1.0)
    with pytest.raises(ValueError, match=rf"there is no parameter 'radius'. Did you mean '{name}.radius'\?"):
        mbs.SetObjectParameter(item, "radius", 1.0)
    with pytest.raises(
        ValueError, match=f"a constant of this name, and does not read the parameter. Use '{name}.stiffness'"
    ):
        mbs.SetObjectParameter(item, "stiffness", [1, 1, 1])
    with pytest.raises((TypeError, ValueError), match=f"'{name}.stiffness'|{name}.stiffness.*received 'soft'"):
        mbs.SetObjectParameter(item, f"{name}.stiffness", "soft")
    with pytest.raises(ValueError, match="stiffness is not a recorded function with constants"):
        mbs.GetObjectParameter(item, "stiffness.x")


def test_laws_take_numbers() -> None:
    u = np.array([0.3, -0.5, 0.2])
    mbs, item = two_points(Hertz)
    np.testing.assert_allclose(
        Hertz.function(u, 0 * u, 0.0), mbs.GetObjectOutput(item, exu.OutputVariableType.Force), rtol=1e-14
    )
    assert repr(Hertz) == "<law Hertz(radius, stiffness) of ObjectConnectorCartesianSpringDamper>"
    assert Hertz.__doc__ == "Contact of a sphere with a point."
