"""Packings stay in the box and do not overlap."""

import numpy as np
import pytest
from scipy.spatial.distance import pdist

from dalembert.particles import CreateParticlesInBox


def test_packing_is_dense_without_overlap_and_centred():
    lower, upper = np.array([0.0, 1, 2]), np.array([2.0, 3.1, 4.2])
    particles = CreateParticlesInBox(lower, upper, 0.1)
    points = np.array([p for p, _ in particles])
    assert pdist(points).min() == pytest.approx(0.2)
    assert (points >= lower + 0.1 - 1e-12).all()
    assert (points <= upper - 0.1 + 1e-12).all()
    np.testing.assert_allclose(points.min(0) - lower, upper - points.max(0), atol=1e-12)
    fraction = len(points) * 4 / 3 * np.pi * 1e-3 / np.prod(upper - lower)
    assert 0.55 < fraction < np.pi / np.sqrt(18)


def test_random_radii_and_limits():
    particles = CreateParticlesInBox([0, 0, 0], [2, 2, 2], 0.1, 0.2, maxNumberOfParticles=20, offsetRadius=0.05)
    radii = [r for _, r in particles]
    assert len(radii) == 20
    assert 0.1 <= min(radii) < max(radii) <= 0.2
    assert pdist(np.array([p for p, _ in particles])).min() == pytest.approx(0.5)
    with pytest.raises(ValueError, match="no sphere of radius 3 fits in a box of size"):
        CreateParticlesInBox([0, 0, 0], [1, 1, 1], 3)
    with pytest.raises(ValueError, match="0 < minRadius <= maxRadius"):
        CreateParticlesInBox([0, 0, 0], [1, 1, 1], 0.2, 0.1)
