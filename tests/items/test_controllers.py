"""Controllers against closed forms, and sampled ones with dead time against simulations in discrete time in Python."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import numba
import numpy as np
import pytest
from scipy.integrate import solve_ivp

import dalembert as exu
from dalembert import compiled
from dalembert import itemInterface as items
from dalembert.control import CompiledController, ComputedTorque, Controller, PDController, SampledController
from dalembert.robotics.motion import (
    ProfileConstantAcceleration,
    ProfileLinearAccelerationsList,
    ProfilePTP,
    Trajectory,
)
from dalembert.testing.trees import Link, Tree, in_python, lists, make, random_links
from dalembert.treeDynamics import TreeDynamics

Solver = exu.DynamicSolverType
GRAVITY = [1.0, -2.0, -9.0]
MASS, STIFFNESS, DAMPING = 2.0, 300.0, 12.0


def settings_of(end: float, steps: int) -> Any:
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1
    settings.timeIntegration.newton.relativeTolerance = 1e-11
    settings.timeIntegration.newton.absoluteTolerance = 1e-11
    settings.solutionSettings.writeSolutionToFile = False
    return settings


def slider(controller: Any, reference: float = 0.0, start: float = 0.1, rate: float = 0.5) -> Tree:
    """A mass on a rail; `start` is the total coordinate."""
    mbs = exu.SystemContainer().AddSystem()
    link = Link("Px", mass=MASS, inertia=np.eye(3))
    coordinates = {"referenceCoordinates": [reference], "initialCoordinates": [start - reference]}
    node = mbs.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=1, initialCoordinates_t=[rate], **coordinates))
    body = mbs.AddObject(items.ObjectKinematicTree(nodeNumber=node, forceUserFunction=controller, **lists([link])))
    mbs.Assemble()
    return Tree(mbs, node, body, [link])


def trajectory(n: int) -> Trajectory:
    """Ramps of different lengths, a rest, accelerations that are linear in time."""
    rng = np.random.default_rng(n)
    made = Trajectory(
        rng.uniform(-1, 1, n), initialTime=0.1003, maxVelocities=np.full(n, 2.0), maxAccelerations=np.full(n, 9.0)
    )
    made.Add(ProfilePTP(rng.uniform(-1, 1, n), syncAccTimes=False))
    made.Add(ProfileConstantAcceleration(rng.uniform(-1, 1, n), 0.4))
    bump = [(0, np.zeros(n)), (0.1, np.full(n, 5.0)), (0.3, np.full(n, -5.0)), (0.4, np.zeros(n))]
    made.Add(ProfileLinearAccelerationsList(bump))
    return made


# ---- control laws
# --------------------------------------------------------------------------------------------------------


def test_controllers_follow_trajectories_to_the_last_digits() -> None:
    wanted, rest = trajectory(3), np.zeros(3)
    place, rates = PDController(wanted, 1, 0), PDController(wanted, 0, 1)
    for t in [-1.0, *np.linspace(0.0, wanted.GetTimes()[-1] + 0.2, 101)]:
        s, v, _ = wanted.Evaluate(t)
        assert place.Forces(t, rest, rest) == pytest.approx(s, abs=1e-13)
        assert rates.Forces(t, rest, rest) == pytest.approx(v, abs=1e-12)


@numba.cfunc(compiled.numba_signature("Controller", "desired"))
def swings(t, count, q, v, a):
    for i, (values, factor) in enumerate(((q, 1.0), (v, 3.0), (a, -9.0))):
        array = numba.carray(values, count)
        for k in range(count):
            array[k] = factor * (np.cos(3 * t) if i == 1 else np.sin(3 * t)) * (k + 1)


def test_motions_by_compiled_functions() -> None:
    law = PDController(swings, [2.0, 5.0], [3.0, 1.0], forces=[0.5, -1])
    q, v = np.array([0.3, -0.2]), np.array([1.0, 2.0])
    s, s_t = np.sin(2.1) * np.array([1, 2]), 3 * np.cos(2.1) * np.array([1, 2])
    assert law.Forces(0.7, q, v) == pytest.approx([0.5, -1] + np.array([2, 5]) * (s - q) + np.array([3, 1]) * (s_t - v))


# ---- continuous controllers -------------------------------------------------------------------------------------------


def oscillation(t: float, start: float, rate: float) -> float:
    """Free vibration of the mass about zero."""
    decay, omega = DAMPING / (2 * MASS), np.sqrt(STIFFNESS / MASS - (DAMPING / (2 * MASS)) ** 2)
    return float(np.exp(-decay * t) * (start * np.cos(omega * t) + (rate + decay * start) / omega * np.sin(omega * t)))


# The order of the methods: errors of RK67 are those of round-off, those of the trapezoidal rule (omega h)^2 / 12 of omega t.
@pytest.mark.parametrize(("solver", "tolerance"), [(Solver.RK67, 1e-11), (Solver.TrapezoidalIndex2, 2e-5)], ids=str)
def test_pd_control_is_a_spring_with_damper(solver: Any, tolerance: float) -> None:
    tree = slider(PDController([0.7], STIFFNESS, DAMPING), reference=0.25)
    tree.mbs.SolveDynamic(settings_of(0.5, 500), solverType=solver)
    assert tree.coordinates[0] == pytest.approx(0.7 + oscillation(0.5, -0.6, 0.5), abs=tolerance)


def test_generic_objects_are_controlled_as_well() -> None:
    mbs = exu.SystemContainer().AddSystem()
    place = {"referenceCoordinates": [0.25], "initialCoordinates": [-0.15], "initialCoordinates_t": [0.5]}
    node = mbs.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=1, **place))
    law = PDController([0.7], STIFFNESS, DAMPING)
    mbs.AddObject(items.ObjectGenericODE2(nodeNumbers=[node], massMatrix=[[MASS]], forceUserFunction=law))
    mbs.Assemble()
    mbs.SolveDynamic(settings_of(0.5, 500), solverType=Solver.RK67)
    total = mbs.GetNodeOutput(node, exu.OutputVariableType.CoordinatesTotal)
    assert total == pytest.approx(0.7 + oscillation(0.5, -0.6, 0.5), abs=1e-11)


def test_variations_are_solved_with_controllers() -> None:
    tree, starts = slider(PDController([0.7], STIFFNESS, DAMPING), reference=0.25), np.array([0.1, 0.3, 0.45])
    found = tree.mbs.SolveVariations(
        initialCoordinates={"ODE2": (starts - 0.25)[:, None]},
        simulationSettings=settings_of(0.5, 500),
        solverType=Solver.RK67,
        storeCoordinates=True,
    )
    wanted = [0.7 + oscillation(0.5, start - 0.7, 0.5) for start in starts]
    assert 0.25 + found.coordinates["ODE2"][:, 0] == pytest.approx(wanted, abs=1e-11)


# Each joint of a branched tree fulfils e_tt + d e_t + k e = 0, as a single mass does. The trapezoidal rule, for motions
# of some rad
# per 0.1 s with 1 ms steps have errors of 1e-4.
@pytest.mark.parametrize(("solver", "tolerance"), [(Solver.RK67, 1e-9), (Solver.TrapezoidalIndex2, 5e-4)], ids=str)
def test_errors_under_computed_torque_fall_as_oscillators(solver: Any, tolerance: float) -> None:
    links = random_links(4, 7)
    body = items.ObjectKinematicTree(gravity=GRAVITY, **lists(links))
    law = ComputedTorque(TreeDynamics(body), swings, STIFFNESS / MASS, DAMPING / MASS)
    factor = np.arange(1, 8)
    off, off_rate = np.linspace(-0.3, 0.3, 7), np.linspace(1, -1, 7)
    tree = make(links, off, 3 * factor + off_rate, gravity=GRAVITY, forceUserFunction=law)
    tree.mbs.Assemble()
    tree.mbs.SolveDynamic(settings_of(0.3, 300), solverType=solver)
    wanted = np.sin(0.9) * factor + [oscillation(0.3, *start) for start in zip(off, off_rate, strict=True)]
    assert tree.coordinates == pytest.approx(wanted, abs=tolerance)


# ---- sampled controllers -----------------------------------------------------------------------------------------------


def switching(period: float, dead_time: float, end: float) -> list[tuple[float, int, str]]:
    """Times, samples and events, in this order: the output of a sample acts before the next sample is taken."""
    count = int(end / period) + 1
    events = [(k * period, k, "sample") for k in range(count)] + [
        (k * period + dead_time, k, "act") for k in range(count)
    ]
    return sorted(events, key=lambda e: (round(e[0], 12), e[1], e[2] == "act"))


def in_discrete_time(
    state: np.ndarray, end: float, period: float, dead_time: float, law: Any, move: Callable[..., np.ndarray]
) -> np.ndarray:
    """The state at the end; move(state, forces, start, end) goes on under constant forces."""
    forces, found, t, n = np.zeros(len(state) // 2), dict[int, np.ndarray](), 0.0, len(state) // 2
    for time, k, what in switching(period, dead_time, end):
        if time > end:
            break
        if time > t:
            state, t = move(state, forces, t, time), time
        if what == "sample":
            found[k] = law(time, state[:n], state[n:])
        else:
            forces = found[k]
    return move(state, forces, t, end)


def free_mass(state: np.ndarray, force: np.ndarray, start: float, end: float) -> np.ndarray:
    h, a = end - start, force[0] / MASS
    return np.array([state[0] + h * state[1] + 0.5 * h * h * a, state[1] + h * a])


# All methods but Euler's are exact where accelerations are constant, also with steps that are longer than the period, or not commensurate with it.
EXACT = sorted(set(Solver) - {Solver.ExplicitEuler, Solver.DVERK6}, key=int)


@pytest.mark.parametrize(
    ("period", "dead_time"), [(0.01, 0.0), (0.01, 0.004), (0.01, 0.01), (0.01, 0.025), (0.007, 0.0123)]
)
@pytest.mark.parametrize("steps", [7, 333])
@pytest.mark.parametrize("solver", EXACT, ids=str)
def test_sampled_pd_control_with_dead_time(solver: Any, steps: int, period: float, dead_time: float) -> None:
    tree = slider(SampledController(PDController([0.7], STIFFNESS, DAMPING), period, dead_time), reference=0.25)
    settings = settings_of(0.5, steps)
    settings.timeIntegration.automaticStepSize = True  # of those that have it
    tree.mbs.SolveDynamic(settings, solverType=solver)

    def law(_t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        return STIFFNESS * (0.7 - q) - DAMPING * v

    wanted = in_discrete_time(np.array([0.1, 0.5]), 0.5, period, dead_time, law, free_mass)
    # 0.5 s of about 400 steps, each with round-off of 1e-16
    assert [*tree.coordinates, *tree.rates] == pytest.approx(wanted, abs=1e-12)
    assert abs(tree.coordinates[0] - 0.7 - oscillation(0.5, -0.6, 0.5)) > 1e-3  # it is not the continuous one


def test_an_arm_under_sampled_computed_torque() -> None:
    """Against DOP853 between the switching times, with the equations of motion in Python."""
    links = random_links(8, 4)
    model, start = in_python(links, GRAVITY), np.array([0.1, -0.2, 0.3, 0.2, 0, 0, 0, 0])
    wanted = trajectory(4)
    law = ComputedTorque(TreeDynamics(items.ObjectKinematicTree(gravity=GRAVITY, **lists(links))), wanted, 90.0, 16.0)
    tree = make(links, start[:4], start[4:], gravity=GRAVITY, forceUserFunction=SampledController(law, 0.01, 0.004))
    tree.mbs.Assemble()
    tree.mbs.SolveDynamic(settings_of(0.3, 200), solverType=Solver.RK67)

    def in_python_law(t: float, q: np.ndarray, v: np.ndarray) -> np.ndarray:
        s, s_t, s_tt = wanted.Evaluate(t)
        M, f = model.ComputeMassMatrixAndForceTerms(q, v)
        return np.asarray(M @ (s_tt + 16 * (s_t - v) + 90 * (s - q)) + f)

    def move(state: np.ndarray, forces: np.ndarray, begin: float, end: float) -> np.ndarray:
        def rate(_t: float, y: np.ndarray) -> np.ndarray:
            M, f = model.ComputeMassMatrixAndForceTerms(y[:4], y[4:])
            return np.concatenate([y[4:], np.linalg.solve(M, forces - f)])

        if end - begin < 1e-13:
            return state
        return np.asarray(solve_ivp(rate, (begin, end), state, "DOP853", rtol=1e-11, atol=1e-12).y[:, -1])

    expected = in_discrete_time(start, 0.3, 0.01, 0.004, in_python_law, move)
    assert [*tree.coordinates, *tree.rates] == pytest.approx(expected, abs=1e-7)


@ctypes.CFUNCTYPE(None, *[ctypes.c_double, ctypes.c_int64, *3 * [ctypes.POINTER(ctypes.c_double), ctypes.c_int64]])
def in_c(_t, _item, q, _n, v, _m, f, _k):
    f[0] = STIFFNESS * (0.7 - q[0]) - DAMPING * v[0]


def end_of(controller: Any, **more: Any) -> list[float]:
    tree = slider(controller, reference=0.25)
    settings = settings_of(0.5, 64)
    tree.mbs.SolveDynamic(settings, **more)
    return [*tree.coordinates, *tree.rates]


@pytest.mark.parametrize("solver", [Solver.RK44, Solver.GeneralizedAlpha], ids=str)
def test_laws_in_c_do_the_same(solver: Any) -> None:
    pd, own = PDController([0.7], STIFFNESS, DAMPING), CompiledController(in_c)
    assert end_of(own, solverType=solver) == pytest.approx(end_of(pd, solverType=solver), abs=1e-13)
    sampled = [end_of(SampledController(law, 0.01, 0.004), solverType=solver) for law in (pd, own)]
    assert sampled[0] == pytest.approx(sampled[1], abs=1e-13)


def test_solutions_begin_anew_and_objects_hold_their_own() -> None:
    law = SampledController(PDController([0.7], STIFFNESS, DAMPING), 0.01, 0.013)
    first, second, fresh = slider(law), slider(law, start=-0.4), slider(law)
    for tree in (first, second, first, fresh):
        tree.mbs.SolveDynamic(settings_of(0.5, 64))
    assert [*first.coordinates, *first.rates] == [*fresh.coordinates, *fresh.rates]
    assert abs(second.coordinates[0] - first.coordinates[0]) > 0.01


def test_restart_files_contain_pending_outputs(tmp_path: Any, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    law = SampledController(PDController([0.7], STIFFNESS, DAMPING), 0.01, 0.013)
    for solver in (Solver.RK44, Solver.GeneralizedAlpha):
        whole, part, rest = (slider(law, reference=0.25) for _ in range(3))
        settings = settings_of(0.5, 64)
        whole.mbs.SolveDynamic(settings, solverType=solver)
        settings = settings_of(0.5, 64)
        settings.solutionSettings.writeRestartFile = True
        settings.solutionSettings.restartFileName, settings.solutionSettings.restartWritePeriod = "restart.txt", 0.3
        part.mbs.SolveDynamic(settings, solverType=solver)
        settings = settings_of(0.5, 64)
        settings.continuation.restartFileName = "restart.txt"
        rest.mbs.SolveDynamic(settings, solverType=solver)
        assert [*rest.coordinates, *rest.rates] == [*part.coordinates, *part.rates]
        assert [*part.coordinates, *part.rates] == pytest.approx([*whole.coordinates, *whole.rates], abs=1e-9)


def test_another_controller_acts_from_its_first_sample_on() -> None:
    """It is set half way, and another item changes with each step: the same as two solutions in sequence."""
    pulls, brakes = (SampledController(PDController([to], STIFFNESS, DAMPING), 0.01) for to in (0.7, -0.2))
    tree = slider(pulls)
    marker = tree.mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=tree.node, coordinate=0))
    load = tree.mbs.AddLoad(items.LoadCoordinate(markerNumber=marker, load=0.0))
    tree.mbs.Assemble()

    def change(mbs: Any, t: float) -> bool:
        mbs.SetLoadParameter(load, "load", 1e-20 * t)
        if abs(t - 0.2) < 1e-9:
            mbs.SetObjectParameter(tree.body, "forceUserFunction", brakes)
        return True

    tree.mbs.SetPostStepUserFunction(change)
    tree.mbs.SolveDynamic(settings_of(0.4, 400))
    first = slider(pulls)
    first.mbs.SolveDynamic(settings_of(0.2, 200))
    second = slider(brakes, start=first.coordinates[0], rate=first.rates[0])
    second.mbs.SolveDynamic(settings_of(0.2, 200))
    assert [*tree.coordinates, *tree.rates] == pytest.approx([*second.coordinates, *second.rates], abs=1e-9)


def test_steps_have_their_size_again_after_a_sample() -> None:
    tree = slider(SampledController(PDController([0.7], STIFFNESS, DAMPING), 0.1, 0.03))
    times: list[float] = []
    tree.mbs.SetPostStepUserFunction(lambda _mbs, t: times.append(t) or True)
    tree.mbs.SolveDynamic(settings_of(0.2, 5))
    np.testing.assert_allclose(times, [0, 0.03, 0.07, 0.1, 0.13, 0.17, 0.2], rtol=0, atol=1e-15)


# ---- rejected arguments
# -------------------------------------------------------------------------------------------------


@numba.cfunc("float64(float64)")
def other(t):
    return t


PD = PDController([0.7], 1, 1)
WRONG: dict[str, tuple[Callable[[], Any], str]] = {
    "gains": (lambda: PDController([0.0, 0.0], [1.0], 1), "desired has 2 coordinates; expected 1"),
    "more gains": (
        lambda: PDController([0.0], 1, [1, 2]),
        "PDController: damping: expected a finite number, or 1, one per",
    ),
    "nan": (lambda: PDController([np.nan], 1, 1), "PDController: desired: expected finite numbers"),
    "no number of coordinates": (
        lambda: PDController(swings, 1, 1),
        "one number per coordinate, as desired is a function",
    ),
    "signature": (
        lambda: PDController(other, [1], 1),
        r"the signature void\(double, int64, double\*, double\*, double\*\)",
    ),
    "law": (lambda: CompiledController(other), r"that of this one is double\(double\)"),
    "no law": (lambda: CompiledController(len), "CompiledController: law: expected a C function"),
    "twice": (
        lambda: SampledController(SampledController(PD, 1), 1),
        "such as .*, that is not sampled itself, received",
    ),
    "period": (lambda: SampledController(PD, 0), "SampledController: period: expected a positive number"),
    "dead time": (lambda: SampledController(PD, 1, -1), "deadTime: expected a finite number that is not negative"),
    "forces": (lambda: PD.Forces(0, [1, 2], [1, 2]), "PDController.Forces: q: expected a vector with 1 components"),
    "place": (
        lambda: exu.LoadCoordinate(loadUserFunction=PD),
        "Controllers take the place of forceUserFunction of kinematic trees and of generic objects",
    ),
}


@pytest.mark.parametrize(("make_it", "text"), WRONG.values(), ids=WRONG)
def test_wrong_values_are_refused(make_it: Callable[[], Any], text: str) -> None:
    with pytest.raises((ValueError, TypeError), match=text):
        make_it()


def test_other_numbers_of_coordinates_are_refused() -> None:
    tree = slider(PDController([0.0, 0.0], 1, 1))
    with pytest.raises(ValueError, match=r"'forceUserFunction' of object 0.*a controller of 2 coordinates.*one of 1"):
        tree.mbs.SolveDynamic(settings_of(0.1, 10))


def test_forces_that_are_not_finite_name_the_object() -> None:
    nan = ctypes.CFUNCTYPE(None, *in_c.argtypes)(lambda *arguments: arguments[6].__setitem__(0, float("nan")))
    tree = slider(CompiledController(nan))
    with pytest.raises(ValueError, match=r"'forceUserFunction' of object 0.*nan as force.*Check the controller"):
        tree.mbs.SolveDynamic(settings_of(0.1, 10))


def test_sampled_controllers_need_time() -> None:
    tree = slider(SampledController(PD, 0.01))
    with pytest.raises(RuntimeError, match="acts in time, which static solutions do not know"):
        tree.mbs.SolveStatic()
    with pytest.raises(RuntimeError, match="has a sampled controller, and variations"):
        tree.mbs.SolveVariations(initialCoordinates={"ODE2": [[0.1], [0.2]]}, simulationSettings=settings_of(0.1, 10))
    assert isinstance(tree.mbs.GetObjectParameter(tree.body, "forceUserFunction"), Controller)


def test_static_solutions_under_a_continuous_controller() -> None:
    link = Link("Px", mass=MASS, inertia=np.eye(3))
    tree = make([link], [0.3], gravity=[4.0, 0, 0], forceUserFunction=PDController([0.7], STIFFNESS, 1))
    tree.mbs.Assemble()
    tree.mbs.SolveStatic()
    assert tree.coordinates[0] == pytest.approx(0.7 + 4 * MASS / STIFFNESS, abs=1e-12)
