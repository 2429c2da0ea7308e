"""A time integration whose states after each step are kept, and checks that it can be differentiated."""

from __future__ import annotations

import copy
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core, solver
from dalembert._checks import FloatArray
from dalembert._core import MainSystem, SimulationSettings
from dalembert._solving.integrators import IMPLICIT, kind_of
from dalembert._studies.design_parameters import describe
from dalembert._studies.difference_formulas import derivative
from dalembert._studies.generalized_alpha import Scheme
from dalembert._studies.not_differentiable import INSTEAD, NotDifferentiable
from dalembert._studies.recorded_steps import Steps
from dalembert._studies.runge_kutta_steps import TABLEAUS, Tableau
from dalembert._studies.stored_rows import Rows

_NEWTON = {"relativeTolerance": 1e-12, "absoluteTolerance": 1e-13}
_LOOSER = 100.0  # factor of these tolerances if round-off, such as that of prestressed items, is larger
_SYSTEM_FUNCTIONS = (
    "PreStep",
    "PostStep",
    "PostNewton",
    "PreNewtonResidual",
    "SystemJacobian",
    "Events",
    "EventAction",
    "ItemEventAction",
)


class Motion(NamedTuple):
    """times (one more than steps), and states [q, v, a, y, y_t, lambda, data] in rows."""

    times: FloatArray
    states: Rows
    algorithmic: Rows | None  # algorithmic accelerations, if all steps have one size
    scheme: Scheme  # of Runge-Kutta methods: the size of regular steps alone
    computes_start: bool  # accelerations of the start fulfil the equations of motion
    tableau: Tableau | None = None  # of Runge-Kutta methods
    adaptive: bool = False  # tolerances have chosen the steps, or they are prescribed


def refuse_system(mbs: MainSystem) -> None:
    """Refuse a model whose equations have parts that cannot be differentiated."""
    for name in _SYSTEM_FUNCTIONS:
        if getattr(mbs, f"Get{name}UserFunction")() != 0:
            raise NotDifferentiable(
                "functions that are called in steps may change the state unseen",
                item=f"mbs.{name}UserFunction",
                advice=f"remove it, or {INSTEAD}",
            )
    if mbs.GetDictionary().get("generalContactList"):
        raise NotDifferentiable("contacts switch within steps", item="GeneralContact", advice=INSTEAD)
    data = mbs.systemData
    kinds = (
        ("Node", _core.NodeIndex),
        ("Object", _core.ObjectIndex),
        ("Marker", _core.MarkerIndex),
        ("Load", _core.LoadIndex),
    )
    for kind, index in kinds:
        for number in range(getattr(data, f"NumberOf{kind}s")()):
            item = index(number)
            entries = getattr(mbs, f"Get{kind}")(item)
            for name, value in entries.items():
                draws = name.startswith("V")
                if name.endswith("UserFunction") and not draws and value != 0 and not _is_symbolic(value):
                    raise NotDifferentiable(
                        f"{name} is a function without derivative",
                        item=describe(mbs, item),
                        advice=f"write it with dalembert.symbolic, or {INSTEAD}",
                    )


def _nodes_of(entries: dict[str, Any]) -> list[Any]:
    found: list[Any] = []
    for value in entries.values():
        found += [
            each
            for each in (value if isinstance(value, (list, tuple)) else [value])
            if isinstance(each, _core.NodeIndex)
        ]
    return found


def _is_symbolic(value: Any) -> bool:
    return isinstance(value, _core.symbolic.UserFunction)


def refuse_unit_lengths(mbs: MainSystem) -> None:
    """Refuse nodes whose coordinates are normalized after steps with constraints of velocities."""
    for number in range(mbs.systemData.NumberOfNodes()):
        if mbs.systemData.GetNodeLTGAE(number):
            raise NotDifferentiable(
                "its parameters are normalized after each step of the trapezoidal rule",
                item=describe(mbs, _core.NodeIndex(number)),
                advice="use a node with a rotation vector, or generalized alpha",
            )


