"""mbs.SaveVTU(): scenes as unstructured grids of VTK, for ParaView: a file per frame, and a list of them."""

from __future__ import annotations

import base64
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, IntArray
from dalembert._io.files import file_to_write, replacing
from dalembert._pictures import meshes

if TYPE_CHECKING:
    from dalembert._pictures.scene import Scene

LINE, TRIANGLE = 3, 5  # types of cells
KINDS = ("Node", "Object", "Marker", "Load", "Sensor", "Trace", "GeneralContact")


def SaveVTU(
    mbs: Any,
    fileName: str,
    solution: dict[str, Any] | None = None,
    framesPerSecond: float = 25,
    speed: float = 1.0,
) -> None:
    """Save the motion of a solution, or of the last simulation, as grids for ParaView.

    A `fileName` with the ending .pvd lists grids in the same folder, such as motion_0003.vtu, with the times of the
    solution; the ending .vtu writes one grid, of the visualization state. Cells have the kind (0: node, 1: object,
    ...) and the
    number of their items; points have the numbers of the color output (SC.visualizationSettings.contour), nan if
    undefined.
    """
    from dalembert._pictures.motion import Motion
    from dalembert._pictures.studio import Studio

    path = Path(file_to_write("SaveVTU: fileName", fileName, newFolder=True))
    if path.suffix not in (".pvd", ".vtu"):
        raise ValueError(f"SaveVTU: fileName: expected a name that ends with .pvd or .vtu, received '{fileName}'")
    path.parent.mkdir(parents=True, exist_ok=True)
    if path.suffix == ".vtu":
        _write(path, grid(Studio(mbs.GetSystemContainer(), [mbs]).scene()))
        return
    motion = Motion(mbs, "SaveVTU", solution, framesPerSecond, speed, None, (1024, 768))
    entries = []
    for number, scene in enumerate(motion.scenes):
        name = f"{path.stem}_{number:04d}.vtu"
        _write(path.with_name(name), grid(scene))
        entries.append(f'<DataSet timestep="{scene.time!r}" part="0" file={_quoted(name)}/>')
    _write(path, _file("Collection", "<Collection>\n" + "\n".join(entries) + "\n</Collection>"))


def grid(scene: Scene) -> str:
    """Return a scene as an unstructured grid."""
    points: list[FloatArray] = [np.zeros((0, 3))]
    values: list[FloatArray] = [np.zeros(0)]
    cells: list[IntArray] = []  # a table of points for each kind of cell and part
    owners: list[tuple[int, int, int, int]] = []  # how many cells of which type, kind and number of their item
    count = 0

    def add(corners: FloatArray, table: IntArray, kind: int, item: int, numbers: FloatArray | None) -> None:
        nonlocal count
        points.append(corners)
        values.append(np.full(len(corners), np.nan) if numbers is None else numbers)
        cells.append(np.asarray(table) + count)
        owner = scene.items[item] if item >= 0 else None
        which = (-1, -1) if owner is None else (KINDS.index(owner.kind), owner.number)
        owners.append((len(table), kind, *which))
        count += len(corners)

    whole = scene.unbound()
    for part in whole.instances:
        if len(part.mesh.triangles):
            corners = part.mesh.points @ part.matrix.T + part.place
            add(corners, part.mesh.triangles, TRIANGLE, part.item, part.values)
    ball = meshes.ball(8)
    for center, radius, _, item in whole.spheres:
        add(radius * ball.points + center, ball.triangles, TRIANGLE, item, None)
    for line, _, _, item in whole.lines:
        if len(line) > 1:
            add(line, np.stack([np.arange(len(line) - 1), np.arange(1, len(line))], 1), LINE, item, None)
    sizes = [np.full(table.shape[0], table.shape[1]) for table in cells]
    facts = np.repeat(np.array(owners, int).reshape(-1, 4), [o[0] for o in owners], axis=0)
    name = scene.value_name or "value"
    body = "\n".join(
        [
            f'<Piece NumberOfPoints="{count}" NumberOfCells="{len(facts)}">',
            "<Points>" + _array("Points", "Float64", np.concatenate(points), 3) + "</Points>",
            "<Cells>",
            _array("connectivity", "Int64", np.concatenate([np.zeros(0, int), *(table.ravel() for table in cells)])),
            _array("offsets", "Int64", np.cumsum(np.concatenate([np.zeros(0, int), *sizes]))),
            _array("types", "UInt8", facts[:, 1]),
            "</Cells>",
            "<PointData>" + _array(name, "Float64", np.concatenate(values)) + "</PointData>",
            "<CellData>" + _array("kind", "Int64", facts[:, 2]) + _array("item", "Int64", facts[:, 3]) + "</CellData>",
            "</Piece>",
        ]
    )
    return _file("UnstructuredGrid", f"<UnstructuredGrid>\n{body}\n</UnstructuredGrid>")


def _file(kind: str, body: str) -> str:
    return (
        f'<?xml version="1.0"?>\n<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian" header_type="UInt32">\n'
        f"{body}\n</VTKFile>\n"
    )


def _quoted(text: str) -> str:
    """Return a text as the value of an attribute."""
    from xml.sax.saxutils import quoteattr  # slow: it imports urllib and email

    return quoteattr(text)


def _array(name: str, kind: str, values: npt.ArrayLike, components: int = 1) -> str:
    """Return numbers in base64, behind the number of their bytes."""
    data = np.ascontiguousarray(values, {"Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}[kind]).tobytes()
    text = base64.b64encode(np.array([len(data)], "<u4").tobytes() + data).decode()
    return (
        f'<DataArray type="{kind}" Name={_quoted(name)} NumberOfComponents="{components}" format="binary">'
        f"{text}</DataArray>"
    )


def _write(path: Path, text: str) -> None:
    with replacing(path) as written:
        Path(written).write_text(text, "utf-8")
