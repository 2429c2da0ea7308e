"""Positions in pictures: they agree with states, frames and settings, by independent computations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import graphics
from dalembert._pictures import contour, painting, pen
from dalembert._pictures.flow import Flow
from dalembert._pictures.looks import Looks
from dalembert._pictures.making import SceneMaker
from dalembert._pictures.studio import Studio, item_at
from dalembert.itemInterface import (
    Cable2D,
    MarkerBodyRigid,
    MarkerKinematicTreeRigid,
    MarkerNodeCoordinate,
    MarkerNodePosition,
    NodeGenericODE2,
    NodePoint,
    NodePoint2DSlope1,
    NodePointGround,
    ObjectGenericODE2,
    ObjectKinematicTree,
    ReevingSystemSprings,
    SensorBody,
    SpringDamper,
    VCable2D,
    VNodePoint,
    VObjectGenericODE2,
)
from dalembert.utilities import InertiaCuboid, RotationMatrixZ

Configuration, Variable = exu.ConfigurationType, exu.OutputVariableType


def pixels(SC: Any, kind: str, number: int) -> Any:
    """Return where an item is seen in the picture of the renderer."""
    studio = Studio(SC)
    scene = studio.scene()
    seen = painting.items(scene, studio.camera(scene), studio.makers[0].looks, studio.view(0), studio.size(0))
    wanted = [i for i, item in enumerate(scene.items) if (item.kind, item.number) == (kind, number)]
    return np.isin(seen, wanted)


def is_of(scene: Any, item: int, kind: str, number: int) -> bool:
    return (scene.items[item].kind, scene.items[item].number) == (kind, number)


def middle(mask: Any) -> Any:
    rows, columns = np.nonzero(mask)
    return np.array([columns.mean() + 0.5, rows.mean() + 0.5])


def test_a_body_has_the_position_of_its_state(SC: Any, mbs: Any) -> None:
    brick = graphics.Brick(size=[0.4, 0.2, 0.1], color=graphics.color.orange)
    body = mbs.CreateRigidBody(
        referencePosition=[1, 2, 0], inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]), graphicsDataList=[brick]
    )
    mbs.Assemble()
    SC.renderer.SetModelView(zoom=4, centerPoint=[1, 1, 0])
    scale = 768 / 2 / 4
    q = mbs.systemData.GetODE2Coordinates()
    q[:2] = [-1.5, 0.5]
    mbs.systemData.SetODE2Coordinates(q, Configuration.Visualization)
    seen = pixels(SC, "Object", int(body))
    assert middle(seen) == pytest.approx([512 + scale * (1 - 1.5 - 1), 384 - scale * (2 + 0.5 - 1)], abs=0.6)
    assert seen.sum() == pytest.approx(0.4 * 0.2 * scale**2, rel=0.06)


def test_the_view_turns_the_scene(SC: Any, mbs: Any) -> None:
    """SetModelView turns by a rotation vector; a point is seen at modelRotation.T (p - centerPoint)."""
    node = mbs.AddNode(NodePoint(referenceCoordinates=[1, 0.5, 0.25], visualization=VNodePoint(drawSize=0.2)))
    SC.renderer.SetModelView(zoom=2, rotationVector=[0, 0, np.pi / 2], centerPoint=[0.5, 0, 0])
    state = SC.renderer.GetState()
    x, y, _ = state["modelRotation"].T @ (np.array([1, 0.5, 0.25]) - state["centerPoint"])
    assert (x, y) == (pytest.approx(-0.5), pytest.approx(0.5))
    seen = pixels(SC, "Node", int(node))
    assert middle(seen) == pytest.approx([512 + 192 * x, 384 - 192 * y], abs=0.6)
    assert seen.sum() == pytest.approx(np.pi * (0.1 * 192) ** 2, rel=0.03)


def test_the_automatic_view_shows_everything(SC: Any, mbs: Any) -> None:
    for x, y in ((-3, 0), (5, 1), (0, 7)):
        mbs.AddNode(NodePoint(referenceCoordinates=[x, y, 0]))
    for number in range(3):
        assert pixels(SC, "Node", number).any()
    edges = np.concatenate([pixels(SC, "Node", n)[[0, -1]].ravel() for n in range(3)])
    assert not edges.any()


def test_a_spring_goes_from_marker_to_marker(SC: Any, mbs: Any) -> None:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(referencePosition=[2, 0, 0], physicsMass=1, show=False)
    spring = mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1, drawSize=0.4)
    SC.visualizationSettings.markers.show = False
    SC.renderer.SetModelView(zoom=1.5, centerPoint=[1, 0, 0])
    rows, columns = np.nonzero(pixels(SC, "Object", int(spring)))
    scale = 768 / 2 / 1.5
    wire = 0.13 * 0.2 * scale
    assert (columns.min(), columns.max()) == (
        pytest.approx(512 - scale, abs=wire),
        pytest.approx(512 + scale, abs=wire),
    )
    assert (rows.max() - rows.min()) == pytest.approx(0.4 * scale + 2 * wire, abs=wire)


def test_a_beam_is_as_high_as_it_is_drawn(SC: Any, mbs: Any) -> None:
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 2)]
    beam = mbs.AddObject(
        Cable2D(
            nodeNumbers=nodes, physicsLength=2, physicsMassPerLength=1, physicsBendingStiffness=1,
            physicsAxialStiffness=1, visualization=VCable2D(drawHeight=0.3),
        )
    )  # fmt: skip
    SC.visualizationSettings.nodes.show = False
    SC.renderer.SetModelView(zoom=1.5, centerPoint=[1, 0, 0])
    seen = pixels(SC, "Object", int(beam))
    assert seen.sum() == pytest.approx(2 * 0.3 * (768 / 3) ** 2, rel=0.02)


def test_a_pixel_gives_the_item(SC: Any, mbs: Any) -> None:
    node = mbs.AddNode(NodePoint(name="here", referenceCoordinates=[1, 0, 0], visualization=VNodePoint(drawSize=0.2)))
    SC.renderer.SetModelView(zoom=2)
    found = item_at(Studio(SC), 512 + 192, 384)
    assert found is not None
    assert (found.kind, found.number, found.type_name, found.name) == ("Node", int(node), "Point", "here")
    assert item_at(Studio(SC), 5, 5) is None


def test_numbers_become_colors(SC: Any, mbs: Any) -> None:
    """The displacement grows along the cable: colors from the first to the last one of the bar."""
    n = 9
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in range(n)]
    for a, b in zip(nodes[:-1], nodes[1:], strict=True):
        mbs.AddObject(
            Cable2D(
                nodeNumbers=[a, b], physicsLength=1, physicsMassPerLength=1, physicsBendingStiffness=1,
                physicsAxialStiffness=1, visualization=VCable2D(drawHeight=1),
            )
        )  # fmt: skip
    mbs.Assemble()
    q = np.zeros((n, 4))
    q[:, 1] = np.linspace(0, 1, n)
    q[:, 3] = 1 / 8
    mbs.systemData.SetODE2Coordinates(q.ravel(), Configuration.Visualization)
    contour = SC.visualizationSettings.contour
    contour.outputVariable, contour.outputVariableComponent = Variable.Displacement, 1
    SC.visualizationSettings.nodes.show = False
    studio = Studio(SC)
    scene = studio.scene()
    assert scene.value_range == (pytest.approx(0, abs=1e-9), pytest.approx(1))
    from dalembert._pictures.contour import colors

    low, quarter, high, over = colors(studio.makers[0].looks, np.array([0, 0.25, 1, 1.1]), (0, 1))
    assert np.allclose(low, contour.advanced.contourColor0)
    assert np.allclose(quarter, contour.advanced.contourColor1)
    assert np.allclose(high, contour.advanced.contourColor4)
    assert np.allclose(over, [*contour.advanced.contourColorMax[:3], 1])
    SC.renderer.SetModelView(zoom=4, centerPoint=[4, 0.5, 0])  # 96 pixels per m

    def at(x: float) -> Any:
        return Studio(SC).picture().astype(int)[round(384 - 96 * (x / 8 - 0.5)), round(512 + 96 * (x - 4))]

    assert at(0.3)[2] > at(0.3)[0] + 50  # blue
    assert at(7.7)[0] > at(7.7)[2] + 50  # red


def test_deformation_is_scaled(SC: Any, mbs: Any) -> None:
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    mbs.AddObject(
        Cable2D(
            nodeNumbers=nodes,
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=1,
        )
    )
    mbs.Assemble()
    mbs.systemData.SetODE2Coordinates([0, 0, 0, 0, 0, 0.01, 0, 0], Configuration.Visualization)
    SC.visualizationSettings.bodies.deformationScaleFactor = 20
    lines = Studio(SC).scene().lines
    assert lines[0][0][-1] == pytest.approx([1, 0.2, 0])


def test_user_functions_give_shapes(SC: Any, mbs: Any) -> None:
    asked = []

    def shapes(mbs: Any, number: int) -> list[Any]:
        asked.append(number)
        return [graphics.Sphere([0, 0.5, 0], radius=0.1, nTiles=16)]

    ground = mbs.CreateGround(referencePosition=[1, 0, 0], graphicsDataUserFunction=shapes)
    SC.renderer.SetModelView(zoom=1)
    assert middle(pixels(SC, "Object", int(ground))) == pytest.approx([512 + 384, 384 - 192], abs=1)
    assert asked == [0] * len(asked)


TRIANGLE = {"type": "TriangleList", "points": np.eye(3), "triangles": [0, 1, 2]}


@pytest.mark.parametrize(
    ("entry", "text"),
    [
        ({"type": "Cube"}, "'type': expected TriangleList.*received 'Cube'"),
        ({**TRIANGLE, "points": np.arange(8)}, "'points': expected rows of 3 numbers"),
        ({**TRIANGLE, "triangles": [0, 1]}, "'triangles': expected rows of 3 numbers"),
        ({**TRIANGLE, "triangles": [0, 1, 9]}, "'triangles': expected numbers of points, 0 to 2, received 9"),
        ({**TRIANGLE, "triangles": [0, 1, 1.5]}, "'triangles': expected numbers of points, 0 to 2, received 1.5"),
        ({**TRIANGLE, "edges": [0, 3]}, "'edges': expected numbers of points, 0 to 2, received 3"),
        (
            {**TRIANGLE, "colors": [1, 0, 0, 1]},
            "'colors': expected 4 numbers for each of 3 points, or none, received 4",
        ),
        (
            {**TRIANGLE, "normals": np.eye(3)[:2]},
            "'normals': expected 3 numbers for each of 3 points, or none, received 6",
        ),
        ({"type": "Line", "data": [0, 0, 0, 1, 1]}, "'data': expected rows of 3 numbers"),
        ({"type": "Text", "position": [0, 0], "text": "A"}, "'position': expected a vector with 3 components"),
        ({"type": "Circle", "position": [0, 0, 0], "radius": "1"}, "'radius': expected a finite number"),
    ],
)
def test_graphics_data_that_cannot_be_drawn_name_the_body(SC: Any, mbs: Any, entry: dict[str, Any], text: str) -> None:
    mbs.CreateGround(name="floor", graphicsDataUserFunction=lambda mbs, n: [entry])
    with pytest.raises(ValueError, match=rf"object 0 'floor': .*\[0\]: {text}"):
        Studio(SC).scene()


@pytest.mark.parametrize(
    ("triangles", "text"),
    [([[0, 1, 3]], "expected numbers of points, 0 to 2, received 3"), ([[0, 1]], "expected rows of 3 numbers")],
)
def test_triangles_of_nodes_that_are_not_there_name_the_body(
    SC: Any, mbs: Any, triangles: list[list[int]], text: str
) -> None:
    nodes = [mbs.AddNode(NodePoint(referenceCoordinates=[i, i * i, 0])) for i in range(3)]
    looks = VObjectGenericODE2(triangleMesh=triangles)
    mbs.AddObject(ObjectGenericODE2(name="sheet", nodeNumbers=nodes, massMatrix=np.eye(9), visualization=looks))
    mbs.Assemble()
    with pytest.raises(ValueError, match=rf"object 0 'sheet': VtriangleMesh: {text}"):
        Studio(SC).scene()


def test_frames_of_nodes(SC: Any, mbs: Any) -> None:
    """The axes of a node that has turned by 90 degrees about z: x points up."""
    mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [1, 1, 1]), referenceRotationMatrix=RotationMatrixZ(np.pi / 2))
    SC.visualizationSettings.nodes.showBasis = True
    SC.visualizationSettings.nodes.basisSize = 0.7
    scene = Studio(SC).scene()
    red = [part for part in scene.instances if part.color == (0.85, 0.15, 0.15, 1.0)]
    tips = [part.mesh.points @ part.matrix.T + part.place for part in red]
    assert np.concatenate(tips)[:, 1].max() == pytest.approx(0.7)
    assert np.abs(np.concatenate(tips)[:, 0]).max() < 0.1


def test_groups_are_shown_or_not(SC: Any, mbs: Any) -> None:
    ground = mbs.CreateGround()
    mass = mbs.CreateMassPoint(physicsMass=1, referencePosition=[1, 0, 0], gravity=[0, -1, 0])
    mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1)
    mbs.AddSensor(SensorBody(bodyNumber=mass, outputVariableType=Variable.Position))
    everything = len(Studio(SC).scene().instances) + len(Studio(SC).scene().spheres)
    for group in ("nodes", "connectors", "markers", "loads", "sensors"):
        getattr(SC.visualizationSettings, group).show = False
        fewer = Studio(SC).scene()
        assert len(fewer.instances) + len(fewer.spheres) < everything
        getattr(SC.visualizationSettings, group).show = True
    SC.visualizationSettings.nodes.showNumbers = True
    assert [label.text for label in Studio(SC).scene().labels] == ["N0"]


def test_numbers_at_one_point_stand_below_each_other(SC: Any, mbs: Any) -> None:
    mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [0.01, 0.01, 0.01]))
    for kind in ("nodes", "bodies"):
        getattr(SC.visualizationSettings, kind).showNumbers = True
    SC.visualizationSettings.view0.scene.drawCoordinateSystem = 0
    SC.visualizationSettings.view0.window.globalFontSize = 20
    SC.renderer.SetModelView(zoom=1, centerPoint=[0, 0, 0])
    image = np.array(SC.renderer.RedrawAndGetImage()).min(axis=2)
    rows = np.nonzero((image[:, image.shape[1] // 2 + 8 :] < 100).any(axis=1))[0]
    heights = [len(part) for part in np.split(rows, np.nonzero(np.diff(rows) > 1)[0] + 1)]
    assert len(heights) == 2 and min(heights) > 10  # two rows of letters


def test_several_systems_are_in_one_picture(SC: Any, mbs: Any) -> None:
    other = SC.AddSystem()
    for system, x in ((mbs, -1.0), (other, 1.0)):
        system.AddNode(NodePoint(referenceCoordinates=[x, 0, 0], visualization=VNodePoint(drawSize=0.2)))
    SC.renderer.SetModelView(zoom=2)
    image = SC.renderer.RedrawAndGetImage()
    assert (image[384, [512 - 192, 512 + 192]] < 250).any(axis=1).all()


def test_sharp_edges_of_a_brick() -> None:
    from dalembert._pictures.graphics_data import shapes
    from dalembert._pictures.meshes import sharp_edges

    ((_, brick, _),) = shapes([graphics.Brick(size=[1, 2, 3])], (1.0, 0.0, 0.0, 1.0), "a test")
    ends = brick.points[sharp_edges(brick)]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    assert sorted(lengths) == pytest.approx([1] * 4 + [2] * 4 + [3] * 4)
    ((_, ball, _),) = shapes([graphics.Sphere(nTiles=32)], (1.0, 0.0, 0.0, 1.0), "a test")
    assert len(sharp_edges(ball)) == 0


def test_one_item_is_highlighted(SC: Any, mbs: Any) -> None:
    nodes = [mbs.AddNode(NodePoint(referenceCoordinates=[x, 0, 0])) for x in (0, 1, 2)]
    interactive = SC.visualizationSettings.interactive
    interactive.highlightItemIndex, interactive.highlightItemType = int(nodes[1]), exu.ItemType.Node
    scene = Studio(SC).scene()
    assert [tuple(center) for center, *_ in scene.spheres] == [(1, 0, 0)]
    assert scene.spheres[0][2][:3] == pytest.approx(interactive.advanced.highlightColor[:3])
    assert len(scene.instances) == 2  # the others are seen through


def test_the_frame_of_the_world(SC: Any, mbs: Any) -> None:
    mbs.AddNode(NodePoint())
    SC.visualizationSettings.view0.scene.drawWorldBasis = True
    SC.visualizationSettings.view0.scene.worldBasisSize = 3
    box = np.concatenate([i.mesh.points @ i.matrix.T + i.place for i in Studio(SC).scene().instances])
    assert box.max(axis=0) == pytest.approx([3, 3, 3])


def test_sections_are_filled() -> None:
    """Triangles of an I section: their areas sum up to that of the section, and none lies outside."""
    from dalembert._pictures.meshes import filled

    half = [[1, -2], [1, -1.5], [0.2, -1.5], [0.2, 1.5], [1, 1.5], [1, 2]]
    section = np.array(half + [[-x, y] for x, y in reversed(half)], float)
    area = 2 * 2 * 0.5 + 3 * 0.4
    for polygon in (section, section[::-1]):
        a, b, c = (polygon[filled(polygon)[:, k]] for k in range(3))
        areas = np.abs((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]) / 2
        assert areas.sum() == pytest.approx(area)
        middles = (a + b + c) / 3
        assert np.all((np.abs(middles[:, 1]) > 1.5) | (np.abs(middles[:, 0]) < 0.2))


def test_perspective_keeps_everything_in_the_picture(SC: Any, mbs: Any) -> None:
    for x, y, z in ((-1, 0, 3), (1, 0, 3), (0, 1, -3), (0, -1, 0)):
        mbs.AddNode(NodePoint(referenceCoordinates=[x, y, z], visualization=VNodePoint(drawSize=0.1)))
    SC.visualizationSettings.view0.camera.perspective = 0.4
    camera = Studio(SC).camera(Studio(SC).scene())
    seen = camera.pixels(np.array([[-1, 0, 3], [1, 0, 3], [0, 1, -3], [0, -1, 0]], float), 1024, 768)
    assert (seen[:, :2] > 0).all() and (seen[:, 0] < 1024).all() and (seen[:, 1] < 768).all()
    assert max(np.abs(seen[:, 0] - 512).max() / 512, np.abs(seen[:, 1] - 384).max() / 384) > 0.4


def test_the_bar_of_colors_has_its_place(SC: Any, mbs: Any) -> None:
    nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    mbs.AddObject(
        Cable2D(
            nodeNumbers=nodes,
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=1,
        )
    )
    mbs.Assemble()
    SC.visualizationSettings.contour.outputVariable = Variable.Displacement
    columns = np.nonzero(pixels(SC, "Object", 0))[1]
    assert 0.03 * 1024 < columns.min() < columns.max() < 0.86 * 1024


def test_springs_of_many_objects_are_simpler(SC: Any, mbs: Any) -> None:
    ends = [
        mbs.AddMarker(MarkerNodePosition(nodeNumber=mbs.AddNode(NodePoint(referenceCoordinates=[x, 0, 0]))))
        for x in (0, 1)
    ]
    numbers = []
    for count in (1, 150, 900, 2200):
        while mbs.systemData.NumberOfObjects() < count:
            mbs.AddObject(SpringDamper(markerNumbers=ends, stiffness=1))
        scene = Studio(SC).scene()
        springs = [part for part in scene.instances if scene.items[part.item].kind == "Object"]
        numbers.append(len(springs[0].mesh.points) if springs else 0)
    assert numbers[0] > 1.9 * numbers[1] > 3.5 * numbers[2] > numbers[3] == 0
    assert len(scene.lines) == 2200


def test_extremes_stand_for_the_size_of_a_mesh() -> None:
    from dalembert._pictures.meshes import ball, cube, extremes, helix

    for mesh, error in ((cube(), 1e-12), (ball(16), 0.03), (helix(8.0, 10, 0.1, 16, 8), 0.05)):
        assert len(extremes(mesh)) <= 26
        for angle in (0.0, 0.3, 0.7):
            turned, few = (points @ RotationMatrixZ(angle).T for points in (mesh.points, extremes(mesh)))
            np.testing.assert_allclose(few.max(axis=0), turned.max(axis=0), atol=error * np.ptp(turned, axis=0).max())


@pytest.mark.parametrize("scale", [1e-5, 1.0, 1e4])
def test_pictures_look_the_same_in_every_size(scale: float) -> None:
    """Symbols and fit are in proportion: the same model in other units gives the same picture, but for rounding."""

    def picture(unit: float) -> Any:
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.CreateGround()
        body = mbs.CreateRigidBody(
            referencePosition=[0.5 * unit, 0.2 * unit, 0],
            inertia=InertiaCuboid(1, [unit, 0.2 * unit, 0.2 * unit]),
            graphicsDataList=[graphics.Brick(size=[unit, 0.2 * unit, 0.2 * unit])],
        )
        mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0.2 * unit, 0], axis=[0, 0, 1])
        mbs.CreateSpringDamper(bodyNumbers=[ground, body], localPosition0=[unit, unit, 0], stiffness=1)
        mbs.CreateForce(bodyNumber=body, loadVector=[0, 1, 0])
        return np.asarray(mbs.Draw(windowSize=[320, 240])).astype(int)

    different = np.abs(picture(scale) - picture(1.0)).max(axis=2) > 40
    assert different.mean() < 0.005


def test_coordinates_that_lengthen_a_rope_are_not_where_it_runs(SC: Any, mbs: Any) -> None:
    ground = mbs.CreateGround()
    places = [[-0.5, 0, 0], [0, 2, 0], [0.5, 0, 0]]
    markers = [mbs.AddMarker(MarkerBodyRigid(bodyNumber=ground, localPosition=place)) for place in places]
    node = mbs.AddNode(NodePointGround(referenceCoordinates=[7, 0, 0]))
    winch = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    rope = mbs.AddObject(
        ReevingSystemSprings(
            markerNumbers=[*markers, winch, winch],
            hasCoordinateMarkers=True,
            stiffnessPerLength=100,
            referenceLength=5,
            sheavesAxes=exu.Vector3DList([[0, 0, -1]] * 3),
            sheavesRadii=[0, 0.5, 0],
        )
    )
    mbs.Assemble()
    SC.renderer.SetModelView(zoom=10, centerPoint=[0, 0, 0])
    columns = np.nonzero(pixels(SC, "Object", int(rope)))[1]
    scale = 768 / 2 / 10
    assert columns.min() - 512 == pytest.approx(-0.5 * scale, abs=2)
    assert columns.max() - 512 == pytest.approx(0.5 * scale, abs=2)


def test_balls_of_many_nodes_are_smaller_than_their_distances(SC: Any, mbs: Any) -> None:
    apart, side = 0.3, 8
    for place in np.ndindex(side, side, side):
        mbs.CreateMassPoint(referencePosition=apart * np.array(place), physicsMass=1)
    mbs.Assemble()
    SC.visualizationSettings.bodies.show = False
    (radius,) = {sphere[1] for sphere in Studio(SC).scene().spheres}
    assert 0.1 * apart < 2 * radius < 0.25 * apart


def test_ground_keeps_its_colors(SC: Any, mbs: Any) -> None:
    """It is not part of the moving items, and would widen the range of the colors."""
    mbs.CreateGround(graphicsDataList=[graphics.CheckerBoard(size=20)])
    brick = [graphics.Brick(size=[0.2, 0.2, 0.2])]
    mbs.CreateRigidBody(referencePosition=[1, 0, 0], inertia=InertiaCuboid(1, [1, 1, 1]), graphicsDataList=brick)
    mbs.Assemble()
    SC.visualizationSettings.contour.outputVariable = Variable.Position
    SC.visualizationSettings.contour.outputVariableComponent = 0
    scene = Studio(SC).scene()
    assert scene.value_range == pytest.approx((0.9, 1.1))


@pytest.mark.parametrize("limits", [(0.0, 1.0), (-3.0, 5.0), (20.0, 20.001)])
def test_colors_of_many_numbers_are_those_of_each(limits: tuple[float, float]) -> None:
    looks, (low, high) = Looks(exu.VisualizationSettings()), limits
    values = low + (high - low) * np.concatenate([np.linspace(-0.2, 1.2, 3001), [0, 1]])
    exact = 255 * contour.colors(looks, values, limits)[:, :3]
    off = np.abs(contour.shades(looks, values, limits) - exact)
    assert 0.1 < off.max() < 1.01  # half a step of the table, where colors change by 4 * 255 / 1024, and half a byte
    below, above = (contour.shades(looks, np.array([x]), limits) for x in (low - (high - low), high + (high - low)))
    assert (contour.shades(looks, np.array([np.nan, -np.inf]), limits) == below).all()
    assert (contour.shades(looks, np.array([np.inf]), limits) == above).all() and (below != above).any()


def test_links_of_a_tree_reach_to_their_center_of_mass_and_markers(SC: Any, mbs: Any) -> None:
    node = mbs.AddNode(NodeGenericODE2(numberOfODE2Coordinates=2, referenceCoordinates=[0, 0]))
    tree = mbs.AddObject(
        ObjectKinematicTree(
            nodeNumber=node, jointTypes=[exu.JointType.RevoluteZ] * 2, linkParents=[-1, 0], linkMasses=[1, 1],
            jointTransformations=exu.Matrix3DList([np.eye(3)] * 2), linkCOMs=exu.Vector3DList([[0.5, 0, 0]] * 2),
            jointOffsets=exu.Vector3DList([[0, 0, 0], [1, 0, 0]]), linkInertiasCOM=exu.Matrix3DList([np.eye(3)] * 2),
        )
    )  # fmt: skip
    mbs.Assemble()
    box = Studio(SC).scene().box()
    assert box is not None
    assert box[1][0] == pytest.approx(1.5, abs=1e-9)  # a rod ends there; the joint at 1 is much thinner
    mbs.AddMarker(MarkerKinematicTreeRigid(objectNumber=tree, linkNumber=1, localPosition=[0, 2, 0]))
    mbs.Assemble()
    box = Studio(SC).scene().box()
    assert box is not None
    assert box[1][1] == pytest.approx(2, abs=1e-9)  # another one at the marker


def test_numbers_of_masses_that_are_drawn_as_nodes(SC: Any, mbs: Any) -> None:
    """CreateMassPoint hides a body without graphics: its node is drawn in place of it, and has the number of the body."""
    bodies = [mbs.CreateMassPoint(referencePosition=[x, 1, 0], physicsMass=1) for x in range(3)]
    mbs.CreateMassPoint(referencePosition=[5, 1, 0], physicsMass=1, show=False)
    SC.visualizationSettings.bodies.showNumbers = True
    for assembled in (False, True):
        if assembled:
            mbs.Assemble()
        labels = Studio(SC).scene().labels
        assert [(label.text, *label.place) for label in labels] == [
            (f"O{int(b)}", x, 1, 0) for x, b in enumerate(bodies)
        ]
    flow = Flow(SceneMaker(mbs, SC.visualizationSettings))
    flow.scene()
    q = mbs.systemData.GetODE2Coordinates()
    mbs.systemData.SetODE2Coordinates(q + 0.5, Configuration.Visualization)
    scene = flow.scene()
    assert [(label.text, *label.place) for label in scene.labels] == [
        (f"O{int(b)}", x + 0.5, 1.5, 0.5) for x, b in enumerate(bodies)
    ]
    assert all(is_of(scene, item, "Node", k) for k, item in enumerate(scene.balls.items[:3].tolist()))
    assert not any(scene.items[item].kind == "Object" for item in scene.balls.items)
    SC.visualizationSettings.bodies.show = False
    assert not Studio(SC).scene().labels


@pytest.mark.parametrize("count", [2, 300])
def test_a_ball_of_a_mass_has_the_color_of_its_node(SC: Any, mbs: Any, count: int) -> None:
    """It hides the node, of which nothing would be seen; single items, and many equal ones."""
    red = [1.0, 0.0, 0.0, 1.0]
    for k in range(count):
        look = exu.VNodePoint(color=red) if k == 1 else exu.VNodePoint()
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[k, 0, 0], visualization=look))
        mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
    mbs.Assemble()
    SC.visualizationSettings.nodes.show = False
    scene = Studio(SC).scene()
    colors = {scene.items[item].number: color for _, _, color, item in scene.spheres}
    assert len(colors) == count
    assert [number for number, color in colors.items() if color == pytest.approx(red)] == [1]


def test_a_mass_that_is_drawn_as_its_node_is_highlighted(SC: Any, mbs: Any) -> None:
    bodies = [mbs.CreateMassPoint(referencePosition=[x, 1, 0], physicsMass=1) for x in range(3)]
    exu.utilities.HighlightItem(SC, mbs, bodies[1])
    scene = Studio(SC).scene()
    bright = SC.visualizationSettings.interactive.advanced.highlightColor[:3]
    assert [scene.items[item].number for _, _, color, item in scene.spheres if color[:3] == pytest.approx(bright)] == [
        1
    ]


@pytest.mark.parametrize("drawn", [None, 5, "text", [3]])
def test_functions_that_draw_nothing_that_is_known_are_named(mbs: Any, SC: Any, drawn: Any) -> None:
    mbs.CreateGround(name="floor", graphicsDataUserFunction=lambda mbs, number: drawn)
    with pytest.raises(
        ValueError, match="object 0 'floor': graphicsDataUserFunction: expected a list of graphics data"
    ):
        Studio(SC).scene()


def test_functions_that_raise_are_named(mbs: Any, SC: Any) -> None:
    mbs.CreateGround(name="floor", graphicsDataUserFunction=lambda mbs, number: 1 / 0)
    with pytest.raises(ZeroDivisionError) as caught:
        Studio(SC).scene()
    assert caught.value.__notes__ == ["raised by the graphicsDataUserFunction of object 0 'floor'"]


def test_incomplete_graphics_data_are_reported(mbs: Any, SC: Any) -> None:
    mbs.CreateGround(name="floor", graphicsDataUserFunction=lambda mbs, number: [{"type": "Line"}])
    with pytest.raises(ValueError, match=r"'floor': graphicsDataUserFunction: graphicsData\[0\]: a Line needs 'data'"):
        Studio(SC).scene()


def test_functions_that_draw_their_own_system(mbs: Any) -> None:
    def draws(mbs: Any, number: int) -> list[Any]:
        mbs.Draw()
        return []

    mbs.CreateGround(name="mirror", graphicsDataUserFunction=draws)
    with pytest.raises(RuntimeError, match="'mirror': its graphicsDataUserFunction draws the system") as caught:
        mbs.Draw()
    assert caught.value.__notes__ == ["raised by the graphicsDataUserFunction of object 0 'mirror'"]
    another = exu.SystemContainer().AddSystem()  # that may be drawn
    another.CreateGround(graphicsDataList=[graphics.Sphere()])
    mbs.SetObjectParameter(0, "VgraphicsDataUserFunction", lambda mbs, number: bool(another.Draw()) * [])
    mbs.Draw()


def test_meshes_without_points_are_drawn_and_saved(mbs: Any, SC: Any) -> None:
    mbs.CreateGround(graphicsDataList=[{"type": "TriangleList", "points": [], "triangles": [], "colors": []}])
    mbs.Assemble()
    assert Studio(SC).scene().instances
    mbs.SaveHTML("empty.html")
    mbs.SaveGLB("empty.glb")


def test_springs_have_distinguishable_windings(mbs: Any, SC: Any) -> None:
    ground, mass = mbs.CreateGround(), mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1)
    spring = mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1)
    SC.visualizationSettings.connectors.springNumberOfWindings = 10**6
    scene = Studio(SC).scene()
    (helix,) = (part for part in scene.instances if is_of(scene, part.item, "Object", int(spring)))
    assert len(helix.mesh.points) < 1e6


@pytest.mark.parametrize("scale", [1e-12, 1e-9, 1e-3, 1e9])
def test_scenes_of_any_size_look_alike(scale: float) -> None:
    """Sizes from molecules to planets: the picture is that of one meter."""
    images = []
    for size in (1.0, scale):
        container = exu.SystemContainer()
        mbs = container.AddSystem()
        body = mbs.CreateRigidBody(
            referencePosition=[2 * size, 0, 0], inertia=InertiaCuboid(1000, [size, size, size]),
            graphicsDataList=[graphics.Brick(size=[size, 0.5 * size, 0.3 * size], color=graphics.color.orange)],
        )  # fmt: skip
        mbs.CreateSpringDamper(bodyNumbers=[mbs.CreateGround(), body], stiffness=1)
        mbs.Assemble()
        images.append(np.asarray(mbs.Draw(windowSize=[160, 120]), int))
    assert np.mean(np.abs(images[0] - images[1]).max(axis=2) > 40) < 0.01


# ---- frames of joints


def frames_of(mbs: Any, joint: int) -> list[tuple[Any, Any]]:
    """Origins and axes (columns) of the frames that are drawn for a joint, by the colors of their arrows."""
    settings = mbs.GetSystemContainer().visualizationSettings
    settings.connectors.showJointAxes = True
    scene = SceneMaker(mbs, settings).scene().unbound()
    number = next(n for n, item in enumerate(scene.items) if (item.kind, item.number) == ("Object", joint))
    shafts = [  # cylinders, which are longer than the cones at their ends
        part for part in scene.instances if part.item == number and part.color in (pen.RED, pen.GREEN, pen.BLUE)
    ][::2]
    assert [part.color for part in shafts] == [pen.RED, pen.GREEN, pen.BLUE] * (len(shafts) // 3)
    axes = [part.matrix[:, 2] / np.linalg.norm(part.matrix[:, 2]) for part in shafts]
    return [(shafts[k].place, np.column_stack(axes[k : k + 3])) for k in range(0, len(shafts), 3)]


def test_frames_of_joints_are_those_of_their_outputs(SC: Any, mbs: Any) -> None:
    """Frames are the markers' with their joint rotations: R_m0 rotationMarker0, and R_m1 rotationMarker1."""
    ground = mbs.CreateGround()
    turned = RotationMatrixZ(0.4)
    body = mbs.CreateRigidBody(
        referencePosition=[1, 2, 3], referenceRotationMatrix=turned, inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1])
    )
    markers = [
        mbs.AddMarker(MarkerBodyRigid(bodyNumber=number, localPosition=place))
        for number, place in ((ground, [1, 2, 3]), (body, [0, 0, 0.5]))
    ]
    rotations = [exu.utilities.RotationMatrixX(0.3), exu.utilities.RotationMatrixY(-0.7)]
    joint = mbs.AddObject(
        exu.ObjectJointGeneric(
            markerNumbers=markers, constrainedAxes=[1, 1, 0, 0, 0, 0], rotationMarker0=rotations[0],
            rotationMarker1=rotations[1],
        )
    )  # fmt: skip
    mbs.Assemble()
    (place0, axes0), (place1, axes1) = frames_of(mbs, joint)
    np.testing.assert_allclose(place0, [1, 2, 3], atol=1e-14)
    np.testing.assert_allclose(place1, [1, 2, 3.5], atol=1e-14)
    np.testing.assert_allclose(axes0, rotations[0], atol=1e-14)
    np.testing.assert_allclose(axes1, turned @ rotations[1], atol=1e-14)
    SC.visualizationSettings.connectors.showJointAxes = False
    assert len(SceneMaker(mbs, SC.visualizationSettings).scene().instances) > 0
    scene = SceneMaker(mbs, SC.visualizationSettings).scene()
    assert all(part.color not in (pen.RED, pen.GREEN, pen.BLUE) for part in scene.instances)


