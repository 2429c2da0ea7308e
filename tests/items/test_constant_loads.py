"""Loads that do not change between the steps of a solution, and those that parameters make change."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu

G = 10.0
END = 0.5
# Return the position of a mass that falls from rest, under a load with this factor; constant accelerations are
# integrated exactly.
FALL = -0.5 * G * END**2


class Falling:
    """A body under its weight, without a spring or with one that pulls it with its stiffness times its fall."""

    def __init__(self, stiffness: float = 0.0) -> None:
        self.system = exu.SystemContainer()
        mbs = self.mbs = self.system.AddSystem()
        self.node = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0]))
        inertia = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]
        body = mbs.AddObject(exu.ObjectRigidBody(physicsMass=2, physicsInertia=inertia, nodeNumber=self.node))
        mass = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
        self.load = mbs.AddLoad(exu.LoadMassProportional(markerNumber=mass, loadVector=[0, 0, -G]))
        ground = mbs.AddObject(exu.ObjectGround())
        ends = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b)) for b in (ground, body)]
        mbs.AddObject(exu.ObjectConnectorCartesianSpringDamper(markerNumbers=ends, stiffness=[stiffness] * 3))
        mbs.Assemble()

    def change(self, name: str, value: Any) -> None:
        self.mbs.SetLoadParameter(self.load, name, value)

    def height(self) -> float:
        settings = exu.SimulationSettings()
        settings.timeIntegration.endTime = END
        settings.timeIntegration.numberOfSteps = 5
        settings.timeIntegration.newton.relativeTolerance = 1e-12
        settings.solutionSettings.writeSolutionToFile = False
        self.mbs.SolveDynamic(settings)
        return float(self.mbs.GetNodeOutput(self.node, exu.OutputVariableType.Position)[2])


def tripled(mbs: Any, t: float, load: list[float]) -> list[float]:
    return [3 * x for x in load]


def test_load_follows_its_parameters() -> None:
    model = Falling()
    # A dozen operations per step, of numbers of the size one.
    close = {"abs": 1e-13}
    assert model.height() == pytest.approx(FALL, **close)
    model.change("loadVector", [0, 0, -2 * G])
    assert model.height() == pytest.approx(2 * FALL, **close)
    model.change("loadVectorUserFunction", tripled)
    assert model.height() == pytest.approx(6 * FALL, **close)
    model.change("loadVectorUserFunction", 0)
    assert model.height() == pytest.approx(2 * FALL, **close)


def test_load_moves_off_the_node_with_the_centre_of_mass() -> None:
    central, eccentric = Falling(), Falling()
    eccentric.mbs.SetObjectParameter(0, "physicsCenterOfMass", [0.1, 0, 0])
    for model in (central, eccentric):
        model.height()
    turn = [model.mbs.GetNodeOutput(model.node, exu.OutputVariableType.Rotation)[1] for model in (central, eccentric)]
    # A uniform field has no torque about the center of mass, so the node falls without rotation.
    np.testing.assert_allclose(turn, [0, 0], rtol=0, atol=1e-13)
    assert eccentric.height() == pytest.approx(FALL, abs=1e-13)


def test_load_keeps_its_marker_for_other_forces() -> None:
    stiffness = 50.0
    model = Falling(stiffness)
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = 4
    settings.staticSolver.newton.relativeTolerance = 1e-12
    settings.solutionSettings.writeSolutionToFile = False
    settings.linearSolverSettings.ignoreSingularJacobian = True  # nothing holds the rotation
    model.mbs.SolveStatic(settings)
    height = model.mbs.GetNodeOutput(model.node, exu.OutputVariableType.Position)[2]
    # Residual below 1e-12 of the weight.
    assert height == pytest.approx(-2 * G / stiffness, abs=1e-12)


def turned(change: bool, points: list[list[float]]) -> list[float]:
    """The rotation after a force has acted at one of the points: set before Assemble, or, one after the other, after it."""
    mbs = exu.SystemContainer().AddSystem()
    node = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0, 0, 0]))
    inertia = [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]
    body = mbs.AddObject(exu.ObjectRigidBody(physicsMass=2, physicsInertia=inertia, nodeNumber=node))
    at = points[0] if change else points[-1]
    marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=at))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[0, 0, 5.0]))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime = 0.1
    settings.timeIntegration.numberOfSteps = 10
    settings.solutionSettings.writeSolutionToFile = False
    for point in points if change else []:
        mbs.SetMarkerParameter(marker, "localPosition", point)
        mbs.SolveDynamic(settings)
    if not change:
        mbs.SolveDynamic(settings)
    return list(mbs.GetNodeOutput(node, exu.OutputVariableType.Rotation))


@pytest.mark.parametrize(
    "points", [[[0, 0, 0], [0.3, 0, 0]], [[0.3, 0, 0], [0, 0, 0]], [[0, 0, 0], [0.3, 0, 0], [0, 0, 0]]]
)
def test_force_acts_where_its_marker_has_moved_to(points: list[list[float]]) -> None:
    # The same operations as in a system that was assembled so.
    assert turned(True, points) == turned(False, points)
    assert any(turned(True, points)) == any(points[-1])
