"""Values of the right type and size that cannot be right: no rotations, no unit vectors, inertia of no body, joints to themselves."""

from __future__ import annotations

import re
import warnings
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sample_values import CHECKED, CLASSES, ITEMS, SHEAR, rows

import dalembert as exu
from codegen.load import load
from codegen.model import Item, Parameter
from codegen.model_settings import SettingsGroup
from dalembert.kinematicTree import KinematicTree33
from dalembert.lieGroupBasics import LogSO3, R3xSO3Matrix
from dalembert.rigidBodyUtilities import (
    GetRigidBodyNode,
    HomogeneousTransformation,
    HT2rotationMatrix,
    HT2T66Inverse,
    InertiaCuboid,
    InertiaCylinder,
    InertiaHollowSphere,
    InertiaMassPoint,
    InertiaRodX,
    InertiaSphere,
    InverseHT,
    InverseT66toRotationTranslation,
    RigidBodyInertia,
    RotationMatrix2EulerParameters,
    RotationMatrix2RotationVector,
    RotationMatrix2RotXYZ,
    RotationMatrix2RotZYZ,
    RotationMatrixZ,
    RotationTranslation2T66,
    RotationTranslation2T66Inverse,
    RotationVector2RotationMatrix,
    T66Inverse,
    TreeLink,
)

JUDGED = list(rows(lambda row: row.effective_check in CHECKED))
each_judged = pytest.mark.parametrize(("item", "row"), JUDGED, ids=[f"{item.name}.{row.name}" for item, row in JUDGED])


def one_of(item: Item, row: Parameter, value: Any) -> Any:
    """Value as required by the row: the value, or a list of one."""
    return [value] if row.type.storage.endswith("s") and row.shape[0] is None else value


def test_every_matrix_of_direction_cosines_is_checked() -> None:
    without_unit = rows(lambda row: row.type.storage.startswith("matrix3") and row.unit == "1")
    assert [f"{item.name}.{row.name}" for item, row in without_unit if row.effective_check == "none"] == []


def test_every_color_is_checked() -> None:
    def rows_of(group: SettingsGroup) -> Iterator[Parameter]:
        yield from group.rows
        for child in group.children:
            yield from rows_of(child)

    groups = [group for file in load(Path(__file__).parents[2]).settings for group in (file.root, *file.shared)]
    tables = [*(item.visualization for item in ITEMS), *map(rows_of, groups)]
    colors = [row for table in tables for row in table if row.type.name == "Float4" and "olor" in row.name]
    assert len(colors) > 60  # of items and of settings
    assert [row.name for row in colors if row.effective_check != "color"] == []


@each_judged
def test_values_that_are_none_are_refused_with_the_reason(item: Item, row: Parameter) -> None:
    turned = RotationVector2RotationMatrix([0.3, -0.2, 0.9])
    axis = np.array([2.0, -1.0, 0.5])
    bad: list[tuple[Any, str]] = [([0, 0, 0], "A vector of zeros has no direction."), (axis, "Its length is 2.291")]
    good: Any = axis / np.linalg.norm(axis)
    if row.effective_check != "unit_vector":
        good = turned
        bad = [
            (2 * np.eye(3), "It is not orthogonal: A A^T differs from the identity matrix by up to 3."),
            (SHEAR, "It is not orthogonal: A A^T differs from the identity matrix by up to 0.1."),
            (turned * (1 + 1e-7), "It is not orthogonal: A A^T differs from the identity matrix by up to 2e-07."),
        ]
    if row.effective_check == "rotation":
        bad += [(turned @ np.diag([1, -1, 1]), "It is a reflection: its determinant is -1, its axes are left-handed.")]
    for value, reason in bad:
        if np.array_equal(row.default, value):  # means: not set
            continue
        with pytest.raises(ValueError, match=rf"^{item.name}, parameter '{row.name}': received ") as caught:
            CLASSES[item.name](**{row.name: one_of(item, row, value)})
        assert reason in str(caught.value)
    made = CLASSES[item.name](**{row.name: one_of(item, row, good * (1 + 1e-12))})
    np.testing.assert_allclose(np.array(getattr(made, row.name)).reshape(good.shape), good, rtol=1e-11)


