"""Files in generated/ are exactly those that the specs and templates produce."""

from __future__ import annotations

from pathlib import Path

import pytest

from codegen.__main__ import compare, main
from codegen.model_settings import Specs
from codegen.new_item import KINDS
from codegen.render import TemplateError, environment, fill, render


def test_generated_files_are_fresh(specs: Specs, root: Path) -> None:
    stale, orphans = compare(root / "generated", render(specs))
    assert not stale, "run `python -m codegen`"
    assert not orphans, "no spec generates these files"


def test_check_reports_stale_missing_and_orphan(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--root", str(copy)]) == 0
    assert main(["--root", str(copy), "--check"]) == 0
    registry = copy / "generated/src/registry.cpp"
    registry.write_text(registry.read_text().replace("object_ground_type", "another_type"))
    (copy / "generated/include/dalembert/enums.hpp").unlink()
    (copy / "generated/left_over.txt").write_text("")
    capsys.readouterr()
    assert main(["--root", str(copy), "--check"]) == 1
    shown = capsys.readouterr()
    assert "-extern const ItemType another_type;" in shown.out
    assert "+enum class AccessFunctionType : std::uint32_t {" in shown.out
    assert "left_over.txt: no spec generates this file" in shown.out
    assert "run `python -m codegen`" in shown.err


def test_every_template_is_used(root: Path) -> None:
    sources = "".join(path.read_text() for path in (root / "codegen").glob("*.py"))
    sources += "".join(path.read_text() for path in (root / "codegen/templates").rglob("*.j2"))  # the rest extend these
    of_kinds = {f"new/{kind}.{end}.j2" for kind in KINDS for end in ("toml", "hpp")}
    for template in environment().list_templates():
        assert f'"{template}"' in sources or template in of_kinds, f"{template} is used by nothing"


def test_a_value_without_a_hole_and_a_hole_without_a_value_fail() -> None:
    with pytest.raises(TemplateError, match="enums.cpp.j2: no hole for colour"):
        fill("enums.cpp.j2", enums=(), colour="red")
    with pytest.raises(Exception, match="'enums' is undefined"):
        fill("enums.cpp.j2")


def test_banners_name_source_template_command_and_test(specs: Specs) -> None:
    for path, text in render(specs).items():
        head = text[:500]
        if path.endswith((".hpp", ".cpp", ".pyi", ".rst")):
            assert "Generated from specs/" in head and "codegen/templates/" in head, path
            assert "python -m codegen" in head, path
            assert "tests/codegen/test_freshness.py" in head, path
