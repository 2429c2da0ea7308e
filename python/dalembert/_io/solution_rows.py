"""A solution in memory, independent of the format of its file."""

from __future__ import annotations

from typing import Any

from dalembert._checks import FloatArray

# Contents of a row after the time, in the order of columnsExported, by the names of the functions that set it.
COLUMNS = (
    "ODE2Coordinates",
    "ODE2Coordinates_t",
    "ODE2Coordinates_tt",
    "ODE1Coordinates",
    "ODE1Coordinates_t",
    "AECoordinates",
    "DataCoordinates",
)


def solution_of(data: FloatArray, columns: list[int]) -> dict[str, Any]:
    """Return the rows as the dictionary that functions on solutions take."""
    return {"data": data, "columnsExported": columns, "nColumns": data.shape[1] - 1, "nRows": data.shape[0]}
