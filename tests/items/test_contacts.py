"""Contacts of spheres, triangles, rolls and curves against closed forms: impacts, friction, adhesion, and rejected
parameters."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq

import dalembert as exu
from dalembert.utilities import InertiaSphere

RADIUS, MASS, G = 0.1, 0.5, 9.81
OPEN = [1e-3, 0, 0, 0]  # data of a contact that is not closed


def new_system() -> exu.MainSystem:
    return exu.SystemContainer().AddSystem()


def ball(mbs: exu.MainSystem, position: list[float], velocity: list[float] = [0, 0, 0], **options: Any) -> Any:
    body = mbs.CreateRigidBody(
        referencePosition=position, initialVelocity=velocity, inertia=InertiaSphere(MASS, RADIUS), **options
    )
    return body


def solve(mbs: exu.MainSystem, end: float, steps: int, static: bool = False) -> None:
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    time = settings.timeIntegration
    time.endTime, time.numberOfSteps, time.verboseMode = end, steps, 0
    time.generalizedAlpha.spectralRadius = 1
    if static:
        settings.staticSolver.verboseMode = 0
        mbs.SolveStatic(settings)
    else:
        mbs.SolveDynamic(settings)


def output(mbs: exu.MainSystem, body: Any, name: str) -> np.ndarray:
    return np.asarray(mbs.GetObjectOutputBody(body, getattr(exu.OutputVariableType, name), [0, 0, 0]))


def loss_of(model: int, e: float) -> float:
    """The damping factor times the impact velocity."""
    if model == 1:
        return 1.5 * (1 - e)
    return 1.5 * (1 - e) * (11 - e) / (1 + 9 * e) if e > 1 / 3 else (1 - e * e) / e


@pytest.mark.parametrize("model", [1, 2])
@pytest.mark.parametrize("e", [0.9, 0.6, 0.2])
@pytest.mark.parametrize("exponent", [1.0, 1.5])
def test_restitution(model: int, e: float, exponent: float) -> None:
    """Integrated over the impact, u du / (1 + chi u) vanishes: the law that gives the speed after impact for any
    exponent."""
    mbs = new_system()
    first, second = ball(mbs, [0, 0, 0], [1, 0, 0]), ball(mbs, [0.21, 0, 0])
    mbs.CreateSphereSphereContact(
        bodyNumbers=[first, second],
        spheresRadii=[RADIUS, RADIUS],
        contactStiffness=1e5 if exponent == 1 else 1e7,
        contactStiffnessExponent=exponent,
        restitutionCoefficient=e,
        impactModel=model,
        dataInitialCoordinates=[0.01, 0, 0, 0],
    )
    solve(mbs, 0.03, 12000)
    v0, v1 = output(mbs, first, "Velocity")[0], output(mbs, second, "Velocity")[0]
    assert v0 + v1 == pytest.approx(1, abs=1e-9)
    assert v1 - v0 == pytest.approx(speed_after_impact(loss_of(model, e)), abs=5e-3)


def speed_after_impact(chi: float) -> float:
    """Root of the integrated law for an impact with speed 1."""

    def balance(x: float) -> float:
        return chi * (1 + x) - np.log((1 + chi) / (1 - chi * x))

    return float(brentq(balance, 1e-6, min(1.0, 0.999999 / chi)))


@pytest.mark.parametrize("model", [1, 2])
@pytest.mark.parametrize("e", [0.9, 0.6, 0.2])
@pytest.mark.parametrize("exponent", [1.0, 1.5])
def test_restitution_of_coordinates(model: int, e: float, exponent: float) -> None:
    """A mass hits a stop with 1 m/s: the same law as for spheres, with its speed in the second data coordinate."""
    mbs = new_system()
    node = mbs.AddNode(exu.Node1D(referenceCoordinates=[0.01], initialVelocities=[-1]))
    mbs.AddObject(exu.Mass1D(nodeNumber=node, mass=1))
    ground = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(exu.NodePointGround()), coordinate=0))
    marker = mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[0.01, 0]))
    mbs.AddObject(
        exu.ObjectContactCoordinate(
            markerNumbers=[ground, marker],
            nodeNumber=data,
            offset=-0.01,
            contactStiffness=1e5 if exponent == 1 else 1e7,
            contactStiffnessExponent=exponent,
            restitutionCoefficient=e,
            impactModel=model,
        )
    )
    solve(mbs, 0.03, 12000)
    assert mbs.systemData.GetDataCoordinates()[1] == pytest.approx(1, abs=1e-9)
    speed = mbs.GetNodeOutput(node, exu.OutputVariableType.Coordinates_t)
    assert speed == pytest.approx(speed_after_impact(loss_of(model, e)), abs=5e-3)


def test_impact_of_hertz() -> None:
    """Time of contact 2.943 d/v with the greatest penetration d = (5 m v^2 / 4 k)^(2/5)."""
    mbs = new_system()
    ground = mbs.CreateGround()
    body = ball(mbs, [-0.1, 0, 0.101], [0, 0, -1])
    k = 1e7
    contact = mbs.CreateSphereQuadContact(
        name="floor",
        bodyNumbers=[body, ground],
        radiusSphere=RADIUS,
        quadPoints=[[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]],
        contactStiffness=k,
        contactStiffnessExponent=1.5,
        dataInitialCoordinates=OPEN,
    )
    assert [mbs.GetObject(number)["name"] for number in contact.values()] == ["floor0", "floor1"]
    sensors = [
        mbs.AddSensor(
            exu.SensorObject(
                objectNumber=o, outputVariableType=exu.OutputVariableType.Force, storeInternal=True, writeToFile=False
            )
        )
        for o in contact.values()
    ]
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e-6
    time = settings.timeIntegration
    time.endTime, time.numberOfSteps, time.verboseMode = 0.005, 5000, 0
    time.generalizedAlpha.spectralRadius = 1
    mbs.SolveDynamic(settings)
    force = sum(np.asarray(mbs.GetSensorStoredData(s))[:, 3] for s in sensors)
    depth = (5 * MASS / (4 * k)) ** 0.4
    assert force.max() == pytest.approx(k * depth**1.5, rel=1e-3)
    assert np.count_nonzero(force > 0) * 1e-6 == pytest.approx(2.9432 * depth, rel=5e-3)
    assert output(mbs, body, "Velocity")[2] == pytest.approx(1, abs=1e-3)


def plane(mbs: exu.MainSystem, body: Any, friction: float, under: int = 0, size: float = 20, speed: float = 0) -> None:
    """Two triangles; the ball begins on the one of this number, and slips with this speed."""
    contacts = mbs.CreateSphereQuadContact(
        bodyNumbers=[body, mbs.CreateGround()],
        radiusSphere=RADIUS,
        quadPoints=[[-size, -size, 0], [size, -size, 0], [size, size, 0], [-size, size, 0]],
        contactStiffness=1e5,
        contactDamping=300,
        dynamicFriction=friction,
        dataInitialCoordinates=OPEN,
    )
    history = mbs.GetObject(contacts[f"oContact{under}"])["nodeNumber"]
    mbs.SetNodeParameter(history, "initialCoordinates", [-1e-6, speed, 0, 0])


SINK = MASS * G / 1e5


def test_billiard_ball_comes_to_roll() -> None:
    """It slides with friction until it rolls with 5/7 of its speed, after 2 v / (7 mu g)."""
    mbs, mu, speed = new_system(), 0.2, 1.0
    body = ball(mbs, [-1, 0, RADIUS - SINK], [speed, 0, 0], gravity=[0, 0, -G])
    plane(mbs, body, mu, speed=speed)
    until = 2 * speed / (7 * mu * G)
    solve(mbs, 0.9 * until, 400)
    assert output(mbs, body, "Velocity")[0] == pytest.approx(speed - mu * G * 0.9 * until, abs=1e-3)
    solve(mbs, 2 * until, 800)
    assert output(mbs, body, "Velocity")[0] == pytest.approx(5 / 7 * speed, abs=1e-3)
    assert output(mbs, body, "AngularVelocity")[1] * RADIUS == pytest.approx(5 / 7 * speed, abs=2e-3)


@pytest.mark.parametrize(("mu", "share"), [(0.5, 5 / 7), (0.05, None)])
def test_ball_on_an_incline(mu: float, share: float | None) -> None:
    """It rolls where friction is larger than 2/7 of the slope, and slips otherwise."""
    mbs, slope, end = new_system(), 0.4, 0.3
    gravity = [G * np.sin(slope), 0, -G * np.cos(slope)]
    body = ball(mbs, [-1, 0, RADIUS - SINK * np.cos(slope)], gravity=gravity)
    plane(mbs, body, mu)
    solve(mbs, end, 600)
    rate = share * G * np.sin(slope) if share else G * (np.sin(slope) - mu * np.cos(slope))
    assert output(mbs, body, "Velocity")[0] == pytest.approx(rate * end, abs=2e-3)


def test_ball_rolls_over_an_inner_edge() -> None:
    """The diagonal of a quadrangle does not lift it."""
    mbs = new_system()
    body = ball(mbs, [0.3, 0.2, RADIUS - SINK], [-1, -0.7, 0], gravity=[0, 0, -G])
    plane(mbs, body, 0.0, under=1, size=1)
    sensor = mbs.AddSensor(
        exu.SensorBody(
            bodyNumber=body, outputVariableType=exu.OutputVariableType.Position, storeInternal=True, writeToFile=False
        )
    )
    solve(mbs, 0.6, 1200)
    height = np.asarray(mbs.GetSensorStoredData(sensor))[:, 3]
    assert np.abs(height - (RADIUS - SINK)).max() < 1e-6 * RADIUS
    end = output(mbs, body, "Position")
    assert end[0] + end[1] < 0 < 0.3 + 0.2  # it has crossed


@pytest.mark.parametrize("corners", [4, 8])
def test_ball_rests_on_hidden_triangles(corners: int) -> None:
    """Exactly above an edge, or a corner, of coplanar triangles, all of which leave it out, as deep as on a face."""
    mbs = new_system()
    body, ground = ball(mbs, [0, 0, RADIUS - SINK], gravity=[0, 0, -G]), mbs.CreateGround()
    angle = 2 * np.pi * np.arange(corners) / corners
    fan = 2 * np.array([np.cos(angle), np.sin(angle), 0 * angle]).T
    if corners == 4:
        triangles, left_out = [[fan[0], fan[1], fan[2]], [fan[2], fan[3], fan[0]]], 3
    else:
        triangles, left_out = [[[0, 0, 0], a, b] for a, b in zip(fan, np.roll(fan, -1, axis=0), strict=True)], 2
    for triangle in triangles:
        mbs.CreateSphereTriangleContact(
            bodyNumbers=[body, ground], radiusSphere=RADIUS, trianglePoints=triangle, includeEdges=left_out,
            contactStiffness=1e5, dataInitialCoordinates=[-SINK, 0, 0, 0],
        )  # fmt: skip
    solve(mbs, 0.05, 100)
    assert output(mbs, body, "Position")[2] == pytest.approx(RADIUS - SINK, abs=1e-9 * RADIUS)


@pytest.mark.parametrize("limited", [True, False])
@pytest.mark.parametrize("kind", ["sphere", "triangle"])
def test_damping_pulls_where_it_is_not_limited(kind: str, limited: bool) -> None:
    """m d'' = -(k d + c d') until the gap is open, with exp(-pi z / sqrt(1 - z^2)) of the speed, or until that is zero.

    Then, exp(-z (pi - 2 asin z) / sqrt(1 - z^2)) of the speed is left.
    """
    mbs, k, share = new_system(), 1e5, 0.3
    body = ball(mbs, [0, 0, RADIUS + 1e-4], [0, 0, -1])
    damping = 2 * share * np.sqrt(k * MASS)
    common = {
        "contactStiffness": k,
        "contactDamping": damping,
        "dataInitialCoordinates": [1e-4, 0, 0, 0],
        "limitDamping": limited,
    }
    bodies = [body, mbs.CreateGround(referencePosition=[0, 0, -1 if kind == "sphere" else 0])]
    if kind == "sphere":
        mbs.CreateSphereSphereContact(bodyNumbers=bodies, spheresRadii=[RADIUS, 1.0], **common)
    else:
        corners = [[-1, -1, 0], [2, -1, 0], [-1, 2, 0]]
        mbs.CreateSphereTriangleContact(bodyNumbers=bodies, radiusSphere=RADIUS, trianglePoints=corners, **common)
    solve(mbs, 0.015, 6000)
    phase = np.pi - 2 * np.arcsin(share) if limited else np.pi
    assert output(mbs, body, "Velocity")[2] == pytest.approx(np.exp(-share * phase / np.sqrt(1 - share**2)), abs=2e-3)


def test_slip_is_that_of_the_nearest_point() -> None:
    """A ball of which the point on the surface rests, sunk into it as deep as it is, feels no friction; forces act half as deep."""
    mbs, depth, spin = new_system(), 0.02, 3.0
    velocity = [spin * (RADIUS - depth), 0, 0]
    body = ball(mbs, [0, 0, RADIUS - depth], velocity, initialAngularVelocity=[0, spin, 0])
    contact = mbs.CreateSphereTriangleContact(
        bodyNumbers=[body, mbs.CreateGround()], radiusSphere=RADIUS, trianglePoints=[[-1, -1, 0], [2, -1, 0], [-1, 2, 0]],
        contactStiffness=1e4, dynamicFriction=0.5, frictionProportionalZone=1.0, dataInitialCoordinates=[-depth, 0, 0, 0],
    )  # fmt: skip
    mbs.Assemble()
    value = lambda name: mbs.GetObjectOutput(contact, getattr(exu.OutputVariableType, name))  # noqa: E731
    np.testing.assert_allclose(value("Force"), [0, 0, 1e4 * depth], atol=1e-12)
    np.testing.assert_allclose(value("Position"), [0, 0, -depth / 2], atol=1e-15)


def test_cradle() -> None:
    """Equal balls with gaps pass the velocity on in each impact."""
    mbs = new_system()
    balls = [ball(mbs, [0.21 * i, 0, 0], [1, 0, 0] if i == 0 else [0, 0, 0]) for i in range(4)]
    for first, second in zip(balls[:-1], balls[1:], strict=True):
        mbs.CreateSphereSphereContact(
            bodyNumbers=[first, second],
            spheresRadii=[RADIUS, RADIUS],
            contactStiffness=1e6,
            dataInitialCoordinates=[0.01, 0, 0, 0],
        )
    solve(mbs, 0.05, 10000)
    speeds = [output(mbs, body, "Velocity")[0] for body in balls]
    assert speeds == pytest.approx([0, 0, 0, 1], abs=2e-3)


def test_hollow_sphere() -> None:
    """A ball lies at the bottom of a hollow sphere that presses with its weight."""
    mbs = new_system()
    ground = mbs.CreateGround()
    body = ball(mbs, [0, 0, -0.4 - SINK], gravity=[0, 0, -G])
    contact = mbs.CreateSphereSphereContact(
        bodyNumbers=[body, ground],
        spheresRadii=[RADIUS, 0.5],
        isHollowSphere1=True,
        contactStiffness=1e5,
        dataInitialCoordinates=[-SINK, 0, 0, 0],
    )
    mbs.Assemble()
    force = mbs.GetObjectOutput(contact, exu.OutputVariableType.Force)
    assert force == pytest.approx([0, 0, MASS * G], rel=1e-9)
    assert mbs.GetObjectOutput(contact, exu.OutputVariableType.Director1) == pytest.approx([0, 0, -1])


def test_adhesive_loading_and_unloading() -> None:
    """First loading, stiffer unloading, attraction: the three branches of the law."""
    k, ratio, pull, attraction, n = 1e5, 0.6, 0.01, 4e4, 1.5
    mbs = new_system()
    ground, body = mbs.CreateGround(), ball(mbs, [0.2, 0, 0])
    contact = mbs.CreateSphereSphereContact(
        bodyNumbers=[ground, body],
        spheresRadii=[RADIUS, RADIUS],
        contactStiffness=k,
        contactStiffnessExponent=n,
        contactPlasticityRatio=ratio,
        constantPullOffForce=pull,
        adhesionCoefficient=attraction,
        adhesionExponent=2,
    )
    mbs.Assemble()

    def normal_force(depth: float, overlap: float) -> float:
        coordinates = mbs.systemData.GetODE2Coordinates()
        coordinates[0] = -depth
        mbs.systemData.SetODE2Coordinates(coordinates)
        mbs.systemData.SetDataCoordinates([-depth, 0, 0, overlap])
        return -float(mbs.GetObjectOutput(contact, exu.OutputVariableType.Force)[0])

    deepest = 0.01
    overlap = ratio ** (1 / n) * deepest
    assert normal_force(deepest, overlap) == pytest.approx(k * deepest**n - pull, rel=1e-9)
    stiff = k / (1 - ratio) * (0.009**n - overlap**n) - pull
    assert normal_force(0.009, overlap) == pytest.approx(stiff, rel=1e-9)
    assert normal_force(0.002, overlap) == pytest.approx(-attraction * 0.002**2 - pull, rel=1e-9)


@pytest.mark.parametrize("tilt", [0.0, 0.1, -0.25])
def test_roll_touches_where_its_profile_is_level(tilt: float) -> None:
    """r = r0 - c x^2 has the slope of the ground at x = -tan(tilt) / 2 c, as long as that lies on the roll."""
    r0, c, length = 0.1, 0.5, 0.4
    mbs = new_system()
    ground = mbs.CreateGround(referencePosition=[0, 0, -1])
    body = mbs.CreateRigidBody(
        inertia=InertiaSphere(MASS, RADIUS), referenceRotationMatrix=exu.utilities.RotationMatrixY(tilt)
    )
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=3, initialCoordinates=[1, 0, 0]))
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=number)) for number in (ground, body)]
    roll = mbs.AddObject(
        exu.ObjectContactConvexRoll(
            markerNumbers=markers,
            nodeNumber=data,
            rollLength=length,
            coefficientsHull=[-c, 0, r0],
            contactStiffness=1e3,
        )
    )
    mbs.Assemble()
    x = np.clip(np.tan(tilt) / (2 * c), -length / 2, length / 2)
    expected = exu.utilities.RotationMatrixY(tilt) @ [x, 0, -(r0 - c * x**2)]
    assert mbs.GetObjectOutput(roll, exu.OutputVariableType.Position) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("model", [0, 1])
def test_two_circles_on_a_curve(model: int) -> None:
    """Each rests on its own side of a roof, by the depth or the area that it shares with it."""
    mbs = new_system()
    roof = exu.MatrixContainer(np.array([[1.0, 0, 0, 1], [0, 1, -1, 0]]))
    normals = [np.array([s, 1, 0]) / np.sqrt(2) for s in (1, -1)]
    feet = [np.array([s * 0.5, 0.5, 0]) for s in (1, -1)]
    depth, k = 0.02, 1e4
    ground = mbs.CreateGround()
    bodies = [ball(mbs, list(foot + (RADIUS - depth) * n)) for foot, n in zip(feet, normals, strict=True)]
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=number)) for number in (ground, *bodies)]
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=6, initialCoordinates=[0, -1, 0, 1, -1, 0]))
    contact = mbs.AddObject(
        exu.ObjectContactCurveCircles(
            markerNumbers=markers,
            nodeNumber=data,
            circlesRadii=[RADIUS, RADIUS],
            segmentsData=roof,
            contactStiffness=k,
            contactModel=model,
        )
    )
    mbs.Assemble()
    gaps = mbs.GetObjectOutput(contact, exu.OutputVariableType.DisplacementLocal)
    assert gaps == pytest.approx([-depth, -depth], rel=1e-9)
    half = np.arccos(1 - depth / RADIUS)
    size = np.sqrt(2) * depth if model == 0 else RADIUS**2 * (half - np.sin(half) * np.cos(half))
    forces = mbs.GetObjectOutput(contact, exu.OutputVariableType.ForceLocal)
    assert forces == pytest.approx([k * size, 0, k * size, 0], rel=1e-9, abs=1e-9)


GOOD: dict[str, dict[str, Any]] = {
    "ObjectContactSphereSphere": {"spheresRadii": [0.1, 0.2], "contactStiffness": 1},
    "ObjectContactSphereTriangle": {
        "radiusSphere": 0.1,
        "trianglePoints": exu.Vector3DList([[0, 0, 0], [1, 0, 0], [0, 1, 0]]),
        "contactStiffness": 1,
    },
    "ObjectContactConvexRoll": {"rollLength": 0.2, "coefficientsHull": [-1, 0, 0.1], "contactStiffness": 1},
    "ObjectContactCurveCircles": {
        "circlesRadii": [0.1],
        "segmentsData": exu.MatrixContainer([[0, 0, 1, 0]]),
        "contactStiffness": 1,
    },
}
DATA = {"ObjectContactConvexRoll": 3, "ObjectContactCurveCircles": 3}
BAD: list[tuple[str, str, Any, str]] = [
    ("ObjectContactSphereSphere", "spheresRadii", [0.1, 0], "two positive radii"),
    ("ObjectContactSphereSphere", "isHollowSphere1", True, "larger than sphere 0"),
    ("ObjectContactSphereSphere", "impactModel", 3, "0, 1 or 2"),
    ("ObjectContactSphereSphere", "contactPlasticityRatio", 1, "less than 1"),
    ("ObjectContactSphereTriangle", "trianglePoints", exu.Vector3DList([[0, 0, 0], [1, 0, 0], [2, 0, 0]]), "an area"),
    ("ObjectContactSphereTriangle", "trianglePoints", exu.Vector3DList([[0, 0, 0]]), "three points"),
    ("ObjectContactSphereTriangle", "includeEdges", 8, "a sum of 1, 2 and 4"),
    ("ObjectContactConvexRoll", "rollLength", 0, "a positive length"),
    ("ObjectContactConvexRoll", "coefficientsHull", [1, 0, 0.1], "a convex roll"),
    ("ObjectContactConvexRoll", "coefficientsHull", [-20, 0, 0.1], "a radius along the whole roll"),
    ("ObjectContactCurveCircles", "circlesRadii", [0.1, 0.2], "one for every circle marker"),
    ("ObjectContactCurveCircles", "circlesRadii", [0.0], "positive radii"),
    ("ObjectContactCurveCircles", "segmentsData", exu.MatrixContainer([[0, 0, 0, 0]]), "different points"),
    ("ObjectContactCurveCircles", "segmentsData", exu.MatrixContainer([[0, 0, 0]]), "per segment"),
    ("ObjectContactCurveCircles", "polynomialData", exu.MatrixContainer([[0, 0]]), "segments are straight"),
    ("ObjectContactCurveCircles", "contactModel", 2, "0 or 1"),
]


def with_contact(name: str, **changes: Any) -> exu.MainSystem:
    mbs = new_system()
    ground, body = mbs.CreateGround(), ball(mbs, [0, 0, 0.3])
    markers = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=number)) for number in (ground, body)]
    data = mbs.AddNode(
        exu.NodeGenericData(numberOfDataCoordinates=DATA.get(name, 4), initialCoordinates=[0] * DATA.get(name, 4))
    )
    values = GOOD[name] | changes
    if changes.get("isHollowSphere1"):
        values["spheresRadii"] = [0.2, 0.1]
    mbs.AddObject(getattr(exu, name)(markerNumbers=markers, nodeNumber=data, **values))
    return mbs


@pytest.mark.parametrize(("name", "parameter", "value", "expected"), BAD)
def test_refused(name: str, parameter: str, value: Any, expected: str) -> None:
    with_contact(name).Assemble()
    mbs = with_contact(name, **{parameter: value})
    with pytest.raises(ValueError, match=expected) as error:
        mbs.Assemble()
    assert name in str(error.value) and "object 2" in str(error.value)


def test_friction_needs_orientation() -> None:
    """Mass points touch without friction; the error with it names marker and remedy."""
    mbs = new_system()
    points = [mbs.CreateMassPoint(referencePosition=[0.3 * i, 0, 0], physicsMass=1) for i in range(2)]
    mbs.CreateSphereSphereContact(bodyNumbers=points, spheresRadii=[0.1, 0.1], contactStiffness=1e4)
    mbs.Assemble()
    markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=point)) for point in points]
    data = mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=4, initialCoordinates=[0] * 4))
    mbs.AddObject(
        exu.ObjectContactSphereSphere(
            markerNumbers=markers, nodeNumber=data, spheresRadii=[0.1, 0.1], contactStiffness=1e4, dynamicFriction=0.1
        )
    )
    with pytest.raises(ValueError, match="orientation.*dynamicFriction"):
        mbs.Assemble()


def test_balls_that_bounce_and_roll_off_a_plate_of_two_triangles() -> None:
    """Steps do not matter where the speed that damping is divided by is bounded: six balls, of which one rolls onto the other triangle with 1e-12 m/s.

    All balls have rolled off in the end, over edges and corners.
    """
    ends = []
    for steps in (2500, 5000):
        mbs = exu.SystemContainer().AddSystem()
        ground = mbs.CreateGround()
        balls = []
        for angle in np.pi / 3 * np.arange(6):
            way = np.array([np.sin(angle), np.cos(angle), 0])
            ball = mbs.CreateRigidBody(
                referencePosition=0.2 * way + [0.2, 0.2, 0.11], initialVelocity=1.2 * way, inertia=InertiaSphere(1.6, 0.1),
                gravity=[0, 0, -10],
            )  # fmt: skip
            for corners, edges in (([[-1, -1], [2, -1], [-1, 2]], 5), ([[2, -1], [2, 2], [-1, 2]], 3)):
                mbs.CreateSphereTriangleContact(
                    bodyNumbers=[ball, ground], radiusSphere=0.1, includeEdges=edges, contactStiffness=1e5,
                    trianglePoints=[[0.25 * x, 0.25 * y, 0] for x, y in corners], dynamicFriction=0.2, impactModel=2,
                    restitutionCoefficient=0.5, minimumImpactVelocity=1e-2,
                )  # fmt: skip
            balls.append(ball)
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.timeIntegration.verboseMode = 0
        settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.5, steps
        settings.timeIntegration.newton.useModifiedNewton = True
        mbs.SolveDynamic(settings, solverType=exu.DynamicSolverType.TrapezoidalIndex2)
        ends.append([mbs.GetObjectOutputBody(b, exu.OutputVariableType.Position, [0, 0, 0]) for b in balls])
    np.testing.assert_allclose(ends[0], ends[1], atol=1e-4)  # of the last bounces, whose times are those of steps
    assert np.max(ends[1], axis=0)[2] < 0
