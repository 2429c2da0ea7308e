"""Every mistake in a spec is rejected with a message that names file, table, row, the fault and the allowed values.

A file in specs_invalid/ starts with two comments: `# path:` is the name under which the file is read, `# message:` the
expected text.
"""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

from codegen.load import load_group, load_item
from codegen.load_settings import load_enum, load_settings
from codegen.model import SpecError
from codegen.model_settings import Specs

FILES = sorted((Path(__file__).parent / "specs_invalid").glob("*.toml"))


@pytest.mark.parametrize("file", FILES, ids=[file.stem for file in FILES])
def test_refused(specs: Specs, root: Path, file: Path) -> None:
    content = file.read_text()
    path = re.search(r"^# path: (.*)$", content, re.MULTILINE)
    message = re.search(r"^# message: (.*)$", content, re.MULTILINE)
    assert path and message, "the file lacks its comments"
    with pytest.raises(SpecError) as error:
        read(specs, root, path[1], content)
    assert str(error.value) == f"{path[1]}: {message[1]}"


def read(specs: Specs, root: Path, path: str, content: str) -> None:
    enums = {enum.name: enum for enum in specs.enums}
    folder = path.split("/")[1]
    if folder == "enums":
        load_enum(path, content)
    elif folder == "settings":
        load_settings(path, content, enums)
    elif folder == "groups":
        load_group(path, content)
    else:
        groups = {f.stem: tomllib.loads(f.read_text()) for f in (root / "specs/groups").glob("*.toml")}
        load_item(path, content, groups, enums)
