"""Meshes of mass points, and the data that ObjectFFRFreducedOrder requires: sums over the points."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = np.ndarray


def skew(v: Array) -> Array:
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def of_points(points: Array, masses: Array, modes: Array) -> dict[str, Any]:
    """Parameters for mass points in the body frame (n x 3) and modes (3 n x m)."""
    shapes = modes.reshape(len(points), 3, -1)
    count = shapes.shape[2]
    bodies = [
        (mass, skew(x), [skew(psi) for psi in shape.T]) for mass, x, shape in zip(masses, points, shapes, strict=True)
    ]
    return {
        "massMatrixReduced": np.einsum("p,pai,paj->ij", masses, shapes, shapes),
        "modeBasis": modes,
        "referencePositions": points.ravel(),
        "physicsMass": masses.sum(),
        "physicsCenterOfMass": masses @ points / masses.sum(),
        "physicsInertia": sum(-m * x @ x for m, x, _ in bodies),
        "mPhitTPsi": np.einsum("p,pai->ai", masses, shapes),
        "mXRefTildePsiTilde": np.hstack([sum(-m * x @ psi[i] for m, x, psi in bodies) for i in range(count)]),
        "mPsiTildePsiTilde": np.block(
            [[sum(-m * psi[i] @ psi[j] for m, _, psi in bodies) for j in range(count)] for i in range(count)]
        ),
    }
