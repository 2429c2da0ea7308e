"""Paths of equilibria by their length: over limit points, through bifurcation points, along branches."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq
from solving import Variable, new_system
from test_right_angle_frame import BUCKLED, argyris_frame

import dalembert as exu
from dalembert.solver import SolverError

HALF, RIGIDITY = 1.0, 1000.0  # half the distance of the supports (m), stiffness of each bar (N/m)


class Truss:
    """Two bars of a linear law that meet at a height (L. von Mises, 1923), pushed down by a force."""

    def __init__(self, height: float, load: float, held: bool = True, user_function: bool = False) -> None:
        self.height, self.mbs = height, new_system()
        self.length = float(np.hypot(HALF, height))
        node = self.mbs.AddNode(exu.NodePoint(referenceCoordinates=[0, height, 0]))
        self.mbs.AddObject(exu.MassPoint(physicsMass=1, nodeNumber=node))
        apex = self.mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
        for x in (-HALF, HALF):
            support = self.mbs.AddNode(exu.NodePointGround(referenceCoordinates=[x, 0, 0]))
            markers = [self.mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=support)), apex]
            self.mbs.AddObject(exu.SpringDamper(markerNumbers=markers, stiffness=RIGIDITY, referenceLength=self.length))
        ground = self.mbs.AddMarker(
            exu.MarkerNodeCoordinate(nodeNumber=self.mbs.AddNode(exu.NodePointGround()), coordinate=0)
        )
        for coordinate in (0, 2) if held else (2,):
            markers = [ground, self.mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=coordinate))]
            self.mbs.AddObject(exu.CoordinateConstraint(markerNumbers=markers))
        growing = {"loadVectorUserFunction": lambda mbs, t, vector: [0, -load * t, 0]} if user_function else {}
        self.mbs.AddLoad(exu.Force(markerNumber=apex, loadVector=[0, -load, 0], **growing))
        self.sensor = self.mbs.AddSensor(
            exu.SensorNode(nodeNumber=node, outputVariableType=Variable.Position, storeInternal=True)
        )
        self.mbs.Assemble()

    def force(self, y: Any) -> Any:
        """Equilibrium with the apex at height y in the middle."""
        return 2 * RIGIDITY * (self.length / np.hypot(HALF, y) - 1) * y

    def limit(self) -> float:
        """The height at which the force is largest: (y^2 + b^2)^3 = (L b^2)^2."""
        return float(np.sqrt((self.length * HALF**2) ** (2 / 3) - HALF**2))

    def sway(self) -> float:
        """The height at which the apex may as well move aside: the sum of geometric and elastic stiffness vanishes, l^3 = L y^2."""
        return float(brentq(lambda y: (y**2 + HALF**2) ** 1.5 - self.length * y**2, self.limit(), self.height))


def path_settings(steps: int = 20, **arc_length: Any) -> exu.SimulationSettings:
    chosen = exu.SimulationSettings()
    chosen.solutionSettings.writeSolutionToFile = False
    chosen.staticSolver.verboseMode = 0
    chosen.staticSolver.numberOfLoadSteps = steps
    chosen.staticSolver.newton.relativeTolerance = 1e-10
    chosen.staticSolver.arcLength.active = True
    for name, value in arc_length.items():
        setattr(chosen.staticSolver.arcLength, name, value)
    return chosen


def singular_points(mbs: exu.MainSystem) -> list[dict[str, Any]]:
    return mbs.sys["staticSolver"].GetSingularPoints()


@pytest.mark.parametrize("user_function", [False, True])
def test_snap_through(user_function: bool) -> None:
    """The load rises, falls below zero and rises again, and agrees with the closed form at each step; limit points are
    met exactly."""
    truss = Truss(0.5, 200.0, user_function=user_function)
    chosen = path_settings()
    chosen.staticSolver.useLoadFactor = not user_function
    truss.mbs.SolveStatic(chosen)
    load, _, y, _ = truss.mbs.GetSensorStoredData(truss.sensor).T
    assert load * 200 == pytest.approx(truss.force(y), abs=1e-9)
    assert (np.diff(y) < 0).all()
    assert load[-1] == 1
    assert truss.force(y[-1]) == pytest.approx(200, rel=1e-9)
    assert y[-1] < -0.5
    points = singular_points(truss.mbs)
    assert [p["type"] for p in points] == ["limit", "limit"]
    highest = truss.force(truss.limit()) / 200
    assert [p["loadFactor"] for p in points] == pytest.approx([highest, -highest], rel=1e-12)
    assert y[[p["step"] for p in points]] == pytest.approx(np.array([1, -1]) * truss.limit(), rel=1e-6)
    assert points[0]["mode"] == pytest.approx([0, 1, 0], abs=1e-9)


def test_load_steps_jump_where_the_path_goes_on() -> None:
    """Load steps without arc length jump from the limit load to the other side."""
    truss = Truss(0.5, 200.0)
    chosen = path_settings(200)
    chosen.staticSolver.arcLength.active = False
    truss.mbs.SolveStatic(chosen)
    y = truss.mbs.GetSensorStoredData(truss.sensor)[:, 2]
    assert np.abs(np.diff(y)).max() > 0.9


def test_path_that_ends_below() -> None:
    truss = Truss(0.5, 200.0)
    truss.mbs.SolveStatic(path_settings(lowestLoadFactor=-0.1))
    load, _, y, _ = truss.mbs.GetSensorStoredData(truss.sensor).T
    assert load[-1] == pytest.approx(-0.1, abs=1e-15)
    assert truss.force(y[-1]) == pytest.approx(-20, rel=1e-9)


@pytest.mark.parametrize("side", [0, 1, -1])
def test_sway_of_a_steep_truss(side: int) -> None:
    """The apex goes aside long before the limit load; both bars are in equilibrium with the load before and on the
    branch."""
    truss = Truss(3.0, 3000.0, held=False)
    truss.mbs.SolveStatic(path_settings(40, branchStep=0.1 * side, lowestLoadFactor=0.0))
    load, x, y, _ = truss.mbs.GetSensorStoredData(truss.sensor).T
    first = singular_points(truss.mbs)[0]
    assert first["type"] == "bifurcation"
    assert first["loadFactor"] * 3000 == pytest.approx(truss.force(truss.sway()), rel=1e-8)
    assert np.abs(first["mode"]) == pytest.approx([1, 0, 0], abs=1e-6)
    before = np.arange(len(load)) <= first["step"]
    assert np.abs(x[before]).max() < 1e-6
    bars = [np.hypot(x + s * HALF, y) for s in (1, -1)]
    pushes = [RIGIDITY * (truss.length / bar - 1) for bar in bars]
    assert 3000 * load == pytest.approx((pushes[0] + pushes[1]) * y, abs=1e-6)
    assert pushes[0] * (x + HALF) + pushes[1] * (x - HALF) == pytest.approx(np.zeros(len(x)), abs=1e-6)
    aside = x[~before] * np.sign(first["mode"][0])
    if side == 0:
        assert np.abs(aside).max() < 1e-6
    else:
        assert aside[0] == pytest.approx(0.1 * side, rel=0.05)
        assert (aside * side > 0.05).all()


def frame_path(elements: int, load: float, across: float = 0.0, **arc_length: Any) -> tuple[np.ndarray, list[Any]]:
    """The tip by the load on the frame of Argyris, with a constant force across its plane."""
    rod, _, tip = argyris_frame(elements, exu.NodeRigidBodyRotVecLG)
    rod.load(tip, exu.Force, [0, 0, 0], loadVectorUserFunction=lambda mbs, t, vector: [load * t, 0, across])
    motion = exu.SensorNode(nodeNumber=tip, outputVariableType=Variable.Displacement, storeInternal=True)
    sensor = rod.mbs.AddSensor(motion)
    rod.mbs.Assemble()
    chosen = path_settings(10, **arc_length)
    chosen.staticSolver.newton.relativeTolerance = 1e-9
    chosen.staticSolver.useLoadFactor = False
    rod.mbs.SolveStatic(chosen)
    return rod.mbs.GetSensorStoredData(sensor), singular_points(rod.mbs)


@pytest.mark.parametrize(("load", "wanted"), [(1.2, 1.087517937764), (-0.8, -0.680427409360)])
def test_lateral_buckling_of_a_frame(load: float, wanted: float) -> None:
    """Errors of the load at the bifurcation fall with the square of the element length."""
    errors = []
    for elements in (8, 16, 32):
        told, points = frame_path(elements, load)
        assert [p["type"] for p in points] == ["bifurcation"]
        assert np.abs(told[:, 3]).max() < 1e-6
        errors.append(points[0]["loadFactor"] * load / wanted - 1)
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.05)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(2, abs=0.05)
    assert abs(4 * errors[2] - errors[1]) / 3 < 2e-6


def test_path_of_ten_thousand_unknowns() -> None:
    """The number of steps is that of few elements; the error of the mesh is 2e-7 there, and rounding leaves as much."""
    told, points = frame_path(840, 1.2)
    assert len(told) == len(frame_path(32, 1.2)[0])
    assert [p["type"] for p in points] == ["bifurcation"]
    assert points[0]["loadFactor"] * 1.2 == pytest.approx(1.087517937764, rel=5e-7)


def test_post_buckling_of_a_frame() -> None:
    """Branch of the perfect frame, and path of one with a transverse force of 1 mN: far above, both meet."""
    told = {branch: frame_path(16, 1.2, branchStep=branch)[0] for branch in (1.0, -1.0)}
    assert told[1.0][-1, 3] == pytest.approx(-told[-1.0][-1, 3], rel=1e-6)
    coarse, pushed = (frame_path(elements, 1.2, across=1e-3)[0] for elements in (8, 16))
    assert len(pushed) < 150
    # errors fall with the square of the element length: see test_right_angle_frame
    assert (4 * pushed[-1, 1:] - coarse[-1, 1:]) / 3 == pytest.approx(BUCKLED[1.20], rel=2e-3)
    # the push itself moves the tip by less than a hundredth there
    assert abs(told[1.0][-1, 3]) == pytest.approx(pushed[-1, 3], rel=1e-2)


def test_path_that_meets_no_end() -> None:
    truss = Truss(0.5, 200.0)
    with pytest.raises(SolverError, match="the path of equilibria has not met one of its ends in step 8") as failed:
        truss.mbs.SolveStatic(path_settings(maximumSteps=8))
    assert failed.value.reason == "pathTooLong"
    assert "arcLength.maximumSteps" in str(failed.value)


def test_refusals() -> None:
    chosen = path_settings()
    chosen.staticSolver.loadStepGeometric = True
    with pytest.raises(ValueError, match="arcLength.active: received True with loadStepGeometric=True"):
        Truss(0.5, 200.0).mbs.SolveStatic(chosen)
    chosen = path_settings()
    chosen.staticSolver.stabilizerODE2term = 1.0
    with pytest.raises(ValueError, match="arcLength.active: received True with stabilizerODE2term"):
        Truss(0.5, 200.0).mbs.SolveStatic(chosen)
    with pytest.raises(RuntimeError, match="needs loads that move the system"):
        Truss(0.5, 0.0).mbs.SolveStatic(path_settings())
