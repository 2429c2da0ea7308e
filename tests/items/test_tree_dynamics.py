"""Functions of kinematic trees against spatial vectors in Python, differences, and each other."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as items
from dalembert.testing.trees import Link, in_python, lists, random_links
from dalembert.treeDynamics import TreeDynamics

GRAVITY = [1.0, -2.0, 9.0]
BASE = [3.0, 4.0, 5.0]


def tree_of(links: list[Link]) -> TreeDynamics:
    return TreeDynamics(items.ObjectKinematicTree(gravity=GRAVITY, baseOffset=BASE, **lists(links)))


def states(links: list[Link], *shape: int, count: int = 3) -> Any:
    return np.random.default_rng(7).uniform(-2, 2, (count, *shape, len(links)))


@pytest.mark.parametrize("count", [8, 14])  # accelerations by a mass matrix, and by articulated bodies
@pytest.mark.parametrize("seed", range(3))
def test_many_states_are_those_one_by_one(seed: int, count: int) -> None:
    links = random_links(seed, count)
    tree, python = tree_of(links), in_python(links, GRAVITY)
    q, v, a = states(links, 3, 7)
    forces, bias, M = tree.InverseDynamics(q, v, a), tree.BiasForces(q, v), tree.MassMatrix(q)
    assert M.shape == (3, 7, count, count)
    for at in np.ndindex(3, 7):
        expected, f = python.ComputeMassMatrixAndForceTerms(q[at], v[at])
        assert M[at] == pytest.approx(np.array(expected), abs=1e-12)
        assert bias[at] == pytest.approx(f, abs=1e-11)
        assert forces[at] == pytest.approx(expected @ a[at] + f, abs=1e-11)
    assert tree.ForwardDynamics(q, v, forces) == pytest.approx(a, abs=1e-10)
    assert tree.GravityForces(q) == pytest.approx(tree.BiasForces(q, 0 * v), abs=1e-13)


def test_large_angles_keep_their_digits() -> None:
    links = random_links(1, 6)
    tree, python = tree_of(links), in_python(links, GRAVITY)
    q, v, _ = states(links)
    for turns in (1, -1000, 123456789):
        further = q + np.pi / 2 * turns * np.array([link.joint.startswith("R") for link in links])
        assert tree.BiasForces(further, v) == pytest.approx(
            python.ComputeMassMatrixAndForceTerms(further, v)[1], rel=1e-11
        )


def test_single_states_and_broadcasting() -> None:
    links = random_links(2, 5)
    tree = tree_of(links)
    q, v, a = states(links, 4)
    assert tree.InverseDynamics(q[0], v[0], a[0]) == pytest.approx(tree.InverseDynamics(q, v, a)[0], rel=1e-12)
    assert tree.InverseDynamics(q[0], v, a) == pytest.approx(
        tree.InverseDynamics(np.tile(q[0], (4, 1)), v, a), rel=1e-12
    )
    assert tree.KineticEnergy(q[0], v[0]).shape == ()
    assert tree.MassMatrix(np.zeros((0, 5))).shape == (0, 5, 5)


def test_derivatives_are_those_of_differences() -> None:
    links = random_links(3, 7)
    tree = tree_of(links)
    q, v, a = states(links, 2)
    h, unit = 1e-6, np.eye(7)
    for of, derivatives in (
        (tree.InverseDynamics, tree.InverseDynamicsDerivatives(q, v, a)),
        (tree.ForwardDynamics, tree.ForwardDynamicsDerivatives(q, v, a)),
    ):
        for k in range(7):
            steps = [(h * unit[k], 0, 0), (0, h * unit[k], 0), (0, 0, h * unit[k])]
            for derivative, (dq, dv, da) in zip(derivatives, steps, strict=False):
                difference = (of(q + dq, v + dv, a + da) - of(q - dq, v - dv, a - da)) / (2 * h)
                scale = 1 + np.abs(difference).max()
                assert derivative[..., k] == pytest.approx(difference, abs=1e-7 * scale)


def test_derivatives_of_inertia_places_and_energies() -> None:
    """Against differences, whose error is of the order of h^2 = 1e-10; rounding makes 1e-16 / h = 1e-11."""
    links = random_links(4, 7)
    tree = tree_of(links)
    q, v, _ = states(links, 2)
    h, last, point = 1e-5, len(links) - 1, [0.3, -0.2, 0.1]
    kinetic_by_q, kinetic_by_v = tree.KineticEnergyDerivatives(q, v)
    found = [
        (tree.MassMatrix, tree.MassMatrixDerivatives(q)),
        (lambda q: tree.Jacobian(q, last, point), tree.JacobianDerivatives(q, last, point)),
        (tree.CenterOfMass, tree.CenterOfMassJacobian(q)),
        (lambda q: tree.KineticEnergy(q, v), kinetic_by_q),
        (tree.PotentialEnergy, tree.GravityForces(q)),
    ]
    for of, derivatives in found:
        assert np.abs(derivatives).max() > 0.1
        for k, step in enumerate(h * np.eye(7)):
            difference = (of(q + step) - of(q - step)) / (2 * h)
            assert derivatives[..., k] == pytest.approx(difference, abs=1e-8 * (1 + np.abs(difference).max()))
    assert kinetic_by_v == pytest.approx(np.einsum("...ij,...j->...i", tree.MassMatrix(q), v), rel=1e-11)
    assert tree.JacobianDerivatives(q[0], last).shape == (6, 7, 7) and tree.CenterOfMassJacobian(q[0]).shape == (3, 7)


@pytest.mark.parametrize("link", [0, 4, 6])
def test_jacobian_is_the_derivative_of_the_frame(link: int) -> None:
    links = random_links(4, 7)
    tree = tree_of(links)
    q, v, _ = states(links, 3)
    local, h = np.array([0.3, -0.2, 0.4]), 1e-6

    def frame(x: Any) -> Any:
        rotations, origins = tree.LinkFrames(x)
        return rotations[:, link], origins[:, link] + rotations[:, link] @ local

    twist = np.einsum("...ij,...j->...i", tree.Jacobian(q, link, local), v)
    (after, there), (before, here) = frame(q + h * v), frame(q - h * v)
    assert twist[:, :3] == pytest.approx((there - here) / (2 * h), abs=1e-8)
    spin = (after - before) / (2 * h) @ np.swapaxes(frame(q)[0], -1, -2)
    assert twist[:, 3:] == pytest.approx(np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], -1), abs=1e-8)


def test_energies() -> None:
    links = random_links(5, 6)
    tree = tree_of(links)
    q, v, a = states(links, 4)
    kinetic = tree.KineticEnergy(q, v)
    assert kinetic == pytest.approx(0.5 * np.einsum("...i,...ij,...j", v, tree.MassMatrix(q), v), rel=1e-12)
    mass = sum(link.mass for link in links)
    assert tree.PotentialEnergy(q) == pytest.approx(-mass * tree.CenterOfMass(q) @ GRAVITY, rel=1e-12)
    h = 1e-5
    rate = sum(
        s * (tree.KineticEnergy(q + s * h * v, v + s * h * a) + tree.PotentialEnergy(q + s * h * v)) for s in (1, -1)
    )
    power = np.sum(tree.InverseDynamics(q, v, a) * v, axis=-1)
    assert rate / (2 * h) == pytest.approx(power, rel=1e-7)


def test_tree_of_a_system() -> None:
    mbs = exu.SystemContainer().AddSystem()
    links = random_links(6, 5)
    node = mbs.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=5))
    number = mbs.AddObject(items.ObjectKinematicTree(nodeNumber=node, gravity=GRAVITY, **lists(links)))
    mbs.Assemble()
    q, v, a = states(links, 2)
    assert TreeDynamics(mbs, number).InverseDynamics(q, v, a) == pytest.approx(tree_of(links).InverseDynamics(q, v, a))
    ground = mbs.AddObject(items.ObjectGround())
    mbs.Assemble()
    with pytest.raises(ValueError, match="expected an ObjectKinematicTree"):
        TreeDynamics(mbs, ground)


def test_refusals() -> None:
    tree = tree_of(random_links(0, 4))
    with pytest.raises(ValueError, match="TreeDynamics: v.*4 numbers"):
        tree.BiasForces(np.zeros(4), np.zeros(3))
    with pytest.raises(ValueError, match="TreeDynamics: q: expected finite numbers"):
        tree.ForwardDynamics([0, np.nan, 0, 0], np.zeros(4), np.zeros(4))
    with pytest.raises(ValueError, match="TreeDynamics: q: expected an array .* received .'a'"):
        tree.MassMatrix(["a", "b", "c", "d"])
    with pytest.raises(ValueError, match=r"received the shapes q \(5, 4\), v \(3, 4\)"):
        tree.BiasForces(np.zeros((5, 4)), np.zeros((3, 4)))
    with pytest.raises(ValueError, match="linkNumber: received 4"):
        tree.Jacobian(np.zeros(4), 4)
    with pytest.raises(ValueError, match="linkMasses"):
        TreeDynamics(items.ObjectKinematicTree(**lists(random_links(0, 4)) | {"linkMasses": [1]}))
    with pytest.raises(ValueError, match="nothing resists joint 1"):
        tree_of([Link("Rz", mass=1.0, inertia=np.eye(3)), Link("Rx", 0)]).ForwardDynamics([0, 0], [0, 0], [0, 0])
