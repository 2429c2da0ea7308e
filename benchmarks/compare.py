"""Print the table of benchmarks: python compare.py [--peer PYTHON] [CASE ...].

PYTHON is an interpreter with Exudyn installed; by default this one is tried. Without it the table has
the times of dalembert alone. Each measurement is a process of its own; the packages take turns.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from models import CASES

HERE = Path(__file__).parent
ONE_THREAD = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}


def printed_by(python: str, script: str, *arguments: str) -> dict[str, Any] | None:
    """Run one measurement and return what it prints as JSON; None if the package cannot be run."""
    command = [python, str(HERE / script), *arguments]
    run = subprocess.run(command, capture_output=True, text=True, env=os.environ | ONE_THREAD, check=False)
    if run.returncode != 0:
        print(run.stderr.strip().splitlines()[-1], file=sys.stderr)
        return None
    return dict(json.loads(run.stdout.splitlines()[-1]))


def has_peer(python: str) -> bool:
    """Tell whether that interpreter has Exudyn."""
    return subprocess.run([python, "-c", "import exudyn"], capture_output=True, check=False).returncode == 0


def line(case: str, ours: dict[str, Any] | None, peer: dict[str, Any] | None) -> str:
    """Return one line of the table: times per step in microseconds, ratio and relative difference of the results."""
    text = (
        f"{CASES[case].title:40s} {ours['microseconds']:12.2f}" if ours else f"{CASES[case].title:40s} {'failed':>12s}"
    )
    if ours and peer:
        difference = abs(ours["result"] - peer["result"]) / max(abs(peer["result"]), 1e-300)
        text += f" {peer['microseconds']:12.2f} {peer['microseconds'] / ours['microseconds']:8.1f} {difference:10.0e}"
    return text


def main() -> None:
    """Measure the chosen cases and print the table as it grows."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*", metavar="CASE", help=", ".join(CASES))
    parser.add_argument("--peer", default=sys.executable, help="interpreter with exudyn")
    parser.add_argument("--repeat", type=int, default=3)
    arguments = parser.parse_args()
    with_peer = has_peer(arguments.peer)
    columns = ["dalembert us", "exudyn us", "ratio", "difference"] if with_peer else ["dalembert us"]
    print(f"{'time per step':40s} " + " ".join(f"{c:>{w}s}" for c, w in zip(columns, (12, 12, 8, 10), strict=False)))
    for case in arguments.cases or CASES:
        options = (case, "--repeat", str(arguments.repeat))
        ours = printed_by(sys.executable, "measure.py", "dalembert", *options)
        peer = printed_by(arguments.peer, "measure.py", "exudyn", *options) if with_peer else None
        print(line(case, ours, peer), flush=True)


if __name__ == "__main__":
    main()
