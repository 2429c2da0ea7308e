"""General contact as settings.contact shows it: the drawn contacts are those of the search."""

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
    """Scenes one after the other are as if each was drawn by itself; files agree."""
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


# ---- forces


def solved(mbs: Any, steps: int, end: float) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = end
    settings.solutionSettings.writeSolutionToFile = False
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.ExplicitMidpoint)


@pytest.fixture
def slide(SC: Any, mbs: Any) -> tuple[Any, Any]:
    """A ball of radius 0.1 slides on a large triangle, another one sits on the first, with friction."""
    ground = mbs.CreateGround()
    markers = [mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=ground))]
    inertia = exu.utilities.InertiaSphere(1, 0.1)
    for place, speed in (([0, 0, 0.0995], [1, 0, 0]), ([0, 0, 0.2988], [1, 0.2, 0])):
        body = mbs.CreateRigidBody(inertia=inertia, referencePosition=place, initialVelocity=speed, gravity=[0, 0, -10])
        markers.append(mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body)))
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.3]])
    contact.AddTrianglesRigidBodyBased(markers[0], 4e4, 20, 0, [[-9, -9, 0], [9, -9, 0], [0, 9, 0]], [[0, 1, 2]])
    for marker in markers[1:]:
        contact.AddSphereWithMarker(marker, 0.1, 4e4, 20, 0)
    mbs.Assemble()
    solved(mbs, 100, 0.01)
    return mbs, SC.visualizationSettings


def test_forces_are_those_of_the_equations(slide: tuple[Any, Any]) -> None:
    """Their sums by sphere are the generalised forces, as are their moments; points lie on the spheres and on the triangle."""
    mbs, _ = slide
    contact = mbs.GetGeneralContact(0)
    pairs, points, forces = contact._pushes(exu.ConfigurationType.Visualization)
    assert pairs.tolist() == [[0, 1], [0, 2]] and (np.linalg.norm(forces, axis=1) > 0).all()
    assert np.hypot(*forces[1, :2]) == pytest.approx(0.3 * forces[1, 2], rel=1e-9)  # it slides
    whole = contact.GetSystemODE2RhsContactForces().reshape(2, 7)[:, :3]
    np.testing.assert_allclose([forces.sum(axis=0), -forces[0]], whole, rtol=1e-9, atol=1e-9)
    centers = [mbs.GetNodeOutput(n, exu.OutputVariableType.Position) for n in range(2)]
    assert points[1, 2] == pytest.approx(0, abs=1e-15) and np.linalg.norm(points[1] - centers[0]) < 0.1
    assert np.linalg.norm(points[0] - centers[0]) == pytest.approx(
        np.linalg.norm(centers[1] - centers[0]) / 2, rel=1e-9
    )


def test_forces_are_drawn_where_they_push(slide: tuple[Any, Any]) -> None:
    mbs, settings = slide
    settings.contact.showContactForces = settings.contact.showContactForcesValues = True
    settings.contact.contactForcesFactor, settings.contact.contactPointsDefaultSize = 0.02, 0.01
    _, points, forces = mbs.GetGeneralContact(0)._pushes(exu.ConfigurationType.Visualization)
    scene = SceneMaker(mbs, settings).scene()
    spheres, arrows, lines = of_contact(scene)
    np.testing.assert_allclose([center for center, *_ in spheres], points)
    assert [radius for _, radius, _ in spheres] == pytest.approx([0.005, 0.005]) and not lines
    tips = [
        max(corners @ force) / np.linalg.norm(force) for corners, force in zip(_by_two(arrows), forces, strict=True)
    ]
    expected = [
        (point + 0.02 * force) @ force / np.linalg.norm(force) for point, force in zip(points, forces, strict=True)
    ]
    np.testing.assert_allclose(tips, expected, rtol=1e-6)
    assert [label.text for label in scene.labels] == [f"{np.linalg.norm(force):.4g} N" for force in forces]


def test_forces_without_a_direction_are_reported(SC: Any, mbs: Any, capfd: Any) -> None:
    """Two spheres with one center push each other nowhere: the picture is drawn, with a notice of the missing parts."""
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    for _ in range(2):
        ball = mbs.CreateMassPoint(physicsMass=1)
        contact.AddSphereWithMarker(mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=ball)), 0.1, 1e4, 0, 0)
    mbs.Assemble()
    SC.visualizationSettings.contact.showContactForces = True
    for _ in range(2):
        spheres, arrows, _lines = of_contact(SceneMaker(mbs, SC.visualizationSettings).scene())
        assert not spheres and not arrows
    said = capfd.readouterr().out
    assert said.count("forces of general contact 0 are not drawn: ") == 1


def _by_two(parts: list[Any]) -> list[Any]:
    """An arrow has a shaft and a tip, in one mesh or in two."""
    size = len(parts) // 2
    return [np.concatenate(parts[:size]), np.concatenate(parts[size:])]


