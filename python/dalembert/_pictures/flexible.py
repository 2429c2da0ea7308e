"""How beams, cables, plates and finite element meshes are drawn, deformed, and colored by their outputs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray, as_point_numbers
from dalembert._core import ConfigurationType, CrossSectionType, OutputVariableType
from dalembert._pictures import graphics_data, meshes
from dalembert._pictures.bodies import user_shapes
from dalembert._pictures.contour import Contour
from dalembert._pictures.looks import rgba
from dalembert._pictures.meshes import Mesh
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import Places, frame_along
from dalembert._pictures.scene import Source

Item = dict[str, Any]
NO_EDGES: IntArray = np.empty((0, 2), int)
LINE_WIDTH = 3.0  # pixels, of beams whose section nobody has given
FEW = 50  # nodes of a body without a mesh, between which lines are distinguishable


def _stations(pen: Pen, length: float) -> FloatArray:
    tiling = max(int(pen.looks.setting("bodies.beams.axialTiling")), 1)
    return np.linspace(-0.5, 0.5, tiling + 1) * length


def _axis(pen: Pen, number: int, stations: FloatArray) -> FloatArray | None:
    """Return points of the axis of a beam; displacements are scaled as the settings say."""
    now = [pen.places.body(number, (x, 0, 0)) for x in stations]
    if any(point is None for point in now):
        return None
    points = np.array(now)
    factor = float(pen.looks.setting("bodies.deformationScaleFactor"))
    if factor != 1:
        rest = Places(pen.places.mbs, ConfigurationType.Reference)
        before = np.array([rest.body(number, (x, 0, 0)) for x in stations])
        points = before + factor * (points - before)
    return points


def _beam_stations(pen: Pen, item: Item) -> FloatArray:
    """Return positions along a beam: cables count from their first node, other beams from their middle."""
    stations = _stations(pen, float(item["physicsLength"]))
    return stations - stations[0] if "Cable" in item["objectType"] else stations


def _values(pen: Pen, colors: Contour, number: int, stations: FloatArray, repeat: int) -> FloatArray | None:
    """Return the numbers along a beam, for sections of so many points."""
    if not colors.active:
        return None
    numbers = [colors.number(pen.places.body_output(number, colors.variable, (x, 0, 0))) for x in stations]
    return np.repeat(numbers, repeat)


def _diagram(pen: Pen, colors: Contour, number: int, stations: FloatArray, axis: FloatArray) -> None:
    """Draw the numbers along a beam as lines normal to its axis, as bodies.beams.drawVertical says."""
    beams = pen.looks.setting("bodies.beams")
    numbers = _values(pen, colors, number, stations, 1)
    if not beams.drawVertical or numbers is None:
        return
    tangents = np.gradient(axis, axis=0)
    flat = np.ptp(axis[:, 2]) <= 1e-9 * pen.looks.size
    sides = [np.array([-t[1], t[0], 0.0]) if flat else frame_along(t)[:, 0] for t in np.asarray(tangents)]
    across = np.array(sides)
    across /= np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
    heights = float(beams.drawVerticalFactor) * (numbers + float(beams.drawVerticalOffset))
    ends, color = axis + heights[:, None] * across, rgba(beams.drawVerticalColor)
    pen.line(ends, color)
    for begin, end, value in zip(axis, ends, numbers, strict=True):
        if beams.drawVerticalLines:
            pen.line([begin, end], color)
        if beams.drawVerticalValues:
            pen.label(end, f"{value:.4g}", color)


def planar_beam(pen: Pen, colors: Contour, number: int, item: Item) -> None:
    """A band of the height that is to be drawn, in the plane of the beam; a line if that is zero."""
    stations = _beam_stations(pen, item)
    if (axis := _axis(pen, number, stations)) is None:
        return
    _diagram(pen, colors, number, stations, axis)
    height, color = float(item["VdrawHeight"]), pen.looks.color(item, "bodies.defaultColor")
    if height <= 0 and not colors.active:
        pen.line(axis, color, LINE_WIDTH)
        return
    height = height if height > 0 else 0.012 * pen.looks.size
    tangents = np.gradient(axis, axis=0)
    across = np.cross([0, 0, 1.0], tangents)
    across *= 0.5 * height / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-300)
    section = np.array([[-1.0, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])
    deep = np.array([0, 0, 0.5 * height])
    points = np.array([axis + y * across + z * deep for y, z in section]).transpose(1, 0, 2)
    mesh = Mesh(points.reshape(-1, 3), meshes.grid_triangles(len(axis), len(section)))
    pen.mesh(mesh, color=color, values=_values(pen, colors, number, stations, len(section)))


def cable(pen: Pen, colors: Contour, number: int, item: Item) -> None:
    """A tube; a line if its radius is zero."""
    stations = _beam_stations(pen, item)
    if (axis := _axis(pen, number, stations)) is None:
        return
    _diagram(pen, colors, number, stations, axis)
    radius, color = float(item.get("Vradius", 0.0)), pen.looks.color(item, "bodies.defaultColor")
    if radius <= 0 and not colors.active:
        pen.line(axis, color, LINE_WIDTH)
        return
    tiles = max(2 * int(pen.looks.setting("bodies.beams.crossSectionTiling")), 6)
    mesh = meshes.swept(axis, radius if radius > 0 else 0.006 * pen.looks.size, tiles)
    pen.mesh(mesh, color=color, values=_values(pen, colors, number, stations, tiles + 1))


def beam(pen: Pen, colors: Contour, number: int, item: Item) -> None:
    """The polygon of the section, carried along with the rotation of the beam; a tube without one."""
    section = _section(item.get("VsectionGeometry"))
    stations = _beam_stations(pen, item)
    axis = _axis(pen, number, stations) if section is not None else None
    if section is None or axis is None:
        cable(pen, colors, number, item)
        return
    _diagram(pen, colors, number, stations, axis)
    frames = [_beam_frame(pen, number, axis, i, float(x)) for i, x in enumerate(stations)]
    outline = np.vstack([section, section[:1]])
    sections = [
        p + np.outer(outline[:, 0], f[:, 1]) + np.outer(outline[:, 1], f[:, 2])
        for p, f in zip(axis, frames, strict=True)
    ]
    points = np.array(sections)
    n = len(outline)
    side = meshes.grid_triangles(len(points), n)
    end = meshes.filled(section)
    triangles = np.concatenate([side, end[:, ::-1], end + n * (len(points) - 1)])
    color = pen.looks.color(item, "bodies.defaultColor")
    pen.mesh(Mesh(points.reshape(-1, 3), triangles), color=color, values=_values(pen, colors, number, stations, n))


def _section(geometry: Any) -> FloatArray | None:
    """Return the polygon of a section, in the y and z axes of the beam; None if it has no polygon."""
    if geometry is None:
        return None
    if geometry.crossSectionType == CrossSectionType.Circular and geometry.crossSectionRadiusY > 0:
        angles = np.linspace(0, 2 * np.pi, 24, endpoint=False)
        radii = [geometry.crossSectionRadiusY, geometry.crossSectionRadiusZ or geometry.crossSectionRadiusY]
        return np.stack([np.cos(angles), np.sin(angles)], 1) * radii
    points = np.array([list(point) for point in geometry.polygonalPoints], float)
    return points if len(points) >= 3 else None


def _beam_frame(pen: Pen, number: int, axis: FloatArray, index: int, x: float) -> FloatArray:
    """Return the axes of a section: x along the beam, y and z those of the section."""
    rotation = pen.places.body_rotation(number, (x, 0, 0))
    if rotation is not None:
        return rotation
    angles = pen.places.body_output(number, OutputVariableType.Rotation, (x, 0, 0))
    if angles is not None and len(angles) == 3:
        return _tait_bryan(angles)
    around = frame_along(np.gradient(axis, axis=0)[index])
    return np.stack([around[:, 2], around[:, 0], around[:, 1]], axis=1)


def _tait_bryan(angles: FloatArray) -> FloatArray:
    """Return the rotation about x, then about the new y and z."""
    matrix = np.eye(3)
    for i, angle in enumerate(angles):
        j, k = (i + 1) % 3, (i + 2) % 3
        step = np.eye(3)
        step[j, j] = step[k, k] = np.cos(angle)
        step[j, k], step[k, j] = -np.sin(angle), np.sin(angle)
        matrix = matrix @ step
    return matrix


def plate(pen: Pen, colors: Contour, number: int, item: Item) -> None:
    """A plate between its four nodes, with its thickness unless bodies.shells.drawSolid is off."""
    nodes = [pen.places.node_output(n, OutputVariableType.Position) for n in item["nodeNumbers"]]
    places = [place for place in nodes if place is not None]
    if len(places) == 4:
        values = None
        if colors.active:
            values = np.array([colors.number(pen.places.node_output(n, colors.variable)) for n in item["nodeNumbers"]])
        corners, color = np.array(places), pen.looks.color(item, "bodies.defaultColor")
        thickness = np.resize(np.asarray(item.get("physicsThickness") or [0.0], float), 4)
        thickness = thickness * float(pen.looks.setting("bodies.shells.thicknessFactor"))
        if pen.looks.setting("bodies.shells.drawSolid") and thickness.any():
            pen.mesh(_slab(corners, thickness), color=color, values=None if values is None else np.tile(values, 2))
        else:
            mesh = Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]]), edges=np.array([[0, 1], [1, 2], [2, 3], [3, 0]]))
            pen.mesh(mesh, color=color, values=values)


def _slab(corners: FloatArray, thickness: FloatArray) -> Mesh:
    """Return a quadrangle with a thickness at each corner; normals are those of the sides that meet there."""
    before, after = np.roll(corners, 1, axis=0) - corners, np.roll(corners, -1, axis=0) - corners
    normals = np.cross(after, before)
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
    half = 0.5 * thickness[:, None] * normals
    upper, lower = [[0, 1, 2], [0, 2, 3]], [[4, 6, 5], [4, 7, 6]]
    rim = [[a, a + 4, b] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))]
    rim += [[b, a + 4, b + 4] for a, b in ((0, 1), (1, 2), (2, 3), (3, 0))]
    edges = [[a, (a + 1) % 4] for a in range(4)]
    return Mesh(np.concatenate([corners + half, corners - half]), np.array(upper + lower + rim), edges=np.array(edges))


class MeshBodies:
    """Draws bodies with mesh nodes; data of the mesh is computed once."""

    def __init__(self, mbs: Any) -> None:
        self.mbs = mbs
        self._known: dict[int, tuple[IntArray, IntArray, IntArray]] = {}  # given mesh, triangles and edges

    def draw(self, pen: Pen, colors: Contour, number: int, item: Item) -> None:
        """Draw the deformed triangles of the mesh or, if there are none, its nodes and lines between coupled nodes."""
        default = rgba(pen.looks.setting("bodies.defaultColor"))
        shapes = user_shapes(self.mbs, number, item, default, f"object {number} '{item['name']}'")
        graphics_data.draw(pen, shapes, np.zeros(3), np.eye(3))
        points = self._points(pen, number, item)
        if points is None:
            return
        triangles, edges = self._faces(number, item, len(points))
        color = pen.looks.color(item, "bodies.defaultColor")
        if len(triangles):
            if not pen.looks.setting("view0.scene.showMeshEdges"):
                edges = NO_EDGES
            if not pen.looks.setting("view0.scene.showMeshFaces"):
                triangles = triangles[:0]
            dark = (0.3 * color[0], 0.3 * color[1], 0.3 * color[2], 1.0)
            pen.mesh(
                Mesh(points, triangles, None, None, edges, dark),
                color=color,
                values=self._values(pen, colors, number, len(points)),
                source=Source("mesh", number) if points.dtype == np.float32 else None,
            )
        if not len(triangles):
            for pair in _coupled(pen, item):
                pen.line(points[pair], color)
        if item.get("VshowNodes") or not len(triangles):
            radius = 0.5 * pen.looks.length("nodes.defaultSize", 0.015)
            for point in points:
                pen.sphere(point, radius, color)

    def _faces(self, number: int, item: Item, points: int) -> tuple[IntArray, IntArray]:
        """Return the triangles of a mesh, and their edges."""
        given = np.asarray(item.get("VtriangleMesh", []))
        known = self._known.get(number)
        if known is not None and known[0] is not given and np.array_equal(known[0], given):
            known = self._known[number] = given, *known[1:]
        if known is None or known[0] is not given:
            name = f"object {number} '{item['name']}': VtriangleMesh"
            triangles = as_point_numbers(name, given, 3, points)
            sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
            self._known[number] = given, triangles, np.unique(np.sort(sides, axis=1), axis=0)
        return self._known[number][1:]

    def _points(self, pen: Pen, number: int, item: Item) -> FloatArray | None:
        """Return the positions of the mesh nodes."""
        factor = float(pen.looks.setting("bodies.deformationScaleFactor"))
        points = pen.places.mesh_points(number)
        if points is not None:
            if factor != 1:
                change = pen.places.mesh_outputs(number, OutputVariableType.Displacement)
                points = points if change is None else points + (factor - 1) * change
            return points
        if "referencePositions" in item:
            return _reference_points(pen, item)
        found = []
        for node in item["nodeNumbers"][1 if item["objectType"] == "FFRF" else 0 :]:
            if (place := pen.places.node(node)) is None:
                return None
            if factor != 1:
                change = pen.places.node_output(node, OutputVariableType.Displacement)
                place = place if change is None else place + (factor - 1) * change
            found.append(place)
        return np.array(found) if found else None

    def _values(self, pen: Pen, colors: Contour, number: int, count: int) -> FloatArray | None:
        if not colors.active:
            return None
        known = pen.places.mesh_numbers(number, colors.variable, colors.component)
        if known is not None and len(known) == count:
            return known
        return np.array([colors.number(pen.places.mesh_output(number, colors.variable, node)) for node in range(count)])


def nodes_line(pen: Pen, number: int, item: Item) -> None:
    """Draw a line through the nodes of an element of a package."""
    places = [pen.places.node(node) for key in item for node in _node_numbers(key, item[key])]
    points = [place for place in places if place is not None]
    if len(points) > 1:
        pen.line(np.array(points), pen.looks.color(item, "bodies.defaultColor"), LINE_WIDTH)


def _node_numbers(key: str, value: Any) -> Sequence[int]:
    """Return the entries of nodeNumbers, or of nodeNumber0, nodeNumber1 and so on."""
    if not key.startswith("nodeNumber"):
        return ()
    return [int(node) for node in np.atleast_1d(value)]


def _coupled(pen: Pen, item: Item) -> IntArray:
    """Return pairs of nodes of a body of few nodes between which there is stiffness."""
    if item["objectType"] != "GenericODE2" or len(item["nodeNumbers"]) > FEW:
        return np.empty((0, 2), int)
    nodes = [pen.places.item("Node", node) for node in item["nodeNumbers"]]
    of_nodes = np.repeat(np.arange(len(nodes)), [len(node["referenceCoordinates"]) for node in nodes])
    pairs = of_nodes[np.argwhere(item["stiffnessMatrix"].Convert2DenseMatrix())].reshape(-1, 2)
    return np.unique(pairs[pairs[:, 0] < pairs[:, 1]], axis=0)


def _reference_points(pen: Pen, item: Item) -> FloatArray | None:
    """Return the undeformed mesh in the frame of its first node, before the system is assembled."""
    points = np.asarray(item["referencePositions"], float).reshape(-1, 3)
    frame = pen.places.frame(item["nodeNumbers"][0])
    return frame[0] + points @ frame[1].T if len(points) and frame is not None else None


DRAWINGS = {
    "ANCFCable2D": planar_beam,
    "ALEANCFCable2D": planar_beam,
    "BeamGeometricallyExact2D": planar_beam,
    "ANCFCable": cable,
    "ANCFBeam": beam,
    "BeamGeometricallyExact": beam,
    "ANCFThinPlate": plate,
}
MESH_BODIES = ("GenericODE2", "FFRF", "FFRFreducedOrder")
