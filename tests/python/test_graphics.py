"""Primitives as closed surfaces with outward normals and the right volume; operations and files on triangle lists."""

import struct

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dalembert import graphics as gr
from dalembert import graphicsDataUtilities as gdu
from dalembert import machines

P, AXIS = np.array([1.0, 2, 3]), np.array([0.3, -0.5, 0.9])
RED = [1.0, 0, 0, 1]
SQUARE = [[0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]]  # an L of area 3
LOOP = [[i, (i + 1) % 6] for i in range(6)]


def mesh(g):
    return np.reshape(g["points"], (-1, 3)), np.reshape(g["triangles"], (-1, 3))


def volume(g):
    points, triangles = mesh(g)
    return np.linalg.det(points[triangles]).sum() / 6


def is_closed(g):
    """Each directed edge between (merged) points has exactly one opposite."""
    points, triangles = mesh(g)
    _, index = np.unique(np.round(points, 9), axis=0, return_inverse=True)
    corners = index.ravel()[triangles]
    edges = np.vstack([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]])
    edges = edges[edges[:, 0] != edges[:, 1]]
    count: dict = {}
    for a, b in edges.tolist():
        count[a, b] = count.get((a, b), 0) + 1
    return all(count.get((b, a)) == n for (a, b), n in count.items())


def prism(n):
    """Area of a regular n-gon over that of its circumscribed circle."""
    return n / (2 * np.pi) * np.sin(2 * np.pi / n)


