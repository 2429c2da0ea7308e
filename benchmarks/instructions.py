"""Compare the instructions that five small solves need with those stored beside this file.

python instructions.py [--write]

Counted by valgrind's callgrind, from the solver's start to its end: repeatable where times are not. A count beyond the
tolerance, in either direction, fails: a slow-down is to be mended, a gain to be stored with --write.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).parent
# Counts are not to depend on the processor.
SETTINGS = {"PYTHONHASHSEED": "0", "OPENBLAS_NUM_THREADS": "1", "DALEMBERT_INSTRUCTIONS": "portable"}
STORED = HERE / "instructions.json"
TOLERANCE = 0.05  # compilers differ by a few percent between their releases
CASES = {
    "oscillator": "oscillator(p, 2000)",
    "top": "top(p, 100)",
    "chain": "chain(p, 10, 20)",
    "net": "grid(p, 10, 50, 'VelocityVerlet')",
    "cable": "cable(p, 20, 20)",
}


def counted(job: str) -> int:
    """Return the instructions of one solve, in a process of its own."""
    script = f"from models import *\np = Package.load('dalembert')\n{job}.solve()\n"
    with tempfile.TemporaryDirectory() as folder:
        command = [
            "valgrind",
            "--tool=callgrind",
            "--collect-atstart=no",
            "--toggle-collect=dalembert::Solver::solve_system*",
            f"--callgrind-out-file={folder}/counts",
            sys.executable,
            "-c",
            script,
        ]
        environment = os.environ | SETTINGS
        run = subprocess.run(command, capture_output=True, text=True, cwd=HERE, env=environment, check=False)
        found = re.search(r"Collected : (\d+)", run.stderr)
        if run.returncode != 0 or found is None:
            raise RuntimeError(run.stderr)
    return int(found[1])


def main() -> int:
    """Count, print, and compare or store."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="store the counts")
    arguments = parser.parse_args()
    if shutil.which("valgrind") is None:
        print("valgrind is not installed: nothing was counted")
        return 0
    with ThreadPoolExecutor(os.cpu_count()) as together:  # counts do not depend on what else runs
        counts = dict(zip(CASES, together.map(counted, CASES.values()), strict=True))
    if arguments.write:
        STORED.write_text(json.dumps(counts, indent=2) + "\n")
    stored = json.loads(STORED.read_text())
    failures = 0
    for name, count in counts.items():
        change = count / stored[name] - 1
        failures += abs(change) > TOLERANCE
        print(f"{name:12s} {count:12d} instructions, {100 * change:+6.1f} % against {stored[name]}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
