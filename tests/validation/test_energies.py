"""Energies of systems against closed forms, and the page about a system."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import Variable, new_system, settings

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

NODES = [
    exu.NodeType.RotationEulerParameters,
    exu.NodeType.RotationRxyz,
    exu.NodeType.RotationRotationVector,
]
GRAVITY = np.array([0.3, -9.81, 2.0])


@pytest.mark.parametrize("node", NODES)
def test_a_free_body(node: Any) -> None:
    """It turns and falls: m v^2 / 2 + w J w / 2 - m g x, whichever parameters its rotation has."""
    mbs = new_system()
    turn = Rotation.from_rotvec([0.3, -0.4, 0.2])
    inertia = InertiaCuboid(1000, [1, 0.2, 0.3])
    body = mbs.CreateRigidBody(
        inertia=inertia,
        referenceRotationMatrix=turn.as_matrix(),
        initialVelocity=[1, 2, 3],
        initialAngularVelocity=[2, -3, 1],
        gravity=GRAVITY,
        nodeType=node,
    )
    mbs.Assemble()
    s = settings(0.7, 700)
    mbs.SolveDynamic(s)
    place, velocity, spin = (
        np.asarray(mbs.GetObjectOutputBody(body, variable, [0, 0, 0]))
        for variable in (Variable.Position, Variable.Velocity, Variable.AngularVelocityLocal)
    )
    found = mbs.ComputeEnergies()
    kinetic = inertia.Mass() * velocity @ velocity / 2 + spin @ inertia.InertiaCOM() @ spin / 2
    assert found.kinetic == pytest.approx(kinetic, rel=1e-10)
    assert found.potential == pytest.approx(-inertia.Mass() * GRAVITY @ place, rel=1e-10)
    assert found.total == pytest.approx(found.kinetic + found.potential) and found.potentialError < 1e-9
    assert found.dissipatedPower == pytest.approx(0, abs=1e-5 * kinetic)
    assert found.kineticPerNode == {0: pytest.approx(kinetic)}


@pytest.mark.parametrize("node", NODES)
def test_a_pendulum_on_a_spring(node: Any) -> None:
    """The weight far from the axis, a spring and a damper at the end: potential and power from lengths and their rates."""
    mbs = new_system()
    ground = mbs.CreateGround()
    inertia = InertiaCuboid(1000, [1, 0.2, 0.3])
    body = mbs.CreateRigidBody(referencePosition=[0.5, 0, 0], inertia=inertia, gravity=GRAVITY, nodeType=node)
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0.1, 0.2, 1])
    stiffness, damping, length, anchor = 3000.0, 40.0, 0.8, np.array([1.5, 1.0, 0.3])
    mbs.CreateSpringDamper(
        bodyNumbers=[ground, body],
        localPosition0=anchor,
        localPosition1=[0.5, 0, 0],
        referenceLength=length,
        stiffness=stiffness,
        damping=damping,
    )
    mbs.Assemble()

    def spring() -> tuple[float, float]:
        end, velocity = (
            np.asarray(mbs.GetObjectOutputBody(body, variable, [0.5, 0, 0]))
            for variable in (Variable.Position, Variable.Velocity)
        )
        span = np.linalg.norm(end - anchor)
        return float(span), float((end - anchor) @ velocity / span)

    def potential() -> float:
        place = np.asarray(mbs.GetObjectOutputBody(body, Variable.Position, [0, 0, 0]))
        return float(stiffness / 2 * (spring()[0] - length) ** 2 - inertia.Mass() * GRAVITY @ place)

    start = potential()
    mbs.SolveDynamic(settings(0.5, 500))
    found = mbs.ComputeEnergies()
    assert found.potential == pytest.approx(potential() - start, rel=1e-9)
    assert found.dissipatedPower == pytest.approx(damping * spring()[1] ** 2, rel=1e-4)


def test_a_cantilever() -> None:
    """A load that grows slowly stores half of force times deflection; all of the force counts as a load at its end."""
    mbs = new_system()
    cable = exu.beams.GenerateStraightLineANCFCable2D(
        mbs,
        [0, 0, 0],
        [2, 0, 0],
        8,
        exu.itemInterface.ObjectANCFCable2D(
            physicsMassPerLength=1.0, physicsBendingStiffness=100.0, physicsAxialStiffness=1e6
        ),
        massProportionalLoad=[0, 0, 0],
        fixedConstraintsNode0=[1, 1, 0, 1],
    )
    tip = mbs.AddMarker(exu.itemInterface.MarkerNodePosition(nodeNumber=cable[0][-1]))
    mbs.AddLoad(exu.itemInterface.LoadForceVector(markerNumber=tip, loadVector=[0, -0.1, 0]))
    mbs.Assemble()
    s = settings(1, 1)
    s.staticSolver.verboseMode = 0
    mbs.SolveStatic(s)
    deflection = mbs.GetNodeOutput(cable[0][-1], Variable.Displacement)[1]
    assert deflection == pytest.approx(-0.1 * 2**3 / 300, rel=1e-3)
    assert mbs.ComputeEnergies().potential == pytest.approx(0.1 * deflection / 2, rel=1e-3)


def test_the_page_about_a_door() -> None:
    mbs = new_system()
    ground = mbs.CreateGround()
    door = mbs.CreateRigidBody(referencePosition=[0.5, 0, 0], inertia=InertiaCuboid(100, [1, 0.1, 2]), gravity=GRAVITY)
    for height in (-0.5, 0.5):
        mbs.CreateRevoluteJoint(
            name=f"hinge {height}", bodyNumbers=[ground, door], position=[0, 0, height], axis=[0, 0, 1]
        )
    page = mbs.Report()
    assert "degrees of freedom: 1; redundant constraint equations: 5" in page and ", mass 20 kg" in page
    assert "'hinge 0.5': 5 of 5 equations are removable" in page and "constraints: closed" in page
    mbs.SolveDynamic(settings(0.1, 10))
    page = mbs.Report()
    assert "implicit second order time integration: finished; 10 steps to time 0.1 s, 20 Newton iterations" in page
    assert f"kinetic {mbs.ComputeEnergies().kinetic:.6g} J" in page


def test_the_report_shows_the_drift_of_energy() -> None:
    """A mass that a damper slows down, from 3 m/s by exp(-d t / m)."""
    mbs = new_system()
    node = mbs.AddNode(exu.itemInterface.Node1D(referenceCoordinates=[0], initialVelocities=[3]))
    mbs.AddObject(exu.itemInterface.Mass1D(nodeNumber=node, physicsMass=2))
    markers = [
        mbs.AddMarker(exu.itemInterface.MarkerNodeCoordinate(nodeNumber=n, coordinate=0))
        for n in (mbs.AddNode(exu.itemInterface.NodePointGround()), node)
    ]
    mbs.AddObject(exu.itemInterface.ObjectConnectorCoordinateSpringDamper(markerNumbers=markers, damping=0.5))
    mbs.Assemble()
    assert "drift" not in mbs.Report()  # nothing has moved
    mbs.SolveDynamic(settings(1, 100))
    drift, share = (
        next(line for line in mbs.Report().splitlines() if "drift since the initial state" in line)
        .split(": ")[1]
        .split(";")[0]
        .split(" J, ")
    )
    lost = 9 * (np.exp(-0.5) - 1)
    assert float(drift) == pytest.approx(lost, rel=2e-3)  # three digits
    assert float(share.split()[0]) == pytest.approx(-lost / 9, rel=2e-2)  # two digits


def test_contacts_that_were_open_at_the_reference() -> None:
    """A ball in the groove of a ring, without friction: the energy of the contact is that of its penetration, k d^2 / 2."""
    stiffness, gap = 1e4, 0.2
    mbs = new_system()
    ball = mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [0.1] * 3), referencePosition=[1, 0, 0], initialVelocity=[2, 0.5, 1]
    )
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body)) for body in (ball, mbs.CreateGround())]
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[gap, 0, 0, 0]))
    contact = mbs.AddObject(
        exu.ObjectContactSphereTorus(
            markerNumbers=markers,
            nodeNumber=data,
            radiusSphere=0.1,
            torusMajorRadius=1,
            torusMinorRadius=0.1 + gap,
            torusAxis=[0, 0, 1],
            contactStiffness=stiffness,
        )
    )
    mbs.Assemble()
    start = mbs.ComputeEnergies()
    s = settings(0.1, 1000)
    mbs.SolveDynamic(s)
    depth = -float(mbs.GetObjectOutput(contact, Variable.DisplacementLocal))
    assert depth > 0.005
    end = mbs.ComputeEnergies()
    # The force has a kink where contact begins: errors of the quadrature, 2e-5 of the energy.
    assert end.potential == pytest.approx(stiffness * depth**2 / 2, rel=1e-4)
    assert end.total == pytest.approx(start.total, rel=1e-4)


def test_a_warning_names_sticking_friction() -> None:
    """The bristle of a sliding friction has moved by much more than its elastic deflection, whose energy is below 1 mJ."""
    mbs = new_system()
    node = mbs.AddNode(exu.Node1D(name="slider", referenceCoordinates=[0], initialVelocities=[1]))
    mbs.AddObject(exu.Mass1D(physicsMass=2, nodeNumber=node))
    ends = [mbs.AddNode(exu.NodePointGround()), node]
    markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=each, coordinate=0)) for each in ends]
    history = mbs.AddNode(exu.NodeGenericData(initialCoordinates=[0, 0, 0], numberOfDataCoordinates=3))
    friction = mbs.AddObject(
        exu.CoordinateSpringDamperExt(
            markerNumbers=markers,
            nodeNumber=history,
            fDynamicFriction=4,
            stickingStiffness=1e4,
            frictionProportionalZone=0,
        )
    )
    mbs.Assemble()
    mbs.SolveDynamic(settings(0.05, 500))
    with pytest.warns(RuntimeWarning, match="ComputeEnergies: forces on node 0 'slider'.*sticking friction"):
        mbs.ComputeEnergies()
    mbs.SetObjectParameter(friction, "fDynamicFriction", 0)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert mbs.ComputeEnergies().potential == 0
