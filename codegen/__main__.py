"""`python -m codegen` writes generated/; `--check` only compares, and fails on a difference.

`python -m codegen new connector MyItem` starts a new item: a spec and the skeleton of its kernel.
"""

from __future__ import annotations

import argparse
import difflib
import sys
from pathlib import Path

from codegen.load import load
from codegen.model import SpecError
from codegen.new_item import add_arguments, create
from codegen.render import render

ROOT = Path(__file__).parent.parent
DIFF_LINES = 40  # lines of the diff of an outdated file that --check prints


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m codegen", description=__doc__)
    parser.add_argument("--check", action="store_true", help="compare only; exit 1 if generated/ is stale")
    parser.add_argument("--root", type=Path, default=ROOT, help="the repository (default: the one this package is in)")
    commands = parser.add_subparsers(dest="command")
    add_arguments(commands.add_parser("new", help="start a new item"))
    arguments = parser.parse_args(argv)
    try:
        if arguments.command == "new":
            print("\n".join(create(arguments.root, arguments.kind, arguments.name)))
            return 0
        wanted = render(load(arguments.root))
    except SpecError as error:
        print(error, file=sys.stderr)
        return 1
    generated = arguments.root / "generated"
    return check(generated, wanted) if arguments.check else write(generated, wanted)


def compare(generated: Path, wanted: dict[str, str]) -> tuple[list[str], list[str]]:
    """Paths that are missing or differ, and paths that no spec generates."""
    present = {p.relative_to(generated).as_posix(): p for p in generated.rglob("*") if p.is_file()}
    stale = [path for path, text in wanted.items() if path not in present or present[path].read_text("utf-8") != text]
    return sorted(stale), sorted(present.keys() - wanted.keys())


def check(generated: Path, wanted: dict[str, str]) -> int:
    stale, orphans = compare(generated, wanted)
    for path in stale:
        file = generated / path
        old = file.read_text("utf-8").splitlines() if file.exists() else []
        diff = difflib.unified_diff(old, wanted[path].splitlines(), path, path, lineterm="", n=1)
        print("\n".join(list(diff)[:DIFF_LINES]))
    for path in orphans:
        print(f"{path}: no spec generates this file")
    if stale or orphans:
        print("generated/ is out of date: run `python -m codegen`", file=sys.stderr)
    return int(bool(stale or orphans))


def write(generated: Path, wanted: dict[str, str]) -> int:
    """Write only changed files, so that a build compiles only these."""
    stale, orphans = compare(generated, wanted)
    for path in stale:
        file = generated / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(wanted[path], "utf-8")
    for path in orphans:
        (generated / path).unlink()
    print(f"{len(wanted)} files, {len(stale)} written, {len(orphans)} removed")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
