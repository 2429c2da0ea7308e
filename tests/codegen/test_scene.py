"""Whom a [scene] names, and the page that explains it."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import pytest

from codegen.load import load
from codegen.model import SpecError
from codegen.scene import EXEMPT, FRAMES, SceneTable


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
    spec.write_text(spec.read_text().replace("[docs]", f'[scene]\npairs = [["{place}"]]\n\n[docs]', 1))
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
    spec.write_text(spec.read_text().replace("[docs]", f"[scene]\nnodes = [{node}]\n\n[docs]", 1))
    with pytest.raises(SpecError) as error:
        load(copy)
    assert str(error.value).startswith(f"specs/finite_elements/ancf_beam.toml: scene: nodes: {message}")


def test_the_page_explains_each_word(root: Path) -> None:
    page = (root / "docs/developer/scenes.rst").read_text()
    for word in [*FRAMES, *EXEMPT, *(field.name for field in fields(SceneTable))]:
        assert f"``{word}``" in page, word
