"""Random trees against Pinocchio and MuJoCo, where they are installed (pip install pin mujoco)."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dalembert import itemInterface as items
from dalembert.robotics.utilities import ReadRobot
from dalembert.testing.trees import JOINTS, Link, lists, random_links
from dalembert.treeDynamics import TreeDynamics

GRAVITY = np.array([1.0, -2.0, -9.0])
DATA = Path(__file__).parents[1] / "python/data"
SEEDS = pytest.mark.parametrize("seed", range(4))


def tree_of(links: list[Link]) -> TreeDynamics:
    return TreeDynamics(items.ObjectKinematicTree(gravity=GRAVITY, **lists(links)))


def state(n: int, seed: int = 0) -> Any:
    return np.random.default_rng(seed).uniform(-2, 2, (3, n))


# ---- Pinocchio ---------------------------------------------------------------------------------------------------------


def in_pinocchio(links: list[Link]) -> tuple[Any, Any, list[int]]:
    """Pinocchio, its model, and the numbers of its joints."""
    pin = pytest.importorskip("pinocchio", reason="pip install pin", exc_type=ImportError)
    model = pin.Model()
    model.gravity.linear = GRAVITY

    def add(i: int, carrier: int) -> None:
        """Branches in sequence: Pinocchio's mass matrix asks for that."""
        link = links[i]
        kind = getattr(pin, f"JointModel{link.joint[0]}{link.joint[1].upper()}")()
        joint = model.addJoint(carrier, kind, pin.SE3(np.asarray(link.rotation), np.asarray(link.offset)), f"joint{i}")
        inertia = pin.Inertia(link.mass, np.asarray(link.com), np.asarray(link.inertia))
        model.appendBodyToJoint(joint, inertia, pin.SE3.Identity())
        for k, other in enumerate(links):
            if other.parent == i:
                add(k, joint)

    for i, link in enumerate(links):
        if link.parent < 0:
            add(i, 0)
    return pin, model, [model.getJointId(f"joint{i}") for i in range(len(links))]


@SEEDS
def test_dynamics_are_those_of_pinocchio(seed: int) -> None:
    links = random_links(seed, 12)
    tree, (pin, model, joints) = tree_of(links), in_pinocchio(links)
    data = model.createData()
    at = [model.joints[joint].idx_v for joint in joints]
    q, v, a = state(12, seed)

    def sorted_(x: Any) -> Any:
        result = np.empty(12)
        result[at] = x
        return result

    forces = pin.rnea(model, data, sorted_(q), sorted_(v), sorted_(a))[at]
    assert tree.InverseDynamics(q, v, a) == pytest.approx(forces, abs=1e-11)
    assert tree.ForwardDynamics(q, v, forces) == pytest.approx(a, abs=1e-10)
    upper = np.triu(pin.crba(model, data, sorted_(q)))
    assert tree.MassMatrix(q) == pytest.approx((upper + np.triu(upper, 1).T)[np.ix_(at, at)], abs=1e-12)
    by_q, by_v, _ = pin.computeRNEADerivatives(model, data, sorted_(q), sorted_(v), sorted_(a))
    found_q, found_v = tree.InverseDynamicsDerivatives(q, v, a)
    assert found_q == pytest.approx(by_q[np.ix_(at, at)], abs=1e-11)
    assert found_v == pytest.approx(by_v[np.ix_(at, at)], abs=1e-11)
    assert tree.KineticEnergy(q, v) == pytest.approx(pin.computeKineticEnergy(model, data, sorted_(q), sorted_(v)))
    assert tree.PotentialEnergy(q) == pytest.approx(pin.computePotentialEnergy(model, data, sorted_(q)))
    assert tree.CenterOfMass(q) == pytest.approx(pin.centerOfMass(model, data, sorted_(q)), abs=1e-13)


