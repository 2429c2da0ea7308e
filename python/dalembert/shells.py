"""Rectangular meshes of thin plates, plane or mapped to any surface; their supports, hinges and loads of edges."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert import itemInterface as eii
from dalembert._checks import FloatArray, as_matrix, as_transformation, as_vector, shape_error, unit_vector
from dalembert._core import Matrix3DList, symbolic
from dalembert._geometry.surface_maps import SurfaceMap

__all__ = [
    "AddClampToGround",
    "AddDistributedClampToEdge",
    "AddEdgeSpringDamper",
    "AddNodeConstraints",
    "AddRotationalSpringDamper",
    "AddSlopeConformityConstraints",
    "AddSphericalJointToGround",
    "ApplyEdgeLoad",
    "ShellMesh",
    "SurfaceMap",
]

_SQUARE = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]


class ShellMesh:
    """Elements between four vertices, given in the order bottom left, bottom right, top right, top left.

    x runs from left to right, y from bottom to top. `vertexMapping`, a function of [x, y, z] that returns [x, y, z],
    bends the mesh; written with dalembert.symbolic, its derivatives are exact, otherwise they come from differences.
    `vertexTransformation`, a 4x4 matrix, moves it afterwards. Both are attributes, set before elements are created.
    `surfaceMap`, a function f(x, y) that returns [X, Y, Z], is the same as vertexMapping for plane vertices.
    `thicknessFunction`, a function of the global x and y of a node, sets the thickness at nodes; it goes before
    thicknessAtNodes and thickness. Elements interpolate the thickness linearly, as their stiffness.
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
        thicknessFunction: Callable[[Any, Any], Any] | None = None,
        stiffnessProportionalDamping: float = 0.0,
        surfaceMap: Callable[[Any, Any], Any] | None = None,
    ) -> None:
        self.vertices = as_matrix("ShellMesh: vertices", vertices, (4, 3))
        for name, count in (("numberOfElementsX", numberOfElementsX), ("numberOfElementsY", numberOfElementsY)):
            if count != int(count) or count < 1:
                raise shape_error(f"ShellMesh: {name}", "a positive integer", count)
        self.numberOfElementsX, self.numberOfElementsY = int(numberOfElementsX), int(numberOfElementsY)
        self.youngsModulus, self.poissonsRatio = youngsModulus, poissonsRatio
        self.density, self.thickness = density, thickness
        self.massProportionalDamping = massProportionalDamping
        self.stiffnessProportionalDamping = stiffnessProportionalDamping
        self.thicknessAtNodes = thicknessAtNodes
        self.thicknessFunction = thicknessFunction
        self.surfaceMap = surfaceMap
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
        self.thicknessGradientAtNodes: FloatArray | None = None

    def NumberOfNodes(self) -> int:
        """The number of nodes that were created."""
        return len(self.nodeReferencePositions)

    def SetVisualizationThicknessFactor(self, mbs: Any, VthicknessFactor: float = 1.0) -> None:
        """Draw all elements thicker (>1) or thinner by a factor."""
        factor = _thickness_factor(VthicknessFactor)
        for element in self.elementNumbers:
            mbs.SetObjectParameter(element, "VthicknessFactor", factor)

    def ApplyVertexMapping(self) -> None:
        """Move the nodes by vertexMapping or surfaceMap, if there is one; slopes are its unit tangents."""
        mapping, surface = self.vertexMapping, self.surfaceMap
        if mapping is not None and surface is not None:
            raise ValueError("ShellMesh: vertexMapping and surfaceMap: expected one of them")
        if surface is not None:

            def of_surface(p: Any) -> Any:
                return surface(p[0], p[1])

            mapping = of_surface
        if mapping is None:
            return
        mapped = [_mapped(mapping, position) for position in self.nodeReferencePositions]
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

    def ComputeNodalThicknessGradients(self) -> None:
        """Evaluate thicknessFunction, if there is one, at the reference positions of the nodes.

        Rows of thicknessGradientAtNodes are the thickness and its derivatives along the two unit slopes of the node.
        """
        function = self.thicknessFunction
        if function is None:
            return

        def of_place(p: Any) -> list[Any]:
            return [function(p[0], p[1]), 0.0, 0.0]

        rows = []
        for place, *slopes in zip(self.nodeReferencePositions, self.nodeSlopesX, self.nodeSlopesY, strict=True):
            value, derivatives = _value_and_derivatives(of_place, place, "thicknessFunction")
            rows.append([value[0], *(derivatives[0] @ slope[:2] for slope in slopes)])
        self.thicknessGradientAtNodes = np.array(rows)

    def CreateANCFThinPlateElements(
        self, mbs: Any, VthicknessFactor: float = 1.0, useReducedOrderIntegration: int = 0
    ) -> None:
        """Add nodes and elements; their numbers are in nodeNumbers and elementNumbers, row by row.

        boundaryNodeNumbers has those of the sides 'left', 'bottom', 'right', 'top' and 'all', vertexNodeNumbers those
        of the vertices. useReducedOrderIntegration: see ObjectANCFThinPlate.
        """
        factor = _thickness_factor(VthicknessFactor)
        stiffness = self._stiffness_of_unit_thickness()
        self.CreateReset()
        self._place_nodes()
        self.ApplyVertexMapping()
        self.ApplyVertexTransformation()
        self.ComputeNodalThicknessGradients()
        thicknesses = self._thicknesses()
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
                h = thicknesses[:1] if len(thicknesses) == 1 else thicknesses[places]
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
                    stiffnessProportionalDamping=self.stiffnessProportionalDamping,
                    useReducedOrderIntegration=useReducedOrderIntegration,
                )
                self.elementNumbers.append(mbs.AddObject(plate))
        if factor != 1.0:
            self.SetVisualizationThicknessFactor(mbs, factor)

    def _thicknesses(self) -> FloatArray:
        """The thickness, or those of all nodes."""
        if self.thicknessGradientAtNodes is not None:
            given: Any = self.thicknessGradientAtNodes[:, 0].tolist()
            name, count = "thicknessFunction", len(given)
        elif self.thicknessAtNodes is None:
            given = [self.thickness]
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


