"""A frame of two beams at a right angle: buckling out of its plane (J. H. Argyris et al. 1979), and its motion (J. C. Simo, L. Vu-Quoc 1988).

References are solutions of the differential equations of the rod: by shooting, and by elements of degree 12.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from rods import Rod, section
from scipy.spatial.transform import Rotation
from solving import Solver, Variable, settings

import dalembert as exu


def frame(leg: float, turn: float, elements: int, of: Any, node: type) -> tuple[Rod, Any, Any]:
    """The rod, the elbow and the tip; the second leg is turned about z."""
    rod = Rod(node)
    elbow = rod.add_leg(np.zeros(3), np.eye(3), leg, elements, of)[-1]
    tip = rod.add_leg([leg, 0, 0], Rotation.from_rotvec([0, 0, turn]).as_matrix(), leg, elements, of)[-1]
    rod.clamp()
    return rod, elbow, tip


# Tip displacements by the load in the plane of the frame, with 1 mN across it; the frame buckles at 1.0875 N.
BUCKLED = {
    1.00: (0.195893292, 0.075347956, 0.846864026),
    1.05: (0.221617766, 0.091857959, 1.690384199),
    1.10: (3.553768381, 2.622825936, 19.275636524),
    1.20: (22.655072997, 17.541463883, 45.679674826),
}


def argyris_frame(elements: int, node: type) -> tuple[Rod, Any, Any]:
    young, area = 71240.0, 18.0
    shear = young / 2.62
    stiffness = [young * area, shear * area, shear * area, 30 * 0.6**3 / 3 * shear]
    of = section([*stiffness, young * 30 * 0.6**3 / 12, young * 0.6 * 30**3 / 12])
    return frame(240.0, -np.pi / 2, elements, of, node)


def buckled(node: type, elements: int) -> np.ndarray:
    """The path of equilibria, which an increasing load follows into the buckled branch: no step fails."""
    rod, _, tip = argyris_frame(elements, node)
    rod.load(tip, exu.Force, [0, 0, 0], loadVectorUserFunction=lambda mbs, t, load: [t, 0, 1e-3])
    motion = exu.SensorNode(nodeNumber=tip, outputVariableType=Variable.Displacement, storeInternal=True)
    sensor = rod.mbs.AddSensor(motion)
    rod.mbs.Assemble()
    chosen = settings(1, 1)
    static = chosen.staticSolver
    static.verboseMode, static.useLoadFactor = 0, False
    static.loadStepDuration, static.numberOfLoadSteps = 1.2, 120
    static.newton.relativeTolerance = 1e-9
    chosen.solutionSettings.sensorsWritePeriod = 0.01
    rod.mbs.SolveStatic(chosen)
    told = rod.mbs.GetSensorStoredData(sensor)
    assert len(told) == 121
    return np.array([told[round(100 * load), 1:] for load in BUCKLED])


@pytest.mark.parametrize("node", [exu.NodeRigidBodyRotVecLG, exu.NodeRigidBodyEP])
def test_lateral_buckling(node: type) -> None:
    """Errors fall with the square of the element length, next to the singular point and beyond it."""
    wanted = np.array(list(BUCKLED.values()))
    coarse, fine, finest = (buckled(node, n) for n in (8, 16, 32))
    errors = [np.linalg.norm(u - wanted, axis=1) for u in (coarse, fine, finest)]
    assert np.log2(errors[1] / errors[2]) == pytest.approx([2, 2, 2, 2], abs=0.06)
    limit = [(4 * b - a) / 3 for a, b in ((coarse, fine), (fine, finest))]
    np.testing.assert_allclose((16 * limit[1] - limit[0]) / 15, wanted, rtol=0, atol=1e-4)


# Displacements of elbow and tip by time.
MOTION = {
    1: ((-0.054196, 0.022882, 0.951314), (-0.003017, -0.023389, 0.054032)),
    2: ((-1.011114, 0.267389, 4.115246), (0.106261, -0.692150, 0.069264)),
    5: ((-0.851796, -0.764270, 3.111415), (-0.540678, -1.062475, 5.479398)),
}


def motion(elements: int, steps: int) -> np.ndarray:
    of = section([1e6] * 3 + [1e3] * 3, 1.0, [20, 10, 10])
    rod, elbow, tip = frame(10.0, np.pi / 2, elements, of, exu.NodeRigidBodyRotVecLG)

    def hat(mbs: Any, t: float, load: Any) -> list[float]:
        return [0, 0, 50 * max(0.0, min(t, 2 - t))]

    rod.load(elbow, exu.Force, [0, 0, 0], loadVectorUserFunction=hat)
    sensors = [
        rod.mbs.AddSensor(exu.SensorNode(nodeNumber=n, outputVariableType=Variable.Displacement, storeInternal=True))
        for n in (elbow, tip)
    ]
    rod.mbs.Assemble()
    chosen = settings(5, steps, tolerance=1e-8)
    chosen.solutionSettings.sensorsWritePeriod = 1
    rod.mbs.SolveDynamic(chosen, solverType=Solver.TrapezoidalIndex2)
    told = [rod.mbs.GetSensorStoredData(sensor) for sensor in sensors]
    return np.array([[data[time, 1:] for data in told] for time in MOTION])


def test_motion_of_the_frame() -> None:
    """Errors of second order in the lengths of elements and steps together, towards the solution of the published
    problem."""
    wanted = np.array(list(MOTION.values()))
    coarse, fine = motion(8, 250), motion(16, 500)
    errors = [float(np.linalg.norm(u - wanted)) for u in (coarse, fine)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.05)
    np.testing.assert_allclose((4 * fine - coarse) / 3, wanted, rtol=0, atol=1.5e-3)
