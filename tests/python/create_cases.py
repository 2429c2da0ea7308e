"""Calls of all Create functions on one model, and how items are written down to compare them."""

from typing import Any

import numpy as np

from dalembert import JointType, Matrix3DList, Vector3DList
from dalembert.rigidBodyUtilities import HTtranslate, InertiaCuboid, RotationMatrixX, RotationMatrixZ, TreeLink

TILTED = RotationMatrixX(0.4) @ RotationMatrixZ(0.2)
ABOUT_Z = RotationMatrixZ(0.3)
BAR = InertiaCuboid(density=1000, sideLengths=[1, 0.2, 0.3])
GRAVITY = [0, -9.81, 0]

# Names of items that a call refers to: 'ground', 'body', 'other', 'mass', 'rigidMarker', 'massNode'.
JOINED = ["body", "other"]

BASE = {
    "ground": ("CreateGround", {"name": "g", "referencePosition": [0.1, 0.2, 0], "referenceRotationMatrix": ABOUT_Z}),
    "body": (
        "CreateRigidBody",
        {
            "name": "b",
            "referencePosition": [1, 2, 3],
            "referenceRotationMatrix": TILTED,
            "initialVelocity": [1, 2, 3],
            "initialAngularVelocity": [0.1, 0.2, 0.3],
            "inertia": BAR,
            "gravity": GRAVITY,
        },
    ),
    "other": ("CreateRigidBody", {"referencePosition": [2, 2, 3], "referenceRotationMatrix": ABOUT_Z, "inertia": BAR}),
    "mass": ("CreateMassPoint", {"name": "m", "referencePosition": [3, 2, 1], "physicsMass": 2, "drawSize": 0.5}),
}

PLACE = {"bodyNumbers": JOINED, "position": [1, 1, 2]}
AXIS = {"axis": [1, 2, 0.5]}
LOCAL = {"useGlobalFrame": False}
ENDS = {"bodyNumbers": JOINED, "localPosition0": [0.5, 0, 0], "localPosition1": [0, 0.1, 0]}
TRIANGLE = Vector3DList([[0, 0, 0], [2, 0, 0], [0, 1, 0.5]])
DISC = {"bodyNumbers": ["ground", "body"], "axisPosition": [0, 0, 0.1], "discRadius": 0.5, "name": "disc"}
SIX = {"stiffness": 3 * np.eye(6), "damping": 0.1 * np.eye(6), "rotationMatrixJoint": TILTED}

