"""The Create function of kinematic trees: node and object of links in minimal coordinates, in one call."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import graphics
from dalembert import itemInterface as items
from dalembert._checks import as_color
from dalembert._core import JointType, MainSystem, Matrix3DList, ObjectIndex, Vector3DList
from dalembert._geometry.inertia import TreeLink
from dalembert._tools.missing_names import nearest
from dalembert.create import bodies
from dalembert.create._arguments import (
    DEFAULT_COLOR,
    FLAG,
    NOT_NEGATIVE,
    POSITIVE,
    ZERO3,
    Check,
    UserFunction,
    Vector,
    argument_error,
    vector,
)
from dalembert.create._link_shapes import Look, link_shapes
from dalembert.rigidBodyUtilities import HT2rotationMatrix, HT2translation


def _parents(links: Sequence[TreeLink]) -> list[int]:
    """Return the parent of each link: all of them are given, or each link hangs on the one before."""
    if all(link.parent is None for link in links):
        return [i - 1 for i in range(len(links))]
    parents: list[int] = []
    numbers: dict[str, int] = {}  # numbers of previous links; names of joints are used if no link has the name
    for i, link in enumerate(links):
        parent = numbers.get(link.parent) if isinstance(link.parent, str) else link.parent
        if parent is None or not -1 <= parent < i:
            expected = (
                f"links whose parent is -1 or the index or name of a link before, link {i} among them; or None for all"
                + (nearest(link.parent, numbers) if isinstance(link.parent, str) else "")
            )
            raise argument_error("CreateKinematicTree", "listOfTreeLinks", expected, link.parent)
        parents.append(int(parent))
        if link.jointName:
            numbers.setdefault(link.jointName, i)
        if link.name:
            numbers[link.name] = i
    return parents


def _names(links: Sequence[TreeLink], field: str) -> list[str]:
    """Return the names of links or joints; an empty list if there are none."""
    names = [getattr(link, field) for link in links]
    return names if any(names) else []


def _of_joints(name: str, values: Any, count: int, default: Any) -> Any:
    if values is None:
        return default
    if np.shape(values) != (count,):
        raise argument_error("CreateKinematicTree", name, f"a vector with {count} components, one per link", values)
    return values


def _of_links(name: str, vectors: Any, count: int) -> Any:
    if vectors is None:
        return Vector3DList()
    if len(vectors) != count:
        raise argument_error("CreateKinematicTree", name, f"{count} vectors, one per link", vectors)
    return vectors


def _colors(name: str, colors: Any, count: int, default: Vector) -> list[Any]:
    """Return a colour for each link, of one for all or of a list."""
    where = f"MainSystem.CreateKinematicTree(...): argument '{name}'"
    if np.shape(colors) == (4,):
        return [default if colors[0] == -1 else as_color(where, colors)] * count
    if np.shape(colors) != (count, 4):
        raise argument_error("CreateKinematicTree", name, f"an RGBA color, or a list of {count} of them", colors)
    return [as_color(where, each) for each in colors]


def CreateKinematicTree(
    mbs: MainSystem,
    name: str = "",
    listOfTreeLinks: Sequence[TreeLink] = [],
    referenceCoordinates: Vector | None = None,
    initialCoordinates: Vector | None = None,
    initialCoordinates_t: Vector | None = None,
    gravity: Vector = ZERO3,
    baseOffset: Vector = ZERO3,
    linkForces: Any = None,
    linkTorques: Any = None,
    jointForceVector: Vector | None = None,
    jointPositionOffsetVector: Vector | None = None,
    jointVelocityOffsetVector: Vector | None = None,
    forceUserFunction: UserFunction = 0,
    jointRadius: float = 0.05,
    jointWidth: float = 0.12,
    colors: Any = DEFAULT_COLOR,
    colorsJoints: Any = DEFAULT_COLOR,
    baseGraphicsDataList: list[dict[str, Any]] | None = None,
    linkRoundness: float = 0.2,
    show: bool = True,
) -> ObjectIndex:
    """Add a kinematic tree with its node and return its ObjectIndex.

    Links without graphics are drawn as bars between joints. The base is drawn as a ground object, unless its list of
    graphics is empty.
    """
    links, n = list(listOfTreeLinks), len(listOfTreeLinks)
    for i, link in enumerate(links):
        if not isinstance(link, TreeLink):
            raise argument_error("CreateKinematicTree", f"listOfTreeLinks[{i}]", "a TreeLink(...)", link)
        if not isinstance(link.jointType, JointType):
            expected = "a member of JointType, e.g. exu.JointType.RevoluteZ"
            raise argument_error("CreateKinematicTree", f"listOfTreeLinks[{i}].jointType", expected, link.jointType)
    parents = _parents(links)
    controlled = any(link.PDcontrol is not None for link in links)
    offsets = {
        "jointPositionOffsetVector": jointPositionOffsetVector,
        "jointVelocityOffsetVector": jointVelocityOffsetVector,
    }
    if not controlled and any(values is not None for values in offsets.values()):
        given = next(name for name, values in offsets.items() if values is not None)
        raise argument_error("CreateKinematicTree", given, "None, as no link has PDcontrol", offsets[given])
    start = {
        "referenceCoordinates": _of_joints("referenceCoordinates", referenceCoordinates, n, np.zeros(n)),
        "initialCoordinates": _of_joints("initialCoordinates", initialCoordinates, n, np.zeros(n)),
        "initialCoordinates_t": _of_joints("initialCoordinates_t", initialCoordinates_t, n, np.zeros(n)),
    }
    gains = [link.PDcontrol if link.PDcontrol is not None else (0.0, 0.0) for link in links] if controlled else []
    look = Look(
        jointRadius,
        jointWidth,
        linkRoundness,
        _colors("colors", colors, n, graphics.color.defaultBody),
        _colors("colorsJoints", colorsJoints, n, graphics.color.defaultJoint),
    )
    shapes, base = link_shapes(links, parents, look)
    tree = items.ObjectKinematicTree(
        name=name,
        gravity=gravity,
        baseOffset=baseOffset,
        jointTypes=[link.jointType for link in links],
        linkParents=parents,
        linkNames=_names(links, "name"),
        jointNames=_names(links, "jointName"),
        jointTransformations=Matrix3DList([HT2rotationMatrix(link.jointHT) for link in links]),
        jointOffsets=Vector3DList([HT2translation(link.jointHT) for link in links]),
        linkInertiasCOM=Matrix3DList([link.linkInertia.InertiaCOM() for link in links]),
        linkCOMs=Vector3DList([link.linkInertia.COM() for link in links]),
        linkMasses=[link.linkInertia.Mass() for link in links],
        linkForces=_of_links("linkForces", linkForces, n),
        linkTorques=_of_links("linkTorques", linkTorques, n),
        jointForceVector=_of_joints("jointForceVector", jointForceVector, n, []),
        jointPControlVector=[gain[0] for gain in gains],
        jointDControlVector=[gain[1] for gain in gains],
        forceUserFunction=forceUserFunction,
        visualization=items.VObjectKinematicTree(show=show, graphicsDataList=shapes),
        **{key: _of_joints(key, values, n, np.zeros(n)) for key, values in offsets.items() if controlled},
    )
    base = base if baseGraphicsDataList is None else baseGraphicsDataList
    if base:
        bodies.CreateGround(mbs, referencePosition=baseOffset, graphicsDataList=base, show=show)
    node_name = f"Node:{name}" if name else ""
    tree.nodeNumber = mbs.AddNode(items.NodeGenericODE2(name=node_name, numberOfODE2Coordinates=n, **start))
    return mbs.AddObject(tree)


_LINKS = Check(
    lambda value: isinstance(value, (list, tuple)) and bool(value) and all(isinstance(v, TreeLink) for v in value),
    "a list of TreeLink, one at least",
)
CHECKS: dict[str, dict[str, Check]] = {
    "CreateKinematicTree": {
        "listOfTreeLinks": _LINKS,
        "gravity": vector(3),
        "jointRadius": POSITIVE,
        "jointWidth": POSITIVE,
        "linkRoundness": NOT_NEGATIVE,
        "show": FLAG,
    }
}
