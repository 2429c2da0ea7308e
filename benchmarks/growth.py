"""Print how times grow with the size of a model: python growth.py [FAMILY ...].

Times are those of one iteration of Newton's method or, of explicit methods, of one step; what a solver does once,
before its first step, is not part of them. The exponent p is that of the fit time = c N^p between 100 and 10 000
bodies, nodes or elements: 1 is linear growth.
"""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import models
import numpy as np
from models import Job, Package


@dataclass(frozen=True)
class Family:
    """Models of one kind: `build` makes the one of about N bodies, nodes or elements, which takes so many steps."""

    title: str
    build: Callable[[Package, int, int], Job]
    work: int  # steps times N


def _side(nodes: int) -> int:
    return max(2, round(math.sqrt(nodes)))


FAMILIES = {
    "chain": Family("chain of rigid bodies, full Newton", models.chain, 20_000),
    "net": Family(
        "net, velocity Verlet", lambda p, n, steps: models.grid(p, _side(n), steps, "VelocityVerlet"), 1_000_000
    ),
    "cable": Family("cable of ANCF elements, full Newton", models.cable, 100_000),
}
SIZES = (10, 100, 1000, 10_000)


def solved(package: Package, family: Family, size: int, steps: int) -> tuple[float, int]:
    """Return the time of one solution in seconds, and how many iterations or steps it has taken."""
    job: Any = family.build(package, size, steps)
    start = time.perf_counter()
    job.solve()
    return time.perf_counter() - start, job.iterations() or steps


def time_of_iteration(package: Package, family: Family, size: int, repeat: int) -> float:
    """Return the time of an iteration after the first step in microseconds, from the least times of all repetitions."""
    steps = max(20, family.work // size)
    (one, before), (more, after) = (min(solved(package, family, size, n) for _ in range(repeat)) for n in (1, steps))
    return 1e6 * (more - one) / (after - before)


def main() -> None:
    """Measure the chosen families and print the table as it grows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("families", nargs="*", metavar="FAMILY", help=", ".join(FAMILIES))
    parser.add_argument("--module", default="dalembert")
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    package = Package.load(arguments.module)
    print(f"{'microseconds, N =':40s}" + "".join(f"{size:>12d}" for size in SIZES) + f"{'exponent':>12s}")
    for name in arguments.families or FAMILIES:
        family = FAMILIES[name]
        times = [time_of_iteration(package, family, size, arguments.repeat) for size in SIZES]
        exponent = np.polyfit(np.log(SIZES[1:]), np.log(times[1:]), 1)[0]
        print(f"{family.title:40s}" + "".join(f"{t:12.1f}" for t in times) + f"{exponent:12.2f}", flush=True)


if __name__ == "__main__":
    main()
