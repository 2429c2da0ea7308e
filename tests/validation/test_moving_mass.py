"""A mass that runs along a beam between two hinges, on a sliding joint, against modes that carry it: L. Fryba, Vibration of solids and
structures under moving loads, 1972."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from solving import Variable, new_system, settings

import dalembert as exu
from dalembert.beams import GenerateSlidingJoint, GenerateStraightLineANCFCable2D

LENGTH, DENSITY, STIFFNESS, MASS, SPEED, WEIGHT = 4.0, 2.0, 4000.0, 3.0, 8.0, 1e-2  # m, kg/m, N m^2, kg, m/s, m/s^2
END = 0.45  # s; the mass is at 90 percent of the beam then


def of_modes(count: int) -> tuple[float, float]:
    """Deflections of the middle and of the mass at the end: sine modes, coupled by the mass under them."""
    number = np.arange(1, count + 1)
    wave = number * np.pi / LENGTH
    own = np.sqrt(STIFFNESS / DENSITY) * wave**2
    share = 2 * MASS / (DENSITY * LENGTH)

    def rates(t: float, state: np.ndarray) -> np.ndarray:
        q, v = state[:count], state[count:]
        shape, slope, bend = (
            np.sin(wave * SPEED * t),
            wave * np.cos(wave * SPEED * t),
            -(wave**2) * np.sin(wave * SPEED * t),
        )
        # deflection of the mass: w_tt + 2 v w_xt + v^2 w_xx
        carried = 2 * SPEED * slope @ v + SPEED**2 * bend @ q
        force = -(own**2) * q - share * shape * (WEIGHT + carried)
        # J. Sherman, W. Morrison: inverse of the mass matrix 1 + share shape shape^T
        return np.concatenate([v, force - share * (shape @ force) / (1 + share * shape @ shape) * shape])

    end = solve_ivp(rates, (0, END), np.zeros(2 * count), method="DOP853", rtol=1e-9, atol=1e-16).y[:count, -1]
    return float(np.sin(wave * LENGTH / 2) @ end), float(np.sin(wave * SPEED * END) @ end)


def of_cable(elements: int, steps: int) -> tuple[float, float]:
    mbs = new_system()
    template = exu.ObjectANCFCable2D(
        physicsMassPerLength=DENSITY, physicsBendingStiffness=STIFFNESS, physicsAxialStiffness=1e7
    )
    nodes, cables, *_ = GenerateStraightLineANCFCable2D(
        mbs, [0, 0, 0], [LENGTH, 0, 0], elements, template,
        fixedConstraintsNode0=[1, 1, 0, 0], fixedConstraintsNode1=[0, 1, 0, 0],
    )  # fmt: skip
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0, 0], initialVelocities=[SPEED, 0]))
    mass = mbs.AddObject(exu.MassPoint2D(physicsMass=MASS, nodeNumber=node))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mass))
    mbs.AddLoad(exu.Force(markerNumber=marker, loadVector=[0, -MASS * WEIGHT, 0]))
    GenerateSlidingJoint(mbs, cables, marker)
    mbs.Assemble()
    mbs.SolveDynamic(settings(END, steps))
    place = np.array(mbs.GetNodeOutput(node, Variable.Position))
    assert place[0] == pytest.approx(SPEED * END, rel=1e-6)
    return float(mbs.GetNodeOutput(nodes[elements // 2], Variable.Displacement)[1]), float(place[1])


def test_moving_mass() -> None:
    wanted = np.array(of_modes(20))
    assert np.abs(np.array(of_modes(10)) - wanted).max() < 2e-3 * np.abs(wanted).max()
    found = np.array(of_cable(16, 1800))
    assert np.abs(wanted).min() > 1e-7
    assert found == pytest.approx(wanted, abs=1e-3 * np.abs(wanted).max())
