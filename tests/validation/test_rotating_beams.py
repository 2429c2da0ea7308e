"""A beam that is spun up (J. C. Simo, L. Vu-Quoc, 1986), and frequencies of beams that rotate."""

from __future__ import annotations

import numpy as np
import pytest
from rods import Rod, section
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, settings

import dalembert as exu

# Displacement of the tip, relative to the rigidly rotating line: along it, across it, and the rotation of the section;
# by an element of degree 10.
SPUN = {
    2.5: (-0.001322677, -0.151283559, -0.020621126),
    5.0: (-0.012654636, -0.468476183, -0.063716733),
    7.5: (-0.017741865, -0.559083459, -0.074778631),
    10.0: (-0.007072336, -0.362814516, -0.047237006),
    15.0: (0.000513990, 0.001303626, 0.000167747),
}
LENGTH, PULL, INERTIA = 10.0, 2.8e7, 1.2  # m, N, kg/m
END_SPEED, RISE = 6.0, 15.0  # rad/s, s


def angle_of_root(t: float) -> float:
    if t > RISE:
        return END_SPEED * (t - RISE / 2)
    period = RISE / (2 * np.pi)
    return float(END_SPEED / RISE * (t**2 / 2 + period**2 * (np.cos(t / period) - 1)))


def spun(elements: int, steps: int, end: float = 15.0) -> np.ndarray:
    """Rows of the tip at the times of SPUN, by planar beams on three nodes."""
    mbs = new_system()
    nodes = [
        mbs.AddNode(exu.NodeRigidBody2D(referenceCoordinates=[x, 0, 0]))
        for x in np.linspace(0, LENGTH, 2 * elements + 1)
    ]
    for i in range(elements):
        mbs.AddObject(
            exu.ObjectBeamGeometricallyExact2D(
                physicsLength=LENGTH / elements, nodeNumbers=nodes[2 * i : 2 * i + 3],
                physicsMassPerLength=INERTIA, physicsCrossSectionInertia=6e-4,
                physicsBendingStiffness=1.4e4, physicsAxialStiffness=PULL, physicsShearStiffness=1e7,
            )
        )  # fmt: skip
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    for coordinate in range(3):
        root = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=nodes[0], coordinate=coordinate))
        turn = {"offsetUserFunction": lambda mbs, t, item, offset: angle_of_root(t)} if coordinate == 2 else {}
        mbs.AddObject(exu.CoordinateConstraint(markerNumbers=[ground, root], **turn))
    sensor = mbs.AddSensor(
        exu.SensorNode(nodeNumber=nodes[-1], outputVariableType=Variable.Coordinates, storeInternal=True)
    )
    mbs.Assemble()
    chosen = settings(end, steps, spectral_radius=0.9, tolerance=1e-8)
    chosen.solutionSettings.sensorsWritePeriod = 0.5
    mbs.SolveDynamic(chosen)
    told = mbs.GetSensorStoredData(sensor)
    rows = []
    for t in SPUN:
        x, y, turn = told[round(2 * t), 1:]
        phi = angle_of_root(t)
        c, s = np.cos(phi), np.sin(phi)
        place = np.array([LENGTH + x, y])
        rows.append([c * place[0] + s * place[1] - LENGTH, -s * place[0] + c * place[1], turn - phi])
    return np.array(rows)


def test_spin_up() -> None:
    """The beam lags behind, and comes back to a line that is longer by the centrifugal force."""
    wanted = np.array(list(SPUN.values()))
    coarse, fine = spun(4, 750), spun(8, 3000)
    errors = [np.abs(u - wanted).max(axis=0) for u in (coarse, fine)]
    assert (errors[1] < errors[0] / 8).all()
    assert (np.abs(fine - wanted).max(axis=0) < [2e-5, 3e-4, 4e-5]).all()


# Flap frequencies of a clamped beam that rotates about its root, all made dimensionless with EI and rho A, by speed; lag frequencies
# are less: the square of the speed is missing in their squares.
FLAP = {
    1: (3.6816468, 22.1810112, 61.8417626),
    5: (6.4495447, 25.4460804, 65.2050405),
    10: (11.2023278, 33.6403658, 74.6492946),
}


AT_REST = np.array([1.8751040687, 4.6940911330]) ** 2  # roots of cos x cosh x = -1