CASES: dict[str, tuple[str, dict[str, Any]]] = {
    "ground": ("CreateGround", {}),
    "mass point with gravity": ("CreateMassPoint", {"name": "p", "physicsMass": 3, "gravity": GRAVITY}),
    "planar mass point": (
        "CreateMassPoint",
        {"create2D": True, "referencePosition": [1, 2, 0], "initialVelocity": [3, 4, 0], "physicsMass": 3},
    ),
    "rigid body with gravity": ("CreateRigidBody", {"name": "r", "inertia": BAR, "gravity": GRAVITY}),
    "displaced rigid body": (
        "CreateRigidBody",
        {
            "inertia": BAR.Translated([0.1, 0, 0]),
            "referenceRotationMatrix": TILTED,
            "initialDisplacement": [0.1, 0, 0],
            "initialRotationMatrix": ABOUT_Z,
        },
    ),
    "planar rigid body": (
        "CreateRigidBody",
        {
            "create2D": True,
            "inertia": BAR,
            "referencePosition": [1, 2, 0],
            "referenceRotationMatrix": ABOUT_Z,
            "initialAngularVelocity": [0, 0, 3],
            "initialDisplacement": [1, 1, 0],
            "initialRotationMatrix": RotationMatrixZ(0.6),
            "gravity": GRAVITY,
        },
    ),
    "revolute": ("CreateRevoluteJoint", PLACE | AXIS | {"name": "j"}),
    "revolute local": ("CreateRevoluteJoint", PLACE | AXIS | LOCAL),
    "revolute at marker": ("CreateRevoluteJoint", AXIS | {"bodyNumbers": ["rigidMarker", "other"], "position": []}),
    "prismatic": ("CreatePrismaticJoint", PLACE | AXIS),
    "prismatic local": ("CreatePrismaticJoint", PLACE | AXIS | LOCAL),
    "spherical": ("CreateSphericalJoint", PLACE | {"constrainedAxes": [1, 1, 0]}),
    "spherical on mass": ("CreateSphericalJoint", {"bodyNumbers": ["ground", "mass"], "position": [3, 2, 1]}),
    "generic": (
        "CreateGenericJoint",
        PLACE | {"rotationMatrixAxes": TILTED, "constrainedAxes": [1, 1, 0, 1, 0, 0], "axesRadius": 0.2},
    ),
    "generic local": ("CreateGenericJoint", PLACE | LOCAL | {"rotationMatrixAxes": TILTED}),
    "spring-damper": ("CreateSpringDamper", ENDS | {"name": "s", "stiffness": 3, "damping": 1, "force": 2}),
    "spring-damper at node": ("CreateSpringDamper", {"bodyNumbers": ["massNode", "rigidMarker"], "stiffness": 3}),
    "spring-damper by list": ("CreateSpringDamper", {"bodyOrNodeList": JOINED, "referenceLength": 0.5}),
    "cartesian": ("CreateCartesianSpringDamper", ENDS | {"stiffness": [1, 2, 3], "offset": [0.1, 0, 0]}),
    "six directions": ("CreateRigidBodySpringDamper", ENDS | SIX),
    "six directions local": ("CreateRigidBodySpringDamper", ENDS | SIX | LOCAL),
    "torsional": ("CreateTorsionalSpringDamper", PLACE | AXIS | {"stiffness": 3, "damping": 1, "torque": 2}),
    "torsional limited": ("CreateTorsionalSpringDamper", PLACE | AXIS | LOCAL | {"unlimitedRotations": False}),
    "distance": ("CreateDistanceConstraint", ENDS | {"name": "d"}),
    "distance zero": ("CreateDistanceConstraint", {"bodyNumbers": ["mass", "body"], "distance": 0}),
    "coordinate to ground": (
        "CreateCoordinateConstraint",
        {"name": "c", "bodyNumbers": [None, "body"], "coordinates": [None, 2], "offset": 0.1},
    ),
    "coordinates": (
        "CreateCoordinateConstraint",
        {"bodyNumbers": ["body", "mass"], "coordinates": [1, 2], "factorValue1": 2},
    ),
    "rolling": ("CreateRollingDisc", DISC | {"planePosition": [0, 0, 0.1], "constrainedAxes": [1, 0, 1]}),
    "rolling penalty": (
        "CreateRollingDiscPenalty",
        DISC | {"contactStiffness": 100, "dryFriction": [0.1, 0.2], "dryFrictionProportionalZone": 0.1},
    ),
    "spheres": (
        "CreateSphereSphereContact",
        ENDS | {"name": "touch", "spheresRadii": [0.1, 0.2], "contactStiffness": 100, "contactPlasticityRatio": 0.2},
    ),
    "spheres with friction": (
        "CreateSphereSphereContact",
        {"bodyNumbers": JOINED, "spheresRadii": [0.1, 0.2], "dynamicFriction": 0.3, "impactModel": 1, "show": True},
    ),
    "sphere and triangle": (
        "CreateSphereTriangleContact",
        ENDS | {"radiusSphere": 0.1, "trianglePoints": TRIANGLE, "includeEdges": 5, "dynamicFriction": 0.3},
    ),
    "sphere and quadrangle": (
        "CreateSphereQuadContact",
        {
            "bodyNumbers": ["body", "ground"],
            "radiusSphere": 0.1,
            "includeEdges": 13,
            "dataInitialCoordinates": [1, 0, 0, 0],
        },
    ),
    "force": ("CreateForce", {"bodyNumber": "mass", "loadVector": [1, 2, 3]}),
    "force that turns": (
        "CreateForce",
        {"bodyNumber": "body", "loadVector": [1, 2, 3], "localPosition": [0.1, 0, 0], "bodyFixed": True},
    ),
    "force at marker": ("CreateForce", {"bodyNumber": "rigidMarker", "loadVector": [1, 2, 3]}),
    "torque": ("CreateTorque", {"bodyNumber": "body", "loadVector": [1, 2, 3], "localPosition": [0.1, 0, 0]}),
    "kinematic tree": (
        "CreateKinematicTree",
        {
            "name": "arm",
            "listOfTreeLinks": [
                TreeLink(BAR, JointType.RevoluteZ, HTtranslate([0.1, 0.2, 0.3]), PDcontrol=(100, 5)),
                TreeLink(BAR.Translated([0.5, 0, 0]), JointType.PrismaticY, HTtranslate([1, 0, 0]), PDcontrol=(50, 2)),
            ],
            "referenceCoordinates": [0.1, 0.2],
            "initialCoordinates": [0.3, 0.4],
            "initialCoordinates_t": [1, 2],
            "gravity": GRAVITY,
            "baseOffset": [1, 2, 3],
            "jointForceVector": [3, 4],
            "jointVelocityOffsetVector": [0.5, 0.6],
            "baseGraphicsDataList": [],
        },
    ),
}


def base_model(mbs: Any, exu: Any, items: Any, create: Any) -> dict[str, Any]:
    """Add the items that the calls refer to and return their numbers by name; create(function, arguments)."""
    numbers = {name: create(function, arguments) for name, (function, arguments) in BASE.items()}
    numbers["rigidMarker"] = mbs.AddMarker(items.MarkerBodyRigid(bodyNumber=numbers["body"], localPosition=[0.5, 0, 0]))
    numbers["massNode"] = exu.NodeIndex(2)
    return numbers


def resolved(arguments: dict[str, Any], numbers: dict[str, Any]) -> dict[str, Any]:
    """Return the arguments with item names replaced by item numbers."""

    def number(value: Any) -> Any:
        return numbers.get(value, value) if isinstance(value, str) else value

    with_items = ("bodyNumber", "bodyNumbers", "bodyOrNodeList")
    return {
        key: ([number(v) for v in value] if isinstance(value, list) else number(value)) if key in with_items else value
        for key, value in arguments.items()
    }


def plain(value: Any) -> Any:
    """Return a value as it can be written to JSON."""
    if isinstance(value, (Vector3DList, Matrix3DList)):
        return [plain(np.array(v)) for v in value]
    if isinstance(value, (list, tuple, np.ndarray)):
        return [plain(v) for v in value]
    if isinstance(value, (float, np.floating)):
        return round(float(value), 12) + 0.0
    if isinstance(value, (bool, np.bool_, str)) or value is None:
        return value if not isinstance(value, np.bool_) else bool(value)
    return int(value)


def added_items(mbs: Any, before: dict[str, int]) -> list[list[Any]]:
    """Return [kind, parameters] of all items that are there beyond the given counts, without graphics data."""
    rows = []
    for kind in ("Node", "Object", "Marker", "Load"):
        for i in range(before[kind], counts(mbs)[kind]):
            data = getattr(mbs, f"Get{kind}")(i)
            rows.append([kind, {key: plain(value) for key, value in data.items() if "raphics" not in key}])
    return rows


def counts(mbs: Any) -> dict[str, int]:
    """Return the number of items by kind."""
    return {kind: getattr(mbs.systemData, f"NumberOf{kind}s")() for kind in ("Node", "Object", "Marker", "Load")}