def refuse_settings(settings: SimulationSettings, solverType: Any) -> None:
    """Refuse methods and step sizes whose derivatives are not available."""
    kind_of("ComputeSensitivities", solverType)
    if solverType not in IMPLICIT and solverType not in TABLEAUS:
        raise NotDifferentiable(
            "only generalized alpha, the trapezoidal rule, ESDIRK43 and explicit Runge-Kutta methods of up to 7 stages "
            "are available",
            item=str(solverType),
            advice=INSTEAD,
        )
    time = settings.timeIntegration
    refused = [
        (
            solverType in IMPLICIT and time.newton.useNewtonSolver is False,
            "timeIntegration.newton.useNewtonSolver",
            "residuals do not vanish",
            "",
        ),
        (
            settings.linearSolverSettings.ignoreSingularJacobian,
            "linearSolverSettings.ignoreSingularJacobian",
            "equations are left out",
            "",
        ),
    ]
    for is_set, name, reason, advice in refused:
        if is_set:
            raise NotDifferentiable(reason, item=f"simulationSettings.{name}", advice=advice)


def refuse_changed_velocities(mbs: MainSystem, settings: SimulationSettings, solverType: Any) -> None:
    """Refuse error control of methods that correct velocities across constraints whenever the step size changes."""
    controls = settings.timeIntegration.automaticStepSize and settings.stepSizeControl.implicitSolvers
    if solverType in IMPLICIT and controls and mbs.systemData.AEsize() > 0:
        raise NotDifferentiable(
            "velocities across constraints are corrected after each step, in the metric of Newton's matrices",
            item="simulationSettings.stepSizeControl.implicitSolvers",
            advice="use exu.DynamicSolverType.ESDIRK43, or equal steps",
        )


def silent(settings: SimulationSettings) -> SimulationSettings:
    """Return a copy of settings for solutions without text and files, solved to round-off."""
    made: SimulationSettings = copy.deepcopy(settings)
    for part in (made.timeIntegration, made.staticSolver):
        part.verboseMode = part.verboseModeFile = 0
        for name, value in _NEWTON.items():
            setattr(part.newton, name, min(value, getattr(part.newton, name)))
    # One Jacobian per step, and some iterations more: these cost a hundredth of it.
    newton = made.timeIntegration.newton
    newton.useModifiedNewton = newton.modifiedNewtonJacUpdatePerStep = True
    solution = made.solutionSettings
    solution.writeSolutionToFile = solution.writeRestartFile = solution.sensorsStoreAndWriteFiles = False
    solution.recordImagesInterval = -1
    made.redundantConstraints.treat = True  # they are found and refused
    return made


def refuse_redundant(used: Any) -> None:
    """Refuse constraints that follow from others: multipliers are not unique, and the matrix of a step is singular."""
    found = used.GetRedundantConstraints()
    if found["count"] > 0:
        names = ", ".join(f"{each['item']}" for each in found["items"])
        raise NotDifferentiable(
            f"{found['count']} constraint equations follow from others, so that multipliers are not unique",
            item=names or "constraints",
            advice="remove redundant constraints",
        )


