"""How links of trees are drawn that come without graphics: a body from joint to joint, and the joints."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from dalembert import graphics
from dalembert._checks import FloatArray
from dalembert._geometry.inertia import TreeLink
from dalembert.create._interface import JointTypeToAxis
from dalembert.rigidBodyUtilities import ComputeOrthonormalBasis, HT2translation

Shapes = list[dict[str, Any]]


class Look(NamedTuple):
    """Radius and width of joints (m), roundness of links from 0 to 1, and the colour of each link and joint."""

    radius: float
    width: float
    roundness: float
    links: Sequence[Any]
    joints: Sequence[Any]


def _bar(look: Look, start: FloatArray, end: FloatArray, color: Any) -> dict[str, Any]:
    span = end - start
    if look.roundness >= 1:
        return graphics.Cylinder(pAxis=start, vAxis=span, radius=look.radius, color=color)
    size = [float(np.linalg.norm(span)) + 2 * look.radius, look.width, 2 * look.radius]
    block = graphics.Brick(size=size, color=color, roundness=look.roundness, nTiles=24)
    return graphics.Move(block, 0.5 * (start + end), ComputeOrthonormalBasis(span))


def link_shapes(links: Sequence[TreeLink], parents: Sequence[int], look: Look) -> tuple[list[Shapes], Shapes]:
    """Return the shapes of each link, and those of the base."""
    shapes: list[Shapes] = [list(link.graphicsDataList or []) for link in links]
    base: Shapes = []
    for i, (link, parent) in enumerate(zip(links, parents, strict=True)):
        axis, offset = JointTypeToAxis(link.jointType), HT2translation(link.jointHT)
        own = link.graphicsDataList is None
        if own:
            half = 0.5 * look.width * axis
            shapes[i].append(graphics.Cylinder(-half, 2 * half, look.radius, look.joints[i]))
        if own and i not in parents:  # the last of its branch: a stub across the axis
            across = look.width * np.roll(axis, 1)
            shapes[i].append(_bar(look, 0 * across, 2 * across, look.links[i]))
        if not np.any(offset):
            continue
        if parent < 0:
            base.append(_bar(look, 0 * offset, offset, graphics.color.defaultBody))
        elif links[parent].graphicsDataList is None:
            shapes[parent].append(_bar(look, 0 * offset, offset, look.links[parent]))
    return shapes, base
