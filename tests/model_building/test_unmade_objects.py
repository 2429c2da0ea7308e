"""Objects of compiled classes that only __new__ has made: the process survives all operations on them."""

from __future__ import annotations

import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import dalembert as exu


def test_nothing_done_to_unmade_objects_ends_the_process() -> None:
    script = Path(__file__).parent / "use_unmade_objects.py"
    done = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, (done.stdout.splitlines()[-1:], done.stderr[-2000:])
    used = {line.split()[0] for line in done.stdout.splitlines()}
    assert {"MainSystem", "SystemContainer", "MainSolverStatic", "Vector3DList", "NodePoint", "MatrixContainer"} < used


@pytest.mark.parametrize("protocol", [0, 1])
def test_early_protocols_of_pickle(protocol: int) -> None:
    entries = pickle.loads(pickle.dumps(exu.Vector3DList([[1, 2, 3]]), protocol))
    assert entries[0].tolist() == [1, 2, 3]
    with pytest.raises(TypeError, match="cannot pickle 'MainSolverStatic' object"):
        pickle.dumps(exu.MainSolverStatic(), protocol)


@pytest.mark.parametrize("made", [exu.SystemContainer, exu.Vector3DList, exu.MainSolverStatic, exu.MatrixContainer])
def test_the_error_names_missing_parts(made: Any) -> None:
    empty = made.__new__(made)
    with pytest.raises(RuntimeError, match=r"the object is empty, because its __init__ was not called"):
        repr(empty)
    made.__init__(empty)
    assert repr(empty)
