"""Stress and strain modes: nodal values of each displacement mode, averaged over adjacent elements."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from dalembert._checks import FloatArray
from dalembert._fem.assembly import CHUNK, geometry
from dalembert._fem.elements import Block
from dalembert._fem.materials import strain_vector


def nodal_strains(
    mesh: Sequence[Block],
    positions: FloatArray,
    modes: FloatArray,
    laws: Sequence[FloatArray] | None,
    progress: Callable[[str], None],
) -> FloatArray:
    """Node, mode, component (xx, yy, zz, yz, xz, xy) of strains, or of stresses if there is a law for each element.

    Strains of an element are found at its nodes, by its own displacements.
    """
    count = len(positions)
    sums, times = np.zeros((count, 6 * modes.shape[1])), np.zeros(count)
    by_node = modes.reshape(count, 3, -1)
    for block in mesh:
        for start in range(0, len(block.nodes), CHUNK):
            nodes = block.nodes[start : start + CHUNK]
            gradients, _ = geometry(block.kind, positions[nodes], block.kind.nodes)
            strains = strain_vector(np.einsum("eqan,enim->eqmia", gradients, by_node[nodes], optimize=True))
            if laws is not None:
                law = np.array(laws[block.first + start : block.first + start + len(nodes)])
                strains = np.einsum("eij,eqmj->eqmi", law, strains)
            np.add.at(sums, nodes.ravel(), strains.reshape(nodes.size, -1))
            np.add.at(times, nodes.ravel(), 1.0)
        progress(f"strains of {len(block.nodes)} elements {block.kind.name}")
    return sums / np.maximum(times, 1.0)[:, None]
