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
from pathlib import Path

HERE = Path(__file__).parent
# Counts are not to depend on the processor, nor on which blocks the C library clears and copies by an instruction that
# repeats itself: callgrind counts one for each byte.
SETTINGS = {
    "PYTHONHASHSEED": "0",
    "OPENBLAS_NUM_THREADS": "1",
    "DALEMBERT_INSTRUCTIONS": "portable",
    "GLIBC_TUNABLES": "glibc.cpu.x86_rep_stosb_threshold=0x7fffffff:glibc.cpu.x86_rep_movsb_threshold=0x7fffffff",
}
STORED = HERE / "instructions.json"
TOLERANCE = 0.05  # compilers differ by a few percent between their releases
CASES = {
    "oscillator": "oscillator(p, 2000).solve",
    "top": "top(p, 100).solve",
    "chain": "chain(p, 10, 20).solve",
    "net": "grid(p, 10, 50, 'VelocityVerlet').solve",
    "cable": "cable(p, 20, 20).solve",
}


SETUP = 'from models import *; p = Package.load("dalembert")'
# What takes longest is the start: processes for the cases branch off after it.
SCRIPT = """
import json, os, sys
exec(sys.argv[2])
processes = {}
for name, job in json.loads(sys.argv[1]).items():
    processes[name] = os.fork()
    if not processes[name]:
        eval(job)()
        os._exit(0)
failed = [name for name, process in processes.items() if os.waitpid(process, 0)[1]]
json.dump(processes, sys.stdout) if not failed else sys.exit(f"these fail: {failed}")
"""


def count_all(cases: dict[str, str] = CASES, setup: str = SETUP) -> dict[str, int]:
    """Return the instructions of each solve, in a process of its own; cases give functions, after `setup`."""
    with tempfile.TemporaryDirectory() as folder:
        command = [
            "valgrind",
            "--tool=callgrind",
            "--collect-atstart=no",
            "--toggle-collect=dalembert::Solver::solve_system*",
            f"--callgrind-out-file={folder}/%p",
            sys.executable,
            "-c",
            SCRIPT,
            json.dumps(cases),
            setup,
        ]
        environment = os.environ | SETTINGS
        run = subprocess.run(command, capture_output=True, text=True, cwd=HERE, env=environment, check=False)
        if run.returncode != 0:
            raise RuntimeError(run.stderr)
        counts = {}
        for name, process in json.loads(run.stdout.splitlines()[-1]).items():
            found = re.search(r"^summary: (\d+)$", Path(folder, str(process)).read_text(), re.MULTILINE)
            if found is None:
                raise RuntimeError(f"no instructions were counted for {name}")
            counts[name] = int(found[1])
    return counts


def main() -> int:
    """Count, print, and compare or store."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="store the counts")
    arguments = parser.parse_args()
    if shutil.which("valgrind") is None:
        print("valgrind is not installed: nothing was counted")
        return 0
    counts = count_all()
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
