"""Errors and costs of exact sensitivities for the problems of tests/validation/sensitivity_problems.py.

`python benchmarks/sensitivity_problems.py docs/data/sensitivity_problems.csv`. Errors are those of derivatives times
parameters, relative to the largest one of the same output. References are closed forms, or complex steps through
integrations in minimal coordinates. Derivatives of motions are extrapolated from solutions with n and 2n steps, or 4n,
those of meshes from two meshes. Costs are those of a solution with its derivatives by the adjoint method, in units of a
solution alone.
"""

from __future__ import annotations

import csv
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from validation.sensitivity_problems import (  # noqa: E402
    DYNAMIC,
    EVENTS,
    FIXED_POINTS,
    STATIC,
    Problem,
    absorber_problem,
    buckling,
    elastica,
    vibrating_cantilever,
)
from validation.test_exact_sensitivities import FIRST_ORDER, known, limit_of, numbers_of, relative  # noqa: E402

import dalembert as exu  # noqa: E402

ROUNDS = 3
# Steps of RK67, which has order 6, where steps of generalized alpha do not end at an event, or converge slowly.
EXPLICIT = {"P10": 900, "P12": 30, "P13": 60}
MESHES: dict[str, Any] = {"P4b": (elastica, 24), "P5": (buckling, 4), "P6": (vibrating_cantilever, 8)}
TITLES = {
    "P1": ("frequency of a compound pendulum", "reference"),
    "P2": ("slider-crank, prescribed crank", "reference"),
    "P3": ("four-bar at rest, reactions", "reference"),
    "P4a": ("linear beam", "reference"),
    "P4b": ("elastica of cable elements", "24 and 48 elements"),
    "P5": ("buckling load of a column", "4 and 8 elements"),
    "P6": ("frequencies of a beam with tip mass", "8 and 16 elements"),
    "P7": ("weight on two springs", "reference"),
    "P8": ("frequency response of an absorber", "both fixed points"),
    "P9": ("block that slides and stops", "generalized alpha, event"),
    "P10": ("drop on a spring, two events", "RK67"),
    "P11": ("oscillator, fit to data", "extrapolated"),
    "P12": ("first-order system", "RK67"),
    "P13": ("planet, recorded user function", "RK67"),
    "P14": ("damped pendulum", "extrapolated"),
    "P15": ("slider-crank, free run", "extrapolated"),
    "P16": ("double pendulum", "extrapolated"),
    "P17": ("cart-pole with force levels", "extrapolated"),
    "P18": ("pendulum of one cable element", "extrapolated"),
    "P19 EP": ("heavy top, Euler parameters", "extrapolated"),
    "P19 Rxyz": ("heavy top, Tait-Bryan angles", "extrapolated"),
    "P19 RotVecLG": ("heavy top, Lie group", "extrapolated"),
    "P20": ("two-link arm, joint torques", "extrapolated"),
}


def error(problem: Problem, name: str, matrix: Any) -> float:
    _, derivatives = known(name, problem)
    return float(relative(problem, matrix - derivatives, derivatives).max())


def of_problem(name: str) -> tuple[Problem, Callable[[str], float]]:
    """Return a problem, and the error by method."""
    if name in MESHES:
        build, elements = MESHES[name]
        meshes = [build(elements), build(2 * elements)]
        return meshes[1], lambda method: error(
            meshes[1], name, limit_of([each.solve(method=method).matrix for each in meshes], order=4)
        )
    if name == "P8":
        problems = {side: absorber_problem(omega) for side, omega in FIXED_POINTS.items()}
        return problems[1], lambda method: max(
            error(each, f"P8 {side:+d}", each.solve(method=method).matrix) for side, each in problems.items()
        )
    problem = {**STATIC, **DYNAMIC, **EVENTS}[name]
    if name in EXPLICIT:
        explicit = replace(problem, solver=exu.DynamicSolverType.RK67, steps=EXPLICIT[name])
        return explicit, lambda method: error(explicit, name, explicit.solve(method=method).matrix)
    if name in STATIC or name in EVENTS:
        return problem, lambda method: error(problem, name, problem.solve(method=method).matrix)
    counts = (1, 2, 4) if name in FIRST_ORDER else (1, 2)

    def extrapolated(method: str) -> float:
        parts = [problem.solve(count * problem.steps, method=method).matrix for count in counts]
        if name in FIRST_ORDER:
            parts = [limit_of(list(pair), order=1) for pair in zip(parts[:-1], parts[1:], strict=True)]
        return error(problem, name, limit_of(parts, order=2))

    return problem, extrapolated


def seconds(function: Callable[[], Any]) -> float:
    best = np.inf
    for _ in range(ROUNDS):
        begin = time.process_time()
        function()
        best = min(best, time.process_time() - begin)
    return float(best)


def cost(problem: Problem) -> float:
    """Return the time of a solution with derivatives, in units of one without."""
    mbs, settings = problem.build(problem.numbers), problem.settings()
    settings.staticSolver.verboseMode = 0
    parameters = problem.parameters(problem.numbers)

    def solve() -> None:
        if problem.solver == "static":
            mbs.SolveStatic(settings)
        else:
            mbs.SolveDynamic(settings, solverType=problem.solver)

    def differentiate() -> None:
        mbs.ComputeSensitivities(parameters, problem.outputs, settings, problem.solver, "adjoint")

    return seconds(differentiate) / seconds(solve)


def main() -> None:
    rows = []
    for name, (title, how) in TITLES.items():
        problem, error_of = of_problem(name)
        errors = [error_of(method) for method in ("forward", "adjoint")]
        found = problem.solve(method="forward")
        sizes = f"{len(numbers_of(found))} x {len(problem.numbers)}"
        ratio = float(f"{cost(problem):.1g}")
        rows.append([name, title, sizes, how, *(f"{each:.0e}" for each in errors), f"{ratio:.0f}"])
        print(*rows[-1], sep=", ", flush=True)
    if len(sys.argv) > 1:
        with Path(sys.argv[1]).open("w", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(
                [["", "problem", "outputs x parameters", "compared", "forward", "adjoint", "cost"], *rows]
            )


if __name__ == "__main__":
    main()
