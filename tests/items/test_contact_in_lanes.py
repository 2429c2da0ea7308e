"""Contact of spheres has the same bits in registers of any width: its products and sums are not fused, those of rotations are."""

from __future__ import annotations

import numpy as np
import pytest
from registers import each_width, numbers_in_registers

HEAP = """
import numpy as np
import dalembert as exu
from dalembert.utilities import InertiaSphere

def accelerations(turns, surfaces, steps):
    mbs = exu.SystemContainer().AddSystem()
    contact, rng = mbs.AddGeneralContact(), np.random.default_rng(3)
    contact.SetFrictionPairings([[0.3]])
    for k, place in enumerate(np.mgrid[0:5, 0:5, 0:3].reshape(3, -1).T):
        motion = {
            "referencePosition": 0.195 * place + rng.uniform(-0.005, 0.005, 3),
            "initialVelocity": rng.uniform(-1, 1, 3),
        }
        spin = rng.uniform(-5, 5, 3)
        if turns:
            body = mbs.CreateRigidBody(
                **motion,
                inertia=InertiaSphere(1, 0.1),
                initialAngularVelocity=spin,
                nodeType=exu.NodeType.RotationRotationVector,
            )
        else:
            body = mbs.CreateMassPoint(**motion, physicsMass=1)
        kind = exu.MarkerNodeRigid if turns else exu.MarkerNodePosition
        marker = mbs.AddMarker(kind(nodeNumber=mbs.GetObject(body)["nodeNumber"]))
        contact.AddSphereWithMarker(marker, 0.1, 2e4 + 1e3 * (k % surfaces), 3, 0)
    mbs.Assemble()
    s = exu.SimulationSettings()
    s.solutionSettings.writeSolutionToFile = False
    s.timeIntegration.numberOfSteps, s.timeIntegration.endTime, s.timeIntegration.verboseMode = steps, 2e-4 * steps, 0
    mbs.SolveDynamic(s, solverType=exu.DynamicSolverType.ExplicitEuler)
    return mbs.systemData.GetODE2Coordinates_tt()

for turns, steps in ((False, 100), (True, 1)):
    for surfaces in (1, 2):
        print(*(x.hex() for x in accelerations(turns, surfaces, steps)))
"""


@each_width
def test_contact_with_friction(wide: str) -> None:
    expected, found = (numbers_in_registers(HEAP, name) for name in ("portable", wide))
    points, bodies = found[:2], found[2:]
    assert all(np.array_equal(some, others) for some, others in zip(points, expected[:2], strict=True))
    for some, others in zip(bodies, expected[2:], strict=True):
        assert np.abs(some - others).max() < 1e-14 * np.abs(others).max()  # some roundings
    assert [some.size for some in found] == [3 * 75, 3 * 75, 6 * 75, 6 * 75]
    assert np.abs(bodies[0].reshape(-1, 6)).max(axis=0) == pytest.approx([300] * 3 + [3000] * 3, rel=0.9)
