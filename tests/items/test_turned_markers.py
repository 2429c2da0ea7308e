"""localHT of markers, referenceHT of ground and jointHTs of trees: the same motion as with rotations of joints."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

TURN = exu.HT(rotationVector=[0.4, -0.7, 0.2])
V = exu.OutputVariableType


def pendulum(turned: bool, node_type: exu.NodeType, joint: str = "generic") -> tuple[Any, Any, Any]:
    """Return a system, its joint and its body: a hinge about a skew axis, with its axes in markers or in the joint."""
    mbs = exu.SystemContainer().AddSystem()
    place, arm = exu.HT(TURN.rotation, [0.1, 0.2, 0.3]), exu.HT(TURN.rotation, [-0.5, 0, 0])
    ground = mbs.AddObject(exu.ObjectGround())
    body = mbs.CreateRigidBody(
        inertia=InertiaCuboid(density=1000, sideLengths=[1, 0.1, 0.2]),
        referencePosition=place.translation + [0.5, 0, 0],
        initialAngularVelocity=2 * TURN.rotation[:, 2],
        initialVelocity=np.cross(2 * TURN.rotation[:, 2], [0.5, 0, 0]),
        nodeType=node_type,
        gravity=[0, 0, -9.81],
    )
    locals_ = [{"localHT": H} if turned else {"localPosition": H.translation} for H in (place, arm)]
    markers = [
        mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b, **given))  # type: ignore[arg-type]
        for b, given in zip((ground, body), locals_, strict=True)
    ]
    axes = {} if turned else {"rotationMarker0": TURN.rotation, "rotationMarker1": TURN.rotation}
    if joint == "generic":
        number = mbs.AddObject(exu.GenericJoint(markerNumbers=markers, constrainedAxes=[1, 1, 1, 1, 1, 0], **axes))
    else:
        number = mbs.AddObject(exu.ObjectJointRevoluteZ(markerNumbers=markers, **axes))
    mbs.AddObject(exu.RigidBodySpringDamper(markerNumbers=markers, stiffness=np.diag([0, 0, 0, 0, 0, 5.0]), **axes))
    mbs.Assemble()
    return mbs, number, body


@pytest.mark.parametrize("joint", ["generic", "revolute"])
@pytest.mark.parametrize(
    "node_type", [exu.NodeType.RotationEulerParameters, exu.NodeType.RotationRxyz, exu.NodeType.RotationRotationVector]
)
def test_turned_markers_move_as_turned_joints(node_type: exu.NodeType, joint: str) -> None:
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 200
    settings.timeIntegration.newton.relativeTolerance = 1e-10
    settings.solutionSettings.writeSolutionToFile = False
    found = []
    for turned in (True, False):
        mbs, number, body = pendulum(turned, node_type, joint)
        mbs.SolveDynamic(settings)
        found.append(
            [
                mbs.GetObjectOutputBody(body, V.Position),
                mbs.GetObjectOutput(number, V.Rotation),
                mbs.GetObjectOutput(number, V.ForceLocal),
                mbs.sys["dynamicSolver"].it.newtonStepsCount,
            ]
        )
    assert np.linalg.norm(np.subtract(found[0][0], [0.6, 0.2, 0.3])) > 0.1  # it has moved
    for one, other in zip(found[0][:3], found[1][:3], strict=True):
        assert np.allclose(one, other, rtol=0, atol=1e-8 * max(1.0, float(np.abs(other).max())))  # Newton's tolerance
    assert found[0][3] == found[1][3]  # the tangent is exact in both cases


def test_outputs_of_a_turned_marker_and_its_parameters() -> None:
    mbs = exu.SystemContainer().AddSystem()
    place = exu.HT(Rxyz=[0.1, 0.2, 0.3], translation=[1, 2, 3])
    ground = mbs.AddObject(exu.ObjectGround(referenceHT=place))
    assert np.allclose(mbs.GetObjectParameter(ground, "referencePosition"), [1, 2, 3])
    assert np.allclose(mbs.GetObjectParameter(ground, "referenceRotation"), place.rotation)
    assert mbs.GetObjectParameter(ground, "referenceHT") == place
    marker = mbs.AddMarker({"markerType": "BodyRigid", "bodyNumber": ground, "localHT": TURN})
    mbs.Assemble()
    expected = place * TURN
    assert np.allclose(mbs.GetMarkerOutput(marker, V.RotationMatrix), expected.rotation.ravel(), rtol=0, atol=1e-15)
    assert np.allclose(mbs.GetMarkerOutput(marker, V.HomogeneousTransformation), expected, rtol=0, atol=1e-15)
    mbs.SetMarkerParameter(marker, "localHT", place)
    mbs.Assemble()
    assert np.allclose(mbs.GetMarkerOutput(marker, V.HomogeneousTransformation), place * place, rtol=0, atol=1e-14)
    item = exu.MarkerBodyRigid(localHT=place)
    assert item.localHT == place
    item.localHT = TURN
    assert np.allclose(item.localRotation, TURN.rotation)
    assert exu.MarkerBodyRigid(localHT=None) == exu.MarkerBodyRigid()
    with pytest.raises(TypeError, match="'localPosition': given twice, by two of its names"):
        exu.MarkerBodyRigid(localPosition=[1, 0, 0], localHT=place)
    with pytest.raises(ValueError, match="a rotation without translation"):
        exu.MarkerNodeRigid(localHT=place)
    with pytest.raises(ValueError, match=r"MarkerBodyRigid: localHT"):
        exu.MarkerBodyRigid(localHT=np.eye(3))


def test_joint_transformations_of_a_tree() -> None:
    places = [exu.HT(rotationVector=[0.1 * i, 0.2, 0.3], translation=[i, 0, 1]) for i in range(2)]
    tree = exu.ObjectKinematicTree(jointHTs=places)
    assert np.allclose(np.array(tree.jointOffsets), [H.translation for H in places])
    assert np.allclose(np.array(tree.jointTransformations), [H.rotation for H in places])
    assert tree.jointHTs == places
