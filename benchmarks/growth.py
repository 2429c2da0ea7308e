"""Print how the time per step grows with the size of a model: python growth.py [FAMILY ...].

The exponent p is that of the fit time = c N^p between 100 and 10 000 bodies, nodes or elements: 1 is linear growth.
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


def time_per_step(package: Package, family: Family, size: int, repeat: int) -> float:
    """Return the least time per step of all repetitions, in microseconds."""
    steps = max(2, family.work // size)
    times = []
    for _ in range(repeat):
        job: Any = family.build(package, size, steps)
        start = time.perf_counter()
        job.solve()
        times.append(time.perf_counter() - start)
    return 1e6 * min(times) / steps


def main() -> None:
    """Measure the chosen families and print the table as it grows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("families", nargs="*", metavar="FAMILY", help=", ".join(FAMILIES))
    parser.add_argument("--module", default="dalembert")
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    package = Package.load(arguments.module)
    print(f"{'microseconds per step, N =':40s}" + "".join(f"{size:>12d}" for size in SIZES) + f"{'exponent':>12s}")
    for name in arguments.families or FAMILIES:
        family = FAMILIES[name]
        times = [time_per_step(package, family, size, arguments.repeat) for size in SIZES]
        exponent = np.polyfit(np.log(SIZES[1:]), np.log(times[1:]), 1)[0]
        print(f"{family.title:40s}" + "".join(f"{t:12.1f}" for t in times) + f"{exponent:12.2f}", flush=True)


if __name__ == "__main__":
    main()
