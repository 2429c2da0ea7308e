"""Friction that holds: bristles of general contact against closed forms of sticking and sliding."""

from __future__ import annotations

import pickle
from typing import Any

import numpy as np
import pytest
from test_general_contact import EXPLICIT, IMPLICIT, G, World, check_tangent, cloud, grid_mesh

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert._core import testing
from dalembert.utilities import InertiaCuboid, InertiaSphere

K = 2e5  # the stiffness of one surface; two of them are half as stiff
VERLET = exu.DynamicSolverType.VelocityVerlet


def gripping(friction: float, stiffness: float = 0.8, damping: float = 1.0, static: float = 1.0) -> World:
    world = World(friction)
    world.contact.SetFrictionBristles(stiffness, damping, static)
    return world


def sensor(world: World, body: Any, name: str) -> Any:
    kind = getattr(exu.OutputVariableType, name)
    return world.mbs.AddSensor(eii.SensorBody(bodyNumber=body, storeInternal=True, outputVariableType=kind))


def stored(world: World, number: Any) -> np.ndarray:
    return np.asarray(world.mbs.GetSensorStoredData(number))


def brick(world: World, slope: float, damping: float = 100.0) -> Any:
    """2 kg on four spheres, sunk as deep as it rests; it is wide, so that the slope hardly changes the normal
    forces."""
    mass, gravity = 2.0, [G * np.sin(slope), 0, -G * np.cos(slope)]
    sink = mass * G * np.cos(slope) / (4 * K / 2)
    world.mesh(*grid_mesh(1.0, 30), stiffness=K, damping=damping)
    body = world.mbs.CreateRigidBody(
        referencePosition=[-0.5, 0, 0.05 - sink], inertia=InertiaCuboid(2 / 0.03, [1, 0.3, 0.1]), gravity=gravity,
        nodeType=exu.NodeType.RotationRotationVector,
    )  # fmt: skip
    for x in (-0.41, 0.39):
        for y in (-0.1, 0.1):
            corner = eii.MarkerBodyRigid(bodyNumber=body, localPosition=[x, y, 0])
            world.sphere(world.mbs.AddMarker(corner), 0.05, K, damping)
    return body


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT, VERLET])
def test_brick_below_the_angle_of_friction_does_not_creep(solver: Any) -> None:
    """24 of 26.6 degrees: it leans on its bristles, m g sin(slope) = 4 k_t x at the soles, and rests: rounding errors are left.

    The load comes at once; damping is three times the critical one, so that bristles need not bear more than 3 % above that.
    """
    slope, world = np.radians(24), gripping(0.5, damping=6.0)
    body = brick(world, slope)
    place = sensor(world, body, "Position")
    world.solve(1.0, 4000, solver)
    x = stored(world, place)
    assert np.abs(x[-1, 1:] - x[2800, 1:]).max() < 1e-10  # vibrations have died away: 100 Ns/m against 2 kg
    sole = world.mbs.GetObjectOutputBody(body, exu.OutputVariableType.Position, [0, 0, -0.05])
    assert sole[0] + 0.5 == pytest.approx(2 * G * np.sin(slope) / (4 * 0.8 * K / 2), rel=1e-3)


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT, VERLET])
def test_brick_above_the_angle_of_friction_slides(solver: Any) -> None:
    slope, world = np.radians(28), gripping(0.5)
    body = brick(world, slope)
    speed = sensor(world, body, "Velocity")
    world.solve(0.5, 1000, solver)
    v = stored(world, speed)
    rate = (v[-1, 1] - v[600, 1]) / (v[-1, 0] - v[600, 0])
    assert rate == pytest.approx(G * (np.sin(slope) - 0.5 * np.cos(slope)), rel=1e-4)


def test_without_bristles_the_brick_creeps() -> None:
    """Purpose of the option: the regularized law lets it go with tan(slope)/mu of the zone's speed."""
    slope, world = np.radians(25), World(0.5)
    body = brick(world, slope)
    world.solve(0.5, 4000, EXPLICIT)
    assert world.output(body, "Velocity")[0] == pytest.approx(1e-3 * np.tan(slope) / 0.5, rel=1e-2)


