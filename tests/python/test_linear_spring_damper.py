"""CreateLinearSpringDamper: a spring along an axis that is fixed to the first body; energy of loads."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import dalembert as exu
from dalembert.advancedUtilities import LoadPotentialEnergy
from dalembert.rigidBodyUtilities import InertiaCuboid

V = exu.OutputVariableType
A = Rotation.from_rotvec([0.3, -0.5, 0.8]).as_matrix()


@pytest.mark.parametrize("useGlobalFrame", [True, False])
def test_displacement_and_force_along_the_axis(useGlobalFrame: bool) -> None:
    """The body is 0.3 m ahead along the axis and 0.2 m beside it: k (0.3 - 0.1) + 5."""
    mbs = exu.SystemContainer().AddSystem()
    axis = A @ [1, 0, 0]
    beside = A @ [0, 0.2, 0]
    first = mbs.CreateGround(referencePosition=[1, 2, 3], referenceRotationMatrix=A)
    second = mbs.CreateRigidBody(
        inertia=InertiaCuboid(density=1000, sideLengths=[1, 1, 1]),
        referencePosition=[4, 5, 6],
        initialDisplacement=0.3 * axis + beside,
    )
    place = np.array([2.0, 0, 1])
    spring = mbs.CreateLinearSpringDamper(
        bodyNumbers=[first, second],
        position=place if useGlobalFrame else A.T @ (place - [1, 2, 3]),
        axis=2 * axis if useGlobalFrame else [2, 0, 0],
        stiffness=10,
        offset=0.1,
        force=5,
        useGlobalFrame=useGlobalFrame,
    )
    mbs.Assemble()
    assert np.allclose(mbs.GetObjectParameter(spring, "axisMarker0"), [1, 0, 0], rtol=0, atol=1e-14)
    for marker in mbs.GetObjectParameter(spring, "markerNumbers"):
        found = mbs.GetMarkerOutput(marker, V.Position, exu.ConfigurationType.Reference)
        assert np.allclose(found, place, rtol=0, atol=1e-14)
    assert mbs.GetObjectOutput(spring, V.DisplacementLocal) == pytest.approx(0.3, abs=1e-14)
    assert mbs.GetObjectOutput(spring, V.ForceLocal) == pytest.approx(10 * 0.2 + 5, abs=1e-12)
    force = mbs.CreateForce(bodyNumber=second, loadVector=[1, 2, 3])
    mbs.Assemble()
    way = 0.3 * axis + beside
    assert LoadPotentialEnergy(mbs, force) == pytest.approx(-(way @ [1, 2, 3]), abs=1e-14)


def test_an_axis_of_zero_length() -> None:
    mbs = exu.SystemContainer().AddSystem()
    bodies = [mbs.CreateGround(), mbs.CreateMassPoint(physicsMass=1)]
    with pytest.raises(ValueError, match="argument 'axis': expected a vector with 3 components that is not zero"):
        mbs.CreateLinearSpringDamper(bodyNumbers=bodies, axis=[0, 0, 0])
