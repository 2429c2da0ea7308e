"""Systems that are built, changed, copied, solved and read in random order: none crashes, none changes another one."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random

import pytest
from session import run, some_steps


@pytest.mark.parametrize("seed", range(100))
def test_any_order(seed: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    steps = some_steps(Random(seed))
    try:
        run(steps)
    except BaseException as error:
        error.add_note(f"to see the calls: python tests/stateful/hunt.py --replay '{json.dumps(steps)}'")
        raise
