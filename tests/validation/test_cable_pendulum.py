"""A cable that is pinned at one end falls from the horizontal: extensible, with some bending stiffness, no rotary inertia."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Variable, new_system, settings

import dalembert as exu

# E A = 1e4, E I = 0.5, L = 1, rho A = 1, g = 9.81, by splines of degree 7 and 8: tip and middle; uncertain by 3e-6.
PLACES = {
    0.25: ((0.910198, -0.363239), (0.420632, -0.264593)),
    0.5: ((-0.105420, -0.994942), None),
    1.0: ((-0.992574, 0.042070), (-0.497870, -0.029574)),
}


def fall(elements: int, steps: int, in_space: bool, end: float) -> list[np.ndarray]:
    mbs, length = new_system(), 1 / elements
    node = exu.NodePointSlope1 if in_space else exu.NodePoint2DSlope1
    cable: Any = exu.ObjectANCFCable if in_space else exu.ObjectANCFCable2D
    zero = [0.0] * in_space
    nodes = [mbs.AddNode(node(referenceCoordinates=[i * length, 0, *zero, 1, 0, *zero])) for i in range(elements + 1)]
    for i in range(elements):
        body = mbs.AddObject(
            cable(
                physicsLength=length, physicsMassPerLength=1, physicsBendingStiffness=0.5, physicsAxialStiffness=1e4,
                nodeNumbers=nodes[i : i + 2],
            )
        )  # fmt: skip
        mass = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
        mbs.AddLoad(exu.LoadMassProportional(markerNumber=mass, loadVector=[0, -9.81, 0]))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    for c in range(3 if in_space else 2):
        held = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=c))
        mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[ground, held]))
    mbs.Assemble()
    mbs.SolveDynamic(settings(end, steps))
    return [np.array(mbs.GetNodeOutput(nodes[i], Variable.Position))[:2] for i in (elements, elements // 2)]


@pytest.mark.parametrize("in_space", [False, True])
@pytest.mark.parametrize("end", list(PLACES))
def test_falling_cable(end: float, in_space: bool) -> None:
    """Errors decrease with the square of the step, so that a third of the change by halving remains; half of this is
    allowed for elements, whose errors decrease with a higher power of their length."""
    coarse, fine = (fall(16, int(end * n), in_space, end) for n in (1000, 2000))
    for place, a, b in zip(PLACES[end], coarse, fine, strict=True):
        if place is not None:
            assert np.linalg.norm(a - b) < 1e-4
            assert b == pytest.approx(np.array(place), abs=3e-6 + np.linalg.norm(a - b) / 2)
