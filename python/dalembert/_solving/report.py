"""One page about a system and its last solution."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._core import ConfigurationType, testing
from dalembert._solving.energies import ComputeEnergies, TotalMass
from dalembert._solving.linearized import ComputeSystemDegreeOfFreedom
from dalembert._solving.quiet import assemble_if_needed

_NAME = "Report"
_LISTED = 5
_NOTICEABLE = 1e-9  # gap, relative to the size of the model
# rate of a gap relative to the joining velocities: index 3 solvers have smaller ones as a rule
_NOTICEABLE_RATE = 1e-2


def _first(lines: list[str]) -> list[str]:
    return lines if len(lines) <= _LISTED else [*lines[:_LISTED], f"... {len(lines) - _LISTED} more"]


def _counts(mbs: Any) -> list[str]:
    data = mbs.systemData
    items = ", ".join(
        f"{count} {name}"
        for name, count in (
            ("nodes", data.NumberOfNodes()),
            ("objects", data.NumberOfObjects()),
            ("markers", data.NumberOfMarkers()),
            ("loads", data.NumberOfLoads()),
            ("sensors", data.NumberOfSensors()),
        )
    )
    freedom = ComputeSystemDegreeOfFreedom(mbs)
    lines = [
        f"items: {items}; size {testing.extent(mbs):.3g} m, mass {TotalMass(mbs):.6g} kg",
        "coordinates: {nODE2} of second order, {nODE1} of first order; {nAE} algebraic equations".format(**freedom),
        "degrees of freedom: {degreeOfFreedom}; redundant constraint equations: {redundantConstraints}".format(
            **freedom
        ),
    ]
    removable = freedom.get("removableEquations", {})
    return lines + _first(
        [
            f"  object {number} '{mbs.GetObject(number)['name']}': {some} of {of_all} equations are removable, "
            "reactions have the minimum norm"
            for number, (some, of_all) in removable.items()
        ]
    )


def _gaps(mbs: Any) -> list[str]:
    if len(mbs.systemData.GetAECoordinates()) == 0:
        return []
    found = testing.open_constraints(mbs, testing.State(mbs), _NOTICEABLE, _NOTICEABLE_RATE)
    if not found:
        return ["constraints: closed"]
    return ["constraint violations:", *_first([f"  {text}" for *_, text in found])]


def _energies(mbs: Any) -> list[str]:
    now = ComputeEnergies(mbs)
    lines = [
        f"energy: kinetic {now.kinetic:.6g} J, potential {now.potential:.6g} J, total {now.total:.6g} J; "
        f"dissipated power {now.dissipatedPower:.3g} W"
    ]
    if now.potentialError > 1e-6 * max(abs(now.potential), abs(now.kinetic)):
        lines.append("  potential energy is inaccurate: a force jumps")
    data = mbs.systemData
    if data.GetTime() != data.GetTime(ConfigurationType.Initial):
        start = ComputeEnergies(mbs, ConfigurationType.Initial)
        change = now.total - start.total
        largest = max(now.kinetic, start.kinetic, abs(now.potential - start.potential))
        share = f", {abs(change) / largest:.2g} of the largest energy" if largest > 0 else ""
        lines.append(
            f"  drift since the initial state: {change:.3g} J{share}; dissipation, drives and errors of the solver "
            "together (mbs.InspectSolution separates them)"
        )
    return lines


def _repeated(it: Any) -> str:
    """Return how many steps were repeated, and why, as the end of a line."""
    causes = {
        "tolerances": it.rejectedAutomaticStepSizeSteps,
        "Newton's method": it.rejectedNewtonSteps,
        "contact or friction": it.rejectedDiscontinuousSteps,
    }
    told = ", ".join(f"{count} by {cause}" for cause, count in causes.items() if count)
    return f", {sum(causes.values())} steps repeated ({told})" if told else ""


def _solution(mbs: Any) -> list[str]:
    lines = []
    for key in ("staticSolver", "dynamicSolver"):
        solver = mbs.sys.get(key)
        if solver is None:
            continue
        it, how = solver.it, "finished" if solver.output.finishedSuccessfully else solver.GetErrorString()
        line = f"{solver.GetSolverName()}: {how}; {it.currentStepIndex - 1} steps to time {it.currentTime:.6g} s"
        if it.newtonStepsCount:
            line += f", {it.newtonStepsCount} Newton iterations, {it.newtonJacobiCount} Jacobians"
        lines.append(line + _repeated(it))
        if it.largestStepSize > 0:
            most = f", {it.stepsAtMaximumStepSize} of the largest admissible size" if it.stepsAtMaximumStepSize else ""
            lines.append(f"  step sizes from {it.smallestStepSize:.3g} to {it.largestStepSize:.3g} s{most}")
        if it.singularPositionSteps:
            lines.append(f"  singular configurations were passed in {it.singularPositionSteps} steps")
        lines.extend(f"  not to be trusted: {doubt}" for doubt in solver.GetDoubts())
        misfit = solver.GetRedundantConstraints()["misfit"]
        if misfit > _NOTICEABLE:
            lines.append(f"  redundant constraints were inconsistent by {misfit:.3g} of the size of the model")
    return lines


def Report(mbs: Any, autoAssemble: bool = True) -> str:
    """Return one page about the system in its current state, and about its last solutions.

    Numbers of items and coordinates, degrees of freedom and redundant constraints with the objects that could lose
    some, constraints that are open, energies with their drift since the initial state, and how the last solvers ended.
    """
    assemble_if_needed(_NAME, mbs, autoAssemble)
    with np.errstate(invalid="ignore"):
        return "\n".join([*_counts(mbs), *_gaps(mbs), *_energies(mbs), *_solution(mbs)])
