"""Count the instructions that redundant constraints cost.

`python benchmarks/redundancy.py` compares mechanisms with the same ones of which the redundant equations are freed, and
these with the same of which more equations are: what an equation costs that is not redundant is no cost of the
treatment. Besides, a regular four-bar linkage with itself without a search for redundancy. All from solver start to
end, counted by callgrind, with generalized alpha.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from instructions import count_all

TESTS = Path(__file__).parents[1] / "tests"
SETUP = f"""
sys.path[:0] = [{str(TESTS / "models")!r}, {str(TESTS)!r}]
from redundant_models import ladder, platform
from test_bricard import Bricard
from test_four_bar import Bars
from solving import settings
def solution(mbs, steps, treat=True):
    s = settings(0.002 * steps, steps)
    s.redundantConstraints.treat = treat
    return lambda: mbs.SolveDynamic(s)
"""
STEPS = (50, 200)


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


if __name__ == "__main__":
    main()
