"""Boxes, cylinders, capsules and convex hulls in general contact, against closed forms of rest, toppling, rolling and impact."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from test_general_contact import EXPLICIT, IMPLICIT, G, World, check_tangent, grid_mesh

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert._core import testing
from dalembert.utilities import (
    InertiaCuboid,
    InertiaCylinder,
    InertiaSphere,
    RotationMatrixX,
    RotationMatrixY,
    RotationMatrixZ,
)

K = 2e5  # the stiffness of one surface; two of them are half as stiff
FLOORS = ["plane", "triangles", "mesh", "heights", "box"]


class ConvexWorld(World):
    """A system with convex shapes on floors of all kinds, whose upper side is z = 0."""

    surface = {"contactStiffness": K, "contactDamping": 0.0, "frictionMaterialIndex": 0}

    def damped(self, damping: float) -> None:
        self.surface = self.surface | {"contactDamping": damping}

    def floor(self, kind: str = "plane", size: float = 2.0) -> None:
        if kind == "plane":
            self.contact.AddPlane(self.ground, [0, 0, 2], **self.surface)
        elif kind == "heights":
            self.contact.AddHeightField(
                self.ground, np.zeros((11, 21)), [size / 5, size / 10], origin=[-size, -size, 0], **self.surface
            )
        elif kind == "box":
            self.contact.AddBoxWithMarker(
                self.ground, [2 * size, 2 * size, 1], centerPoint=[0, 0, -0.5], **self.surface
            )
        else:
            points, triangles = grid_mesh(size, 1 if kind == "triangles" else 40)
            self.contact.AddTrianglesRigidBodyBased(
                self.ground, pointList=points, triangleList=triangles, **self.surface
            )

    def body(self, inertia: Any, position: Any, gravity: Any = (0, 0, -G), **kwargs: Any) -> tuple[Any, Any]:
        body = self.mbs.CreateRigidBody(
            referencePosition=list(position), inertia=inertia, gravity=list(gravity),
            nodeType=exu.NodeType.RotationRotationVector, **kwargs,
        )  # fmt: skip
        return body, self.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body))

    def box(self, size: Any, position: Any, mass: float = 1.0, gravity: Any = (0, 0, -G), **kwargs: Any) -> Any:
        body, marker = self.body(InertiaCuboid(mass / np.prod(size), size), position, gravity, **kwargs)
        self.contact.AddBoxWithMarker(marker, size, **self.surface)
        return body

    def cylinder(self, radius: float, length: float, position: Any, mass: float = 1.0, **kwargs: Any) -> Any:
        """Along y."""
        density = mass / (np.pi * radius**2 * length)
        body, marker = self.body(InertiaCylinder(density, length, radius, axis=1), position, **kwargs)
        self.contact.AddCylinderWithMarker(marker, radius, [0, length, 0], **self.surface)
        return body

    def position_sensor(self, body: Any, place: Any = (0, 0, 0)) -> Any:
        kind = exu.OutputVariableType.Position
        sensor = eii.SensorBody(bodyNumber=body, storeInternal=True, outputVariableType=kind, localPosition=list(place))
        return self.mbs.AddSensor(sensor)

    def stored(self, sensor: Any) -> np.ndarray:
        """Times and positions."""
        return np.asarray(self.mbs.GetSensorStoredData(sensor))


def rest(world: ConvexWorld, body: Any) -> float:
    return float(world.output(body, "Position")[2])


# ---- rest ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("floor", FLOORS)
@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_a_box_sinks_as_one_spring(floor: str, solver: Any) -> None:
    """The places of a face share the stiffness of the pair, however many there are: m g / k on all floors."""
    world = ConvexWorld(0.3)
    world.damped(100.0)
    world.floor(floor)
    sink = G / (K / 2)
    body = world.box([0.2, 0.3, 0.1], [0.013, 0.021, 0.05 - 0.5 * sink])
    world.solve(0.5, 2000, solver)
    assert rest(world, body) == pytest.approx(0.05 - sink, abs=1e-6 * sink)
    np.testing.assert_allclose(world.output(body, "Rotation"), 0, atol=1e-9)


@pytest.mark.parametrize("floor", ["plane", "mesh", "box"])
@pytest.mark.parametrize("shape", ["standing", "lying", "capsule", "hull"])
def test_everything_sinks_as_one_spring(floor: str, shape: str) -> None:
    world, sink = ConvexWorld(0.3), G / (K / 2)
    world.damped(60.0)
    world.floor(floor)
    height = {"standing": 0.1, "lying": 0.08, "capsule": 0.08, "hull": 0.05}[shape]
    body, marker = world.body(InertiaSphere(1, 0.1), [0.017, 0.023, height - sink])
    if shape == "capsule":
        world.contact.AddCapsuleWithMarker(marker, 0.08, [0.3, 0.1, 0], **world.surface)
    elif shape == "hull":  # an hexagonal prism with points inside and in its faces
        angles = np.pi / 3 * np.arange(6)
        ring = np.stack([0.1 * np.cos(angles), 0.1 * np.sin(angles), 0 * angles], axis=1)
        points = np.concatenate([ring + [0, 0, 0.05], ring - [0, 0, 0.05], [[0, 0, 0], [0, 0, 0.05], [0.02, 0, -0.05]]])
        world.contact.AddConvexHullWithMarker(marker, points, **world.surface)
    else:
        axis = [0, 0, 0.2] if shape == "standing" else [0.1, 0.2, 0]
        world.contact.AddCylinderWithMarker(marker, 0.08, axis, **world.surface)
    world.solve(0.3, 3000, EXPLICIT)
    assert rest(world, body) == pytest.approx(height - sink, abs=1e-6 * sink)
    np.testing.assert_allclose(world.output(body, "Rotation"), 0, atol=1e-9)


def test_a_box_that_slides_over_a_fine_mesh_keeps_its_height() -> None:
    """Over 20 inner edges; the corners of its sole stand on triangles, whose edges are none for them."""
    world, sink = ConvexWorld(0.0), G / (K / 2)
    world.floor("mesh")
    body = world.box([0.2, 0.3, 0.1], [-0.5, 0.021, 0.05 - sink], initialVelocity=[2.0, 0, 0])
    height = world.position_sensor(body)
    world.solve(0.5, 1000, EXPLICIT)
    x = world.stored(height)
    assert x[-1, 1] == pytest.approx(0.5)
    assert np.abs(x[:, 3] - (0.05 - sink)).max() < 1e-6 * 0.05


@pytest.mark.parametrize("damping", [150.0, 5000.0])
def test_a_tower_of_ten_boxes_stands(damping: float) -> None:
    """For 10 s; each contact is a spring that carries the weight above.

    Boxes are 1 mm to the left and to the right, in turn: the lowest sole is 1 mm off the weight, which tilts it by 10 m
    g e / (k a^2 / 4) = 4e-4. The tower is a column that its own weight would buckle at 1.26 m, with k a^3 / 4 as
    bending stiffness, so it tilts twice as much: 0.8 mm of 1 m. It begins upright, so that it sways; damped more, it
    rests.
    """
    world, n, side = ConvexWorld(0.5), 10, 0.1
    world.damped(damping)
    world.contact.SetFrictionBristles(0.8, 1.0)
    world.floor("plane")
    heights, z = [], 0.0
    for i in range(n):
        z -= (n - i) * G / (K / 2)
        heights.append(z + side / 2)
        z += side
    bodies = [world.box([side] * 3, [1e-3 * (-1) ** i, 0, h]) for i, h in enumerate(heights)]
    places = [world.position_sensor(body) for body in bodies]
    world.solve(10.0, 2000, IMPLICIT)
    for i, (place, h) in enumerate(zip(places, heights, strict=True)):
        x = world.stored(place)
        assert x[-1, 3] == pytest.approx(h, abs=5e-6)  # 0.1 % of the total compression of all contacts
        assert x[-1, 1:3] == pytest.approx([1e-3 * (-1) ** i, 0], abs=1.5e-3)
        early, late = np.ptp(x[:500, 1:], axis=0), np.ptp(x[1500:, 1:], axis=0)
        assert late[0] < 0.9 * early[0]
        if damping > 1000:
            assert late[0] < 1e-3 * early[0]


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_spheres_on_a_plane_are_as_on_triangles(solver: Any) -> None:
    """A ball that is pushed slides until it rolls with 5/7 of its speed; a point does not turn, and stops."""
    results, friction, speed = [], 0.3, 1.0
    for floor in ("plane", "triangles"):
        world, sink = ConvexWorld(friction), G / (K / 2)
        world.floor(floor)
        ball = world.ball(
            [-1, 0.01, 0.1 - sink], [speed, 0, 0], gravity=[0, 0, -G], surface={"stiffness": K, "damping": 0.0}
        )
        point = world.point([-1, 0.5, 0.1 - sink], [speed, 0, 0], stiffness=K)
        marker = world.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=point))
        world.mbs.AddLoad(eii.LoadForceVector(markerNumber=marker, loadVector=[0, 0, -G]))
        world.solve(0.4, 2000, solver)
        results.append([world.output(b, n) for b in (ball, point) for n in ("Position", "Velocity")])
    np.testing.assert_allclose(results[0], results[1], atol=1e-9)
    arm = 0.1 - G / (K / 2)
    assert results[0][1][0] == pytest.approx(speed / (1 + 0.4 * (0.1 / arm) ** 2), rel=2e-3)
    assert np.abs(results[0][3]).max() < 1e-3


# ---- slopes ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("floor", ["plane", "mesh", "box"])
@pytest.mark.parametrize("side", [-1, 1])
def test_a_box_topples_where_its_weight_leaves_the_sole(floor: str, side: int) -> None:
    """tan(slope) = width / height: 1 % below it stands, 1 % above it falls."""
    width, height = 0.1, 0.3
    slope = np.arctan(width / height) * (1 + 0.01 * side)
    world = ConvexWorld(2.0)
    world.damped(100.0)
    world.contact.SetFrictionBristles(0.8, 1.0)
    world.surface = world.surface | {"contactStiffness": 2e7, "contactDamping": 3e3}
    world.floor(floor)
    body = world.box([width, 0.2, height], [0.0, 0.0, height / 2], gravity=[G * np.sin(slope), 0, -G * np.cos(slope)])
    world.solve(2.0, 4000, IMPLICIT)
    turned = abs(world.output(body, "Rotation")[1])
    assert turned < 1e-3 if side < 0 else turned > 0.5


@pytest.mark.parametrize("floor", ["plane", "mesh", "box"])
def test_a_box_below_the_angle_of_friction_does_not_creep(floor: str) -> None:
    """It leans on the bristles of its four corners, whose stiffness is that of the pair together, and rests."""
    slope, world = np.radians(24), ConvexWorld(0.5)
    world.damped(300.0)
    world.contact.SetFrictionBristles(0.8, 1.0, 1.0)
    world.floor(floor)
    sink = G * np.cos(slope) / (K / 2)
    body = world.box([1, 0.5, 0.1], [0, 0, 0.05 - sink], gravity=[G * np.sin(slope), 0, -G * np.cos(slope)])
    place = world.position_sensor(body, [0, 0, -0.05])
    world.solve(0.5, 2000, EXPLICIT)
    x = world.stored(place)
    assert np.abs(x[-1, 1:] - x[1600, 1:]).max() < 1e-9
    assert x[-1, 1] == pytest.approx(G * np.sin(slope) / (0.8 * K / 2), rel=1e-3)


@pytest.mark.parametrize("floor", [*FLOORS, "box behind"])
@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_a_cylinder_rolls_down(floor: str, solver: Any) -> None:
    """Its acceleration is 2/3 g sin(slope), as that of a round body; its lever arm is as much shorter as it sinks."""
    slope, radius, end, world = 0.3, 0.1, 0.5, ConvexWorld(0.8)
    sink = G * np.cos(slope) / (K / 2)
    world.damped(100.0)
    if floor != "box behind":
        world.floor(floor)
    gravity = [G * np.sin(slope), 0, -G * np.cos(slope)]
    body = world.cylinder(radius, 0.3, [-1.0, 0.01, radius - sink], gravity=gravity)
    if floor == "box behind":  # the order of both makes no difference
        world.floor("box")
    height = world.position_sensor(body)
    world.solve(end, 2000, solver)
    inertia = 0.5 * (radius / (radius - sink)) ** 2
    assert world.output(body, "Velocity")[0] == pytest.approx(G * np.sin(slope) / (1 + inertia) * end, rel=1e-3)
    x = world.stored(height)
    assert np.abs(x[:, 3] - (radius - sink)).max() < 1e-6 * radius


# ---- conserved quantities --------------------------------------------------------------------------------------------


def crowd(
    world: ConvexWorld, seed: int, count: int = 10, speed: float = 1.0, frame: Any = None, shift: Any = (0, 0, 0)
) -> list[Any]:
    """Boxes, cylinders, capsules, hulls and spheres at random, some of which overlap, in a frame that may be turned."""
    rng, bodies, frame = np.random.default_rng(seed), [], np.eye(3) if frame is None else frame
    for i in range(count):
        turn = RotationMatrixX(rng.uniform(0, 6)) @ RotationMatrixY(rng.uniform(0, 6))
        body, marker = world.body(
            InertiaSphere(1, 0.1), shift + frame @ rng.uniform(-0.17, 0.17, 3), (0, 0, 0),
            referenceRotationMatrix=frame @ turn, initialVelocity=list(frame @ rng.uniform(-speed, speed, 3)),
            initialAngularVelocity=list(frame @ rng.uniform(-5, 5, 3)),
        )  # fmt: skip
        kind = i % 5
        if kind == 0:
            world.contact.AddBoxWithMarker(marker, rng.uniform(0.1, 0.2, 3), **world.surface)
        elif kind == 1:
            world.contact.AddCylinderWithMarker(marker, 0.07, [0, 0, 0.15], **world.surface)
        elif kind == 2:
            world.contact.AddCapsuleWithMarker(marker, 0.06, [0.1, 0, 0.05], **world.surface)
        elif kind == 3:
            world.contact.AddConvexHullWithMarker(marker, rng.normal(0, 0.07, (12, 3)), **world.surface)
        else:
            world.sphere(marker, 0.08, K, world.surface["contactDamping"])
        bodies.append(body)
    return bodies


@pytest.mark.parametrize("seed", range(4))
def test_action_is_reaction(seed: int) -> None:
    """Bodies in random motion, with friction: neither momentum nor moment is left over."""
    world = ConvexWorld(0.4)
    world.contact.frictionProportionalZone = 0.3
    world.damped(5.0)
    bodies = crowd(world, seed)
    plate, marker = world.body(InertiaSphere(2, 0.5), [0, 0, -0.1], (0, 0, 0), initialAngularVelocity=[1, 2, 3])
    points, triangles = grid_mesh(0.5, 4)
    world.contact.AddTrianglesRigidBodyBased(marker, pointList=points, triangleList=triangles, **world.surface)
    half, marker = world.body(InertiaSphere(2, 0.5), [0.1, 0, -0.1], (0, 0, 0), initialAngularVelocity=[1, 2, 3])
    world.contact.AddPlane(marker, [0.1, 0.2, 1], **world.surface)
    world.mbs.Assemble()
    data = world.mbs.systemData
    forces = world.contact.GetSystemODE2RhsContactForces()
    total, moment = np.zeros(3), np.zeros(3)
    for body in [*bodies, plate, half]:
        own = forces[data.GetObjectLTGODE2(body)]
        total += own[:3]
        # Coordinates of the rotation vector at zero are conjugate to moments in the axes of the body.
        rotation = world.output(body, "RotationMatrix").reshape(3, 3)
        moment += np.cross(world.output(body, "Position"), own[:3]) + rotation @ own[3:]
    places = world.contact.GetConvexContacts()
    assert len({tuple(p) for p in places["pairs"].tolist()}) > 15
    scale = np.abs(forces).max()
    np.testing.assert_allclose(total, 0, atol=1e-12 * scale)
    np.testing.assert_allclose(moment, 0, atol=1e-12 * scale)


@pytest.mark.parametrize("seed", range(4))
def test_forces_turn_with_the_frame(seed: int) -> None:
    """Everything shifted and turned: the same gaps and forces, turned along."""
    frame, found = RotationMatrixY(0.7) @ RotationMatrixX(1.9), []
    for turn, shift in ((np.eye(3), np.zeros(3)), (frame, np.array([3.0, -5.0, 2.0]))):
        world = ConvexWorld(0.4)
        world.contact.frictionProportionalZone = 0.3
        crowd(world, seed, 12, 1.0, turn, shift)
        world.mbs.Assemble()
        places = world.contact.GetConvexContacts()
        found.append((places["gaps"], places["forces"] @ turn, (places["points"] - shift) @ turn))
    assert len(found[0][0]) > 15
    for plain, turned in zip(*found, strict=True):
        np.testing.assert_allclose(turned, plain, atol=1e-12 * max(1, np.abs(plain).max()))


@pytest.mark.parametrize("yaw", [1e-12, 1e-7, -1e-7])
def test_forces_do_not_jump_where_faces_are_flush(yaw: float) -> None:
    """A box on another of the same size, tilted: sides that coincide cut corners anywhere if one is turned by a hair; forces change by the hair alone."""
    wrenches = []
    for turn in (0.0, yaw):
        world = ConvexWorld()
        world.contact.AddBoxWithMarker(world.ground, [0.1, 0.1, 0.1], **world.surface)
        rotation = RotationMatrixX(2e-4) @ RotationMatrixZ(turn)
        body, marker = world.body(
            InertiaSphere(1, 0.1), [0, 0, 0.1 - 3e-5], (0, 0, 0), referenceRotationMatrix=rotation
        )
        world.contact.AddBoxWithMarker(marker, [0.1, 0.1, 0.1], **world.surface)
        world.mbs.Assemble()
        wrenches.append(world.contact.GetSystemODE2RhsContactForces()[world.mbs.systemData.GetObjectLTGODE2(body)])
    assert wrenches[0][2] == pytest.approx(K / 2 * 3e-5, rel=1e-3)
    assert wrenches[0][3] == pytest.approx(-K / 2 * 2e-4 * 0.05**2, rel=1e-2)
    np.testing.assert_allclose(wrenches[1], wrenches[0], atol=10 * abs(yaw) * wrenches[0][2] + 1e-11)


def test_a_box_that_bounces_keeps_its_energy() -> None:
    """Its corners are constant springs of k / 4; the remaining error comes from steps in which one of about ten
    contacts begins or ends.

    There, the impulse is wrong by a part of k v h^2, and so is the energy by a part of k v^2 h^2: 2e-3 of m v^2 / 2 with h = 0.1 ms.
    """
    drifts = []
    for steps in (4000, 8000):
        world = ConvexWorld()
        world.floor("plane")
        turn = RotationMatrixX(0.3) @ RotationMatrixY(0.4)
        size = [0.2, 0.3, 0.1]
        body = world.box(size, [0, 0, 0.25], initialAngularVelocity=[1, 2, 0], referenceRotationMatrix=turn)
        inertia = np.array(InertiaCuboid(1 / np.prod(size), size).GetInertia6D()[:3])
        world.mbs.Assemble()

        def energy(world: ConvexWorld = world, body: Any = body, inertia: Any = inertia) -> float:
            places = world.contact.GetConvexContacts()
            elastic = float((places["shares"] * K / 2 * places["gaps"] ** 2).sum() / 2)
            return float(world.totals([body], inertia)[6] + G * world.output(body, "Position")[2] + elastic)

        before = energy()
        world.solve(0.8, steps, EXPLICIT)
        drifts.append(abs(energy() - before) / before)
    assert max(drifts) < 2e-4


@pytest.mark.parametrize("floor", ["plane", "mesh", "box"])
def test_flush_bounces_are_unstable_as_the_springs_at_the_corners_say(floor: str) -> None:
    """A tilt grows between two apexes by the eigenvalue of flight and contact: a body that rocks on corners during
    contact continues to rotate in flight.

    Rotation during contact: I theta'' = (-k a^2 + N c) theta: corners at the half length a, the centre c above them.
    The remainder is the effect of tilt on the times of contact of the corners, which is of second order.
    """
    size, fall, tilt = [0.2, 0.2, 0.1], 0.02, 1e-9
    a, c, k = 0.1, 0.05, K / 2
    inertia, omega, speed = (a**2 + c**2) / 3, np.sqrt(k), np.sqrt(2 * G * fall)
    contact, flight = (np.pi + 2 * np.arctan(G / (omega * speed))) / omega, 2 * speed / G

    def rock(t: float, y: np.ndarray) -> list[float]:
        depth = speed * np.sin(omega * t) / omega + G / omega**2 * (1 - np.cos(omega * t))
        return [y[1], (-k * a**2 + k * depth * c) * y[0] / inertia]

    columns = [solve_ivp(rock, (0, contact), start, rtol=1e-10, atol=1e-12).y[:, -1] for start in ([1, 0], [0, 1])]
    growth = np.abs(np.linalg.eigvals(np.array(columns).T @ [[1, flight], [0, 1]])).max()
    world = ConvexWorld()
    world.floor(floor)
    body = world.box(size, [0, 0, 0.05 + fall], referenceRotationMatrix=RotationMatrixX(tilt))
    kind = exu.OutputVariableType.RotationMatrix
    sensor = world.mbs.AddSensor(eii.SensorBody(bodyNumber=body, storeInternal=True, outputVariableType=kind))
    world.solve(4 * (contact + flight), 30000, EXPLICIT)
    times, tilts = np.asarray(world.mbs.GetSensorStoredData(sensor))[:, [0, 8]].T
    apexes = np.interp((contact + flight) * np.arange(4), times, tilts)
    assert growth == pytest.approx(60.46, abs=0.01)  # a value of the page
    np.testing.assert_allclose(apexes[2:] / apexes[1:-1], growth, rtol=2e-3)


def test_an_impact_keeps_momentum() -> None:
    """To rounding; moment of momentum as the scheme keeps it where contacts begin and end, with the square of the step."""
    errors = []
    for steps in (1000, 8000):
        world = ConvexWorld(0.3)
        world.damped(20.0)
        world.surface = world.surface | {"contactStiffness": 2e4}
        bodies = crowd(world, 11, 10, 0.5)
        inertia = np.full(3, 0.4 * 0.1**2)
        world.mbs.Assemble()
        before = world.totals(bodies, inertia)
        world.solve(0.2, steps, EXPLICIT)
        after = world.totals(bodies, inertia)
        np.testing.assert_allclose(after[:3], before[:3], atol=1e-12)
        errors.append(np.abs(after[3:6] - before[3:6]).max())
    assert errors[1] < errors[0] / 16
    assert errors[1] < 1e-6


# ---- solvers ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("weights", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
def test_tangent_is_the_derivative_of_the_residual(weights: tuple[float, float, float]) -> None:
    world = ConvexWorld(0.3)
    world.contact.frictionProportionalZone = 0.5
    world.damped(5.0)
    crowd(world, 3, 10)
    world.floor("mesh")
    world.floor("plane")
    world.mbs.Assemble()
    s = testing.State(world.mbs)
    testing.search(world.mbs, s)
    assert len(world.contact.GetConvexContacts()["gaps"]) > 10
    check_tangent(world, s, weights)


def test_implicit_and_explicit_integration_agree() -> None:
    states = []
    for solver in (EXPLICIT, IMPLICIT):
        world = ConvexWorld(0.3)
        world.damped(20.0)
        world.surface = world.surface | {"contactStiffness": 2e4}
        bodies = crowd(world, 11, 5, 0.5)
        world.floor("mesh")
        world.solve(0.05, 4000, solver)
        states.append([np.concatenate([world.output(b, "Position"), world.output(b, "Velocity")]) for b in bodies])
    change = np.abs(np.array(states[0]) - states[1])
    assert change[:, :3].max() < 1e-4
    assert change[:, 3:].max() < 2e-2


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_threads_and_frames_change_nothing(solver: Any) -> None:
    """Bit for bit with any number of threads; and the same up to rounding, or to Newton's tolerance, where everything is shifted."""
    results = []
    for threads, shift in ((1, 0.0), (3, 0.0), (1, 4.0)):
        world = ConvexWorld(0.4)
        world.damped(20.0)
        world.contact.SetFrictionBristles(0.5, 1.0)
        bodies = [world.box([0.1, 0.12 - 0.01 * i, 0.14], [shift + 0.02 * i, 0, 0.08 + 0.15 * i]) for i in range(3)]
        world.floor("plane")
        world.solve(0.4, 400, solver, threads)
        results.append(np.array([world.output(b, "Position") for b in bodies]))
    assert results[0].tobytes() == results[1].tobytes()
    np.testing.assert_allclose(results[2] - [4.0, 0, 0], results[0], atol=1e-9 if solver is EXPLICIT else 1e-6)


