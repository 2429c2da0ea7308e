"""Models around every item, divided into regions that threads share: the equations are those of the undivided system."""

from __future__ import annotations

import numpy as np
import pytest

from dalembert._core import testing
from dalembert.testing.tangents import random_state
from dalembert.testing.variants import ALL_VARIANTS, Variant


@pytest.mark.parametrize("variant", ALL_VARIANTS, ids=lambda variant: variant.id)
def test_divided_systems_have_the_same_equations(variant: Variant) -> None:
    scene = variant.build(seed=7)
    s = random_state(scene, seed=8)

    def equations() -> list[np.ndarray]:
        return [
            testing.residual(scene.mbs, s),
            testing.tangent(scene.mbs, s, cq=0.7, cv=-1.3, ca=0.4, cy=1.1, cy_t=0.6),
            testing.forces(scene.mbs, s),
            testing.mass_matrix(scene.mbs, s),
        ]

    undivided = equations()
    assert testing.divide(scene.mbs, 1, threads=1) == 1
    alone = equations()
    regions = 4 if len(s.q) >= 4 else 2 if len(s.q) >= 2 else 1
    assert testing.divide(scene.mbs, 1, threads=3) == min(3, regions)
    for _ in range(3):
        for shared, by_one in zip(equations(), alone, strict=True):
            np.testing.assert_array_equal(shared, by_one)
    # Sums have another order.
    for divided, whole in zip(alone, undivided, strict=True):
        np.testing.assert_allclose(divided, whole, rtol=0, atol=1e-12 * max(1.0, np.abs(whole).max(initial=0)))
