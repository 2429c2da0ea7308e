"""Triangle meshes from and to files: STL (text and binary), PyMeshLab formats, NGsolve meshes."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import FloatArray, as_array, as_color, as_matrix, as_vector
from dalembert._io.files import file_to_read, file_to_write, replacing
from dalembert.graphics._mesh import GraphicsData, mesh_of, triangle_list, triangle_normals
from dalembert.graphics._operations import FromPointsAndTrigs, _normalized
from dalembert.graphics._outlines import Compute6NodeTrigsNormals

_SAME_POINT = 1e-6  # relative to the size of a surface
_BINARY_FACET = np.dtype([("normal", "<f4", 3), ("points", "<f4", (3, 3)), ("attribute", "<u2")])
_FACET_LINES = ("facet normal", "outer loop", "vertex", "vertex", "vertex", "endloop", "endfacet")


def _facets_from_text(text: str, fileName: str) -> tuple[FloatArray, FloatArray]:
    """Return normals (n,3) and corner points (n,3,3) of the facets of a text STL file."""
    lines = [(number, line.split()) for number, line in enumerate(text.splitlines(), start=1) if line.strip()]
    if not lines or lines[0][1][0] != "solid":
        raise ValueError(f"{fileName}, line 1: expected 'solid name', received '{text[:40]}'")
    values: list[list[float]] = []
    position = 0  # within the lines of a facet
    for number, words in lines[1:]:
        if position == 0 and words[0] in ("endsolid", "solid"):  # a file may contain several solids
            continue
        keys = _FACET_LINES[position].split()
        nValues = 3 if keys[0] in ("facet", "vertex") else 0
        try:
            if words[: len(keys)] != keys or len(words) != len(keys) + nValues:
                raise ValueError
            if nValues:
                values.append([float(word) for word in words[len(keys) :]])
        except ValueError:
            expected = " ".join(keys) + (" x y z" if nValues else "")
            raise ValueError(
                f"{fileName}, line {number}: expected '{expected}', received '{' '.join(words)}'"
            ) from None
        position = (position + 1) % len(_FACET_LINES)
    if position != 0:
        raise ValueError(f"{fileName}: the file ends within a facet, '{_FACET_LINES[position]}' is missing")
    facets = np.array(values).reshape(-1, 4, 3)
    return facets[:, 0], facets[:, 1:]


def _read_facets(fileName: str) -> tuple[FloatArray, FloatArray]:
    """Return normals and corner points of a binary or text STL file."""
    with open(file_to_read("FromSTLfile: fileName", fileName), "rb") as file:
        content = file.read()
    if len(content) >= 84:
        nFacets = int.from_bytes(content[80:84], "little")
        if len(content) == 84 + nFacets * _BINARY_FACET.itemsize:
            facets = np.frombuffer(content, _BINARY_FACET, offset=84)
            return facets["normal"].astype(float), facets["points"].astype(float)
    if content.lstrip()[:5] != b"solid":
        raise ValueError(f"{fileName}: neither a text STL file nor a binary one with a matching number of facets")
    return _facets_from_text(content.decode("utf-8", errors="replace").lstrip(), fileName)


@checked
def FromSTLfileASCII(
    fileName: str,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    verbose: bool = False,
    invertNormals: bool = True,
    invertTriangles: bool = True,
) -> GraphicsData:
    """Return a TriangleList from a text STL file, with the normals of the file.

    Normals and orientation of the triangles are inverted by default. Errors name the line of the file.
    """
    fileName = file_to_read("FromSTLfileASCII: fileName", fileName)
    with open(fileName) as file:
        normals, corners = _facets_from_text(file.read(), fileName)
    if verbose:
        print(f"FromSTLfileASCII: {fileName}: {len(normals)} triangles")
    order = [0, 2, 1] if invertTriangles else [0, 1, 2]
    triangles = np.arange(3 * len(normals)).reshape(-1, 3)[:, order]
    pointNormals = np.repeat(-normals if invertNormals else normals, 3, axis=0)
    return triangle_list("FromSTLfileASCII", corners.reshape(-1, 3), triangles, color, pointNormals)


def _faults(corners: FloatArray) -> str:
    """Return the faults of a surface that should enclose a volume; its edges must occur in pairs, in both
    directions."""
    size = np.ptp(corners.reshape(-1, 3), axis=0).max(initial=0.0)
    if size == 0.0:
        return ""
    rounded = np.round(corners.reshape(-1, 3) / (_SAME_POINT * size)).astype(np.int64)
    number = np.unique(rounded, axis=0, return_inverse=True)[1].reshape(-1, 3)
    edges = np.stack([number, np.roll(number, -1, axis=1)], axis=-1).reshape(-1, 2)
    edges = edges[edges[:, 0] != edges[:, 1]]
    pairs, inverse = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    forward = np.where(edges[:, 0] < edges[:, 1], 1, -1)
    balance = np.bincount(inverse.ravel(), forward, len(pairs))
    count = np.bincount(inverse.ravel(), minlength=len(pairs))
    if is_open := int((count % 2 == 1).sum()):
        return f"the surface is open at {is_open} edges"
    if turned := int((balance != 0).sum()):
        return f"triangles at {turned} edges are turned against each other"
    return ""


def _mass_properties(corners: FloatArray, density: float) -> dict[str, Any]:
    """Return volume, mass, centre of mass and inertia about it, of the tetrahedra from the origin to the triangles.

    Surfaces whose triangles are turned inward enclose the same volume.
    """
    volumes = np.linalg.det(corners) / 6.0
    volume = volumes.sum()
    if volume < 0.0:
        volume, volumes = -volume, -volumes
    if volume == 0.0:
        raise ValueError("FromSTLfile: the surface encloses no volume, so density gives no mass")
    sums = corners.sum(axis=1)
    com = volumes @ sums / (4.0 * volume)
    second = np.einsum("t,ti,tj->ij", volumes, sums, sums) + np.einsum("t,tci,tcj->ij", volumes, corners, corners)
    second = second / 20.0 - volume * np.outer(com, com)
    inertia = density * (np.trace(second) * np.eye(3) - second)
    return {"volume": volume, "mass": density * volume, "COM": com, "inertia": inertia}


@checked
def FromSTLfile(
    fileName: str,
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    verbose: bool = False,
    density: float = 0.0,
    scale: float = 1.0,
    Aoff: npt.ArrayLike = [],
    pOff: npt.ArrayLike = [],
    invertNormals: bool = True,
    invertTriangles: bool = True,
) -> GraphicsData | list[dict[str, Any]]:
    """Return a TriangleList from a text or binary STL file, scaled, then rotated by Aoff and shifted by pOff.

    If a density is given, the result is [graphicsData, properties] with minPos, maxPos, volume, mass, COM and the
    inertia
    about COM. A warning reports a surface that is open or whose triangles are turned against each other. Unit normals
    are computed from the triangles; the default inverts normals and triangles.
    """
    corners = scale * _read_facets(fileName)[1]
    turned, moved = as_array("FromSTLfile: Aoff", Aoff), as_array("FromSTLfile: pOff", pOff)
    if turned.size or moved.size:
        A = as_matrix("FromSTLfile: Aoff", Aoff, (3, 3)) if turned.size else np.eye(3)
        r = as_vector("FromSTLfile: pOff", pOff, 3) if moved.size else np.zeros(3)
        corners = r + corners @ A.T
    points = corners.reshape(-1, 3)
    index = np.arange(len(points))
    normals = np.repeat(triangle_normals(points, index.reshape(-1, 3)), 3, axis=0)
    order = index[::-1] if invertTriangles else index
    graphicsData = triangle_list("FromSTLfile", points, order, color, -normals if invertNormals else normals)
    lower, upper = points.min(axis=0), points.max(axis=0)
    properties: dict[str, Any] = {"minPos": lower, "maxPos": upper}
    if density != 0:
        if fault := _faults(corners):
            warnings.warn(f"FromSTLfile: {fileName}: {fault}: mass and inertia may be wrong", stacklevel=3)
        properties |= _mass_properties(corners, density)
    if verbose:
        print(f"FromSTLfile: {fileName}: {len(points)} points")
        for key, value in properties.items():
            print(f"  {key} = {value}")
    return [graphicsData, properties] if density != 0 else graphicsData


@checked
def FromPyMeshlabFile(
    fileName: str,
    defaultColor: npt.ArrayLike = [0.4, 0.4, 0.9, 1],
    invertNormals: bool = False,
    invertTriangles: bool = False,
    normalizeNormals: bool = True,
    useDefaultColor: bool = False,
    verbose: bool = False,
) -> GraphicsData:
    """Return a TriangleList from any file that PyMeshLab loads (.obj, .dae, .stl); needs the package pymeshlab.

    Colours of faces, if there are any, are given to their points unless useDefaultColor is set.
    """
    try:
        import pymeshlab
    except ImportError:
        raise ImportError("FromPyMeshlabFile: the package pymeshlab is needed: pip install pymeshlab") from None
    fileName = file_to_read("FromPyMeshlabFile: fileName", fileName)
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(fileName)
    mesh = meshes.current_mesh()
    points, triangles = mesh.vertex_matrix(), mesh.face_matrix()
    normals = mesh.vertex_normal_matrix()
    if verbose:
        print(f"FromPyMeshlabFile: {fileName}: {len(points)} points, {len(triangles)} triangles")
    if normalizeNormals:
        normals = _normalized(normals, "FromPyMeshlabFile")
    colors = np.tile(as_color("FromPyMeshlabFile: defaultColor", defaultColor), (len(points), 1))
    if mesh.has_face_color() and not useDefaultColor:
        colors = np.zeros_like(colors)
        colors[triangles.ravel()] = np.repeat(mesh.face_color_matrix(), 3, axis=0)
    order = [0, 2, 1] if invertTriangles else [0, 1, 2]
    return FromPointsAndTrigs(points, triangles[:, order], colors, -normals if invertNormals else normals)


@checked
def NGsolveMesh2PointsAndTrigs(
    mesh: Any = None,
    ngMesh: Any = None,
    meshOrder: int = 2,
    scale: float = 1,
    addNormals: bool = True,
    verbose: bool = False,
) -> list[npt.NDArray[Any]]:
    """Return [points, triangles], or [points, triangles, normals], of the surface of an NGsolve or netgen mesh.

    Either mesh or ngMesh is given. meshOrder=2 makes the mesh quadratic (in place), and each surface element gives 4
    triangles; if normals are
    requested, triangles do not share points.
    """
    if (mesh is None) == (ngMesh is None):
        raise ValueError("NGsolveMesh2PointsAndTrigs: expected either mesh or ngMesh, received both or none")
    netgenMesh = mesh.ngmesh if ngMesh is None else ngMesh
    if meshOrder == 2:
        netgenMesh.SecondOrder()
    points = np.array([list(point) for point in netgenMesh.Points()], dtype=float)
    elements = list(netgenMesh.Elements2D())
    nNodes = 6 if meshOrder == 2 else 3
    corners = [[v.nr - 1 for v in (el.points if meshOrder == 2 else el.vertices)] for el in elements]
    if any(len(element) != nNodes for element in corners):
        raise ValueError(f"NGsolveMesh2PointsAndTrigs: expected surface elements with {nNodes} nodes only")
    nodes = np.array(corners, dtype=int).reshape(-1, nNodes)
    parts = np.array([[0, 5, 4], [5, 1, 3], [5, 3, 4], [4, 3, 2]] if meshOrder == 2 else [[0, 1, 2]])
    triangles = nodes[:, parts].reshape(-1, 3)
    if verbose:
        print(f"NGsolveMesh2PointsAndTrigs: {len(points)} points, {len(elements)} surface elements")
    if not addNormals:
        return [scale * points, triangles]
    if meshOrder == 2:
        nodal = np.array([Compute6NodeTrigsNormals(points[element]) for element in nodes]).reshape(-1, 6, 3)
        normals = nodal[:, parts].reshape(-1, 3)
    else:
        normals = np.repeat(triangle_normals(points, triangles), 3, axis=0)
    return [scale * points[triangles.ravel()], np.arange(triangles.size).reshape(-1, 3), normals]


@checked
def ExportSTL(
    graphicsData: GraphicsData,
    fileName: str,
    solidName: str = "ExudynSolid",
    invertNormals: bool = True,
    invertTriangles: bool = True,
) -> None:
    """Write a TriangleList to a text STL file, by default with inverted normals and orientation of the triangles."""
    points, triangles = mesh_of("ExportSTL", graphicsData)
    fileName = file_to_write("ExportSTL: fileName", fileName)
    normals = (-1.0 if invertNormals else 1.0) * triangle_normals(points, triangles) + 0.0  # no negative zeros
    corners = points[triangles[:, [0, 2, 1] if invertTriangles else [0, 1, 2]]]
    lines = [f"solid {solidName}"]
    for normal, facet in zip(normals.tolist(), corners.tolist(), strict=True):
        lines += ["facet normal {!r} {!r} {!r}".format(*normal), "outer loop"]
        lines += ["vertex {!r} {!r} {!r}".format(*corner) for corner in facet]
        lines += ["endloop", "endfacet"]
    with replacing(fileName) as written, open(written, "w") as file:
        file.write("\n".join([*lines, f"endsolid {solidName}", ""]))
