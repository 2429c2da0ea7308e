"""Create functions: the added items with their parameters, and rejected arguments."""

import inspect
import json
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import create_cases

import dalembert as exu
from dalembert import create
from dalembert import itemInterface as items
from dalembert import mainSystemExtensions as extensions
from dalembert.create._examples import EXAMPLES

EXPECTED = json.loads((Path(__file__).parent / "data" / "create_items.json").read_text())


@pytest.fixture
def mbs():
    container = exu.SystemContainer()
    yield container.AddSystem()


def call(mbs, function, arguments):
    return getattr(mbs, function)(**arguments)


def close(value, expected, tolerance):
    """Compare numbers with a relative tolerance, all else exactly."""
    if isinstance(expected, list):
        same_size = isinstance(value, list) and len(value) == len(expected)
        return same_size and all(close(v, e, tolerance) for v, e in zip(value, expected, strict=True))
    if isinstance(expected, float) and isinstance(value, (int, float)):
        return abs(value - expected) <= tolerance * max(1.0, abs(expected))
    return value == expected


def wrong_parameters(item, expected):
    """Return {name: (value, expected)} of differences; drawing parameters are expected in single precision."""
    return {
        key: (item.get(key), value)
        for key, value in expected.items()
        if not close(item.get(key), value, 1e-7 if key.startswith("V") else 1e-11)
    }


@pytest.mark.parametrize("name", create_cases.CASES)
def test_items_are_those_of_the_interface(mbs, name):
    function, arguments = create_cases.CASES[name]
    numbers = create_cases.base_model(mbs, exu, items, lambda f, a: call(mbs, f, a))
    before = create_cases.counts(mbs)
    call(mbs, function, create_cases.resolved(arguments, numbers))
    added = create_cases.added_items(mbs, before)
    assert [(kind, item[f"{kind.lower()}Type"]) for kind, item in added] == [
        (kind, item[f"{kind.lower()}Type"]) for kind, item in EXPECTED[name]
    ]
    for (_, item), (_, expected) in zip(added, EXPECTED[name], strict=True):
        assert not wrong_parameters(item, expected)


def test_every_implemented_function_has_a_case():
    functions = {function for function, _ in create_cases.CASES.values()}
    elsewhere = {
        "CreateFFRFReducedOrderObject",  # see tests/fem/test_bodies.py
        "CreateDistanceSensor", "CreateDistanceSensorGeometry",  # see tests/solvers/test_contact_interface.py
        "CreateRobot",  # see test_robot_trees.py
        "CreateFixedJoint", "CreateCylindricalJoint", "CreateUniversalJoint",  # see test_create_joints_and_shapes.py
        "CreateBox", "CreateCylinder", "CreateSphere",
        "CreateMotor", "CreatePIDController", "CreateJointStops", "CreatePrescribedMotion",  # see test_drives.py
        "CreateForceFromTable", "CreateTorqueFromTable",
        "CreateCable", "CreateBeam", "CreateRope", "CreateHydraulicCylinder",  # see test_create_lines.py
        "CreateBelt",  # see test_create_belts.py
        "CreateLinearSpringDamper",  # see test_linear_spring_damper.py
    }  # fmt: skip
    assert functions == set(create.functions) - elsewhere


@pytest.mark.parametrize("name", create.functions)
def test_methods_are_attached(name):
    assert getattr(exu.MainSystem, name) is create.functions[name]
    assert next(iter(inspect.signature(create.functions[name]).parameters)) == "mbs"


def test_lists_given_by_the_caller_stay_as_they_are(mbs):
    ground = mbs.CreateGround()
    body = mbs.CreateRigidBody(inertia=create_cases.BAR)
    pair, position = [ground, body], [0.0, 0.0, 0.0]
    mbs.CreateRevoluteJoint(bodyNumbers=pair, position=position, axis=[0, 0, 1])
    mbs.CreateSpringDamper(bodyNumbers=pair, localPosition0=position, localPosition1=[1, 0, 0])
    assert pair == [ground, body] and position == [0.0, 0.0, 0.0]
    assert create._arguments.ZERO3 == [0.0, 0.0, 0.0] and create._arguments.NO_PAIR == [None, None]


