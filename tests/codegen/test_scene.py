"""Whom a [scene] names, and the page that explains it."""

from __future__ import annotations

import re
from dataclasses import fields
from pathlib import Path

import pytest

from codegen.load import load
from codegen.model import SpecError
from codegen.scene import EXEMPT, FRAMES, SceneTable


def put_scene(spec: Path, line: str) -> None:
    """Let a line be all of the scene of a spec."""
    text = re.sub(r"^\[\[?scene\b.*\n(?:(?!\[).*\n)*", "", spec.read_text(), flags=re.MULTILINE)
    spec.write_text(text.replace("[docs]", f"[scene]\n{line}\n\n[docs]", 1))


@pytest.mark.parametrize(
    ("place", "message"),
    [
        ("MarkerBodyRigid on ObjectRigidBodi on NodeRigidBodyEP", "unknown name 'ObjectRigidBodi'; did you mean"),
        ("MarkerBodyRigid on ObjectRigidBody on NodePoint", "ObjectRigidBody is not made for NodePoint; "),
        (
            "MarkerBodyRigid on ObjectRigidBody",
            "ObjectRigidBody needs 'on' and one of its nodes; known are NodeRigidBodyEP, NodeRigidBodyRxyz,",
        ),
    ],
)
def test_places_exist(copy: Path, place: str, message: str) -> None:
    spec = copy / "specs/nodes/point_slope12.toml"
    put_scene(spec, f'pairs = [["{place}"]]')
    with pytest.raises(SpecError) as error:
        load(copy)
    assert str(error.value).startswith(f"specs/nodes/point_slope12.toml: scene: pairs: {message}")


@pytest.mark.parametrize(
    ("node", "message"),
    [
        ('{ type = "NodePiont" }', "unknown name 'NodePiont'; did you mean 'NodePoint'?"),
        ('{ type = "NodePoint", values = { number = 1 } }', "unknown name 'number'; did you mean 'name'?"),
    ],
)
def test_nodes_of_a_body_exist(copy: Path, node: str, message: str) -> None:
    spec = copy / "specs/finite_elements/ancf_beam.toml"
    put_scene(spec, f"nodes = [{node}]")
    with pytest.raises(SpecError) as error:
        load(copy)
    assert str(error.value).startswith(f"specs/finite_elements/ancf_beam.toml: scene: nodes: {message}")


def test_the_page_explains_each_word(root: Path) -> None:
    page = (root / "docs/developer/scenes.rst").read_text()
    for word in [*FRAMES, *EXEMPT, *(field.name for field in fields(SceneTable))]:
        assert f"``{word}``" in page, word


@pytest.mark.parametrize(
    ("spec", "drawing", "message"),
    [
        ("connectors/spring_damper.toml", "sprin", "unknown drawing 'sprin'; did you mean 'spring'?"),
        (
            "bodies/mass_point.toml",
            "spring",
            "drawing: for objects with markerNumbers; a body has the graphics of its node",
        ),
    ],
)
def test_drawings_are_those_of_markers(copy: Path, spec: str, drawing: str, message: str) -> None:
    put_scene(copy / "specs" / spec, f'drawing = "{drawing}"')
    with pytest.raises(SpecError) as error:
        load(copy)
    assert str(error.value).startswith(f"specs/{spec}: scene: {message}")