L = np.linalg.norm(AXIS)
CONTOUR = [[0, 0], [0, 0.2], [0.5, 0.2], [0.5, 0]]
SOLIDS = {
    "sphere": (gr.Sphere(P, 0.3, RED, 60), 4 / 3 * np.pi * 0.027, 4e-3),
    "shell": (
        gr.Sphere(P, 0.3, RED, 60, majorAngleMin=-0.3, majorAngleMax=0.4, innerRadius=0.2),
        np.pi * (0.09 - 0.04) * 0.3 * (np.sin(0.3) + np.sin(0.4)),
        4e-3,
    ),
    "brick": (gr.Brick(P, [0.1, 0.2, 0.3], RED), 0.006, 1e-12),
    "brick with normals": (gr.Brick(P, [0.1, 0.2, 0.3], RED, addNormals=True), 0.006, 1e-12),
    "ellipsoid": (gr.Brick(P, [0.1, 0.2, 0.3], RED, roundness=1, nTiles=80), np.pi * 0.001, 1e-2),
    "cylinder": (gr.Cylinder(P, AXIS, 0.2, RED, 12), np.pi * 0.04 * L * prism(12), 1e-12),
    "tube": (gr.Cylinder(P, AXIS, 0.2, RED, 12, radiusInner=0.1), np.pi * 0.03 * L * prism(12), 1e-12),
    "revolution": (gr.SolidOfRevolution(P, AXIS, CONTOUR, RED, 12), np.pi * 0.02 * prism(12), 1e-12),
    "torus": (gr.Torus(P, AXIS, 0.5, 0.1, RED, 80, 60), 2 * np.pi**2 * 0.005, 4e-3),
    "extrusion": (gr.SolidExtrusion(SQUARE, LOOP, 0.5, pOff=P, smoothNormals=True), 1.5, 1e-12),
    "rack": (gr.ToothedRack(0.1, 5, 0.2, 0.22, 0.1), 0.1 * np.pi * 0.21, 1e-9),
    "arrow": (gr.Arrow(P, [0, 0, 1], 0.01, RED, nTiles=40), np.pi * 1e-4 * (0.92 + 4 * 0.08 / 3), 5e-3),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_solids_are_closed_with_the_volume_of_the_shape(name):
    g, expected, tolerance = SOLIDS[name]
    assert is_closed(g)
    assert volume(g) == pytest.approx(expected, rel=tolerance)
    n = len(g["points"]) // 3
    assert len(g["colors"]) == 4 * n
    assert g["triangles"].dtype.kind == "i"
    assert g["triangles"].max() < n
    if "normals" in g and name not in ("ellipsoid",):
        assert gr.InconsistentTriangles(g) == 0
        assert np.linalg.norm(g["normals"].reshape(-1, 3), axis=1).max() == pytest.approx(1)


def test_open_and_partial_surfaces():
    for options in ({"cutPlain": True}, {"cutPlain": False}):
        g = gr.Cylinder(P, AXIS, 0.2, RED, 13, angleRange=[0.2, 2.0], **options)
        assert is_closed(g)
        sector, chord = 0.5 * 0.04 * 12 * np.sin(1.8 / 12), 0.5 * 0.04 * np.sin(1.8)
        if options["cutPlain"]:
            assert volume(g) == pytest.approx((sector - chord) * L)
        else:
            assert volume(g) == pytest.approx(sector * L)
            assert gr.InconsistentTriangles(g) == 0
    assert not is_closed(gr.Cylinder(P, AXIS, 0.2, RED, 13, angleRange=[0.2, 2.0], lastFace=False))
    closed = gr.Torus(P, AXIS, 0.5, 0.1, RED, 9, 7)
    inner = gr.Torus(P, AXIS, 0.5, 0.1, RED, 9, 7, invert=True)
    assert volume(inner) == pytest.approx(-volume(closed))
    assert gr.InconsistentTriangles(inner) == 0
    assert not is_closed(gr.Torus(P, AXIS, 0.5, 0.1, RED, 9, 7, 0, 1.0))


def test_tube_keeps_its_radius_and_faces_outwards():
    s = np.linspace(0, 3, 30)
    points = np.column_stack([np.cos(s), np.sin(s), s])
    axes = np.column_stack([-np.sin(s), np.cos(s), 0 * s + 1])
    g = gr.Tube(points, axes, 0.1, RED, 9)
    rings = g["points"].reshape(30, 9, 3) - points[:, None]
    np.testing.assert_allclose(np.linalg.norm(rings, axis=2), 0.1)
    np.testing.assert_allclose(np.einsum("rpi,ri->rp", rings, axes), 0, atol=1e-12)
    assert gr.InconsistentTriangles(g) == 0
    with pytest.raises(ValueError, match="at least 2 points and as many axes, received 30 points, 1 axes"):
        gr.Tube(points, axes[:1])


def test_edges_lie_on_the_shape():
    sphere = gr.Sphere(P, 0.3, RED, 8, addEdges=4, edgeColor=gr.color.blue)
    assert sphere["edgeColor"].tolist() == gr.color.blue
    assert sphere["edges"].max() < len(sphere["points"]) // 3
    for normals in (False, True):
        brick = gr.Brick([0, 0, 0], [1, 2, 3], RED, addNormals=normals, addEdges=True)
        ends = brick["points"].reshape(-1, 3)[brick["edges"].reshape(-1, 2)]
        assert sorted(np.abs(ends[:, 0] - ends[:, 1]).sum(1).tolist()) == [1] * 4 + [2] * 4 + [3] * 4
    part = gr.Cuboid(gr.Brick(size=[2, 2, 2])["points"].reshape(8, 3), RED, [1, 0, 0, 0, 0, 1], True, True)
    assert len(part["edges"]) == 14  # two faces with one common edge
    assert part["edges"].max() < len(part["points"]) // 3
    cylinder = gr.Cylinder(P, AXIS, 0.2, RED, 12, addEdges=3)
    ends = cylinder["points"].reshape(-1, 3)[cylinder["edges"].reshape(-1, 2)]
    np.testing.assert_allclose(ends[-3:, 1] - ends[-3:, 0], np.tile(AXIS, (3, 1)))
    assert gr.SolidOfRevolution(P, AXIS, CONTOUR, nTiles=12, addEdges=2)["edges"].size == 2 * (3 * 12 + 2 * 3)


def test_faces_can_be_left_out():
    for g in (gr.Sphere(addFaces=False), gr.Brick(addFaces=False), gr.Cylinder(addFaces=False)):
        assert g["triangles"].size == 0
        assert g["points"].size > 0


def test_smooth_contour_averages_normals_below_the_angle():
    contour = [[0, 0.1], [1, 0.1], [2, 0.2], [2, 0]]
    normals = gr.SolidOfRevolution([0, 0, 0], [0, 0, 1], contour, RED, 4, True, smoothingAngle=1.0)["normals"]
    normals = normals.reshape(3, 2, 4, 3)
    np.testing.assert_allclose(normals[0, 1], normals[1, 0])
    np.testing.assert_allclose(normals[2, 0, :, 2], 1)
    slope = np.arctan(0.1) / 2
    np.testing.assert_allclose(normals[0, 1, :, 2], -np.sin(slope))


def test_quads_and_checkerboards():
    g = gr.Quad([[0, 0, 0], [4, 0, 0], [4, 2, 0], [0, 2, 0]], RED, alternatingColor=gr.color.blue, nTiles=4, nTilesY=2)
    points, triangles = mesh(g)
    np.testing.assert_allclose(gdu.ComputeTriangleArea(*points[triangles[0]]), 0.5)
    assert len(triangles) == 16
    np.testing.assert_allclose(g["normals"].reshape(-1, 3), [[0, 0, 1]] * 32)
    reds = g["colors"].reshape(2, 4, 4, 4)[:, :, 0, 0]
    assert reds.tolist() == [[1, 0, 1, 0], [0, 1, 0, 1]]
    board = gr.CheckerBoard(P, AXIS, size=2, nTiles=2, size2=1, nTiles2=1, materialIndex=gr.material.indexChrome)
    assert set(board["colors"].reshape(-1, 4)[:, 3]) == {1004}
    np.testing.assert_allclose((board["points"].reshape(-1, 3) - P) @ AXIS, 0, atol=1e-12)
    with pytest.warns(UserWarning, match="argument 'colour' is unknown"):
        gr.Quad(np.zeros((4, 3)), colour=RED)


def test_elements():
    assert gr.Lines([[0, 0, 0], [1, 2, 3]], RED)["data"].tolist() == [0, 0, 0, 1, 2, 3]
    assert gr.Circle(P, 2)["radius"] == 2
    text = gr.Text(P, "abc", fontSize=3, offset=[1, 2])
    assert (text["text"], text["fontSize"], text["offset"], text["type"]) == ("abc", 3, [1, 2], "Text")
    basis = gr.Basis(P, length=2, labels=["x", "y", "z"])
    assert basis[3]["position"].tolist() == [1, 2, 5]
    frame = gr.Frame(np.eye(4), 2)
    np.testing.assert_allclose(gr.BoundingBox(frame)[1], 2, atol=0.05)


def test_curved_lines():
    """Parabolas pass through their three points, and have the length of y = x^2."""
    line = gr.Lines([[0, 0, 0], [0.5, 0.25, 0], [1, 1, 0], [2, 1, 0], [3, 1, 0]], shape="quadratic")
    points = line["data"].reshape(-1, 3)
    assert line["type"] == "Line" and len(points) == 33
    np.testing.assert_allclose(points[[0, 8, 16, 24, 32], :2], [[0, 0], [0.5, 0.25], [1, 1], [2, 1], [3, 1]])
    length = np.linalg.norm(np.diff(points[:17], axis=0), axis=1).sum()
    assert length == pytest.approx(np.sqrt(5) / 2 + np.arcsinh(2) / 4, rel=1e-3)  # 16 chords


def test_many_spheres():
    centers = np.array([[0.0, 0, 0], [5, 0, 0], [0, 7, 0]])
    g = gr.Spheres(centers, [1, 2, 0.5], [RED, [0, 1, 0, 1], RED], nTiles=32)
    volumes, at = [], np.reshape(g["points"], (-1, 3))
    for each in np.split(np.reshape(g["triangles"], (-1, 3)), 3):
        volumes.append(np.linalg.det(at[each] - at[each[0, 0]]).sum() / 6)
    np.testing.assert_allclose(volumes, 4 / 3 * np.pi * np.array([1, 8, 0.125]), rtol=0.01)  # chords of 64 tiles
    assert gr.InconsistentTriangles(g) == 0
    assert np.reshape(g["colors"], (-1, 4))[len(at) // 3].tolist() == [0, 1, 0, 1]
    same = {"type": "Spheres", "points": centers.ravel(), "radii": [1, 2, 0.5], "colors": RED, "resolution": 32}
    np.testing.assert_array_equal(gr.SpheresToTriangleList(same)["points"], g["points"])
    assert gr.SpheresToTriangleList(g) is g


def test_curved_triangles_become_flat_ones():
    corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    g = {
        "type": "TriangleList",
        "points": np.ravel(corners),
        "colors": np.tile(RED, 6),
        "triangles": [],
        "triangles6": [0, 1, 2, 3, 4, 5],
        "edges3": [0, 1, 3],
    }
    flat = gr.Triangles6ToTriangles(g)
    each = np.array(corners, float)[np.reshape(flat["triangles"], (-1, 3))]
    np.testing.assert_allclose(np.cross(each[:, 1] - each[:, 0], each[:, 2] - each[:, 0]), np.tile([0, 0, 1.0], (4, 1)))
    assert flat["edges"].tolist() == [0, 3, 3, 1]
    assert "triangles6" not in flat and gr.Triangles6ToTriangles(flat) is flat


@pytest.mark.parametrize("g", [gr.Sphere(P), gr.Lines([P, AXIS]), gr.Text(P), gr.Circle(P)])
def test_transform_moves_points(g):
    key = {"TriangleList": "points", "Line": "data"}.get(g["type"], "position")
    A = Rotation.from_rotvec([0.1, 0.2, 0.3]).as_matrix()
    before = np.copy(g[key])
    moved = gr.Transform(g, [3, 2, 1], A, scale=2)
    expected = 2 * before.reshape(-1, 3) @ A.T + [3, 2, 1]
    np.testing.assert_allclose(moved[key].reshape(-1, 3), expected)
    np.testing.assert_allclose(gr.Move(gr.Move(g, P, A), -A.T @ P, A.T)[key], before, atol=1e-12)
    assert (g[key] == before).all()


def test_normals_and_triangles_can_be_inverted():
    g = gr.Cylinder(P, AXIS)
    assert gr.InconsistentTriangles(gr.InvertTriangles(g)) == 0
    assert gr.InconsistentTriangles(gr.InvertTriangles(g, invertNormals=False)) == len(g["triangles"])
    assert volume(gr.InvertTriangles(g)) == pytest.approx(-volume(g))
    long = gr.FromPointsAndTrigs(*gr.ToPointsAndTrigs(g), normals=3 * g["normals"])
    np.testing.assert_allclose(gr.Transform(long, normalizeNormals=True)["normals"], g["normals"])
    with pytest.raises(ValueError, match="no normals"):
        gr.InvertTriangles(gr.Brick())


def test_merge_keeps_each_part_with_its_edges():
    brick, cylinder = gr.Brick(P), gr.Cylinder(addEdges=True, edgeColor=RED)
    for parts in ([brick, cylinder], [cylinder, brick], [cylinder, cylinder]):
        merged = gr.MergeTriangleLists(*parts)
        assert volume(merged) == pytest.approx(sum(map(volume, parts)))
        ends = [g["points"].reshape(-1, 3)[g["edges"]] for g in parts if "edges" in g]
        np.testing.assert_allclose(merged["points"].reshape(-1, 3)[merged["edges"]], np.vstack(ends))
        assert merged["edgeColor"].tolist() == RED
    assert "normals" in gr.MergeTriangleLists(cylinder, cylinder)
    assert "normals" not in gr.MergeTriangleLists(cylinder, brick)


def test_bounding_boxes():
    box = gr.BoundingBox([gr.Brick(P, [2, 2, 2]), gr.Circle([0, 0, 9], 5), gr.Text([9, 0, 0]), gr.Lines([[0, 0, -7]])])
    np.testing.assert_allclose(box, [[-5, -5, -7], [9, 5, 9]])
    assert gr.BoundingBox([]) == [None, None]
    with pytest.raises(ValueError, match="expected 'TriangleList', 'Line', 'Text' or 'Circle', received 'Blob'"):
        gr.BoundingBoxSingle({"type": "Blob"})


def test_meshes_that_are_merged_or_measured_are_checked():
    brick = gr.Brick()
    for wrong, text in (
        (
            {"triangles": [0, 1, 99]},
            r"g2: graphicsData\['triangles'\]: expected numbers of points, 0 to 7, received 99",
        ),
        ({"edges": [0, 0.5]}, r"g2: graphicsData\['edges'\]: expected numbers of points, 0 to 7, received 0.5"),
        ({"points": [1, 2]}, r"g2: graphicsData\['points'\]: expected rows of 3"),
        ({"normals": [0, 0, 1]}, r"g2: graphicsData\['normals'\]: expected 3 numbers for each of 8 points"),
    ):
        with pytest.raises(ValueError, match="MergeTriangleLists: " + text):
            gr.MergeTriangleLists(brick, brick | wrong)
    with pytest.raises(ValueError, match="MergeTriangleLists: g1: graphicsData: a TriangleList needs 'triangles'"):
        gr.MergeTriangleLists({"type": "TriangleList", "points": []}, brick)
    rows = brick | {"points": brick["points"].reshape(-1, 3)}
    merged, twice = gr.MergeTriangleLists(rows, brick), gr.MergeTriangleLists(brick, brick)
    assert all((merged[key] == twice[key]).all() for key in ("points", "triangles", "colors"))
    nothing = {"type": "TriangleList", "points": [], "triangles": []}
    assert (gr.MergeTriangleLists(nothing, brick)["colors"] == brick["colors"]).all()
    for wrong, text in (
        ({"type": "TriangleList", "points": [1, 2]}, r"\['points'\]: expected rows of 3"),
        ({"type": "Text", "position": [1, 2]}, r"\['position'\]: expected a vector with 3 components"),
        ({"type": "Circle", "position": [0, 0, 0]}, ": a Circle needs 'radius'"),
        ([brick], ": expected a dictionary"),
    ):
        with pytest.raises(ValueError, match="BoundingBoxSingle: graphicsData" + text):
            gr.BoundingBoxSingle(wrong)


def test_numbers_counts_and_switches_that_are_none_are_named():
    points = [[0, 0, 0], [1, 0, 0]], [[1, 0, 0], [1, 0, 0]]
    for call, text in (
        (lambda: gr.Sphere(nTiles=None), "Sphere: nTiles: expected an integer, received None"),
        *(
            (lambda make=make: make(nTiles=10**13), f"{make.__name__}: nTiles: expected an integer")
            for make in (gr.Sphere, gr.Cylinder, gr.CheckerBoard, gr.Basis, gr.Frame)
        ),
        (lambda: gr.CheckerBoard(nTiles2=10**9), "CheckerBoard: nTiles2: expected an integer from 1 to 10000"),
        (lambda: gr.Torus(P, [0, 0, 1], radiusMajor="1"), "Torus: radiusMajor: expected a finite number, received '1'"),
        (lambda: gr.Torus(P, [0, 0, 1], float("nan")), "Torus: radiusMajor: expected a finite number, received nan"),
        (
            lambda: gr.Arrow(P, [0, 0, 1], headFactor=[1, 2]),
            r"Arrow: headFactor: expected a finite number, received \[1, 2\]",
        ),
        (lambda: gr.Cylinder(P, addFaces="False"), "Cylinder: addFaces: expected True or False, received 'False'"),
        (lambda: gr.Tube(*points, radius=[1, 2, 3]), "Tube: radius: expected a finite number"),
        (lambda: gr.Tube(*points, color=[[1, 0, 0, 1]] * 3), "Tube: color: expected a vector with 4 components"),
        (lambda: gr.Basis(colors=[RED]), "Basis: colors: expected three colors, one for each axis"),
        (lambda: gr.Tube(*points, nTiles=16.5), "Tube: nTiles: expected an integer, received 16.5"),
    ):
        with pytest.raises(ValueError, match=text):
            call()
    assert len(gr.Tube(*points, nTiles=np.float64(16))["points"]) == 3 * 32
    for nowhere in ([float("nan"), 0, 0], [0, float("inf"), 0]):
        for call, others in ((gr.Sphere, ()), (gr.Cylinder, ()), (gr.Arrow, ([0, 0, 1], 0.1))):
            with pytest.raises(ValueError, match=r"points: expected finite coordinates, received \["):
                call(nowhere, *others)
    with pytest.raises(ValueError, match="AddEdgesAndSmoothenNormals: triangleColor: expected an array of numbers"):
        gr.AddEdgesAndSmoothenNormals(gr.Brick(), triangleColor="red")
    with pytest.raises(TypeError, match="SegmentsFromPoints: pointIndexOffset: expected an integer, 0 or more"):
        gdu.SegmentsFromPoints(points[0], [1, 2, 3])


def test_rigid_link_joins_its_parts():
    spheres = gr.RigidLink([0, 0, 0], [1, 0, 0], nTiles=8)
    cylinders = gr.RigidLink([0, 0, 0], [1, 0, 0], [0, 0, 2], [0, 0, 1], [0.1, 0.2], 0.05, [0.3, 0.4], nTiles=8)
    np.testing.assert_allclose(gr.BoundingBox(cylinders), [[-0.1, -0.2, -0.2], [1.2, 0.2, 0.2]])
    np.testing.assert_allclose(gr.BoundingBox(spheres)[1], [1.1, 0.1, 0.1])


def test_smooth_normals_and_edges_of_a_split_mesh():
    brick = gr.AddEdgesAndSmoothenNormals(gr.Brick(P, [1, 1, 1], RED, addNormals=True))
    assert len(brick["edges"]) == 24
    assert gr.InconsistentTriangles(brick) == 0
    points, triangles = gr.ToPointsAndTrigs(gr.Brick([0, 0, 0]))
    for _ in range(4):
        points, triangles = gdu.RefineMesh(points, triangles)
    sphere = P + 0.5 * np.array(points) / np.linalg.norm(points, axis=1)[:, None]
    corners = sphere[np.array(triangles).ravel()]  # every triangle with points of its own
    flat = gr.FromPointsAndTrigs(corners, range(len(corners)))
    smooth = gr.AddEdgesAndSmoothenNormals(flat, triangleColor=RED)
    assert smooth["edges"].size == 0
    assert len(smooth["points"]) == 3 * len(points)
    radial = (smooth["points"].reshape(-1, 3) - P) / 0.5
    np.testing.assert_allclose(smooth["normals"].reshape(-1, 3), radial, atol=0.03)
    assert (smooth["colors"].reshape(-1, 4) == RED).all()
    sheet = gr.AddEdgesAndSmoothenNormals(gr.Quad([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], nTiles=3))
    assert len(sheet["edges"]) == 2 * 12  # its boundary


def binary_stl(g):
    points, triangles = mesh(g)
    facets = b"".join(struct.pack("<12fH", 0, 0, 0, *points[t].ravel(), 0) for t in triangles)
    return b"solid confusingly binary".ljust(80) + struct.pack("<I", len(triangles)) + facets


@pytest.mark.parametrize("binary", [False, True])
def test_stl_files_return_the_body(tmp_path, binary):
    g = gr.Cylinder(P, AXIS, 0.2, RED, 12)
    fileName = str(tmp_path / "body.stl")
    if binary:
        (tmp_path / "body.stl").write_bytes(binary_stl(g))
    else:
        gr.ExportSTL(g, fileName, invertNormals=False, invertTriangles=False)
    read, data = gr.FromSTLfile(fileName, density=10, scale=2, invertNormals=False, invertTriangles=False)
    assert volume(read) == pytest.approx(8 * volume(g), rel=1e-5)
    assert gr.InconsistentTriangles(read) == 0
    np.testing.assert_allclose(data["COM"], 2 * (P + AXIS / 2), rtol=1e-5)
    polar = np.pi * 0.1**2 * 0 + 0.04 * (2 + np.cos(2 * np.pi / 12)) / 6  # second moment over area of a 12-gon
    e = AXIS / L
    assert e @ data["inertia"] @ e == pytest.approx(data["mass"] * 4 * polar, rel=1e-4)
    inverted = gr.FromSTLfile(fileName, pOff=P, Aoff=np.eye(3))
    assert volume(inverted) == pytest.approx(-volume(g), rel=1e-5)
    assert gr.InconsistentTriangles(inverted) == 0
    np.testing.assert_allclose(gr.BoundingBox(inverted)[0], gr.BoundingBox(g)[0] + P, rtol=1e-5)


def test_text_stl_round_trip_and_errors(tmp_path):
    g = gr.Brick(P)
    fileName = tmp_path / "brick.stl"
    gr.ExportSTL(g, str(fileName))
    read = gr.FromSTLfileASCII(str(fileName), RED)
    assert volume(read) == pytest.approx(volume(g))
    assert gr.InconsistentTriangles(read) == 0
    text = fileName.read_text()
    fileName.write_text(text.replace("outer loop", "outer", 1))
    with pytest.raises(ValueError, match="line 3: expected 'outer loop', received 'outer'"):
        gr.FromSTLfileASCII(str(fileName))
    fileName.write_text(text[: text.index("endloop")])
    with pytest.raises(ValueError, match="ends within a facet, 'endloop' is missing"):
        gr.FromSTLfileASCII(str(fileName))


class Vertex:
    def __init__(self, nr):
        self.nr = nr


class Surface:
    """The part of a netgen mesh that is read: one quadratic triangle."""

    def Points(self):
        return [(0, 0, 0), (2, 0, 0), (0, 2, 0), (1, 1, 0), (0, 1, 0), (1, 0, 0)]

    def Elements2D(self):
        nodes = [Vertex(i + 1) for i in range(6)]
        return [type("Element", (), {"points": nodes, "vertices": nodes[:3]})]

    def SecondOrder(self):
        pass


@pytest.mark.parametrize("order", [1, 2])
def test_netgen_surfaces(order):
    points, triangles, normals = gr.NGsolveMesh2PointsAndTrigs(ngMesh=Surface(), meshOrder=order, scale=3)
    g = gr.FromPointsAndTrigs(points, triangles, normals=normals)
    np.testing.assert_allclose(normals, np.tile([0, 0, 1], (len(points), 1)))
    assert sum(gdu.ComputeTriangleArea(*points[t]) for t in triangles) == pytest.approx(18)
    assert gr.InconsistentTriangles(g) == 0
    points, triangles = gr.NGsolveMesh2PointsAndTrigs(ngMesh=Surface(), meshOrder=order, addNormals=False)
    assert points.shape == (6, 3)
    with pytest.raises(ValueError, match="either mesh or ngMesh"):
        gr.NGsolveMesh2PointsAndTrigs()


def test_solids_of_revolution_have_no_triangles_without_area():
    """Contours that begin and end on the axis: cylinders, arrows, cups; contact geometry takes no others."""
    for g in (gr.Cylinder(P, AXIS, 0.2), gr.Arrow(P, AXIS, 0.01), gr.SolidOfRevolution(P, AXIS, CONTOUR, RED, 12)):
        corners = g["points"].reshape(-1, 3)[g["triangles"].reshape(-1, 3)]
        sides = corners - np.roll(corners, 1, axis=1)
        areas = 0.5 * np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
        assert areas.min() > 1e-6 * areas.max()


def test_a_basis_without_length_is_empty():
    assert len(gr.Basis(length=0)["points"]) == 0


def test_linked_cylinders_have_the_area_of_their_outline():
    r0, r1, d, n = 0.1, 0.2, 0.7, 400
    g = gr.LinkedCylinders(P, P + [0, d, 0], [0.5, 0, 0], r0, r1, 0.05, 0.05, n)
    a = np.arcsin((r1 - r0) / d)
    area = (r0 + r1) * d * np.cos(a) + r1**2 * (np.pi / 2 + a) + r0**2 * (np.pi / 2 - a) - 2 * np.pi * 0.05**2
    assert is_closed(g)
    assert volume(g) == pytest.approx(0.5 * area, rel=1e-3)
    np.testing.assert_allclose(gr.BoundingBox(g), [P - [0, r0, r1], P + [0.5, d + r1, r1]], atol=1e-4)
    contained = gr.LinkedCylinders(P, P + [0, 0.05, 0], [0.5, 0, 0], r0, r1, nTiles=12)
    assert volume(contained) == pytest.approx(np.pi * r1**2 * 0.5 * prism(12))


def test_gears_are_closed_with_the_area_of_their_outline():
    gear = machines.InvoluteGear(module=0.1, nTeeth=9)
    x, y = gear.GenerateGear().T
    area = 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
    g = gr.InvoluteGear(gear, 0.2)
    assert is_closed(g)
    assert volume(g) == pytest.approx(0.2 * area)
    hole = gr.InvoluteGear(gear, 0.2, radius=0.1, nTilesCylinder=12)
    assert volume(hole) == pytest.approx(0.2 * (area - np.pi * 0.01 * prism(12)))
    internal = machines.InvoluteGear(module=0.1, nTeeth=20, isInternalGear=True)
    x, y = internal.GenerateGear().T
    area = 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
    ring = gr.InvoluteGear(internal, 0.2, radius=1.4)
    assert volume(ring) == pytest.approx(0.2 * (np.pi * 1.96 * prism(32) - area))


def test_bearing_rings_are_closed_and_leave_room_for_the_balls():
    data = machines.GetBallBearingData([0, 1, 1], 0.08, 0.04, 0.02, 7, radiusBalls=0.006)
    rings = gr.BallBearingRings(**data)
    assert set(rings) == {"innerRingGraphics", "outerRingGraphics", "cageGraphics"}
    for g in rings.values():
        assert is_closed(g)
        assert volume(g) > 0
    with pytest.raises(ValueError, match="BallBearingRings: nTilesGrooves: expected an integer, 1 or more"):
        gr.BallBearingRings(**data | {"nTilesGrooves": 0})
    with pytest.raises(ValueError, match="BallBearingRings: innerGrooveRadius: expected a positive number"):
        gr.BallBearingRings(**data | {"innerGrooveRadius": 0})
    data["innerGrooveRadius"] = 1e-4
    with pytest.raises(ValueError, match="innerGrooveTorusRadius and innerRingShoulderRadius of at most"):
        gr.BallBearingRings(**data)


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: gr.Sphere(majorAngleMin=1, majorAngleMax=0), "increasing angles"),
        (lambda: gr.Sphere(innerRadius=5), "innerRadius: expected a number between 0 and radius=0.1, received 5"),
        (lambda: gr.Cuboid([[0, 0, 0]]), "pList: expected a list of 8 points"),
        (lambda: gr.Brick(color=[1, 0, 0]), "^Brick: color: expected a vector with 4 components"),
        (lambda: gr.Cylinder(color="red"), "^Cylinder: color: expected a vector with 4 components"),
        (lambda: gr.Sphere(addEdges=1, edgeColor=3), "^Sphere: edgeColor: expected a vector with 4 components"),
        (lambda: gr.Brick([1, float("nan"), 0]), "^Brick: points: expected finite coordinates"),
        (lambda: gr.Brick(size=[float("nan")] * 3), "^Brick: size: expected finite side lengths"),
        (lambda: gr.Brick(["1", "2", "3"]), "^Brick: centerPoint: expected a vector with 3 components"),
        (lambda: gr.Brick(np.array([1j, 2, 3])), "^Brick: centerPoint: expected a vector with 3 components"),
        (lambda: gr.SolidExtrusion(SQUARE, "all", 1), "SolidExtrusion: segments: expected rows of 2 numbers"),
        (lambda: gr.SolidExtrusion(SQUARE, [], 1), "SolidExtrusion: segments: expected pairs of numbers of points"),
        (
            lambda: gr.SolidExtrusion(SQUARE, [[0, 1], [1, 6], [6, 0]], 1),
            "SolidExtrusion: segments: expected numbers of points, 0 to 5, received 6",
        ),
        (lambda: gr.InvoluteGear(None, 1), "InvoluteGear: involuteGear: expected a machines.InvoluteGear"),
        (lambda: gr.ToothedRack(0.1, 0, 0.1, 0.2, 0.1), "ToothedRack: nTeeth: expected an integer, 1 or more"),
        (lambda: gr.ToothedRack(-0.1, 3, 0.1, 0.2, 0.1), "ToothedRack: module: expected a positive number"),
        (lambda: gr.Lines([[0, 0]]), "pList: expected a list of points with 3 coordinates each"),
        (lambda: gr.Lines([P, P], shape="quadratic"), "pList: expected an odd number of points, 3 or more"),
        (lambda: gr.Lines([P, P], shape="round"), "shape: expected 'linear' or 'quadratic', received 'round'"),
        (lambda: gr.Spheres([P, P], [1, 2, 3]), "radii: expected one radius, or 2, that are not negative"),
        (lambda: gr.Spheres([P], 1, [1, 0, 0]), "colors: expected 4 RGBA values, or those of 1 points"),
        (lambda: gr.ToPointsAndTrigs(gr.Text()), "expected 'TriangleList', received 'Text'"),
        (lambda: gr.FromPointsAndTrigs(np.eye(3), [[0, 1, 2]], [1, 2]), "color: expected 4 RGBA values"),
        (
            lambda: gr.FromPointsAndTrigs(np.eye(3), [[0, 1, 3]]),
            "triangles: expected numbers of points, 0 to 2, received 3",
        ),
        (lambda: gr.FromPointsAndTrigs(np.eye(3), [[0, 1, -1]]), "numbers of points, 0 to 2, received -1"),
        (lambda: gr.FromPointsAndTrigs(np.eye(3), [[0, 1, 1.5]]), "numbers of points, 0 to 2, received 1.5"),
        (lambda: gr.FromPointsAndTrigs(np.zeros((6, 2)), [[0, 1, 2]]), "points: expected rows of 3 numbers"),
        (
            lambda: gr.FromPointsAndTrigs(np.eye(3), [[0, 1, 2]], normals=[[0, 0, 1]]),
            "normals: expected 3 numbers for each",
        ),
        (lambda: gr.FromPointsAndTrigs([], [[0, 1, 2]]), "of which there are none, received 0"),
        (
            lambda: gr.ToPointsAndTrigs({"type": "TriangleList", "points": np.eye(3), "triangles": [0, 1, 3]}),
            "received 3",
        ),
        (
            lambda: gdu.RefineMesh(np.eye(3), [[0, 1, -3]]),
            "RefineMesh: triangles: expected numbers of points.*received -3",
        ),
        (lambda: gdu.ShrinkMeshNormalToSurface(np.eye(3), [[0, 1, 2.5]], 0.1), "triangles: .*received 2.5"),
        (lambda: gdu.ComputeTriangularMesh([[0, 0], [1, 0], [0, 1]], [[0, 5]]), "segments: .*0 to 2, received 5"),
    ],
)
def test_wrong_arguments_are_named(call, text):
    with pytest.raises(ValueError, match=text):
        call()


