"""The headers that items can include, for the build: their hash, and the files that item packages are built from.

`python codegen/headers.py stamp FILE` writes a C++ source with the hash, `python codegen/headers.py copy DIRECTORY`
copies headers, sources, specs and the generator. The directory then has the structure of the repository. Needs the
standard library only.
"""

from __future__ import annotations

import hashlib
import re
import shutil
import sys
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
INCLUDES = ("core/include", "generated/include")
# What kernels and generated sources include; all else follows.
STARTS = ("batches", "contracts", "frames.hpp", "items", "laws", "reflection")
SUPPORT = "core/packages/support.cpp"
# Sources of the core that packages compile: those of every package, and those of folders of items.
SOURCES = ("core/src/math/large_memory.cpp", "core/src/system/term.cpp")
FURTHER_SOURCES = {
    "markers": ("core/src/batches/inner_markers.cpp", "core/src/batches/marker.cpp", "core/src/system/ports.cpp"),
    "super_elements": (
        *("core/src/batches/mesh_place.cpp", "core/src/batches/sized_law.cpp", "core/src/contracts/square_matrix.cpp"),
    ),
}
_INCLUDE = re.compile(r'^#include "(.+)"', re.MULTILINE)


def headers(root: Path = ROOT) -> dict[str, Path]:
    """The headers by the names with which they are included, in alphabetical order."""
    found: dict[str, Path] = {}
    open_names = [
        file.relative_to(root / INCLUDES[0]).as_posix()
        for start in STARTS
        for file in sorted((root / INCLUDES[0] / "dalembert" / start).rglob("*.hpp"))
        or [root / INCLUDES[0] / "dalembert" / start]
    ]
    while open_names:
        name = open_names.pop()
        if name in found:
            continue
        found[name] = next(path for include in INCLUDES if (path := root / include / name).is_file())
        open_names += _INCLUDE.findall(found[name].read_text("utf-8"))
    return dict(sorted(found.items()))


def digest(root: Path = ROOT) -> str:
    """A hash of the headers; layouts of structures and virtual functions follow from them."""
    total = hashlib.sha256()
    for name, path in headers(root).items():
        total.update(f"{name}\0{path.read_text('utf-8')}\0".encode())
    return total.hexdigest()[:16]


def write_stamp(file: Path) -> None:
    definition = f'extern const char* const header_hash;\nconst char* const header_hash = "{digest()}";'
    text = f"namespace dalembert {{\n{definition}\n}}\n"
    if not file.exists() or file.read_text("utf-8") != text:
        file.write_text(text, "utf-8")


def copied() -> Iterable[Path]:
    """The files of the repository from which item packages are generated and compiled."""
    yield from headers().values()
    further = (source for sources in FURTHER_SOURCES.values() for source in sources)
    yield from (ROOT / source for source in (SUPPORT, *SOURCES, *further))
    yield from (ROOT / "specs").rglob("*.toml")
    yield from (path for path in (ROOT / "codegen").rglob("*") if path.suffix in (".py", ".j2"))


def copy(directory: Path) -> None:
    for file in copied():
        target = directory / file.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, target)


if __name__ == "__main__":
    command, destination = sys.argv[1:]
    {"stamp": write_stamp, "copy": copy}[command](Path(destination))
