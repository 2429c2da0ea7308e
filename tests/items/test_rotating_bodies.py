"""mbs.ComputeVibrationModes of bodies with a floating frame, and of generic ones, in a steady rotation."""

from __future__ import annotations

import numpy as np
import pytest
from flexible import of_points

import dalembert as exu


def flexible_body(kind: str) -> exu.MainSystem:
    """1 kg on springs of 100, 400 and 130 N/m, 2 m away from the axis, as a body whose frame is held."""
    mbs, stiffness = exu.SystemContainer().AddSystem(), np.diag([100.0, 400, 130])
    if kind == "GenericODE2":
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[2, 0, 0]))
        mbs.AddObject(exu.ObjectGenericODE2(nodeNumbers=[node], massMatrix=np.eye(3), stiffnessMatrix=stiffness))
        mbs.Assemble()
        return mbs
    places, masses = np.array([[0.0, 0, 0], [2, 0, 0]]), np.array([3.0, 1.0])
    if kind == "FFRF on angles of rotation":
        frame = mbs.AddNode(exu.NodeRigidBodyRotVecLG(referenceCoordinates=[0] * 6))
    else:
        frame = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0]))
    held = mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=frame))
    ground = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
    mbs.AddObject(exu.GenericJoint(markerNumbers=[ground, held]))
    if kind == "FFRF":
        nodes = [mbs.AddNode(exu.NodePoint(referenceCoordinates=list(place))) for place in places]
        mass = exu.MatrixContainer(np.kron(np.diag(masses), np.eye(3)))
        springs = exu.MatrixContainer(np.block([[1e9 * np.eye(3), np.zeros((3, 3))], [np.zeros((3, 3)), stiffness]]))
        mbs.AddObject(exu.ObjectFFRF(nodeNumbers=[frame, *nodes], massMatrixFF=mass, stiffnessMatrixFF=springs))
    else:
        modes = np.vstack([np.zeros((3, 3)), np.eye(3)])
        modal = mbs.AddNode(
            exu.NodeGenericODE2(
                numberOfODE2Coordinates=3, referenceCoordinates=[0] * 3, initialCoordinates=[0] * 3, initialCoordinates_t=[0] * 3
            )
        )  # fmt: skip
        rows = of_points(places, masses, modes)
        mbs.AddObject(exu.ObjectFFRFreducedOrder(nodeNumbers=[frame, modal], stiffnessMatrixReduced=stiffness, **rows))
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("kind", ["GenericODE2", "FFRF", "FFRFreducedOrder", "FFRF on angles of rotation"])
def test_rotating_flexible_bodies(kind: str) -> None:
    """Steady deflection and frequencies are those of a mass point on springs, which has a closed form."""
    speed = 4.0
    found = flexible_body(kind).ComputeVibrationModes(3, [0, 0, speed])
    assert found.coordinates[-3:] == pytest.approx([2 * speed**2 / (100 - speed**2), 0, 0], abs=1e-6)
    # lambda^4 + lambda^2 (500 + 2 Omega^2) + (100 - Omega^2) (400 - Omega^2) = 0 in the plane
    squares = np.roots([1, 500 + 2 * speed**2, (100 - speed**2) * (400 - speed**2)])
    wanted = np.sort([*np.sqrt(-squares), np.sqrt(130)])
    assert found.eigenvalues.imag[:3] == pytest.approx(wanted, rel=1e-7)
    assert np.abs(found.eigenvalues.real[:3]).max() < 1e-6
