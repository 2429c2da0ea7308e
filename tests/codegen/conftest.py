"""Shared fixtures of the generator's tests."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from repositories import bare_repository

ROOT = Path(__file__).parents[2]
if str(ROOT) not in sys.path:
    sys.path.insert(0, str(ROOT))

from codegen.load import load
from codegen.model_settings import Specs


@pytest.fixture(scope="session")
def specs() -> Specs:
    return load(ROOT)


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture
def copy(root: Path, tmp_path: Path) -> Path:
    return bare_repository(root, tmp_path)