def test_small_numbers_of_tiles_are_raised_with_a_warning():
    with pytest.warns(UserWarning, match="nTiles = 1 is too small, using 3"):
        gr.Cylinder(nTiles=1)


def test_colors_and_materials():
    assert gr.color.red == [1, 0, 0, 1]
    assert len(gr.colorList) == gdu.color4listSize == 16
    assert gr.material.chrome == [-1, -1, -1, gr.material.indexChrome]


def test_mesh_helpers():
    points, triangles = gr.ToPointsAndTrigs(gr.Brick([0, 0, 0], [2, 2, 2]))
    fine = gr.FromPointsAndTrigs(*gdu.RefineMesh(points, triangles))
    assert len(fine["points"]) == 3 * (8 + 18)
    assert is_closed(fine)
    assert volume(fine) == pytest.approx(8)
    shrunk = gr.FromPointsAndTrigs(*gdu.ShrinkMeshNormalToSurface(points, triangles, 0.1))
    np.testing.assert_allclose(gr.BoundingBox(shrunk)[1], 0.9)
    nodes = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [1, 1, 1], [0, 1, 0.5], [1, 0, 0.5]]
    z = lambda x, y: (x + y) * (1 - (x + y) / 2) + x * y  # noqa: E731
    assert [p[2] for p in nodes] == [z(*p[:2]) for p in nodes]
    for (x, y, _), normal in zip(nodes, gdu.Compute6NodeTrigsNormals(nodes), strict=True):
        expected = np.array([-(1 - x - y + y), -(1 - x - y + x), 1])
        np.testing.assert_allclose(normal, expected / np.linalg.norm(expected), atol=1e-12)
    assert gdu.SegmentsFromPoints(range(3), invert=True).tolist() == [[1, 0], [2, 1], [0, 2]]
    assert gdu.SegmentsFromPoints(range(3), 5, closeCurve=False).tolist() == [[5, 6], [6, 7]]
    assert gdu.SwitchTripletOrder([1, 2, 3]) == [1, 3, 2]


def test_triangular_mesh_has_holes_and_reports_duplicates():
    outer, hole = gdu.CirclePointsAndSegments(radius=2, invert=True), gdu.CirclePointsAndSegments(pointIndexOffset=16)
    tri = gdu.ComputeTriangularMesh(outer[0] + hole[0], outer[1] + hole[1])
    corners = tri.points[tri.simplices]
    areas = 0.5 * np.linalg.det(np.diff(corners, axis=1))
    assert (areas > 0).all()
    assert areas.sum() == pytest.approx(np.pi * (4 - 0.01) * prism(16))
    with pytest.warns(UserWarning, match="duplicated"):
        gdu.ComputeTriangularMesh([[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]], [[0, 1], [1, 2], [2, 3], [3, 0]])
