"""Nested dissection of a mesh: the order in which its nodes are eliminated, so that factors have few entries.

A mesh is cut in two again and again [George 1973]; the nodes of a cut are eliminated after those on both of its sides.
Among all planes normal to an axis, the one with the best ratio of cut nodes to separated nodes is used. The number of
its nodes is minimal: no smaller set meets all edges that cross the plane [Koenig 1931].
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray
from dalembert._tools.later import scipy

BoolArray = np.typing.NDArray[np.bool_]
LEAF = 64  # nodes that are eliminated without a further cut
SMALLER_SIDE = 0.2  # minimum fraction of the nodes of a part on the smaller side of a cut


@dataclass
class Front:
    """Nodes that are eliminated together, consecutive from `begin` to `end`; `around` are the later nodes of the
    front."""

    begin: int
    end: int
    children: list[Front]
    around: IntArray = field(default_factory=lambda: np.zeros(0, dtype=np.int64))


def dissect(positions: FloatArray, graph: Any) -> tuple[IntArray, list[Front]]:
    """Nodes in the order of their elimination, and fronts of them; children come before their parents.

    `graph` has an entry for each pair of nodes that have to do with each other, and for each node with itself.
    """
    order: list[IntArray] = []
    fronts: list[Front] = []
    _dissect_part(np.arange(len(positions)), graph, positions, order, fronts)
    nodes = np.concatenate(order) if order else np.zeros(0, dtype=np.int64)
    _find_surroundings(fronts, graph[nodes][:, nodes])
    return nodes, fronts


def _dissect_part(
    part: IntArray, graph: Any, positions: FloatArray, order: list[IntArray], fronts: list[Front]
) -> list[Front]:
    """Order the nodes of a part with its graph; return its last front, or those below it if its cut has no nodes."""
    children: list[Front] = []
    if len(part) > LEAF:
        low = _half(positions[part], graph)
        cut = _smallest_cut(graph, low)
        for side in (low & ~cut, ~low & ~cut):
            inside = np.flatnonzero(side)
            if len(inside):
                children += _dissect_part(part[inside], graph[inside][:, inside], positions, order, fronts)
        part = part[cut]
    if len(part) == 0:
        return children
    begin = fronts[-1].end if fronts else 0
    order.append(part)
    fronts.append(Front(begin, begin + len(part), children))
    return [fronts[-1]]


def _half(positions: FloatArray, graph: Any) -> BoolArray:
    """Nodes on the lower side of the plane with the fewest nodes for those on its smaller side.

    The nodes below a plane with neighbours above it are all nodes below it except those with all neighbours below, so
    that
    sorted coordinates give the numbers for all planes at once.
    """
    count, best, low = len(positions), np.inf, np.arange(len(positions)) < len(positions) // 2
    for along in positions.T:
        neighbours = along[graph.indices]
        planes, below = np.unique(along, return_index=False, return_counts=True)
        below = np.cumsum(below)[:-1]
        lowest, highest = (np.sort(f.reduceat(neighbours, graph.indptr[:-1])) for f in (np.minimum, np.maximum))
        cut = np.minimum(
            below - np.searchsorted(highest, planes[1:]),
            np.searchsorted(lowest, planes[1:]) - below,
        )
        smaller = np.minimum(below, count - below)
        cost = np.where(smaller >= SMALLER_SIDE * count, cut / smaller, np.inf)
        if len(cost) and cost.min() < best:
            best, low = cost.min(), along < planes[1 + np.argmin(cost)]
    return low


def _smallest_cut(graph: Any, low: BoolArray) -> BoolArray:
    """The fewest nodes that meet all edges between the nodes of `low` and the others."""
    crossed = graph @ (~low).astype(float), graph @ low.astype(float)
    sides = np.flatnonzero(low & (crossed[0] > 0)), np.flatnonzero(~low & (crossed[1] > 0))
    edges = graph[sides[0]][:, sides[1]]
    mate = scipy.sparse.csgraph.maximum_bipartite_matching(edges, perm_type="column")
    matched = mate >= 0
    mate_above = np.zeros(len(sides[1]), dtype=np.int64)
    mate_above[mate[matched]] = np.flatnonzero(matched)
    # reached from nodes without a mate, by edges up and by matches down
    reached, reached_above = ~matched, np.zeros(len(sides[1]), dtype=bool)
    new = np.flatnonzero(reached)
    while len(new):
        above = np.unique(edges[new].indices)
        above = above[~reached_above[above]]
        reached_above[above] = True
        new = mate_above[above]
        new = new[~reached[new]]
        reached[new] = True
    cut = np.zeros(len(low), dtype=bool)
    cut[sides[0][~reached]] = True
    cut[sides[1][reached_above]] = True
    return cut


def _find_surroundings(fronts: list[Front], graph: Any) -> None:
    """Find the later nodes of each front, from its own entries and from the updates of its children."""
    for front in fronts:
        reached = graph.indices[graph.indptr[front.begin] : graph.indptr[front.end]]
        nodes = np.unique(np.concatenate([reached, *(child.around for child in front.children)]))
        front.around = nodes[nodes >= front.end].astype(np.int64)
