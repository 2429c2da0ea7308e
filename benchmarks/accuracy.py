"""Errors of published benchmarks against the size of the step, with the models and references of tests/validation.

`python benchmarks/accuracy.py docs/data/accuracy.csv` writes the table of the documentation: quantity by quantity, for
numbers of steps that are doubled three times, the error against an independent solution, and the order observed
between a row and the one above it.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

sys.path.extend(str(Path(__file__).parents[1] / folder) for folder in ("", "tests/validation", "tests/items"))

import test_andrews as andrews
import test_bicycle as bicycle
import test_bricard as bricard
import test_four_bar as four_bar
import test_governor as governor
import test_heavy_top as heavy_top
import test_kinematic_tree as kinematic_tree
import test_pendulum as pendulum
import test_spatial_slider_crank as slider_crank
from solving import Variable, settings

HEADER = ("benchmark", "error of", "step (ms)", "error", "order")


class Case(NamedTuple):
    benchmark: str
    quantity: str
    end: float  # s
    coarsest: int  # number of steps
    error: Callable[[int], Any]
    order: int = 2  # of the method


def pendulum_error(steps: int) -> Any:
    mbs, position = pendulum.rod("NodeRigidBodyEP")
    mbs.SolveDynamic(settings(10.0, steps))
    return position() - pendulum.exact(10.0)


def four_bar_error(steps: int) -> Any:
    bars = four_bar.Bars(2)
    bars.mbs.SolveDynamic(settings(10.0, steps))
    return bars.tip_output(Variable.Position) - four_bar.PUBLISHED[10]


def andrews_error(steps: int) -> Any:
    return andrews.final(steps) - andrews.angles(andrews.END)


def governor_error(steps: int) -> Any:
    return governor.final("NodeRigidBodyEP", 1.0, steps) - governor.heights_of_slider()[1.0]


def slider_crank_error(steps: int) -> Any:
    return slider_crank.final(1.0, steps) - slider_crank.reference()[1.0]


def top_error(node: str, scheme: str, k: int) -> Callable[[int], Any]:
    wanted = (heavy_top.POSITION, heavy_top.OMEGA, heavy_top.axis_motion(1.0)[2])[k]
    return lambda steps: heavy_top.top(node, scheme, steps)[k] - wanted


def capsize_error(steps: int) -> Any:
    """The steps are those of a period of 60 ms."""
    return bicycle.eigenvalues(5.0, steps)[-1] - bicycle.PUBLISHED[5.0][-1]


def bricard_error(steps: int) -> Any:
    """One equation of the sixth joint, which the others make redundant, is left out."""
    return bricard.final({5: 0}, 1.0, steps) - bricard.third_corners()[1.0]


def chain_error(steps: int) -> Any:
    tip = kinematic_tree.tip_of_chain(0.0, 0.5, steps, kinematic_tree.Solver.RK44)
    return tip - kinematic_tree.TIP_OF_CHAIN[0.0, 0.5]


def branched_tree_error(steps: int) -> Any:
    found = kinematic_tree.motion_of_branched_tree(1.0, steps, kinematic_tree.Solver.GeneralizedAlpha)
    return found - kinematic_tree.MOTION_OF_BRANCHED[1.0]


TOP = ("position (m)", "angular velocity (rad/s)", "force of the joint (N)")
NODES = (("Euler parameters", "NodeRigidBodyEP", ""), ("rotation vectors", "NodeRigidBodyRotVecLG", "default"))
CASES = (
    Case("A01 pendulum, 10 s", "position (m)", 10.0, 1250, pendulum_error),
    Case("A02 four-bar with two loops, 10 s", "position (m)", 10.0, 2500, four_bar_error),
    Case("A03 Andrews' squeezer, 30 ms", "angles (rad)", 0.03, 1000, andrews_error),
    Case("A04 Bricard, 1 s", "position (m)", 1.0, 125, bricard_error),
    Case("A05 governor, 1 s", "height (m)", 1.0, 250, governor_error),
    Case("Spatial slider-crank, 1 s", "position (m)", 1.0, 500, slider_crank_error),
    Case("Bicycle at 5 m/s", "capsize eigenvalue (1/s)", 0.06, 60, capsize_error),
    Case("Kinematic tree: chain of ten rods, 0.5 s, RK44", "position (m)", 0.5, 25, chain_error, 4),
    Case("Kinematic tree of six branched links, 1 s", "coordinates (rad, m)", 1.0, 250, branched_tree_error),
    *(
        Case(f"Heavy top, 1 s, {name}", quantity, 1.0, 1000, top_error(node, scheme, k))
        for name, node, scheme in NODES
        for k, quantity in enumerate(TOP)
    ),
)


def rows(levels: int = 4) -> Iterator[tuple[str, ...]]:
    """Lines of the table, as texts; the names of a case stand in its first line only."""
    for case in CASES:
        before = None
        for level in range(levels):
            steps = case.coarsest * 2**level
            error = float(np.linalg.norm(case.error(steps)))
            names = (case.benchmark, case.quantity) if before is None else ("", "")
            order = "" if before is None else f"{np.log2(before / error):.2f}"
            yield (*names, f"{1e3 * case.end / steps:.3g}", f"{error:.2e}", order)
            before = error


if __name__ == "__main__":
    with open(sys.argv[1], "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([HEADER, *rows()])
