"""Read what the package leaves out of the interface: specs/left_out."""

from __future__ import annotations

from codegen.model import SpecError
from codegen.model_settings import LeftOut
from codegen.rows import at, check_keys, parse, text

KEYS = ("instead", "names")


def load_left_out(path: str, content: str) -> tuple[LeftOut, ...]:
    with at(path):
        found = []
        for purpose, row in parse(content).items():
            with at(purpose):
                check_keys(row, KEYS)
                names = row.get("names", [])
                if not names or len(set(names)) != len(names):
                    raise SpecError("names: none, or one twice")
                found.append(LeftOut(purpose, text(row, "instead"), tuple(names)))
        return tuple(found)
