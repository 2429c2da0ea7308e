"""Scenes as messages for the viewer: the whole scene if its parts have changed, otherwise only moving parts.

A message is a JSON head and arrays behind it: the length of the head (4 bytes), the head, filled up with blanks to a
multiple of 8, and arrays of little-endian numbers, each at a multiple of 4. The head lists them in `arrays` as
[kind, count], where kind is f4, u4, u1 or r6; null means an unchanged array of the whole scene. r6 are poses of six
words instead of twelve numbers: position (f4), then the first two rows of the rotation in units of
1 / 32000 (signed, of two bytes each); the third row is their cross product. Only meshes that are small compared with
the scene use them (flow.SMALL), so that positions are accurate to 1e-6 of
the scene size. Browsers that have drawn the previous picture receive only new points of lines, such as traces: `kept`
in
the head lists [position, position in the previous points, count] of unchanged numbers, which are not in the array.
"""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray
from dalembert._pictures import contour
from dalembert._pictures.camera import Camera
from dalembert._pictures.flow import Flow
from dalembert._pictures.looks import Looks
from dalembert._pictures.meshes import Mesh, Rgba, same_form, sharp_edges
from dalembert._pictures.scene import DrawnItem, Instance, Scene

Piece = bytes | memoryview


class Picture(NamedTuple):
    """Messages of a picture."""

    scene: int  # the number of the scene that it is of
    whole: Callable[[], bytes]  # makes the message of the whole scene
    frame: Sequence[Piece]  # moving parts, for browsers that have the scene
    grown: Callable[[], Sequence[Piece] | None] | None = None  # makes it for pages that have drawn the picture before

    def after(self, before: bool) -> Sequence[Piece]:
        """Return the frame; `before`: the browser has drawn the previous picture."""
        grown = self.grown() if before and self.grown is not None else None
        return self.frame if grown is None else grown


Key = tuple[int, int]  # item, and how manieth of its parts
KINDS = {"f4": "<f4", "u4": "<u4", "u1": "u1"}


class Arrays:
    """Arrays of a message; a head refers to them by number."""

    def __init__(self) -> None:
        self.parts: list[npt.NDArray[Any] | None] = []

    def add(self, kind: str, values: npt.ArrayLike) -> int:
        """Keep an array; return its number."""
        self.parts.append(np.ascontiguousarray(values, dtype=KINDS[kind]).ravel())
        return len(self.parts) - 1

    def shades(self, colors: npt.ArrayLike) -> int:
        """Keep colors, numbers from 0 to 1, as bytes."""
        return self.add("u1", np.round(255 * np.clip(np.asarray(colors, float), 0, 1)))

    def message(self, head: dict[str, Any]) -> bytes:
        """Return a message."""
        return b"".join(self.pieces(head))

    def pieces(self, head: dict[str, Any]) -> list[Piece]:
        """Return a message in pieces: joining millions of bytes takes as long as sending them."""
        names = {np.dtype(dtype): kind for kind, dtype in KINDS.items()}
        table = [None if part is None else [names[part.dtype], part.size] for part in self.parts]
        text = json.dumps(head | {"arrays": table}, separators=(",", ":")).encode()
        text += b" " * (-(len(text) + 4) % 8)
        pieces: list[Piece] = [len(text).to_bytes(4, "little") + text]
        for part in self.parts:
            if part is not None and part.nbytes:
                pieces.append(part.data.cast("B"))
                if left := -part.nbytes % 4:
                    pieces.append(b"\0" * left)
        return pieces


UNTURNED = np.eye(3)
LONG = 50  # points of a line that is worth a look whether it has grown
SCENES = 4  # remembered scenes for picking: a browser may refer to one that has just been replaced


