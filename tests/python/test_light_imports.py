"""The lines that each model begins with load no library that few models need."""

from __future__ import annotations

import subprocess
import sys

import pytest

HEAVY = ("scipy", "matplotlib", "PIL", "asyncio", "websockets", "h5py", "sympy", "gymnasium")


@pytest.mark.parametrize(
    "line",
    [
        "import dalembert",
        "import dalembert.itemInterface",
        "from dalembert.utilities import *",
        "from dalembert.beams import *",
        "import dalembert.plot, dalembert.graphics, dalembert.solver, dalembert.rigidBodyUtilities",
    ],
)
def test_heavy_libraries_are_not_loaded(line: str) -> None:
    script = f"import sys; {line}; print(*sorted({set(HEAVY)} & set(sys.modules)))"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.split() == []
