"""Runs of the examples, each in its own folder below docs/_generated/examples: pages show the results, tests check
them.

An example is run again if it, a file with the same stem or the package has changed.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterable
from functools import cache
from importlib.util import find_spec
from pathlib import Path

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
RUNS = ROOT / "docs/_generated/examples"


def stamps(files: Iterable[Path]) -> str:
    lines = sorted(f"{path} {path.stat().st_size} {path.stat().st_mtime_ns}" for path in files if path.is_file())
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


@cache
def package_stamp() -> str:
    package = Path(find_spec("dalembert").origin).parent
    return stamps(path for path in package.rglob("*") if path.suffix in (".py", ".so", ".pyd", ".json"))


def run(path: Path) -> Path:
    """Run an example if need be; return its folder, with its pictures and printed.txt. RuntimeError, if it fails."""
    folder = RUNS / path.stem
    state = f"{package_stamp()} {stamps(path.parent.glob(f'{path.stem}.*'))}"
    done = folder / "done.txt"
    if done.exists() and done.read_text("utf-8") == state:
        return folder
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    environment = os.environ | {"MPLBACKEND": "Agg"}
    result = subprocess.run(
        [sys.executable, str(path)], cwd=folder, env=environment, capture_output=True, text=True, check=False
    )
    if result.returncode != 0:
        raise RuntimeError(f"{path.name} fails: {result.stdout}{result.stderr}")
    (folder / "printed.txt").write_text(result.stdout, "utf-8")
    done.write_text(state, "utf-8")
    return folder
