"""Kinematic trees against closed forms, published values, other formulations, and what mechanics conserves."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from trees import Link, Tree, box_inertia, forward, in_python, make, random_links

import dalembert as exu
from dalembert._core import testing

Solver = exu.DynamicSolverType
G = 9.81


def solve(tree: Tree, end: float, steps: int, solver: Any = Solver.RK67) -> None:
    tree.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.endTime = end
    settings.timeIntegration.newton.relativeTolerance = 1e-11
    settings.timeIntegration.newton.absoluteTolerance = 1e-11
    settings.timeIntegration.generalizedAlpha.spectralRadius = 1
    settings.solutionSettings.writeSolutionToFile = False
    tree.mbs.SolveDynamic(settings, solverType=solver)


def state_of(tree: Tree) -> testing.State:
    tree.mbs.Assemble()
    return testing.State(tree.mbs)


# ---- equations ----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("seed", range(6))
def test_mass_matrix_and_forces_are_those_of_spatial_vectors(seed: int) -> None:
    links, rng = random_links(seed), np.random.default_rng(100 + seed)
    q, v, a = rng.uniform(-1, 1, (3, len(links)))
    gravity = [1.0, -2.0, 9.0]
    tree = make(links, q, v, gravity=gravity, baseOffset=[3, 4, 5])
    M, f = in_python(links, gravity).ComputeMassMatrixAndForceTerms(q, v)
    s = state_of(tree)
    assert testing.mass_matrix(tree.mbs, s) == pytest.approx(np.array(M), abs=1e-12)
    s.a = a
    assert testing.residual(tree.mbs, s) == pytest.approx(M @ a + f, abs=1e-11)


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("n", [2, 5, 40])
def test_forward_dynamics_are_the_inverse_of_inverse_dynamics(seed: int, n: int) -> None:
    links, rng = random_links(seed, n), np.random.default_rng(seed)
    q, v, torques = rng.uniform(-1, 1, (3, n))
    tree = make(links, q, v, gravity=[0, 0, -G], jointForceVector=torques)
    s = state_of(tree)
    a = forward(tree)
    s.a = a
    scale = np.abs(testing.mass_matrix(tree.mbs, s)).max() * np.abs(a).max() + 1
    assert testing.residual(tree.mbs, s) == pytest.approx(0, abs=1e-12 * scale)


def test_double_pendulum() -> None:
    """Two uniform rods; equations as in any textbook, with absolute angles."""
    m, length = 1.3, 0.8
    rod = {"mass": m, "com": [length / 2, 0, 0], "inertia": np.diag([0, 1, 1]) * m * length**2 / 12}
    links = [Link("Rz", **rod), Link("Rz", 0, offset=[length, 0, 0], **rod)]
    q, v = np.array([0.4, -1.1]), np.array([1.5, -2.5])
    tree = make(links, q, v, gravity=[0, -G, 0])
    first, second = q[0], q[0] + q[1]
    rates = np.array([v[0], v[0] + v[1]])
    coupling = m * length**2 / 2
    M = np.array(
        [
            [4 * m * length**2 / 3, coupling * np.cos(first - second)],
            [coupling * np.cos(first - second), m * length**2 / 3],
        ]
    )
    turning = coupling * np.sin(first - second) * np.array([-(rates[1] ** 2), rates[0] ** 2])
    weight = -m * G * length / 2 * np.array([3 * np.cos(first), np.cos(second)])
    absolute = np.linalg.solve(M, turning + weight)
    assert forward(tree) == pytest.approx([absolute[0], absolute[1] - absolute[0]], rel=1e-12)


def test_cart_with_pendulum() -> None:
    M, m, length, angle, rate, push = 2.0, 0.7, 1.2, 0.5, 1.7, 3.0  # the pendulum hangs at angle 0
    links = [Link("Px", mass=M), Link("Rz", 0, m, com=[0, -length, 0])]
    tree = make(links, [0.3, angle], [0.1, rate], gravity=[0, -G, 0], jointForceVector=[push, 0])
    s, c = np.sin(angle), np.cos(angle)
    cart = (push + m * s * (length * rate**2 + G * c)) / (M + m * s**2)
    swing = (-push * c - m * length * rate**2 * c * s - (M + m) * G * s) / (length * (M + m * s**2))
    assert forward(tree) == pytest.approx([cart, swing], rel=1e-12)


BRANCHED = [
    Link("Rz", -1, 5, [0, 0, 0.1], box_inertia(5, [0.4, 0.4, 0.2])),
    Link("Ry", 0, 2, [0.25, 0, 0], box_inertia(2, [0.5, 0.1, 0.1]), [0, 0, 0.2]),
    Link("Rx", 1, 1, [0.1, 0.2, 0], box_inertia(1, [0.1, 0.4, 0.1]), [0.5, 0.1, 0]),
    Link("Ry", 2, 0.7, [0, 0.05, -0.15], box_inertia(0.7, [0.1, 0.1, 0.3]), [0, 0.4, 0]),
    Link("Px", 1, 0.9, [0.05, -0.1, 0], box_inertia(0.9, [0.2, 0.2, 0.1]), [0.5, -0.1, 0]),
    Link("Rz", 4, 0.6, [0.15, 0, 0.02], box_inertia(0.6, [0.3, 0.05, 0.05]), [0.1, -0.2, 0]),
]


def test_branched_tree_at_a_state() -> None:
    """Values computed by other methods, with 12 digits."""
    tree = make(BRANCHED, [0.3, -0.4, 0.5, -0.6, 0.2, 0.7], [1, -0.5, 0.8, 1.2, -0.3, 0.9], gravity=[0, 0, -G])
    M = testing.mass_matrix(tree.mbs, state_of(tree))
    entries = {
        (0, 0): 1.940807978154, (0, 1): -0.121893458904, (0, 4): 0.278179217339, (1, 1): 1.809591252849, (1, 2): -0.29227759106,
        (2, 2): 0.21099073541, (4, 4): 1.5, (4, 5): -0.057979591851,
    }  # fmt: skip
    assert {at: M[at] for at in entries} == pytest.approx(entries, abs=2e-12)
    expected = [1.994298542827, 12.894586136427, -3.167731143557, 11.397209317307, -3.439292301815, -3.948297156448]
    assert forward(tree) == pytest.approx(expected, abs=2e-11)


@pytest.mark.parametrize(
    ("end", "expected"),
    [
        (0.5, [0.437033464, 1.290105721, -0.847618154, -1.518340184, 0.688320266, 0.052191689]),
        (1.0, [1.828872817, 1.850289952, -1.025303088, -1.508339974, 2.528036613, 0.471552177]),
    ],
)
def test_motion_of_branched_tree(end: float, expected: list[float]) -> None:
    """From q = 0 with unit velocity of the first joint; uncertainty of the values 2e-9."""
    control = {"jointPControlVector": np.zeros(6), "jointDControlVector": [0.2, 0.2, 0.2, 0.2, 5, 0.2]}
    tree = make(BRANCHED, v=[1, 0, 0, 0, 0, 0], gravity=[0, 0, -G], **control)
    solve(tree, end, round(2000 * end))
    assert tree.coordinates == pytest.approx(expected, abs=3e-9)


@pytest.mark.parametrize(
    ("damping", "end", "expected"),
    [
        (0.0, 0.5, (4.55618084975, -1.22630291184)),
        (0.0, 1.0, (0.57327217864, -4.92983877617)),
        (0.5, 1.0, (0.73940093044, -4.94246136942)),
    ],
)
def test_chain_of_ten_rods(damping: float, end: float, expected: Any) -> None:
    """The tip of a chain that falls from the horizontal; uncertainty of the values 1e-10."""
    rod = {"mass": 1.0, "com": [0.25, 0, 0], "inertia": np.diag([0, 1, 1]) * 0.25 / 12}
    links = [Link("Rz", i - 1, offset=[0.5 if i else 0, 0, 0], **rod) for i in range(10)]
    tree = make(links, gravity=[0, -G, 0], jointDControlVector=np.full(10, damping))
    solve(tree, end, round(4000 * end))
    assert tree.of_link("Position", 9, [0.5, 0, 0])[:2] == pytest.approx(expected, abs=1e-9)


# ---- what mechanics conserves -------------------------------------------------------------------------------------------
def floating(links: list[Link]) -> list[Link]:
    """The links on a base with six coordinates, which has no mass but in the last of its joints."""
    base = [Link(joint, i - 1) for i, joint in enumerate(["Px", "Py", "Pz", "Rz", "Ry"])]
    body = Link("Rx", 4, 3.0, [0.1, 0.2, -0.1], box_inertia(3, [0.5, 0.6, 0.7]))
    below = [Link(**{**vars(link), "parent": link.parent + 6}) for link in links]
    return [*base, body, *below]


def momentum(tree: Tree) -> np.ndarray:
    """Linear and angular, the latter about the global origin."""
    total = np.zeros(6)
    for i, link in enumerate(tree.links):
        if link.mass == 0:
            continue
        position, velocity = (tree.of_link(variable, i, link.com) for variable in ("Position", "Velocity"))
        rotation, spin = tree.of_link("RotationMatrix", i).reshape(3, 3), tree.of_link("AngularVelocity", i)
        total[:3] += link.mass * velocity
        total[3:] += link.mass * np.cross(position, velocity) + rotation @ link.inertia @ rotation.T @ spin
    return total


def energy(tree: Tree, gravity: np.ndarray) -> float:
    total = 0.0
    for i, link in enumerate(tree.links):
        velocity, spin = tree.of_link("Velocity", i, link.com), tree.of_link("AngularVelocityLocal", i)
        total += 0.5 * link.mass * velocity @ velocity + 0.5 * spin @ link.inertia @ spin
        total -= link.mass * gravity @ tree.of_link("Position", i, link.com)
    return total


@pytest.mark.parametrize("seed", range(2))
def test_floating_tree_keeps_momentum_and_energy(seed: int) -> None:
    links = floating(random_links(seed, 5))
    rng = np.random.default_rng(seed)
    q, v = 0.5 * rng.uniform(-1, 1, (2, len(links)))
    after = [make(links, q, v) for _ in range(2)]
    solve(after[0], 1e-9, 1)
    solve(after[1], 1.0, 1000)
    start, end = (momentum(tree) for tree in after)
    assert end == pytest.approx(start, abs=1e-7)
    assert energy(after[1], np.zeros(3)) == pytest.approx(energy(after[0], np.zeros(3)), rel=1e-8)
