"""Constraint forces at rest, and limits of linearizations about the initial state."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np

from dalembert._checks import FloatArray
from dalembert._core import testing
from dalembert._solving.coordinate_parts import CoordinateParts

_BALANCED = 1e-5  # forces that constraints do not balance, relative to all others
_ROUND_OFF = 1e3 * np.finfo(float).eps
_TURNS = 1e-5  # rad/s, above the residual velocities of bodies at rest
_PRELOAD = 1e-3  # share of forces that constraints carry


def _dense(entries: Any, size: int) -> FloatArray:
    matrix = np.zeros((size, size))
    rows, columns, values = entries
    np.add.at(matrix, (rows, columns), values)
    return matrix


def stiffness_of_reactions(function: str, mbs: Any, state: Any) -> FloatArray | None:
    """Return the contribution of constraint forces to the stiffness matrix at rest; None without such forces.

    They are known if constraints balance all other forces. Otherwise, a warning names the function to call.
    """
    n, at_rest = len(state.q), state.copy()
    if len(state.lam) == 0:
        return None
    at_rest.v, at_rest.lam = np.zeros(n), np.zeros(len(state.lam))
    first, size = n + len(state.y), n + len(state.y) + len(state.lam)
    saddle = _dense(testing.tangent_entries(mbs, at_rest), size)
    residual = np.asarray(testing.residual(mbs, at_rest))[:n]
    magnitudes = np.maximum(np.abs(mbs.systemData.GetODE2CoordinatesTotal()), testing.extent(mbs))
    if np.linalg.norm(residual) <= _ROUND_OFF * np.linalg.norm(np.abs(saddle[:n, :n]) @ magnitudes):
        return None
    forces = saddle[:n, first:]
    lengths = np.linalg.norm(forces, axis=0)
    forces = forces / np.where(lengths > 0, lengths, 1.0)
    scaled = np.linalg.lstsq(forces, -residual, rcond=1e-10)[0]
    rest = residual + forces @ scaled
    if np.linalg.norm(rest) > _BALANCED * np.linalg.norm(residual):
        if np.linalg.norm(forces @ scaled) > _PRELOAD * np.linalg.norm(residual):
            warnings.warn(
                f"{function}: the initial state is no equilibrium: forces of constraints, which add to the stiffness, "
                "are left out. Call mbs.SolveStatic(updateInitialValues=True) first, or mbs.ComputeVibrationModes(), "
                "which finds the equilibrium",
                stacklevel=4,
            )
        return None
    at_rest.lam = scaled / np.where(lengths > 0, lengths, 1.0)
    return _dense(testing.tangent_entries(mbs, at_rest), size)[:n, :n] - saddle[:n, :n]


def warn_of_turning(function: str, mbs: Any, state: Any) -> None:
    """Warn of bodies that turn initially: the linearized system is then that of no steady state."""
    turning = CoordinateParts(mbs, state).turning
    moving = turning[np.abs(np.asarray(state.v)[turning]) > _TURNS]
    if len(moving):
        warnings.warn(
            f"{function}: bodies turn in the initial state ({testing.describe_row(mbs, int(moving[0]))}): the "
            "linearized system depends on rotation parameters and has no gyroscopic modes. Call "
            "mbs.ComputeVibrationModes(angularVelocity=...), with the model at rest in the rotating frame",
            stacklevel=4,
        )