@pytest.mark.parametrize("penalty", [False, True])
def test_the_frame_of_a_rolling_disc_is_at_its_contact_point(mbs: Any, penalty: bool) -> None:
    """Frame J1 is an output of the item: lateral, forward, normal."""
    ground = mbs.CreateGround()
    tilted = exu.utilities.RotationMatrixY(0.2) @ RotationMatrixZ(0.3)
    body = mbs.CreateRigidBody(
        referencePosition=[1, 2, 0.3 * np.cos(0.2)], referenceRotationMatrix=tilted,
        inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]),
    )  # fmt: skip
    create = mbs.CreateRollingDiscPenalty if penalty else mbs.CreateRollingDisc
    more = {"contactStiffness": 1e5} if penalty else {}
    joint = create(bodyNumbers=[ground, body], discRadius=0.3, axisPosition=[0, 0, 0], axisVector=[1, 0, 0], **more)
    mbs.Assemble()
    ((place, axes),) = frames_of(mbs, joint)
    expected = np.reshape(mbs.GetObjectOutput(joint, Variable.RotationMatrix), (3, 3))
    np.testing.assert_allclose(axes, expected, atol=1e-12)
    np.testing.assert_allclose(place, mbs.GetObjectOutput(joint, Variable.Position), atol=1e-12)
