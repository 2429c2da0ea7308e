"""Measure one case with one package: python measure.py MODULE CASE [--repeat N]. Prints one line of JSON."""

from __future__ import annotations

import argparse
import json
import time

from models import CASES, Package


def main() -> None:
    """Print the least time of all repetitions, per step, and the result of the last."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("module")
    parser.add_argument("case", choices=CASES)
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    package, case = Package.load(arguments.module), CASES[arguments.case]
    times = []
    for _ in range(arguments.repeat):
        job = case.build(package)
        start = time.perf_counter()
        job.solve()
        times.append(time.perf_counter() - start)
    print(json.dumps({"microseconds": 1e6 * min(times) / case.steps, "result": job.result()}))


if __name__ == "__main__":
    main()