def on_belt(
    static: float, speed: float, spring: float, stiffness: float = 1e6, damping: float = 30.0
) -> tuple[World, Any]:
    """A block of 1 kg that a spring holds back, on a belt, which is as heavy as to keep its speed."""
    world = gripping(0.3, 1.0, 1.0, static)
    belt = world.mbs.CreateRigidBody(
        inertia=InertiaSphere(1e12, 1), initialVelocity=[speed, 0, 0], nodeType=exu.NodeType.RotationRotationVector
    )
    world.mesh([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], [[0, 1, 2], [0, 2, 3]],
               world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=belt)), 2 * stiffness, damping)  # fmt: skip
    block = world.point([0, 0, 0.1 - G / stiffness], [speed, 0, 0], stiffness=2 * stiffness, damping=damping)
    node = world.mbs.GetObject(block)["nodeNumber"]
    world.mbs.AddLoad(
        eii.LoadForceVector(
            markerNumber=world.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=block)), loadVector=[0, 0, -G]
        )
    )
    coordinate = world.mbs.AddMarker(eii.MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
    rest = world.mbs.AddMarker(
        eii.MarkerNodeCoordinate(nodeNumber=world.mbs.AddNode(eii.NodePointGround()), coordinate=0)
    )
    world.mbs.AddObject(eii.CoordinateSpringDamper(markerNumbers=[rest, coordinate], stiffness=spring))
    return world, block


def crossings(t: np.ndarray, v: np.ndarray, level: float, falling: bool) -> np.ndarray:
    low = v < level
    at = np.flatnonzero(low[1:] != low[:-1])
    at = at[(v[at] > level) == falling]
    return t[at] + (level - v[at]) / (v[at + 1] - v[at]) * (t[at + 1] - t[at])


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_stick_slip_on_a_belt(solver: Any) -> None:
    """Let e be the elongation of the spring, and A half of its fall: it slips at e = mu_s N / k, for (2 / w) (pi -
    atan(A w / V)), and sticks for 2 A / V.

    The belt is 1e4 times stiffer than the spring, so times may differ by this part, plus 1.5 steps until the contact
    slides.
    """
    k, mu, static, speed = 100.0, 0.3, 1.5, 0.2
    world, block = on_belt(static, speed, k)
    velocity = sensor(world, block, "Velocity")
    steps, end = 40000, 2.0
    world.solve(end, steps, solver)
    v = stored(world, velocity)
    w, a = np.sqrt(k), (static - 1) * mu * G / k
    first = static * mu * G / (k * speed)
    slip, stick = 2 / w * (np.pi - np.arctan(a * w / speed)), 2 * a / speed
    # relative to the belt; at the middle of the belt's speed, which the block passes within a known angle
    level = 0.5 * speed
    lag = brief_angle(level, a * w, speed) / w
    leaves = crossings(v[:, 0], v[:, 1], level, True)[:2] - lag
    returns = crossings(v[:, 0], v[:, 1], level, False)
    returns = returns[returns > leaves[0]][:1] + lag
    tolerance = 1e-4 * first + 2 * end / steps + 1e-3 * slip
    assert leaves[0] == pytest.approx(first, abs=tolerance)
    assert returns[0] == pytest.approx(first + slip, abs=tolerance)
    assert leaves[1] == pytest.approx(first + slip + stick, abs=2 * tolerance)


def brief_angle(drop: float, a: float, b: float) -> float:
    """How far the swing turns until the speed has fallen by `drop`: a sin(x) + b (1 - cos(x)) = drop."""
    return float(2 * np.arctan2(-a + np.sqrt(a * a + 2 * b * drop - drop * drop), 2 * b - drop))


def test_the_place_where_sticking_ends_is_found() -> None:
    """Steps of 5 ms end where the bristle gives way, to far less than a step; a step that is solved again begins with the bristle of its start.

    The block goes with the belt until k x = mu_s N. It swings on its bristle, w = 1e4 / s, with k V / w = 2 mN, which is 0.1 ms of the spring.
    """
    k, mu, static, speed = 100.0, 0.3, 1.5, 0.2
    world, block = on_belt(static, speed, k, stiffness=1e8, damping=1000.0)
    velocity = sensor(world, block, "Velocity")
    world.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e-9
    settings.events.ofItems = True
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 0.25, 50
    world.mbs.SolveDynamic(settings, solverType=IMPLICIT)
    t = stored(world, velocity)[:, 0]
    first = static * mu * G / (k * speed)
    assert len(t) > 51
    assert np.abs(t - first).min() < 2e-4


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_coulomb_damped_swing_stops_where_it_should(solver: Any) -> None:
    """Released at 5.5 mu N / k: turns at -3.5, 1.5, and stays at 0.5, after three half swings; the bristle takes and gives 1e-4 of the way."""
    k, mu, end = 100.0, 0.3, 1.2
    world, block = on_belt(1.0, 0.0, k)
    unit = mu * G / k
    world.mbs.SetNodeParameter(world.mbs.GetObject(block)["nodeNumber"], "initialCoordinates", [5.5 * unit, 0, 0])
    place = sensor(world, block, "Displacement")
    world.solve(end, 12000, solver)
    x = stored(world, place)
    half = np.pi / np.sqrt(k)
    for number, turn in ((1, -3.5), (2, 1.5)):
        at = np.abs(x[:, 0] - number * half) < 0.2 * half
        extreme = np.abs(x[at, 1]).argmax()
        assert x[at, 1][extreme] == pytest.approx(turn * unit, abs=1e-3 * unit)
        assert x[at, 0][extreme] == pytest.approx(number * half, abs=2e-2 * half)
    assert x[-1, 1] == pytest.approx(0.5 * unit, abs=1e-3 * unit)
    assert np.abs(x[x[:, 0] > 3.2 * half, 1] - 0.5 * unit).max() < 5e-3 * unit


def test_a_bristle_is_a_spring_as_long_as_it_holds() -> None:
    """A point that is pressed on a plane swings on its bristle without damping: neither frequency nor amplitude change in 25 swings."""
    world = gripping(0.9, 0.5, 0.0)
    world.mesh([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], [[0, 1, 2], [0, 2, 3]], stiffness=K)
    block = world.point([0, 0, 0.1 - G / (K / 2)], [1e-2, 0, 0], stiffness=K)
    marker = world.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=block))
    world.mbs.AddLoad(eii.LoadForceVector(markerNumber=marker, loadVector=[0, 0, -G]))
    w = np.sqrt(0.5 * K / 2)
    end = 25.25 * 2 * np.pi / w
    world.solve(end, 4000, EXPLICIT)
    assert world.output(block, "Displacement")[0] == pytest.approx(1e-2 / w, rel=1e-5)
    assert world.output(block, "Velocity")[0] == pytest.approx(0, abs=1e-5)


