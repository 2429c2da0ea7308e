"""Shared fixtures of the tests of items and systems."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
if str(ROOT) not in sys.path:
    sys.path.insert(0, str(ROOT))

import dalembert as exu


@pytest.fixture
def mbs() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()
