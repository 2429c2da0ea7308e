"""mbs.SaveGLB(): a motion as binary glTF 2.0, which Blender, browsers and presentations open.

Rigid meshes are nodes whose translation, rotation and scale are animated; deformed meshes have a morph target for each
frame. Reference: the glTF 2.0 specification of the Khronos Group (ISO/IEC 12113:2022).
"""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray
from dalembert._io.files import file_to_write, replacing
from dalembert._pictures import meshes
from dalembert._pictures.meshes import Mesh, Rgba

if TYPE_CHECKING:
    from dalembert._pictures.motion import Motion
    from dalembert._pictures.scene import Instance, Scene

FLOAT, UINT, BYTE = 5126, 5125, 5121  # componentType
ARRAY, ELEMENTS = 34962, 34963  # target of a bufferView
LINES, TRIANGLES = 1, 4  # mode of a primitive
STILL = 1e-7  # relative to the largest number: smaller changes count as rest


def SaveGLB(
    mbs: Any,
    fileName: str,
    solution: dict[str, Any] | None = None,
    framesPerSecond: float = 25,
    speed: float = 1.0,
) -> None:
    """Save the motion of a solution (from LoadSolutionFile), or of the last simulation, as animated glTF (.glb).

    If there is no solution, the file has the visualization state. `speed` is the time of the solution that passes
    in a second. Colors of a contour are those of the first frame.
    """
    from dalembert._pictures.motion import Motion

    path = Path(file_to_write("SaveGLB: fileName", fileName, newFolder=True))
    if path.suffix != ".glb":
        raise ValueError(f"SaveGLB: fileName: expected a name that ends with .glb, received '{fileName}'")
    motion = Motion(mbs, "SaveGLB", solution, framesPerSecond, speed, None, (1024, 768), optional=True)
    path.parent.mkdir(parents=True, exist_ok=True)
    with replacing(path) as written:
        Path(written).write_bytes(Exporter(motion).data())


