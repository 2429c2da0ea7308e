"""Vector images, as the renderer exports them to text files: loading and plotting."""

from __future__ import annotations

import os
import warnings
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_array, shape_error
from dalembert._io.files import file_to_read, file_to_write, numbers_of, refuse_line, replacing
from dalembert._tools.user_interface import UIWindowSuppressed

Image = dict[str, list[Any]]

_HEADER, _END = "text image export file", "#END"
_SIZES = {"#COLOR": 4, "#LINE": 3, "#TRIANGLE": 9}  # how many numbers follow, or a multiple


def LoadImage(fileName: str, trianglesAsLines: bool = True, verbose: bool = False) -> Image:
    """Load a text image file, as written by the renderer in the image format 'TXT'.

    Returns a dictionary with 'linePoints' (per line the coordinates [x0, y0, z0, x1, ...]), 'lineColors' (per line
    (red, green, blue, alpha)) and 'triangles' (per triangle 9 coordinates and its colour). With `trianglesAsLines`,
    triangles become closed lines. `verbose` prints the numbers of lines, segments and triangles.
    """
    fileName = file_to_read("LoadImage: fileName", fileName)
    with open(fileName) as file:
        lines = [line.rstrip("\n") for line in file]
    if not lines:
        raise ValueError(f"LoadImage: file {fileName!r} is empty")
    if _HEADER not in lines[0]:
        warnings.warn(f"LoadImage: file {fileName!r} starts with {lines[0]!r}: not a text image", stacklevel=2)
    if lines[-1] != _END:
        warnings.warn(f"LoadImage: file {fileName!r} does not end with {_END!r}: it may be incomplete", stacklevel=2)

    image: Image = {"linePoints": [], "lineColors": [], "triangles": []}
    color: tuple[float, ...] = (0.0, 0.0, 0.0, 1.0)
    segments = triangles = 0
    content = iter(enumerate(lines[1:], 2))
    for number, tag in content:
        if tag not in _SIZES:
            continue  # comment
        number, line = next(content, (number + 1, ""))
        values = numbers_of(line.strip().rstrip(","), ",")
        if values is None or not values or len(values) % _SIZES[tag]:
            raise refuse_line(
                fileName, number, f"numbers separated by ',', {_SIZES[tag]} or a multiple, after {tag}", line
            )
        if tag == "#COLOR":
            color = tuple(values)
            continue
        closed = tag == "#TRIANGLE"
        triangles += closed
        if closed and not trianglesAsLines:
            image["triangles"].append((values, color))
            continue
        segments += 0 if closed else len(values) // 3 - 1
        image["linePoints"].append(values + values[:3] if closed else values)
        image["lineColors"].append(color)
    if verbose:
        print("number of lines:", len(image["linePoints"]))
        print("number of line segments:", segments)
        print("number of triangles:", triangles)
    return image


def _transformed(points: Any, transformation: FloatArray) -> FloatArray:
    """Return points (n x 3) from a flat list of coordinates, transformed by a homogeneous transformation (4x4)."""
    return np.reshape(points, (-1, 3)) @ transformation[:3, :3].T + transformation[:3, 3]


def _plot_flat(ax: Any, lines: list[FloatArray], image: Image, style: dict[str, Any], axesEqual: bool) -> None:
    from matplotlib.collections import LineCollection

    if lines:
        ax.add_collection(LineCollection([line[:, :2] for line in lines], colors=image["lineColors"], **style))
        if axesEqual:
            ax.set_aspect("equal", "box")
    if image["triangles"]:
        warnings.warn("PlotImage: triangles are left out; set plot3D=True to see them", stacklevel=3)


def _plot_spatial(
    ax: Any, lines: list[FloatArray], image: Image, transformation: FloatArray, style: dict[str, Any], edges: Any
) -> None:
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection  # type: ignore[import-untyped]

    triangles = [_transformed(points, transformation) for points, _ in image["triangles"]]
    if lines:
        ax.add_collection3d(Line3DCollection(lines, colors=image["lineColors"], **style))
    if triangles:
        faces = [color[:3] for _, color in image["triangles"]]
        ax.add_collection3d(Poly3DCollection(triangles, facecolors=faces, **edges))
    points = np.vstack(lines + triangles) if lines or triangles else np.zeros((1, 3))
    for axis, (low, high) in zip("xyz", zip(points.min(axis=0), points.max(axis=0), strict=True), strict=True):
        margin = 0.05 * (high - low) or 0.5
        getattr(ax, f"set_{axis}lim")(low - margin, high + margin)


