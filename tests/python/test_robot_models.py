"""Standard robots at states that are published, and in both kinds of frames."""

from __future__ import annotations

import numpy as np
import pytest

from dalembert.robotics import models
from dalembert.robotics.models import LinkDict2Robot, LinkDictModDHKK2Robot, ManipulatorPANDA, ManipulatorPuma560

ROBOTS = ["Manipulator4Rsimple", "Manipulator3RSimple", "ManipulatorPANDA", "ManipulatorUR5", "ManipulatorPuma560"]
Q, QUARTER = np.pi / 2, np.pi / 4
# configurations that P. I. Corke, Robotics, Vision and Control, Springer, 2011, chapters 7 and 9, calls z, n, s and r
ZERO, NOMINAL, STRETCHED, READY = [0] * 6, [0, QUARTER, np.pi, 0, QUARTER, 0], [0, 0, -Q, 0, 0, 0], [0, Q, -Q, 0, 0, 0]
PRINTED = {"rtol": 0, "atol": 0.51e-4}  # four digits


@pytest.fixture
def puma():
    return LinkDict2Robot(ManipulatorPuma560())


@pytest.mark.parametrize(
    ("q", "wanted"),
    [
        (NOMINAL, [0, 31.6399, 6.0351, 0, 0.0283, 0]),
        (STRETCHED, [0, 46.0069, 8.7722, 0, 0.0283, 0]),
        (READY, [0, -0.7752, 0.2489, 0, 0, 0]),
    ],
)
def test_puma_holds_its_weight(puma, q, wanted):
    np.testing.assert_allclose(puma.InverseDynamics(q, ZERO, ZERO), wanted, **PRINTED)


def test_puma_turns_its_waist(puma):
    """1 rad/s about the first axis, without weight: centrifugal torques (that of the first joint is friction alone)."""
    torques = puma.InverseDynamics(NOMINAL, [1, 0, 0, 0, 0, 0], ZERO, gravity=[0, 0, 0])
    np.testing.assert_allclose(torques, [0, 0.6280, -0.3607, -0.0003, 0, 0], **PRINTED)


def test_mass_matrix_of_puma_with_its_motors(puma):
    """Rotors of 0.2e-3 and 0.033e-3 kg m^2 behind gears, as in the source."""
    ratios = np.array([-62.6111, 107.815, -53.7063, 76.0364, 71.923, 76.686])
    for link, inertia in zip(puma.links, ratios**2 * np.repeat([200e-6, 33e-6], 3), strict=True):
        link.rotorInertia = inertia
    wanted = [
        [3.6594, -0.4044, 0.1006, -0.0025, 0.0000, 0.0000],
        [-0.4044, 4.4137, 0.3509, 0.0000, 0.0024, 0.0000],
        [0.1006, 0.3509, 0.9378, 0.0000, 0.0015, 0.0000],
        [-0.0025, 0.0000, 0.0000, 0.1925, 0.0000, 0.0000],
        [0.0000, 0.0024, 0.0015, 0.0000, 0.1713, 0.0000],
        [0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.1941],
    ]
    np.testing.assert_allclose(puma.MassMatrix(NOMINAL), wanted, **PRINTED)


def test_puma_reaches(puma):
    np.testing.assert_allclose(puma.FrameHT("tool", ZERO)[:3, 3], [0.4521, -0.15005, 0.4318], atol=1e-12)
    wanted = [[0, 0, 1, 0.5963], [0, 1, 0, -0.1501], [-1, 0, 0, -0.0144], [0, 0, 0, 1]]
    np.testing.assert_allclose(puma.FrameHT("tool", NOMINAL), wanted, **PRINTED)
    wanted = [
        [0.1501, 0.0144, 0.3197, 0, 0, 0],
        [0.5963, 0, 0, 0, 0, 0],
        [0, 0.5963, 0.2910, 0, 0, 0],
        [0, 0, 0, 0.7071, 0, 1],
        [0, -1, -1, 0, -1, 0],
        [1, 0, 0, -0.7071, 0, 0],
    ]
    np.testing.assert_allclose(puma.Jacobian(puma.JointHT(NOMINAL)), wanted, **PRINTED)


def test_panda_stretched():
    """Its flange is 0.926 m above the base and 0.088 m in front of it, as the data sheet says, and looks down."""
    flange = LinkDict2Robot(ManipulatorPANDA()).LinkHT([0] * 7)[-1]
    np.testing.assert_allclose(flange[:3, 3], [0.088, 0, 0.333 + 0.316 + 0.384 - 0.107], atol=1e-15)
    np.testing.assert_allclose(flange[:3, 2], [0, 0, -1], atol=1e-15)


@pytest.mark.parametrize("name", ROBOTS)
def test_both_kinds_of_frames_describe_one_robot(name):
    """Joints are at the same places, and weights are the same where inertias are carried over."""
    data = getattr(models, name)()
    n = len(data["links"])
    q, q_t, q_tt = np.random.default_rng(0).uniform(-1, 1, (3, n))
    standard = LinkDict2Robot(data | {"dhMode": "stdDH"})
    modified = LinkDictModDHKK2Robot(data | {"dhMode": "stdDH"})
    np.testing.assert_allclose(standard.JointHT(q), modified.JointHT(q), atol=1e-14)
    torques = standard.InverseDynamics(q, q_t, q_tt)
    np.testing.assert_allclose(modified.InverseDynamics(q, q_t, q_tt), torques, atol=1e-12)
    own = LinkDict2Robot(data)
    assert [link.maxForce for link in own.links] == list(np.diag(data["joinTorqueMaxMatrix"]))
    assert [list(link.jointLimits) for link in own.links] == [link["jointLimits"] for link in data["links"]]
    assert np.linalg.eigvalsh(own.MassMatrix(q)).min() > 0


def test_other_dictionaries():
    data = ManipulatorPuma560()
    robot = LinkDict2Robot({"links": data["links"][:2], "dhMode": "stdDH"})
    assert not robot.GetLink(0).HasPDcontrol() and robot.gravity.tolist() == [0, 0, 0]
    longer = LinkDict2Robot({"links": data["links"][2:], "dhMode": "stdDH"}, robot)
    assert longer is robot and robot.NumberOfLinks() == 6
    with pytest.raises(ValueError, match="dhMode: expected 'stdDH' or 'modDHKK', received None"):
        LinkDict2Robot({"links": []})
