"""Scripts run once more for processors with less: what they print in registers of other widths."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np


def run_with_instructions(script: str, name: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"DALEMBERT_INSTRUCTIONS": name, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment)


def numbers_in_all_registers(script: str) -> list[list[np.ndarray]]:
    """Lines of hexadecimal numbers, as arrays: by portable code, with AVX2 and with AVX-512."""
    results = []
    for name in ("portable", "avx2", "avx512"):
        run = run_with_instructions(script, name)
        assert run.returncode == 0, run.stderr
        results.append([np.array([float.fromhex(x) for x in line.split()]) for line in run.stdout.splitlines()])
    return results
