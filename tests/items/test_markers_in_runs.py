"""Markers at nodes that follow each other are evaluated as one run: an item does not depend on the others."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as eii

COUNT = 6
AT_NODE, BESIDE = [0.0, 0.0, 0.0], [0.02, -0.03, 0.05]
NODES = [eii.NodeRigidBodyRotVecLG, eii.NodeRigidBodyEP, eii.NodeRigidBodyRxyz]


def bodies(node_type: Any, marker_type: Any, local: list[list[float]]) -> Any:
    """Bodies that turn, each on a spring and a turning spring at its marker, where there is one."""
    rng, mbs = np.random.default_rng(3), exu.SystemContainer().AddSystem()
    ground = mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=mbs.AddObject(eii.ObjectGround())))
    rotation = [1.0, 0.0, 0.0, 0.0] if node_type is eii.NodeRigidBodyEP else [0.0] * 3
    objects = []
    for place in rng.uniform(-1, 1, (COUNT, 3)):
        node = mbs.AddNode(node_type(referenceCoordinates=[*place, *rotation]))
        objects.append(
            mbs.AddObject(
                eii.ObjectRigidBody(physicsMass=2, physicsInertia=[0.01, 0.02, 0.03, 0, 0, 0], nodeNumber=node)
            )
        )
    for body, place in zip(objects, local, strict=True):
        mbs.AddMarker(marker_type(bodyNumber=body, localPosition=place))
    for k in range(COUNT):
        markers: list[Any] = [ground, 1 + k]
        if marker_type is eii.MarkerBodyRigid:
            mbs.AddObject(
                eii.ObjectConnectorRigidBodySpringDamper(
                    markerNumbers=markers, stiffness=np.diag([100.0 + k] * 3 + [0.5] * 3), damping=np.diag([1.0] * 6)
                )
            )
        else:
            mbs.AddObject(
                eii.ObjectConnectorCartesianSpringDamper(
                    markerNumbers=markers, stiffness=[100.0 + k] * 3, damping=[1.0] * 3
                )
            )
    mbs.Assemble()
    return mbs


def motion(mbs: Any) -> np.ndarray:
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.numberOfSteps = 20
    settings.timeIntegration.endTime = 0.02
    settings.timeIntegration.verboseMode = 0
    mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.RK44)
    return np.concatenate([mbs.GetNodeOutput(i, exu.OutputVariableType.Position) for i in range(COUNT)])


@pytest.mark.parametrize("node_type", NODES)
@pytest.mark.parametrize("marker_type", [eii.MarkerBodyRigid, eii.MarkerBodyPosition])
@pytest.mark.parametrize("beside", [[0], [2], [COUNT - 1], [1, 2, 4]])
def test_a_marker_that_is_moved_is_as_if_it_had_been_there(node_type: Any, marker_type: Any, beside: list[int]) -> None:
    """Equality is exact, also after changing it back."""
    places = [BESIDE if k in beside else AT_NODE for k in range(COUNT)]
    moved, there = bodies(node_type, marker_type, [AT_NODE] * COUNT), bodies(node_type, marker_type, places)
    back, at_node = bodies(node_type, marker_type, places), bodies(node_type, marker_type, [AT_NODE] * COUNT)
    for k in beside:
        moved.SetMarkerParameter(1 + k, "localPosition", BESIDE)
        back.SetMarkerParameter(1 + k, "localPosition", AT_NODE)
    found = motion(moved)
    assert found.tobytes() == motion(there).tobytes()
    alone = motion(at_node)
    assert motion(back).tobytes() == alone.tobytes()
    others = np.repeat([k not in beside for k in range(COUNT)], 3)
    np.testing.assert_array_equal(found[others], alone[others])
    assert np.all(np.any(np.abs((found - alone).reshape(COUNT, 3)) > 1e-6, axis=1) == ~others[::3])
