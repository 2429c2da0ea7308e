"""Lines, circles and texts."""

from __future__ import annotations

import numpy.typing as npt

from dalembert._calls import checked
from dalembert._checks import as_color, as_points, as_vector, shape_error
from dalembert.graphics._mesh import GraphicsData


@checked
def Lines(pList: npt.ArrayLike, color: npt.ArrayLike = [0.0, 0.0, 0.0, 1.0]) -> GraphicsData:
    """Return a line through a list of 3D points."""
    return {
        "type": "Line",
        "color": as_color("Lines: color", color).copy(),
        "data": as_points("Lines: pList", pList).flatten(),
    }


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
