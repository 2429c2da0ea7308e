"""Repositories that tests write into."""

import shutil
from pathlib import Path


def bare_repository(root: Path, folder: Path) -> Path:
    """Make of a folder a repository with the specs of this one and nothing generated."""
    shutil.copytree(root / "specs", folder / "specs")
    if (root / "examples").exists():
        (folder / "examples").symlink_to(root / "examples")
    return folder
