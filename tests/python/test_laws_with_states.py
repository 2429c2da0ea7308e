"""Laws with states of their own: closed forms, built-in items, stored models, and mistakes."""

from __future__ import annotations

import pickle
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

import dalembert as exu
from dalembert._core import testing
from dalembert.laws import connector, maximum, minimum, norm

K, D, MASS = 100.0, 5.0, 2.0
YIELD = 3.0


@connector("coordinates", states={"s": 0.0})
def Maxwell(q, q_t, t, s, k=K, d=D):
    """A spring in series with a damper, whose elongation is s."""
    force = k * (q - s)
    return force, force / d


@connector("coordinates", history={"p": 0.0})
def Slider(q, q_t, t, p, k=K, limit=YIELD):
    """A spring in series with a Coulomb slider at p."""
    force = minimum(maximum(k * (q - p), -limit), limit)
    return force, q - force / k


@connector("points", states={"s": 0.5, "r": 0.0}, history={"h": 0.25})
def Mixed(u, v, t, s, r, h, k=3.0):
    f = k * (1 + s * s) * u + r * h * v
    return f, u @ u - s * r, np.sin(r) + v[0], h + s


def one_coordinate(
    law: Any, start: float = 0.0, velocity: float = 0.0, **constants: float
) -> tuple[Any, Any, list[Any]]:
    """A mass on a line, and a law between the origin and it."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddNode(exu.NodePointGround())
    node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0.0], initialCoordinates=[start], initialVelocities=[velocity]))
    mbs.AddObject(exu.ObjectMass1D(nodeNumber=node, physicsMass=MASS))
    markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, node)]
    nodes = law.AddNodes(mbs)
    item = mbs.AddObject(law(markers, nodeNumbers=nodes, **constants))
    mbs.AddSensor(
        exu.SensorNode(
            nodeNumber=node, outputVariableType=exu.OutputVariableType.Coordinates, storeInternal=True, name="q"
        )
    )
    mbs.AddSensor(
        exu.SensorObject(
            objectNumber=item, outputVariableType=exu.OutputVariableType.Force, storeInternal=True, name="f"
        )
    )
    mbs.Assemble()
    return mbs, item, nodes


def settings(steps: int, end: float) -> Any:
    s = exu.SimulationSettings()
    s.timeIntegration.numberOfSteps, s.timeIntegration.endTime = steps, end
    s.solutionSettings.writeSolutionToFile = False
    s.solutionSettings.sensorsWritePeriod = end / steps
    s.solutionSettings.sensorsWriteFileHeader = False
    return s


def maxwell_end(end: float, start: float, k: float = K, d: float = D) -> np.ndarray:
    """m q_tt + k (q - s) = 0, s_t = k/d (q - s): the exponential of the matrix of (q, q_t, s)."""
    a = np.array([[0, 1, 0], [-k / MASS, 0, k / MASS], [k / d, 0, -k / d]])
    return np.asarray(expm(a * end) @ [start, 0, 0])


# ---- states with rates -------------------------------------------------------------------------------------------------
def test_a_mass_on_a_maxwell_element() -> None:
    """Explicit of order 6 (adaptive) to 1e-9; implicit of order 2: the error decreases by four with half the step."""
    wanted = maxwell_end(0.7, 0.3)
    mbs, item, (node,) = one_coordinate(Maxwell, 0.3)
    s = settings(10, 0.7)
    s.timeIntegration.relativeTolerance = s.timeIntegration.absoluteTolerance = 1e-11
    mbs.SolveDynamic(s, solverType=exu.DynamicSolverType.DOPRI5)
    found = [*mbs.systemData.GetODE2Coordinates(), *mbs.systemData.GetODE1Coordinates()]
    np.testing.assert_allclose(found, wanted[[0, 2]], rtol=0, atol=1e-9)
    assert mbs.GetObjectOutput(item, exu.OutputVariableType.Force) == pytest.approx(
        K * (found[0] - found[1]), rel=1e-14
    )
    assert mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates) == pytest.approx(wanted[2], abs=1e-9)
    errors = []
    for steps in (200, 400):
        mbs.SolveDynamic(settings(steps, 0.7))
        errors.append(abs(mbs.systemData.GetODE2Coordinates()[0] - wanted[0]))
    assert errors[0] / errors[1] == pytest.approx(4, rel=0.1)
    assert errors[1] < 1e-5


def test_relaxation_of_a_held_maxwell_element() -> None:
    """The force of an element that is held at an elongation of 1 is k exp(-k t / d); order 2."""
    mbs, item, _ = one_coordinate(Maxwell, 1.0)
    mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[0, 1], offset=1.0))
    mbs.Assemble()
    mbs.SolveDynamic(settings(1000, 0.1))
    force = float(mbs.GetObjectOutput(item, exu.OutputVariableType.Force))
    assert force == pytest.approx(K * np.exp(-K * 0.1 / D), rel=1e-5)


# ---- a history ---------------------------------------------------------------------------------------------------------
def test_the_work_of_a_hysteresis_loop() -> None:
    """A full cycle of amplitude a dissipates 4 F_y (a - F_y / k): the area of the parallelogram of force over position."""
    amplitude, steps = 0.1, 4000
    mbs, item, (node,) = one_coordinate(Slider)
    turning = lambda mbs, t, i, offset: amplitude * np.sin(2 * np.pi * t)  # noqa: E731
    mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[0, 1], offsetUserFunction=turning))
    mbs.Assemble()
    mbs.SolveDynamic(settings(2 * steps, 2.0))
    q, f = (mbs.GetSensorStoredData(name)[-steps - 1 :, 1] for name in ("q", "f"))
    work = np.sum(0.5 * (f[1:] + f[:-1]) * np.diff(q))
    assert work == pytest.approx(4 * YIELD * (amplitude - YIELD / K), rel=1e-5)  # corners within steps of 1/4000
    assert np.abs(f).max() == YIELD
    # at the end q is zero, on the way up from -a: it yields from -a + 2 F_y / k = -0.04 on
    assert mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates) == pytest.approx(-YIELD / K, abs=1e-12)


def test_sliding_friction_stops_a_mass() -> None:
    """The kinetic energy is dissipated by the slider, up to what the spring keeps: F_y p = m v^2 / 2 - F_y^2 / (2 k)."""
    mbs, _, (node,) = one_coordinate(Slider, velocity=2.0)
    s = settings(20000, 2.0)
    mbs.SolveDynamic(s)
    plastic = float(mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates))
    assert plastic == pytest.approx((0.5 * MASS * 2.0**2 - 0.5 * YIELD**2 / K) / YIELD, abs=1e-4)


def test_rejected_steps_do_not_change_the_history() -> None:
    """Adaptive steps end with the same plastic position."""
    ends = []
    for adaptive in (False, True):
        mbs, _, (node,) = one_coordinate(Slider, velocity=2.0)
        mbs.AddObject(
            exu.CoordinateSpringDamper(
                markerNumbers=[0, 1],
                springForceUserFunction=lambda mbs, t, i, u, v, k, d, o: 1e5 * max(u - 0.3, 0.0) ** 3,
            )
        )
        mbs.Assemble()
        s = settings(100 if adaptive else 20000, 2.0)
        solver = exu.DynamicSolverType.TrapezoidalIndex2
        if adaptive:
            s.timeIntegration.automaticStepSize = True
            solver = exu.DynamicSolverType.DOPRI5
            s.timeIntegration.relativeTolerance = s.timeIntegration.absoluteTolerance = 1e-8
            s.timeIntegration.stepInformation = 0
        mbs.SolveDynamic(s, solverType=solver)
        ends.append(float(mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates)))
    assert ends[1] == pytest.approx(ends[0], abs=5e-3)


# ---- residual and tangent ----------------------------------------------------------------------------------------------
def mixed() -> tuple[Any, list[Any]]:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[0.3, -0.5, 0.2], initialVelocities=[0.5, 0.1, -0.3]))
    mbs.AddObject(exu.MassPoint(physicsMass=MASS, nodeNumber=node))
    nodes = Mixed.AddNodes(mbs, r=-0.4)
    mbs.AddObject(Mixed([ground, mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))], nodeNumbers=nodes))
    mbs.Assemble()
    return mbs, nodes


def test_tangent_of_forces_and_rates() -> None:
    """The derivatives of f = k (1 + s^2) u + r h v, s_t = u.u - s r and r_t = sin r + v_x, to round-off."""
    mbs, _ = mixed()
    u, v, s, r, h, k = np.array([0.3, -0.5, 0.2]), np.array([0.5, 0.1, -0.3]), 0.5, -0.4, 0.25, 3.0
    state = testing.State(mbs)
    residual = testing.residual(mbs, state)
    force, rates = k * (1 + s * s) * u + r * h * v, np.array([u @ u - s * r, np.sin(r) + v[0]])
    np.testing.assert_allclose(np.abs(residual[:3]), np.abs(force), rtol=1e-14)
    np.testing.assert_allclose(np.abs(residual[3:]), np.abs(rates), rtol=1e-14)
    sign, sign_of_rates = np.sign(residual[0] / force[0]), np.sign(residual[3] / rates[0])
    tangent = testing.tangent(mbs, state, cq=0.7, cv=1.3)
    np.testing.assert_allclose(
        tangent[:3, :3], sign * (0.7 * k * (1 + s * s) + 1.3 * r * h) * np.eye(3), rtol=1e-14, atol=1e-14
    )
    np.testing.assert_allclose(tangent[3, :3], sign_of_rates * 0.7 * 2 * u, rtol=1e-14)
    np.testing.assert_allclose(tangent[4, :3], sign_of_rates * 1.3 * np.array([1, 0, 0]), rtol=1e-14)
    # the weight of first-order coordinates appears in all of their columns
    weight = tangent[0, 3] / (sign * k * 2 * s * u[0])
    np.testing.assert_allclose(tangent[:3, 3], sign * weight * k * 2 * s * u, rtol=1e-14)
    np.testing.assert_allclose(tangent[:3, 4], sign * weight * h * v, rtol=1e-14)
    assert weight > 0


K6, D6 = (root @ root.T + np.eye(6) for root in np.random.default_rng(4).normal(size=(2, 6, 6)))


@connector("points", history={"h": 1.0})
def Points(u, v, t, h, k=120.0, d=3.0):
    return h * (k * u + d * v), h


@connector("line", history={"h": 1.0})
def Line(L, L_t, t, h, k=120.0, d=3.0, L_0=0.4):
    return h * (k * (L - L_0) + d * L_t), h


@connector("frames", history={"h": 1.0})
def Frames(u, phi, v, omega, t, h):
    f = K6 @ np.array([*u, *phi]) + D6 @ np.array([*v, *omega])
    return (f[:3], h * f[3:]), h


@connector("rotation", history={"h": 1.0})
def Rotation(phi, omega, t, h, k=120.0, d=3.0):
    return h * (k * phi + d * omega), h


AXES = {"rotationMarker0": exu.utilities.RotationMatrixX(0.3), "rotationMarker1": exu.utilities.RotationMatrixY(0.2)}
PAIRS = {
    "points": (Points, exu.CartesianSpringDamper, {"stiffness": [120.0] * 3, "damping": [3.0] * 3}, {}),
    "line": (Line, exu.SpringDamper, {"stiffness": 120.0, "damping": 3.0, "referenceLength": 0.4}, {}),
    "frames": (Frames, exu.RigidBodySpringDamper, {"stiffness": K6, "damping": D6}, AXES),
    "rotation": (Rotation, exu.TorsionalSpringDamper, {"stiffness": 120.0, "damping": 3.0}, AXES),
}


def two_bodies(make: Callable[[Any, list[Any]], Any]) -> Any:
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
        markers.append(mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=[0.1, 0.2, 0.3])))
    mbs.AddObject(make(mbs, markers))
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("kind", PAIRS)
def test_laws_of_each_kind_are_the_built_in_items(kind: str) -> None:
    law, item, parameters, common = PAIRS[kind]
    own = two_bodies(lambda mbs, markers: law(markers, nodeNumbers=law.AddNodes(mbs), **common))
    other = two_bodies(lambda mbs, markers: item(markerNumbers=markers, **parameters, **common))
    for f in (testing.residual, lambda mbs, s: testing.tangent(mbs, s, cq=0.7, cv=1.3)):
        found, wanted = (f(mbs, testing.State(mbs)) for mbs in (own, other))
        np.testing.assert_allclose(found, wanted, rtol=0, atol=2e-14 * np.abs(wanted).max())


# ---- parameters, threads, stored models --------------------------------------------------------------------------------
def test_constants_and_start_values_are_parameters() -> None:
    """A constant is set in all functions of the law; variations in threads have the closed form."""
    mbs, item, (node,) = one_coordinate(Maxwell, 0.3)
    mbs.SetObjectParameter(item, "forceUserFunction.k", 150.0)
    assert mbs.GetObjectParameter(item, "stateRateUserFunction.k") == 150.0
    mbs.SetObjectParameter(item, "forceUserFunction.k", K)
    with pytest.raises(ValueError, match=r"there is no constant 'd'"):
        mbs.GetObjectParameter(item, "forceUserFunction.d")
    stiffness, damping = [80.0, 100.0, 120.0, 150.0], [4.0, 5.0, 6.0, 9.0]
    varied = {(item, "forceUserFunction.k"): stiffness, (item, "stateRateUserFunction.d"): damping}
    found = mbs.SolveVariations(varied, settings(2000, 0.7), numberOfThreads=2)
    wanted = [maxwell_end(0.7, 0.3, k, d)[0] for k, d in zip(stiffness, damping, strict=True)]
    np.testing.assert_allclose(np.ravel(found.SensorValues("q")), wanted, rtol=0, atol=1e-6)
    starts = [0.0, 0.1]
    found = mbs.SolveVariations({(node, "initialCoordinates"): [[x] for x in starts]}, settings(2000, 0.7))
    a = np.array([[0, 1, 0], [-K / MASS, 0, K / MASS], [K / D, 0, -K / D]])
    wanted = [(expm(a * 0.7) @ [0.3, 0, x])[0] for x in starts]
    np.testing.assert_allclose(np.ravel(found.SensorValues("q")), wanted, rtol=0, atol=1e-6)


def test_sensitivities() -> None:
    """dq/dk against the difference of the closed form."""
    mbs, item, _ = one_coordinate(Maxwell, 0.3)
    found = mbs.ComputeSensitivities(
        {"k": (item, "forceUserFunction.k"), "d": (item, "stateRateUserFunction.d")},
        {"end": exu.At("q", component=0)},
        settings(2000, 0.7),
    )
    h = 1e-3
    wanted = (maxwell_end(0.7, 0.3, k=K + h) - maxwell_end(0.7, 0.3, k=K - h))[0] / (2 * h)
    assert found.Derivative("end", "k") == pytest.approx(wanted, rel=1e-4)
    wanted = (maxwell_end(0.7, 0.3, d=D + h) - maxwell_end(0.7, 0.3, d=D - h))[0] / (2 * h)
    assert found.Derivative("end", "d") == pytest.approx(wanted, rel=1e-4)


@pytest.mark.parametrize("law", [Maxwell, Slider])
def test_files_and_pickles_keep_laws_with_states(law: Any, tmp_path: Path) -> None:
    mbs, _, nodes = one_coordinate(law, 0.0, velocity=1.0)
    mbs.Save(tmp_path / "model.json")
    loaded = exu.SystemContainer().AddSystem()
    loaded.Load(tmp_path / "model.json")
    for other in (loaded, pickle.loads(pickle.dumps(mbs))):
        ends = []
        for system in (mbs, other):
            system.Assemble()
            system.SolveDynamic(settings(300, 0.3))
            data = system.systemData
            ends.append([*data.GetODE2Coordinates(), *data.GetODE1Coordinates(), *data.GetDataCoordinates()])
        np.testing.assert_array_equal(ends[0], ends[1])
        assert ends[0][-1] != 0


@pytest.mark.parametrize("law", [Maxwell, Slider])
def test_restart_continues_bit_for_bit(law: Any, tmp_path: Path) -> None:
    """Steps of 1/256 are binary fractions, so that no rounding separates the halves from the whole."""
    whole, half, rest = (one_coordinate(law, 0.0, velocity=1.0)[0] for _ in range(3))
    whole.SolveDynamic(settings(128, 0.5))
    s = settings(64, 0.25)
    s.solutionSettings.writeRestartFile = True
    s.solutionSettings.restartFileName = str(tmp_path / "restart.txt")
    s.solutionSettings.restartWritePeriod = 0.25
    half.SolveDynamic(s)
    solver = exu.MainSolverImplicitSecondOrder()
    solver.ContinueFromRestartFile(rest, str(tmp_path / "restart.txt"))
    s = settings(64, 0.5)
    s.timeIntegration.startTime = rest.systemData.GetTime(exu.ConfigurationType.Initial)
    assert s.timeIntegration.startTime == 0.25 and solver.SolveSystem(rest, s)
    for name in ("GetODE2Coordinates", "GetODE1Coordinates", "GetDataCoordinates"):
        found, wanted = (getattr(mbs.systemData, name)() for mbs in (rest, whole))
        np.testing.assert_array_equal(found, wanted)


# ---- mistakes ----------------------------------------------------------------------------------------------------------
def lawful(returned: Callable[[Any, Any], Any], **states: Any) -> Callable[[], Any]:
    def law(q, q_t, t, s):
        return returned(q, s)

    return lambda: connector("coordinates", **states)(law)


WRONG: list[tuple[Callable[[], Any], type[Exception], str]] = [
    (lawful(lambda q, s: q - s, states={"s": 0}), TypeError, "returned one value, but expected a tuple of the result, the rate of s"),
    (lawful(lambda q, s: (q - s,), states={"s": 0}), TypeError, "returned 1 values, but expected a tuple of the result, the rate of s"),
    (lawful(lambda q, s: (q - s, s, s), history={"s": 0}), TypeError, "returned 3 values, .* the result, s after the step"),
    (lawful(lambda q, s: (q - s, [s, s]), states={"s": 0}), TypeError, "returned 2 numbers, but expected 1 number"),
    (lawful(lambda q, s: ([q, q, q], s), states={"s": 0}), TypeError, "returned 3 numbers, but expected 1 number"),
    (lawful(lambda q, s: (q, s), states={"s": 0, "r": 0}), TypeError, r"is called with \(q, q_t, t, s, r\), but has \(q, q_t, t, s\)"),
    (lambda: connector("points", states=["s"]), TypeError, r"states: received \['s'\], but expected names and start values, as in"),
    (lambda: connector("points", history={}), TypeError, "history: received {}, but expected names and start values"),
    (lambda: connector("points", states={"s": "a"}), TypeError, "states: s: received 'a', but constants of laws are finite numbers"),
    (lambda: connector("points", states={"s": 0}, history={"s": 1}), ValueError, "'s' is the name of two arguments"),
    (lambda: connector("points", states={"u": 0}), ValueError, "'u' is the name of two arguments"),
    (lambda: connector("springs", states={"u": 0}), ValueError, "received 'springs', but expected one of 'points', 'line'"),
    (lambda: Maxwell([0, 1]), TypeError, r"it has states; add nodeNumbers=Maxwell.AddNodes\(mbs\)"),
    (lambda: Maxwell([0, 1], nodeNumbers=[0], numberOfCoordinates=3), TypeError, "'numberOfCoordinates' of ObjectConnectorLaw has no effect"),
    (lambda: Maxwell.AddNodes(None, r=1.0), TypeError, "there is no state 'r'. States are s."),
    (lambda: connector("points")(lambda u, v, t: u).AddNodes(None), TypeError, "the law has no states"),
]  # fmt: skip


@pytest.mark.parametrize(("wrong", "error", "text"), WRONG)
def test_mistakes(wrong: Callable[[], Any], error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text):
        wrong()


@pytest.mark.parametrize(
    ("nodes", "text"),
    [
        (lambda mbs: [], "received 0 nodes, but expected a NodeGenericODE1"),
        (lambda mbs: Maxwell.AddNodes(mbs) + Maxwell.AddNodes(mbs), "received 2 nodes, but expected a NodeGenericODE1"),
        (
            lambda mbs: Mixed.AddNodes(mbs),
            "object 1, recorded user function '.*': argument 'states' was recorded with 1 numbers, but has 3",
        ),
    ],
)
def test_wrong_nodes(nodes: Callable[[Any], Any], text: str) -> None:
    mbs, item, _ = one_coordinate(Maxwell)
    mbs.SetObjectParameter(item, "nodeNumbers", nodes(mbs))
    with pytest.raises(ValueError, match=text):
        mbs.Assemble()
        mbs.SolveDynamic(settings(1, 0.1))


@pytest.mark.parametrize("law", [Maxwell, Slider])
def test_two_items_with_one_node(law: Any) -> None:
    mbs, _, nodes = one_coordinate(law)
    mbs.AddObject(law([0, 1], nodeNumbers=nodes))
    with pytest.warns(UserWarning, match=r"object 2 .*: it shares node 2 .* with object 1 .*; add a node for each"):
        mbs.Assemble()


def test_wrong_markers() -> None:
    mbs, item, _ = one_coordinate(Maxwell)
    ground = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    mbs.SetObjectParameter(item, "markerNumbers", [ground, 1])
    with pytest.raises(ValueError, match=r"MarkerBodyPosition\), but expected a marker of a single coordinate"):
        mbs.Assemble()


def test_laws_with_states_take_numbers() -> None:
    assert Slider.function(0.1, 0.0, 0.0, 0.0) == (YIELD, pytest.approx(0.1 - YIELD / K))
    assert Maxwell.states == {"s": 0.0} and Slider.history == {"p": 0.0}
    assert norm(np.array([3.0, 4.0])) == 5


def test_nodes_of_another_law_are_refused() -> None:
    """States need a first-order node, a history a data node: numbers of the other kind would be taken for them."""
    rates = connector("coordinates", states={"s": 0.0})(lambda q, q_t, t, s: (100 * (q - s), q - s))
    history = connector("coordinates", history={"h": 0.0})(lambda q, q_t, t, h: (100 * (q - h), h))
    for law, other, text in ((rates, history, "no NodeGenericODE1"), (history, rates, "no NodeGenericData")):
        mbs = exu.SystemContainer().AddSystem()
        node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0]))
        mbs.AddObject(exu.Mass1D(physicsMass=1, nodeNumber=node))
        ends = (mbs.AddNode(exu.NodePointGround()), node)
        markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=end, coordinate=0)) for end in ends]
        mbs.AddObject(law(markers, nodeNumbers=other.AddNodes(mbs)))
        with pytest.raises(ValueError, match=f"'nodeNumbers': received {text}"):
            mbs.Assemble()
