"""Count the instructions that redundant constraints cost.

`python benchmarks/redundancy.py` compares Bricard's mechanism with the same one without an equation, from solver start
to end, and a regular four-bar linkage with itself without a search for redundancy; counted by callgrind, with
generalized alpha and two iterations per step.
"""

from __future__ import annotations

from pathlib import Path

from instructions import count_all

TESTS = Path(__file__).parents[1] / "tests"
SETUP = f"""
sys.path[:0] = [{str(TESTS / "models")!r}, {str(TESTS)!r}]
from test_bricard import Bricard
from test_four_bar import Bars
from solving import settings
def solution(model, steps, treat=True):
    s = settings(0.005 * steps, steps)
    s.redundantConstraints.treat = treat
    return lambda: model.mbs.SolveDynamic(s)
"""
STEPS = (50, 200)
PAIRS = {  # with and without
    "Bricard's mechanism, one of 30 equations redundant": ("Bricard({{}}), {0}", "Bricard({{5: 0}}), {0}"),
    "regular four-bar linkage, search for redundancy": ("Bars(1), {0}", "Bars(1), {0}, False"),
}


def main() -> None:
    """Count and print: what a solution costs more, and what each step does, without start and search."""
    cases = {
        f"{name} {steps} {i}": f"solution({models[i].format(steps)})"
        for name, models in PAIRS.items()
        for steps in STEPS
        for i in (0, 1)
    }
    counts = count_all(cases, SETUP)
    for name in PAIRS:
        few, many = ([counts[f"{name} {steps} {i}"] for i in (0, 1)] for steps in STEPS)
        changes = [*(x / y - 1 for x, y in (few, many)), (many[0] - few[0]) / (many[1] - few[1]) - 1]
        shown = (
            f"{steps} steps {100 * change:+.1f} %" for steps, change in zip((*STEPS, "further"), changes, strict=True)
        )
        print(f"{name}: {', '.join(shown)}")


if __name__ == "__main__":
    main()
