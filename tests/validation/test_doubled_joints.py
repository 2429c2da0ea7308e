"""Each joint and constraint twice between the same bodies: they move as with one, and all equations of one could be left out."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from solving import Solver, Variable, new_system, settings
from test_redundant import redundancy

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

AXES = Rotation.from_euler("xyz", [0.3, 0.4, -0.5]).as_matrix()
PLACE = np.array([0.4, 0.15, 0])  # of the joint
TURNS = [Rotation.from_euler("xyz", angles).as_matrix() for angles in ([0.2, -0.1, 0.6], [-0.4, 0.5, 0.3])]
CENTRES = [np.array([0.2, 0.1, -0.1]), np.array([0.6, 0.2, 0.1])]
SWING = {
    "offsetUserFunction": lambda mbs, t, number, offset: 0.1 * (1 - np.cos(3 * t)),
    "offsetUserFunction_t": lambda mbs, t, number, offset: 0.3 * np.sin(3 * t),
}


class TwoBodies:
    """The first hangs on a ball joint; a spring pulls the second."""

    def __init__(self) -> None:
        self.mbs = new_system()
        self.ground = self.mbs.CreateGround()
        self.bodies = [
            self.mbs.CreateRigidBody(
                referencePosition=centre,
                referenceRotationMatrix=turn,
                inertia=InertiaCuboid(1000, [0.3, 0.1, 0.2]),
                gravity=[1, -2, -9.81],
            )
            for centre, turn in zip(CENTRES, TURNS, strict=True)
        ]
        self.mbs.CreateSphericalJoint(bodyNumbers=[self.ground, self.bodies[0]], position=[0, 0, 0])
        self.mbs.CreateSpringDamper(
            bodyNumbers=[self.ground, self.bodies[1]],
            localPosition0=[0.8, 0.5, 0.3],
            stiffness=500,
            damping=2,
        )

    def frames(self) -> dict[str, Any]:
        """Markers of the bodies at the joint, and its axes there."""
        markers = [
            self.mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=turn.T @ (PLACE - centre)))
            for body, centre, turn in zip(self.bodies, CENTRES, TURNS, strict=True)
        ]
        return {
            "markerNumbers": markers,
            "rotationMarker0": TURNS[0].T @ AXES,
            "rotationMarker1": TURNS[1].T @ AXES,
        }

    def coordinates(self) -> dict[str, Any]:
        """Markers of y of the first body and x of the second."""
        nodes = [self.mbs.GetObject(body)["nodeNumber"] for body in self.bodies]
        marker = exu.MarkerNodeCoordinate
        pairs = zip(nodes, (1, 0), strict=True)
        return {"markerNumbers": [self.mbs.AddMarker(marker(nodeNumber=n, coordinate=c)) for n, c in pairs]}

    def motion(self) -> np.ndarray:
        variables = (Variable.Position, Variable.Velocity, Variable.RotationMatrix)
        outputs = [self.mbs.GetObjectOutputBody(b, v, [0.1, 0.2, 0]) for b in self.bodies for v in variables]
        return np.concatenate([np.ravel(output) for output in outputs])


def generic(*axes: int) -> Callable[[TwoBodies], Any]:
    return lambda two: exu.GenericJoint(constrainedAxes=axes, **two.frames())


def spherical(*axes: int) -> Callable[[TwoBodies], Any]:
    return lambda two: exu.SphericalJoint(constrainedAxes=axes, markerNumbers=two.frames()["markerNumbers"])


def coordinate(**parameters: Any) -> Callable[[TwoBodies], Any]:
    return lambda two: exu.CoordinateConstraint(**two.coordinates(), **parameters)


def distance(two: TwoBodies) -> Any:
    markers = [two.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body)) for body in two.bodies]
    return exu.DistanceConstraint(markerNumbers=markers, distance=np.linalg.norm(CENTRES[1] - CENTRES[0]))


JOINTS = {  # and how many equations each has
    "fixed": (generic(1, 1, 1, 1, 1, 1), 6),
    "universal": (generic(1, 1, 1, 0, 0, 1), 4),
    "in a plane": (generic(0, 0, 1, 1, 1, 0), 3),
    "rotations": (generic(0, 0, 0, 1, 1, 1), 3),
    "revolute": (lambda two: exu.ObjectJointRevoluteZ(**two.frames()), 5),
    "prismatic": (lambda two: exu.ObjectJointPrismaticX(**two.frames()), 5),
    "spherical": (spherical(1, 1, 1), 3),
    "spherical, one free": (spherical(1, 0, 1), 2),
    "distance": (distance, 1),
    "coordinate": (coordinate(factorValue1=-2.5), 1),
    "rate of a coordinate": (coordinate(velocityLevel=True), 1),
    "driven coordinate": (coordinate(**SWING), 1),
    "driven rate": (coordinate(velocityLevel=True, **SWING), 1),
}


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.ESDIRK43, Solver.DOPRI5])
@pytest.mark.parametrize(("joint", "equations"), JOINTS.values(), ids=JOINTS)
def test_two_joints_move_as_one(joint: Callable[[TwoBodies], Any], equations: int, solver: Any) -> None:
    ends = []
    for times in (1, 2):
        two = TwoBodies()
        for _ in range(times):
            two.mbs.AddObject(joint(two))
        two.mbs.Assemble()
        s = settings(0.3, 150)
        s.timeIntegration.automaticStepSize = False
        two.mbs.SolveDynamic(s, solverType=solver)
        assert redundancy(two.mbs)["count"] == (times - 1) * equations
        ends.append(two.motion())
    np.testing.assert_allclose(ends[1], ends[0], rtol=0, atol=1e-9)