def test_asking_for_forces_changes_no_result(slide: tuple[Any, Any]) -> None:
    """Neither between two solutions nor between two steps."""
    mbs, settings = slide

    def end(asks: bool) -> Any:
        def look(mbs: Any, t: float) -> bool:
            if asks:
                mbs.GetGeneralContact(0)._pushes(exu.ConfigurationType.Visualization)
                mbs.GetGeneralContact(0)._pushes(exu.ConfigurationType.Current)
            return True

        mbs.SetPreStepUserFunction(look)
        simulation = exu.SimulationSettings()
        simulation.timeIntegration.numberOfSteps = 50
        simulation.timeIntegration.endTime = 0.05
        simulation.solutionSettings.writeSolutionToFile = False
        mbs.SolveDynamic(simulation)
        return mbs.systemData.GetSystemState()

    for first, second in zip(end(True), end(False), strict=True):
        np.testing.assert_array_equal(first, second)


def test_forces_of_circles_on_cables(SC: Any, mbs: Any) -> None:
    nodes = [mbs.AddNode(eii.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    cable = mbs.AddObject(
        eii.ObjectANCFCable2D(
            nodeNumbers=nodes,
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=1,
        )
    )
    ball = mbs.CreateMassPoint(referencePosition=[0.4, 0.119, 0], physicsMass=1, create2D=True)
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    contact.AddANCFCable(cable, 0.02, 1e5, 0, 0)
    contact.AddSphereWithMarker(mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=ball)), 0.1, 1e5, 0, 0)
    mbs.Assemble()
    pairs, (point,), (force,) = contact._pushes(exu.ConfigurationType.Visualization)
    assert pairs.tolist() == [[0, 1]]
    np.testing.assert_allclose(point, [0.4, 0.019, 0], atol=1e-12)
    np.testing.assert_allclose(force[:2], contact.GetSystemODE2RhsContactForces()[-2:], rtol=1e-12, atol=1e-12)
    assert force[1] > 0


def test_shadows_of_systems_have_their_contacts(slide: tuple[Any, Any]) -> None:
    """Contents of pages; they follow changes of the contact."""
    mbs, settings = slide
    settings.contact.showSpheres = settings.contact.showContactForces = True
    shadow = exu._core._Shadow(mbs)
    assert shadow.follow()[2] and not any(shadow.follow())
    assert len(of_contact(SceneMaker(shadow.system, settings).scene())[0]) == 4
    mbs.GetGeneralContact(0).SetSphereMarkerBased(1, radius=0.15)
    assert shadow.follow()[2]
    radii = [radius for _, radius, _ in of_contact(SceneMaker(shadow.system, settings).scene())[0]]
    assert radii[:2] == pytest.approx([0.1, 0.15])


def test_contacts_that_have_no_direction_are_not_drawn(SC: Any, mbs: Any) -> None:
    markers = [mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=mbs.CreateMassPoint(physicsMass=1))) for _ in range(2)]
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    for marker in markers:
        contact.AddSphereWithMarker(marker, 0.1, 1e4, 0, 0)
    mbs.Assemble()
    SC.visualizationSettings.contact.showContactForces = True
    assert of_contact(SceneMaker(mbs, SC.visualizationSettings).scene()) == ([], [], [])
    contact.isActive = False
    assert len(contact._pushes(exu.ConfigurationType.Visualization)[0]) == 0


def test_convex_shapes(SC: Any, mbs: Any) -> None:
    """Corners of boxes and hulls are drawn; cylinders and capsules reach as far as they are large."""
    body = mbs.CreateRigidBody(referencePosition=[1, 2, 3], inertia=exu.utilities.InertiaCuboid(1000, [0.1, 0.1, 0.1]))
    marker = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body))
    contact = mbs.AddGeneralContact()
    contact.SetFrictionPairings([[0.0]])
    surface = {"contactStiffness": 1e4, "contactDamping": 1, "frictionMaterialIndex": 0}
    contact.AddBoxWithMarker(marker, [0.2, 0.4, 0.6], centerPoint=[0, 0, 1], **surface)
    contact.AddConvexHullWithMarker(marker, [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], **surface)
    contact.AddCylinderWithMarker(marker, 0.1, [0, 0.5, 0], **surface)
    contact.AddCapsuleWithMarker(marker, 0.1, [0.5, 0, 0], pAxis=[0, 0, 0], **surface)
    mbs.Assemble()
    SC.visualizationSettings.contact.showSpheres = True
    _, meshes, _ = of_contact(SceneMaker(mbs, SC.visualizationSettings).scene())
    boxes = np.array([[points.min(axis=0), points.max(axis=0)] for points in meshes]) - [1, 2, 3]
    expected = [
        [[-0.1, -0.2, 0.7], [0.1, 0.2, 1.3]],
        [[0, 0, 0], [1, 1, 1]],
        [[-0.1, -0.25, -0.1], [0.1, 0.25, 0.1]],
        [[-0.1, -0.1, -0.1], [0.6, 0.1, 0.1]],
    ]
    np.testing.assert_allclose(boxes, expected, atol=1e-12)
