"""A motion as data for the HTML file: parts are stored once, and their motion frame by frame.

The data are a JSON head and arrays behind it. Constant data is stored once; rigid parts have 12 numbers per frame
(the rows of x = matrix @ point + position), deformed
parts their points. Parts that move with a carrier store their relative pose, without numbers per frame (carrying.py);
the
browser computes the numbers when it reads the file. Floats lose their last, invisible bits; the remaining bits are an
integer, whose difference to the previous frame is stored, because successive numbers are nearly equal. Bytes are sorted
by significance for compression.
"""

from __future__ import annotations

import gzip
import json
from collections import Counter, defaultdict
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray
from dalembert._pictures import contour
from dalembert._pictures.carrying import Carried, Carriers
from dalembert._pictures.looks import Looks
from dalembert._pictures.meshes import Mesh, same_form, sharp_edges
from dalembert._pictures.notices import tell_settings_of_pictures
from dalembert._pictures.scene import Instance, Scene

if TYPE_CHECKING:
    from dalembert._pictures.motion import Motion, Still

LARGEST = float(np.finfo(np.float32).max)
SPARE_BITS = 7  # of 23 mantissa bits: relative accuracy of positions 1e-5
MOST_TEXTS = 1000  # texts of a scene that the viewer shows
NOWHERE = np.full(3, np.nan)
Key = tuple[int, int]  # item, and how manieth of its parts


