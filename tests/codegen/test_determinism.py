"""Same specs, same bytes: independently of the working directory, the hash seed and the order of the directory."""

from __future__ import annotations

import hashlib
import os
import subprocess
import sys
from pathlib import Path

DIGEST = """
import hashlib, sys
sys.path.insert(0, sys.argv[1])
from pathlib import Path
from codegen.load import load
from codegen.render import render
print(hashlib.sha256(repr(sorted(render(load(Path(sys.argv[1]))).items())).encode()).hexdigest())
"""


def digest(root: Path, directory: Path, seed: str) -> str:
    command = [sys.executable, "-c", DIGEST, str(root)]
    environment = {**os.environ, "PYTHONHASHSEED": seed, "TZ": "Asia/Tokyo" if seed == "1" else "UTC"}
    return subprocess.run(command, cwd=directory, env=environment, check=True, capture_output=True, text=True).stdout


def test_output_does_not_depend_on_hash_seed_or_directory(root: Path, tmp_path: Path) -> None:
    first = digest(root, root, "1")
    assert len(first.strip()) == len(hashlib.sha256().hexdigest())
    assert digest(root, tmp_path, "2") == first


def test_no_machine_paths_in_generated_files(root: Path) -> None:
    for path in (root / "generated").rglob("*"):
        if path.is_file():
            assert str(root) not in path.read_text(), path
