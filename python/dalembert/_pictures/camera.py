"""Camera of a scene: the render state that scripts store, and the derived matrices."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, as_rotation
from dalembert.rigidBodyUtilities import RotationVector2RotationMatrix

FRONT = np.eye(3)  # x to the right, y up
PERSPECTIVE_OF_PAGES = float(np.tan(np.radians(30.0) / 2))  # FIELD in page/view.js


def axonometric(up: int = 2) -> FloatArray:
    """Return the rotation of the scene by which all axes are seen; `up`, 1 or 2, is the one that points upwards."""
    side, height = np.radians(30.0), np.radians(25.0)
    towards = np.array([np.sin(side) * np.cos(height), np.sin(height), np.cos(side) * np.cos(height)])
    right = np.array([np.cos(side), 0.0, -np.sin(side)])
    rows = np.array([right, np.cross(towards, right), towards])
    return rows if up == 1 else rows @ np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])


@dataclass
class Camera:
    """`rotation` turns the scene to right, up, towards the viewer; `center` is in the middle, `zoom` half as high."""

    rotation: FloatArray = field(default_factory=lambda: np.eye(3))
    center: FloatArray = field(default_factory=lambda: np.zeros(3))
    zoom: float = 1.0
    perspective: float = 0.0  # zoom by distance of the viewer; 0: parallel
    aspect: float = 0.0  # width by height of the image that it was fitted to; 0: it was not

    def view(self) -> FloatArray:
        """Return the rows that turn points to right, up and away from the viewer (3 x 4)."""
        rows = self.rotation * np.array([[1.0], [1.0], [-1.0]])
        return np.column_stack([rows, -rows @ self.center])

    def pixels(self, points: FloatArray, width: int, height: int) -> FloatArray:
        """Return column, row and depth of points."""
        eye = points @ self.view()[:, :3].T + self.view()[:, 3]
        scale = 0.5 * height / self.zoom / (1 + self.perspective / self.zoom * eye[:, 2])
        return np.stack([0.5 * width + scale * eye[:, 0], 0.5 * height - scale * eye[:, 1], eye[:, 2]], 1)

    def words(self) -> dict[str, Any]:
        """Return the camera for pages, which look from farther away if they are narrower than the image."""
        rows, center = self.rotation.ravel().tolist(), self.center.tolist()
        known = {"rotation": rows, "center": center, "zoom": self.zoom}
        return known | {"aspect": self.aspect} if self.aspect else known

    def fit(self, box: FloatArray | None, width: int, height: int, factor: float = 1.2, right: float = 0.0) -> None:
        """Let the camera look at a box, from where it is now, with a margin; `right`: part of the width left free."""
        if box is None:
            self.center, self.zoom = np.zeros(3), 1.0
            return
        corners = np.array([[box[i, 0], box[j, 1], box[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)])
        turned = corners @ self.rotation.T
        middle = 0.5 * (turned.min(axis=0) + turned.max(axis=0))
        x, y, towards = (turned - middle).T
        wide = (1 - right) * width / height
        # seen at x / (1 - perspective * towards / zoom), which is to be within zoom times the shape of the image
        needed = np.maximum(np.abs(x) / wide, np.abs(y)) + self.perspective * towards
        self.zoom, self.aspect = factor * (float(needed.max()) or 1.0), width / height
        middle[0] += right * self.zoom * width / height
        self.center = self.rotation.T @ middle


def of_settings(settings: Any) -> Camera:
    """Return the camera with which a renderer starts."""
    start = settings.openGL.advanced
    rotation = np.asarray(start.initialModelRotation, float).reshape(3, 3).T
    return Camera(rotation, np.asarray(start.initialCenterPoint, float), float(start.initialZoom))


def turned(rotation_vector: Any) -> FloatArray:
    """Return the rotation of the scene by a rotation vector, as SetModelView takes it."""
    return np.asarray(RotationVector2RotationMatrix(np.asarray(rotation_vector, float)), float)


def named(view: Any, up: int = 2, where: str = "") -> FloatArray:
    """Return the rotation of the scene for the name of a view, or for a rotation matrix; errors begin with `where`."""
    quarter = {
        "front": [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        "back": [[-1, 0, 0], [0, 1, 0], [0, 0, -1]],
        "right": [[0, 1, 0], [0, 0, 1], [1, 0, 0]],
        "left": [[0, -1, 0], [0, 0, 1], [-1, 0, 0]],
        "top": [[1, 0, 0], [0, 0, -1], [0, 1, 0]],
        "bottom": [[1, 0, 0], [0, 0, 1], [0, -1, 0]],
    }
    if isinstance(view, str):
        if view == "axonometric":
            return axonometric(up)
        if view in quarter:
            return np.array(quarter[view], float)
        raise ValueError(
            f"{where}view: expected {', '.join([*quarter, 'axonometric'])} or a rotation matrix, received '{view}'"
        )
    return as_rotation(f"{where}view", view)


def automatic(box: FloatArray | None, up: int) -> FloatArray:
    """Return the default view of a system: the front if it is planar, otherwise a view in which all axes are
    visible."""
    if box is None:
        return FRONT
    size = box[1] - box[0]
    is_flat = size[2] <= 0.25 * max(size[0], size[1]) and size[2] <= 2 * size[1]
    return FRONT if is_flat else axonometric(up)