def test_numbers_of_all_parts_are_returned_on_request(mbs):
    numbers = mbs.CreateMassPoint(physicsMass=1, gravity=[0, 0, -9.81], returnDict=True)
    assert set(numbers) == {"nodeNumber", "bodyNumber", "markerBodyMass", "loadNumber"}
    assert set(mbs.CreateRigidBody(inertia=create_cases.BAR, returnDict=True)) == {"nodeNumber", "bodyNumber"}


def test_coordinates_count_over_all_nodes_of_a_body(mbs):
    nodes = [mbs.AddNode(items.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    cable = items.ObjectANCFCable2D(
        physicsLength=1,
        physicsMassPerLength=1,
        physicsBendingStiffness=1,
        physicsAxialStiffness=1,
        nodeNumbers=nodes,
    )
    body = mbs.AddObject(cable)
    constraint = mbs.CreateCoordinateConstraint(bodyNumbers=[None, body], coordinates=[None, 5])
    marker = mbs.GetMarker(mbs.GetObject(constraint)["markerNumbers"][1])
    assert int(marker["nodeNumber"]) == int(nodes[1]) and marker["coordinate"] == 1


def test_the_joint_position_is_the_same_point_of_both_bodies(mbs):
    numbers = create_cases.base_model(mbs, exu, items, lambda f, a: call(mbs, f, a))
    joint = mbs.CreateGenericJoint(bodyNumbers=[numbers["body"], numbers["other"]], position=[0.3, -0.2, 0.7])
    reference = exu.ConfigurationType.Reference
    positions = [
        mbs.GetMarkerOutput(marker, exu.OutputVariableType.Position, reference)
        for marker in mbs.GetObject(joint)["markerNumbers"]
    ]
    assert np.allclose(positions, [[0.3, -0.2, 0.7]] * 2, atol=1e-14)


BODY = {"inertia": create_cases.BAR}

WRONG = {
    "vector size": (
        "CreateGround",
        {"referencePosition": [1, 2]},
        ValueError,
        "referencePosition.*3 finite components",
    ),
    "not a number": ("CreateMassPoint", {"gravity": [0, np.nan, 0]}, ValueError, "gravity.*finite"),
    "matrix size": ("CreateGround", {"referenceRotationMatrix": np.eye(2)}, ValueError, "referenceRotationMatrix.*3x3"),
    "name": ("CreateGround", {"name": 3}, ValueError, "name.*a string"),
    "unknown argument": ("CreateRigidBody", BODY | {"intertia": 3}, TypeError, "intertia.*Did you mean 'inertia'"),
    "no inertia": ("CreateRigidBody", {}, ValueError, "inertia.*RigidBodyInertia"),
    "node type": ("CreateRigidBody", BODY | {"nodeType": 17}, ValueError, "nodeType.*RotationEulerParameters"),
    "out of plane": (
        "CreateRigidBody",
        BODY | {"create2D": True, "initialVelocity": [0, 0, 1]},
        ValueError,
        "initialVelocity.*without z",
    ),
    "tilted plane": (
        "CreateRigidBody",
        BODY | {"create2D": True, "referenceRotationMatrix": create_cases.TILTED},
        ValueError,
        "referenceRotationMatrix.*rotation about z",
    ),
    "no bodies": ("CreateSpringDamper", {"stiffness": 1}, ValueError, r"bodyNumbers\[0\].*ObjectIndex"),
    "one body": ("CreateSphericalJoint", {"bodyNumbers": [0]}, ValueError, "bodyNumbers.*list of 2"),
    "node with local position": (
        "CreateSpringDamper",
        {"bodyNumbers": [exu.NodeIndex(0), exu.NodeIndex(0)], "localPosition1": [1, 0, 0]},
        ValueError,
        r"localPosition1.*\[0,0,0\]",
    ),
    "marker with position": (
        "CreateSphericalJoint",
        {"bodyNumbers": [exu.MarkerIndex(0), exu.ObjectIndex(0)], "position": [1, 0, 0]},
        ValueError,
        r"position.*\[\], because a marker",
    ),
    "node in a joint": (
        "CreateRevoluteJoint",
        {"bodyNumbers": [exu.NodeIndex(0), exu.ObjectIndex(0)], "position": [0, 0, 0], "axis": [1, 0, 0]},
        ValueError,
        r"bodyNumbers\[0\].*ObjectIndex or a MarkerIndex",
    ),
    "no axis": ("CreatePrismaticJoint", {"bodyNumbers": [0, 0], "position": [0, 0, 0]}, ValueError, "axis.*not zero"),
    "flags": ("CreateGenericJoint", {"constrainedAxes": [1, 1, 1, 2, 0, 0]}, ValueError, "constrainedAxes.*0 or 1"),
    "negative distance": ("CreateDistanceConstraint", {"distance": -1}, ValueError, "distance.*not negative"),
    "only ground": ("CreateCoordinateConstraint", {"coordinates": [0, 0]}, ValueError, "bodyNumbers.*not ground"),
    "load without body": ("CreateForce", {"loadVector": [1, 0, 0]}, ValueError, "bodyNumber.*ObjectIndex"),
}


@pytest.mark.parametrize("name", WRONG)
def test_wrong_arguments_are_named_and_leave_the_system_alone(mbs, name):
    function, arguments, error, text = WRONG[name]
    with pytest.raises(error, match=rf"(?s)MainSystem\.{function}\(.*{text}"):
        getattr(mbs, function)(**arguments)
    assert sum(create_cases.counts(mbs).values()) == 0


AXIS = {"axis": [0, 0, 1]}
PLACE = {"position": [0, 0, 0]}
NEEDS_PLACES = {
    "CreateRevoluteJoint": PLACE | AXIS,
    "CreatePrismaticJoint": PLACE | AXIS,
    "CreateSphericalJoint": PLACE,
    "CreateGenericJoint": PLACE,
    "CreateSpringDamper": {},
    "CreateRigidBodySpringDamper": {},
    "CreateTorsionalSpringDamper": PLACE | AXIS,
    "CreateDistanceConstraint": {},
}


@pytest.mark.parametrize("function", NEEDS_PLACES)
@pytest.mark.parametrize("number", [2, -1, exu.ObjectIndex(7)])
def test_bodies_that_do_not_exist_are_named_by_function_and_argument(mbs, function, number):
    ground, _ = mbs.CreateGround(), mbs.CreateRigidBody(inertia=create_cases.BAR)
    before = create_cases.counts(mbs)
    expected = rf"MainSystem\.{function}\(.*'bodyNumbers\[1\]'.*an object of this MainSystem, which has 2"
    with pytest.raises(ValueError, match=expected):
        getattr(mbs, function)(bodyNumbers=[ground, number], **NEEDS_PLACES[function])
    assert create_cases.counts(mbs) == before


def test_nodes_and_markers_that_do_not_exist_are_named(mbs):
    ground = mbs.CreateGround()
    with pytest.raises(ValueError, match=r"CreateSphericalJoint\(.*bodyNumbers\[0\].*a marker of this .* has 0"):
        mbs.CreateSphericalJoint(bodyNumbers=[exu.MarkerIndex(0), ground])
    with pytest.raises(ValueError, match=r"CreateSpringDamper\(.*bodyOrNodeList\[1\].*a node of this .* has 0"):
        mbs.CreateSpringDamper(bodyOrNodeList=[ground, exu.NodeIndex(3)])


def test_a_coordinate_that_a_body_does_not_have_is_refused(mbs):
    body = mbs.CreateMassPoint(physicsMass=1)
    with pytest.raises(ValueError, match=r"coordinates\[1\].*less than 3"):
        mbs.CreateCoordinateConstraint(bodyNumbers=[None, body], coordinates=[None, 3])


@pytest.mark.parametrize("other", ["bodyOrNodeList", "bodyList"])
def test_ends_that_are_given_twice_are_refused(mbs, other):
    """It is ambiguous."""
    ground, mass = mbs.CreateGround(), mbs.CreateMassPoint(physicsMass=1, referencePosition=[1, 0, 0])
    expected = rf"MainSystem\.CreateSpringDamper\(.*'{other}': expected \[None, None\], as bodyNumbers is given"
    with pytest.raises(ValueError, match=expected):
        mbs.CreateSpringDamper(bodyNumbers=[ground, mass], stiffness=1, **{other: [mass, ground]})


@pytest.mark.parametrize(("given", "size"), [({}, 0), ({"drawSize": 0.3}, 0.3)])
def test_a_body_in_the_shape_of_its_inertia_has_a_node_of_the_size_that_is_asked_for(mbs, given, size):
    body = mbs.CreateRigidBody(inertia=create_cases.BAR, color=[1, 0, 0, 1], **given)
    node = mbs.GetNode(mbs.GetObject(body)["nodeNumber"])
    assert node["VdrawSize"] == pytest.approx(size, rel=1e-6)  # single precision


# ---- parts of Create functions
# -----------------------------------------------------------------------------------------

TURN = np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]])


