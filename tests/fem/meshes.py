"""Blocks of all kinds of elements."""

import numpy as np

from dalembert import FEM
from dalembert._fem.elements import KINDS

STEEL = FEM.KirchhoffMaterial(2.1e11, 0.3, 7850.0)
SIX = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]


def hexahedra(cells, size, origin=(0, 0, 0)):
    """Positions and nodes of a grid of hexahedra."""
    axes = [np.linspace(o, o + s, n + 1) for o, s, n in zip(origin, size, cells, strict=True)]
    positions = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    i, j, k = (g.ravel() for g in np.meshgrid(*map(np.arange, cells), indexing="ij"))
    number = lambda i, j, k: (i * (cells[1] + 1) + j) * (cells[2] + 1) + k  # noqa: E731
    ring = ((0, 0), (1, 0), (1, 1), (0, 1))
    return positions, np.stack([number(i + a, j + b, k + c) for c in (0, 1) for a, b in ring], axis=1)


def refined(kind, positions, corners):
    """Add the nodes on edges, faces and in the middle, where a kind has them."""
    table, nodes = KINDS[kind], [corners]
    middles = [corners[:, list(edge)] for edge in table.edges]
    if table.count == 27:
        faces = ((0, 3, 4, 7), (1, 2, 5, 6), (0, 1, 4, 5), (2, 3, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7), range(8))
        middles += [corners[:, list(face)] for face in faces]
    points, offset = [positions], len(positions)
    places = np.concatenate([positions[m].mean(axis=1) for m in middles]) if middles else np.zeros((0, 3))
    unique, inverse = np.unique(np.round(places, 9), axis=0, return_inverse=True)
    added = np.zeros((len(unique), 3))
    added[inverse.ravel()] = places
    points.append(added)
    nodes += [offset + part[:, None] for part in inverse.ravel().reshape(len(middles), -1)] if middles else []
    return np.vstack(points), np.hstack(nodes)


def block(kind, cells=(2, 2, 2), size=(1.0, 1.0, 1.0), origin=(0, 0, 0)):
    """Positions and {kind: nodes} of a block."""
    positions, corners = hexahedra(cells, size, origin)
    shape = KINDS[kind].shape
    if shape == "Tet":
        corners = np.concatenate([corners[:, list(part)] for part in SIX])
    elif shape == "Wedge":
        corners = np.concatenate([corners[:, [0, 1, 2, 4, 5, 6]], corners[:, [0, 2, 3, 4, 6, 7]]])
    positions, nodes = refined(kind, positions, corners)
    return positions, {kind: nodes}


def solid(kind, cells=(2, 2, 2), size=(1.0, 1.0, 1.0), material=STEEL, origin=(0, 0, 0)):
    """A block with matrices."""
    fem = FEM.FEMinterface()
    fem.SetMesh(*block(kind, cells, size, origin))
    fem.AssembleMatrices(material)
    return fem