@SEEDS
def test_jacobians_are_those_of_pinocchio(seed: int) -> None:
    links = random_links(seed, 12)
    tree, (pin, model, joints) = tree_of(links), in_pinocchio(links)
    data, at = model.createData(), [model.joints[joint].idx_v for joint in joints]
    q = state(12, seed)[0]
    unsorted = np.empty(12)
    unsorted[at] = q
    pin.computeJointJacobians(model, data, unsorted)
    rotations, origins = tree.LinkFrames(q)
    for link, joint in enumerate(joints):
        place = data.oMi[joint]
        assert rotations[link] == pytest.approx(place.rotation, abs=1e-13)
        assert origins[link] == pytest.approx(place.translation, abs=1e-13)
        expected = pin.getJointJacobian(model, data, joint, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
        assert tree.Jacobian(q, link) == pytest.approx(expected[:, at], abs=1e-12)


def test_urdf_files_are_those_of_pinocchio() -> None:
    pin = pytest.importorskip("pinocchio", reason="pip install pin", exc_type=ImportError)
    robot = ReadRobot(DATA / "arm.urdf", gravity=GRAVITY, graphics=False)
    model = pin.buildModelFromUrdf(str(DATA / "arm.urdf"))
    model.gravity.linear = GRAVITY
    data, q = model.createData(), pin.neutral(model)
    mine, rates, accelerations = state(len(robot.links))
    at = [model.joints[model.getJointId(link.jointName)] for link in robot.links]
    v, a = np.zeros(model.nv), np.zeros(model.nv)
    for joint, angle, rate, acceleration in zip(at, mine, rates, accelerations, strict=True):
        q[joint.idx_q : joint.idx_q + joint.nq] = [angle] if joint.nq == 1 else [np.cos(angle), np.sin(angle)]
        v[joint.idx_v], a[joint.idx_v] = rate, acceleration
    rigid = robot.InverseDynamics(mine, rates, accelerations) - robot.JointResistance(rates)
    expected = pin.rnea(model, data, q, v, a)
    assert rigid == pytest.approx(expected[[joint.idx_v for joint in at]], abs=1e-11)


# ---- MuJoCo ------------------------------------------------------------------------------------------------------------


def numbers(values: Any) -> str:
    return " ".join(f"{value:.17g}" for value in np.ravel(values))


def in_mujoco(links: list[Link]) -> tuple[Any, Any, list[int]]:
    """MuJoCo, its model, and the places of joints among its coordinates."""
    mujoco = pytest.importorskip("mujoco", reason="pip install mujoco", exc_type=ImportError)

    def body(i: int) -> str:
        link, quaternion = links[i], np.empty(4)
        mujoco.mju_mat2Quat(quaternion, np.ravel(link.rotation))
        inertia = np.asarray(link.inertia)[[0, 1, 2, 0, 0, 1], [0, 1, 2, 1, 2, 2]]
        axis = np.eye(3)[(JOINTS[link.joint] - 1) % 3]
        return (
            f'<body pos="{numbers(link.offset)}" quat="{numbers(quaternion)}">'
            f'<inertial pos="{numbers(link.com)}" mass="{link.mass:.17g}" fullinertia="{numbers(inertia)}"/>'
            f'<joint name="joint{i}" type="{"hinge" if link.joint[0] == "R" else "slide"}" axis="{numbers(axis)}"/>'
            + "".join(body(k) for k, other in enumerate(links) if other.parent == i)
            + "</body>"
        )

    bodies = "".join(body(i) for i, link in enumerate(links) if link.parent < 0)
    options = f'<option gravity="{numbers(GRAVITY)}"/>'
    model = mujoco.MjModel.from_xml_string(f"<mujoco>{options}<worldbody>{bodies}</worldbody></mujoco>")
    return mujoco, model, [model.joint(f"joint{i}").dofadr[0] for i in range(len(links))]


@SEEDS
def test_dynamics_are_those_of_mujoco(seed: int) -> None:
    links = [
        replace(link, inertia=np.trace(link.inertia) * np.eye(3) - link.inertia) for link in random_links(seed, 12)
    ]
    tree, (mujoco, model, at) = tree_of(links), in_mujoco(links)  # physically possible bodies
    data = mujoco.MjData(model)
    q, v, forces = state(12, seed)
    data.qpos[at], data.qvel[at], data.qfrc_applied[at] = q, v, forces
    mujoco.mj_forward(model, data)
    assert tree.BiasForces(q, v) == pytest.approx(data.qfrc_bias[at], abs=1e-11)
    assert tree.ForwardDynamics(q, v, forces) == pytest.approx(data.qacc[at], abs=1e-10)
    assert tree.CenterOfMass(q) == pytest.approx(data.subtree_com[0], abs=1e-13)


@pytest.mark.parametrize("seed", range(3))
def test_mjcf_files_are_those_of_mujoco(seed: int) -> None:
    mujoco = pytest.importorskip("mujoco", reason="pip install mujoco", exc_type=ImportError)
    robot, model = ReadRobot(DATA / "arm.xml"), mujoco.MjModel.from_xml_path(str(DATA / "arm.xml"))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
    data = mujoco.MjData(model)
    data.qpos, data.qvel, forces = state(model.nv, seed)
    data.qfrc_applied = forces
    mujoco.mj_forward(model, data)
    assert robot.ForwardDynamics(data.qpos, data.qvel, forces) == pytest.approx(data.qacc, rel=1e-9)