@pytest.fixture
def pair(mbs):
    """Ground at [1, 2, 3], and a body at [1, 0, 0] that is turned by a quarter about z."""
    ground = mbs.CreateGround(referencePosition=[1, 2, 3])
    body = mbs.CreateRigidBody(referencePosition=[1, 0, 0], referenceRotationMatrix=TURN, inertia=create_cases.BAR)
    return [ground, body]


def test_axes_of_joints():
    for i, letter in enumerate("XYZ"):
        for kind in ("Revolute", "Prismatic"):
            assert np.array_equal(extensions.JointTypeToAxis(getattr(exu.JointType, kind + letter)), np.eye(3)[i])
    with pytest.raises(ValueError, match="expected a revolute or prismatic joint"):
        extensions.JointTypeToAxis(exu.JointType._None)


def test_place_of_a_joint(mbs, pair):
    check = extensions.JointPreCheckCalcBodyMarkers
    p0, a0, p1, a1, m0, m1, point = check("CreateMine", mbs, "name", pair, [0.5, 0, 0], True, True)
    assert np.array_equal([p0, p1, point], [[1, 2, 3], [1, 0, 0], [0.5, 0, 0]])
    assert np.allclose([a0, a1], [np.eye(3), TURN], rtol=0, atol=1e-15) and m0 is m1 is None
    assert np.array_equal(check("CreateMine", mbs, "", pair, [0.5, 0, 0], True, False)[6], [1.5, 2, 3])
    with pytest.raises(ValueError, match=r"CreateMine.*bodyNumbers\[1\]"):
        check("CreateMine", mbs, "", [pair[0], None], [0, 0, 0], True, True)


