"""The surface of a mesh: triangles for drawing, and areas that belong to nodes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert._checks import FloatArray, IntArray, shape_error
from dalembert._fem.data import MeshData
from dalembert._fem.elements import Block, Kind, blocks

MESH_SURFACE = "meshSurface"


def _need_corners(name: str, numbers: Any, corners: int) -> None:
    if not isinstance(numbers, (Sequence, np.ndarray)) or isinstance(numbers, str) or len(numbers) < corners:
        raise shape_error(name, f"{corners} numbers of nodes or more", numbers)


def ConvertHexToTrigs(nodeNumbers: Sequence[int]) -> list[list[int]]:
    """The 12 triangles on the faces of a hexahedron with 8 nodes; nodes on edges are left out."""
    _need_corners("ConvertHexToTrigs: nodeNumbers", nodeNumbers, 8)
    corners = (
        *((0, 1, 2), (0, 2, 3), (6, 5, 4), (6, 4, 7), (0, 4, 1), (1, 4, 5)),
        *((1, 5, 2), (2, 5, 6), (2, 6, 3), (3, 6, 7), (3, 7, 0), (0, 7, 4)),
    )
    return [[nodeNumbers[i] for i in corner] for corner in corners]


def ConvertTetToTrigs(nodeNumbers: Sequence[int]) -> list[list[int]]:
    """The 4 triangles on the faces of a tetrahedron; nodes on edges are left out."""
    _need_corners("ConvertTetToTrigs: nodeNumbers", nodeNumbers, 4)
    return [[nodeNumbers[i] for i in corner] for corner in ((0, 1, 2), (0, 3, 1), (1, 3, 2), (0, 2, 3))]


def face_triangles(kind: Kind, face: Sequence[int]) -> list[tuple[int, int, int]]:
    """Triangles that fill a face; nodes on its edges are corners of them."""
    edges = {frozenset(edge): kind.first_middle + i for i, edge in enumerate(kind.edges)}
    n = len(face)
    if not edges:
        return [(face[0], face[i], face[i + 1]) for i in range(1, n - 1)]
    middle = [edges[frozenset((face[i], face[(i + 1) % n]))] for i in range(n)]
    tips = [(face[i], middle[i], middle[i - 1]) for i in range(n)]
    return tips + [(middle[0], middle[i], middle[i + 1]) for i in range(1, n - 1)]


def _outer(mesh: Sequence[Block]) -> list[IntArray]:
    """Return, for each block, the faces of its elements without neighbour: element, face."""
    corners = [block.nodes[:, list(face)] for block in mesh for face in block.kind.faces]
    keys = np.concatenate([_key(part) for part in corners]) if corners else np.zeros((0, 4), dtype=np.int64)
    _, place, times = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    single = times[place.ravel()] == 1
    result, start = [], 0
    for block in mesh:
        size = len(block.nodes) * len(block.kind.faces)
        faces = single[start : start + size].reshape(len(block.kind.faces), len(block.nodes))
        result.append(np.argwhere(faces.T))
        start += size
    return result


def _key(corners: IntArray) -> IntArray:
    padded = np.full((len(corners), 4), -1, dtype=np.int64)
    padded[:, : corners.shape[1]] = corners
    return np.sort(padded, axis=1)


def surface_triangles(mesh: Sequence[Block], interior: bool = False) -> IntArray:
    """Triangles of the surface, or of all faces; normals point outwards."""
    parts = [np.zeros((0, 3), dtype=np.int64)]
    places = [None] * len(mesh) if interior else _outer(mesh)
    for block, place in zip(mesh, places, strict=True):
        for number, face in enumerate(block.kind.faces):
            chosen = block.nodes if place is None else block.nodes[place[place[:, 1] == number, 0]]
            parts += [chosen[:, list(triangle)] for triangle in face_triangles(block.kind, face)]
    return np.concatenate(parts)


def triangle_areas(positions: FloatArray, triangles: IntArray) -> FloatArray:
    """Areas of triangles."""
    a, b, c = (positions[triangles[:, i]] for i in range(3))
    return np.asarray(0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1), dtype=float)


class Surfaces(MeshData):
    """The surface of the mesh, and node sets of boundaries."""

    def GetSurfaceTriangles(self) -> list[Any]:
        """Triangles of all surfaces, as lists of three node numbers."""
        return [row for part in self.surface if "Trigs" in part for row in np.asarray(part["Trigs"]).tolist()]

    def VolumeToSurfaceElements(self, verbose: bool = False) -> None:
        """Make the surface of all solid elements; nodes on edges of quadratic elements are corners of triangles."""
        self._set_surface(surface_triangles(list(blocks(self.elements))), verbose)

    def _set_surface(self, triangles: IntArray, verbose: bool) -> None:
        if verbose:
            print(f"surface: {len(triangles)} triangles")
        self.surface = [part for part in self.surface if part.get("Name") != MESH_SURFACE]
        self.surface.append({"Name": MESH_SURFACE, "Trigs": triangles})

    def GetNodeWeightsFromSurfaceAreas(
        self, nodeList: Sequence[int] | IntArray, normalizeWeights: bool = True
    ) -> FloatArray:
        """Area that belongs to each node of a list, a third of its triangles on the surface; the sum is 1 by default.

        Triangles count whose three nodes are in the list.
        """
        nodes = np.asarray(nodeList, dtype=np.int64)
        triangles = np.asarray(self.GetSurfaceTriangles(), dtype=np.int64).reshape(-1, 3)
        inside = triangles[np.isin(triangles, nodes).all(axis=1)]
        areas = np.zeros(self.NumberOfNodes())
        np.add.at(areas, inside.ravel(), np.repeat(triangle_areas(self.GetNodePositionsAsArray(), inside) / 3.0, 3))
        if len(inside) == 0 or areas.sum() == 0:
            expected = "nodes that make up at least one triangle of the surface (VolumeToSurfaceElements makes it)"
            raise shape_error("FEMinterface.GetNodeWeightsFromSurfaceAreas: nodeList", expected, nodeList)
        return areas[nodes] / areas.sum() if normalizeWeights else areas[nodes]

    def GetBoundaryNodeSetsAsLists(self) -> list[list[Any]]:
        """[lists of nodes, lists of weights] of the node sets with type 'boundary', for Hurty-Craig-Bampton modes."""
        sets = [s for s in self.nodeSets if s.get("type") == "boundary" and "NodeNumbers" in s and "NodeWeights" in s]
        return [[s["NodeNumbers"] for s in sets], [s["NodeWeights"] for s in sets]]

    def AddBoundary(self, name: str, nodeNumbers: Sequence[int]) -> None:
        """Add a node set of type 'boundary', whose nodes are weighted by surface areas; a former one is replaced."""
        weights = self.GetNodeWeightsFromSurfaceAreas(nodeNumbers)
        self.nodeSets = [s for s in self.nodeSets if s.get("Name") != name]
        numbers = np.asarray(nodeNumbers, dtype=np.int64)
        self.nodeSets.append({"Name": name, "NodeNumbers": numbers, "NodeWeights": weights, "type": "boundary"})