def test_sticking_bodies_rotate_as_one() -> None:
    """Two balls that springs press together and twist against each other turn once: the stretch of the bristle that holds them turns along.

    Springs and contact are internal forces, so that angular momentum is constant, and a rigid-body motion remains after
    damping.
    """
    world, radius, spin = gripping(0.8, 1.0, 1.0), 0.1, 20.0
    surface = {"stiffness": K, "damping": 200.0}
    balls = [
        world.ball([x, 0, 0], [0, spin * x, 0], [0, 0, spin], surface=surface) for x in (-radius, radius)
    ]  # fmt: skip
    for heights, rest, stiffness in (((0, 0), 0.1, 4e3), ((0.08, -0.08), 0.2, 500.0)):
        ends = [[0, h, 0] for h in heights]
        world.mbs.CreateSpringDamper(
            bodyNumbers=balls,
            localPosition0=ends[0],
            localPosition1=ends[1],
            referenceLength=rest,
            stiffness=stiffness,
            damping=20,
        )
    speeds = [sensor(world, b, "AngularVelocity") for b in balls]
    world.solve(2 * np.pi / spin, 8000, EXPLICIT)
    first, second = (stored(world, s)[4000:, 3] for s in speeds)
    # the twist is 28 N of the diagonal spring at 0.62 of its length across, which friction of zero would not bear
    assert np.abs(first - second).max() < 1e-6 * spin
    assert np.ptp(first) < 1e-6 * spin
    _, _, forces = world.contact._pushes(exu.ConfigurationType.Current)
    x = [world.output(b, "Position") for b in balls]
    along = (x[1] - x[0]) / np.linalg.norm(x[1] - x[0])
    assert np.linalg.norm(forces[0] - forces[0] @ along * along) > 5