def test_ends_of_a_connector(mbs, pair):
    node = exu.NodeIndex(0)
    process, none = extensions.ProcessBodyNodeMarkerLists, [None, None]
    assert process(pair, none, [0, 0, 0], [0, 0, 1], "CreateMine") == pair
    assert process(none, [node, pair[1]], [0, 0, 0], [0, 0, 1], "CreateMine") == [node, pair[1]]
    with pytest.raises(ValueError, match=r"CreateMine.*localPosition1"):
        process(none, [pair[1], node], [0, 0, 0], [0, 0, 1], "CreateMine")


def test_markers_with_their_places(mbs, pair):
    get, local = extensions.GetMarkersPosRot, ([0, 0, 0.5], [0, 1, 0])
    plain = get(mbs, "plain", pair, *local)
    assert plain[2:] == [None] * 4
    assert [mbs.GetMarker(m)["markerType"] for m in plain[:2]] == ["BodyPosition"] * 2
    assert [mbs.GetMarker(m)["name"] for m in plain[:2]] == ["Marker0:plain", "Marker1:plain"]
    full = get(mbs, "full", pair, *local, getPosition=True, getRotationMatrix=True, useRigidMarker=True)
    assert np.allclose(full[2:4], [[1, 2, 3.5], [0, 0, 0]], rtol=0, atol=1e-15)
    assert np.allclose(full[4:], [np.eye(3), TURN], rtol=0, atol=1e-15)
    assert [mbs.GetMarker(m)["markerType"] for m in full[:2]] == ["BodyRigid"] * 2
    assert get(mbs, "", full[:2], [0, 0, 0], [0, 0, 0])[:2] == full[:2]


