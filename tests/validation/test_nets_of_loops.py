"""Plane linkages in space whose loops all hang together: blocks of hundreds of equations, eliminated node by node."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import new_system, settings
from test_redundant import NODES, assert_smallest, redundancy

from dalembert._core import testing
from dalembert.rigidBodyUtilities import InertiaCuboid


class Net:
    """Links that stand on the ground, with bars from each to the next and from some to any other, turned anyhow in space."""

    def __init__(self, random: np.random.Generator, links: int, more: int, node: Any) -> None:
        self.mbs, self.random, self.node = new_system(), random, node
        self.turn = Rotation.random(random_state=random).as_matrix()
        ground = self.mbs.CreateGround()
        feet = [np.array([i, 0, 0]) + random.uniform(-0.2, 0.2, 3) * [1, 1, 0] for i in range(links)]
        heads = [foot + [random.uniform(-0.3, 0.3), random.uniform(0.7, 1.3), 0] for foot in feet]
        bodies = [self.bar(foot, head) for foot, head in zip(feet, heads, strict=True)]
        for foot, body in zip(feet, bodies, strict=True):
            self.hinge(ground, body, foot)
        pairs = [(i, i + 1) for i in range(links - 1)]
        pairs += [tuple(random.choice(links, 2, replace=False)) for _ in range(more)]
        for pair in pairs:
            bar = self.bar(heads[pair[0]], heads[pair[1]])
            for i in pair:
                self.hinge(bodies[i], bar, heads[i])
        self.mbs.Assemble()

    def bar(self, start: np.ndarray, end: np.ndarray) -> Any:
        length = float(np.linalg.norm(end - start))
        along = (end - start) / length
        return self.mbs.CreateRigidBody(
            referencePosition=self.turn @ (start + end) / 2,
            referenceRotationMatrix=self.turn @ np.column_stack([along, np.cross([0, 0, 1], along), [0, 0, 1]]),
            inertia=InertiaCuboid(self.random.uniform(500, 5000), [length, 0.1, 0.05]),
            gravity=[0, 0, -9.81],
            nodeType=self.node,
        )

    def hinge(self, one: Any, other: Any, place: np.ndarray) -> None:
        self.mbs.CreateRevoluteJoint(bodyNumbers=[one, other], position=self.turn @ place, axis=self.turn[:, 2])

    def redundant_by_singular_values(self) -> int:
        state = testing.State(self.mbs)
        state.lam = np.zeros_like(state.lam)
        forces = testing.tangent(self.mbs, state)[: len(state.q), len(state.q) + len(state.y) :]
        sizes = np.linalg.svd(forces / np.linalg.norm(forces, axis=0))[1]
        return int(forces.shape[1] - np.count_nonzero(sizes > 1e-8 * sizes[0]))


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize(("links", "more"), [(14, 0), (19, 2), (17, 3)])
def test_what_is_redundant_and_smallest_reactions(links: int, more: int, node: Any) -> None:
    """Three equations of each loop at least, among 200 to 370 in one block."""
    for seed in range(2):
        net = Net(np.random.default_rng(seed), links, more, node)
        wanted = net.redundant_by_singular_values()
        assert wanted >= 3 * (links - 1 + more)
        assert net.mbs.ComputeSystemDegreeOfFreedom()["redundantConstraints"] == wanted
        s = settings(0.02, 10, tolerance=1e-12)
        s.redundantConstraints.momentLength = 1.0
        assert net.mbs.SolveDynamic(s) is True
        assert redundancy(net.mbs)["count"] == wanted
        assert_smallest(net.mbs, 1.0)
