"""Settings of an MJCF file that hold for all elements: units, notations of rotations, defaults of classes, assets."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._geometry.rotations import (
    EulerParameters2RotationMatrix,
    RotationMatrixX,
    RotationMatrixY,
    RotationMatrixZ,
    RotationVector2RotationMatrix,
)
from dalembert.robotics import _shapes
from dalembert.robotics._description import translated, turned
from dalembert.robotics._xml import Element

_ACTUATORS = (
    "general",
    "motor",
    "position",
    "velocity",
    "intvelocity",
    "damper",
    "cylinder",
    "muscle",
    "adhesion",
    "dcmotor",
    "plugin",
)
_TURNS = {"x": RotationMatrixX, "y": RotationMatrixY, "z": RotationMatrixZ}


def root_numbers(root: Element, settings: dict[str, str], name: str, size: int, default: str) -> FloatArray:
    """Return a setting of <compiler>."""
    return replace(root, tag="compiler", attributes=settings).numbers(name, size, default)


class Compiler:
    """Settings of a file that hold for all elements: units, defaults of classes, assets.

    models has the settings of the file and of all models that are attached to it, by their numbers. Models that are
    attached to this one have the numbers after its own, up to end.
    """

    def __init__(self, root: Element, folder: Path, shapes: bool, models: list[Compiler] | None = None) -> None:
        self.models = [] if models is None else models
        self.number = len(self.models)
        self.end = self.number + 1
        self.models.append(self)
        settings: dict[str, str] = {}
        for element in root.every("compiler"):
            settings |= element.attributes
        if settings.get("coordinate", "local") != "local":
            root.fail("compiler: coordinate='global' is no longer supported; convert the file with MuJoCo 2.3")
        self.degrees = settings.get("angle", "degree") == "degree"
        self.autolimits = settings.get("autolimits", "true") == "true"
        self.sequence = settings.get("eulerseq", "xyz")
        self.from_shapes = settings.get("inertiafromgeom", "auto")
        lower, upper = root_numbers(root, settings, "inertiagrouprange", 2, "0 5")
        self.weighed_groups = range(int(lower), int(upper) + 1)
        self.least_mass, self.least_inertia, self.total_mass = (
            float(root_numbers(root, settings, name, 1, default)[0])
            for name, default in (("boundmass", "0"), ("boundinertia", "0"), ("settotalmass", "-1"))
        )
        self.balances = settings.get("balanceinertia", "false") == "true"
        self.folder, self.shapes = folder / settings.get("meshdir", settings.get("assetdir", "")), shapes
        self.classes: dict[str, dict[str, dict[str, str]]] = {"main": {}}
        self.actuator_defaults: dict[str, list[Element]] = {"main": []}
        for element in root.every("default"):
            name = element.text("class", "main")
            self._add_class(element, {}, [], name)
            self.classes["main"] = self.classes[name]
            self.actuator_defaults["main"] = self.actuator_defaults[name]
        assets = [asset for group in root.every("asset") for asset in group.children]
        self.materials = {asset.text("name"): asset for asset in assets if asset.tag == "material"}
        self.meshes = {self._asset_name(asset): asset for asset in assets if asset.tag == "mesh"}

    def of(self, element: Element) -> Compiler:
        """Return the settings of the model that an element belongs to."""
        return self.models[element.model]

    @staticmethod
    def _asset_name(asset: Element) -> str:
        return asset.text("name", Path(asset.text("file", "")).stem)

    def _add_class(
        self, element: Element, inherited: dict[str, dict[str, str]], actuators: list[Element], name: str
    ) -> None:
        """Add a class and those in it; all kinds of actuators have their defaults in common, in their order."""
        self.actuator_defaults[name] = [
            *actuators,
            *(child for child in element.children if child.tag in _ACTUATORS),
        ]
        own = {tag: dict(values) for tag, values in inherited.items()}
        for child in element.children:
            if child.tag != "default":
                own[child.tag] = own.get(child.tag, {}) | child.attributes
        self.classes[name] = own
        for child in element.every("default"):
            self._add_class(child, own, self.actuator_defaults[name], child.text("class"))

    def complete(self, element: Element, child_class: str) -> Element:
        """Return an element with the defaults of its class."""
        name = self.class_of(element, child_class)
        return replace(element, attributes=self.classes[name].get(element.tag, {}) | element.attributes)

    def class_of(self, element: Element, child_class: str) -> str:
        """Return the name of the default class of an element."""
        name = element.attributes.get("class", child_class)
        if name not in self.classes:
            element.fail(f"class: there is no default class '{name}'; there are: {', '.join(self.classes)}")
        return name

    def angle(self, values: Any) -> Any:
        """Return angles of the file in rad."""
        return np.deg2rad(values) if self.degrees else values

    def rotation(self, element: Element) -> FloatArray:
        """Return the rotation of an element, from any of its attributes."""
        given = element.attributes.keys() & {"quat", "axisangle", "euler", "xyaxes", "zaxis"}
        if len(given) > 1:
            element.fail(f"expected one way to give a rotation, received {', '.join(sorted(given))}")
        match next(iter(given), ""):
            case "quat":
                q = element.numbers("quat", 4)
                return EulerParameters2RotationMatrix(q / self.length(element, "quat", q))
            case "axisangle":
                *axis, angle = element.numbers("axisangle", 4)
                return RotationVector2RotationMatrix(
                    self.angle(angle) * np.array(axis) / self.length(element, "axisangle", axis)
                )
            case "euler":
                return self._euler(self.angle(element.numbers("euler", 3)))
            case "xyaxes":
                x, y = element.numbers("xyaxes", 6).reshape(2, 3)
                x = x / self.length(element, "xyaxes", x)
                y = y - (x @ y) * x
                y = y / self.length(element, "xyaxes", y)
                return np.column_stack([x, y, np.cross(x, y)])
            case "zaxis":
                return self.from_z(element.numbers("zaxis", 3), element)
        return np.eye(3)

    def _euler(self, angles: FloatArray) -> FloatArray:
        A = np.eye(3)
        for letter, angle in zip(self.sequence, angles, strict=True):
            turn = _TURNS[letter.lower()](angle)
            A = A @ turn if letter.islower() else turn @ A
        return A

    @staticmethod
    def length(element: Element, name: str, vector: Any) -> float:
        length = float(np.linalg.norm(vector))
        return length if length > 0 else element.fail(f"{name}: expected a vector that is not zero")

    def from_z(self, direction: FloatArray, element: Element) -> FloatArray:
        """Return the smallest rotation that turns the z axis to a direction."""
        d = direction / self.length(element, "zaxis", direction)
        axis = np.cross([0, 0, 1], d)
        sine = np.linalg.norm(axis)
        if sine < 1e-12:
            return np.eye(3) if d[2] > 0 else RotationMatrixX(np.pi)
        return RotationVector2RotationMatrix(np.arctan2(sine, d[2]) * axis / sine)

    def place(self, element: Element) -> FloatArray:
        """Return the transformation of pos and rotation."""
        return translated(element.numbers("pos", 3, "0 0 0")) @ turned(self.rotation(element))

    def mesh(self, geom: Element) -> _shapes.Shape:
        """Return the mesh of a geom, from a file or from its corners."""
        name = geom.text("mesh")
        if name not in self.meshes:
            geom.fail(f"mesh: there is no <mesh name='{name}'> among the assets")
        asset = self.complete(self.meshes[name], "main")
        scale = asset.numbers("scale", 3, "1 1 1")
        shape = _inline_mesh(asset, scale) if "vertex" in asset.attributes else self._mesh_file(asset, scale)
        assert shape.corners is not None
        quat = asset.numbers("refquat", 4, "1 0 0 0")
        A = EulerParameters2RotationMatrix(quat / self.length(asset, "refquat", quat))
        return _shapes.Shape("mesh", corners=(shape.corners - asset.numbers("refpos", 3, "0 0 0")) @ A)

    def _mesh_file(self, asset: Element, scale: FloatArray) -> _shapes.Shape:
        if "file" not in asset.attributes:
            asset.fail("expected the attribute 'file' or 'vertex': builtin meshes are not read; save the mesh as file")
        path = self.folder / asset.text("file")
        if not path.is_file():
            asset.fail(f"there is no file '{path}'; {self._remedy()}")
        try:
            return _shapes.mesh(path, scale)
        except ImportError as error:
            asset.fail(f"{error}; {self._remedy()}")

    def _remedy(self) -> str:
        if self.shapes:
            return "graphics=False leaves shapes out"
        return "a body without <inertial> is weighed by its meshes: give it an <inertial>"


def _inline_mesh(asset: Element, scale: FloatArray) -> _shapes.Shape:
    """Return the mesh of vertex and face; the convex hull if there are no faces."""
    points = asset.numbers("vertex", (9, 10**9)).reshape(-1, 3) * scale
    if "face" in asset.attributes:
        corners = points[asset.numbers("face", (3, 10**9)).astype(int).reshape(-1, 3)]
        return _shapes.Shape("mesh", corners=corners if scale.prod() > 0 else corners[:, ::-1])
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points)
    corners = points[hull.simplices]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.sum(normals * hull.equations[:, :3], axis=1) < 0
    corners[inward] = corners[inward][:, ::-1]
    return _shapes.Shape("mesh", corners=corners)
