"""Chains of geometrically exact beams in space, for tests of whole models."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation
from solving import Variable, new_system

import dalembert as exu


def section(stiffness: Any, mass: float = 0.0, inertia: Any = (0.0, 0.0, 0.0)) -> Any:
    made = exu.BeamSection()
    made.stiffnessMatrix = np.diag(stiffness)
    made.massPerLength, made.inertia = mass, np.diag(inertia)
    return made


class Rod:
    """Straight legs along given frames, one after the other; each leg ends in a corner that is rigid."""

    def __init__(self, node: type = exu.NodeRigidBodyRotVecLG) -> None:
        self.mbs, self.node = new_system(), node
        self.nodes: list[Any] = []
        self.beams: list[Any] = []
        self.ground = self.mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=self.mbs.CreateGround()))

    def add_node(self, position: Any, turn: Any) -> Any:
        rotation = Rotation.from_matrix(turn)
        is_vector = self.node is exu.NodeRigidBodyRotVecLG
        coordinates = rotation.as_rotvec() if is_vector else rotation.as_quat()[[3, 0, 1, 2]]
        return self.mbs.AddNode(self.node(referenceCoordinates=[*position, *coordinates]))

    def add_leg(self, start: Any, turn: Any, length: float, elements: int, of: Any) -> list[Any]:
        """Nodes of a leg along the first axis of `turn`; its first node is fixed to the last one so far, if there is one."""
        turn, places = np.asarray(turn, dtype=float), np.linspace(0, length, elements + 1)
        nodes = [self.add_node(start + x * turn[:, 0], turn) for x in places]
        for pair in pairwise(nodes):
            beam = exu.ObjectBeamGeometricallyExact(
                physicsLength=length / elements, sectionData=of, nodeNumbers=list(pair)
            )
            self.beams.append(self.mbs.AddObject(beam))
        if self.nodes:
            self.join(self.marker(self.nodes[-1]), self.marker(nodes[0]), turn)
        self.nodes += nodes
        return nodes

    def marker(self, node: Any) -> Any:
        return self.mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=node))

    def join(self, first: Any, second: Any, turn: Any, axes: Any = (1, 1, 1, 1, 1, 1)) -> None:
        """`turn` is the rotation of the second marker; the first one must not be turned in the reference configuration."""
        self.mbs.AddObject(
            exu.GenericJoint(markerNumbers=[first, second], rotationMarker0=turn, constrainedAxes=list(axes))
        )

    def clamp(self) -> None:
        self.join(self.ground, self.marker(self.nodes[0]), np.eye(3))

    def load(self, node: Any, kind: Any, vector: Any, **function: Any) -> Any:
        return self.mbs.AddLoad(kind(markerNumber=self.marker(node), loadVector=vector, **function))

    def solve_static(self, steps: int, tolerance: float = 1e-10) -> None:
        chosen = exu.SimulationSettings()
        chosen.solutionSettings.writeSolutionToFile = False
        chosen.staticSolver.verboseMode = 0
        chosen.staticSolver.numberOfLoadSteps = steps
        chosen.staticSolver.newton.relativeTolerance = tolerance
        self.mbs.SolveStatic(chosen, updateInitialValues=True)

    def displacement(self, node: Any) -> np.ndarray:
        return np.array(self.mbs.GetNodeOutput(node, Variable.Displacement))