def show_figure(plt: Any, figure: Any) -> None:
    """Show a figure where there are windows; do nothing where figures are just saved."""
    if UIWindowSuppressed("Plots"):
        return
    if plt.get_backend().lower() not in ("agg", "cairo", "pdf", "pgf", "ps", "svg", "template"):
        figure.show()


def save_figure(figure: Any, fileName: str, where: str) -> None:
    """Save a figure to a file, making its folder if needed; nothing for an empty name."""
    if fileName in ("", None):
        return
    fileName = file_to_write(f"{where}: fileName", fileName, newFolder=True)
    folder = os.path.dirname(fileName)
    if folder:
        os.makedirs(folder, exist_ok=True)
    known = figure.canvas.get_supported_filetypes()
    ending = os.path.splitext(fileName)[1].lstrip(".").lower()
    if not ending:
        fileName += f".{figure.canvas.get_default_filetype()}"
    elif ending not in known:
        raise shape_error(f"{where}: fileName", f"an ending of matplotlib, {', '.join(sorted(known))}", fileName)
    with replacing(fileName) as written:
        figure.savefig(written)


def PlotImage(
    imageData: Image,
    HT: npt.ArrayLike = np.eye(4),  # noqa: B008
    axesEqual: bool = True,
    plot3D: bool = False,
    lineWidths: float = 1,
    lineStyles: str = "-",
    triangleEdgeColors: Any = "black",
    triangleEdgeWidths: float = 0.5,
    removeAxes: bool = True,
    orthogonalProjection: bool = True,
    title: str = "",
    figureName: str = "",
    fileName: str = "",
    fontSize: float = 16,
    closeAll: bool = False,
    azim: float = 0.0,
    elev: float = 0.0,
) -> None:
    """Plot an image from LoadImage with matplotlib, as a view along z (2D) or as a 3D plot.

    `HT` is a homogeneous transformation (4x4) for all points; triangles are seen in 3D only. `axesEqual` keeps the
    proportions, `removeAxes` hides axes and background of a 3D plot, `orthogonalProjection` is without perspective;
    `azim` and `elev` are the angles of the view in degrees. A `fileName` (.pdf, .png, ...) saves the figure.
    """
    import matplotlib.pyplot as plt

    transformation = as_array("PlotImage: HT", HT, "a 4x4 matrix")
    if transformation.shape != (4, 4):
        raise shape_error("PlotImage: HT", "a 4x4 matrix", HT)
    if closeAll:
        plt.close("all")
    plt.rcParams.update({"font.size": fontSize})
    if figureName and plt.fignum_exists(figureName):
        plt.close(figureName)
    figure = plt.figure(figureName or None)

    lines = [_transformed(points, transformation) for points in imageData["linePoints"]]
    style = {"linewidths": lineWidths, "linestyles": lineStyles}
    ax: Any
    if plot3D:
        ax = figure.add_subplot(projection="3d")
        edges = {"edgecolors": triangleEdgeColors if triangleEdgeWidths else "none", "linewidths": triangleEdgeWidths}
        _plot_spatial(ax, lines, imageData, transformation, style, edges)
        ax.view_init(elev=elev, azim=azim)
        if removeAxes:
            ax.set_axis_off()
        if orthogonalProjection:
            ax.set_proj_type("ortho")
        if axesEqual:
            ax.set_aspect("equal")
    else:
        ax = figure.add_subplot()
        _plot_flat(ax, lines, imageData, style, axesEqual)
        ax.autoscale()
    if title:
        ax.set_title(title)
    figure.tight_layout()
    show_figure(plt, figure)
    save_figure(figure, fileName, "PlotImage")
