"""Construction of a scene from a system: drawing of each item, order and sizes."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray, IntArray
from dalembert._core import ConfigurationType
from dalembert._pictures import connectors, contacts, contour, flexible, forces, symbols, traces
from dalembert._pictures.bodies import Bodies, node_in_place_of
from dalembert._pictures.contour import Contour
from dalembert._pictures.crowds import RIGID, Crowd, groups
from dalembert._pictures.forces import Forces
from dalembert._pictures.looks import Looks, rgba
from dalembert._pictures.meshes import Mesh, edges_of_box
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import Parameters, Places
from dalembert._pictures.scene import DrawnItem, Herd, Instance, Scene
from dalembert._pictures.trees import Trees

TINY = 1e-30  # m, of symbols while the size of the scene is found
NOTHING = 1e-13  # of coordinates: sizes that are rounding errors
KINDS = ("Node", "Object", "Marker", "Load", "Sensor")
# Items without a position in space: their coordinates belong to a controller, a hydraulic circuit or a field.
WITHOUT_PLACE = {
    "ObjectGenericODE1": "equations of first order have no shape",
    "NodeGenericAE": "algebraic coordinates have no place",
    "NodeGenericData": "data coordinates have no place",
    "NodeGenericODE1": "coordinates of first order have no place",
    "NodeGenericODE2": "coordinates without meaning have no place; the objects that use them are drawn",
    "MarkerNodeODE1Coordinate": "coordinates of first order have no place",
    "SensorUserFunction": "it measures values of other sensors",
}


class SceneMaker:
    """Makes scenes of one system, one for each state; constant data is computed once.

    Sizes relative to the system use the first scene, so that they do not vary in a film.
    """

    def __init__(self, mbs: Any, settings: Any, number: int = 0) -> None:
        """`number`: that of the system in its container."""
        self.mbs, self.looks, self.number = mbs, Looks(settings), number
        self._range: tuple[float, float] | None = None  # color range of the last scene
        self.bodies, self.meshes, self.trees = Bodies(mbs), flexible.MeshBodies(mbs), Trees(mbs)
        self.source = _core._ScenePlaces(mbs)  # positions of all items of the assembled system
        self._items: Parameters = {}  # valid since the last change
        self._changes = 0
        self.stored: traces.Stored = lambda sensor: (mbs.GetSensorStoredData(sensor), self.source.stored_frames(sensor))
        self._sized = False
        self.forces: Forces | None = None  # if they are drawn

    def show_forces(self, flag: bool) -> None:
        """Draw arrows of forces, or none."""
        self.forces, self.looks.forces = Forces() if flag else None, flag

    def scene(self, configuration: ConfigurationType | None = None) -> Scene:
        """Return the scene in a configuration: the visualization state, or the reference before assembly."""
        with self.looks.kept():
            return self.draw(configuration)[0]

    def is_assembled(self) -> bool:
        """Return whether outputs can be asked for in all configurations."""
        try:
            self.mbs.systemData.GetODE2Coordinates(ConfigurationType.Visualization)
        except RuntimeError:
            return False
        return True

    def places(self, configuration: ConfigurationType) -> Places:
        """Return where everything is, in an assembled system."""
        return Places(self.mbs, configuration, self.source)

    def places_again(self, configuration: ConfigurationType) -> Places:
        """Return the same, for few items that are drawn for pages again and again: their parameters are kept."""
        self.changes()
        return Places(self.mbs, configuration, self.source, self._items, coarse=True)

    def link_at(self, number: int, point: FloatArray) -> int:
        """Return the link of a kinematic tree that is drawn at a point; -1 for its base, and for other objects."""
        item = self.mbs.GetObject(number)
        if item["objectType"] != "KinematicTree":
            return -1
        pen = Pen(Scene(), self.places_again(ConfigurationType.Visualization), self.looks)
        pen.take(DrawnItem("Object", number, item["objectType"], item["name"]))
        return self.trees.link_at(pen, number, item, point)

    def changes(self) -> int:
        """Return how often items have come, gone or got other parameters."""
        if self.source.changed():
            self._changes += 1
            self._items = {}
            self.bodies.forget_markers()
            self.trees.forget_markers()
        return self._changes

    def draw(self, configuration: ConfigurationType | None, crowded: bool = False) -> tuple[Scene, Pen | None]:
        """Return a scene, and the pen with the attachments; None if they are not usable.

        `crowded`: items with equal appearance may be arrays in the scene.
        """
        self.changes()
        assembled = self.is_assembled()
        if configuration is None:
            configuration = ConfigurationType.Visualization
        if not assembled:
            configuration = ConfigurationType.Reference
        places = self.places(configuration) if assembled else Places(self.mbs, configuration)
        if not self._sized:
            self._find_size(places)
            self._sized = True
        self.looks.crowd = self._count("Object")
        scene = Scene()
        pen, colors = Pen(scene, places, self.looks), Contour(self.looks)
        crowd = Crowd(pen, self.bodies) if crowded and assembled and not colors.active else None
        for kind in KINDS:
            self._draw_kind(pen, colors, kind, crowd)
        if crowd is not None:
            crowd.draw()
        for item in contacts.drawn_items(self.mbs, self.looks):
            pen.take(item)
            contacts.draw(pen, item)
        if self.forces is not None and assembled:
            self.forces.measure(pen)
            for item in self.forces.drawn_items(pen):
                pen.take(item)
                self.forces.draw(pen, item)
        self._trace = len(scene.items)
        pen.take(DrawnItem("Trace", 0, "", ""))
        self._finish(pen, colors)
        whole = [change for change in (add_normals, add_box, self._highlight) if change(pen)]
        return pen.scene, None if whole else pen

    def _highlight(self, pen: Pen) -> bool:
        own = int(self.looks.setting("interactive.highlightMbsNumber")) == self.number
        return own and highlight(pen)

    def draw_again(self, scene: Scene, places: Places, chosen: list[int]) -> None:
        """Draw some items of a scene with a complete list of items, and all parts that are drawn anew in each scene."""
        pen, colors = Pen(scene, places, self.looks), Contour(self.looks)
        if self.forces is not None:
            self.forces.measure(pen)
        for number in chosen:
            if number != self._trace:
                pen.go_on(number)
                self._draw_item(pen, colors, scene.items[number])
        pen.go_on(self._trace)
        self._finish(pen, colors)

    def _finish(self, pen: Pen, colors: Contour) -> None:
        """Draw parts without an item, and compute time and range of the colors."""
        scene = pen.scene
        scene.time = float(self.mbs.systemData.GetTime(pen.places.configuration)) if pen.places.source else 0.0
        if self.forces is not None and pen.places.source:
            scene.information.append(self.forces.words(self.looks.size))
        if self.has_traces():
            traces.draw(pen, scene.time, self.stored)
        if self.looks.setting("view0.scene.drawWorldBasis"):
            pen.frame(np.zeros(3), np.eye(3), self.looks.length("view0.scene.worldBasisSize", 0.2))
        scene.value_name = colors.name
        scene.value_range = colors.range(scene.values())
        if self._range is not None and not self.looks.setting("contour.reduceRange"):
            scene.value_range = min(scene.value_range[0], self._range[0]), max(scene.value_range[1], self._range[1])
        self._range = scene.value_range if colors.active else None

    def rule_of_colors(self) -> tuple[Any, ...]:
        """Return which numbers have which colors, as _MovingParts.keep() has it; the last scene has been finished."""
        with self.looks.kept():
            colors = Contour(self.looks)
            shown, grows = self._range, self._range is not None and not self.looks.setting("contour.reduceRange")
            limits, table = colors.fixed_range(), contour.table(self.looks)
            automatic = bool(self.looks.setting("contour.automaticRange"))
            return colors.variable, colors.component, automatic, bool(grows), limits, shown or limits, table

    def range_was(self, limits: tuple[float, float]) -> None:
        """Take over the range of a scene that was not drawn here."""
        self._range = limits if self._range is not None else None

    def has_traces(self) -> bool:
        """Return whether sensors of this system leave traces."""
        return int(self.looks.setting("sensors.traces.sensorsMbsNumber")) == self.number and traces.wanted(self.looks)

    def _find_size(self, places: Places) -> None:
        """Compute the size from bodies, positions of nodes and ends of connectors, without symbols."""
        self.looks.size = TINY
        rough = Scene()
        pen = Pen(rough, places, self.looks)
        colors = Contour(self.looks)
        pen.take(DrawnItem("Object", -1, "", ""))
        pen.line(self._places_of_nodes(places), (0.0, 0.0, 0.0, 1.0))
        alike: dict[int, tuple[Mesh, list[IntArray]]] = {}  # bodies by the mesh that they have
        left = np.ones(self._count("Object"), bool)
        for group in groups(places, "Object", len(left)):
            if not group.first.get("Vshow", True):
                left[group.numbers] = False
            elif group.first["objectType"] in RIGID and len(group.numbers):
                meshes = self.bodies.meshes(pen, int(group.numbers[0]), group.first)
                if meshes is not None:  # bodies without meshes extend to their markers only
                    left[group.numbers] = False if meshes else self.bodies.with_markers(group.numbers)
                for mesh in meshes or ():
                    alike.setdefault(id(mesh), (mesh, []))[1].append(group.numbers)
        for number in np.flatnonzero(left).tolist():
            item = places.item("Object", number)
            name = item["objectType"]
            if not item.get("Vshow", True):
                continue
            is_plain = name in RIGID and places.turns("Object", number)
            if is_plain and (found := self.bodies.meshes(pen, number, item)) is not None:
                for mesh in found:
                    alike.setdefault(id(mesh), (mesh, []))[1].append(np.array([number]))
                continue
            pen.take(DrawnItem("Object", number, name, ""))
            self._draw_body(pen, colors, number, item)
            if "RollingDisc" not in item["objectType"] and "markerNumbers" in item:  # the ground below them is anywhere
                joined = [place for m in item["markerNumbers"] if (place := places.marker(m)) is not None]
                pen.take(DrawnItem("Object", -1, "", ""))
                pen.line(joined, (0.0, 0.0, 0.0, 1.0))
        pen.take(DrawnItem("Object", -1, "", ""))
        for mesh, members in alike.values():
            numbers = np.concatenate(members)
            rows = np.asarray(places.rows("Object"))[numbers]
            rough.herds.append(Herd(mesh, None, np.full(len(numbers), pen.item), rows))
        box = rough.box()
        size = 0.0 if box is None else float(np.linalg.norm(box[1] - box[0]))
        rounding = 0.0 if box is None else NOTHING * float(np.abs(box).max())
        self.looks.size = size if size > max(100 * TINY, rounding) else 1.0

    def _places_of_nodes(self, places: Places) -> FloatArray:
        """Return where nodes are (n x 3), as far as they have a place."""
        rows = places.rows("Node")
        rows = np.full((self._count("Node"), 3, 4), np.nan) if rows is None else rows
        stands = np.isfinite(rows[:, :, 3]).all(axis=1)
        others = [place for n in np.flatnonzero(~stands) if (place := places.node(int(n))) is not None]
        return np.concatenate([rows[stands, :, 3], np.reshape(others, (-1, 3))])

    def _count(self, kind: str) -> int:
        return int(getattr(self.mbs.systemData, f"NumberOf{kind}s")())

    def _draw_kind(self, pen: Pen, colors: Contour, kind: str, crowd: Crowd | None) -> None:
        """Draw all items of a kind, as far as they and their group of settings are shown."""
        flags: dict[str, tuple[bool, bool]] = {}  # by group: whether items, and their numbers, are shown
        name_of_type = f"{kind.lower()}Type"
        count = self._count(kind)
        left = np.ones(count, bool)
        for group in groups(pen.places, kind, count) if crowd is not None else ():
            settings = self.looks.setting(self._group(kind, group.first))
            hidden = not settings.show or not group.first.get("Vshow", True)
            if settings.show and settings.showNumbers:
                continue
            if hidden or (crowd is not None and crowd.takes_all(kind, group)):
                left[group.numbers] = False
        for number in np.flatnonzero(left).tolist():
            item = pen.places.item(kind, number)
            name = self._group(kind, item)
            if name not in flags:
                group = self.looks.setting(name)
                flags[name] = bool(group.show), bool(group.showNumbers)
            shown, numbered = flags[name]
            hidden = not item.get("Vshow", True)
            if not shown or (hidden and (not numbered or node_in_place_of(pen.places, item) is None)):
                continue
            pen.take(DrawnItem(kind, number, item[name_of_type], item["name"]))
            if crowd is not None and not numbered and crowd.takes(kind, number, item):
                pen.places.forget(kind, number)
                continue
            if not hidden:
                self._draw(pen, colors, kind, number, item)
            if numbered:
                self._number(pen, kind, number, item)

    def _draw_item(self, pen: Pen, colors: Contour, drawn: DrawnItem) -> None:
        """Draw one item."""
        if drawn.kind == contacts.KIND:
            contacts.draw(pen, drawn)
            return
        if drawn.kind == forces.KIND:
            if self.forces is not None:
                self.forces.draw(pen, drawn)
            return
        kind, number = drawn.kind, drawn.number
        item = pen.places.item(kind, number)
        if item.get("Vshow", True):
            self._draw(pen, colors, kind, number, item)
        if self.looks.setting(self._group(kind, item)).showNumbers:
            self._number(pen, kind, number, item)

    def _number(self, pen: Pen, kind: str, number: int, item: dict[str, Any]) -> None:
        """Write the number of an item where it is."""
        if (place := self._label_place(pen, kind, number, item)) is None:
            return
        if kind == "Sensor":
            pen.stick()
        else:
            owner, which = (
                (kind, number) if kind in ("Node", "Object") else pen.places.seat(item.get("markerNumber", number))
            )
            known = pen.places.rows(owner)
            same = known is not None and np.array_equal(known[which, :, 3], place)
            pen.stick(owner if same else "", which, turns=False)
        pen.label(place, f"{kind[0]}{number}")

    @staticmethod
    def _label_place(pen: Pen, kind: str, number: int, item: dict[str, Any]) -> FloatArray | None:
        if kind == "Sensor":
            return symbols.sensor_place(pen, item)
        places = pen.places
        return places.marker(item["markerNumber"]) if kind == "Load" else getattr(places, kind.lower())(number)

    @staticmethod
    def _group(kind: str, item: dict[str, Any]) -> str:
        """Return the group of settings that an item belongs to."""
        if kind != "Object":
            return f"{kind.lower()}s"
        return "connectors" if connectors.drawing(item["objectType"]) else "bodies"

    def _draw(self, pen: Pen, colors: Contour, kind: str, number: int, item: dict[str, Any]) -> None:
        if kind == "Node":
            symbols.node(pen, colors, number, item)
        elif kind == "Marker":
            symbols.marker(pen, number, item)
        elif kind == "Load":
            symbols.load(pen, number, item)
        elif kind == "Sensor":
            symbols.sensor(pen, number, item)
        elif drawing := connectors.drawing(item["objectType"]):
            drawing(pen, item)
            connectors.axes(pen, item)
        else:
            self._draw_body(pen, colors, number, item)

    def _draw_body(self, pen: Pen, colors: Contour, number: int, item: dict[str, Any]) -> None:
        name = item["objectType"]
        if name in RIGID or name == "Ground":
            self.bodies.draw(pen, colors, number, item)
        elif name in flexible.DRAWINGS:
            flexible.DRAWINGS[name](pen, colors, number, item)
        elif name in flexible.MESH_BODIES:
            self.meshes.draw(pen, colors, number, item)
        elif name == "KinematicTree":
            self.trees.draw(pen, number, item)
        elif "nodeNumber" in item:  # of a package
            self.bodies.draw(pen, colors, number, item)
        else:
            flexible.nodes_line(pen, number, item)


def add_normals(pen: Pen) -> bool:
    """Draw normals of faces and at their corners, as openGL.drawFaceNormals and drawVertexNormals say."""
    gl = pen.looks.setting("openGL")
    length = pen.looks.length("openGL.drawNormalsLength", 0.03)
    if not (gl.drawFaceNormals or gl.drawVertexNormals):
        return False
    pen.scene = pen.scene.unbound()
    for part in pen.scene.instances:
        points = part.mesh.points @ part.matrix.T + part.place
        a, b, c = (points[part.mesh.triangles[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-300)
        pen.go_on(part.item)
        if gl.drawFaceNormals:
            for middle, normal in zip((a + b + c) / 3, normals, strict=True):
                pen.line([middle, middle + length * normal], rgba(gl.advanced.faceNormalsColor))
        if gl.drawVertexNormals:
            own = part.mesh.normals @ np.linalg.pinv(part.matrix) if part.mesh.normals is not None else None
            for k, corner in enumerate((a, b, c)):
                turned = normals if own is None else own[part.mesh.triangles[:, k]]
                turned = turned / np.maximum(np.linalg.norm(turned, axis=1, keepdims=True), 1e-300)
                for point, normal in zip(corner, turned, strict=True):
                    pen.line([point, point + length * normal], rgba(gl.advanced.vertexNormalsColor))
    return True


def add_box(pen: Pen) -> bool:
    """Draw the box that an automatic zoom uses, as openGL.advanced.showBoundingBox says."""
    box = pen.scene.box() if pen.looks.setting("openGL.advanced.showBoundingBox") else None
    if box is None:
        return False
    pen.go_on(-1)
    for edge in edges_of_box(box):
        pen.line(edge, (0.3, 0.3, 0.3, 1.0))
    return True


def highlight(pen: Pen) -> bool:
    """Give the item that interactive.highlightItemIndex names its color, and all others that of the others.

    Return whether it names one.
    """
    scene, looks = pen.scene, pen.looks
    number = int(looks.setting("interactive.highlightItemIndex"))
    kind = looks.setting("interactive.highlightItemType").name
    chosen = [i for i, item in enumerate(scene.items) if item.kind == kind and item.number == number]
    there = kind == "Object" and 0 <= number < pen.places.mbs.systemData.NumberOfObjects()
    if there and (node := node_in_place_of(pen.places, pen.places.item(kind, number))) is not None:
        chosen += [i for i, item in enumerate(scene.items) if item.kind == "Node" and item.number == node]
    if number < 0 or not chosen:
        return False
    bright = rgba(looks.setting("interactive.advanced.highlightColor"))
    others = rgba(looks.setting("interactive.advanced.highlightOtherColor"))
    pick = dict.fromkeys(chosen, (*bright[:3], 1.0))
    scene = pen.scene = scene.unbound()
    scene.instances = [Instance(i.mesh, i.matrix, i.place, pick.get(i.item, others), i.item) for i in scene.instances]
    spheres, scene.spheres = scene.spheres, []
    for center, radius, _, item in spheres:
        pen.go_on(item)
        pen.sphere(center, radius, pick.get(item, others))
    return True
