"""Mass and stiffness matrices of linear elasticity on a mesh.

Chunks of elements are integrated at once; entries of all elements are summed by scipy, row by row.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
import scipy.sparse

from dalembert._checks import FloatArray, IntArray
from dalembert._fem.elements import Block, Kind

CHUNK = 4000  # elements at once: their numbers stay in the cache


def geometry(kind: Kind, corners: FloatArray, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Derivatives of shape functions by x, y, z (element, point, direction, node), and Jacobian determinants."""
    by_reference = kind.gradients(points)
    jacobians = np.einsum("qdn,enx->eqdx", by_reference, corners)
    determinants = np.linalg.det(jacobians)
    with np.errstate(all="ignore"):
        safe = np.where(determinants[..., None, None] == 0, np.eye(3), jacobians)
        gradients = np.linalg.solve(safe, np.broadcast_to(by_reference, (len(corners), *by_reference.shape)))
    return gradients, determinants


def element_stiffness(kind: Kind, corners: FloatArray, mu: FloatArray, lame: FloatArray) -> FloatArray:
    """Stiffness matrices of elements with nodes at `corners` (element, node, xyz), of isotropic materials."""
    rule = kind.rule(kind.stiffness_points)
    gradients, determinants = geometry(kind, corners, rule.points)
    n, count = kind.count, len(corners)
    weighted = gradients * (determinants * rule.weights)[..., None, None]
    flat = gradients.reshape(count, len(rule.weights), 3 * n)
    products = (weighted.reshape(flat.shape).transpose(0, 2, 1) @ flat).reshape(count, 3, n, 3, n)
    laplace = np.einsum("eaiaj->eij", products)
    result = lame[:, None, None, None, None] * products + mu[:, None, None, None, None] * products.transpose(
        0, 3, 2, 1, 4
    )
    for axis in range(3):
        result[:, axis, :, axis] += mu[:, None, None] * laplace
    return result.transpose(0, 2, 1, 4, 3).reshape(count, 3 * n, 3 * n)


def element_mass(kind: Kind, corners: FloatArray, density: FloatArray) -> FloatArray:
    """Mass matrices of elements, one number for each pair of nodes."""
    rule = kind.rule(kind.mass_points)
    values = kind.values(rule.points)
    jacobians = np.einsum("qdn,enx->eqdx", kind.gradients(rule.points), corners)
    weights = np.linalg.det(jacobians) * rule.weights * density[:, None]
    pairs = (values[:, :, None] * values[:, None, :]).reshape(len(values), -1)
    return (weights @ pairs).reshape(len(corners), kind.count, kind.count)


def _chunks(block: Block) -> Iterator[slice]:
    return (slice(start, start + CHUNK) for start in range(0, len(block.nodes), CHUNK))


def _sum(size: int, rows: list[IntArray], columns: list[IntArray], values: list[FloatArray]) -> Any:
    parts = (np.concatenate([part.ravel() for part in parts]) for parts in (values, rows, columns))
    data, row, column = parts
    matrix = scipy.sparse.csr_matrix((data, (row, column)), shape=(size, size))
    matrix.sum_duplicates()
    return matrix


def assemble(
    mesh: Sequence[Block],
    positions: FloatArray,
    constants: FloatArray,
    progress: Callable[[str], None],
) -> tuple[Any, Any]:
    """Mass and stiffness matrix; `constants` has shear modulus, Lame's constant and density of each element."""
    count = len(positions)
    mass: Any = scipy.sparse.csr_matrix((count, count))
    stiffness: Any = scipy.sparse.csr_matrix((3 * count, 3 * count))
    for block in mesh:
        entries: list[tuple[IntArray, IntArray, FloatArray]] = []
        masses: list[tuple[IntArray, IntArray, FloatArray]] = []
        for chunk in _chunks(block):
            nodes = block.nodes[chunk].astype(np.int32)
            mu, lame, density = constants[block.first :][chunk][: len(nodes)].T
            corners = positions[nodes]
            rows = (3 * nodes[:, :, None] + np.arange(3, dtype=np.int32)).reshape(len(nodes), -1)
            matrices = element_stiffness(block.kind, corners, mu, lame)
            entries.append((*_places(rows), matrices))
            masses.append((*_places(nodes), element_mass(block.kind, corners, density)))
        progress(f"{len(block.nodes)} elements {block.kind.name} integrated")
        stiffness = stiffness + _sum(3 * count, *map(list, zip(*entries, strict=True)))
        mass = mass + _sum(count, *map(list, zip(*masses, strict=True)))
    stiffness = 0.5 * (stiffness + stiffness.T)  # round-off is not symmetric
    return scipy.sparse.kron(mass, scipy.sparse.eye(3), format="csr"), stiffness.tocsr()


def _places(rows: Any) -> tuple[IntArray, IntArray]:
    n = rows.shape[1]
    return np.repeat(rows, n, axis=1), np.tile(rows, (1, n))
