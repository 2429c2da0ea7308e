"""Dense packings of spheres."""

from __future__ import annotations

from math import sqrt

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, as_vector, shape_error


def CreateParticlesInBox(
    minPointBox: npt.ArrayLike,
    maxPointBox: npt.ArrayLike,
    minRadius: float,
    maxRadius: float | None = None,
    maxNumberOfParticles: int | None = None,
    offsetRadius: float = 0,
    verbose: int = 0,
) -> list[tuple[FloatArray, float]]:
    """Return (point, radius) of spheres in a hexagonal closest packing, centred in a box between two corners.

    Radii are uniformly random (numpy.random) in [minRadius, maxRadius]; the packing is that of spheres with the
    radius maxRadius + offsetRadius. Layers are filled from below, up to maxNumberOfParticles. Raises ValueError if
    not a single sphere fits.
    """
    largest = minRadius if maxRadius is None else maxRadius
    if not 0 < minRadius <= largest:
        received = [minRadius, largest]
        raise shape_error("CreateParticlesInBox: minRadius, maxRadius", "0 < minRadius <= maxRadius", received)
    r = largest + offsetRadius
    lower = as_vector("CreateParticlesInBox: minPointBox", minPointBox, 3)
    size = as_vector("CreateParticlesInBox: maxPointBox", maxPointBox, 3) - lower
    spacing = r * np.array([2.0, sqrt(3.0), sqrt(8.0 / 3.0)])
    shift = r * np.array([1.0, 1.0 / sqrt(3.0), 0.0])  # shift of every second row (x) and layer (y)
    counts = np.floor((size - 2 * r - shift) / spacing).astype(int) + 1
    if counts.min() < 1:
        raise ValueError(f"CreateParticlesInBox: no sphere of radius {r} fits in a box of size {size.tolist()}")
    needed = (counts - 1) * spacing + shift + 2 * r
    origin = lower + 0.5 * (size - needed) + r
    k, j, i = (index.ravel() for index in np.indices(counts[::-1].tolist()))
    points = origin + np.column_stack([i, j, k]) * spacing
    points[:, 0] += shift[0] * ((j + k) % 2)
    points[:, 1] += shift[1] * (k % 2)
    points = points[:maxNumberOfParticles]
    radii = np.random.uniform(minRadius, largest, len(points))
    if verbose:
        print(f"CreateParticlesInBox: {len(points)} of {counts.prod()} particles, {counts} in x, y, z direction")
    return list(zip(points, radii.tolist(), strict=True))
