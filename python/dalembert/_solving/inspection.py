"""Constraints and energies in the course of a solution."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType, testing
from dalembert._io.solution_states import LoadSolutionFile
from dalembert._solving.energies import MovingSystem, energies_of
from dalembert._solving.quiet import assemble_if_needed

_NAME = "InspectSolution"
_GROUPS = ("q", "v", "a", "y", "y_t", "lam", "data")  # groups of a row of a solution


class Drift(NamedTuple):
    """The largest value of one item in a solution, its time (s) and the equation, counted in the item."""

    value: float
    time: float
    equation: int


class SolutionInspection(NamedTuple):
    """Results of mbs.InspectSolution.

    times: times of the states (s).
    gaps, gapRates: the largest gap (m or rad) and its largest rate, by the text that names item and type.
    kinetic, potential: energies (J) in these states; potential counts from the reference configuration.
    dissipated: work (J) that forces of velocities have taken out since the first state, by the trapezoidal rule.
    supplied: work (J) that motors, loads that change and errors of the solver have put in since the first state.
    """

    times: FloatArray
    gaps: dict[str, Drift]
    gapRates: dict[str, Drift]
    kinetic: FloatArray
    potential: FloatArray
    dissipated: FloatArray
    supplied: FloatArray

    def __str__(self) -> str:
        lines = [f"{len(self.times)} states from {self.times[0]:.6g} s to {self.times[-1]:.6g} s"]
        for name, unit, found in (("gap", "", self.gaps), ("rate of a gap", " per s", self.gapRates)):
            lines += [
                f"largest {name} of {item}, equation {drift.equation}: {drift.value:.3g}{unit} at {drift.time:.6g} s"
                for item, drift in found.items()
            ]
        total = self.kinetic + self.potential
        lines.append(
            f"energy: {total[0]:.6g} J at first, {total[-1]:.6g} J at last; dissipated {self.dissipated[-1]:.3g} J, "
            f"supplied {self.supplied[-1]:.3g} J (between {self.supplied.min():.3g} and {self.supplied.max():.3g} J)"
        )
        return "\n".join(lines)


def _states(system: MovingSystem, solution: dict[str, Any], every: int) -> Iterator[Any]:
    """Set the state of the system to one row of a solution after the other."""
    columns = solution["columnsExported"]
    for row in np.asarray(solution["data"])[::every]:
        state = system.state
        state.t = float(row[0])
        for name, group in zip(_GROUPS, np.split(row[1:], np.cumsum(columns)[:-1]), strict=True):
            if group.size and name in ("q", "v", "y", "data"):
                setattr(state, name, group)
        yield state


def _keep_largest(mbs: Any, state: Any, gaps: dict[str, Drift], rates: dict[str, Drift]) -> None:
    for _, of_rate, value, _, text in testing.open_constraints(mbs, state, 0.0, 0.0):
        item, _, equation = text.partition(":")[0].rpartition(", equation ")
        found = rates if of_rate else gaps
        if item not in found or abs(value) > abs(found[item].value):
            found[item] = Drift(value, float(state.t), int(equation))


def _largest_first(found: dict[str, Drift]) -> dict[str, Drift]:
    return dict(sorted(found.items(), key=lambda entry: -abs(entry[1].value)))


def InspectSolution(
    mbs: Any,
    solution: dict[str, Any] | str | Path = "coordinatesSolution.txt",
    every: int = 1,
    autoAssemble: bool = True,
) -> SolutionInspection:
    """Return the largest gaps of all items in a solution, and its energies; print it for a table.

    solution is a file, or the result of LoadSolutionFile; every: increment of states. It must contain velocities
    (solutionSettings.exportVelocities). The state of the system does not change.
    """
    assemble_if_needed(_NAME, mbs, autoAssemble)
    if not isinstance(solution, dict):
        solution = LoadSolutionFile(solution, verbose=False)
    columns, sizes = solution["columnsExported"], (len(testing.State(mbs).q), len(testing.State(mbs).v))
    if tuple(columns[:2]) != sizes:
        raise ValueError(
            f"{_NAME}: solution: received {columns[0]} coordinates and {columns[1]} velocities per state; expected "
            f"{sizes[0]} of each, of this system. Use solutionSettings.exportVelocities=True"
        )
    if every < 1 or len(solution["data"]) == 0:
        raise ValueError(
            f"{_NAME}: received every={every}, and {len(solution['data'])} states; expected 1 or more of both"
        )
    system = MovingSystem(mbs, ConfigurationType.Current)
    gaps: dict[str, Drift] = {}
    rates: dict[str, Drift] = {}
    rows = []
    for state in _states(system, solution, every):
        _keep_largest(mbs, state, gaps, rates)
        energies = energies_of(system)
        rows.append((state.t, energies.kinetic, energies.potential, energies.dissipatedPower))
    times, kinetic, potential, power = np.array(rows, dtype=float).T
    steps = np.diff(times) * (power[1:] + power[:-1]) / 2
    dissipated = np.concatenate([[0.0], np.cumsum(steps)])
    total = kinetic + potential
    supplied = total - total[0] + dissipated
    return SolutionInspection(
        times, _largest_first(gaps), _largest_first(rates), kinetic, potential, dissipated, supplied
    )
