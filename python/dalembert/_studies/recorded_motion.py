"""A time integration whose states after each step are kept, and checks that it can be differentiated."""

from __future__ import annotations

import copy
from typing import Any, NamedTuple

import numpy as np

from dalembert import _core, solver
from dalembert._checks import FloatArray
from dalembert._core import MainSystem, SimulationSettings
from dalembert._solving.integrators import IMPLICIT, kind_of
from dalembert._studies.design_parameters import describe
from dalembert._studies.generalized_alpha import Scheme
from dalembert._studies.not_differentiable import NotDifferentiable

_INSTEAD = "use processing.ComputeSensitivities, which takes differences of whole solutions"
_NEWTON = {"relativeTolerance": 1e-12, "absoluteTolerance": 1e-13}
_TURNS = {"ConnectorTorsionalSpringDamper"}  # data only count turns
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
    states: FloatArray
    algorithmic: FloatArray  # algorithmic accelerations, in rows
    scheme: Scheme
    computes_start: bool  # accelerations of the start fulfil the equations of motion


def refuse_system(mbs: MainSystem) -> None:
    """Refuse a model whose equations have parts that cannot be differentiated."""
    for name in _SYSTEM_FUNCTIONS:
        if getattr(mbs, f"Get{name}UserFunction")() != 0:
            raise NotDifferentiable(
                "functions that are called in steps may change the state unseen",
                item=f"mbs.{name}UserFunction",
                advice=f"remove it, or {_INSTEAD}",
            )
    if mbs.GetDictionary().get("generalContactList"):
        raise NotDifferentiable("contacts switch within steps", item="GeneralContact", advice=_INSTEAD)
    data = mbs.systemData
    users_of_nodes: dict[int, list[int]] = {}
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
                        advice=f"write it with dalembert.symbolic, or {_INSTEAD}",
                    )
            if kind == "Node" and data.GetNodeLTGData(number):
                if not users_of_nodes:
                    for i in range(data.NumberOfObjects()):
                        for node in _nodes_of(mbs.GetObject(i)):
                            users_of_nodes.setdefault(int(node), []).append(i)
                users = users_of_nodes.get(number, [])
                if all(mbs.GetObject(i)["objectType"] in _TURNS for i in users):
                    continue
                owner = _core.ObjectIndex(users[0]) if users else item
                raise NotDifferentiable(
                    "its history, such as of contact or friction, changes between steps",
                    item=describe(mbs, owner),
                    advice=_INSTEAD,
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
    if solverType not in IMPLICIT:
        raise NotDifferentiable(
            "only generalized alpha and the trapezoidal rule are available", item=str(solverType), advice=_INSTEAD
        )
    time = settings.timeIntegration
    refused = [
        (
            time.automaticStepSize and settings.stepSizeControl.implicitSolvers,
            "stepSizeControl.implicitSolvers",
            "steps depend on parameters",
            "use equal steps",
        ),
        (settings.events.ofItems, "events.ofItems", "steps end at events", "switch it off if the model has no events"),
        (time.newton.useNewtonSolver is False, "timeIntegration.newton.useNewtonSolver", "residuals do not vanish", ""),
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


def silent(settings: SimulationSettings) -> SimulationSettings:
    """Return a copy of settings for solutions without text and files, solved to round-off."""
    made: SimulationSettings = copy.deepcopy(settings)
    for part in (made.timeIntegration, made.staticSolver):
        part.verboseMode = part.verboseModeFile = 0
        for name, value in _NEWTON.items():
            setattr(part.newton, name, min(value, getattr(part.newton, name)))
    made.timeIntegration.newton.useModifiedNewton = False  # which converges slowly
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


def record(mbs: MainSystem, settings: SimulationSettings, solverType: Any) -> Motion:
    """Solve a system, which is a copy that may change, and return its motion."""
    data = mbs.systemData
    times: list[float] = []
    states: list[FloatArray] = []
    get = (
        data.GetODE2Coordinates,
        data.GetODE2Coordinates_t,
        data.GetODE2Coordinates_tt,
        data.GetODE1Coordinates,
        data.GetODE1Coordinates_t,
        data.GetAECoordinates,
        data.GetDataCoordinates,
    )

    def keep(_mbs: Any, time: float) -> bool:
        times.append(time)
        states.append(np.concatenate([part() for part in get]))
        return True

    mbs.SetPostStepUserFunction(keep)
    try:
        solver.SolveDynamic(mbs, settings, solverType=solverType)
    finally:
        mbs.SetPostStepUserFunction(0)
    used = mbs.sys["dynamicSolver"]
    refuse_redundant(used)
    generalized = settings.timeIntegration.generalizedAlpha
    newmark = generalized.useNewmark or solverType == _core.DynamicSolverType.TrapezoidalIndex2
    steps = int(round(settings.timeIntegration.numberOfSteps))
    step_size = (settings.timeIntegration.endTime - settings.timeIntegration.startTime) / steps
    all_times, z = np.array(times), np.array(states)
    if len(z) != steps + 1 or np.max(np.abs(np.diff(all_times) - step_size)) > 1e-8 * step_size:
        raise NotDifferentiable(
            f"there were {len(z) - 1} steps, some of them of other sizes, instead of {steps} equal ones",
            item="time integration",
            advice="use smaller steps, such that none has to be repeated",
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
    n = data.ODE2Size()
    a = z[:, 2 * n : 3 * n]
    b = np.empty_like(a)
    b[0] = a[0]
    for i in range(steps):
        b[i + 1] = scheme.algorithmic(a[i], b[i], a[i + 1])
    return Motion(all_times, z, b, scheme, bool(generalized.computeInitialAccelerations))


def check_steps(motion: Motion, derivatives: Any, n: int) -> None:
    """Refuse a motion whose steps are not those of the scheme, because the solver has corrected velocities."""
    s, z = motion.scheme, motion.states
    q, v, a, b = z[:-1, :n], z[:-1, n : 2 * n], z[:-1, 2 * n : 3 * n], motion.algorithmic[:-1]
    q_end, v_end, a_end = z[1:, :n], z[1:, n : 2 * n], z[1:, 2 * n : 3 * n]
    x = a_end / s.c_a
    expected_v = s.velocities(v, a, b) + s.c_v * x
    expected_q = q + s.increments(v, a, b) + x
    if len(s.rotations):
        for i in range(len(q)):
            now = q[i]
            for increment in s.increment_of_step(v[i], a[i], b[i], a_end[i]):
                now = derivatives.compose(now, increment)
            expected_q[i] = now
    # Round-off of a is that of increments times c_a.
    off = np.abs(expected_v - v_end).max(axis=1, initial=0.0)
    speed = np.abs(v_end).max(axis=1, initial=0.0) + s.c_v * (np.abs(q_end).max(initial=0.0) + 1e-6) * 1e-6
    off_q = np.abs(expected_q - q_end).max(axis=1, initial=0.0)
    length = np.abs(q_end - q).max(axis=1, initial=0.0) + 1e-6 * np.abs(q_end).max(initial=0.0) + 1e-12
    bad = np.flatnonzero((off > 1e-7 * speed) | (off_q > (1e-4 if len(s.rotations) else 1e-7) * length))
    if len(bad):
        raise NotDifferentiable(
            "the solver has changed the state besides its scheme, such as velocities across constraints that oscillate",
            item="time integration",
            time=float(motion.times[bad[0] + 1]),
            advice="use smaller steps, a smaller spectralRadius, or exu.DynamicSolverType.TrapezoidalIndex2",
        )
