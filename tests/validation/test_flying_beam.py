"""A free beam that a force and a moment at its end throw and bend in space: "flying spaghetti", J. C. Simo and L. Vu-Quoc, 1988."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from rods import Rod, section
from solving import Solver, Variable, settings

import dalembert as exu

# Positions of both ends and of the middle by time, computed by elements of degree 12.
THROWN = {
    2.5: ((3.41295, 0.19690, 0.01735), (4.02381, 8.49552, -0.73302), (5.83225, 3.94574, 0.12737)),
    5.0: ((19.56276, 1.52133, -1.50769), (11.87883, 6.88136, 1.83002), (15.38436, 3.89904, -0.10442)),
    8.0: ((30.87220, -0.97840, 0.36540), (29.86313, 8.94853, -0.22685), (30.60607, 4.00728, -0.04341)),
}
ENERGY = 884.12685  # J, after the load has ended


class Thrown:
    def __init__(self, elements: int, steps_per_second: int) -> None:
        self.of = section([1e4] * 3 + [500] * 3, 1.0, [10, 10, 10])
        self.rod = rod = Rod()
        axis = np.array([-0.6, 0.8, 0])
        turn = np.column_stack([axis, [-0.8, -0.6, 0], [0, 0, 1]])
        nodes = rod.add_leg([6, 0, 0], turn, 10.0, elements, self.of)

        def hat(t: float) -> float:
            return 80 * max(0.0, min(t, 5 - t))

        rod.load(nodes[0], exu.Force, [0, 0, 0], loadVectorUserFunction=lambda mbs, t, f: [hat(t) / 10, 0, 0])
        rod.load(nodes[0], exu.Torque, [0, 0, 0], loadVectorUserFunction=lambda mbs, t, m: [0, -hat(t) / 2, -hat(t)])
        sensors = [
            rod.mbs.AddSensor(exu.SensorNode(nodeNumber=n, outputVariableType=Variable.Position, storeInternal=True))
            for n in (nodes[0], nodes[-1], nodes[elements // 2])
        ]
        rod.mbs.Assemble()
        chosen = settings(8, 8 * steps_per_second, tolerance=1e-9)
        chosen.solutionSettings.sensorsWritePeriod = 0.5
        rod.mbs.SolveDynamic(chosen, solverType=Solver.TrapezoidalIndex2)
        told = [rod.mbs.GetSensorStoredData(sensor) for sensor in sensors]
        self.places = np.array([[data[round(2 * time), 1:] for data in told] for time in THROWN])

    def momentum_and_energy(self) -> tuple[np.ndarray, float]:
        """Linear shape functions: masses and inertias of an element are those of its halves, at their nodes."""
        mbs, length = self.rod.mbs, 10.0 / len(self.rod.beams)
        velocities, spins = (
            np.array([mbs.GetNodeOutput(n, v) for n in self.rod.nodes])
            for v in (Variable.Velocity, Variable.AngularVelocity)
        )
        shares = np.full(len(velocities), length)
        shares[[0, -1]] /= 2
        kinetic = 0.5 * shares @ ((velocities**2).sum(axis=1) + 10 * (spins**2).sum(axis=1))
        strain = 0.0
        for beam in self.rod.beams:
            strains, curvatures = (
                np.array(mbs.GetObjectOutputBody(beam, v, [0, 0, 0]))
                for v in (Variable.StrainLocal, Variable.CurvatureLocal)
            )
            strain += 0.5 * length * (1e4 * strains @ strains + 500 * curvatures @ curvatures)
        return shares @ velocities, kinetic + strain


def test_flight() -> None:
    """Places of second order in the lengths of elements and steps together; momentum is that of the load, and energy stays."""
    coarse, fine = Thrown(16, 100), Thrown(32, 200)
    wanted = np.array(list(THROWN.values()))
    errors = [float(np.linalg.norm(t.places - wanted)) for t in (coarse, fine)]
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.1)
    np.testing.assert_allclose((4 * fine.places - coarse.places) / 3, wanted, rtol=0, atol=2e-3)
    told: list[Any] = [t.momentum_and_energy() for t in (coarse, fine)]
    for momentum, _ in told:
        np.testing.assert_allclose(momentum, [50, 0, 0], rtol=0, atol=1e-5)
    assert (4 * told[1][1] - told[0][1]) / 3 == pytest.approx(ENERGY, rel=5e-7)
