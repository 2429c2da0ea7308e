"""Items know the system, and the system no item: the contracts are between them."""

from __future__ import annotations

import re
from pathlib import Path

from codegen.load import load

LAYERS = ("core/include/dalembert/batches", "core/include/dalembert/system", "core/src/batches", "core/src/system")


def test_no_line_of_batches_or_system_names_an_item(root: Path) -> None:
    names = "|".join(item.name for item in load(root).items)
    named = re.compile(rf"\b(?:{names})(?:Parameters|Record|Visualization)?\b")
    found = [
        f"{file.relative_to(root)}:{number}: {line.strip()}"
        for layer in LAYERS
        for file in sorted((root / layer).iterdir())
        for number, line in enumerate(file.read_text().splitlines(), 1)
        if named.search(line)
    ]
    assert not found, "\n".join(found)
