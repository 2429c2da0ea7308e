"""Solid elements: where their nodes are, their shape functions, faces and points of integration.

An element is defined by a table: nodes in reference coordinates, and the monomials of its shape functions. The
condition
that shape functions are 1 at their node and 0 at the other ones defines them.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from itertools import product
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._tools.later import scipy

Exponents = tuple[tuple[int, ...], ...]  # powers of x, y and z


@dataclass(frozen=True)
class Rule:
    """Points of integration in reference coordinates, and their weights."""

    points: FloatArray
    weights: FloatArray


def _gauss(n: int, low: float, power: float = 0.0) -> tuple[FloatArray, FloatArray]:
    """Points and weights on the interval from `low` to 1, of a weight function (1 - x)^power."""
    points, weights = scipy.special.roots_jacobi(n, power, 0.0)
    half = 0.5 * (1.0 - low)
    return low + half * (points + 1.0), weights * half ** (power + 1.0)


def _grid(*axes: tuple[FloatArray, FloatArray]) -> Rule:
    points = np.stack([axis.ravel() for axis in np.meshgrid(*(points for points, _ in axes), indexing="ij")], axis=1)
    weights = np.prod(np.meshgrid(*(weights for _, weights in axes), indexing="ij"), axis=0).ravel()
    return Rule(points, weights)


@cache
def hexahedron_rule(n: int) -> Rule:
    """Gauss points of the cube from -1 to 1."""
    return _grid(*[_gauss(n, -1.0)] * 3)


@cache
def tetrahedron_rule(n: int) -> Rule:
    """Gauss points of a cube that is collapsed to the tetrahedron x, y, z >= 0, x + y + z <= 1."""
    rule = _grid(_gauss(n, 0.0, 2.0), _gauss(n, 0.0, 1.0), _gauss(n, 0.0))
    x, y, z = rule.points.T
    return Rule(np.stack([x, y * (1 - x), z * (1 - x) * (1 - y)], axis=1), rule.weights)


@cache
def wedge_rule(n: int) -> Rule:
    """Gauss points of the triangle x, y >= 0, x + y <= 1, times the interval from -1 to 1."""
    rule = _grid(_gauss(n, 0.0, 1.0), _gauss(n, 0.0), _gauss(n, -1.0))
    x, y, z = rule.points.T
    return Rule(np.stack([x, y * (1 - x), z], axis=1), rule.weights)


_RULES = {"Tet": tetrahedron_rule, "Hex": hexahedron_rule, "Wedge": wedge_rule}
_FACES: dict[str, tuple[tuple[int, ...], ...]] = {  # corners, normals pointing outwards
    "Tet": ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
    "Hex": ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
    "Wedge": ((0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
}
_EDGES: dict[str, tuple[tuple[int, int], ...]] = {  # adjacent corners of the nodes on edges, in their order
    "Tet": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    "Hex": (
        *((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)),
        *((0, 4), (1, 5), (2, 6), (3, 7)),
    ),
    "Wedge": ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)),
}
_CORNERS = {
    "Tet": [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)],
    "Hex": [(x, y, z) for z in (-1, 1) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))],
    "Wedge": [(x, y, z) for z in (-1, 1) for x, y in ((0, 0), (1, 0), (0, 1))],
}


@dataclass(frozen=True)
class Kind:
    """A kind of element: numbers of points per direction are exact for elements with straight edges."""

    name: str
    shape: str
    nodes: FloatArray
    exponents: Exponents
    stiffness_points: int
    mass_points: int

    @property
    def count(self) -> int:
        """The number of nodes."""
        return len(self.nodes)

    @property
    def faces(self) -> tuple[tuple[int, ...], ...]:
        """Corners of each face, normals pointing outwards."""
        return _FACES[self.shape]

    @property
    def edges(self) -> tuple[tuple[int, int], ...]:
        """Adjacent corners of each node on an edge; empty for linear elements."""
        return _EDGES[self.shape] if self.count > self.first_middle else ()

    @property
    def first_middle(self) -> int:
        """The first node on an edge."""
        return len(_CORNERS[self.shape])

    def rule(self, points: int) -> Rule:
        """Points of integration."""
        return _RULES[self.shape](points)

    @cached_property
    def _coefficients(self) -> FloatArray:
        return np.asarray(np.linalg.inv(_monomials(self.nodes, self.exponents)), dtype=float)

    def values(self, points: FloatArray) -> FloatArray:
        """Shape functions at points, one row per point."""
        return np.asarray(_monomials(points, self.exponents) @ self._coefficients, dtype=float)

    def gradients(self, points: FloatArray) -> FloatArray:
        """Derivatives of shape functions by reference coordinates: point, direction, node."""
        parts = []
        for axis in range(3):
            lower = tuple(tuple(e - (i == axis) for i, e in enumerate(row)) for row in self.exponents)
            factors = np.array([row[axis] for row in self.exponents], dtype=float)
            parts.append(_monomials(points, lower) * factors @ self._coefficients)
        return np.stack(parts, axis=1)


def _monomials(points: FloatArray, exponents: Sequence[Sequence[int]]) -> FloatArray:
    powers = np.maximum(np.array(exponents), 0)  # a factor of zero removes those below
    return np.asarray(np.prod(points[:, None, :] ** powers[None], axis=2), dtype=float)


def _kind(name: str, exponents: Sequence[tuple[int, ...]], stiffness: int, mass: int) -> Kind:
    shape, count = name.rstrip("0123456789"), len(exponents)
    nodes = np.array(_CORNERS[shape], dtype=float)
    if count > len(nodes):
        nodes = np.vstack([nodes, [(nodes[a] + nodes[b]) / 2 for a, b in _EDGES[shape]]])
    if count == 27:  # centres of faces and of the volume, in the order of VTK
        nodes = np.vstack(
            [nodes, -np.eye(3)[0], np.eye(3)[0], -np.eye(3)[1], np.eye(3)[1], -np.eye(3)[2], np.eye(3)[2]]
        )
        nodes = np.vstack([nodes, np.zeros(3)])
    return Kind(name, shape, nodes, tuple(exponents), stiffness, mass)


_LINEAR, _QUADRATIC = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(2, 0, 0), (0, 2, 0), (0, 0, 2)]
_CUBE, _CUBE2 = list(product((0, 1), repeat=3)), list(product((0, 1, 2), repeat=3))
_TRIANGLE, _TRIANGLE2 = [(0, 0), (1, 0), (0, 1)], [(2, 0), (1, 1), (0, 2)]

KINDS = {
    kind.name: kind
    for kind in (
        _kind("Tet4", _LINEAR, 1, 2),
        _kind("Tet10", [*_LINEAR, *_QUADRATIC, (1, 1, 0), (0, 1, 1), (1, 0, 1)], 2, 3),
        _kind("Hex8", _CUBE, 2, 2),
        _kind("Hex20", [*_CUBE, *(e for e in _CUBE2 if sum(i == 2 for i in e) == 1)], 3, 3),
        _kind("Hex27", _CUBE2, 3, 3),
        _kind("Wedge6", [(*e, z) for e in _TRIANGLE for z in (0, 1)], 2, 2),
        _kind(
            "Wedge15",
            [*((*e, z) for e in _TRIANGLE + _TRIANGLE2 for z in (0, 1)), *((*e, 2) for e in _TRIANGLE)],
            3,
            3,
        ),
    )
}


_MIRRORED = {"Tet4": [1, 0, 2, 3], "Tet10": [1, 0, 2, 3, 4, 6, 5, 8, 7, 9]}


def turned(kind: str, nodes: IntArray, positions: FloatArray) -> IntArray:
    """Nodes of elements; tetrahedra are reordered if their first face, seen from inside, is clockwise.

    Programs use either of both orders.
    """
    if kind not in _MIRRORED or nodes.size == 0 or nodes.min() < 0 or nodes.max() >= len(positions):
        return nodes
    a, b, c, d = (positions[nodes[:, i]] for i in range(4))
    inverted = np.einsum("ei,ei->e", np.cross(b - a, c - a), d - a) < 0
    return np.where(inverted[:, None], nodes[:, _MIRRORED[kind]], nodes)


@dataclass(frozen=True)
class Block:
    """Elements of one kind: nodes, one row per element, and the number of the first of them in the whole mesh."""

    kind: Kind
    nodes: IntArray
    first: int


def blocks(elements: Sequence[dict[str, Any]]) -> Iterator[Block]:
    """Give the elements of FEMinterface.elements, kind by kind."""
    first = 0
    for group in elements:
        for name, kind in KINDS.items():
            if name in group and len(group[name]) > 0:
                nodes = np.asarray(group[name], dtype=np.int64)
                if nodes.ndim != 2 or nodes.shape[1] != kind.count:
                    raise ValueError(
                        f"elements: '{name}': expected {kind.count} nodes per element, received {nodes.shape}"
                    )
                yield Block(kind, nodes, first)
                first += len(nodes)
