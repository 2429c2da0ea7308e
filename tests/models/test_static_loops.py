"""Static solutions of closed loops whose iterations go to where no joints fit."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Variable, new_system

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

STIFFNESS = 30.0  # N m / rad, of springs that hold the joints


def soft_loop(node: Any, frees_three: bool) -> tuple[Any, Any]:
    """Three bars whose weight turns them far; the last joint states three equations that follow from others, or is free of them."""
    random = np.random.default_rng(3)
    angles, radii = np.sort(random.uniform(0, 2 * np.pi, 4)) + 0.3 * np.arange(4), random.uniform(0.6, 1.4, 4)
    corners = [np.array([r * np.cos(a), r * np.sin(a), 0]) for a, r in zip(angles, radii, strict=True)]
    mbs = new_system()
    bodies = [mbs.CreateGround()]
    for start, end in zip(corners[:-1], corners[1:], strict=True):
        length = float(np.linalg.norm(end - start))
        along = (end - start) / length
        body = mbs.CreateRigidBody(
            referencePosition=(start + end) / 2,
            referenceRotationMatrix=np.column_stack([along, np.cross([0, 0, 1], along), [0, 0, 1]]),
            inertia=InertiaCuboid(1000, [length, 0.1, 0.05]),
            gravity=[3, -9.81, 0],
            nodeType=node,
        )
        mbs.CreateGenericJoint(bodyNumbers=[body, bodies[-1]], position=start, constrainedAxes=[1, 1, 1, 1, 1, 0])
        mbs.CreateTorsionalSpringDamper(
            bodyNumbers=[bodies[-1], body], position=start, axis=[0, 0, 1], stiffness=STIFFNESS
        )
        bodies.append(body)
    axes = [1, 1, 0, 0, 0, 0] if frees_three else [1, 1, 1, 1, 1, 0]
    mbs.CreateGenericJoint(bodyNumbers=[bodies[-1], bodies[0]], position=corners[-1], constrainedAxes=axes)
    mbs.Assemble()
    return mbs, bodies[2]


@pytest.mark.parametrize("frees_three", [False, True], ids=["redundant", "regular"])
@pytest.mark.parametrize(
    "node", [exu.NodeType.RotationRotationVector, exu.NodeType.RotationRxyz, exu.NodeType.RotationEulerParameters]
)
def test_a_soft_loop_turns_far_in_one_load_step(node: Any, frees_three: bool) -> None:
    """Where iterations of the full load go astray, smaller steps follow: joints that fitted before were said to contradict each other.

    All arrive where a hundred steps with Euler parameters do.
    """
    mbs, coupler = soft_loop(node, frees_three)
    s = exu.SimulationSettings()
    s.staticSolver.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    assert mbs.SolveStatic(s) is True
    place = mbs.GetObjectOutputBody(coupler, Variable.Position, [0.1, 0, 0])
    np.testing.assert_allclose(place, [0.58405, -0.90024, 0], rtol=0, atol=1e-5)
