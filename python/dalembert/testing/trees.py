"""Kinematic trees for tests: a list of links with everything that is known of them, and the items made of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

import dalembert as exu
from dalembert import itemInterface as items
from dalembert.kinematicTree import KinematicTree33
from dalembert.rigidBodyUtilities import RotationMatrixX, RotationMatrixY, RotationMatrixZ
from dalembert.testing.motions import random_rotation

JOINTS = {"Rx": 1, "Ry": 2, "Rz": 3, "Px": 4, "Py": 5, "Pz": 6}


def box_inertia(mass: float, sides: Any) -> np.ndarray:
    a, b, c = np.square(sides)
    return mass / 12 * np.diag([b + c, a + c, a + b])


@dataclass
class Link:
    joint: str
    parent: int = -1
    mass: float = 0.0
    com: Any = (0.0, 0.0, 0.0)
    inertia: Any = field(default_factory=lambda: np.zeros((3, 3)))  # about the centre of mass
    offset: Any = (0.0, 0.0, 0.0)
    rotation: Any = field(default_factory=lambda: np.eye(3))


@dataclass
class Tree:
    mbs: Any
    node: Any
    body: Any
    links: list[Link]
    base: Any = (0.0, 0.0, 0.0)

    @property
    def coordinates(self) -> np.ndarray:
        return np.atleast_1d(self.mbs.GetNodeOutput(self.node, exu.OutputVariableType.CoordinatesTotal))

    @property
    def rates(self) -> np.ndarray:
        return np.atleast_1d(self.mbs.GetNodeOutput(self.node, exu.OutputVariableType.Coordinates_t))

    def of_link(self, variable: str, link: int, local: Any = (0, 0, 0)) -> np.ndarray:
        """An output of a point of a link, by a sensor on another tree that starts in this state."""
        here = make(self.links, self.coordinates, self.rates, baseOffset=self.base)
        kind = getattr(exu.OutputVariableType, variable)
        place = {"objectNumber": here.body, "linkNumber": link, "localPosition": local}
        sensor = here.mbs.AddSensor(items.SensorKinematicTree(outputVariableType=kind, **place))
        here.mbs.Assemble()
        return np.array(here.mbs.GetSensorValues(sensor))


def make(links: list[Link], q: Any = None, v: Any = None, mbs: Any = None, **parameters: Any) -> Tree:
    """The tree in a system, with initial values of the coordinates."""
    n = len(links)
    mbs = exu.SystemContainer().AddSystem() if mbs is None else mbs
    start = {
        "initialCoordinates": np.zeros(n) if q is None else q,
        "initialCoordinates_t": np.zeros(n) if v is None else v,
    }
    node = mbs.AddNode(items.NodeGenericODE2(numberOfODE2Coordinates=n, referenceCoordinates=np.zeros(n), **start))
    body = mbs.AddObject(items.ObjectKinematicTree(nodeNumber=node, **lists(links), **parameters))
    return Tree(mbs, node, body, links, parameters.get("baseOffset", np.zeros(3)))


def lists(links: list[Link]) -> dict[str, Any]:
    return {
        "jointTypes": [exu.JointType(JOINTS[link.joint]) for link in links],
        "linkParents": [link.parent for link in links],
        "jointTransformations": exu.Matrix3DList([np.asarray(link.rotation) for link in links]),
        "jointOffsets": exu.Vector3DList([np.asarray(link.offset, dtype=float) for link in links]),
        "linkInertiasCOM": exu.Matrix3DList([np.asarray(link.inertia) for link in links]),
        "linkCOMs": exu.Vector3DList([np.asarray(link.com, dtype=float) for link in links]),
        "linkMasses": [link.mass for link in links],
    }


def in_python(links: list[Link], gravity: Any) -> KinematicTree33:
    """A kinematic tree whose dynamics are computed with spatial vectors in Python."""

    def about_origin(link: Link) -> np.ndarray:
        c = np.asarray(link.com, dtype=float)
        return link.inertia + link.mass * (c @ c * np.eye(3) - np.outer(c, c))

    return KinematicTree33(
        [link.joint for link in links],
        [link.rotation for link in links],
        [link.offset for link in links],
        [about_origin(link) for link in links],
        [link.com for link in links],
        [link.mass for link in links],
        [link.parent for link in links],
        gravity,
    )


def link_frame(tree: Any, q: Any, link: int) -> tuple[np.ndarray, np.ndarray]:
    """Rotation matrix and origin of a link, of the parameters of the object."""
    parent = tree["linkParents"][link]
    rotation, origin = (np.eye(3), np.array(tree["baseOffset"])) if parent < 0 else link_frame(tree, q, parent)
    origin = origin + rotation @ tree["jointOffsets"][link]
    rotation = rotation @ tree["jointTransformations"][link]
    kind = int(tree["jointTypes"][link]) - 1
    axis = np.eye(3)[kind % 3]
    if kind >= 3:
        return rotation, origin + q[link] * rotation @ axis
    return rotation @ (RotationMatrixX, RotationMatrixY, RotationMatrixZ)[kind](q[link]), origin


def random_links(seed: int, n: int = 9) -> list[Link]:
    """A tree with branches and all types of joints."""
    rng = np.random.default_rng(seed)
    links = []
    for i in range(n):
        root = rng.uniform(-0.5, 0.5, (3, 3))
        joint = list(JOINTS)[i % 6] if i < 6 else str(rng.choice(list(JOINTS)))
        parent = int(rng.integers(-1, i)) if i else -1
        vectors = {"com": rng.uniform(-0.3, 0.3, 3), "offset": rng.uniform(-0.5, 0.5, 3)}
        inertia = root @ root.T + 0.1 * np.eye(3)
        links.append(
            Link(joint, parent, rng.uniform(0.5, 2), inertia=inertia, rotation=random_rotation(rng), **vectors)
        )
    return links


def forward(tree: Tree) -> np.ndarray:
    """Accelerations at the start, by one large step of Euler's explicit method."""
    tree.mbs.Assemble()
    v = tree.rates
    settings = exu.SimulationSettings()
    settings.timeIntegration.numberOfSteps = 1
    settings.timeIntegration.endTime = 1
    settings.solutionSettings.writeSolutionToFile = False
    tree.mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.ExplicitEuler)
    return tree.rates - v
