"""Rectangular meshes of thin plates, plane or mapped to any surface."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import itemInterface as eii
from dalembert._checks import FloatArray, as_matrix, as_transformation, as_vector, shape_error, unit_vector
from dalembert._core import Matrix3DList, symbolic

__all__ = ["ShellMesh"]

_SQUARE = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]


class ShellMesh:
    """Elements between four vertices, given in the order bottom left, bottom right, top right, top left.

    x runs from left to right, y from bottom to top. `vertexMapping`, a function of [x, y, z] that returns [x, y, z],
    bends the mesh; written with dalembert.symbolic, its derivatives are exact, otherwise they come from differences.
    `vertexTransformation`, a 4x4 matrix, moves it afterwards. Both are attributes, set before elements are created.
    """

    def __init__(
        self,
        vertices: npt.ArrayLike = _SQUARE,
        numberOfElementsX: int = 1,
        numberOfElementsY: int = 1,
        youngsModulus: float | None = None,
        poissonsRatio: float | None = None,
        density: float | None = None,
        thickness: float | None = None,
        massProportionalDamping: float = 0.0,
        thicknessAtNodes: Sequence[float] | None = None,
    ) -> None:
        self.vertices = as_matrix("ShellMesh: vertices", vertices, (4, 3))
        for name, count in (("numberOfElementsX", numberOfElementsX), ("numberOfElementsY", numberOfElementsY)):
            if count != int(count) or count < 1:
                raise shape_error(f"ShellMesh: {name}", "a positive integer", count)
        self.numberOfElementsX, self.numberOfElementsY = int(numberOfElementsX), int(numberOfElementsY)
        self.youngsModulus, self.poissonsRatio = youngsModulus, poissonsRatio
        self.density, self.thickness = density, thickness
        self.massProportionalDamping = massProportionalDamping
        self.thicknessAtNodes = thicknessAtNodes
        self.vertexMapping: Callable[[Any], Any] | None = None
        self.vertexTransformation: npt.ArrayLike | None = None
        self.Dstrain: Any = None
        self.Dcurvature: Any = None
        self.CreateReset()

    def CreateReset(self) -> None:
        """Forget nodes and elements, so that the mesh can be created again."""
        self.boundaryNodeNumbers: dict[str, list[Any]] = {
            side: [] for side in ("left", "bottom", "right", "top", "all")
        }
        self.vertexNodeNumbers: list[Any] = []
        self.nodeNumbers: list[Any] = []
        self.elementNumbers: list[Any] = []
        self.nodeReferencePositions: list[FloatArray] = []
        self.nodeSlopesX: list[FloatArray] = []
        self.nodeSlopesY: list[FloatArray] = []

    def NumberOfNodes(self) -> int:
        """The number of nodes that were created."""
        return len(self.nodeReferencePositions)

    def SetVisualizationThicknessFactor(self, mbs: Any, VthicknessFactor: float = 1.0) -> None:
        """Draw all elements thicker (>1) or thinner by a factor."""
        factor = _thickness_factor(VthicknessFactor)
        for element in self.elementNumbers:
            mbs.SetObjectParameter(element, "VthicknessFactor", factor)

    def ApplyVertexMapping(self) -> None:
        """Move the nodes by vertexMapping, if there is one; slopes are its unit tangents."""
        if self.vertexMapping is None:
            return
        mapped = [_mapped(self.vertexMapping, position) for position in self.nodeReferencePositions]
        self.nodeReferencePositions = [position for position, _ in mapped]
        for i, slopes in enumerate((self.nodeSlopesX, self.nodeSlopesY)):
            slopes[:] = [_unit(tangents[:, i], position) for position, tangents in mapped]

    def ApplyVertexTransformation(self) -> None:
        """Move the nodes by vertexTransformation, if there is one."""
        if self.vertexTransformation is None:
            return
        matrix = as_transformation("ShellMesh: vertexTransformation", self.vertexTransformation)
        self.nodeReferencePositions = [matrix[:3, :3] @ p + matrix[:3, 3] for p in self.nodeReferencePositions]
        self.nodeSlopesX = [matrix[:3, :3] @ slope for slope in self.nodeSlopesX]
        self.nodeSlopesY = [matrix[:3, :3] @ slope for slope in self.nodeSlopesY]

    def CreateANCFThinPlateElements(self, mbs: Any, VthicknessFactor: float = 1.0) -> None:
        """Add nodes and elements; their numbers are in nodeNumbers and elementNumbers, row by row.

        boundaryNodeNumbers has those of the sides 'left', 'bottom', 'right', 'top' and 'all', vertexNodeNumbers those
        of the vertices.
        """
        factor = _thickness_factor(VthicknessFactor)
        thicknesses = self._thicknesses()
        stiffness = self._stiffness_of_unit_thickness()
        self.CreateReset()
        self._place_nodes()
        self.ApplyVertexMapping()
        self.ApplyVertexTransformation()
        columns, rows = self.numberOfElementsX + 1, self.numberOfElementsY + 1
        for parts in zip(self.nodeReferencePositions, self.nodeSlopesX, self.nodeSlopesY, strict=True):
            self.nodeNumbers.append(mbs.AddNode(eii.NodePointSlope12(referenceCoordinates=np.concatenate(parts))))
        grid = np.arange(rows * columns).reshape(rows, columns)
        sides = {"left": grid[:, 0], "bottom": grid[0], "right": grid[:, -1], "top": grid[-1]}
        sides["all"] = np.unique(np.concatenate(list(sides.values())))
        self.boundaryNodeNumbers = {side: [self.nodeNumbers[i] for i in nodes] for side, nodes in sides.items()}
        corners = (grid[0, 0], grid[0, -1], grid[-1, -1], grid[-1, 0])
        self.vertexNodeNumbers = [self.nodeNumbers[i] for i in corners]
        for row in range(self.numberOfElementsY):
            for column in range(self.numberOfElementsX):
                places = [grid[row + j, column + i] for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
                h = thicknesses[:1] if self.thicknessAtNodes is None else thicknesses[places]
                self.Dstrain, self.Dcurvature = Matrix3DList(), Matrix3DList()
                for value in h:
                    self.Dstrain.Append(value * stiffness)
                    self.Dcurvature.Append(value**3 / 12.0 * stiffness)
                plate = eii.ObjectANCFThinPlate(
                    nodeNumbers=[self.nodeNumbers[i] for i in places],
                    physicsThickness=h,
                    physicsStrainCoefficients=self.Dstrain,
                    physicsCurvatureCoefficients=self.Dcurvature,
                    physicsDensity=self.density or 0.0,
                    physicsMassProportionalDamping=self.massProportionalDamping,
                )
                self.elementNumbers.append(mbs.AddObject(plate))
        if factor != 1.0:
            self.SetVisualizationThicknessFactor(mbs, factor)

    def _thicknesses(self) -> FloatArray:
        """The thickness, or those of all nodes."""
        if self.thicknessAtNodes is None:
            given: Any = [self.thickness]
            name, count = "thickness", 1
        else:
            given, name = self.thicknessAtNodes, "thicknessAtNodes"
            count = (self.numberOfElementsX + 1) * (self.numberOfElementsY + 1)
        if any(value is None for value in given):
            raise shape_error(f"ShellMesh: {name}", "a positive thickness (m)", given)
        values = as_vector(f"ShellMesh: {name}", given, count)
        if not np.all(values > 0):
            raise shape_error(f"ShellMesh: {name}", "positive thicknesses (m)", given)
        return values

    def _stiffness_of_unit_thickness(self) -> FloatArray:
        """Plane stress."""
        for name in ("youngsModulus", "density"):
            value = getattr(self, name)
            if value is None or not np.isfinite(value) or value <= 0:
                raise shape_error(f"ShellMesh: {name}", "a positive number", value)
        nu = self.poissonsRatio
        if nu is None or not -1 < nu <= 0.5:
            raise shape_error("ShellMesh: poissonsRatio", "a number between -1 and 0.5", nu)
        assert self.youngsModulus is not None
        shape = np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]])
        return self.youngsModulus / (1.0 - nu**2) * shape

    def _place_nodes(self) -> None:
        """Nodes of the plane mesh; slopes are those of its lower and left side."""
        a, b, c, d = self.vertices
        along, up = (unit_vector("ShellMesh: vertices", side) for side in (b - a, d - a))
        for y in np.linspace(0.0, 1.0, self.numberOfElementsY + 1):
            for x in np.linspace(0.0, 1.0, self.numberOfElementsX + 1):
                low, high = (1 - x) * a + x * b, (1 - x) * d + x * c
                self.nodeReferencePositions.append((1 - y) * low + y * high)
                self.nodeSlopesX.append(along)
                self.nodeSlopesY.append(up)


def _thickness_factor(value: float) -> float:
    if not np.isfinite(value) or value < 0:
        raise shape_error("ShellMesh: VthicknessFactor", "a number that is not negative", value)
    return float(value)


def _unit(tangent: FloatArray, position: FloatArray) -> FloatArray:
    length = float(np.linalg.norm(tangent))
    if not length > 0:
        text = f"vertexMapping has no tangent at its point {np.round(position, 9).tolist()}"
        raise ValueError(f"ShellMesh: {text}; it must be one to one")
    return tangent / length


def _mapped(mapping: Callable[[Any], Any], position: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the mapped point, and derivatives with respect to x and y as columns."""

    def value(point: FloatArray) -> FloatArray:
        return as_vector("ShellMesh: vertexMapping", [float(v) for v in mapping(point.tolist())], 3)

    symbols = [symbolic.Real(name, float(v)) for name, v in zip("xyz", position, strict=True)]
    try:
        found = mapping(list(symbols))
        tangents = np.array([[v.Diff(s) if hasattr(v, "Diff") else 0.0 for s in symbols[:2]] for v in found])
        if np.all(np.linalg.norm(tangents, axis=0) > 0):
            return as_vector("ShellMesh: vertexMapping", [float(v) for v in found], 3), tangents
    except (TypeError, AttributeError):  # functions that want numbers
        pass
    step = 1e-5 * max(1.0, float(np.abs(position).max()))
    moves = step * np.eye(3)[:2]
    tangents = np.stack([(value(position + move) - value(position - move)) / (2 * step) for move in moves], axis=1)
    return value(position), tangents