def test_a_reflection_is_doubtful_where_one_column_counts(mbs: exu.MainSystem) -> None:
    with pytest.warns(UserWarning, match=r"ObjectMass1D, parameter 'referenceRotation': .* It is a reflection"):
        exu.Mass1D(referenceRotation=[[0, 1, 0], [1, 0, 0], [0, 0, 1]])


def pair(mbs: exu.MainSystem) -> list[Any]:
    """Rigid markers on ground and on a body."""
    ground = mbs.AddObject(exu.ObjectGround())
    body = mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [0.1, 0.1, 0.1]))
    return [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=number)) for number in (ground, body)]


def test_values_written_into_an_array_are_checked_by_assemble(mbs: exu.MainSystem) -> None:
    joint = exu.RevoluteJointZ("hinge", markerNumbers=pair(mbs))
    joint.rotationMarker1[:] *= 3
    mbs.AddObject(joint)
    text = r"^object 2 'hinge' \(ObjectJointRevoluteZ\), parameter 'rotationMarker1': .*a rotation matrix.*by up to 8\."
    with pytest.raises(ValueError, match=text):
        mbs.Assemble()
    torus = exu.ObjectContactSphereTorus  # its default has no direction
    assert torus(torusAxis=[0, 0, 0]) == torus()


# ---- functions in Python ------------------------------------------------------------------------------------------------
TWICE, MIRROR = 2 * np.eye(3), np.diag([1.0, 1.0, -1.0])


def transformation(A: Any) -> Any:
    T = np.eye(4)
    T[:3, :3] = A
    return T


def plucker(A: Any) -> Any:
    return np.kron(np.eye(2), A)


FUNCTIONS: dict[str, Callable[[exu.MainSystem, Any], Any]] = {
    "referenceRotationMatrix": lambda mbs, A: mbs.CreateGround(referenceRotationMatrix=A),
    "CreateRigidBody.*referenceRotationMatrix": lambda mbs, A: mbs.CreateRigidBody(
        inertia=InertiaSphere(1, 1), referenceRotationMatrix=A
    ),
    "initialRotationMatrix": lambda mbs, A: mbs.CreateRigidBody(inertia=InertiaSphere(1, 1), initialRotationMatrix=A),
    "rotationMatrixAxes": lambda mbs, A: mbs.CreateGenericJoint(
        bodyNumbers=[mbs.CreateGround(), mbs.CreateGround()], position=[0, 0, 0], rotationMatrixAxes=A
    ),
    "rotationMatrixJoint": lambda mbs, A: mbs.CreateRigidBodySpringDamper(
        bodyNumbers=[mbs.CreateGround(), mbs.CreateGround()], rotationMatrixJoint=A
    ),
    "GetRigidBodyNode: rotationMatrix": lambda mbs, A: GetRigidBodyNode("RotationRxyz", rotationMatrix=A),
    "rotationMatrix: ": lambda mbs, A: RotationMatrix2EulerParameters(A),
    "rotationMatrix:": lambda mbs, A: RotationMatrix2RotXYZ(A),
    "rotationMatrix": lambda mbs, A: RotationMatrix2RotationVector(A),
    "rotationMatri.": lambda mbs, A: RotationMatrix2RotZYZ(A, False),
    "rotationMatr..": lambda mbs, A: LogSO3(A),
    "R: ": lambda mbs, A: R3xSO3Matrix([0, 0, 0], A),
    "A: ": lambda mbs, A: HomogeneousTransformation(A, [0, 0, 0]),
    "A:": lambda mbs, A: RotationTranslation2T66(A, [0, 0, 0]),
    "A:.": lambda mbs, A: RotationTranslation2T66Inverse(A, [0, 0, 0]),
    "T: ": lambda mbs, A: InverseHT(transformation(A)),
    "T:": lambda mbs, A: HT2rotationMatrix(transformation(A)),
    "T:.": lambda mbs, A: HT2T66Inverse(transformation(A)),
    r"T66\[": lambda mbs, A: T66Inverse(plucker(A)),
    r"T66\[:": lambda mbs, A: InverseT66toRotationTranslation(plucker(A)),
    "Rotated: rot": lambda mbs, A: InertiaCuboid(1, [1, 2, 3]).Rotated(A),
    "Transformed: HT": lambda mbs, A: InertiaCuboid(1, [1, 2, 3]).Transformed(transformation(A)),
    "jointHT": lambda mbs, A: TreeLink(InertiaSphere(1, 1), jointHT=transformation(A)),
    "listOfRotations": lambda mbs, A: KinematicTree33(["Rz"], [A], [[0, 0, 0]], [np.eye(3)], [[0, 0, 0]], [1]),
}