def record(
    mbs: MainSystem, settings: SimulationSettings, solverType: Any, memory: float, ends: FloatArray | None = None
) -> Motion:
    """Solve a system, which is a copy that may change, and return its motion.

    memory: bytes of rows in memory. ends: times at which steps end; error control then has no effect.
    """
    data = mbs.systemData
    times: list[float] = []
    n = data.ODE2Size()
    width = 3 * n + 2 * data.ODE1Size() + data.AEsize() + len(data.GetDataCoordinates())
    states, b = Rows(width, memory * width / (width + n)), Rows(n, memory * n / (width + n))

    def keep(_mbs: Any, time: float) -> bool:
        times.append(time)
        states.append(_core.testing.current_state(mbs))
        return True

    mbs.SetPostStepUserFunction(keep)
    used = solver.new_solver(kind_of("ComputeSensitivities", solverType))
    if ends is not None:
        used.PrescribeEndsOfSteps(ends)
    try:
        solver.integrate(used, mbs, settings, solverType)
    finally:
        mbs.SetPostStepUserFunction(0)
    refuse_redundant(used)
    tableau, adaptive = TABLEAUS.get(solverType), bool(used.it.automaticStepSize)
    if tableau is not None:
        time = settings.timeIntegration
        h = (time.endTime - time.startTime) / int(round(time.numberOfSteps))
        scheme = Scheme(h, 0.25, 0.5, 0.0, 0.0, True, False)
        return Motion(np.array(times), states, None, scheme, tableau.implicit, tableau, adaptive)
    generalized = settings.timeIntegration.generalizedAlpha
    newmark = generalized.useNewmark or solverType == _core.DynamicSolverType.TrapezoidalIndex2
    steps = int(round(settings.timeIntegration.numberOfSteps))
    step_size = (settings.timeIntegration.endTime - settings.timeIntegration.startTime) / steps
    all_times = np.array(times)
    equal = len(times) == steps + 1 and np.max(np.abs(np.diff(all_times) - step_size)) <= 1e-8 * step_size
    if not equal and not settings.events.ofItems and not adaptive:
        newton = settings.timeIntegration.newton
        if used.it.rejectedNewtonSteps and newton.relativeTolerance <= _NEWTON["relativeTolerance"]:
            looser = copy.deepcopy(settings)
            for name, value in _NEWTON.items():
                setattr(looser.timeIntegration.newton, name, _LOOSER * value)
            return record(mbs, looser, solverType, memory, ends)
        raise NotDifferentiable(
            f"there were {len(times) - 1} steps, some of them of other sizes, instead of {steps} equal ones",
            item="time integration",
            advice="set simulationSettings.events.ofItems = True for contacts and friction, or use smaller steps",
        )
    scheme = Scheme(
        step_size,
        used.newmarkBeta,
        used.newmarkGamma,
        used.alphaM,
        used.alphaF,
        newmark,
        generalized.lieGroupSimplifiedKinematicRelations,
    )
    if equal:
        last, made = states[0][2 * n : 3 * n], states[0][2 * n : 3 * n]
        b.append(made)
        for part in states.blocks(1):
            for a in states[part][:, 2 * n : 3 * n]:
                last, made = a, scheme.algorithmic(last, made, a)
                b.append(made)
    return Motion(
        all_times,
        states,
        b if equal else None,
        scheme,
        bool(generalized.computeInitialAccelerations),
        adaptive=adaptive,
    )