class Exporter:
    """Collects meshes, nodes and animations of a motion."""

    def __init__(self, motion: Motion) -> None:
        self._motion, self._bytes = motion, bytearray()
        self._views: list[dict[str, Any]] = []
        self._accessors: list[dict[str, Any]] = []
        self._meshes: list[dict[str, Any]] = []
        self._materials: dict[Rgba, int] = {}
        self._known: dict[tuple[int, Any], int] = {}
        self._kept: list[Mesh] = []  # kept alive, because meshes are identified by their id
        self._channels: list[dict[str, Any]] = []
        self._samplers: list[dict[str, Any]] = []
        self._nodes: list[dict[str, Any]] = []
        times = np.arange(len(motion.scenes)) / motion.rate
        self._times = self._accessor(times, FLOAT, "SCALAR", None, True) if len(times) > 1 else -1
        self._collect([scene.unbound() for scene in motion.scenes])

    # ---- numbers

    def _accessor(self, values: Any, kind: int, shape: str, target: int | None = None, limits: bool = False) -> int:
        types: dict[int, npt.DTypeLike] = {FLOAT: "<f4", UINT: "<u4", BYTE: "u1"}
        array = np.ascontiguousarray(values, types[kind])
        self._bytes += b"\0" * (-len(self._bytes) % 4)
        view: dict[str, Any] = {"buffer": 0, "byteOffset": len(self._bytes), "byteLength": array.nbytes}
        self._views.append(view | ({} if target is None else {"target": target}))
        self._bytes += array.tobytes()
        entry: dict[str, Any] = {"bufferView": len(self._views) - 1, "componentType": kind, "type": shape}
        width = 1 if shape == "SCALAR" else int(shape[-1])
        entry["count"] = array.size // width
        if kind == BYTE:
            entry["normalized"] = True
        if limits:
            rows = array.reshape(-1, width)
            entry |= {"min": rows.min(axis=0).tolist(), "max": rows.max(axis=0).tolist()}
        self._accessors.append(entry)
        return len(self._accessors) - 1

    def _material(self, color: Rgba) -> int:
        return self._materials.setdefault(color, len(self._materials))

    # ---- drawn parts -------------------------------------------------------------------------------------------------

    def _mesh(self, mesh: Mesh, color: Rgba | None, shades: FloatArray | None = None) -> int:
        key = (id(mesh), color)
        if shades is None and key in self._known:
            return self._known[key]
        self._kept.append(mesh)
        points, triangles, normals = mesh.points, mesh.triangles, mesh.normals
        shades = mesh.colors if shades is None and color is None else shades
        if normals is None:  # flat: each triangle has points of its own
            points = points[triangles].reshape(-1, 3)
            shades = None if shades is None else shades[triangles].reshape(-1, 4)
            a, b, c = points[0::3], points[1::3], points[2::3]
            normals = np.repeat(np.cross(b - a, c - a), 3, axis=0)
            triangles = np.arange(len(points)).reshape(-1, 3)
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals = np.where(lengths > 0, normals / np.maximum(lengths, 1e-300), [0.0, 0.0, 1.0])
        attributes = {
            "POSITION": self._accessor(points, FLOAT, "VEC3", ARRAY, True),
            "NORMAL": self._accessor(normals, FLOAT, "VEC3", ARRAY),
        }
        if shades is not None and len(shades):
            if (shades == shades[0]).all():
                color = (float(shades[0, 0]), float(shades[0, 1]), float(shades[0, 2]), float(shades[0, 3]))
            else:
                attributes["COLOR_0"] = self._accessor(np.round(255 * _linear(shades)), BYTE, "VEC4", ARRAY)
                color = (1.0, 1.0, 1.0, float(shades[:, 3].min()))
        primitive = {
            "attributes": attributes,
            "indices": self._accessor(triangles.ravel(), UINT, "SCALAR", ELEMENTS),
            "material": self._material(color or (0.5, 0.5, 0.5, 1.0)),
            "mode": TRIANGLES,
        }
        self._meshes.append({"primitives": [primitive]})
        self._known[key] = len(self._meshes) - 1
        return len(self._meshes) - 1

    def _collect(self, scenes: list[Scene]) -> None:
        parts: dict[tuple[str, int, int], list[tuple[int, Instance]]] = defaultdict(list)
        balls: dict[tuple[str, int, int], list[tuple[int, FloatArray, Rgba]]] = defaultdict(list)
        lines: dict[tuple[str, int, int], list[tuple[int, FloatArray, Rgba]]] = defaultdict(list)
        names = {}
        for number, scene in enumerate(scenes):
            counts: dict[int, int] = defaultdict(int)

            def key(item: int, scene: Scene = scene, counts: dict[int, int] = counts) -> tuple[str, int, int]:
                counts[item] += 1
                owner = scene.items[item]
                names[owner.kind, owner.number] = owner
                return owner.kind, owner.number, counts[item]

            for part in scene.instances:
                if len(part.mesh.triangles):
                    parts[key(part.item)].append((number, part))
            for center, radius, color, item in scene.spheres:
                balls[key(item)].append((number, np.append(center, radius), color))
            for points, color, _, item in scene.lines:
                if len(points) > 1:
                    lines[key(item)].append((number, points, color))
        self._names = names
        for where, history in parts.items():
            first = history[0][1]
            # temporarily grouped by the mesh of the part
            alike: dict[int, list[tuple[int, Instance]]] = defaultdict(list)
            for number, part in history:
                alike[id(part.mesh)].append((number, part))
            is_one_form = all(p.mesh.points.shape == first.mesh.points.shape for _, p in history)
            is_rigid = len(alike) == 1 or 2 * len(alike) <= len(history) or not is_one_form
            if is_rigid and all(p.values is None for _, p in history):
                for members in alike.values():
                    rows = np.array([np.column_stack([p.matrix, p.place]) for _, p in members])
                    shown = members[0][1]
                    self._rigid(where, self._mesh(shown.mesh, shown.color), [n for n, _ in members], rows)
            elif is_one_form:
                self._deformed(where, history)
        for where, spheres in balls.items():
            rows = np.zeros((len(spheres), 3, 4))
            for row, (_, sphere, _) in zip(rows, spheres, strict=True):
                row[:, :3], row[:, 3] = sphere[3] * np.eye(3), sphere[:3]
            self._rigid(where, self._mesh(meshes.ball(12), spheres[0][2]), [n for n, *_ in spheres], rows)
        for where, strips in lines.items():
            self._line(where, strips)

    def _node(self, where: tuple[str, int, int], mesh: int) -> dict[str, Any]:
        owner = self._names[where[0], where[1]]
        node = {
            "name": f"{owner.name or owner.kind.lower()}.{where[2]}",
            "mesh": mesh,
            "extras": {"kind": owner.kind, "number": owner.number, "type": owner.type_name},
        }
        self._nodes.append(node)
        return node

    def _animate(self, path: str, values: FloatArray, shape: str) -> None:
        self._samplers.append(
            {"input": self._times, "output": self._accessor(values, FLOAT, shape), "interpolation": "LINEAR"}
        )
        target = {"node": len(self._nodes) - 1, "path": path}
        self._channels.append({"sampler": len(self._samplers) - 1, "target": target})

    def _all_frames(self, numbers: list[int], rows: FloatArray) -> FloatArray:
        """Return rows for all frames: a part that is not there shrinks to a point."""
        whole = np.zeros((len(self._motion.scenes), *rows.shape[1:]))
        whole[:, :, 3:] = rows[0, :, 3:]
        whole[numbers] = rows
        return whole

    def _rigid(self, where: tuple[str, int, int], mesh: int, numbers: list[int], rows: FloatArray) -> None:
        rows = self._all_frames(numbers, rows)
        scales = np.linalg.norm(rows[:, :, :3], axis=1)
        turns = _quaternions(rows[:, :, :3] / np.maximum(scales, 1e-300)[:, None])
        node = self._node(where, mesh)
        for path, values, shape in (
            ("translation", rows[:, :, 3], "VEC3"),
            ("rotation", turns, "VEC4"),
            ("scale", scales, "VEC3"),
        ):
            node[path] = values[0].tolist()
            if len(values) > 1 and np.ptp(values, axis=0).max() > STILL * max(float(np.abs(values).max()), 1e-30):
                self._animate(path, values, shape)

    def _deformed(self, where: tuple[str, int, int], history: list[tuple[int, Instance]]) -> None:
        first, looks = history[0][1], self._motion.looks
        shades = None
        if first.values is not None:
            from dalembert._pictures import contour

            shades = contour.colors(looks, first.values, self._motion.scenes[0].value_range)
        frames = [part.mesh.points @ part.matrix.T + part.place for _, part in history]
        mesh = Mesh(frames[0], first.mesh.triangles, None, first.mesh.colors)
        number = self._mesh(mesh, None if shades is not None else first.color, shades)
        self._node(where, number)
        order = mesh.triangles.ravel()
        self._morph(number, [frame[order] for frame in frames], [n for n, _ in history])

    def _line(self, where: tuple[str, int, int], strips: list[tuple[int, FloatArray, Rgba]]) -> None:
        most = max(len(points) for _, points, _ in strips)
        frames = [np.concatenate([p, np.repeat(p[-1:], most - len(p), axis=0)]) for _, p, _ in strips]
        pairs = np.stack([np.arange(most - 1), np.arange(1, most)], 1)
        primitive = {
            "attributes": {"POSITION": self._accessor(frames[0], FLOAT, "VEC3", ARRAY, True)},
            "indices": self._accessor(pairs.ravel(), UINT, "SCALAR", ELEMENTS),
            "material": self._material(strips[0][2]),
            "mode": LINES,
        }
        self._meshes.append({"primitives": [primitive]})
        self._node(where, len(self._meshes) - 1)
        self._morph(len(self._meshes) - 1, frames, [n for n, *_ in strips])

    def _morph(self, mesh: int, frames: list[FloatArray], numbers: list[int]) -> None:
        """Add a morph target for each frame that differs from the first one, and the weights that choose them."""
        size = max(float(np.abs(frames[0]).max()), 1e-30)
        moved = [k for k, frame in enumerate(frames) if np.abs(frame - frames[0]).max() > STILL * size]
        if not moved or self._times < 0:
            return
        targets = [{"POSITION": self._accessor(frames[k] - frames[0], FLOAT, "VEC3", ARRAY, True)} for k in moved]
        self._meshes[mesh]["primitives"][0]["targets"] = targets
        self._meshes[mesh]["weights"] = [0.0] * len(moved)
        weights = np.zeros((len(self._motion.scenes), len(moved)))
        for target, k in enumerate(moved):
            weights[numbers[k], target] = 1
        self._animate("weights", weights.ravel(), "SCALAR")

    # ---- the file

    def data(self) -> bytes:
        """Return the file."""
        upright = self._motion.studio.upwards() == 1
        root = {"name": "system", "children": list(range(1, len(self._nodes) + 1))}
        if not upright:
            root["rotation"] = [-float(np.sqrt(0.5)), 0.0, 0.0, float(np.sqrt(0.5))]  # glTF has y upwards
        for channel in self._channels:
            channel["target"]["node"] += 1
        if not self._nodes:
            del root["children"]
        head: dict[str, Any] = {
            "asset": {"version": "2.0", "generator": "dalembert"},
            "scene": 0,
            "scenes": [{"nodes": [0]}],
            "nodes": [root, *self._nodes],
            "materials": [_material(color) for color in self._materials],
            "meshes": self._meshes,
            "accessors": self._accessors,
            "bufferViews": self._views,
            "animations": [{"name": "motion", "channels": self._channels, "samplers": self._samplers}]
            if self._channels
            else [],
            "buffers": [{"byteLength": len(self._bytes)}] if self._bytes else [],
        }
        text = json.dumps({name: part for name, part in head.items() if part != []}, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        body = bytes(self._bytes) + b"\0" * (-len(self._bytes) % 4)
        chunks = np.array([len(text), 0x4E4F534A], "<u4").tobytes() + text
        if body:
            chunks += np.array([len(body), 0x004E4942], "<u4").tobytes() + body
        return np.array([0x46546C67, 2, 12 + len(chunks)], "<u4").tobytes() + chunks


def _linear(colors: npt.ArrayLike) -> FloatArray:
    """Return colors with which light is computed, of those that screens show (IEC 61966-2-1)."""
    array = np.clip(np.array(colors, float), 0, 1)
    rgb = array[..., :3]
    array[..., :3] = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    return array


def _material(color: Rgba) -> dict[str, Any]:
    factor = _linear(color).tolist()
    material: dict[str, Any] = {
        "pbrMetallicRoughness": {"baseColorFactor": factor, "metallicFactor": 0.05, "roughnessFactor": 0.55},
        "doubleSided": True,
    }
    return material | ({"alphaMode": "BLEND"} if color[3] < 1 else {})


def _quaternions(rotations: FloatArray) -> FloatArray:
    """Return unit quaternions (x, y, z, w) of rotation matrices, each on the side of the one before."""
    from scipy.spatial.transform import Rotation

    there = np.abs(np.linalg.det(rotations) - 1) < 1e-6
    result = np.tile([0.0, 0.0, 0.0, 1.0], (len(rotations), 1))
    if there.any():
        result[there] = Rotation.from_matrix(rotations[there]).as_quat()
    for before, now in zip(result[:-1], result[1:], strict=True):
        if before @ now < 0:
            now *= -1
    return result
