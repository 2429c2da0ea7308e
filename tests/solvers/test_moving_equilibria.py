"""Static solutions keep velocities: velocity-dependent forces belong to the balance, and are named."""

from __future__ import annotations

from typing import Any

import pytest

import dalembert as exu
from dalembert.itemInterface import (
    CoordinateSpringDamper,
    LoadCoordinate,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodePointGround,
)

STIFFNESS, FORCE = 200.0, 3.0
WORDS = "velocities are not zero"


def oscillator(velocity: float, damping: float) -> tuple[Any, int]:
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    node = mbs.AddNode(Node1D(name="slide", referenceCoordinates=[0], initialVelocities=[velocity]))
    mbs.AddObject(Mass1D(physicsMass=1, nodeNumber=node))
    moving = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    mbs.AddObject(CoordinateSpringDamper(markerNumbers=[ground, moving], stiffness=STIFFNESS, damping=damping))
    mbs.AddLoad(LoadCoordinate(markerNumber=moving, load=FORCE))
    mbs.Assemble()
    return mbs, node


def solve(mbs: Any, node: int) -> float:
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    assert mbs.SolveStatic(settings)
    return float(mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates))


@pytest.mark.parametrize("velocity", [0.5, -2.0])
def test_damping_of_velocities_is_part_of_the_balance_and_named(
    velocity: float, capfd: pytest.CaptureFixture[str]
) -> None:
    mbs, node = oscillator(velocity, damping=10)
    assert solve(mbs, node) == pytest.approx((FORCE - 10 * velocity) / STIFFNESS, rel=1e-12)  # one linear equation
    printed = capfd.readouterr().out
    assert WORDS in printed and "slide" in printed and f"up to {abs(10 * velocity):g} " in printed


@pytest.mark.parametrize(("velocity", "damping"), [(0.0, 10.0), (0.5, 0.0)], ids=["at rest", "undamped"])
def test_velocities_without_effect_are_no_matter(
    velocity: float, damping: float, capfd: pytest.CaptureFixture[str]
) -> None:
    mbs, node = oscillator(velocity, damping)
    assert solve(mbs, node) == pytest.approx(FORCE / STIFFNESS, rel=1e-12)
    assert WORDS not in capfd.readouterr().out


def test_velocities_of_the_start_count(capfd: pytest.CaptureFixture[str]) -> None:
    mbs, node = oscillator(0.0, damping=10)
    mbs.systemData.SetODE2Coordinates_t([0.25], configuration=exu.ConfigurationType.Initial)
    assert solve(mbs, node) == pytest.approx((FORCE - 2.5) / STIFFNESS, rel=1e-12)
    assert WORDS in capfd.readouterr().out
    mbs.systemData.SetODE2Coordinates_t([0.0], configuration=exu.ConfigurationType.Initial)
    assert solve(mbs, node) == pytest.approx(FORCE / STIFFNESS, rel=1e-12)
    assert WORDS not in capfd.readouterr().out
