"""mbs.ComputeVibrationModes against closed forms: preload, damping, gyroscopic forces, constraints, large systems."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from solving import new_system

import dalembert as exu
from dalembert.beams import GenerateStraightLineANCFCable
from dalembert.solver import SolverError


def string(elements: int, tension: float, bending: float, force: bool = False) -> exu.MainSystem:
    """A cable of length 1 m and mass 1 kg, held at both ends; stretched by initial coordinates, or by a force that pulls its end."""
    mbs = new_system()
    axial = 1e5
    cable = exu.Cable(
        physicsMassPerLength=1.0, physicsBendingStiffness=bending, physicsAxialStiffness=axial,
        physicsReferenceAxialStrain=0.0 if force else -tension / axial,
    )  # fmt: skip
    free = int(force)
    nodes = GenerateStraightLineANCFCable(
        mbs, [0, 0, 0], [1, 0, 0], elements, cable, [0, 0, 0], [1, 1, 1, 0, 0, 0], [1 - free, 1, 1, 0, 0, 0]
    )[0]
    if force:
        end = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=nodes[-1]))
        mbs.AddLoad(exu.Force(markerNumber=end, loadVector=[tension, 0, 0]))
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("force", [False, True])
def test_string_under_tension(force: bool) -> None:
    """omega^2 = (EI n^4 + T n^2) / rho A, twice each, with n pi / L for n: errors fall with the fourth power of the element length."""
    tension, bending = 100.0, 0.05
    length = 1.001 if force else 1.0
    n = np.repeat(np.arange(1, 4), 2) * np.pi / length
    wanted = np.sqrt((bending * n**4 + tension * n**2) * length)
    coarse, fine = (
        string(m, tension, bending, force).ComputeVibrationModes(6).frequencies * 2 * np.pi / wanted - 1
        for m in (16, 32)
    )
    if force:  # elements take curvature and extension by their unstretched length: bending alone sees that, 1e-3 of a hundredth
        assert np.abs(fine).max() < 3e-5
    else:
        assert np.abs(fine).max() < 3e-7
        assert coarse[2:] / fine[2:] == pytest.approx(16 * np.ones(4), rel=0.15)


def test_preload_shows() -> None:
    """The same string without tension has the frequencies of a beam: the preload makes the difference."""
    slack = string(16, 0.0, 0.05).ComputeVibrationModes(2)
    assert slack.frequencies[0] * 2 * np.pi == pytest.approx(np.pi**2 * np.sqrt(0.05), rel=1e-4)


def point(mass: float, stiffness: Any, damping: Any = (0.0, 0.0, 0.0), at: Any = (0.0, 0.0, 0.0)) -> exu.MainSystem:
    mbs = new_system()
    body = mbs.CreateMassPoint(referencePosition=list(at), physicsMass=mass)
    markers = [
        mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b))
        for b in (mbs.CreateGround(referencePosition=list(at)), body)
    ]
    mbs.AddObject(exu.CartesianSpringDamper(markerNumbers=markers, stiffness=list(stiffness), damping=list(damping)))
    mbs.Assemble()
    return mbs


def test_damped_oscillator() -> None:
    """lambda = - delta +- i sqrt(omega^2 - delta^2); one direction is overdamped."""
    found = point(2.0, [50, 200, 2], [4, 0, 10]).ComputeVibrationModes(4)
    wanted = [-1 + 1j * np.sqrt(24), 10j, -2.5 + np.sqrt(5.25), -2.5 - np.sqrt(5.25)]
    for value in wanted:
        assert np.abs(found.eigenvalues - value).min() < 1e-10
    assert found.dampingRatios[np.argmin(np.abs(found.eigenvalues - wanted[0]))] == pytest.approx(0.2, rel=1e-9)


@pytest.mark.parametrize("speed", [3.0, 12.0])
def test_rotating_oscillator(speed: float) -> None:
    """A point on equal springs, seen from the rotating frame, moves forward and backward: |omega -+ Omega|; along the axis: omega."""
    found = point(1.0, [100, 100, 100]).ComputeVibrationModes(3, [0, 0, speed])
    assert np.sort(found.eigenvalues.imag) == pytest.approx(np.sort([abs(10 - speed), 10, 10 + speed]), rel=1e-9)
    circle = found.modes[:, np.argmax(found.eigenvalues.imag)]
    assert abs(circle[0] / circle[1]) == pytest.approx(1, rel=1e-9)


def test_unstable_above_the_critical_speed() -> None:
    """Centrifugal forces with different springs are larger between both frequencies: omega_x < Omega < omega_y."""
    mbs = point(1.0, [100, 400, 100])
    assert np.abs(mbs.ComputeVibrationModes(3, [0, 0, 8.0]).eigenvalues.real).max() < 1e-9
    found = mbs.ComputeVibrationModes(4, [0, 0, 15.0])
    # lambda^4 + lambda^2 (500 + 2 Omega^2) + (100 - Omega^2) (400 - Omega^2) = 0
    growth = np.sqrt(max(np.roots([1, 500 + 2 * 225, (100 - 225) * (400 - 225)]).real))
    assert found.eigenvalues.real.max() == pytest.approx(growth, rel=1e-9)


def test_steady_state_off_the_axis() -> None:
    """A point at radius r on a radial spring moves out by r Omega^2 / (omega^2 - Omega^2), about any center."""
    center = np.array([0.3, -0.2, 0.1])
    mbs = point(1.0, [100, 1e4, 1e4], at=center + [2, 0, 0])
    found = mbs.ComputeVibrationModes(2, [0, 0, 4.0], center, updateInitialValues=True)
    assert found.coordinates == pytest.approx([2 * 16 / 84, 0, 0], abs=1e-12)
    assert mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Initial) == pytest.approx(found.coordinates, abs=0)


def test_forces_of_constraints_count() -> None:
    """A pendulum on a rigid rod has no other stiffness than that of the force in its rod; spun about the vertical, the square of the
    frequency in and across the plane is g / L - Omega^2 with the gyroscopic coupling of a Foucault pendulum."""
    length, g = 2.0, 9.81
    mbs = new_system()
    body = mbs.CreateMassPoint(referencePosition=[0, 0, -length], physicsMass=3.0, gravity=[0, 0, -g])
    mbs.CreateDistanceConstraint(bodyNumbers=[mbs.CreateGround(), body])
    mbs.Assemble()
    still = np.sqrt(g / length)
    assert mbs.ComputeVibrationModes(2).eigenvalues == pytest.approx(1j * still * np.ones(2), rel=1e-9)
    turning = mbs.ComputeVibrationModes(2, [0, 0, 0.7]).eigenvalues.imag
    assert turning == pytest.approx([still - 0.7, still + 0.7], rel=1e-9)


@pytest.mark.parametrize("node", [exu.NodeType.RotationEulerParameters, exu.NodeType.RotationRotationVector])
@pytest.mark.parametrize("length", [1.0, 1e3], ids=["m", "mm"])
def test_redundant_joints_change_nothing(length: float, node: Any) -> None:
    """A door on up to three hinges about x and a torsional spring, spun about its hinges: omega^2 = c / J, and the speed has no part in it.

    Their singular matrices were refused, or ended the process.
    """
    size, stiffness = length * np.array([2.0, 0.9, 0.04]), 40.0 * length**2
    inertia = exu.utilities.InertiaCuboid(30 / np.prod(size), size)
    about_hinges = inertia.InertiaCOM()[0, 0] + 30 * (size[1] / 2) ** 2
    for hinges in (1, 2, 3):
        mbs = new_system()
        ground = mbs.CreateGround()
        door = mbs.CreateRigidBody(referencePosition=size * [0.5, 0.5, 0], inertia=inertia, nodeType=node)
        for x in (0.3, 1.7, 1.0)[:hinges]:
            mbs.CreateRevoluteJoint(bodyNumbers=[ground, door], position=[x * length, 0, 0], axis=[1, 0, 0])
        markers = [
            mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=-size * [0.5, 0.5, 0] * (body == door)))
            for body in (ground, door)
        ]
        turned = exu.utilities.RotationMatrixY(np.pi / 2)
        mbs.AddObject(
            exu.TorsionalSpringDamper(
                markerNumbers=markers, rotationMarker0=turned, rotationMarker1=turned, stiffness=stiffness
            )
        )
        mbs.Assemble()
        for speed in (0.0, 3.0):
            found = mbs.ComputeVibrationModes(1, [speed, 0, 0]).eigenvalues
            assert found == pytest.approx([1j * np.sqrt(stiffness / about_hinges)], rel=1e-9)


@pytest.mark.parametrize("hinges", [1, 2])
def test_joints_that_do_not_fit(hinges: int) -> None:
    """The rule is that of solvers: small misplacements are fitted with a warning, larger ones are rejected. A
    single hinge moves the door to where it fits."""

    def frequency(misplaced: float) -> float:
        mbs = new_system()
        ground, size = mbs.CreateGround(), np.array([2.0, 0.9, 0.04])
        inertia = exu.utilities.InertiaCuboid(30 / np.prod(size), size)
        door = mbs.CreateRigidBody(referencePosition=size * [0.5, 0.5, 0], inertia=inertia)
        for x, beside in ((0.3, misplaced), (1.7, 0))[:hinges]:
            ends = ((ground, [x, beside, 0]), (door, [x, 0, 0] - size * [0.5, 0.5, 0]))
            markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=p)) for body, p in ends]
            turned = exu.utilities.RotationMatrixY(np.pi / 2)
            mbs.AddObject(exu.RevoluteJointZ(markerNumbers=markers, rotationMarker0=turned, rotationMarker1=turned))
        corners = [
            mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b, localPosition=p))
            for b, p in ((ground, [1, 0.9, -1]), (door, [0, 0.45, 0]))
        ]
        mbs.AddObject(exu.SpringDamper(markerNumbers=corners, stiffness=500, referenceLength=1))
        mbs.Assemble()
        return float(mbs.ComputeVibrationModes(1).frequencies[0])

    wanted = np.sqrt(500 * 0.9**2 / (30 * (0.9**2 + 0.04**2 / 4) / 3)) / (2 * np.pi)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert frequency(0) == pytest.approx(wanted, rel=2e-3)
        if hinges == 1:
            assert frequency(1e-3) == pytest.approx(frequency(0), rel=5e-3)
            return
    with pytest.warns(RuntimeWarning, match=r"constraints contradict each other(?s:.*)equation 1: gap") as told:
        assert frequency(1e-6) == pytest.approx(frequency(0), rel=1e-5)
    assert len(told) == 1
    with pytest.raises(exu.SolverError, match="contradict each other") as refused:
        frequency(1e-3)
    assert refused.value.reason == "contradictoryConstraints"


def test_large_system() -> None:
    """More than 10 000 unknowns, by sparse factors; their rounding grows with the stiffness of short elements."""
    found = string(1700, 100.0, 0.05).ComputeVibrationModes(4)
    n = np.array([1, 1, 2, 2]) * np.pi
    assert len(found.coordinates) > 10_000
    assert found.frequencies * 2 * np.pi == pytest.approx(np.sqrt(0.05 * n**4 + 100 * n**2), rel=1e-5)


def test_refusals() -> None:
    mbs = point(1.0, [1, 1, 1])
    with pytest.raises(ValueError, match="numberOfModes: expected a positive number, received 0"):
        mbs.ComputeVibrationModes(0)
    with pytest.raises(ValueError, match="angularVelocity: expected 3 finite numbers"):
        mbs.ComputeVibrationModes(1, [0, 1])
    planar = new_system()
    planar.AddNode(exu.NodePoint2D())
    planar.AddObject(exu.MassPoint2D(nodeNumber=0, physicsMass=1.0))
    with pytest.raises(ValueError, match=r"node 0 \(Point2D\), which stays in its plane; expected a rotation about z"):
        planar.ComputeVibrationModes(1, [1, 0, 0])
    angles = new_system()
    angles.CreateRigidBody(inertia=exu.utilities.InertiaCuboid(1000, [1, 1, 1]), nodeType=exu.NodeType.RotationRxyz)
    with pytest.raises(ValueError, match=r"node 0 \(RigidBodyRxyz\)"):
        angles.ComputeVibrationModes(1, [0, 0, 1])
    modal = new_system()
    modal.AddNode(
        exu.NodeGenericODE2(
            referenceCoordinates=[0], initialCoordinates=[0], initialCoordinates_t=[0], numberOfODE2Coordinates=1
        )
    )
    modal.AddObject(exu.ObjectGenericODE2(nodeNumbers=[0], massMatrix=np.eye(1), stiffnessMatrix=np.eye(1)))
    assert modal.ComputeVibrationModes(1).eigenvalues == pytest.approx([1j], rel=1e-9)
    with pytest.raises(ValueError, match=r"node 0 \(GenericODE2\), whose rotation with the frame is not defined"):
        modal.ComputeVibrationModes(1, [0, 0, 1])
    falling = new_system()
    falling.CreateMassPoint(physicsMass=1.0, gravity=[0, 0, -9.81])
    falling.Assemble()
    with pytest.raises(SolverError, match="no balance of forces"):
        falling.ComputeVibrationModes(1)