def rotating_beam(
    elements: int, node: type = exu.NodeRigidBodyRotVecLG, turn: np.ndarray | None = None, stiff: float = 1e7
) -> exu.MainSystem:
    """Clamped at the origin, along the first axis of `turn`; stiff: E A and G A, where E I is 1."""
    turn, slim = np.eye(3) if turn is None else turn, 1e-6
    rod = Rod(node)
    rod.add_leg(np.zeros(3), turn, 1.0, elements, section([stiff, stiff, stiff, 1, 1, 1], 1.0, [2 * slim, slim, slim]))
    rod.join(rod.ground, rod.marker(rod.nodes[0]), turn)
    return rod.mbs


def rotating_frequencies(elements: int, speed: float) -> np.ndarray:
    found = rotating_beam(elements).ComputeVibrationModes(4, [0, 0, speed])
    assert np.abs(found.eigenvalues.real).max() < 1e-6 * np.abs(found.eigenvalues).max()
    stretch = speed**2 / 3 / 1e7  # by the pull speed^2 (1 - x^2) / 2
    assert found.coordinates[6 * elements] == pytest.approx(stretch, rel=1 / elements**2)
    return found.eigenvalues.imag


@pytest.mark.parametrize("speed", list(FLAP))
def test_frequencies_of_a_rotating_beam(speed: int) -> None:
    """Flap and lag alternate; errors fall with the square of the element length."""
    wanted = np.array(FLAP[speed])
    wanted = np.sort([*wanted, *np.sqrt(wanted**2 - speed**2)])[:4]
    coarse, fine = (rotating_frequencies(n, speed)[:4] for n in (8, 16))
    assert np.log2((coarse - wanted) / (fine - wanted)) == pytest.approx(2 * np.ones(4), abs=0.2)
    assert (4 * fine - coarse) / 3 == pytest.approx(wanted, rel=5e-4)


@pytest.mark.parametrize("node", [exu.NodeRigidBodyRotVecLG, exu.NodeRigidBodyEP])
def test_rotation_about_any_axis(node: type) -> None:
    """Neither the direction of the axis nor the parameters of the rotation show; nodes with unit quaternions have constraints."""
    turn = Rotation.from_rotvec([0.3, -0.8, 1.1]).as_matrix()
    turned = rotating_beam(6, node, turn).ComputeVibrationModes(4, turn[:, 2] * 5)
    wanted = rotating_beam(6).ComputeVibrationModes(4, [0, 0, 5])
    # rounding: extensions of 1e-6 carry the pull, and stiffnesses differ by 1e7
    assert turned.eigenvalues.imag == pytest.approx(wanted.eigenvalues.imag, rel=1e-7)


def test_steady_extension() -> None:
    """tan(aL)/a - L, a^2 = (rho A / EA) w^2, about which the beam goes on to oscillate."""
    a = END_SPEED * np.sqrt(INERTIA / PULL)
    assert np.tan(a * LENGTH) / a - LENGTH == pytest.approx(5.143174550e-4, rel=1e-8)
    assert spun(4, 1500)[-1, 0] == pytest.approx(5.1432e-4, rel=2e-3)


def test_rounding_of_stiff_fine_beams_is_reported() -> None:
    """Errors of frequencies are below the reported ones, and a warning is given if frequencies are lost."""
    for stiff, elements in ((1e7, 100), (1e7, 2000), (1e9, 400)):
        found = rotating_beam(elements, stiff=stiff).ComputeVibrationModes(4)
        errors = np.abs(found.eigenvalues - 1j * np.repeat(AT_REST, 2))
        assert (errors < found.uncertainties + 2 / elements**2 * np.abs(found.eigenvalues)).all()
        assert (found.uncertainties < 0.1 * np.abs(found.eigenvalues)).all()
    with pytest.warns(RuntimeWarning, match="rounding may have moved 4 of 4 eigenvalues by up to"):
        found = rotating_beam(2000, stiff=1e10).ComputeVibrationModes(4)
    assert (found.uncertainties > 0.1 * np.abs(found.eigenvalues)).all()
    assert (np.abs(found.eigenvalues - 1j * np.repeat(AT_REST, 2)) < found.uncertainties).all()