def _value_and_derivatives(
    mapping: Callable[[Any], Any], position: FloatArray, name: str
) -> tuple[FloatArray, FloatArray]:
    """Return three values at a point, and their derivatives with respect to x and y as columns.

    A function of symbolic numbers has exact derivatives; others, and those that compute with numpy, differences.
    """

    def value(point: FloatArray) -> FloatArray:
        return as_vector(f"ShellMesh: {name}", [float(v) for v in mapping(point.tolist())], 3)

    symbols = [symbolic.Real(axis, float(v)) for axis, v in zip("xyz", position, strict=True)]
    try:
        found = mapping(list(symbols))
        if any(hasattr(v, "Diff") for v in found):
            rates = np.array([[v.Diff(s) if hasattr(v, "Diff") else 0.0 for s in symbols[:2]] for v in found])
            return as_vector(f"ShellMesh: {name}", [float(v) for v in found], 3), rates
    except (TypeError, AttributeError):  # functions that want numbers
        pass
    step = 1e-5 * max(1.0, float(np.abs(position).max()))
    moves = step * np.eye(3)[:2]
    rates = np.stack([(value(position + move) - value(position - move)) / (2 * step) for move in moves], axis=1)
    return value(position), rates


def _mapped(mapping: Callable[[Any], Any], position: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the mapped point, and derivatives with respect to x and y as columns."""
    return _value_and_derivatives(mapping, position, "vertexMapping")


# ---- supports, hinges and loads
# Coordinates of a node: 0 to 2 its displacement, 3 to 5 the slope along x, 6 to 8 that along y.


def AddNodeConstraints(mbs: Any, nodeNumber: Any, dofs: Iterable[int], refNodeNumber: Any = None) -> list[Any]:
    """Fix coordinates of a node at their reference values, or set them equal to those of another node.

    Returns the objects. For nodes of two meshes, coordinates are displacements: equal nodes stay equal.
    """
    fixed = list(dofs)
    if refNodeNumber is None:
        ground = mbs.AddNode(eii.NodePointGround(referenceCoordinates=_place(mbs, nodeNumber)))
        others = [mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))] * len(fixed)
    else:
        others = [mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=refNodeNumber, coordinate=i)) for i in fixed]
    objects = []
    for other, i in zip(others, fixed, strict=True):
        own = mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=nodeNumber, coordinate=i))
        objects.append(mbs.AddObject(eii.CoordinateConstraint(markerNumbers=[other, own])))
    return objects


def AddSphericalJointToGround(mbs: Any, nodeNumber: Any) -> list[Any]:
    """Fix the position of a node; its slopes are free."""
    return AddNodeConstraints(mbs, nodeNumber, range(3))


def AddClampToGround(mbs: Any, nodeNumber: Any, fixedConstraints: Sequence[int] | None = None) -> list[Any]:
    """Fix all coordinates of a node, or those whose entry of nine in fixedConstraints is not 0.

    A clamped edge along y of a plate in the xy-plane is [1, 1, 1, 0, 1, 1, 1, 0, 1]: it may stretch.
    """
    flags = [1] * 9 if fixedConstraints is None else list(fixedConstraints)
    if len(flags) != 9:
        raise shape_error("AddClampToGround: fixedConstraints", "nine numbers 0 or 1", fixedConstraints)
    return AddNodeConstraints(mbs, nodeNumber, [i for i, flag in enumerate(flags) if flag])


def AddSlopeConformityConstraints(
    mbs: Any, plateMesh: ShellMesh, direction: str = "x", components: Sequence[int] = (0, 1, 2)
) -> list[Any]:
    """Make the slope across the elements' sides linear along these sides; direction: 'x', 'y' or 'both'.

    The slope of ObjectANCFThinPlate along x varies with a cubic polynomial along y that depends on all four nodes, so
    that neighbours agree at their nodes only. This makes a strip that is one element wide bend as ObjectANCFCable2D.
    It stiffens plates, and 'both' has redundant equations if there are several rows of elements.
    """
    if direction not in ("x", "y", "both"):
        raise shape_error("AddSlopeConformityConstraints: direction", "'x', 'y' or 'both'", direction)
    sides = {"x": ["left"], "y": ["bottom"], "both": ["left", "bottom"]}[direction]
    ground = _zero_marker(mbs)
    return [
        _linear_slope(mbs, ground, element, side, components) for element in plateMesh.elementNumbers for side in sides
    ]


def AddDistributedClampToEdge(
    mbs: Any, plateMesh: ShellMesh, edgeKey: str, components: Sequence[int] = (0, 1, 2)
) -> list[Any]:
    """Make the slope across an edge of the mesh linear between its nodes, which are clamped by AddClampToGround.

    An edge with clamped nodes only turns a bit between them, see AddSlopeConformityConstraints; do not add both.
    """
    ground = _zero_marker(mbs)
    return [_linear_slope(mbs, ground, element, edgeKey, components) for element in _edge(plateMesh, edgeKey)]


def ApplyEdgeLoad(
    mbs: Any,
    plateMesh: ShellMesh,
    edgeKey: str,
    loadVector: npt.ArrayLike | None = None,
    torqueVector: npt.ArrayLike | None = None,
    distributed: bool = False,
) -> list[Any]:
    """Add the total force and the total torque of an edge, spread evenly over its length; returns the loads.

    Nodes get half of the share of the elements beside them. distributed=True: forces act in two points of each element
    so that their work is that of a constant line load, which also loads the slopes. Torques act on nodes.
    """
    loads = []
    elements, nodes = _edge(plateMesh, edgeKey), plateMesh.boundaryNodeNumbers[edgeKey]
    weights = np.full(len(nodes), 1.0 / len(elements))
    weights[[0, -1]] /= 2

    def total(name: str, value: npt.ArrayLike | None) -> FloatArray:
        return np.zeros(3) if value is None else as_vector(f"ApplyEdgeLoad: {name}", value, 3)

    force, torque = total("loadVector", loadVector), total("torqueVector", torqueVector)
    if force.any() and distributed:
        for element in elements:
            for s in _GAUSS:
                place = [*_on_side(edgeKey, s), 0.0]
                marker = mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=element, localPosition=place))
                loads.append(mbs.AddLoad(eii.Force(markerNumber=marker, loadVector=force / (2 * len(elements)))))
    for node, weight in zip(nodes, weights, strict=True):
        if force.any() and not distributed:
            marker = mbs.AddMarker(eii.MarkerNodePosition(nodeNumber=node))
            loads.append(mbs.AddLoad(eii.Force(markerNumber=marker, loadVector=weight * force)))
        if torque.any():
            marker = mbs.AddMarker(eii.MarkerNodeRigid(nodeNumber=node))
            loads.append(mbs.AddLoad(eii.Torque(markerNumber=marker, loadVector=weight * torque)))
    return loads


def AddRotationalSpringDamper(
    mbs: Any, nodeA: Any, nodeB: Any, dofs: Iterable[int], stiffness: float, damping: float = 0.0
) -> list[Any]:
    """Add spring-dampers between the same coordinates of two nodes, such as dofs=[3, 4, 5] of slopes along x.

    For small angles, the stiffness against differences of a unit slope is that against the angle, in Nm/rad.
    """
    objects = []
    for i in dofs:
        markers = [mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=n, coordinate=i)) for n in (nodeA, nodeB)]
        spring = eii.CoordinateSpringDamper(markerNumbers=markers, stiffness=stiffness, damping=damping)
        objects.append(mbs.AddObject(spring))
    return objects


def AddEdgeSpringDamper(
    mbs: Any,
    nodesA: Sequence[Any],
    nodesB: Sequence[Any],
    dofs: Iterable[int],
    totalStiffness: float,
    totalDamping: float = 0.0,
) -> list[Any]:
    """Spread a stiffness and a damping evenly over a hinge between two rows of equally distant nodes.

    Ends of the rows get half of what the nodes between them get.
    """
    if len(nodesA) != len(nodesB) or len(nodesA) < 2:
        raise ValueError(
            "AddEdgeSpringDamper: nodesA and nodesB: expected as many nodes in both, at least two; "
            f"received {len(nodesA)} and {len(nodesB)}"
        )
    coupled, last = list(dofs), len(nodesA) - 1
    objects = []
    for i, (a, b) in enumerate(zip(nodesA, nodesB, strict=True)):
        share = (0.5 if i in (0, last) else 1.0) / last
        objects += AddRotationalSpringDamper(mbs, a, b, coupled, share * totalStiffness, share * totalDamping)
    return objects


# Points of a side in which two values integrate a cubic polynomial (Gauss).
_GAUSS = (-1 / math.sqrt(3), 1 / math.sqrt(3))
_SIDES = ("left", "right", "bottom", "top")
_CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))


def _place(mbs: Any, node: Any) -> list[float]:
    return list(mbs.GetNodeParameter(node, "referenceCoordinates"))[:3]


def _edge(mesh: ShellMesh, side: str) -> list[Any]:
    """Return the elements at a side of the mesh."""
    if side not in _SIDES:
        raise shape_error("edgeKey", "'left', 'right', 'bottom' or 'top'", side)
    if not mesh.elementNumbers:
        raise ValueError("plateMesh: expected a mesh with elements; call CreateANCFThinPlateElements first")
    grid = np.arange(len(mesh.elementNumbers)).reshape(mesh.numberOfElementsY, mesh.numberOfElementsX)
    chosen = {"left": grid[:, 0], "right": grid[:, -1], "bottom": grid[0], "top": grid[-1]}[side]
    return [mesh.elementNumbers[i] for i in chosen]


def _on_side(side: str, s: float) -> tuple[float, float]:
    """Return local coordinates of a place on a side of an element."""
    return {"left": (-1.0, s), "right": (1.0, s), "bottom": (s, -1.0), "top": (s, 1.0)}[side]


def _zero_marker(mbs: Any) -> Any:
    """Return a marker on coordinates that are always zero."""
    return mbs.AddMarker(eii.MarkerNodeCoordinates(nodeNumber=mbs.AddNode(eii.NodePointGround())))


def _slope_across(side: str, s: float, lengths: FloatArray) -> FloatArray:
    """Return the shares of 12 nodal vectors (position and two slopes of four nodes) in the slope across a side.

    The slope is the derivative with respect to a local coordinate; lengths: of the two slopes of each node.
    """
    first = side in ("left", "right")
    u, v = _on_side(side, s) if first else _on_side(side, s)[::-1]  # across and along the side
    shares = np.zeros((4, 3))
    for corner, (a, b) in enumerate(_CORNERS):
        p, q = (a, b) if first else (b, a)
        linear, cubic = (1 + q * v) / 2, (2 + 3 * q * v - q * v**3) / 4
        # derivatives along u of the linear function, the cubic function, and that of a unit slope at this corner
        by_linear, by_cubic, by_slope = p / 2, 0.75 * p * (1 - u**2), (3 * u**2 + 2 * p * u - 1) / 4
        slope_along = -q * (1 - v**2) * (1 + q * v) / 4
        lx, ly = lengths[:, corner] if first else lengths[::-1, corner]
        own = [by_slope * linear * lx / 2, slope_along * by_linear * ly / 2]
        shares[corner] = [by_cubic * linear + by_linear * cubic - by_linear * linear, *(own if first else own[::-1])]
    return shares.ravel()


def _linear_slope(mbs: Any, ground: Any, element: Any, side: str, components: Sequence[int]) -> Any:
    """Constrain the slope across a side of an element to be linear along it; cubic polynomials need two points."""
    nodes = mbs.GetObjectParameter(element, "nodeNumbers")
    reference = np.array([mbs.GetNodeParameter(node, "referenceCoordinates") for node in nodes])
    places = reference[:, :3]
    sides = [np.linalg.norm(places[(i + 1) % 4] - places[i]) for i in range(4)]
    lengths = np.array([[sides[0], sides[0], sides[2], sides[2]], [sides[3], sides[1], sides[1], sides[3]]])
    for row, name in zip(lengths, ("slopesScalingX", "slopesScalingY"), strict=True):
        given = np.array(mbs.GetObjectParameter(element, name))
        row[given > 0] = given[given > 0]
    rows = []
    for s in _GAUSS:
        ends = [(1 + end * s) / 2 * _slope_across(side, end, lengths) for end in (-1.0, 1.0)]
        share = _slope_across(side, s, lengths) - ends[0] - ends[1]
        rows += [np.kron(share, np.eye(3)[i]) for i in components]
    marker = mbs.AddMarker(eii.MarkerObjectODE2Coordinates(objectNumber=element))
    matrix = np.array(rows)
    equations = eii.CoordinateVectorConstraint(
        markerNumbers=[ground, marker],
        scalingMarker1=matrix,
        offset=matrix @ reference.ravel(),
        visualization={"show": False},
    )
    return mbs.AddObject(equations)
