"""Print what threads gain: python threads.py [--threads N].

Evaluations of large models by one thread and by several (parallel.numberOfThreads), in turn, and the least times of all
repetitions. Results are compared bit for bit. The last lines are yardsticks: what the machine gives to threads that
have nothing in common but its caches and its memory.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import models
import numpy as np
from models import Job, Package

# What the solver calls its parts.
RHS, RESIDUAL, TANGENT = (
    ("right-hand side", "ODE2RHS"),
    ("residual", "ODE2RHS"),
    ("tangent", "totalJacobian"),
)

MEGABYTES = 60  # beyond the caches


@dataclass(frozen=True)
class Model:
    """A model of 10 000 items of the kind that its title says, and the parts of its solution to be measured."""

    title: str
    build: Callable[[Package], Job]
    parts: tuple[tuple[str, str], ...]


MODELS = (
    Model("net of 10 000 points, velocity Verlet", lambda p: models.grid(p, 100, 300, "VelocityVerlet"), (RHS,)),
    Model("net of 10 000 points, implicit", lambda p: models.grid(p, 100, 20, "GeneralizedAlpha"), (RESIDUAL, TANGENT)),
    Model("chain of 10 000 rigid bodies, implicit", lambda p: models.chain(p, 10_000, 20), (RESIDUAL, TANGENT)),
    Model("cable of 10 000 ANCF elements, implicit", lambda p: models.cable(p, 10_000, 20), (RESIDUAL, TANGENT)),
)


def measured(package: Package, model: Model, threads: int) -> tuple[list[float], float]:
    """Return the seconds of all parts, and the result."""
    job = model.build(package)
    job.settings.parallel.numberOfThreads = threads
    job.settings.displayComputationTime = True  # parts are timed only then
    job.solve()
    return [getattr(job.timer(), part) for _, part in model.parts], job.result()


def yardstick_times(work: Callable[[int], object], threads: int, repeat: int) -> tuple[float, float]:
    """Return the least seconds in which one thread, and several, do `work(i)` for as many i as there are threads."""

    def seconds(run: Callable[[], object]) -> float:
        start = time.perf_counter()
        run()
        return time.perf_counter() - start

    with ThreadPoolExecutor(threads) as pool:
        times = [
            (seconds(lambda: [work(i) for i in range(threads)]), seconds(lambda: list(pool.map(work, range(threads)))))
            for _ in range(repeat)
        ]
    return min(one for one, _ in times), min(more for _, more in times)


def print_yardsticks(threads: int) -> None:
    """Print what threads gain that share nothing: neither function holds the interpreter's lock."""
    lists = [np.ones(MEGABYTES * 2**20 // 8) for _ in range(threads)]

    def scale(i: int) -> None:
        np.multiply(lists[i], 1 + 1e-9, out=lists[i])

    def digest(i: int) -> bytes:
        return hashlib.sha256(lists[i][: 2**20]).digest()

    print_line("arithmetic alone, SHA-256 of 8 MB per thread", *yardstick_times(digest, threads, 20))
    print_line(f"{MEGABYTES} MB per thread in memory, read and written", *yardstick_times(scale, threads, 20))


def print_line(title: str, one: float, more: float) -> None:
    """Print one line of the table, from seconds."""
    print(f"{title:58s}{1e3 * one:10.1f}{1e3 * more:12.1f}{one / more:8.2f}", flush=True)


def main() -> None:
    """Measure all models and print the table as it grows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--threads", type=int, default=os.cpu_count())
    parser.add_argument("--repeat", type=int, default=5)
    arguments = parser.parse_args()
    package = Package.load("dalembert")
    print(f"{'milliseconds in all':58s}{'1 thread':>10s}{f'{arguments.threads} threads':>12s}{'ratio':>8s}")
    for model in MODELS:
        times: dict[int, list[list[float]]] = {1: [], arguments.threads: []}
        results = set()
        for _ in range(arguments.repeat):
            for threads, runs in times.items():
                seconds, result = measured(package, model, threads)
                runs.append(seconds)
                results.add(result)
        if len(results) > 1:
            raise RuntimeError(f"{model.title}: results differ: {results}")
        for (part, _), one, more in zip(
            model.parts, *([min(column) for column in zip(*runs, strict=True)] for runs in times.values()), strict=True
        ):
            print_line(f"{model.title}, {part}", one, more)
    print_yardsticks(arguments.threads)


if __name__ == "__main__":
    main()