class Packer:
    """Collects arrays; the head refers to them by number."""

    def __init__(self) -> None:
        self.parts: list[bytes] = []
        self.table: list[dict[str, Any]] = []

    def add(self, kind: str, values: bytes, count: int) -> int:
        """Keep an array of so many numbers; return its number."""
        self.table.append({"kind": kind, "count": count, "bytes": len(values)})
        self.parts.append(values)
        return len(self.table) - 1

    def floats(self, values: npt.ArrayLike) -> int:
        """Keep real numbers."""
        single = np.clip(np.asarray(values, float), -LARGEST, LARGEST).astype("<f4")
        bits = np.ascontiguousarray(single).ravel().view("<u4") >> SPARE_BITS
        return self._words("f4", np.diff(bits, prepend=bits.dtype.type(0)))

    def moving(self, frames: npt.ArrayLike, carried: Callable[[FloatArray], Carried | None] | None = None) -> int:
        """Store numbers per frame (frames x numbers), one number after the other; a single frame if nothing changes.

        `carried` finds a carrier.
        """
        array = np.asarray(frames, dtype=float)
        if len(array) > 1 and np.ptp(array, axis=0).max(initial=0) <= 1e-7 * max(
            float(np.abs(array).max(initial=0)), 1e-30
        ):
            array = array[:1]
        elif len(array) > 1 and carried is not None and (found := carried(array)) is not None:
            number = self.floats(found.numbers)
            self.table[number] |= {"kind": "carried", "count": array.size, "by": found.by, "form": found.form}
            return number
        return self.floats(array.T)

    def part(self, frames: FloatArray, carriers: Carriers, is_round: bool) -> int:
        """Store a rigid part (frames x rows of matrix and position).

        A part without a carrier may carry other parts; a part that does not rotate with its body carries neighbours.
        """
        number = self.moving(frames, lambda rows: carriers.part(rows, is_round))
        entry = self.table[number]
        if entry["count"] > frames[0].size and entry.get("form", "place") == "place":
            carriers.add(frames, number)
        return number

    def integers(self, values: npt.ArrayLike) -> int:
        """Keep numbers of points."""
        return self._words("u4", np.ascontiguousarray(values, dtype="<u4").ravel())

    def _words(self, kind: str, words: npt.NDArray[np.uint32]) -> int:
        return self.add(kind, words.view(np.uint8).reshape(-1, 4).T.tobytes(), words.size)

    def shades(self, values: npt.ArrayLike) -> int:
        """Keep colors: numbers from 0 to 1, as bytes."""
        array = np.round(255 * np.clip(np.asarray(values, float), 0, 1)).astype(np.uint8)
        return self.add("u1", array.tobytes(), array.size)

    def data(self, head: dict[str, Any]) -> bytes:
        """Return all, compressed."""
        text = json.dumps(head | {"arrays": self.table}, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        whole = np.array([len(text)], "<u4").tobytes() + text + b"".join(self.parts)
        return gzip.compress(whole, 9, mtime=0)


def pack(motion: Motion | Still, words: dict[str, Any]) -> bytes:
    """Return the data of a motion, and further data of the HTML file."""
    packer, camera, looks = Packer(), motion.camera, motion.looks
    tell_settings_of_pictures(looks.settings)
    scenes = [scene.unbound() for scene in motion.scenes]
    limits = _limits(scenes)
    items: dict[tuple[str, int, int], int] = {}
    names: list[list[Any]] = []
    for scene in scenes:
        for item in scene.items:
            if items.setdefault((item.kind, item.number, item.system), len(names)) == len(names):
                names.append([item.kind, item.number, item.type_name, item.name])
    numbered = [[items[item.kind, item.number, item.system] for item in scene.items] for scene in scenes]
    carriers = Carriers()
    head = {
        "version": 3,
        **words,
        "rate": motion.rate,
        "times": [scene.time for scene in scenes],
        "items": names,
        "camera": camera.words(),
        **looks.of_pages(),
        "upwards": motion.studio.upwards(),
        "labels": _labels(packer, scenes),
        "meshes": _meshes(packer, carriers, scenes, numbered, looks, limits),
        "spheres": _spheres(packer, carriers, scenes, numbered),
        "lines": _lines(packer, carriers, scenes, numbered),
        "contour": _contour(scenes, looks, limits),
    }
    return packer.data(head)


def _limits(scenes: list[Scene]) -> tuple[float, float]:
    """Return one range of colors for all frames."""
    shown = [scene.value_range for scene in scenes if len(scene.values())]
    return (min(low for low, _ in shown), max(high for _, high in shown)) if shown else (0.0, 1.0)


def _labels(packer: Packer, scenes: list[Scene]) -> dict[str, Any]:
    """Return texts with their positions, which are undefined in frames without the text."""
    frames: list[dict[tuple[Any, int], FloatArray]] = []
    for scene in scenes:
        found: Counter[Any] = Counter()
        frames.append({})
        for label in scene.labels[:MOST_TEXTS]:
            text = label.text, tuple(label.color)
            frames[-1][text, found[text]] = label.place
            found[text] += 1
    keys = list(dict.fromkeys(key for frame in frames for key in frame))
    places = np.array([[frame.get(key, NOWHERE) for key in keys] for frame in frames])
    return {"texts": [text for text, _ in keys], "frames": packer.moving(places.reshape(len(scenes), -1))}


def _contour(scenes: list[Scene], looks: Looks, limits: tuple[float, float]) -> dict[str, Any] | None:
    name = next((scene.value_name for scene in scenes if len(scene.values())), "")
    if not name:
        return None
    return {"name": name, "range": limits, "colors": contour.palette(looks)}


def _keyed(parts: list[tuple[int, Any]]) -> dict[Key, Any]:
    """Give the parts of each item numbers."""
    counts: dict[int, int] = defaultdict(int)
    result = {}
    for item, part in parts:
        result[item, counts[item]] = part
        counts[item] += 1
    return result


def _meshes(
    packer: Packer,
    carriers: Carriers,
    scenes: list[Scene],
    numbered: list[list[int]],
    looks: Looks,
    limits: tuple[float, float],
) -> list[dict[str, Any]]:
    """Return meshes: rigid ones with all their places, and deformed ones with their points."""
    frames = [
        _keyed([(numbers[i.item], i) for i in scene.instances if len(i.mesh.points)])
        for scene, numbers in zip(scenes, numbered, strict=True)
    ]
    keys = list(dict.fromkeys(key for frame in frames for key in frame))
    rigid: dict[tuple[int, Any], list[tuple[Key, list[Instance | None]]]] = defaultdict(list)
    result = []
    for key in keys:
        for history in _by_form([frame.get(key) for frame in frames]):
            known = [part for part in history if part is not None]
            if all(part.mesh is known[0].mesh and part.values is None for part in known):
                rigid[id(known[0].mesh), known[0].color].append((key, history))
            else:
                result.append(_deformed(packer, key, history, looks, limits))
    # Round parts come last: their rotation may differ from that of their body, so they cannot be carriers.
    groups = ((next(part for part in group[0][1] if part is not None), group) for group in rigid.values())
    for first, group in sorted(groups, key=lambda known: known[0].mesh.is_round):
        entry = _shape(packer, first.mesh, first)
        entry["places"] = [packer.part(_rows(history), carriers, first.mesh.is_round) for _, history in group]
        entry["items"] = [key[0] for key, _ in group]
        result.append(entry)
    return result


def _by_form(parts: list[Instance | None]) -> list[list[Instance | None]]:
    """Split histories by form: entries of another form, or missing parts, are None."""
    histories: list[tuple[Instance, list[Instance | None]]] = []
    for number, part in enumerate(parts):
        if part is None:
            continue
        history = next((known for first, known in reversed(histories) if _alike(first, part)), None)
        if history is None:
            history = [None] * len(parts)
            histories.append((part, history))
        history[number] = part
    return [history for _, history in histories]


def _alike(a: Instance, b: Instance) -> bool:
    same = a.mesh is b.mesh or same_form(a.mesh, b.mesh)
    return same and a.color == b.color and (a.values is None) == (b.values is None)


def _shape(packer: Packer, mesh: Mesh, first: Instance, points: FloatArray | None = None) -> dict[str, Any]:
    edges = mesh.edges if len(mesh.edges) else sharp_edges(mesh)
    colors = mesh.colors if first.color is None and mesh.colors is not None else None
    entry: dict[str, Any] = {
        "points": packer.floats(mesh.points if points is None else points),
        "triangles": packer.integers(mesh.triangles),
        "edges": packer.integers(edges),
        "marked": bool(len(mesh.edges)),
    }
    if mesh.normals is not None:
        entry["normals"] = packer.floats(mesh.normals)
    if colors is None:
        entry["color"] = list(first.color or (0.5, 0.5, 0.5, 1.0))
    elif (colors == colors[0]).all():
        entry["color"] = colors[0].tolist()
    else:
        entry["colors"] = packer.shades(colors)
        entry["color"] = [1.0, 1.0, 1.0, float(colors[:, 3].min())]
    return entry


def _rows(history: list[Instance | None]) -> FloatArray:
    """Return matrix and place, row by row, in each frame; zeros where there is nothing to be seen."""
    rows = np.zeros((len(history), 3, 4))
    there = [number for number, part in enumerate(history) if part is not None]
    parts = [part for part in history if part is not None]
    rows[there, :, :3], rows[there, :, 3] = [part.matrix for part in parts], [part.place for part in parts]
    return rows.reshape(len(history), 12)


def _deformed(
    packer: Packer, key: Key, history: list[Instance | None], looks: Looks, limits: tuple[float, float]
) -> dict[str, Any]:
    first = next(part for part in history if part is not None)
    still = np.zeros_like(first.mesh.points)
    points = [still if p is None else p.mesh.points @ p.matrix.T + p.place for p in history]
    entry = _shape(packer, first.mesh, first, points[0])
    entry["normals"] = None  # the page finds them for each frame
    entry["smooth"] = first.mesh.normals is not None
    entry["frames"] = packer.moving(np.array([frame.ravel() for frame in points]))
    entry["items"] = [key[0]]
    if first.values is not None:
        nothing = np.zeros((len(still), 4))
        shades = [nothing if p is None else contour.colors(looks, np.asarray(p.values), limits) for p in history]
        entry["color"] = [1.0, 1.0, 1.0, contour.opacity(looks)]
        entry["frameColors"] = packer.shades(np.array(shades)[..., :3])
    return entry


def _spheres(packer: Packer, carriers: Carriers, scenes: list[Scene], numbered: list[list[int]]) -> dict[str, Any]:
    frames = [
        _keyed([(numbers[item], (center, radius, color)) for center, radius, color, item in scene.spheres])
        for scene, numbers in zip(scenes, numbered, strict=True)
    ]
    keys = list(dict.fromkeys(key for frame in frames for key in frame))
    nothing = (np.zeros(3), 0.0, (0.0, 0.0, 0.0, 1.0))
    places = [[[*frame.get(key, nothing)[0], frame.get(key, nothing)[1]] for frame in frames] for key in keys]
    colors = [next(frame[key][2] for frame in frames if key in frame)[:3] for key in keys]
    return {
        "places": [packer.moving(place, carriers.ball) for place in places],
        "colors": packer.shades(np.array(colors).reshape(-1, 3)),
        "items": [key[0] for key in keys],
    }


def _lines(packer: Packer, carriers: Carriers, scenes: list[Scene], numbered: list[list[int]]) -> list[dict[str, Any]]:
    """Return lines; future points of a growing line, such as a trace, coincide with its current end."""
    frames = [
        _keyed([(numbers[item], (points, color)) for points, color, _, item in scene.lines if len(points) > 1])
        for scene, numbers in zip(scenes, numbered, strict=True)
    ]
    keys = list(dict.fromkeys(key for frame in frames for key in frame))
    result = []
    for key in keys:
        most = max(len(frame[key][0]) for frame in frames if key in frame)
        color = next(frame[key][1] for frame in frames if key in frame)
        last = np.zeros((1, 3))
        history = []
        for frame in frames:
            points = frame[key][0] if key in frame else last
            history.append(np.concatenate([points, np.repeat(points[-1:], most - len(points), axis=0)]).ravel())
        frames_of_line = packer.moving(np.array(history), carriers.points)
        result.append({"frames": frames_of_line, "count": most, "color": list(color), "item": key[0]})
    return result
