"""Chains of spatial beams along any line."""

import numpy as np
import pytest

import dalembert as exu
from dalembert import beams
from dalembert.itemInterface import LoadForceVector, MarkerNodeRigid, ObjectBeamGeometricallyExact
from dalembert.rigidBodyUtilities import RotationVector2RotationMatrix

LENGTH = 2.0


def section():
    result = exu.BeamSection()
    result.stiffnessMatrix = np.diag([1e5, 4e4, 3e4, 20.0, 40.0, 60.0])
    result.massPerLength, result.inertia = 1.0, 1e-3 * np.eye(3)
    return result


def bent(direction, force):
    """Displacement of the tip in the axes of the clamped end; the force is given in them, too."""
    mbs = exu.SystemContainer().AddSystem()
    start, end = np.array([1.0, 2.0, 3.0]), np.array([1.0, 2.0, 3.0]) + LENGTH * np.array(direction)
    template = ObjectBeamGeometricallyExact(sectionData=section())
    chain = beams.GenerateStraightBeam(mbs, start.tolist(), end.tolist(), 8, template, [0, 0, 0], [1] * 6)
    assert [len(part) for part in chain] == [9, 8, 0, 9, 6]
    turn = np.array(RotationVector2RotationMatrix(mbs.GetNode(chain[0][0])["referenceCoordinates"][3:]))
    tip = mbs.AddMarker(MarkerNodeRigid(nodeNumber=chain[0][-1]))
    mbs.AddLoad(LoadForceVector(markerNumber=tip, loadVector=turn @ force))
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.staticSolver.verboseMode = 0
    mbs.SolveStatic(settings)
    np.testing.assert_allclose(turn @ [1, 0, 0], direction, rtol=0, atol=1e-12)
    return turn.T @ mbs.GetNodeOutput(chain[0][-1], exu.OutputVariableType.Displacement)


@pytest.mark.parametrize("direction", [[0, 0, 1], [0, -1, 0], [-1, 0, 0], [0.6, 0, -0.8], [2 / 3, -1 / 3, 2 / 3]])
def test_a_cantilever_bends_in_all_directions_alike(direction):
    force = np.array([0.1, 0.5, -0.7])
    along_x = bent([1, 0, 0], force)
    np.testing.assert_allclose(bent(direction, force), along_x, rtol=0, atol=1e-9)
    assert along_x[1] == pytest.approx(0.5 * LENGTH**3 / (3 * 60.0), rel=0.01)
    assert along_x[2] == pytest.approx(-0.7 * LENGTH**3 / (3 * 40.0), rel=0.01)
