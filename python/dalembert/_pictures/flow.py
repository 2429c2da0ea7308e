"""Scenes one after the other, of which all that keeps its shape is moved as arrays, and the rest drawn again.

Drawing code says to which frame of an item its parts stick (Pen.stick): that of a node, an object or a marker, its
place alone, or the span between two markers. The first scene is drawn item by item; from then on, parts that stick are
products of two arrays: where their frames are, from one call per kind of items, and where they stand in them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dalembert import _core
from dalembert._checks import FloatArray, IntArray
from dalembert._core import ConfigurationType
from dalembert._pictures.pen import Pen
from dalembert._pictures.places import KINDS, Places
from dalembert._pictures.scene import Balls, Herd, Instance, Label, Scene, Threads

if TYPE_CHECKING:
    from dalembert._pictures.making import SceneMaker

STRETCH = 2.0  # a spring that becomes longer or shorter by more than that gets another mesh
Frame = tuple[str, int, int]  # kind, and numbers: (Node, 3, -1), (MarkerPlace, 2, -1), (Span, 4, 5)


class Frames:
    """Where parts may stick; each frame is found once per scene."""

    def __init__(self, keys: list[Frame]) -> None:
        kinds = np.array([key[0] for key in keys], dtype=object)
        numbers = np.array([key[1:] for key in keys], int).reshape(-1, 2)
        self._count = len(keys)
        self._parts = []  # of each kind: which frames, whose, whether they turn
        for kind in KINDS:
            for turns, name in ((True, kind), (False, f"{kind}Place")):
                chosen = np.flatnonzero(kinds == name)
                if len(chosen):
                    self._parts.append((kind, turns, _range(chosen), _range(numbers[chosen, 0])))
        self._spans = np.flatnonzero(kinds == "Span")
        self._ends = numbers[self._spans]
        self._lengths: FloatArray | None = None
        self._all = [part[1] for part in self._parts] == [True] and not len(self._spans)  # of one kind: not copied

    def rows(self, places: Places) -> FloatArray | None:
        """Return all frames (n x 3 x 4); None if one is not there any more, or a span has become another one."""
        rows = np.empty((0 if self._all else self._count, 3, 4))
        for kind, turns, chosen, numbers in self._parts:
            found = places.rows(kind)
            assert found is not None
            if self._all:
                rows = found[numbers]
            elif turns:
                rows[chosen] = found[numbers]
            else:
                rows[chosen, :, :3] = np.eye(3)
                rows[chosen, :, 3] = found[numbers, :, 3]
        if len(self._spans):
            found = places.rows("Marker")
            assert found is not None
            begin, axes = found[self._ends[:, 0], :, 3], found[self._ends[:, 1], :, 3] - found[self._ends[:, 0], :, 3]
            lengths = np.sqrt((axes**2).sum(axis=1))
            if self._lengths is None:
                self._lengths = lengths
            if not ((lengths < STRETCH * self._lengths) & (lengths > self._lengths / STRETCH)).all():
                return None
            rows[self._spans] = _along(begin, axes, lengths)
        return rows if np.isfinite(rows.sum()) else None


def _range(numbers: IntArray) -> Any:
    """Return a slice if numbers follow each other: it is read without an index."""
    first, last = int(numbers[0]), int(numbers[-1])
    same = last - first == len(numbers) - 1 and bool((np.diff(numbers) == 1).all())
    return slice(first, last + 1) if same else numbers


def _along(begin: FloatArray, axes: FloatArray, lengths: FloatArray) -> FloatArray:
    """Return frames that begin at points, with third columns to the points at their other ends; as frame_along."""
    z = axes / lengths[:, None]
    x = np.eye(3)[np.argmin(np.abs(z), axis=1)]
    x = x - (x * z).sum(axis=1)[:, None] * z
    x /= np.sqrt((x**2).sum(axis=1))[:, None]
    return np.stack([x, np.cross(z, x), axes, begin], axis=2)


class Stuck:
    """Parts that stand in frames: in which, and where."""

    def __init__(self, index: Any, local: FloatArray) -> None:
        self._index, self._local = index, local
        self._chosen = _range(index) if len(index) and np.abs(local - np.eye(3, 4)).max() < 1e-12 else None

    def placed(self, rows: FloatArray) -> FloatArray:
        """Return where they are (n x 3 x 4); those that all stand as their frames do are not multiplied."""
        if self._chosen is not None:
            return rows[self._chosen]
        return np.asarray(_core._place(rows, self._index, self._local))


class Flow:
    """The scenes of one maker."""

    def __init__(self, maker: SceneMaker) -> None:
        self._maker = maker
        self._frames: Frames | None = None

    def forget(self) -> None:
        """Draw everything again next time: items or settings have changed."""
        self._frames = None

    def scene(self, configuration: ConfigurationType = ConfigurationType.Visualization) -> Scene:
        """Return the scene in a configuration."""
        maker = self._maker
        if maker.source is not None and maker.source.changed():
            self.forget()
        with maker.looks.kept():
            if self._frames is not None and maker.is_assembled():
                places = maker.places(configuration)
                rows = self._frames.rows(places)
                if rows is not None:
                    return self._moved(places, rows)
            return self._begin(configuration)

    def _begin(self, configuration: ConfigurationType) -> Scene:
        """Draw everything, and note what sticks to what."""
        self._frames = None
        scene, pen = self._maker.draw(configuration)
        if pen is None or pen.places.source is None:
            return scene
        frames = Frames(list(pen.frames))
        rows = frames.rows(pen.places)
        if rows is None or not len(pen.frames):
            return scene
        self._sort(scene, pen, rows)
        self._frames = frames
        return self._moved(pen.places, rows)

    def _sort(self, scene: Scene, pen: Pen, rows: FloatArray) -> None:
        """Keep where parts stand in the frames that they stick to; items with parts that stick to none are loose."""
        stuck, self._items = pen.stuck, scene.items
        loose = {part.item for part, frame in zip(scene.instances, stuck.instances, strict=True) if frame < 0}
        loose |= {part.item for part in scene.instances if part.values is not None}
        loose |= {sphere[3] for sphere, frame in zip(scene.spheres, stuck.spheres, strict=True) if frame < 0}
        loose |= {line[3] for line, frame in zip(scene.lines, stuck.lines, strict=True) if frame < 0}
        loose |= {item for item, frame in stuck.labels if frame < 0}
        self._loose = sorted(loose - {-1})
        inverse = np.zeros((len(rows), 4, 4))
        inverse[:, :3], inverse[:, 3, 3] = rows, 1
        inverse = np.ascontiguousarray(np.linalg.inv(inverse)[:, :3])

        def local(index: Any, parts: Any) -> Stuck:
            numbers = np.array(index, np.int32)
            return Stuck(numbers, np.asarray(_core._place(inverse, numbers, np.array(parts, float))))

        groups: dict[tuple[int, Any], list[tuple[int, Instance]]] = {}
        for part, frame in zip(scene.instances, stuck.instances, strict=True):
            if part.item not in loose:
                groups.setdefault((id(part.mesh), part.color), []).append((frame, part))
        self._herds = []
        for group in groups.values():
            parts = np.empty((len(group), 3, 4))
            parts[:, :, :3] = [part.matrix for _, part in group]
            parts[:, :, 3] = [part.place for _, part in group]
            first, items = group[0][1], np.array([part.item for _, part in group])
            self._herds.append((first.mesh, first.color, items, local([frame for frame, _ in group], parts)))

        kept = [(s, f) for s, f in zip(scene.spheres, stuck.spheres, strict=True) if s[3] not in loose]
        self._balls = (
            np.array([s[1] for s, _ in kept], float),
            np.array([s[2] for s, _ in kept], float).reshape(-1, 4),
            np.array([s[3] for s, _ in kept], int),
            local([f for _, f in kept], _points([s[0] for s, _ in kept])),
        )
        lines = [(line, f) for line, f in zip(scene.lines, stuck.lines, strict=True) if line[3] not in loose]
        counts = np.array([len(line[0]) for line, _ in lines], int)
        self._threads = (
            counts,
            [line[1] for line, _ in lines],
            [line[2] for line, _ in lines],
            np.array([line[3] for line, _ in lines], int),
            local(np.repeat([f for _, f in lines], counts), _points([p for line, _ in lines for p in line[0]])),
        )
        texts = [(label, f) for label, (item, f) in zip(scene.labels, stuck.labels, strict=True) if item not in loose]
        self._labels = ([t for t, _ in texts], local([f for _, f in texts], _points([t.place for t, _ in texts])))

    def _moved(self, places: Places, rows: FloatArray) -> Scene:
        """Return the scene with all that sticks where its frames are now, and the rest drawn again."""
        scene = Scene(items=self._items)
        for mesh, color, items, parts in self._herds:
            scene.herds.append(Herd(mesh, color, items, parts.placed(rows)))
        radii, colors, items, points = self._balls
        scene.balls = Balls(points.placed(rows)[:, :, 3], radii, colors, items)
        counts, shades, widths, items, points = self._threads
        scene.threads = Threads(points.placed(rows)[:, :, 3], counts, shades, widths, items)
        texts, points = self._labels
        for text, place in zip(texts, points.placed(rows)[:, :, 3], strict=True):
            scene.labels.append(Label(place, text.text, text.color, text.size, text.shift))
        self._maker.draw_again(scene, places, self._loose)
        return scene


def _points(points: Any) -> FloatArray:
    """Return points as places (n x 3 x 4) without rotation."""
    rows = np.zeros((len(points), 3, 4))
    if len(points):
        rows[:, :, 3] = points
    return rows
