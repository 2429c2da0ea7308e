"""Count the instructions that redundant constraints cost.

`python benchmarks/redundancy.py` compares mechanisms with the same ones of which the redundant equations are freed, and
these with the same of which more equations are: what an equation costs that is not redundant is no cost of the
treatment. Besides, a regular four-bar linkage with itself without a search for redundancy. All from solver start to
end, counted by callgrind, with generalized alpha.

`python benchmarks/redundancy.py --time` compares the time of Bricard's mechanism with the mean of all that have one
equation less and are regular: it varies by a tenth with which one that is.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from instructions import count_all

TESTS = Path(__file__).parents[1] / "tests"
SETUP = f"""
sys.path[:0] = [{str(TESTS / "validation")!r}, {str(TESTS)!r}]
from redundant_models import ladder, platform
from test_bricard import Bricard
from test_four_bar import Bars
from solving import settings
def solution(mbs, steps, treat=True, size=0.002):
    s = settings(size * steps, steps)
    s.redundantConstraints.treat = treat
    return lambda: mbs.SolveDynamic(s)
"""
STEPS = (50, 200)
TIMED_STEPS = {200: 15, 1000: 8}  # and how often


@dataclass(frozen=True)
class Case:
    """Solutions with what is to be counted, without it, and without as much again, of which `share` is freed."""

    name: str
    solutions: tuple[str, ...]
    share: float = 1


CASES = (
    Case(
        "Bricard's mechanism, 1 of 30 equations redundant",
        ("Bricard({}).mbs, {steps}", "Bricard({5: 0}).mbs, {steps}", "Bricard({5: 0, 2: 3}).mbs, {steps}"),
    ),
    Case(
        "ladder of 50 loops in space, 150 of 755 equations redundant",
        tuple(f"ladder(50, {freed}), {{steps}}" for freed in range(3)),
    ),
    Case(
        "platform on six legs with double joints, 18 of 90 equations redundant",
        tuple(f"platform({freed}), {{steps}}" for freed in range(3)),
        share=1 / 3,
    ),
    Case("regular four-bar linkage, search for redundancy", ("Bars(1).mbs, {steps}", "Bars(1).mbs, {steps}, False")),
)


def main() -> None:
    """Count and print: what a solution costs more, and what each step does, without start and search."""
    counts = count_all(
        {
            f"{case.name} {steps} {i}": f"solution({text.replace('{steps}', str(steps))})"
            for case in CASES
            for i, text in enumerate(case.solutions)
            for steps in STEPS
        },
        SETUP,
    )
    for case in CASES:
        few, many = ([counts[f"{case.name} {steps} {i}"] for i in range(len(case.solutions))] for steps in STEPS)
        further = [y - x for x, y in zip(few, many, strict=True)]
        titles = (*(f"{steps} steps" for steps in STEPS), "further steps")
        print(
            f"{case.name}:",
            "; ".join(f"{t} {told(c, case.share)}" for t, c in zip(titles, (few, many, further), strict=True)),
        )


def told(counts: list[int], share: float) -> str:
    """Return what the first solution costs beyond the second, and how much of that equations would cost anyhow."""
    total = 100 * (counts[0] / counts[1] - 1)
    if len(counts) < 3:
        return f"{total:+.1f} %"
    equations = 100 * (1 - counts[2] / counts[1]) / share
    return f"{total:+.1f} % (as equations {equations:+.1f} %, as redundant ones {total - equations:+.1f} %)"


def compare_times() -> None:
    """Time and print: the least of several solutions of each mechanism, all in turn."""
    known: dict[str, Any] = {"sys": sys}
    exec(SETUP, known)
    bricard: Callable[[dict[int, int]], Any] = known["Bricard"]
    ways = [{joint: flag} for joint in range(6) for flag in range(5)]
    regular = [way for way in ways if bricard(way).mbs.ComputeSystemDegreeOfFreedom()["redundantConstraints"] == 0]
    for steps, times in TIMED_STEPS.items():
        least = [min(one) for one in zip(*(_seconds(known, [{}, *regular], steps) for _ in range(times)), strict=True)]
        changes = [100 * (least[0] / other - 1) for other in least[1:]]
        print(
            f"{steps} steps: {statistics.mean(changes):+.1f} % (mean of {len(changes)};"
            f" {min(changes):+.1f} to {max(changes):+.1f} %)"
        )


def _seconds(known: dict[str, Any], ways: list[dict[int, int]], steps: int) -> list[float]:
    seconds = []
    for way in ways:
        solve = known["solution"](known["Bricard"](way).mbs, steps, size=0.005)
        start = time.process_time()
        solve()
        seconds.append(time.process_time() - start)
    return seconds


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--time", action="store_true", help="measure times of Bricard's mechanism")
    compare_times() if parser.parse_args().time else main()
