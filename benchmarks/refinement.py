"""Errors against the size of the step at the default tolerances of Newton's method, and what it leaves of them.

`python benchmarks/refinement.py docs/data/refinement.csv` writes the table of the documentation: for numbers of steps
that are multiplied by four, the error of the coordinates at the end, that error with tolerances of 1e-12, and the
iterations per step of either. References are extrapolated from the two finest solutions with tight tolerances.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests/validation"))

import models
import test_andrews as andrews
import test_four_bar as four_bar
import test_governor as governor
import test_pendulum as pendulum
from bicycle import Bicycle

import dalembert as exu
from dalembert import utilities

HEADER = ("model", "step (ms)", "error", "error, 1e-12", "iterations", "iterations, 1e-12")
PACKAGE = models.Package.load("dalembert")
TIGHT = 1e-12
FACTOR = 4  # between numbers of steps: errors fall to a sixteenth


class Case(NamedTuple):
    model: str
    build: Callable[[], exu.MainSystem]
    end: float  # s
    coarsest: int  # number of steps
    solver: exu.DynamicSolverType = exu.DynamicSolverType.GeneralizedAlpha
    modified_newton: bool = False
    levels: int = 4


def rotor() -> exu.MainSystem:
    """A disc with a small eccentricity between two elastic bearings, driven through its resonance from rest."""
    mbs = exu.SystemContainer().AddSystem()
    mass, radius, length, offset = 2.0, 0.75, 1.0, 1.5e-3
    polar, cross = mass * radius**2 / 2, mass * (radius**2 / 4 + 0.2**2 / 12)
    disc = mbs.CreateRigidBody(
        referencePosition=[0, offset, 0],
        inertia=utilities.RigidBodyInertia(mass, np.diag([polar, cross, cross])),
        nodeType=exu.NodeType.RotationEulerParameters,
    )
    ground = mbs.CreateGround()
    for side in (-0.5, 0.5):
        place = [side * length, 0, 0]
        markers = [
            mbs.AddMarker(utilities.MarkerBodyPosition(bodyNumber=ground, localPosition=place)),
            mbs.AddMarker(utilities.MarkerBodyPosition(bodyNumber=disc, localPosition=[place[0], -offset, 0])),
        ]
        along = float(side < 0)
        mbs.AddObject(
            utilities.CartesianSpringDamper(
                markerNumbers=markers, stiffness=[800 * along, 800, 800], damping=[0.25 * along, 0.25, 0.25]
            )
        )
    drive = mbs.AddMarker(utilities.MarkerBodyRigid(bodyNumber=disc))
    mbs.AddLoad(utilities.Torque(markerNumber=drive, loadVector=[0.4, 0, 0]))
    mbs.Assemble()
    return mbs


def squeezer() -> exu.MainSystem:
    return andrews.Squeezer().mbs


def spun_governor() -> exu.MainSystem:
    return governor.Governor("NodeRigidBodyEP").mbs


TRAPEZOIDAL = exu.DynamicSolverType.TrapezoidalIndex2
CASES = (
    Case("Spinning top", lambda: models.top(PACKAGE, 1).mbs, 0.2, 500),
    Case("Chain of 10 bodies", lambda: models.chain(PACKAGE, 10, 1).mbs, 0.2, 200),
    Case(
        "Chain of 10 bodies, modified Newton", lambda: models.chain(PACKAGE, 10, 1).mbs, 0.2, 200, modified_newton=True
    ),
    Case("Net of 10 x 10", lambda: models.grid(PACKAGE, 10, 1, "GeneralizedAlpha").mbs, 0.05, 25),
    Case("Cable of 10 elements", lambda: models.cable(PACKAGE, 10, 1).mbs, 0.2, 200),
    Case(
        "Cable of 10 elements, modified Newton",
        lambda: models.cable(PACKAGE, 10, 1).mbs,
        0.2,
        200,
        modified_newton=True,
    ),
    Case("A01 pendulum", lambda: pendulum.rod("NodeRigidBodyEP")[0], 1.0, 125),
    Case("A02 four-bar with two loops", lambda: four_bar.Bars(2).mbs, 1.0, 125),
    Case("A03 Andrews' squeezer", squeezer, 0.03, 1000, levels=3),
    Case("A05 governor", spun_governor, 0.5, 125),
    Case("Bicycle, trapezoidal rule", lambda: Bicycle(4.6, 0.5).mbs, 1.0, 250, TRAPEZOIDAL),
    Case("Rotor run-up, trapezoidal rule", rotor, 20.0, 4000, TRAPEZOIDAL),
)


def solve(case: Case, steps: int, tolerance: float | None = None) -> tuple[np.ndarray, float]:
    """Return coordinates at the end and iterations per step."""
    mbs = case.build()
    s = exu.SimulationSettings()
    s.timeIntegration.endTime, s.timeIntegration.numberOfSteps = case.end, steps
    s.timeIntegration.verboseMode = 0
    s.timeIntegration.newton.useModifiedNewton = case.modified_newton
    s.solutionSettings.writeSolutionToFile = False
    s.solutionSettings.sensorsWritePeriod = case.end
    if tolerance is not None:
        s.timeIntegration.newton.relativeTolerance = tolerance
        s.timeIntegration.newton.absoluteTolerance = 1e-2 * tolerance  # as the defaults
    mbs.SolveDynamic(s, solverType=case.solver)
    return mbs.systemData.GetODE2Coordinates(), mbs.sys["dynamicSolver"].it.newtonStepsCount / steps


def rows(case: Case) -> Iterator[tuple[str, ...]]:
    """Lines of the table, as texts; the name of a model stands in its first line only."""
    counts = [case.coarsest * FACTOR**level for level in range(case.levels)]
    tight = [solve(case, steps, TIGHT) for steps in counts]
    (coarse, _), (fine, _) = tight[-2:]
    exact = fine + (fine - coarse) / (FACTOR**2 - 1)
    for steps, (precise, most) in zip(counts, tight, strict=True):
        found, iterations = solve(case, steps)
        errors = (float(np.linalg.norm(q - exact)) for q in (found, precise))
        name = case.model if steps == case.coarsest else ""
        yield (name, f"{1e3 * case.end / steps:.3g}", *(f"{e:.2e}" for e in errors), f"{iterations:.2f}", f"{most:.2f}")


if __name__ == "__main__":
    with open(sys.argv[1], "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(HEADER)
        for case in CASES:
            writer.writerows(rows(case))
            file.flush()
