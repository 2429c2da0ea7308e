"""What the tests of the generator share."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import pytest

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
    """A repository with the specs of this one and nothing generated."""
    shutil.copytree(root / "specs", tmp_path / "specs")
    if (root / "examples").exists():
        (tmp_path / "examples").symlink_to(root / "examples")
    return tmp_path
