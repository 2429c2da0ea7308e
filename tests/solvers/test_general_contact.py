"""General contact of spheres and triangles: forces against plain sums, motions against closed forms."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert._core import testing
from dalembert.utilities import InertiaSphere, RotationMatrixX, RotationMatrixY

G = 9.81
IMPLICIT, EXPLICIT = exu.DynamicSolverType.GeneralizedAlpha, exu.DynamicSolverType.RK44


class World:
    """A system with one general contact."""

    def __init__(self, friction: Any = 0.0, zone: float = 1e-3) -> None:
        self.mbs = exu.SystemContainer().AddSystem()
        self.contact = self.mbs.AddGeneralContact()
        self.contact.SetFrictionPairings(np.atleast_2d(friction))
        self.contact.frictionProportionalZone = zone
        self.ground = self.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=self.mbs.CreateGround()))

    def point(
        self, position: Any, velocity: Any = (0, 0, 0), mass: float = 1.0, radius: float = 0.1, **surface: Any
    ) -> Any:
        body = self.mbs.CreateMassPoint(
            referencePosition=list(position), initialVelocity=list(velocity), physicsMass=mass
        )
        self.sphere(self.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=body)), radius, **surface)
        return body

    def ball(
        self, position: Any, velocity: Any = (0, 0, 0), spin: Any = (0, 0, 0), mass: float = 1.0, radius: float = 0.1,
        gravity: Any = (0, 0, 0), surface: dict[str, Any] = {},
    ) -> Any:  # fmt: skip
        body = self.mbs.CreateRigidBody(
            referencePosition=list(position), initialVelocity=list(velocity), initialAngularVelocity=list(spin),
            inertia=InertiaSphere(mass, radius), gravity=list(gravity), nodeType=exu.NodeType.RotationRotationVector,
        )  # fmt: skip
        self.sphere(self.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body)), radius, **surface)
        return body

    def sphere(
        self, marker: Any, radius: float, stiffness: float = 2e4, damping: float = 0.0, material: int = 0
    ) -> int:
        return self.contact.AddSphereWithMarker(marker, radius, stiffness, damping, material)

    def mesh(
        self, points: Any, triangles: Any, marker: Any = None, stiffness: float = 2e4, damping: float = 0.0,
        material: int = 0,
    ) -> int:  # fmt: skip
        marker = self.ground if marker is None else marker
        return self.contact.AddTrianglesRigidBodyBased(marker, stiffness, damping, material, points, triangles)

    def solve(
        self, end: float, steps: int, solver: Any = IMPLICIT, threads: int = 1, tolerance: float | None = 0.1
    ) -> None:
        if not self.mbs.systemIsConsistent:
            self.mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.solutionSettings.sensorsWritePeriod = end / steps
        settings.parallel.numberOfThreads = threads
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps, time.verboseMode = end, steps, 0
        time.generalizedAlpha.spectralRadius = 1
        time.discontinuous.maxIterations = 10
        if tolerance is not None:
            time.discontinuous.iterationTolerance = tolerance
        self.mbs.SolveDynamic(settings, solverType=solver)

    def output(self, body: Any, name: str) -> np.ndarray:
        return np.asarray(self.mbs.GetObjectOutputBody(body, getattr(exu.OutputVariableType, name), [0, 0, 0]))

    def totals(self, bodies: Any, inertia: Any = None) -> np.ndarray:
        """Momentum, moment of momentum about the origin, and kinetic energy of bodies of 1 kg; without inertia, of points."""
        result = np.zeros(7)
        for body in bodies:
            x, v = self.output(body, "Position"), self.output(body, "Velocity")
            result += [*v, *np.cross(x, v), v @ v / 2]
            if inertia is not None:
                w, turned = self.output(body, "AngularVelocity"), self.output(body, "RotationMatrix").reshape(3, 3)
                spin = turned @ (inertia * (turned.T @ w))
                result[3:] += [*spin, w @ spin / 2]
        return result


def check_tangent(world: World, state: Any, weights: tuple[float, float, float], h: float = 1e-8) -> None:
    """The tangent of contact is the derivative of its forces, by central differences."""

    def contact_part(f: Any) -> np.ndarray:
        world.contact.isActive = True
        result = np.array(f())
        world.contact.isActive = False
        result = result - np.array(f())
        world.contact.isActive = True
        return result

    tangent = contact_part(lambda: testing.tangent(world.mbs, state, cq=weights[0], cv=weights[1]))
    for j in range(len(state.q)):
        ends = []
        for sign in (1, -1):
            other = state.copy()
            change = sign * h * (np.arange(len(state.q)) == j)
            if weights[0]:
                other.q = testing.compose(world.mbs, state, change)
            else:
                other.v = np.array(state.v) + change
            ends.append(contact_part(lambda other=other: testing.residual(world.mbs, other)))
        slope = (ends[0] - ends[1]) / (2 * h)
        np.testing.assert_allclose(tangent[: len(slope), j], slope, atol=2e-5 * max(1, np.abs(tangent).max()))


def grid_mesh(size: float, count: int, height: Any = lambda x, y: 0 * x) -> tuple[np.ndarray, np.ndarray]:
    """Points of a square grid around the origin, and two triangles per cell with normals upwards."""
    axis = np.linspace(-size, size, count + 1)
    x, y = np.meshgrid(axis, axis, indexing="ij")
    corner = np.add.outer(np.arange(count) * (count + 1), np.arange(count)).ravel()
    lower = np.stack([corner, corner + count + 1, corner + count + 2], axis=1)
    upper = np.stack([corner, corner + count + 2, corner + 1], axis=1)
    return np.stack([x, y, height(x, y)], axis=-1).reshape(-1, 3), np.concatenate([lower, upper])


# ---- forces ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("largest", [0.05, 2.0])
def test_forces_of_a_cloud_are_the_sum_over_all_pairs(largest: float) -> None:
    """Radii that differ by a factor of 80 too: no pair is missed or counted twice by any search."""
    rng, world = np.random.default_rng(3), World()
    n = 300
    x, v = rng.uniform(-0.4, 0.4, (n, 3)), rng.uniform(-1, 1, (n, 3))
    r = rng.uniform(0.025, 0.05, n)
    x[:4], r[:4] = rng.uniform(-3, 3, (4, 3)), largest
    k, d = rng.uniform(1e3, 2e3, n), rng.uniform(0, 3, n)
    for i in range(n):
        world.point(x[i], v[i], radius=r[i], stiffness=k[i], damping=d[i])
    world.mbs.Assemble()
    expected, touching = np.zeros((n, 3)), 0
    for i, j in itertools.combinations(range(n), 2):
        span = x[j] - x[i]
        distance = np.linalg.norm(span)
        normal_force = -(
            k[i] * k[j] / (k[i] + k[j]) * (distance - r[i] - r[j]) + (d[i] + d[j]) * span @ (v[j] - v[i]) / distance
        )
        if distance < r[i] + r[j] and normal_force > 0:
            touching += 1
            expected[[i, j]] += np.outer([-1, 1], normal_force / distance * span)
    forces = world.contact.GetSystemODE2RhsContactForces().reshape(n, 3)
    assert touching > 100
    np.testing.assert_allclose(forces, expected, rtol=0, atol=1e-11 * np.abs(expected).max())
    world.contact.UpdateContacts(world.mbs)
    counts = world.contact.GetActiveContacts(exu.ContactTypeIndex.IndexSpheresMarkerBased, -1)
    assert counts.sum() == touching


CUBE = np.array(list(itertools.product([-1.0, 1.0], repeat=3)))
CUBE_FACES = np.array(
    [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
)  # fmt: skip


@pytest.mark.parametrize("friction", [0.0, 0.4])
def test_forces_on_meshes_are_the_sum_of_all_pushes(friction: float) -> None:
    """Spheres over faces are pushed four at once; each contact force is the same when pairs are evaluated one by
    one."""
    rng, world = np.random.default_rng(8), World(friction=friction, zone=0.05)
    world.mesh(*grid_mesh(1.0, 14, lambda x, y: 0.1 * np.sin(4 * x) * np.cos(3 * y)), damping=1.0)
    tilted = world.mbs.CreateGround(
        referencePosition=[0, 0, 0.1], referenceRotationMatrix=RotationMatrixX(0.3) @ RotationMatrixY(0.2)
    )
    world.mesh(*grid_mesh(1.0, 3), world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=tilted)), stiffness=1e4)
    plate = world.mbs.CreateRigidBody(
        referencePosition=[0, 0, -0.05], initialVelocity=[0.1, 0, 0.3], initialAngularVelocity=[0.2, 0.1, 0.4],
        inertia=InertiaSphere(10, 1),
    )  # fmt: skip
    world.mesh(*grid_mesh(0.6, 5), world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=plate)))
    count, make = 400, world.ball if friction else world.point
    bodies = [
        make(
            [*rng.uniform(-1.05, 1.05, 2), rng.uniform(-0.05, 0.25)],
            rng.uniform(-1, 1, 3),
            radius=rng.uniform(0.05, 0.15),
        )
        for _ in range(count)
    ]
    world.contact.sphereSphereContact = False
    world.mbs.Assemble()
    pairs, _, forces = world.contact._pushes(exu.ConfigurationType.Current)
    expected = np.zeros((count, 3))
    np.add.at(expected, pairs[:, 0], forces)
    rows = [world.mbs.GetObject(body)["nodeNumber"] for body in bodies]
    first = [world.mbs.GetNodeODE2Index(node) for node in rows]
    found = np.array(world.contact.GetSystemODE2RhsContactForces())
    touched = np.bincount(pairs[:, 0], minlength=count)
    assert (touched == 1).sum() > 50
    assert (touched > 1).sum() > 50
    np.testing.assert_allclose([found[i : i + 3] for i in first], expected, atol=1e-10 * np.abs(expected).max())


@pytest.mark.parametrize(
    "place",
    [(0.2, 0.3, 1), (1, 0.3, 1), (-1, 1, 0.2), (1, 1, 1), (-1, 1, -1), (0.5, 0.5, 1), (0.5, -0.5, 1), (0, 1, 0), (1.0 - 1e-13, 1, 0.4)],
)  # fmt: skip
def test_a_ball_at_a_cube_is_pushed_once(place: tuple[float, float, float]) -> None:
    """Forces on faces, edges, corners and diagonals of faces are those of the nearest point, independently of the
    number of triangles there."""
    world, depth, radius, stiffness = World(), 0.01, 0.1, 2e4
    outwards = np.where(np.abs(place) >= 1 - 1e-9, np.sign(place), 0.0)
    outwards /= np.linalg.norm(outwards)
    turn = RotationMatrixX(0.4) @ RotationMatrixY(0.7)
    shift = np.array([0.3, -0.2, 0.5])
    cube = world.mbs.CreateGround(referencePosition=list(shift), referenceRotationMatrix=turn)
    marker = world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=cube))
    world.point(shift + turn @ (place + (radius - depth) * outwards), radius=radius)
    world.mesh(CUBE, CUBE_FACES, marker)
    world.mbs.Assemble()
    force = world.contact.GetSystemODE2RhsContactForces()
    np.testing.assert_allclose(force, turn @ outwards * depth * stiffness / 2, atol=1e-9 * stiffness * depth)


def test_a_ball_in_a_groove_is_pushed_from_both_sides() -> None:
    world, depth = World(), 0.01
    points = [[-1, -1, 1], [-1, 1, 1], [0, -1, 0], [0, 1, 0], [1, -1, 1], [1, 1, 1]]
    world.mesh(points, [[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]])
    world.point([0, 0.1, np.sqrt(2) * (0.1 - depth)])
    world.mbs.Assemble()
    force = world.contact.GetSystemODE2RhsContactForces()
    np.testing.assert_allclose(force, [0, 0, np.sqrt(2) * depth * 1e4], atol=1e-8)


def test_action_is_reaction() -> None:
    """Balls and a rigid body with triangles, in random motion, with friction: neither momentum nor moment is left over."""
    rng, world = np.random.default_rng(5), World(friction=0.4, zone=0.3)
    bodies = [world.ball(rng.uniform(-0.2, 0.2, 3), rng.uniform(-1, 1, 3), rng.uniform(-9, 9, 3)) for _ in range(12)]
    plate = world.mbs.CreateRigidBody(
        referencePosition=[0, 0, -0.1], initialAngularVelocity=[1, 2, 3], inertia=InertiaSphere(2, 0.5),
        referenceRotationMatrix=RotationMatrixX(0.3), nodeType=exu.NodeType.RotationRotationVector,
    )  # fmt: skip
    marker = world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=plate, localPosition=[0.1, 0.2, 0]))
    world.mesh(*grid_mesh(0.5, 4), marker)
    world.mbs.Assemble()
    data = world.mbs.systemData
    forces = world.contact.GetSystemODE2RhsContactForces()
    total, moment, mesh_force = np.zeros(3), np.zeros(3), np.zeros(3)
    for body in [*bodies, plate]:
        own = forces[data.GetObjectLTGODE2(body)]
        total += own[:3]
        # Coordinates of the rotation vector at the reference rotation are conjugate to moments in the axes of the body.
        rotation = world.output(body, "RotationMatrix").reshape(3, 3)
        moment += np.cross(world.output(body, "Position"), own[:3]) + rotation @ own[3:]
        mesh_force = own[:3]
    assert np.abs(mesh_force).max() > 10
    scale = np.abs(forces).max()
    np.testing.assert_allclose(total, 0, atol=1e-12 * scale)
    np.testing.assert_allclose(moment, 0, atol=1e-12 * scale)


@pytest.mark.parametrize("friction", [0.0, 0.4])
@pytest.mark.parametrize("weights", [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)])
def test_tangent_is_the_derivative_of_the_residual(friction: float, weights: tuple[float, float, float]) -> None:
    rng, world = np.random.default_rng(7), World(friction=friction, zone=0.5)
    for i in range(6):
        make = world.ball if i % 2 or friction else world.point
        make(rng.uniform(-0.12, 0.12, 3), rng.uniform(-1, 1, 3))
    plate = world.mbs.CreateRigidBody(
        referencePosition=[0, 0, -0.1], initialAngularVelocity=[1, 2, 3], inertia=InertiaSphere(2, 0.5)
    )
    world.mesh(*grid_mesh(0.5, 3), world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=plate)))
    world.mbs.Assemble()
    s = testing.State(world.mbs)
    testing.search(world.mbs, s)
    check_tangent(world, s, weights, 1e-7)


# ---- motions ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT, exu.DynamicSolverType.VelocityVerlet])
@pytest.mark.parametrize("share", [0.0, 0.3])
def test_impact_of_two_balls(solver: Any, share: float) -> None:
    """Springs in series, dampers side by side: the contact of a reduced mass lasts until the force vanishes, see the laws of impact."""
    world, stiffness = World(), 2e4
    damping = 2 * share * np.sqrt(stiffness / 2 * 0.75)
    first = world.point([0, 0, 0], [1, 0, 0], mass=1, stiffness=stiffness, damping=damping / 2)
    second = world.point([0.201, 0, 0], mass=3, stiffness=stiffness, damping=damping / 2)
    world.solve(0.05, 5000, solver)
    e = np.exp(-share * (np.pi - 2 * np.arcsin(share)) / np.sqrt(1 - share**2))
    assert world.output(first, "Velocity")[0] == pytest.approx((1 - 3 * e) / 4, abs=2e-3)
    assert world.output(second, "Velocity")[0] == pytest.approx((1 + e) / 4, abs=2e-3)


def test_time_of_contact() -> None:
    """Half a swing of the reduced mass, in which the ball goes back and forth."""
    world, k, m = World(), 2e4, 0.5
    body = world.point([0, 0, 0.1], [0, 0, -1], mass=m, stiffness=k)
    world.mesh([[-1, -1, 0], [2, -1, 0], [-1, 2, 0]], [[0, 1, 2]], stiffness=k)
    duration = np.pi * np.sqrt(m / (k / 2))
    world.solve(duration / 2, 400, EXPLICIT)
    assert world.output(body, "Position")[2] == pytest.approx(0.1 - np.sqrt(m / (k / 2)), rel=1e-8)
    world = World()
    body = world.point([0, 0, 0.1], [0, 0, -1], mass=m, stiffness=k)
    world.mesh([[-1, -1, 0], [2, -1, 0], [-1, 2, 0]], [[0, 1, 2]], stiffness=k)
    world.solve(2 * duration, 800, EXPLICIT)
    assert world.output(body, "Velocity")[2] == pytest.approx(1, abs=1e-6)
    assert world.output(body, "Position")[2] == pytest.approx(0.1 + duration, abs=1e-6)


@pytest.mark.parametrize("tolerance", [None, 1e-3])
def test_an_elastic_ball_bounces_four_times(tolerance: float | None) -> None:
    """Parabolas and half swings about the position of rest; the default tolerance accepts no force of 10 N that begins a step late.

    Where contact begins or ends within a step, the velocity is off by half of (w h)^2 = 1.2e-4 at most, with either sign.
    """
    world, k, m, height, end = World(), 2e5, 0.5, 0.8, 3.0
    body = world.ball([0.1, 0.05, height + 0.1], mass=m, gravity=[0, 0, -G], surface={"stiffness": k})
    world.mesh([[-2, -2, 0], [2, -2, 0], [2, 2, 0], [-2, 2, 0]], [[0, 1, 2], [0, 2, 3]], stiffness=k)
    world.solve(end, 120000, tolerance=tolerance)
    w, v = np.sqrt(k / 2 / m), np.sqrt(2 * G * height)
    rest = G / w**2
    contact = (np.pi + 2 * np.arctan2(rest, v / w)) / w
    flight = end - v / G - 4 * contact - 3 * 2 * v / G
    assert 0 < flight < 2 * v / G
    assert world.output(body, "Position")[2] - 0.1 == pytest.approx(v * flight - G * flight**2 / 2, abs=2e-4)


@pytest.mark.parametrize("solver", [IMPLICIT, EXPLICIT])
def test_material_minus_one_has_no_friction(solver: Any) -> None:
    """A material with a row of zeros gives identical results: friction of triangles and balls."""
    spins = []
    for none, table in ((-1, [[0.5]]), (1, [[0.5, 0.0], [0.0, 0.0]])):
        world, rng = World(friction=table), np.random.default_rng(6)
        world.mesh(*grid_mesh(1.0, 3))
        balls = [
            world.ball(
                [x, y, 0.0999],
                rng.uniform(-1, 1, 3) * [1, 1, 0],
                gravity=[0, 0, -9.81],
                surface={"material": material, "damping": 10.0},
            )
            for x, y, material in ((0, 0, none), (0.19, 0, none), (-0.6, 0, 0), (-0.41, 0, none))
        ]
        world.solve(0.02, 200, solver)
        spins.append([world.output(ball, "AngularVelocity") for ball in balls])
    assert np.array_equal(spins[0], spins[1])
    assert np.abs(spins[0][:2] + spins[0][3:]).max() < 1e-15  # rad/s: levers of normal forces are zero to rounding
    assert np.abs(spins[0][2]).max() > 1e-3


def cloud(friction: float, seed: int = 1, **options: Any) -> tuple[World, list[Any]]:
    world, rng = World(friction=friction, zone=0.02), np.random.default_rng(seed)
    places = 0.22 * np.array(list(itertools.product(range(4), repeat=3))) + rng.uniform(-0.005, 0.005, (64, 3))
    make = world.ball if friction else world.point
    return world, [make(p, 2 * (0.33 - p) + rng.uniform(-1, 1, 3), **options) for p in places]


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_momentum_of_a_cloud(friction: float) -> None:
    """Linear momentum to rounding, angular momentum and, without friction, energy as the method of fourth order keeps them."""
    world, bodies = cloud(friction)
    world.mbs.Assemble()
    inertia = 0.4 * 0.1**2 if friction else None
    before = world.totals(bodies, inertia)
    world.solve(0.6, 6000, EXPLICIT)
    after = world.totals(bodies, inertia)
    np.testing.assert_allclose(after[:3], before[:3], atol=1e-11)
    np.testing.assert_allclose(after[3:6], before[3:6], atol=1e-7)
    if not friction:  # the cloud has flown apart again
        assert after[6] == pytest.approx(before[6], rel=1e-5)
    else:
        assert after[6] < 0.95 * before[6]


def test_implicit_and_explicit_integration_agree() -> None:
    states = []
    for solver, steps in ((EXPLICIT, 2000), (IMPLICIT, 4000)):
        world, bodies = cloud(0.3)
        world.solve(0.06, steps, solver)
        states.append([np.concatenate([world.output(b, "Position"), world.output(b, "Velocity")]) for b in bodies])
    change = np.abs(np.array(states[0]) - states[1])
    assert change[:, :3].max() < 1e-4
    assert change[:, 3:].max() < 2e-2


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
def test_any_number_of_threads_gives_the_same_bytes(solver: Any) -> None:
    results = []
    for threads in (1, 2):
        world, _ = cloud(0.3)
        world.solve(0.05, 200, solver, threads)
        data = world.mbs.systemData
        results.append(data.GetODE2Coordinates().tobytes() + data.GetODE2Coordinates_t().tobytes())
    assert results[0] == results[1]


@pytest.mark.parametrize(("friction", "bristles"), [(0.0, 0.0), (0.3, 0.0), (0.3, 0.8)])
def test_threads_that_share_spheres_give_the_same_bytes(friction: float, bristles: float) -> None:
    """Three chunks of a thousand spheres, with contacts inside of them, between them and with a body of triangles, for which they take turns."""
    rng = np.random.default_rng(11)
    places = 0.19 * np.array(list(itertools.product(range(15), repeat=3)))[:3100] + rng.uniform(-0.01, 0.01, (3100, 3))
    speeds = rng.uniform(-1, 1, (3100, 3))
    results = []
    for threads in (1, 2, 3):
        world = World(friction=friction, zone=0.02)
        world.contact.SetFrictionBristles(bristles)
        make = world.ball if friction else world.point
        for place, speed in zip(places, speeds, strict=True):
            make(place, speed)
        plate = world.mbs.CreateRigidBody(referencePosition=[1, 1, -0.08], inertia=InertiaSphere(1e3, 1))
        world.mesh(*grid_mesh(2.0, 9), world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=plate)))
        world.solve(0.02, 40, EXPLICIT, threads)
        data = world.mbs.systemData
        results.append(data.GetODE2Coordinates().tobytes() + data.GetODE2Coordinates_t().tobytes())
        assert np.abs(world.output(plate, "Velocity")).max() > 1e-3
    assert results[0] == results[1] == results[2]


def test_the_list_of_pairs_does_not_show() -> None:
    """A system that looked for pairs elsewhere before goes on as one that did not, bit for bit."""
    fresh, _ = cloud(0.0)
    fresh.solve(0.1, 500, EXPLICIT)
    used, _ = cloud(0.0)
    used.mbs.Assemble()
    data = used.mbs.systemData
    start = data.GetODE2Coordinates()
    for shift in (0.013, 0.05, 0.2):
        data.SetODE2Coordinates(start * 0 + shift * np.arange(len(start)))
        used.contact.UpdateContacts(used.mbs)
    data.SetODE2Coordinates(start)
    used.solve(0.1, 500, EXPLICIT)
    assert data.GetODE2Coordinates().tobytes() == fresh.mbs.systemData.GetODE2Coordinates().tobytes()


@pytest.mark.parametrize("direction", [(1, 0), (1, 1), (-1, 1), (0.83, -0.37)])
def test_ball_rolls_over_a_mesh_as_over_a_plane(direction: tuple[float, float]) -> None:
    """Motion along edges, through corners, and across: it keeps its height to 1e-6 radii, and its speed."""
    radius, k, mass = 0.1, 2e4, 1.0
    sink = mass * G / (k / 2)
    along = np.array([*direction, 0]) / np.linalg.norm(direction)
    world = World(friction=0.5)
    spin = np.cross([0, 0, 1], along) / (radius - sink)
    body = world.ball([0, 0, radius - sink], along, spin, mass, radius, [0, 0, -G])
    world.mesh(*grid_mesh(1.0, 40), stiffness=k)
    sensor = world.mbs.AddSensor(
        eii.SensorBody(bodyNumber=body, outputVariableType=exu.OutputVariableType.Position, storeInternal=True)
    )
    world.solve(0.5, 4000, EXPLICIT)
    height = world.mbs.GetSensorStoredData(sensor)[:, 3]
    assert np.abs(height - (radius - sink)).max() < 1e-6 * radius
    np.testing.assert_allclose(world.output(body, "Velocity"), along, atol=1e-6)


@pytest.mark.parametrize("solver", [EXPLICIT, IMPLICIT])
@pytest.mark.parametrize(("mu", "rolls"), [(0.5, True), (0.05, False)])
def test_ball_on_an_incline(mu: float, rolls: bool, solver: Any) -> None:
    """It rolls where friction is large enough, with the radius that is left of the sunken ball; otherwise it slips."""
    slope, end, k = 0.4, 0.3, 2e4
    sink = G * np.cos(slope) / (k / 2)
    world = World(friction=mu, zone=1e-3)
    surface = {"stiffness": k, "damping": 20.0}
    gravity = [G * np.sin(slope), 0, -G * np.cos(slope)]
    body = world.ball([-1, 0.02, 0.1 - sink], gravity=gravity, surface=surface)
    world.mesh(*grid_mesh(2.0, 7), stiffness=k)
    world.solve(end, 3000, solver)
    inertia = 0.4 * (0.1 / (0.1 - sink)) ** 2
    rate = G * np.sin(slope) / (1 + inertia) if rolls else G * (np.sin(slope) - mu * np.cos(slope))
    assert world.output(body, "Velocity")[0] == pytest.approx(rate * end, abs=5e-4)


@pytest.mark.parametrize(
    ("gap", "rise", "slip"),
    [
        (-0.0046, 0.1051, 1.15),
        (-0.0040, 0.1254, 1.35),
        (-0.0012, 0.21, 2.2),
        (-0.0004, -0.3, 0.5),
        (-0.002, 0.01, 0.004),
    ],
)
def test_bodies_that_leave_a_plate_feel_no_force(gap: float, rise: float, slip: float) -> None:
    """Foot of a robot that slides and rises, or sinks or sticks: the normal force is cut at zero, so friction takes power only.

    Friction of a negative normal force would act along the slip without the limit: the second state has 30 W.
    """
    stiffness, damping, friction, zone, radius = 5e4, 500.0, 0.8, 0.01, 0.05
    normal_force = max(0.0, -0.5 * stiffness * gap - 2 * damping * rise)
    for spins in (False, True):
        world = World(friction, zone)
        lever = radius + gap
        spin, velocity = ([0, -slip / lever, 0], [0, 0, rise]) if spins else ([0, 0, 0], [slip, 0, rise])
        surface = {"stiffness": stiffness, "damping": damping}
        body = world.ball([0.1, 0.2, radius + gap], velocity, spin, radius=radius, surface=surface)
        world.mesh(*grid_mesh(1.0, 3), stiffness=stiffness, damping=damping)
        world.mbs.Assemble()
        force = world.contact.GetSystemODE2RhsContactForces()
        rubbed = -friction * normal_force * min(1.0, slip / zone)
        np.testing.assert_allclose(force[:3], [rubbed, 0, normal_force], rtol=1e-12, atol=1e-9)
        # rotation vector and local axes are those of the frame in a state without rotation
        np.testing.assert_allclose(force[3:], np.cross([0, 0, -lever], [rubbed, 0, 0]), rtol=1e-12, atol=1e-9)
        before, step = world.output(body, "Velocity"), 1e-6
        world.solve(step, 1, exu.DynamicSolverType.ExplicitEuler)
        np.testing.assert_allclose((world.output(body, "Velocity") - before) / step, force[:3], rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("slip", [0.0, 1.5])
def test_a_damped_bounce_takes_energy_at_every_step(slip: float) -> None:
    """A ball falls on a plate, slides, and leaves it: contact never supplies energy, for any damping."""
    world, k = World(0.8, 1e-2), 5e4
    surface = {"stiffness": k, "damping": 500.0}
    body = world.ball([0, 0, 0.051], [slip, 0, -0.5], [0, -10.0 * slip, 0], radius=0.05, surface=surface)
    world.mesh(*grid_mesh(1.0, 3), stiffness=k, damping=500.0)
    names = ("Position", "Velocity", "AngularVelocity")
    sensors = [
        world.mbs.AddSensor(
            eii.SensorBody(bodyNumber=body, outputVariableType=getattr(exu.OutputVariableType, n), storeInternal=True)
        )
        for n in names
    ]
    world.solve(0.05, 50000, exu.DynamicSolverType.ExplicitEuler)
    position, velocity, spin = (world.mbs.GetSensorStoredData(s)[:, 1:4] for s in sensors)
    inertia = 0.4 * 0.05**2
    energy = 0.5 * (velocity**2).sum(axis=1) + 0.5 * inertia * (spin**2).sum(axis=1)
    elastic = 0.5 * (k / 2) * np.minimum(position[:, 2] - 0.05, 0) ** 2
    assert velocity[-1, 2] > 0 and position[-1, 2] > 0.05
    assert np.diff(velocity[:, 2]).min() > -1e-12  # never pulled
    assert np.diff(energy + elastic).max() < 1e-5
    assert energy[-1] < energy[0] - 0.05


def test_materials_make_pairs() -> None:
    """A sliding ball is slowed by the coefficient of its own material and that of the ground."""
    world = World(friction=[[0.0, 0.2], [0.2, 0.7]])
    body = world.ball([0, 0, 0.1 - G / 1e4], [2, 0, 0], gravity=[0, 0, -G], surface={"material": 1})
    world.mesh(*grid_mesh(2.0, 5), material=0)
    world.solve(0.1, 1000, EXPLICIT)
    assert world.output(body, "Velocity")[0] == pytest.approx(2 - 0.2 * G * 0.1, abs=1e-4)


def test_several_contacts_in_one_system() -> None:
    """Spheres meet those of the same contact alone; they pass each other without it."""
    for shared in (True, False):
        world = World()
        first = world.point([0, 0, 0], [1, 0, 0])
        if not shared:
            world.contact = world.mbs.AddGeneralContact()
            world.contact.SetFrictionPairings(np.zeros((1, 1)))
        world.point([0.25, 0, 0])
        assert world.mbs.NumberOfGeneralContacts() == (1 if shared else 2)
        world.solve(0.2, 2000, EXPLICIT)
        assert world.output(first, "Velocity")[0] == pytest.approx(0 if shared else 1, abs=1e-3)