@pytest.mark.parametrize("bristles", [0.0, 0.8])
@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_threads_that_share_pairs_give_the_same_bytes(solver: Any, bristles: float) -> None:
    """Shapes of all kinds, more than one batch of pairs, in a box of hills."""
    results = []
    for threads in (1, 2, 3):
        world = ConvexWorld(0.4)
        world.damped(20.0)
        world.contact.SetFrictionBristles(bristles, 1.0)
        heights = 0.01 * np.sin(np.arange(12))[:, None] * np.cos(np.arange(12))
        world.contact.AddHeightField(world.ground, heights, [0.1, 0.1], origin=[-0.5, -0.5, -0.01], **world.surface)
        bodies = []
        for i in range(36):
            place = [0.115 * (i % 4) - 0.2, 0.12 * (i // 4 % 3) - 0.1 + 0.01 * (i // 12), 0.06 + 0.105 * (i // 12)]
            if i % 3:
                bodies.append(world.box([0.1, 0.11, 0.1], place, initialAngularVelocity=[0.1 * i, 1, 0]))
            else:
                body, marker = world.body(InertiaSphere(1, 0.05), place)
                add = world.contact.AddCapsuleWithMarker if i % 2 else world.contact.AddCylinderWithMarker
                add(marker, 0.05, [0.06, 0, 0.02], **world.surface)
                bodies.append(body)
        world.solve(0.15, 300, solver, threads)
        results.append(np.array([world.output(b, "Position") for b in bodies]).tobytes())
    assert results[0] == results[1] == results[2]
