"""Incremental scenes: rigid parts are moved as arrays, and the rest is drawn again.

Drawing code attaches its parts to a frame of an item (Pen.stick): that of a node, an object or a marker, its position
only, or the span between two markers. The first scene is drawn item by item; later poses of attached parts are the
product of their frame and their relative pose: _MovingParts computes all of them at once. Parts that change their shape
or color need not be drawn again for the viewer if their source provides points and numbers (scene.Source).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray
from dalembert._core import ConfigurationType
from dalembert._pictures import contacts
from dalembert._pictures.meshes import Mesh
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import Places
from dalembert._pictures.scene import Balls, Herd, Instance, Label, Scene, Threads

if TYPE_CHECKING:
    from dalembert._pictures.making import SceneMaker

# A scene is so many times as large as a mesh that rotations right to 3e-5 may turn: places are right to 1e-6 of it.
SMALL = 30


class Sent(NamedTuple):
    """An array of a message: poses of parts, or points and colors of a changing part."""

    form: str  # empty: it stays as it is
    group: int = -1  # group of moving parts
    item: int = -1  # provides points, or the number that becomes a color
    numbers: FloatArray = np.zeros(0)  # one per part; points of a ball relative to its center


class Flow:
    """The scenes of one maker."""

    def __init__(self, maker: SceneMaker) -> None:
        self._maker, self._changes = maker, maker.changes()
        self._parts: Any = None  # _MovingParts
        self._complete = False
        self._extent = 0.0  # extent of the positions of all frames, initially

    def forget(self) -> None:
        """Draw everything again next time: items or settings have changed."""
        self._parts, self._complete = None, False

    def scene(self, configuration: ConfigurationType = ConfigurationType.Visualization) -> Scene:
        """Return the scene in a configuration."""
        maker = self._maker
        self._forget_what_has_changed()
        with maker.looks.kept():
            if (places := self._found(configuration)) is not None:
                return self._moved(maker.places_again(configuration), places)
            return self._begin(configuration)

    def _found(self, configuration: ConfigurationType) -> list[FloatArray] | None:
        """Return the poses of the parts of all groups; None if they cannot be updated."""
        if self._parts is None or not self._parts.find(configuration):
            return None
        found = [self._parts.placed(group) for group in range(len(self._herds) + 3)]
        return None if any(rows is None for rows in found) else found

    def moving(self) -> Any:
        """Return the _MovingParts of all moving parts; None if other parts are drawn anew in each scene."""
        self._forget_what_has_changed()
        return self._parts if self._complete else None

    def sent(self) -> list[Sent]:
        """Return the data of the parts for the viewer, array by array."""
        herds = [Sent("turns" if self._is_small(mesh) else "rows", group) for mesh, *_, group in self._herds]
        changing = [sent for part in self._changing for sent in self._sent_of(part)]
        balls, threads, labels = self._balls[-1], self._threads[-1], self._labels[-1]
        others = [Sent("place and number", balls, numbers=self._balls[0]), Sent("place", threads), Sent("")]
        return [*herds, *changing, *others, Sent("place", labels)]

    def _sent_of(self, part: Instance) -> list[Sent]:
        """Return points and colors of a part that changes its shape or color."""
        kind, number = part.source or ("", -1)
        if kind == "mesh":
            points = Sent(kind, item=number)
        else:
            points = Sent(kind, self._seats[part.item], number, (part.mesh.points @ part.matrix.T).ravel())
        return [points] if part.values is None else [points, Sent("shades")]

    def keep(self, entries: list[tuple[Any, ...]]) -> None:
        """Store the state of the viewer in the _MovingParts, in addition to the result of sent()."""
        self._parts.keep(entries, self._maker.rule_of_colors(), self._maker.source.modal_meshes)

    def range_was(self, limits: tuple[float, float]) -> None:
        """Store the range of colors that the viewer has."""
        self._maker.range_was(limits)

    def _is_small(self, mesh: Mesh) -> bool:
        """Return whether a mesh reaches so little from its frame that a rotation of less precision is not seen."""
        reach = float(np.linalg.norm(mesh.points, axis=1).max(initial=0))
        return SMALL * reach <= self._extent

    def _forget_what_has_changed(self) -> None:
        if (changes := self._maker.changes()) != self._changes:
            self._changes = changes
            self.forget()

    def _begin(self, configuration: ConfigurationType) -> Scene:
        """Draw everything, and record attachments."""
        self.forget()
        scene, pen = self._maker.draw(configuration, crowded=True)
        if pen is None or pen.places.source is None:
            return scene
        parts = _core._MovingParts(self._maker.mbs, pen.frames.rows())
        if not parts.find(configuration):
            return scene
        if not np.isfinite(parts.frames()).all():
            return scene
        self._sort(scene, pen, parts)
        chosen = zip(scene.instances, pen.stuck.instances, strict=True)
        seats = {part.item: frame for part, frame in chosen if part.source is not None and frame >= 0}
        self._seats = {item: int(parts.add([frame])) for item, frame in seats.items()}
        places = parts.frames()[:, :, 3]
        self._extent = float(np.linalg.norm(np.ptp(places, axis=0))) if len(places) else 0.0
        self._parts = parts
        found = self._found(configuration)
        return scene if found is None else self._moved(self._maker.places_again(configuration), found)

    def _sort(self, scene: Scene, pen: Pen, all_parts: Any) -> None:
        """Store the relative poses of attached parts; items with unattached parts are drawn again."""
        stuck, self._items = pen.stuck, scene.items
        loose = {part.item for part, frame in zip(scene.instances, stuck.instances, strict=True) if frame < 0}
        loose |= {part.item for part in scene.instances if part.values is not None}
        loose |= {sphere[3] for sphere, frame in zip(scene.spheres, stuck.spheres, strict=True) if frame < 0}
        loose |= {line[3] for line, frame in zip(scene.lines, stuck.lines, strict=True) if frame < 0}
        loose |= {item for item, frame in stuck.labels if frame < 0}
        loose |= {number for number, item in enumerate(scene.items) if contacts.FORCES in (item.kind, item.type_name)}
        self._loose = sorted(loose - {-1})
        frames = all_parts.frames()

        def add(index: Any, parts: Any) -> int:
            numbers = np.array(index, np.int32)
            inverse = np.linalg.inv(_square(frames[numbers]))
            return int(all_parts.add(numbers, (inverse @ _square(np.array(parts, float)))[:, :3]))

        groups: dict[tuple[int, Any], list[tuple[int, Instance]]] = {}
        for part, frame in zip(scene.instances, stuck.instances, strict=True):
            if part.item not in loose:
                groups.setdefault((id(part.mesh), part.color), []).append((frame, part))
        self._herds = [
            (herd.mesh, herd.color, herd.items, int(all_parts.add(numbers)))
            for herd, numbers in zip(scene.herds, stuck.herds, strict=True)
        ]
        for members in groups.values():
            parts = np.empty((len(members), 3, 4))
            parts[:, :, :3] = [part.matrix for _, part in members]
            parts[:, :, 3] = [part.place for _, part in members]
            first, items = members[0][1], np.array([part.item for _, part in members])
            self._herds.append((first.mesh, first.color, items, add([frame for frame, _ in members], parts)))

        kept = [(s, f) for s, f in zip(scene.spheres, stuck.spheres, strict=True) if s[3] not in loose]
        balls = scene.balls
        self._balls = (
            np.concatenate([balls.radii, np.array([s[1] for s, _ in kept], float)]),
            np.concatenate([balls.colors, np.array([s[2] for s, _ in kept], float).reshape(-1, 4)]),
            np.concatenate([balls.items, np.array([s[3] for s, _ in kept], int)]),
            int(all_parts.add(stuck.balls))
            if not kept
            else add(
                [*stuck.balls, *(f for _, f in kept)],
                np.concatenate([_points(balls.centers), _points([s[0] for s, _ in kept])]),
            ),
        )
        lines = [(line, f) for line, f in zip(scene.lines, stuck.lines, strict=True) if line[3] not in loose]
        counts = np.array([len(line[0]) for line, _ in lines], int)
        self._threads = (
            counts,
            [line[1] for line, _ in lines],
            [line[2] for line, _ in lines],
            np.array([line[3] for line, _ in lines], int),
            add(np.repeat([f for _, f in lines], counts), _points([p for line, _ in lines for p in line[0]])),
        )
        texts = [(label, f) for label, (item, f) in zip(scene.labels, stuck.labels, strict=True) if item not in loose]
        self._labels = ([t for t, _ in texts], add([f for _, f in texts], _points([t.place for t, _ in texts])))

    def _moved(self, places: Places, found: list[FloatArray]) -> Scene:
        """Return the scene with all that sticks where its frames are now, and the rest drawn again."""
        scene = Scene(items=self._items)
        for mesh, color, items, group in self._herds:
            scene.herds.append(Herd(mesh, color, items, found[group]))
        radii, colors, items, group = self._balls
        scene.balls = Balls(found[group][:, :, 3], radii, colors, items)
        counts, shades, widths, items, group = self._threads
        scene.threads = Threads(found[group][:, :, 3], counts, shades, widths, items)
        texts, group = self._labels
        for text, place in zip(texts, found[group][:, :, 3], strict=True):
            scene.labels.append(Label(place, text.text, text.color, text.size, text.shift))
        self._maker.draw_again(scene, places, self._loose)
        self._changing = [part for part in scene.instances if part.is_seen()]
        drawn = scene.spheres or scene.lines or len(scene.labels) > len(texts) or self._maker.has_traces()
        known = {part.item for part in scene.instances if self._is_told(part)}
        self._complete = not drawn and known.issuperset(self._loose) and all(map(self._is_told, scene.instances))
        return scene

    def _is_told(self, part: Instance) -> bool:
        """Return whether messages can describe a part."""
        return part.source is not None and (part.source.kind == "mesh" or part.item in self._seats)


def _square(rows: FloatArray) -> FloatArray:
    """Return matrices (n x 4 x 4) with the last row 0, 0, 0, 1."""
    result = np.zeros((len(rows), 4, 4))
    result[:, :3], result[:, 3, 3] = rows, 1
    return result


def _points(points: Any) -> FloatArray:
    """Return points as places (n x 3 x 4) without rotation."""
    rows = np.zeros((len(points), 3, 4))
    if len(points):
        rows[:, :, 3] = points
    return rows