@pytest.mark.parametrize("damping", [0.0, 1.0])
def test_momentum_and_energy_of_a_cloud(damping: float) -> None:
    """Action is reaction, with moments; the energy of bristles at the end of a contact is lost, so that energy
    decreases."""
    world, bodies = cloud(0.4)
    world.contact.SetFrictionBristles(0.8, damping)
    world.mbs.Assemble()
    before = world.totals(bodies, 0.4 * 0.1**2)
    world.solve(0.6, 6000, EXPLICIT)
    after = world.totals(bodies, 0.4 * 0.1**2)
    np.testing.assert_allclose(after[:3], before[:3], atol=1e-11)
    np.testing.assert_allclose(after[3:6], before[3:6], atol=1e-7)
    assert 0.3 * before[6] < after[6] < 0.97 * before[6]


@pytest.mark.parametrize("mesh", [1, 40])
@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_bristles_pass_from_triangle_to_triangle(mesh: int, solver: Any) -> None:
    """A ball that rolls down needs 2/7 of its weight along the slope as friction, also over inner edges.

    A bristle that began anew there would be 14 um too short, and the ball would slip with up to 7 mm/s until it has grown.
    """
    slope, radius, end = 0.4, 0.1, 0.4
    sink = G * np.cos(slope) / (K / 2)
    world = gripping(0.5)
    gravity = [G * np.sin(slope), 0, -G * np.cos(slope)]
    body = world.ball([-0.9, 0.013, radius - sink], gravity=gravity, surface={"stiffness": K, "damping": 200.0})
    world.mesh(*grid_mesh(1.0, mesh), stiffness=K)
    sensors = [sensor(world, body, name) for name in ("Velocity", "AngularVelocity")]
    world.solve(end, 4000, solver)
    v, w = (stored(world, s) for s in sensors)
    inertia = 0.4 * (radius / (radius - sink)) ** 2
    assert world.output(body, "Velocity")[0] == pytest.approx(G * np.sin(slope) / (1 + inertia) * end, rel=5e-4)
    slip = v[:, 1] - w[:, 2] * (radius - sink)
    assert np.abs(slip[v[:, 0] > 0.1]).max() < 1e-3


def test_implicit_and_explicit_integration_agree() -> None:
    states = []
    for solver, steps in ((EXPLICIT, 2000), (IMPLICIT, 4000)):
        world, bodies = cloud(0.3)
        world.contact.SetFrictionBristles(0.8, 1.0, 1.2)
        world.solve(0.06, steps, solver)
        states.append([np.concatenate([world.output(b, "Position"), world.output(b, "Velocity")]) for b in bodies])
    change = np.abs(np.array(states[0]) - states[1])
    assert change[:, :3].max() < 1e-4
    assert change[:, 3:].max() < 2e-2