class Stage:
    """State of the browsers: detects whether a scene has the same parts as the previous one."""

    def __init__(self) -> None:
        self.number = 0  # number of the whole scene
        self.items: list[DrawnItem] = []  # items of the scene
        self._items_of: dict[int, list[DrawnItem]] = {}  # indexed by the number of a scene
        self._layout: Any = None
        self._kept: Any = None
        self._meshes: dict[Key, Mesh] = {}
        self._deforming: set[Key] = set()
        self._forms: dict[Key, int] = defaultdict(int)  # how often more has changed of a mesh than its points
        self._first: list[npt.NDArray[Any] | None] = []
        self._moved: set[int] = set()
        self._words = ""  # text of the head of a frame, in which only time and range change
        self._whole: Callable[[], bytes] = bytes
        self._lines: list[FloatArray] = []  # points of the last picture
        self._told: Any = None  # _MovingParts with the state of the browsers

    def item(self, scene: int, number: int) -> DrawnItem | None:
        """Return the entry of a picked item; None if it no longer exists."""
        items = self._items_of.get(scene, [])
        entry = items[number] if 0 <= number < len(items) else None
        return entry if entry in self.items else None

    def messages(self, scene: Scene, looks: Looks, words: dict[str, Any], camera: Callable[[], Camera]) -> Picture:
        """Return the messages of a scene; `words` are parts of the head of the whole one."""
        with looks.kept():
            return self._messages(scene, looks, words, camera)

    def _messages(self, scene: Scene, looks: Looks, words: dict[str, Any], camera: Callable[[], Camera]) -> Picture:
        opacity = contour.opacity(looks)
        parts = self._parts(scene)
        rigid, deformed = self._sorted(parts)
        layout = (
            [(id(herd.mesh), herd.color, id(herd.items)) for herd in scene.herds],
            [id(part) if len(part) else None for part in (scene.balls.items, scene.threads.items)],
            [(id(group[0][1].mesh), group[0][1].color, [key for key, _ in group]) for group in rigid],
            [(key, self._forms[key], part.color, part.values is None) for key, part in deformed],
            [(color, item) for _, _, color, item in scene.spheres],
            [(label.text, label.color) for label in scene.labels],
            [(color, item) for _, color, _, item in scene.lines],
            len(scene.items),
            opacity,
            words,
        )
        moving, head = self._frame(scene, looks, rigid, deformed)
        if not (same := layout == self._layout):
            self.number += 1
            self._layout, self._first, self._moved = layout, moving.parts, set()
            herds, meshes = list(scene.herds), [group[0][1].mesh for group in rigid]
            # kept alive, because objects are identified by their id
            self._kept = (herds, meshes, scene.balls, scene.threads)
            self.items = scene.items
            self._items_of[self.number] = self.items
            self._items_of.pop(self.number - SCENES, None)
        head["scene"] = self.number
        items = self.items

        def whole() -> bytes:
            told = {**words, **head, "kind": "scene", "items": items}
            return _whole(scene, rigid, deformed, moving, opacity, told, camera())

        self._words = f',"scene":{self.number}'
        self._whole, self._told = whole, None
        changed = self._changes(moving)
        lines, before = [scene.threads.points, *(points for points, *_ in scene.lines)], self._lines
        self._lines = lines
        grown = cache(lambda: _grown(changed, head, lines, before)) if same else None
        return Picture(self.number, whole, changed.pieces(head), grown)

    def moved(self, flow: Flow) -> Picture | None:
        """Return the messages if only moving parts of a flow have changed since it made the last scene.

        None if they cannot follow. The whole scene is that last one: pages take the frames after it.
        """
        parts = flow.moving()
        if parts is not self._told:
            sent = flow.sent()
            first = [part if entry.form else () for part, entry in zip(self._first, sent, strict=True)]
            flow.keep([(*entry, part) for entry, part in zip(sent, first, strict=True)])
            self._told = parts
        self._lines = []
        if (frame := parts.message(self._words, self._moved)) is None:
            return None
        flow.range_was(parts.range)
        return Picture(self.number, self._whole, [frame])

    @staticmethod
    def _parts(scene: Scene) -> list[tuple[Key, Instance]]:
        counts: dict[int, int] = defaultdict(int)
        parts = []
        for part in scene.instances:
            if part.is_seen():
                parts.append(((part.item, counts[part.item]), part))
                counts[part.item] += 1
        return parts

    def _sorted(
        self, parts: list[tuple[Key, Instance]]
    ) -> tuple[list[list[tuple[Key, Instance]]], list[tuple[Key, Instance]]]:
        """Return groups of one mesh at several positions, and parts that change their shape or colors."""
        groups: dict[tuple[int, Any], list[tuple[Key, Instance]]] = {}
        deformed = []
        for key, part in parts:
            before = self._meshes.get(key)
            if before is not None and before is not part.mesh:
                if before.points.shape == part.mesh.points.shape:
                    self._deforming.add(key)
                if not same_form(before, part.mesh):
                    self._forms[key] += 1
            if part.values is not None or part.source is not None or key in self._deforming:
                deformed.append((key, part))
            else:
                groups.setdefault((id(part.mesh), part.color), []).append((key, part))
        self._meshes = {key: part.mesh for key, part in parts}
        return list(groups.values()), deformed

    def _frame(
        self, scene: Scene, looks: Looks, rigid: list[list[tuple[Key, Instance]]], deformed: list[tuple[Key, Instance]]
    ) -> tuple[Arrays, dict[str, Any]]:
        """Return where everything is."""
        arrays = Arrays()
        for herd in scene.herds:
            arrays.add("f4", herd.rows)
        for group in rigid:
            rows = np.empty((len(group), 3, 4))
            rows[:, :, :3] = [part.matrix for _, part in group]
            rows[:, :, 3] = [part.place for _, part in group]
            arrays.add("f4", rows)
        for _, part in deformed:
            stands = np.array_equal(part.matrix, UNTURNED) and not part.place.any()
            arrays.add("f4", part.mesh.points if stands else part.mesh.points @ part.matrix.T + part.place)
            if part.values is not None:
                arrays.add("u1", contour.shades(looks, part.values, scene.value_range))
        balls, threads = scene.balls, scene.threads
        loose = np.array([[*center, radius] for center, radius, _, _ in scene.spheres]).reshape(-1, 4)
        arrays.add("f4", np.concatenate([np.column_stack([balls.centers, balls.radii]), loose]))
        arrays.add("f4", np.concatenate([threads.points, *(points for points, *_ in scene.lines)]))
        arrays.add("u4", np.concatenate([threads.counts, np.array([len(line[0]) for line in scene.lines], int)]))
        arrays.add("f4", [label.place for label in scene.labels])
        head: dict[str, Any] = {"kind": "frame", "time": scene.time, "range": list(scene.value_range)}
        return arrays, head

    def _changes(self, moving: Arrays) -> Arrays:
        """Return the arrays of a frame, without those that have not moved since the message of the whole scene."""
        changed = Arrays()
        for number, (part, first) in enumerate(zip(moving.parts, self._first, strict=True)):
            if number not in self._moved and not _same(part, first):
                self._moved.add(number)
            changed.parts.append(part if number in self._moved else None)
        return changed


