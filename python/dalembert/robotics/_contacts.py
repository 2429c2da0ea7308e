"""Contact of shapes on the links of a robot with each other and with shapes on its base, by general contact."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import (
    FloatArray,
    as_number,
    as_transformation,
    as_vector,
    check_integer,
    check_type,
    shape_error,
)
from dalembert.robotics._tendons import AddMarker, place_of

if TYPE_CHECKING:
    from dalembert.robotics._robot import Robot

_SIZES = {"sphere": 1, "box": 3, "cylinder": 2, "capsule": 2, "plane": 0}
_CORNERS = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_RIGID = 1e6  # stiffness of rigid shapes, relative to the largest other one: penetrations grow by this part


@dataclass
class RobotContact:
    """A shape on a frame that touches other shapes of the robot; names of frames as in Robot.FrameHT, '' for the base.

    shape is 'sphere', with size [radius], 'box', with its three sides, 'cylinder' or 'capsule', with radius and length
    along z, or 'plane', which is the half-space below z = 0 and has no size. HT leads from the frame to its middle.

    Shapes of one link do not touch, nor do those of a link and its parent link, see also Robot.ExcludeContacts. Others
    touch if groups of one and partners of the other, numbers of 32 bits, have a bit in common. Stiffnesses (N/m) are in
    series, and dampers (Ns/m) parallel. A shape of infinite stiffness is rigid. The friction coefficient of a pair is
    the larger one, or 0 if both shapes are smooth. Shapes are not drawn; links have graphics of their own.
    """

    name: str
    frame: str
    shape: str
    size: Sequence[float] = ()
    HT: npt.ArrayLike | None = None
    stiffness: float = np.inf
    damping: float = 0.0
    friction: float = 0.0
    smooth: bool = False
    groups: int = 1
    partners: int = 1

    def __post_init__(self) -> None:
        where = f"RobotContact '{self.name}'"
        if self.shape not in _SIZES:
            raise shape_error(f"{where}: shape", f"one of {', '.join(_SIZES)}", self.shape)
        sizes = as_vector(f"{where}: size", self.size, _SIZES[self.shape])
        if not ((sizes > 0) & np.isfinite(sizes)).all():
            raise shape_error(f"{where}: size", "positive finite numbers", self.size)
        for what in ("damping", "friction"):
            as_number(f"{where}: {what}", getattr(self, what), negative=False)
        if self.stiffness != np.inf and as_number(f"{where}: stiffness", self.stiffness) <= 0:
            raise shape_error(f"{where}: stiffness", "a positive number, or infinity for a rigid shape", self.stiffness)
        for what in ("groups", "partners"):
            check_integer(f"{where}: {what}", getattr(self, what), -(2**31), 2**32 - 1)
        check_type(f"{where}: smooth", self.smooth, bool)
        self.HT = np.eye(4) if self.HT is None else as_transformation(f"{where}: HT", self.HT).copy()


def effective_masses(robot: Robot) -> FloatArray:
    """Return the masses that a force in the centre of mass of each link accelerates, as a mean over its directions.

    The configuration is the reference configuration, and all joints are free. The mass is that of the link if joints
    prevent any motion of its centre of mass.
    """
    q = robot.referenceConfiguration
    frames, mobility = robot.JointHT(q), np.linalg.inv(robot.MassMatrix(q))
    masses = []
    for i, (link, T) in enumerate(zip(robot.links, robot.COMHT(frames), strict=True)):
        J = robot.Jacobian(frames, np.asarray(T)[:3, 3], "trans", i)
        inverse = float(np.trace(J @ mobility @ J.T)) / 3
        masses.append(1 / inverse if inverse * link.mass > np.finfo(float).eps else link.mass)
    return np.array(masses)


def _carriers(robot: Robot, touching: set[int]) -> dict[int, int]:
    """Return the links that carry those with shapes; links without mass between joints of one body do not count."""
    found = {}
    for i in touching - {-1}:
        parent = robot.GetParentIndex(i)
        while parent >= 0 and robot.links[parent].mass == 0 and parent not in touching:
            parent = robot.GetParentIndex(parent)
        found[i] = parent
    return found


def _touching(robot: Robot, links: list[int]) -> npt.NDArray[np.bool_]:
    """Return for each pair of shapes whether they touch."""
    contacts, of = list(robot.contacts.values()), np.array(links)
    groups, partners = (np.array([getattr(each, what) for each in contacts]) for what in ("groups", "partners"))
    planes = np.array([each.shape == "plane" for each in contacts])
    touch = (groups[:, None] & partners) | (groups & partners[:, None]) != 0
    touch &= (of[:, None] != of) & ~(planes[:, None] & planes)
    for child, parent in _carriers(robot, set(links)).items():
        if parent >= 0:
            touch[np.ix_(of == child, of == parent)] = False
            touch[np.ix_(of == parent, of == child)] = False
    frames = np.array([each.frame for each in contacts])
    for first, second in robot.contactExclusions:
        touch[np.ix_(frames == first, frames == second)] = False
        touch[np.ix_(frames == second, frames == first)] = False
    return np.asarray(touch)


def _sets(touch: npt.NDArray[np.bool_], together: npt.NDArray[np.bool_]) -> Iterator[list[int]]:
    """Give sets of shapes that all touch each other, with each touching pair in one of them.

    General contact has no filter of pairs. Shapes of a pair in `together` never touch, and may be in one set.
    """
    left = touch.copy()
    while left.any():
        chosen, fits = list[int](), np.ones(len(left), dtype=bool)
        while fits.any():
            nearest = left[chosen[0]] if len(chosen) == 1 else fits  # the second one touches the first one
            chosen.append(int(np.argmax(np.where(fits & nearest, left.sum(axis=1), -1))))
            fits &= left[chosen[-1]] | together[chosen[-1]]
            fits[chosen] = False
        pairs = np.ix_(chosen, chosen)
        yield [i for i, touches in zip(chosen, left[pairs], strict=True) if touches.any()]
        left[pairs] = False


def _add_shape(general: Any, each: RobotContact, marker: Any, T: FloatArray, surface: dict[str, Any]) -> None:
    """Add a shape to a general contact; T leads from the marker to its middle."""
    size, z = np.asarray(each.size, dtype=float), T[:3, 2]
    match each.shape:
        case "sphere":
            general.AddSphereWithMarker(marker, radius=size[0], **surface)
        case "box":
            general.AddConvexHullWithMarker(marker, pointList=_CORNERS * size @ T[:3, :3].T + T[:3, 3], **surface)
        case "plane":
            general.AddPlane(marker, normal=z, point=T[:3, 3], **surface)
        case _:
            add = general.AddCylinderWithMarker if each.shape == "cylinder" else general.AddCapsuleWithMarker
            start = T[:3, 3] - 0.5 * size[1] * z
            add(marker, radius=size[0], vAxis=size[1] * z, pAxis=start, **surface)


def add(robot: Robot, mbs: Any, marker: AddMarker) -> list[Any]:
    """Add the contacts of a robot; return the general contacts that have them."""
    contacts = list(robot.contacts.values())
    if not contacts:
        return []
    finite = [each.stiffness for each in contacts if np.isfinite(each.stiffness)]
    if not finite:
        raise ValueError(f"Robot: contacts: all shapes are rigid, such as '{contacts[0].name}'; give some a stiffness")
    places = [place_of(robot, each.frame) for each in contacts]
    links = [link for link, _ in places]
    of_links = {link: marker(link, np.eye(4)) for link in dict.fromkeys(links)}
    at: list[tuple[Any, FloatArray]] = []
    for each, (link, T) in zip(contacts, places, strict=True):
        pose = T @ np.asarray(each.HT)
        if each.shape == "sphere":  # these have their middle in a marker
            at.append((marker(link, pose)[0], np.eye(4)))
        else:
            turned = np.eye(4)
            turned[:3, :3] = of_links[link][1]
            at.append((of_links[link][0], turned @ pose))
    materials = sorted({(each.friction, each.smooth) for each in contacts})
    pairings = [[max(a[0], b[0]) * (not (a[1] and b[1])) for b in materials] for a in materials]
    shared = np.array([link if each.shape != "sphere" else -2 for each, link in zip(contacts, links, strict=True)])
    added = []
    for chosen in _sets(_touching(robot, links), (shared[:, None] == shared) & (shared != -2)):
        general = mbs.AddGeneralContact()
        general.SetFrictionPairings(pairings)
        for i in chosen:
            each = contacts[i]
            surface = {
                "contactStiffness": min(each.stiffness, _RIGID * max(finite)),
                "contactDamping": each.damping,
                "frictionMaterialIndex": materials.index((each.friction, each.smooth)),
            }
            _add_shape(general, each, *at[i], surface)
        added.append(general)
    return added