def _predicted(
    s: Scheme, q: FloatArray, v: FloatArray, a: FloatArray, b: FloatArray, a_end: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return positions, but for rotations, and velocities at the ends of steps."""
    x = a_end / s.c_a
    return q + s.increments(v, a, b) + x, s.velocities(v, a, b) + s.c_v * x


def check_steps(motion: Motion, derivatives: Any, n: int, steps: Steps | None = None) -> None:
    """Refuse a motion whose steps are not those of the scheme, because the solver has corrected velocities."""
    for part in motion.states.blocks(1):
        _check_steps(motion, derivatives, n, steps, part)


def _check_steps(motion: Motion, derivatives: Any, n: int, steps: Steps | None, part: slice) -> None:
    """Check the steps that end at some states."""
    s, z = motion.scheme, motion.states[part.start - 1 : part.stop]
    q, v, a = z[:-1, :n], z[:-1, n : 2 * n].copy(), z[:-1, 2 * n : 3 * n]
    q_end, v_end, a_end = z[1:, :n], z[1:, n : 2 * n], z[1:, 2 * n : 3 * n]
    furthest = motion.states.largest[:n].max(initial=0.0)
    if steps is None:
        assert motion.algorithmic is not None
        b = motion.algorithmic[part.start - 1 : part.stop - 1]
        expected_q, expected_v = _predicted(s, q, v, a, b, a_end)
    else:
        a, b = steps.a[part], steps.b[part]
        for i, moved in steps.velocities.items():
            if part.start <= i < part.stop:
                v[i - part.start] = moved
        expected_q, expected_v = np.empty_like(q), np.empty_like(v)
        for i in range(len(q)):
            own = replace(s, h=float(steps.sizes[part.start + i]))
            expected_q[i], expected_v[i] = _predicted(own, q[i], v[i], a[i], b[i], a_end[i])
    if len(s.rotations):
        if steps is None:
            increments: Any = zip(*s.increment_of_step(v, a, b, a_end), strict=True)
        else:
            schemes = [replace(s, h=float(h)) for h in steps.sizes[part]]
            increments = (each.increment_of_step(v[i], a[i], b[i], a_end[i]) for i, each in enumerate(schemes))
        for i, parts in enumerate(increments):
            now = q[i]
            for increment in parts:
                now = derivatives.compose(now, increment)
            expected_q[i] = now
    # Round-off of a is that of increments times c_a.
    off = np.abs(expected_v - v_end).max(axis=1, initial=0.0)
    speed = np.abs(v_end).max(axis=1, initial=0.0) + s.c_v * (furthest + 1e-6) * 1e-6
    off_q = np.abs(expected_q - q_end).max(axis=1, initial=0.0)
    length = np.abs(q_end - q).max(axis=1, initial=0.0) + 1e-6 * furthest + 1e-12
    bad = np.flatnonzero((off > 1e-7 * speed) | (off_q > (1e-4 if len(s.rotations) else 1e-7) * length))
    if len(bad):
        raise NotDifferentiable(
            "the solver has changed the state besides its scheme, such as velocities across constraints that oscillate",
            item="time integration",
            time=float(motion.times[part.start + bad[0]]),
            advice="use smaller steps, a smaller spectralRadius, or exu.DynamicSolverType.TrapezoidalIndex2",
        )


def check_tangent(derivatives: Any, z: FloatArray, time: float, h: float, steps: FloatArray, mbs: Any) -> None:
    """Refuse matrices that are not derivatives of the residual, such as those of mass matrices of user functions."""
    n, n1, m, _ = derivatives.sizes
    count = n + n1 + m
    directions = [np.cos(np.arange(size) + 1.0) for size in (n, n, n, n1, m)]
    q, v, a, y = (
        part * steps[begin : begin + len(part)]
        for part, begin in zip(directions[:4], (0, n, 2 * n, 3 * n), strict=True)
    )
    lam = directions[4] * steps[3 * n + 2 * n1 : 3 * n + 2 * n1 + m]

    def along(e: float) -> FloatArray:
        at = z.copy()
        at[:n] = derivatives.compose(z[:n], e * q)
        for part, begin in ((v, n), (a, 2 * n), (y, 3 * n), (lam, 3 * n + 2 * n1)):
            at[begin : begin + len(part)] += e * part
        return np.asarray(derivatives.residual(at, time, h))

    derivatives.linearize(z, time, h)
    parts = [derivatives.product("K", np.concatenate((q, y, lam))[None])[0], derivatives.product("D", v[None])[0]]
    inertia, of_a = np.zeros(count), derivatives.product("M", a[None])[0]
    inertia[: len(of_a)] = of_a
    parts.append(inertia)
    size = np.abs(parts).sum(axis=0)
    for scale, tolerance in ((0.1, 1e-6), (1e-3, 1e-5)):  # smaller, if a corner is near
        off = np.abs(derivative(along, scale) - np.sum(parts, axis=0))
        blocks = ((0, n), (n, n + n1), (n + n1, count))
        bad = [begin + int(np.argmax(off[begin:end])) for begin, end in blocks if end > begin
               and off[begin:end].max() > tolerance * size[begin:end].max() + 1e-12]  # fmt: skip
        if not bad:
            return
    raise NotDifferentiable(
        "the Jacobian is not the derivative of these equations, as with mass matrices and Jacobians of user functions",
        item=_core.testing.describe_row(mbs, bad[0]),
        time=time,
        advice=INSTEAD,
    )