def _grown(
    changed: Arrays, head: dict[str, Any], lines: list[FloatArray], old_lines: list[FloatArray]
) -> list[Piece] | None:
    """Return the message of a frame without points of long lines that are as in the picture before; None: all of it."""
    place = len(changed.parts) - 3  # points of lines, their counts, and places of labels come last
    points = changed.parts[place]
    if points is None or len(lines) != len(old_lines):
        return None
    sent, kept, at, old = [], [], 0, 0
    for line, before in zip(lines, old_lines, strict=True):
        same = LONG <= len(before) <= len(line) and np.array_equal(line[: len(before)], before)
        count = 3 * len(before) if same else 0
        if same:
            kept.append([at, old, count])
        sent.append(points[at + count : at + line.size])
        at, old = at + line.size, old + before.size
    if not kept:
        return None
    shorter = Arrays()
    shorter.parts = list(changed.parts)
    shorter.parts[place] = np.concatenate(sent)
    return shorter.pieces(head | {"kept": kept})


def _same(a: Any, b: Any) -> bool:
    """Return whether two arrays are equal; most of those that stay so are empty."""
    return len(a) == len(b) and (len(a) == 0 or bool((a == b).all()))


def _whole(
    scene: Scene,
    rigid: list[list[tuple[Key, Instance]]],
    deformed: list[tuple[Key, Instance]],
    moving: Arrays,
    opacity: float,
    words: dict[str, Any],
    camera: Camera,
) -> bytes:
    """Return all that is drawn; `opacity` is that of the colors of numbers."""
    arrays = Arrays()
    arrays.parts = list(moving.parts)
    meshes = [_shape(arrays, herd.mesh, herd.color) | {"items": herd.items.tolist()} for herd in scene.herds]
    for group in rigid:
        meshes.append(_shape(arrays, group[0][1].mesh, group[0][1].color) | {"items": [key[0] for key, _ in group]})
    for key, part in deformed:
        entry = _shape(arrays, part.mesh, part.color) | {"items": [key[0]], "deforms": True}
        shaded = part.values is not None
        meshes.append(entry | {"shaded": shaded} | ({"color": [1.0, 1.0, 1.0, opacity]} if shaded else {}))
    balls, threads = scene.balls, scene.threads
    head = {
        **words,
        "meshes": meshes,
        "spheres": {
            "colors": arrays.shades(_colors(balls.colors, [color for _, _, color, _ in scene.spheres])),
            "items": [*balls.items.tolist(), *(item for *_, item in scene.spheres)],
        },
        "lines": {
            "colors": arrays.shades(_colors(threads.colors, [line[1] for line in scene.lines])),
            "items": [*threads.items.tolist(), *(item for *_, item in scene.lines)],
        },
        "labels": [[label.text, list(label.color)] for label in scene.labels],
        "camera": camera.words(),
    }
    return arrays.message(head)


def _colors(many: Any, others: list[Rgba]) -> FloatArray:
    """Return colors (n x 3)."""
    parts = [np.asarray(part, float).reshape(-1, 4)[:, :3] for part in (many, others)]
    return np.concatenate(parts)


def _shape(arrays: Arrays, mesh: Mesh, color: Rgba | None) -> dict[str, Any]:
    """Return a mesh that is not placed yet."""
    colors = mesh.colors if color is None and mesh.colors is not None else None
    entry: dict[str, Any] = {
        "points": arrays.add("f4", mesh.points),
        "triangles": arrays.add("u4", mesh.triangles),
        "edges": arrays.add("u4", mesh.edges if len(mesh.edges) else sharp_edges(mesh)),
        "marked": bool(len(mesh.edges)),
        "normals": None if mesh.normals is None else arrays.add("f4", mesh.normals),
        "color": list(color or (0.5, 0.5, 0.5, 1.0)),
    }
    if colors is not None and len(colors):
        if (colors == colors[0]).all():
            entry["color"] = colors[0].tolist()
        else:
            entry["colors"] = arrays.shades(colors)
            entry["color"] = [1.0, 1.0, 1.0, float(colors[:, 3].min())]
    return entry
