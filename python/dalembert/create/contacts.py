"""Create functions of contacts of spheres with each other, with triangles and with quadrangles."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np

from dalembert import itemInterface as items
from dalembert._core import MainSystem, ObjectIndex, Vector3DList
from dalembert.create._arguments import DEFAULT_COLOR, NO_PAIR, ZERO3, Check, Connected, Vector, vector
from dalembert.create._frames import add_end_marker, connector_ends, marker_names

TRIANGLE = [np.array(corner, float) for corner in ([0, 0, 0], [1, 0, 0], [0, 1, 0])]
QUADRANGLE = [np.array(corner, float) for corner in ([0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0])]


# Arguments that are parameters of the contact, and are passed on as they are.
_LAW = (
    "isHollowSphere1", "dynamicFriction", "frictionProportionalZone", "contactStiffness", "contactDamping",
    "contactStiffnessExponent", "constantPullOffForce", "contactPlasticityRatio", "adhesionCoefficient",
    "adhesionExponent", "restitutionCoefficient", "minimumImpactVelocity", "impactModel", "activeConnector",
    "limitDamping",
)  # fmt: skip


def _law_of(arguments: dict[str, Any]) -> dict[str, Any]:
    """Return those of a function's arguments that are parameters of the contact."""
    if arguments["restitutionCoefficient"] != 1 and arguments["impactModel"] == 0:
        warnings.warn(
            f"restitutionCoefficient: received {arguments['restitutionCoefficient']}, which impactModel=0 ignores: set "
            "impactModel=2, which keeps it, or contactDamping",
            stacklevel=5,
        )
    return {name: arguments[name] for name in _LAW if name in arguments}


def _history(mbs: MainSystem, coordinates: Vector) -> Any:
    return mbs.AddNode(items.NodeGenericData(initialCoordinates=coordinates, numberOfDataCoordinates=len(coordinates)))


def CreateSphereSphereContact(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    localPosition1: Vector = ZERO3,
    spheresRadii: Vector = [-1, -1],
    isHollowSphere1: bool = False,
    dynamicFriction: float = 0.0,
    frictionProportionalZone: float = 1e-3,
    contactStiffness: float = 0.0,
    contactDamping: float = 0.0,
    contactStiffnessExponent: float = 1,
    constantPullOffForce: float = 0,
    contactPlasticityRatio: float = 0,
    adhesionCoefficient: float = 0,
    adhesionExponent: float = 1,
    restitutionCoefficient: float = 1,
    minimumImpactVelocity: float = 0,
    impactModel: int = 0,
    dataInitialCoordinates: Vector = [0, 0, 0, 0],
    activeConnector: bool = True,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    show: bool = False,
    color: Vector = DEFAULT_COLOR,
    limitDamping: bool = False,
) -> ObjectIndex:
    """Add contact between two spheres around points of bodies or nodes; return the ObjectIndex of the contact.

    Friction requires bodies or nodes with an orientation.
    """
    law = _law_of(locals())
    where = "CreateSphereSphereContact"
    ends = connector_ends(where, bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, NO_PAIR)
    markers = [
        add_end_marker(mbs, number, local, label, rigid=dynamicFriction != 0)
        for number, local, label in zip(ends.numbers, ends.localPositions, marker_names(name), strict=True)
    ]
    return mbs.AddObject(
        items.ObjectContactSphereSphere(
            name=name,
            markerNumbers=markers,
            nodeNumber=_history(mbs, dataInitialCoordinates),
            spheresRadii=spheresRadii,
            **law,
            visualization=items.VObjectContactSphereSphere(show=show, color=color),
        )
    )


