"""A beam that is spun up (J. C. Simo, L. Vu-Quoc, 1986), and frequencies of beams that rotate."""

from __future__ import annotations

import numpy as np
import pytest
import scipy.linalg
from rods import Rod, section
from solving import Variable, new_system, settings

import dalembert as exu
from dalembert._core import testing

# Of the tip, against the line that rotates rigidly: along it, across it, and the rotation of the section; by an element of degree 10.
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


def rotating_frequencies(elements: int, speed: float) -> np.ndarray:
    """Small motions x of a beam that rotates about z, seen in its own axes. With the spin w, coordinates move by T x, where rates are
    x_t + W x and accelerations x_tt + 2 W x_t + W^2 x for translations, x_tt + W x_t for rotations, which are in axes of the nodes."""
    slim = 1e-6
    of = section([1e7, 1e7, 1e7, 1, 1, 1], 1.0, [2 * slim, slim, slim])
    rod = Rod()
    nodes = rod.add_leg(np.zeros(3), np.eye(3), 1.0, elements, of)
    mbs = rod.mbs
    for node in nodes:
        x = mbs.GetNodeOutput(node, Variable.Position, exu.ConfigurationType.Reference)[0]
        # the pull of the centrifugal force, speed^2 (1 - x^2) / 2, stretches the beam
        stretch = speed**2 * (x - x**3 / 3) / 2 / 1e7
        mbs.SetNodeParameter(node, "initialCoordinates", [stretch, 0, 0, 0, 0, 0])
    mbs.Assemble()
    state = testing.State(mbs)
    n = len(nodes)
    for i in range(n):
        place = i / (n - 1) + state.q[6 * i]
        for name, values in (("v", [0, speed * place, 0, 0, 0, speed]), ("a", [-(speed**2) * place, 0, 0, 0, 0, 0])):
            numbers = np.array(getattr(state, name))
            numbers[6 * i : 6 * i + 6] = values
            setattr(state, name, numbers)
    k, d, m = (
        np.array(testing.tangent(mbs, state, cq=float(i == 0), cv=float(i == 1), ca=float(i == 2))) for i in range(3)
    )
    spin = np.kron(np.eye(2 * n), speed * np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 0]]))
    is_translation = np.kron(np.eye(n), np.diag([1.0, 1, 1, 0, 0, 0]))
    gyroscopic = d + m @ spin @ (np.eye(6 * n) + is_translation)
    stiffness = k + d @ spin + m @ spin @ spin @ is_translation
    free = slice(6, None)
    a, b, c = stiffness[free, free], gyroscopic[free, free], m[free, free]
    lower = scipy.linalg.solve(c, np.hstack([-a, -b]), assume_a="pos")
    values = scipy.linalg.eigvals(np.vstack([np.eye(len(a), 2 * len(a), len(a)), lower]))
    assert np.abs(values.real).max() < 1e-6 * np.abs(values.imag).max()
    return np.sort(values.imag[values.imag > 1e-3])


@pytest.mark.parametrize("speed", list(FLAP))
def test_frequencies_of_a_rotating_beam(speed: int) -> None:
    """Flap and lag alternate; errors fall with the square of the element length."""
    wanted = np.array(FLAP[speed])
    wanted = np.sort([*wanted, *np.sqrt(wanted**2 - speed**2)])[:4]
    coarse, fine = (rotating_frequencies(n, speed)[:4] for n in (8, 16))
    assert np.log2((coarse - wanted) / (fine - wanted)) == pytest.approx(2 * np.ones(4), abs=0.2)
    assert (4 * fine - coarse) / 3 == pytest.approx(wanted, rel=5e-4)


def test_steady_extension() -> None:
    """tan(aL)/a - L, a^2 = (rho A / EA) w^2, about which the beam goes on to oscillate."""
    a = END_SPEED * np.sqrt(INERTIA / PULL)
    assert np.tan(a * LENGTH) / a - LENGTH == pytest.approx(5.143174550e-4, rel=1e-8)
    assert spun(4, 1500)[-1, 0] == pytest.approx(5.1432e-4, rel=2e-3)