@pytest.mark.parametrize("argument", FUNCTIONS)
def test_functions_reject_invalid_rotations(mbs: exu.MainSystem, argument: str) -> None:
    call = FUNCTIONS[argument]
    call(mbs, RotationMatrixZ(0.3))
    for matrix, reason in (
        (TWICE, "not orthogonal: A A^T differs from the identity matrix by up to 3."),
        (SHEAR, "not orthogonal: A A^T differs from the identity matrix by up to 0.1."),
        (MIRROR, "a reflection: its determinant is -1"),
        (np.full((3, 3), np.nan), ""),
    ):
        with pytest.raises(ValueError, match=argument) as caught:
            call(mbs, matrix)
        assert reason in str(caught.value)


def test_a_transformation_ends_with_its_row(mbs: exu.MainSystem) -> None:
    T = np.eye(4)
    T[3, 0] = 0.1
    with pytest.raises(ValueError, match=r"Its last row is \[0.1, 0.0, 0.0, 1.0\]"):
        InverseHT(T)


@pytest.mark.parametrize(
    "change", [{"axisVector": [2, 0, 0]}, {"planeNormal": [0, 0, 0]}, {"planeNormal": [0, 1, 1]}], ids=str
)
@pytest.mark.parametrize("method", ["CreateRollingDisc", "CreateRollingDiscPenalty"])
def test_rolling_discs_have_unit_vectors(mbs: exu.MainSystem, method: str, change: dict[str, Any]) -> None:
    bodies = [mbs.CreateGround(), mbs.CreateRigidBody(inertia=InertiaSphere(1, 1))]
    before = repr(mbs)
    with pytest.raises(ValueError, match=f"argument '{next(iter(change))}': expected a vector of length 1"):
        getattr(mbs, method)(bodyNumbers=bodies, axisPosition=[0, 0, 0], discRadius=1, **change)
    assert repr(mbs) == before


def test_a_torsional_spring_has_an_axis(mbs: exu.MainSystem) -> None:
    bodies = [mbs.CreateGround(), mbs.CreateRigidBody(inertia=InertiaSphere(1, 1))]
    with pytest.raises(ValueError, match="argument 'axis': expected a vector with 3 components that is not zero"):
        mbs.CreateTorsionalSpringDamper(bodyNumbers=bodies, position=[0, 0, 0], stiffness=1)


# ---- nodes --------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("node", "parameter", "text"),
    [
        (exu.NodeRigidBodyEP(), "referenceCoordinates", "values of length 0"),
        (exu.NodeRigidBodyEP(referenceCoordinates=[0, 0, 0, 1, 0.1, 0, 0]), "referenceCoordinates", "1.00498756"),
        (
            exu.NodeRigidBodyEP(
                referenceCoordinates=[0, 0, 0, 1, 0, 0, 0], initialCoordinates=[0, 0, 0, 0, 1e-3, 0, 0]
            ),
            "initialCoordinates",
            "values of length 1.0000005",
        ),
        (exu.NodePoint2DSlope1(referenceCoordinates=[1, 2, 0, 0]), "referenceCoordinates", "has no length"),
        (exu.NodePoint2DSlope1(initialCoordinates=[1, 2, -1, 0]), "initialCoordinates", "has no length"),
        (exu.NodePointSlope1(referenceCoordinates=[1, 2, 3, 0, 0, 0]), "referenceCoordinates", "has no length"),
        (exu.NodePointSlope1(initialCoordinates=[1, 2, 3, -1, 0, 0]), "initialCoordinates", "has no length"),
        (exu.Node1D(referenceCoordinates=[1, 2]), "referenceCoordinates", "received 2 values, but expected 1"),
        (exu.Node1D(initialVelocities=[1, 2, 3]), "initialVelocities", "received 3 values, but expected 1"),
    ],
    ids=lambda value: value if isinstance(value, str) else type(value).__name__,
)
def test_coordinates_of_nodes(mbs: exu.MainSystem, node: Any, parameter: str, text: str) -> None:
    mbs.AddNode(node)
    where = f"node 0 'node0' ({type(node).__name__}), parameter '{parameter}': "
    with pytest.raises(ValueError, match="^" + re.escape(where) + f".*{re.escape(text)}"):
        mbs.Assemble()


