"""Curves of values over time."""

from __future__ import annotations

from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._tools.sensor_facts import component_name

COLORS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")  # of Okabe and Ito


def plot_curves(ax: Any, time: FloatArray, values: FloatArray, name: str, variable: str, unit: str) -> Any:
    """Plot each component over time, with names and unit; return the axes, which are new ones if ax is None."""
    if ax is None:
        ax = new_axes()
    columns = np.reshape(values, (len(time), -1))
    for i in range(columns.shape[1]):
        component = f" {component_name(variable, i, columns.shape[1])}" if columns.shape[1] > 1 else ""
        ax.plot(time, columns[:, i], label=f"{name}{component}")
    ax.set_xlabel("time (s)")
    ax.set_ylabel(f"{variable} ({unit})" if unit else variable)
    ax.legend(frameon=False)
    return ax


def new_axes() -> Any:
    """Return axes without a frame, with a light grid and colors that are distinct for color-blind readers."""
    from matplotlib import pyplot

    ax = pyplot.subplots(layout="constrained")[1]
    ax.set_prop_cycle(color=COLORS)
    ax.spines[["top", "right"]].set_visible(False)
    ax.grid(True, color="0.9")
    ax.set_axisbelow(True)
    ax.margins(x=0)
    return ax
