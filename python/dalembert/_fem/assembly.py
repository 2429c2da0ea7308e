"""Mass and stiffness matrices of linear elasticity on a mesh.

Chunks of elements are integrated at once; then the numbers of all elements are summed, pair of nodes by pair of nodes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._fem.elements import Block, Kind
from dalembert._tools.later import scipy

CHUNK = 500  # elements at once: few enough for their numbers to stay in the cache


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


def assemble(
    mesh: Sequence[Block],
    positions: FloatArray,
    constants: FloatArray,
    progress: Callable[[str], None],
) -> tuple[Any, Any]:
    """Mass and stiffness matrix; `constants` has shear modulus, Lame's constant and density of each element."""
    total = sum(block.nodes.size * block.nodes.shape[1] for block in mesh)
    pairs, numbers, begin = np.empty(total, dtype=np.int64), np.empty((10, total)), 0
    for block in mesh:
        for chunk in _chunks(block):
            nodes = block.nodes[chunk].astype(np.int64)
            mu, lame, density = constants[block.first :][chunk][: len(nodes)].T
            corners = positions[nodes]
            own = slice(begin, begin + nodes.size * nodes.shape[1])
            pairs[own] = (nodes[:, :, None] * len(positions) + nodes[:, None, :]).ravel()
            numbers[:9, own] = _by_pairs(element_stiffness(block.kind, corners, mu, lame))
            numbers[9, own] = element_mass(block.kind, corners, density).ravel()
            begin = own.stop
        progress(f"{len(block.nodes)} elements {block.kind.name} integrated")
    return _sum_of_elements(len(positions), pairs, numbers)


def _by_pairs(matrices: FloatArray) -> FloatArray:
    """Nine lines, of the numbers of each pair of nodes; symmetric, which they are not with round-off."""
    size = matrices.shape[1] // 3
    symmetric = 0.5 * (matrices + matrices.transpose(0, 2, 1))
    return symmetric.reshape(-1, size, 3, size, 3).transpose(2, 4, 0, 1, 3).reshape(9, -1)


def _sum_of_elements(count: int, pairs: IntArray, numbers: FloatArray) -> tuple[Any, Any]:
    """Mass and stiffness matrix by the numbers of each pair (i, j) of nodes, which is written as i * count + j."""
    different, places = np.unique(pairs, return_inverse=True)
    structure = different % count, np.searchsorted(different, count * np.arange(count + 1))
    blocks = np.empty((len(different), 9))
    for axes, summands in enumerate(numbers[:9]):
        blocks[:, axes] = np.bincount(places, weights=summands)
    stiffness = scipy.sparse.bsr_matrix((blocks.reshape(-1, 3, 3), *structure), shape=(3 * count, 3 * count)).tocsr()
    masses = np.bincount(places, weights=numbers[9])
    mass = scipy.sparse.csr_matrix((masses, *structure), shape=(count, count))
    return scipy.sparse.kron(mass, scipy.sparse.eye(3), format="csr"), stiffness