def test_node_1d_takes_nothing_for_zero(mbs: exu.MainSystem) -> None:
    mbs.AddObject(
        exu.Mass1D(nodeNumber=mbs.AddNode(exu.Node1D(referenceCoordinates=[], initialVelocities=[])), physicsMass=1)
    )
    mbs.Assemble()
    assert mbs.systemData.GetODE2CoordinatesTotal().tolist() == [0]


# ---- inertia ------------------------------------------------------------------------------------------------------------
def rigid_body(mbs: exu.MainSystem, mass: float, inertia: Any, com: Any = (0, 0, 0)) -> None:
    node = mbs.AddNode(exu.NodeRigidBodyRxyz())
    mbs.AddObject(exu.RigidBody("top", mass, inertia, com, nodeNumber=node))


@pytest.mark.parametrize(
    ("mass", "inertia", "com"),
    [
        (1, [1, 1, -0.1, 0, 0, 0], [0, 0, 0]),
        (1, [1, 1, 1, 0, 0, 1.1], [0, 0, 0]),  # principal moments 2.1, -0.1
        (2, [1, 1, 1, 0, 0, 0], [0, 0, 1]),  # 1 - 2 about the centre of mass
    ],
    ids=["negative", "product of inertia", "about the reference point"],
)
def test_inertia_of_no_body_is_refused(mbs: exu.MainSystem, mass: float, inertia: Any, com: Any) -> None:
    rigid_body(mbs, mass, inertia, com)
    text = "object 0 'top' (ObjectRigidBody), parameter 'physicsInertia': a principal moment about the center of mass is negative"
    with pytest.raises(ValueError, match="^" + re.escape(text)):
        mbs.Assemble()


def test_a_planar_body_has_its_inertia_about_the_node(mbs: exu.MainSystem) -> None:
    mbs.AddObject(exu.RigidBody2D("flat", 2, 1.9, [1, 0], nodeNumber=mbs.AddNode(exu.NodeRigidBody2D())))
    with pytest.raises(ValueError, match=r"'flat' \(ObjectRigidBody2D\), parameter 'physicsInertia': .* it is -0.1"):
        mbs.Assemble()
    mbs.SetObjectParameter(0, "physicsInertia", 2)  # a mass point
    mbs.Assemble()


def test_moments_that_exceed_the_sum_of_the_others_are_doubtful(mbs: exu.MainSystem) -> None:
    """Models are computed with them."""
    for _ in range(3):
        mbs.AddObject(exu.RigidBody("", 1, [1, 1, 3, 0, 0, 0], nodeNumber=mbs.AddNode(exu.NodeRigidBodyRxyz())))
    text = r"^object 0 'object0' \(ObjectRigidBody\): a principal moment .* 1, 1 and 3\. So have 2 other objects\."
    with pytest.warns(UserWarning, match=text):
        mbs.Assemble()
    assert mbs.systemIsConsistent


