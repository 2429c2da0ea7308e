"""General contact as settings.contact shows it: what is drawn is what touches and where it is searched."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
import dalembert.itemInterface as eii
from dalembert._pictures.flow import Flow
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.scene import Scene

CORNERS = np.array([[0, 0, 0], [0.4, 0, 0], [0, 0.3, 0.1]])
COLOR = (0.1, 0.2, 0.3, 1.0)


@pytest.fixture
def world(SC: Any, mbs: Any) -> tuple[Any, Any]:
    """A ball of radius 0.1 above a triangle on a body that has been turned about z by a right angle."""
    quarter = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    body = mbs.CreateRigidBody(
        referencePosition=[1, 2, 0],
        referenceRotationMatrix=quarter,
        inertia=exu.utilities.InertiaCuboid(1000, [0.1, 0.1, 0.1]),
    )
    ball = mbs.CreateMassPoint(referencePosition=[1, 2, 0.3], physicsMass=1, gravity=[0, 0, -9.81])
    markers = [
        mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body)),
        mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=ball)),
    ]
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    contact.AddTrianglesRigidBodyBased(markers[0], 1e4, 1, 0, CORNERS, [[0, 1, 2]])
    contact.AddSphereWithMarker(markers[1], 0.1, 1e4, 1, 0)
    contact.SetSearchTreeCellSize([2, 1, 1])
    contact.SetSearchTreeBox([0, 0, -1], [4, 4, 1])
    mbs.Assemble()
    SC.visualizationSettings.contact.colorSpheres = SC.visualizationSettings.contact.colorTriangles = COLOR
    return mbs, SC.visualizationSettings


def of_contact(scene: Scene) -> tuple[list[Any], list[Any], list[Any]]:
    """Spheres, corners of meshes and lines."""
    whole = scene.unbound()
    own = {i for i, item in enumerate(whole.items) if item.kind == "GeneralContact"}
    return (
        [sphere[:3] for sphere in whole.spheres if sphere[3] in own],
        [part.mesh.points @ part.matrix.T + part.place for part in whole.instances if part.item in own],
        [line[0] for line in whole.lines if line[3] in own],
    )


def test_nothing_is_drawn_unasked(world: Any) -> None:
    assert of_contact(SceneMaker(*world).scene()) == ([], [], [])


def test_spheres_and_triangles(world: Any) -> None:
    mbs, settings = world
    settings.contact.showSpheres = settings.contact.showTriangles = True
    ((center, radius, color),), (corners,), lines = of_contact(SceneMaker(mbs, settings).scene())
    np.testing.assert_allclose(center, [1, 2, 0.3], atol=1e-15)
    assert radius == pytest.approx(0.1, abs=1e-15) and color == pytest.approx(COLOR, abs=1e-7) and not lines
    np.testing.assert_allclose(corners, [[1, 2, 0], [1, 2.4, 0], [0.7, 2, 0.1]], atol=1e-15)


def test_boxes(world: Any) -> None:
    mbs, settings = world
    settings.contact.showBoundingBoxes = True
    lines = of_contact(SceneMaker(mbs, settings).scene())[2]
    assert len(lines) == 24
    boxes = [np.concatenate(lines[12 * i : 12 * i + 12]) for i in range(2)]
    np.testing.assert_allclose([boxes[0].min(axis=0), boxes[0].max(axis=0)], [[0.9, 1.9, 0.2], [1.1, 2.1, 0.4]])
    np.testing.assert_allclose([boxes[1].min(axis=0), boxes[1].max(axis=0)], [[0.7, 2, 0], [1, 2.4, 0.1]], atol=1e-15)


def test_cells_are_the_redder_the_more_they_hold(world: Any) -> None:
    mbs, settings = world
    settings.contact.showSearchTree = settings.contact.showSearchTreeCells = True
    settings.contact.colorSearchTree = [0, 0, 1, 1]
    mbs.GetGeneralContact(0).UpdateContacts(mbs)
    scene = SceneMaker(mbs, settings).scene()
    own = [line for line in scene.lines if line[3] >= 0 and scene.items[line[3]].kind == "GeneralContact"]
    whole, left, right = (own[12 * i : 12 * i + 12] for i in range(3))
    np.testing.assert_allclose(np.concatenate([line[0] for line in whole]).max(axis=0), [4, 4, 1])
    np.testing.assert_allclose(np.concatenate([line[0] for line in left]).max(axis=0), [2, 4, 1])
    assert {line[1] for line in whole} == {line[1] for line in right} == {(0.0, 0.0, 1.0, 1.0)}
    assert {line[1] for line in left} == {(1.0, 0.0, 0.0, 1.0)}


def test_searches_without_a_box_or_cells(world: Any) -> None:
    mbs, settings = world
    settings.contact.showSearchTree = settings.contact.showSearchTreeCells = True
    mbs.AddGeneralContact()
    mbs.AddGeneralContact().SetSearchTreeBox([-1, -1, -1], [1, 1, 1])
    mbs.Assemble()
    scene = SceneMaker(mbs, settings).scene()
    of = [scene.items[line[3]].number for line in scene.lines if scene.items[line[3]].kind == "GeneralContact"]
    assert [of.count(i) for i in range(3)] == [36, 0, 12]


def test_they_move_with_their_bodies(world: Any) -> None:
    """Scenes one after the other are as if each was drawn by itself; so is what files hold."""
    mbs, settings = world
    settings.contact.showSpheres = settings.contact.showTriangles = settings.contact.showBoundingBoxes = True
    flow = Flow(SceneMaker(mbs, settings))
    flow.scene()
    q = np.array(mbs.systemData.GetODE2Coordinates())
    q[:3] += [0.5, 0, 0]
    q[-1] -= 0.05
    mbs.systemData.SetODE2Coordinates(q, exu.ConfigurationType.Visualization)
    moved, drawn = of_contact(flow.scene()), of_contact(SceneMaker(mbs, settings).scene())
    np.testing.assert_allclose(moved[0][0][0], [1, 2, 0.25], atol=1e-15)
    np.testing.assert_allclose(moved[1][0][0], [1.5, 2, 0], atol=1e-15)
    for a, b in zip(moved, drawn, strict=True):
        assert len(a) == len(b)
    np.testing.assert_allclose(moved[1], drawn[1], atol=1e-15)
    np.testing.assert_allclose(moved[2], drawn[2], atol=1e-15)


def test_systems_that_are_not_assembled_have_none(SC: Any, mbs: Any) -> None:
    mbs.AddGeneralContact()
    SC.visualizationSettings.contact.showSpheres = True
    assert of_contact(SceneMaker(mbs, SC.visualizationSettings).scene()) == ([], [], [])


def test_files_of_other_programs_have_them(world: Any, tmp_path: Any) -> None:
    mbs, settings = world
    settings.contact.showTriangles = True
    mbs.SaveVTU(tmp_path / "contact.vtu")
    assert (tmp_path / "contact.vtu").stat().st_size > 0
