"""Floor below all that is drawn: a grid with round numbers, as the viewer has it (page/floor.js), without shadows."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from dalembert._checks import FloatArray
from dalembert._pictures.meshes import Rgba

CELLS = 20  # of the grid, in each direction
GREY, OPACITY = 0.53, 0.25  # of its lines; pictures have no transparent ones, so that the color is mixed
STEPS = np.array([1.0, 2.0, 5.0, 10.0])


def lines(
    box: FloatArray | None, up: int, background: Sequence[float] = (1.0, 1.0, 1.0)
) -> list[tuple[FloatArray, Rgba, float, int]]:
    """Return the lines of the grid below a box; `up` is the axis that points upwards."""
    if box is None:
        return []
    size, (i, j) = box[1] - box[0], ((up + 1) % 3, (up + 2) % 3)
    wide = max(size[i], size[j], 0.5 * size[up])
    if not wide > 0:
        return []  # all is at one point
    power = 10 ** np.floor(np.log10(wide / 8))
    cell = power * STEPS[np.searchsorted(STEPS, wide / 8 / power * (1 - 1e-12))]
    middle = cell * np.floor(0.5 * (box[0] + box[1]) / cell + 0.5)
    middle[up] = cell * np.floor((box[0, up] - 1e-6 * wide) / cell)
    red, green, blue = (OPACITY * GREY + (1 - OPACITY) * float(part) for part in background[:3])
    half, result = 0.5 * CELLS * cell, []
    for along, across in ((i, j), (j, i)):
        for place in np.linspace(-half, half, CELLS + 1):
            ends = np.tile(middle, (2, 1))
            ends[:, along] += [-half, half]
            ends[:, across] += place
            result.append((ends, (red, green, blue, 1.0), 1.0, -1))
    return result