@pytest.mark.parametrize(
    ("mass", "inertia", "com"),
    [
        (3, [0, 4, 4, 0, 0, 0], [0, 0, 0]),  # a thin rod
        (3, [1, 1, 2, 0, 0, 0], [0, 0, 0]),  # a thin plate
        (2, [0, 18, 18, 0, 0, 0], [3, 0, 0]),  # a mass point
        (2, [0.1667, 0.1667, 0.3334, 0, 0, 0], [0, 0, 0]),  # a thin plate, typed with few digits
        (1, [0, 0, 0, 0, 0, 0], [0, 0, 0]),
    ],
)
def test_limits_of_inertia_are_bodies(mbs: exu.MainSystem, mass: float, inertia: Any, com: Any) -> None:
    rigid_body(mbs, mass, inertia, com)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        mbs.Assemble()


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: InertiaCuboid(-1, [1, 1, 1]), "InertiaCuboid: density"),
        (lambda: InertiaCuboid(1, [1, -1, 1]), "InertiaCuboid: sideLengths"),
        (lambda: InertiaRodX(1, -1), "InertiaRodX: length"),
        (lambda: InertiaRodX(-1, 1), "InertiaRodX: mass"),
        (lambda: InertiaMassPoint(-1), "InertiaMassPoint: mass"),
        (lambda: InertiaSphere(mass=-1, radius=1), "InertiaSphere: mass"),
        (lambda: InertiaSphere(density=-1, radius=1), "InertiaSphere: density"),
        (lambda: InertiaSphere(mass=1, radius=-1), "InertiaSphere: radius"),
        (lambda: InertiaHollowSphere(1, -1), "InertiaHollowSphere: radius"),
        (lambda: InertiaCylinder(-1, 1, 1, 0), "InertiaCylinder: density"),
        (lambda: InertiaCylinder(1, -1, 1, 0), "InertiaCylinder: length"),
        (lambda: InertiaCylinder(1, 1, -1, 0), "InertiaCylinder: outerRadius"),
        (lambda: InertiaCylinder(1, 1, 1, 0, -0.5), "InertiaCylinder: innerRadius"),
        (lambda: InertiaCylinder(1, 1, 0.5, 0, 0.7), "InertiaCylinder: innerRadius: expected at most outerRadius=0.5"),
        (lambda: InertiaCuboid(float("nan"), [1, 1, 1]), "InertiaCuboid: density"),
        (lambda: RigidBodyInertia(1, np.diag([1, 1, -1])), "without negative principal moments"),
        (lambda: RigidBodyInertia(2, np.eye(3), [0, 0, 1]), "without negative principal moments"),
    ],
    ids=range(17),
)
def test_inertia_functions_reject_impossible_shapes(make: Any, text: str) -> None:
    with pytest.raises(ValueError, match=text):
        make()


# ---- connectors ---------------------------------------------------------------------------------------------------------
PAIRS = [
    item for item in ITEMS if item.ready and any(r.name == "markerNumbers" and r.size == 2 for r in item.parameters)
]


@pytest.mark.parametrize("item", PAIRS, ids=[item.name for item in PAIRS])
def test_a_marker_is_not_connected_with_itself(mbs: exu.MainSystem, item: Item) -> None:
    ground = mbs.AddNode(exu.NodePointGround())
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=ground, coordinate=0))
    if "Coordinate" not in item.requested_markers:
        marker = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    others: dict[str, Any] = {"torusAxis": [0, 0, 1]} if item.name == "ObjectContactSphereTorus" else {}
    if item.requested_nodes and "nodeNumber" in {row.name for row in item.parameters}:
        others["nodeNumber"] = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=1))
    if "nodeNumbers" in {row.name for row in item.parameters}:
        others["nodeNumbers"] = [ground, ground]
    number = mbs.AddObject(CLASSES[item.name](markerNumbers=[marker, marker], **others))
    where = f"object {int(number)} 'object{int(number)}' ({item.name}), parameter 'markerNumbers': received marker "
    with pytest.raises(ValueError, match="^" + re.escape(where) + ".* twice, but expected two different markers"):
        mbs.Assemble()


HOLDING = [
    item for item in PAIRS if item.object_type in ("Joint", "Constraint") and "Position" in item.requested_markers
]


@pytest.mark.parametrize("on", ["body", "body and its node", "two grounds"])
@pytest.mark.parametrize("item", HOLDING, ids=[item.name for item in HOLDING])
def test_a_body_is_not_joined_to_itself(mbs: exu.MainSystem, item: Item, on: str) -> None:
    node = mbs.AddNode(exu.NodeRigidBodyRxyz())
    body = mbs.AddObject(exu.RigidBody(physicsMass=1, physicsInertia=[1, 1, 1, 0, 0, 0], nodeNumber=node))
    at = lambda number, x: exu.MarkerBodyRigid(bodyNumber=number, localPosition=[x, 0, 0])  # noqa: E731
    markers = {
        "body": lambda: [at(body, 0), at(body, 1)],
        "body and its node": lambda: [at(body, 1), exu.MarkerNodeRigid(nodeNumber=node)],
        "two grounds": lambda: [at(mbs.AddObject(exu.ObjectGround()), x) for x in (0, 1)],
    }[on]()
    mbs.AddObject(CLASSES[item.name](markerNumbers=[mbs.AddMarker(marker) for marker in markers]))
    text = "'markerNumbers': received two markers on " + ("ground" if on == "two grounds" else "node 0 'node0'")
    with pytest.raises(ValueError, match=text + ".*A body cannot be joined to itself"):
        mbs.Assemble()