def CreateSphereTriangleContact(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    radiusSphere: float = 0,
    trianglePoints: Sequence[Vector] = TRIANGLE,
    includeEdges: int = 7,
    dynamicFriction: float = 0.0,
    frictionProportionalZone: float = 1e-3,
    contactStiffness: float = 0.0,
    contactDamping: float = 0.0,
    contactStiffnessExponent: float = 1,
    restitutionCoefficient: float = 1,
    minimumImpactVelocity: float = 0,
    impactModel: int = 0,
    dataInitialCoordinates: Vector = [0, 0, 0, 0],
    activeConnector: bool = True,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    localPosition1: Vector = ZERO3,
    show: bool = False,
    color: Vector = DEFAULT_COLOR,
    limitDamping: bool = False,
) -> ObjectIndex:
    """Add contact between a sphere on the first body and a triangle on the second one; return its ObjectIndex.

    Points of the triangle are relative to localPosition1. Friction requires an orientation of the first body or node.
    """
    law = _law_of(locals())
    where = "CreateSphereTriangleContact"
    ends = connector_ends(where, bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, NO_PAIR)
    labels = marker_names(name)
    sphere = add_end_marker(mbs, ends.numbers[0], localPosition0, labels[0], rigid=dynamicFriction != 0)
    carrier = add_end_marker(mbs, ends.numbers[1], localPosition1, labels[1], rigid=True)
    return mbs.AddObject(
        items.ObjectContactSphereTriangle(
            name=name,
            markerNumbers=[sphere, carrier],
            nodeNumber=_history(mbs, dataInitialCoordinates),
            radiusSphere=radiusSphere,
            trianglePoints=Vector3DList([list(point) for point in trianglePoints]),
            includeEdges=includeEdges,
            **law,
            visualization=items.VObjectContactSphereTriangle(show=show, color=color),
        )
    )


def CreateSphereQuadContact(
    mbs: MainSystem,
    name: str = "",
    bodyNumbers: Sequence[Connected] = NO_PAIR,
    localPosition0: Vector = ZERO3,
    radiusSphere: float = 0,
    quadPoints: Sequence[Vector] = QUADRANGLE,
    includeEdges: int = 15,
    dynamicFriction: float = 0.0,
    frictionProportionalZone: float = 1e-3,
    contactStiffness: float = 0.0,
    contactDamping: float = 0.0,
    contactStiffnessExponent: float = 1,
    restitutionCoefficient: float = 1,
    minimumImpactVelocity: float = 0,
    impactModel: int = 0,
    dataInitialCoordinates: Vector = [0, 0, 0, 0],
    activeConnector: bool = True,
    bodyOrNodeList: Sequence[Connected] = NO_PAIR,
    localPosition1: Vector = ZERO3,
    show: bool = False,
    color: Vector = DEFAULT_COLOR,
    limitDamping: bool = False,
) -> dict[str, ObjectIndex]:
    """Let a sphere on the first body touch a quadrangle on the second one, by two triangles.

    Returns a dictionary with the ObjectIndex of both contacts, oContact0 and oContact1, whose names end with 0 and 1.
    The diagonal that both share leads from point 1 to point 3, and is no edge; includeEdges has a bit for each side of
    the quadrangle.
    """
    law = _law_of(locals())
    where = "CreateSphereQuadContact"
    ends = connector_ends(where, bodyNumbers, localPosition0, localPosition1, bodyOrNodeList, NO_PAIR)
    labels = marker_names(name)
    sphere = add_end_marker(mbs, ends.numbers[0], localPosition0, labels[0], rigid=dynamicFriction != 0)
    carrier = add_end_marker(mbs, ends.numbers[1], localPosition1, labels[1], rigid=True)
    sides = [bool(includeEdges & 1 << i) for i in range(4)]
    halves = {(0, 1, 3): sides[0] + 4 * sides[3], (1, 2, 3): sides[1] + 2 * sides[2]}
    return {
        f"oContact{i}": CreateSphereTriangleContact(
            mbs,
            name=f"{name}{i}" if name else "",
            bodyNumbers=[sphere, carrier],
            radiusSphere=radiusSphere,
            trianglePoints=[quadPoints[corner] for corner in corners],
            includeEdges=edges,
            **law,
            dataInitialCoordinates=dataInitialCoordinates,
            show=show,
            color=color,
        )
        for i, (corners, edges) in enumerate(halves.items())
    }


# Requirements on arguments besides those of the mirrored item and COMMON.
_CHECKS: dict[str, Check] = {"dataInitialCoordinates": vector(4)}
CHECKS: dict[str, dict[str, Check]] = {
    "CreateSphereSphereContact": _CHECKS,
    "CreateSphereTriangleContact": _CHECKS,
    "CreateSphereQuadContact": _CHECKS,
}
