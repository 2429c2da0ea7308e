"""Curves of values over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._tools.sensor_facts import component_name


def plot_curves(ax: Any, time: FloatArray, values: FloatArray, name: str, variable: str, unit: str) -> Any:
    """Plot each component over time, with names and unit; return the axes, which are new ones if ax is None."""
    if ax is None:
        from matplotlib import pyplot

        ax = pyplot.subplots()[1]
    columns = np.reshape(values, (len(time), -1))
    for i in range(columns.shape[1]):
        component = f" {component_name(variable, i, columns.shape[1])}" if columns.shape[1] > 1 else ""
        ax.plot(time, columns[:, i], label=f"{name}{component}")
    ax.set_xlabel("time (s)")
    ax.set_ylabel(f"{variable} ({unit})" if unit else variable)
    ax.grid(True)
    ax.legend()
    return ax