def test_springs_and_coordinates_of_one_body_are_connected(mbs: exu.MainSystem) -> None:
    first, second = pair(mbs)
    body = mbs.GetMarker(second)["bodyNumber"]
    other = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=[1, 0, 0]))
    mbs.AddObject(exu.SpringDamper(markerNumbers=[second, other]))
    node = mbs.GetObject(body)["nodeNumber"]
    coordinates = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=i)) for i in range(2)]
    mbs.AddObject(exu.CoordinateConstraint(markerNumbers=coordinates))
    mbs.Assemble()


@pytest.mark.parametrize(
    "create",
    [
        lambda mbs, pair: mbs.CreateRevoluteJoint(bodyNumbers=pair, position=[0, 0, 0], axis=[0, 0, 1]),
        lambda mbs, pair: mbs.CreatePrismaticJoint(bodyNumbers=pair, position=[0, 0, 0], axis=[0, 0, 1]),
        lambda mbs, pair: mbs.CreateSphericalJoint(bodyNumbers=pair, position=[0, 0, 0]),
        lambda mbs, pair: mbs.CreateGenericJoint(bodyNumbers=pair, position=[0, 0, 0]),
        lambda mbs, pair: mbs.CreateTorsionalSpringDamper(bodyNumbers=pair, position=[0, 0, 0], axis=[0, 0, 1]),
        lambda mbs, pair: mbs.CreateRollingDisc(bodyNumbers=pair, axisPosition=[0, 0, 0], discRadius=1),
        lambda mbs, pair: mbs.CreateRollingDiscPenalty(bodyNumbers=pair, axisPosition=[0, 0, 0], discRadius=1),
    ],
    ids=range(7),
)
def test_create_functions_join_two_bodies(mbs: exu.MainSystem, create: Any) -> None:
    body = mbs.CreateRigidBody(inertia=InertiaSphere(1, 1))
    before = repr(mbs)
    with pytest.raises(ValueError, match="argument 'bodyNumbers': expected two different bodies"):
        create(mbs, [body, body])
    assert repr(mbs) == before


OF_FRAMES = [
    item
    for item in ITEMS
    if item.ready and {"Position", "Orientation"} & {*item.requested_markers} and item.kind == "load"
]


@pytest.mark.parametrize(
    "marker", ["MarkerBodiesRelativeTranslationCoordinate", "MarkerBodiesRelativeRotationCoordinate"]
)
@pytest.mark.parametrize("item", [*OF_FRAMES, *HOLDING], ids=lambda item: item.name)
def test_a_coordinate_between_frames_is_no_frame(mbs: exu.MainSystem, item: Item, marker: str) -> None:
    bodies = [
        mbs.AddObject(
            exu.RigidBody(
                physicsMass=1,
                physicsInertia=[1, 1, 1, 0, 0, 0],
                nodeNumber=mbs.AddNode(exu.NodeRigidBodyRxyz(referenceCoordinates=[i, 0, 0, 0, 0, 0])),
            )
        )
        for i in range(2)
    ]
    number = mbs.AddMarker(CLASSES[marker](bodyNumbers=bodies))
    other = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=bodies[0]))
    markers = {"markerNumber": number} if item.kind == "load" else {"markerNumbers": [other, number]}
    getattr(mbs, f"Add{item.kind.title()}")(CLASSES[item.name](**markers))
    with pytest.raises(
        ValueError,
        match=rf"\({item.name}\), parameter 'markerNumber.*{marker}\), which provides .*Coordinate, but expected",
    ):
        mbs.Assemble()
