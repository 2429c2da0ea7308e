"""Lines, circles and texts."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import as_color, as_points, as_vector, shape_error
from dalembert.graphics._mesh import GraphicsData

PIECES = 16  # straight lines of a curved segment


@checked
def Lines(pList: npt.ArrayLike, color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0], shape: str = "linear") -> GraphicsData:
    """Return a line through a list of 3D points.

    shape='quadratic': parabolas through start, middle and end of each segment; ends are the starts of the next ones.
    """
    points = as_points("Lines: pList", pList)
    if shape == "quadratic":
        if len(points) < 3 or len(points) % 2 == 0:
            raise shape_error(
                "Lines: pList", "an odd number of points, 3 or more: start, middle, end, ...", len(points)
            )
        s = np.linspace(0.0, 1.0, PIECES + 1)[1:, None]
        start, middle, end = points[:-2:2], points[1::2], points[2::2]
        arcs = [
            (1 - s) * (1 - 2 * s) * a + 4 * s * (1 - s) * b + s * (2 * s - 1) * c
            for a, b, c in zip(start, middle, end, strict=True)
        ]
        points = np.vstack([points[:1], *arcs])
    elif shape != "linear":
        raise shape_error("Lines: shape", "'linear' or 'quadratic'", shape)
    return {"type": "Line", "color": as_color("Lines: color", color).copy(), "data": points.flatten()}


@checked
def Circle(
    point: npt.ArrayLike = [0, 0, 0], radius: float = 1, color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0]
) -> GraphicsData:
    """Return a circle about a centre point in the xy plane."""
    position = as_vector("Circle: point", point, 3).copy()
    return {"type": "Circle", "color": as_color("Circle: color", color).copy(), "radius": radius, "position": position}


@checked
def Text(
    point: npt.ArrayLike = [0, 0, 0],
    text: str = "",
    color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0],
    fontSize: float = 0.0,
    offset: npt.ArrayLike = [0.0, 0.0],
) -> GraphicsData:
    """Return a text at a 3D point; fontSize 0 is the default size, offset shifts the text by parts of its size."""
    if not isinstance(text, str):
        raise shape_error("Text: text", "a string", text)
    return {
        "type": "Text",
        "color": as_color("Text: color", color).copy(),
        "text": text,
        "position": as_vector("Text: point", point, 3).copy(),
        "fontSize": fontSize,
        "offset": as_vector("Text: offset", offset, 2).tolist(),
    }
