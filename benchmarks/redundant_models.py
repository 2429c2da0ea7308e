"""Mechanisms with redundant constraints; with as many equations freed; and with as many of those left again."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

LEGS = 6


def _body(mbs: Any, place: Sequence[float], size: Sequence[float], turned: Any = None) -> Any:
    return mbs.CreateRigidBody(
        referencePosition=place,
        referenceRotationMatrix=np.eye(3) if turned is None else turned,
        inertia=InertiaCuboid(1000, size),
        gravity=[3, -9.81, 0],
    )


def ladder(loops: int, freed: int) -> Any:
    """Return a ladder of parallel four-bar linkages in a plane, in space, of bodies that turn about its normal.

    Each loop has three redundant equations, those that keep its bar in the plane.
    """
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    links = [_body(mbs, [i, 0.5, 0], [0.1, 1, 0.1]) for i in range(loops + 1)]
    bars = [_body(mbs, [i + 0.5, 1, 0], [1, 0.1, 0.1]) for i in range(loops)]

    def hinge(pair: list[Any], place: list[float], is_freed: bool = False) -> None:
        axes = [1, 1, 0, 0, 0, 0] if is_freed else [1, 1, 1, 1, 1, 0]
        mbs.CreateGenericJoint(bodyNumbers=pair, position=place, constrainedAxes=axes)

    for i, link in enumerate(links):
        hinge([ground, link], [i, 0, 0])
    for i, bar in enumerate(bars):
        hinge([links[i], bar], [i, 1, 0], is_freed=freed > 1)
        hinge([links[i + 1], bar], [i + 1, 1, 0], is_freed=freed > 0)
    mbs.Assemble()
    return mbs


def platform(freed: int) -> Any:
    """Return a platform on six legs that telescope, with two ball joints at the same place each: one is redundant.

    What is freed besides is one equation of each leg, about its axis.
    """
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    plate = _body(mbs, [0, 1, 0], [1, 0.1, 1])
    for i in range(LEGS):
        foot_angle, head_angle = (2 * np.pi * (i + shift * (-1) ** i) / LEGS for shift in (0.3, -0.2))
        foot = 1.5 * np.array([np.cos(foot_angle), 0, np.sin(foot_angle)])
        head = np.array([0.6 * np.cos(head_angle), 1, 0.6 * np.sin(head_angle)])
        length = float(np.linalg.norm(head - foot))
        along = (head - foot) / length
        side = np.cross([0, 1, 0], along) / np.linalg.norm(np.cross([0, 1, 0], along))
        turned = np.column_stack([along, side, np.cross(along, side)])
        lower, upper = (_body(mbs, foot + s * (head - foot), [length / 2, 0.05, 0.05], turned) for s in (0.25, 0.75))
        middle, join = (foot + head) / 2, mbs.CreateGenericJoint
        of_foot = [1, 1, 1, freed < 2, 0, 0]
        join(bodyNumbers=[lower, ground], position=foot, rotationMatrixAxes=turned, constrainedAxes=of_foot)
        join(bodyNumbers=[lower, upper], position=middle, constrainedAxes=[0, 1, 1, 1, 1, 1])
        for k in range(2):
            of_head = [*[k == 0 or freed == 0] * 3, 0, 0, 0]
            join(bodyNumbers=[upper, plate], position=head, constrainedAxes=of_head)
        places = {"localPosition0": foot, "localPosition1": head - [0, 1, 0]}
        mbs.CreateSpringDamper(bodyNumbers=[ground, plate], stiffness=2e4, damping=50, **places)
    mbs.Assemble()
    return mbs