@pytest.mark.parametrize("name", create.functions)
def test_examples_of_docstrings_run(mbs, name, tmp_path, monkeypatch):
    """Each is a model that assembles and can be solved; help() shows it. No example leaves a file in the working folder."""
    monkeypatch.chdir(tmp_path)
    code = EXAMPLES[name].strip()
    assert all(line.strip() in create.functions[name].__doc__ for line in code.splitlines())
    assert f"mbs.{name}(" in code
    scope = {"mbs": mbs}
    exec(f"import dalembert as exu\nfrom dalembert.utilities import *\n{code}", scope)
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.01, 10
    settings.solutionSettings.writeSolutionToFile = False
    assert mbs.SolveDynamic(settings)
    assert not list(tmp_path.iterdir())


def test_failures_do_not_change_the_system():
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround("ground")
    body = mbs.CreateMassPoint("body", [1, 0, 0], physicsMass=1, gravity=[0, -9.81, 0])
    mbs.CreateForce("push", ground, [1, 0, 0])
    before = repr(mbs.GetDictionary())
    for wrong in (
        lambda: mbs.CreateMassPoint("ground", [2, 0, 0], physicsMass=1),  # after its node
        lambda: mbs.CreateRigidBody("ground", [2, 0, 0], inertia=exu.utilities.InertiaCuboid(1, [1, 1, 1])),
        lambda: mbs.CreateSpringDamper("body", [ground, body], stiffness=1),  # after two markers
        lambda: mbs.CreateForce("push", body, [1, 0, 0]),  # after its marker
    ):
        with pytest.raises(ValueError, match="belongs to"):
            wrong()
        assert repr(mbs.GetDictionary()) == before
    mbs.CreateMassPoint("other", [2, 0, 0], physicsMass=1)


@pytest.mark.parametrize("kind", ["RotationEulerParameters", "RotationRxyz", "RotationRotationVector"])
def test_initial_angular_velocity_is_global_for_any_rotation(kind):
    """It was turned by the initial rotation, as the rates of parameters were those at the reference orientation."""
    import dalembert as exu
    from dalembert.utilities import InertiaCuboid, RotationMatrixX, RotationMatrixY, RotationMatrixZ

    reference = RotationMatrixZ(0.3) @ RotationMatrixY(-0.4)
    for rotation, omega in ((RotationMatrixX(np.pi / 2), [0, 0, 3.0]), (RotationMatrixY(0.7), [1.0, -2.0, 0.5])):
        mbs = exu.SystemContainer().AddSystem()
        body = mbs.CreateRigidBody(
            referenceRotationMatrix=reference,
            initialRotationMatrix=rotation,
            initialAngularVelocity=omega,
            inertia=InertiaCuboid(1000, [0.1, 0.2, 0.3]),
            nodeType=getattr(exu.NodeType, kind),
        )
        mbs.Assemble()
        output = (body, exu.OutputVariableType.AngularVelocity, [0, 0, 0], exu.ConfigurationType.Initial)
        np.testing.assert_allclose(mbs.GetObjectOutputBody(*output), omega, atol=1e-14)
        output = (body, exu.OutputVariableType.RotationMatrix, [0, 0, 0], exu.ConfigurationType.Initial)
        np.testing.assert_allclose(mbs.GetObjectOutputBody(*output).reshape(3, 3), reference @ rotation, atol=1e-14)


@pytest.mark.parametrize("name", create.functions)
def test_summary_is_a_line(name):
    """The table of Create functions, and stubs, show the first line of the text alone."""
    assert create.functions[name].__doc__.splitlines()[0].endswith(".")
