"""Scripts run once more for processors with less: their output in registers of other widths."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest

from dalembert._core import testing

each_width = pytest.mark.parametrize("wide", ["avx2", "avx512"])
USED = """
from dalembert._core import testing
print(testing.instruction_sets()[0])
"""


def run_with_instructions(script: str, name: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"DALEMBERT_INSTRUCTIONS": name, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    return subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment)


def numbers_in_registers(script: str, name: str) -> list[np.ndarray]:
    """Lines of hexadecimal numbers, as arrays; skips the test, with the reason, where the processor has no such registers."""
    if name not in testing.instruction_sets():
        pytest.skip(f"this processor, or DALEMBERT_INSTRUCTIONS, has no {name}: nothing is compared")
    run = run_with_instructions(USED + script, name)
    assert run.returncode == 0, run.stderr
    used, *lines = run.stdout.splitlines()
    assert used == name
    return [np.array([float.fromhex(x) for x in line.split()]) for line in lines]