@pytest.mark.parametrize("weights", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
def test_tangent_is_the_derivative_of_the_residual(weights: tuple[float, float, float]) -> None:
    """Balls on a body of triangles and on each other, with bristles that stick and slide."""
    rng, world = np.random.default_rng(7), gripping(0.3, 0.7, 0.5, 1.3)
    for i in range(6):
        place, speed = rng.uniform(-0.12, 0.12, 3), rng.uniform(-1, 1, 3)
        if i % 2:
            world.ball(place, speed, surface={"damping": 5.0})
        else:
            world.point(place, speed)
    plate = world.mbs.CreateRigidBody(
        referencePosition=[0, 0, -0.1], initialAngularVelocity=[1, 2, 3], inertia=InertiaSphere(2, 0.5),
        nodeType=exu.NodeType.RotationRotationVector,
    )  # fmt: skip
    world.mesh(*grid_mesh(0.5, 3), world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=plate)))
    world.solve(2e-3, 40, IMPLICIT)
    s = testing.State(world.mbs)
    testing.search(world.mbs, s)
    slides = world.contact.GetActiveContacts(exu.ContactTypeIndex.IndexSpheresMarkerBased, 0)
    assert len(slides) > 1
    check_tangent(world, s, weights)


def test_pictures_show_forces_of_bristles() -> None:
    """Forces on the soles of the brick that rests are its weight."""
    slope, world = np.radians(20), gripping(0.5)
    brick(world, slope)
    world.solve(1.0, 2000, EXPLICIT)
    _, _, forces = world.contact._pushes(exu.ConfigurationType.Current)
    np.testing.assert_allclose(forces.sum(axis=0), 2 * G * np.array([-np.sin(slope), 0, np.cos(slope)]), atol=1e-6)


def test_copies_and_a_second_solution_begin_alike() -> None:
    """A solution begins without bristles, also after another one; pickles and files bring the option along."""
    slope, world = np.radians(20), gripping(0.5, 0.7, 0.9, 1.1)
    brick(world, slope)
    copy = pickle.loads(pickle.dumps(world.mbs))
    assert copy.GetGeneralContact(0).GetPythonObject()["frictionBristles"] == [0.7, 0.9, 1.1]
    other, results = World(), []
    other.mbs = copy
    for each in (world, world, other):
        each.solve(0.05, 100, EXPLICIT)
        results.append(each.mbs.systemData.GetODE2Coordinates().tobytes())
    assert results[0] == results[1] == results[2]


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        ((-0.1,), "stiffnessRatio': received -0.1"),
        ((0.5, float("nan")), "dampingRatio': received nan"),
        ((0.5, 1, 0.9), "staticRatio': received 0.9, but expected a number from 1"),
    ],
)
def test_wrong_ratios_are_refused(arguments: tuple[float, ...], text: str) -> None:
    with pytest.raises(ValueError, match=text):
        World().contact.SetFrictionBristles(*arguments)


@pytest.mark.parametrize(("part", "stands"), [(1.03, True), (0.97, False)])
def test_the_smallest_heap_stands_from_a_friction_of_its_geometry(part: float, stands: bool) -> None:
    """A ball on three that touch each other: its forces point to the places where those stand, at half the angle of its contacts.

    The line between two centres is inclined by arcsin(1 / sqrt(3)) from the vertical. A quarter of this friction
    suffices on the ground.
    """
    radius, mass, stiffness, damping = 0.1, 1.0, 2e6, 6e2
    needed = np.tan(0.5 * np.arcsin(1 / np.sqrt(3)))
    world = gripping([[part * needed, 0.6], [0.6, 0.6]], 0.8, 1.0)
    world.mesh(*grid_mesh(2.0, 1), stiffness=stiffness, damping=damping, material=1)
    law = {"stiffness": stiffness, "damping": damping, "material": 0}
    angles = 2 * np.pi / 3 * np.arange(3) + 0.1
    base = 2 * radius / np.sqrt(3) * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    weight = {"mass": mass, "radius": radius, "gravity": [0, 0, -G]}
    for x, y in base:
        world.ball([x, y, radius], surface=law, **weight)
    above = radius * (1 + 2 * np.sqrt(2 / 3))
    top = world.ball([0, 0, above], surface=law, **weight)
    world.solve(2.0, 20000, VERLET)
    fallen = above - world.output(top, "Position")[2]
    if stands:  # spheres that slide immediately while the weight is applied
        assert 0 < fallen < 2e-3 * radius
        assert np.linalg.norm(world.output(top, "Velocity")) < 1e-8
    else:
        assert fallen > radius
