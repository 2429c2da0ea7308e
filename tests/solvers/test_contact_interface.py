"""Outputs of general contact, changes, copies, deletion, and rejected arguments; sensors of distances on it."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from test_general_contact import CUBE, CUBE_FACES, EXPLICIT, IMPLICIT, World, grid_mesh

import dalembert as exu
from dalembert import itemInterface as eii
from dalembert.robotics.utilities import AddLidar

TYPES = exu.ContactTypeIndex


def hills(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    return 0.2 * np.sin(3 * x) * np.cos(2 * y)


# ---- lines -----------------------------------------------------------------------------------------------------------


def first_triangle(points: np.ndarray, triangles: np.ndarray, start: np.ndarray, along: np.ndarray) -> float:
    """The smallest distance to any triangle, from solutions of p0 + a e1 + b e2 = start + s along by Cramer's rule."""
    p0, p1, p2 = (points[triangles[:, i]] for i in range(3))
    one, two, to = p1 - p0, p2 - p0, start - p0
    volume = np.cross(one, two) @ -along
    with np.errstate(divide="ignore", invalid="ignore"):
        a = np.cross(to, two) @ -along / volume
        b = np.cross(one, to) @ -along / volume
        s = np.einsum("ij,ij->i", np.cross(one, two), to) / volume
    hit = (np.abs(volume) > 1e-12) & (a >= 0) & (b >= 0) & (a + b <= 1) & (s >= 0)
    return float(s[hit].min()) if hit.any() else 1e7


def test_lines_hit_the_nearest_object() -> None:
    rng, world = np.random.default_rng(2), World()
    points, triangles = grid_mesh(1.0, 12, hills)
    world.mesh(points, triangles)
    centres, radii = rng.uniform(-1, 1, (20, 3)) + [0, 0, 1.5], rng.uniform(0.05, 0.3, 20)
    for centre, radius in zip(centres, radii, strict=True):
        world.point(centre, radius=radius)
    world.mbs.Assemble()
    kinds = set()
    for _ in range(300):
        start, along = rng.uniform(-1, 1, 3) + [0, 0, 2], rng.normal(size=3) - [0, 0, 1]
        unit = along / np.linalg.norm(along)
        expected = first_triangle(points, triangles, start, unit)
        to = centres - start
        ahead = to @ unit
        inside = radii**2 - (np.einsum("ij,ij->i", to, to) - ahead**2)
        front = ahead - np.sqrt(np.maximum(inside, 0))
        expected = min([expected, *front[(inside > 0) & (front >= 0)]])
        found = world.contact.ShortestDistanceAlongLine(start, along, 0, 1e7, asDictionary=True)
        assert found["distance"] == pytest.approx(expected, abs=1e-9)
        kinds.add(found["typeIndex"])
        assert world.contact.ShortestDistanceAlongLine(start, along, 0, 1e7) == found["distance"]
        of_triangles = world.contact.ShortestDistanceAlongLine(
            start, along, 0, 1e7, typeIndex=TYPES.IndexTrigsRigidBodyBased
        )
        assert of_triangles == pytest.approx(first_triangle(points, triangles, start, unit), abs=1e-9)
    assert kinds == {
        int(t) for t in (TYPES.IndexSpheresMarkerBased, TYPES.IndexTrigsRigidBodyBased, TYPES.IndexEndOfEnumList)
    }


def test_cylinders_find_spheres_near_a_line() -> None:
    world = World()
    world.point([1, 0.25, 0], [3, 5, 0], radius=0.1)
    world.mbs.Assemble()
    of = {"typeIndex": TYPES.IndexSpheresMarkerBased, "asDictionary": True}
    assert world.contact.ShortestDistanceAlongLine(cylinderRadius=0.1, **of)["itemIndex"] == -1
    found = world.contact.ShortestDistanceAlongLine(cylinderRadius=0.2, **of)
    assert found == {
        "distance": pytest.approx(1 - np.sqrt(0.1**2 - 0.05**2)), "velocityAlongLine": pytest.approx(3), "itemIndex": 0, "typeIndex": 0,
    }  # fmt: skip
    assert world.contact.ShortestDistanceAlongLine(cylinderRadius=0.3, **of)["distance"] == pytest.approx(0.9)


def first_sphere(
    centres: np.ndarray, radii: np.ndarray, start: np.ndarray, unit: np.ndarray, wide: float = 0.0
) -> tuple[float, int]:
    """The smallest distance to any sphere, and its number, from the roots of the quadratic equations of cylinders around the line."""
    to = centres - start
    ahead = to @ unit
    aside = np.linalg.norm(to - np.outer(ahead, unit), axis=1)
    inside = radii**2 - np.maximum(0, aside - wide) ** 2
    front = np.where(
        (inside > 0) & (ahead - np.sqrt(np.maximum(0, inside)) >= 0), ahead - np.sqrt(np.maximum(0, inside)), 1e7
    )
    return float(front.min()), int(front.argmin()) if front.min() < 1e7 else -1


class Swarm:
    """Spheres, and many lines at once: they are sought in a tree that is made of one state."""

    def __init__(self, seed: int = 4) -> None:
        self.rng, self.world = np.random.default_rng(seed), World()
        self.places, self.radii = self.rng.uniform(-1, 1, (150, 3)), self.rng.uniform(0.02, 0.1, 150)
        self.bodies = [self.world.point(x, radius=r) for x, r in zip(self.places, self.radii, strict=True)]
        self.world.mbs.Assemble()

    def check(self, places: np.ndarray, count: int = 120, wide: float = 0.0) -> None:
        """All lines hit the expected objects at these positions; some of them meet something."""
        numbers = set()
        for _ in range(count):
            start = self.rng.uniform(-2, 2, 3)
            along = places[self.rng.integers(len(places))] + 0.1 * self.rng.normal(size=3) - start
            distance, number = first_sphere(places, self.radii, start, along / np.linalg.norm(along), wide)
            found = self.world.contact.ShortestDistanceAlongLine(
                start, along, 0, 1e7, True, wide, TYPES.IndexSpheresMarkerBased
            )
            assert found["distance"] == pytest.approx(distance, abs=1e-9)
            assert found["itemIndex"] == number
            numbers.add(number)
        assert len(numbers) > 10


def test_many_lines_agree_with_single_lines() -> None:
    swarm = Swarm()
    for wide in (0.0, 0.1):
        swarm.check(swarm.places, wide=wide)


def test_lines_are_of_the_state_of_the_moment() -> None:
    """All ways of moving the spheres: user functions, present and previous views, a solver, radii."""
    swarm = Swarm()
    data, contact = swarm.world.mbs.systemData, swarm.world.contact
    swarm.check(swarm.places)
    move = swarm.rng.uniform(-0.5, 0.5, swarm.places.shape)
    data.SetODE2Coordinates(move.ravel())
    swarm.check(swarm.places + move)
    view = data.GetODE2Coordinates(copy=False)
    swarm.check(swarm.places + move)
    view += 0.25
    swarm.check(swarm.places + move + 0.25)
    view *= 0
    del view
    swarm.check(swarm.places)
    swarm.check(swarm.places)
    swarm.radii = 1.5 * swarm.radii
    for i, radius in enumerate(swarm.radii):
        contact.SetSphereMarkerBased(i, radius=radius)
    swarm.check(swarm.places)
    system_state = data.GetSystemState()
    data.SetODE2Coordinates(move.ravel())
    swarm.check(swarm.places + move)
    data.SetSystemState(system_state)
    swarm.check(swarm.places)
    data.SetODE2Coordinates_t(move.ravel(), configuration=exu.ConfigurationType.Initial)
    contact.isActive = False
    swarm.world.solve(0.5, 10, exu.DynamicSolverType.ExplicitEuler)
    swarm.check(swarm.places + 0.5 * move)
    swarm.world.mbs.GetNodeOutput(0, exu.OutputVariableType.Position, exu.ConfigurationType.Reference)
    swarm.check(swarm.places + 0.5 * move)


@pytest.mark.parametrize(
    "solver", [exu.DynamicSolverType.ExplicitEuler, exu.DynamicSolverType.VelocityVerlet, EXPLICIT, IMPLICIT]
)
def test_lines_during_a_solution_are_of_its_steps(solver: Any) -> None:
    """Functions that are called before and after each step see spheres where they are then."""
    swarm, speed, times = Swarm(), np.array([0.3, 0.2, -0.1]), [0.0]
    mbs = swarm.world.mbs
    mbs.systemData.SetODE2Coordinates_t(np.tile(speed, len(swarm.radii)), configuration=exu.ConfigurationType.Initial)
    swarm.world.contact.isActive = False

    def before(mbs: Any, t: float) -> bool:
        swarm.check(swarm.places + times[-1] * speed, 60)
        return True

    def after(mbs: Any, t: float) -> bool:
        times.append(t)
        swarm.check(swarm.places + t * speed, 60)
        return True

    mbs.SetPreStepUserFunction(before)
    mbs.SetPostStepUserFunction(after)
    swarm.world.solve(1.0, 4, solver)
    assert times[-4:] == [0.25, 0.5, 0.75, 1]


def test_lines_follow_a_body_that_turns() -> None:
    """The velocity along the line is that of the point of the body."""
    world = World()
    body = world.mbs.CreateRigidBody(
        referencePosition=[0, 0, 5], initialVelocity=[0, 0, 1], initialAngularVelocity=[0, 2, 0],
        inertia=exu.utilities.InertiaSphere(1, 1),
    )  # fmt: skip
    world.mesh(CUBE, CUBE_FACES, world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=body)))
    world.mbs.Assemble()
    found = world.contact.ShortestDistanceAlongLine([0.3, 0.1, 0], [0, 0, 2], 0, 10, asDictionary=True)
    assert found["distance"] == pytest.approx(4)
    assert found["velocityAlongLine"] == pytest.approx(1 - 2 * 0.3)  # upwards, and the turn takes this side down
    world.solve(0.5, 100, EXPLICIT)
    turned = world.output(body, "RotationMatrix").reshape(3, 3)
    place = world.output(body, "Position")
    expected = first_triangle(place + CUBE @ turned.T, CUBE_FACES, np.array([0.3, 0.1, 0]), np.array([0, 0, 1.0]))
    assert world.contact.ShortestDistanceAlongLine([0.3, 0.1, 0], [0, 0, 2]) == pytest.approx(expected, abs=1e-9)


def test_distance_sensors() -> None:
    world = World()
    body = world.point([0, 0, 2], [0, 0, -1], radius=0.5)
    world.mesh(*grid_mesh(3.0, 4))
    number = world.mbs.NumberOfGeneralContacts() - 1
    down = world.mbs.CreateDistanceSensor(
        number, [0, 0, 10], [0, 0, -1], minDistance=0, measureVelocity=True, storeInternal=True
    )
    marker = world.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=body))
    ground = world.mbs.CreateDistanceSensor(
        number, marker, [0, 0, -1], minDistance=0, selectedTypeIndex=TYPES.IndexTrigsRigidBodyBased
    )
    world.solve(0.5, 10, EXPLICIT)
    np.testing.assert_allclose(world.mbs.GetSensorValues(down), [8.0, 1.0], atol=1e-12)
    assert world.mbs.GetSensorValues(ground) == pytest.approx(1.5)
    stored = world.mbs.GetSensorStoredData(down)
    np.testing.assert_allclose(stored[:, 1], 7.5 + stored[:, 0], atol=1e-12)


def test_lidar() -> None:
    """A fan of rays in a square room, on a cart that moves and turns: distances of the walls by their closed form."""
    world, rays = World(), 24
    room = world.mbs.CreateDistanceSensorGeometry(4 * CUBE, CUBE_FACES[:, ::-1], rigidBodyMarkerIndex=world.ground)
    cart = world.mbs.CreateRigidBody(
        initialVelocity=[1, -0.5, 0], initialAngularVelocity=[0, 0, 2], inertia=exu.utilities.InertiaSphere(1, 1)
    )
    marker = world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=cart))
    sensors = AddLidar(
        world.mbs, room, marker, numberOfSensors=rays, angleEnd=2 * np.pi * (1 - 1 / rays), addGraphicsObject=False
    )
    for time in (0.0, 0.7):
        if time:
            world.solve(time, 70, IMPLICIT)
        else:
            world.mbs.Assemble()
        turned = world.output(cart, "RotationMatrix").reshape(3, 3)
        angles = 2 * np.pi * np.arange(rays) / rays + np.arctan2(turned[1, 0], turned[0, 0])
        along = np.stack([np.cos(angles), np.sin(angles)])
        place = np.array([[time], [-0.5 * time]])
        with np.errstate(divide="ignore"):  # rays along a wall
            walls = ((np.copysign(4, along) - place) / along).min(axis=0)  # along the ray, the nearer one of both axes
        measured = [world.mbs.GetSensorValues(sensor) for sensor in sensors]
        np.testing.assert_allclose(measured, walls, atol=1e-9)


def test_geometry_of_sensors_does_not_push() -> None:
    world = World()
    number = world.mbs.CreateDistanceSensorGeometry(*grid_mesh(2.0, 3), rigidBodyMarkerIndex=world.ground)
    assert number == 1
    assert not world.mbs.GetGeneralContact(number).isActive
    sensor = world.mbs.CreateDistanceSensor(number, [0.1, 0.2, 3], [0, 0, -2])
    world.mbs.Assemble()
    assert world.mbs.GetSensorValues(sensor) == pytest.approx(3)


# ---- questions and changes -------------------------------------------------------------------------------------------


def items_and_contacts(mbs: exu.MainSystem) -> list[int]:
    counts = [getattr(mbs.systemData, f"NumberOf{kind}s")() for kind in ("Node", "Object", "Marker", "Load", "Sensor")]
    return [*counts, int(mbs.NumberOfGeneralContacts())]


SPHERES = {"selectedTypeIndex": TYPES.IndexSpheresMarkerBased}
REFUSED_SENSORS = {
    "no such contact": ({"generalContactIndex": 2}, r"'generalContactIndex'.*of which this system has 2, received 2"),
    "a contact, not its number": ({"generalContactIndex": True}, "'generalContactIndex'.*CreateDistanceSensorGeometry"),
    "no direction": ({"dirSensor": [0, 0, 0]}, "'dirSensor'.*It is zero"),
    "two components": ({"dirSensor": [0, 1]}, "'dirSensor'.*3 finite components"),
    "no range": ({"minDistance": 5, "maxDistance": 5}, r"'minDistance'.*less than maxDistance, which is 5, received 5"),
    "negative radius": ({"cylinderRadius": -1}, "'cylinderRadius'.*not negative"),
    "a radius for all kinds": ({"cylinderRadius": 0.1}, "'cylinderRadius'.*selectedTypeIndex=.*received 0.1"),
    "a radius without spheres": (SPHERES | {"cylinderRadius": 0.1}, "'cylinderRadius'.*triangles and no spheres"),
    "a kind by number": ({"selectedTypeIndex": 2}, "'selectedTypeIndex'.*a member of ContactTypeIndex.*received 2"),
    "a number as marker": ({"positionOrMarker": 0}, "'positionOrMarker'.*a MarkerIndex, the name of a marker"),
    "no such marker": (
        {"positionOrMarker": exu.MarkerIndex(9)},
        "'positionOrMarker': there is no marker with number 9",
    ),
    "no such name": ({"positionOrMarker": "roof"}, "'positionOrMarker'.*received 'roof'.*Did you mean 'root'"),
    "no position": ({"positionOrMarker": "x"}, "'positionOrMarker'.*a marker with a position.*MarkerNodeCoordinate"),
    "a wrong color": ({"addGraphicsObject": True, "color": [2, 0, 0, 1]}, "'color'.*from 0 to 1"),
}


@pytest.mark.parametrize("case", REFUSED_SENSORS)
def test_distance_sensors_that_would_see_nothing_are_refused_when_they_are_made(case: str) -> None:
    world = World()
    point = world.mbs.AddNode(eii.NodePoint())
    world.mbs.AddMarker(eii.MarkerNodeCoordinate(name="x", nodeNumber=point, coordinate=0))
    root = world.mbs.AddMarker(eii.MarkerNodePosition(name="root", nodeNumber=point))
    number = world.mbs.CreateDistanceSensorGeometry(*grid_mesh(2.0, 3), world.ground)
    before, (wrong, text) = items_and_contacts(world.mbs), REFUSED_SENSORS[case]
    right = {"generalContactIndex": number, "positionOrMarker": root, "dirSensor": [0, 0, -1]}
    with pytest.raises((ValueError, IndexError), match=rf"(?s)CreateDistanceSensor\(.*{text}"):
        world.mbs.CreateDistanceSensor(**right | wrong)
    assert items_and_contacts(world.mbs) == before


def test_distance_sensors_need_a_contact() -> None:
    mbs = exu.SystemContainer().AddSystem()
    with pytest.raises(ValueError, match="which this system has 0. Make one by mbs.CreateDistanceSensorGeometry"):
        mbs.CreateDistanceSensor(0, [0, 0, 0], [1, 0, 0])


REFUSED_GEOMETRY = {
    "an index too many": ({"meshTrigs": [[0, 1, 4]]}, r"'meshTrigs'.*of the 4 points .* from 0 to 3, received 4"),
    "quadrangles": ({"meshTrigs": [[0, 1, 2, 3]]}, "'meshTrigs'.*3 indices"),
    "a fraction": ({"meshTrigs": [[0, 1, 1.5]]}, "'meshTrigs'.*3 indices"),
    "points in the plane": ({"meshPoints": [[0, 0], [1, 0], [0, 1]]}, "'meshPoints'.*3 finite coordinates"),
    "no area": ({"meshTrigs": [[0, 1, 1]]}, "triangleList"),
    "no cells": ({"searchTreeCellSize": [0, 1, 1]}, "'searchTreeCellSize'.*whole numbers greater than zero"),
    "no orientation": ({"rigidBodyMarkerIndex": "point"}, "'rigidBodyMarkerIndex'.*orientation.*MarkerNodePosition"),
    "no such name": ({"rigidBodyMarkerIndex": "pint"}, "'rigidBodyMarkerIndex'.*Did you mean 'point'"),
}


@pytest.mark.parametrize("case", REFUSED_GEOMETRY)
def test_geometry_that_is_refused_leaves_nothing_behind(case: str) -> None:
    world = World()
    world.mbs.AddMarker(eii.MarkerNodePosition(name="point", nodeNumber=world.mbs.AddNode(eii.NodePoint())))
    before, (wrong, text) = items_and_contacts(world.mbs), REFUSED_GEOMETRY[case]
    corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    right = {"meshPoints": corners, "meshTrigs": [[0, 1, 2]], "rigidBodyMarkerIndex": world.ground}
    with pytest.raises(ValueError, match=f"(?s){text}"):
        world.mbs.CreateDistanceSensorGeometry(**right | wrong)
    assert items_and_contacts(world.mbs) == before


def test_items_in_a_box() -> None:
    world = World()
    for x in range(4):
        world.point([x, 0, 0], radius=0.1)
    world.mesh([[0, 0, 5], [1, 0, 5], [0, 1, 5], [9, 9, 9]], [[0, 1, 2], [1, 3, 2]])
    world.mbs.Assemble()
    found = world.contact.GetItemsInBox([1.05, -1, -1], [2, 1, 5])
    assert {key: list(value) for key, value in found.items()} == {
        "MarkerBasedSpheres": [1, 2], "TrigsRigidBodyBased": [1], "ANCFCable2D": [],
    }  # fmt: skip
    assert world.contact.GetItemsInBox([20, 0, 0], [21, 1, 1]) is False


def test_spheres_and_triangles_are_read_and_changed() -> None:
    world = World(friction=np.zeros((2, 2)))
    world.point([0, 0, 0.3], [1, 2, 3], radius=0.1)
    marker = world.mbs.AddMarker(eii.MarkerBodyRigid(bodyNumber=world.mbs.CreateGround(referencePosition=[0, 0, 0.1])))
    assert world.mesh([[-1, -1, 0], [2, -1, 0], [-1, 2, 0]], [[0, 1, 2]]) == 0
    assert world.mesh([[-1, -1, 0], [2, -1, 0], [-1, 2, 0]], [[2, 1, 0]], marker) == 1
    world.mbs.Assemble()
    sphere = world.contact.GetSphereMarkerBased(0, addData=True)
    np.testing.assert_array_equal(sphere["position"], [0, 0, 0.3])
    np.testing.assert_array_equal(sphere["velocity"], [1, 2, 3])
    np.testing.assert_array_equal(sphere["orientation"], np.eye(3))
    assert isinstance(sphere["markerIndex"], exu.MarkerIndex)
    assert sphere["radius"] == 0.1
    force = world.contact.GetSystemODE2RhsContactForces
    np.testing.assert_array_equal(force(), 0)
    world.contact.SetSphereMarkerBased(0, radius=0.31, contactStiffness=4e4, frictionMaterialIndex=1)
    np.testing.assert_allclose(force(), [0, 0, 0.01 * 4e4 * 2e4 / 6e4])
    triangle = world.contact.GetTriangleRigidBodyBased(1)
    np.testing.assert_array_equal(triangle["normal"], [0, 0, -1])
    assert triangle["contactRigidBodyIndex"] == 1
    world.contact.SetTriangleRigidBodyBased(0, [[-1, -1, -1], [2, -1, -1], [-1, 2, -1]])
    np.testing.assert_array_equal(force(), 0)
    world.contact.SetTriangleRigidBodyBased(1, triangle["points"][::-1])
    np.testing.assert_allclose(force(), [0, 0, 0.11 * 4e4 * 2e4 / 6e4])
    world.contact.isActive = False
    np.testing.assert_array_equal(force(), 0)


def test_active_contacts() -> None:
    """Global numbers are those of spheres, then triangles; a negative result is a slip."""
    world = World(friction=0.1)
    for x in (0.0, 0.19, 0.38):
        world.ball([x, 0, 0.09], [5, 0, 0] if x == 0 else [0, 0, 0])
    world.mesh(*grid_mesh(1.0, 1))
    world.mbs.Assemble()
    assert list(world.contact.GetActiveContacts(TYPES.IndexSpheresMarkerBased, 0)) == []
    world.contact.UpdateContacts(world.mbs)
    spheres = TYPES.IndexSpheresMarkerBased
    assert list(world.contact.GetActiveContacts(spheres, -1)) == [2, 2, 1]
    assert list(world.contact.GetActiveContacts(spheres, 0)) == [1, -3]
    assert list(world.contact.GetActiveContacts(spheres, 1)) == [2, 3]
    assert list(world.contact.GetPythonObject()["globalContactIndexOffsets"]) == [0, 3, 3, 5]


def test_settings_that_change_nothing_say_so_once() -> None:
    """A separate process is used, because other tests may have caused the warning already."""
    script = """
import dalembert as exu
for _ in range(2):
    contact = exu.SystemContainer().AddSystem().AddGeneralContact()
    contact.verboseMode, contact.resetSearchTreeInterval = 0, 10000  # the defaults
    contact.excludeDuplicatedTrigSphereContactPoints = contact.computeContactForces = True  # as it is done anyway
    contact.ancfCableUseExactMethod, contact.ancfCableNumberOfContactSegments = False, 8
"""
    told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    stretches = "has no effect: stretches of cables in contact are found exactly, as zeros of a polynomial"
    assert told.splitlines() == [
        f"Warning: GeneralContact.{name} {stretches}"
        for name in ("ancfCableUseExactMethod", "ancfCableNumberOfContactSegments")
    ]


def bouncing() -> World:
    world = World()
    world.point([0, 0, 0.15], [0, 0, -1])
    world.mesh(*grid_mesh(1.0, 2))
    world.contact.verboseMode = 2
    return world


@pytest.mark.parametrize(
    "copied",
    [copy.copy, copy.deepcopy, lambda mbs: pickle.loads(pickle.dumps(mbs))],
    ids=["copy", "deepcopy", "pickle"],
)
def test_copies_go_on_like_the_system(copied: Any) -> None:
    world = bouncing()
    other = World()
    other.mbs = copied(world.mbs)
    other.contact = other.mbs.GetGeneralContact(0)
    assert other.contact.verboseMode == 2
    world.contact.isActive = False  # properties of the first alone
    other.solve(0.2, 500, EXPLICIT)
    assert other.mbs.systemData.GetODE2Coordinates_t()[2] == pytest.approx(1, abs=1e-3)
    world.solve(0.2, 500, EXPLICIT)
    assert world.mbs.systemData.GetODE2Coordinates_t()[2] == -1


def test_variations_have_the_contact() -> None:
    """Three drops with other speeds, each on a thread with a copy of the model, are those of the system itself, bit for bit."""
    world = bouncing()
    sensor = world.mbs.AddSensor(
        eii.SensorNode(nodeNumber=0, outputVariableType=exu.OutputVariableType.Velocity, storeInternal=True)
    )
    world.mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 500, 0.2
    speeds = np.array([[0, 0, -1.0], [0, 0, -2.0], [0, 0, -3.0]])
    for solver in (EXPLICIT, IMPLICIT):
        results = world.mbs.SolveVariations(
            initialCoordinates={"ODE2_t": speeds}, simulationSettings=settings, sensors=[sensor], solverType=solver
        )
        for speed, found in zip(speeds, results.sensorValues, strict=True):
            world.mbs.systemData.SetODE2Coordinates_t(speed, exu.ConfigurationType.Initial)
            world.mbs.SolveDynamic(settings, solverType=solver)
            np.testing.assert_array_equal(found, world.mbs.systemData.GetODE2Coordinates_t())
            assert found[2] == pytest.approx(-speed[2], abs=2e-2)


def test_deleting_and_resetting() -> None:
    world = bouncing()
    second = world.mbs.AddGeneralContact()
    world.mbs.DeleteGeneralContact(0)
    assert world.mbs.NumberOfGeneralContacts() == 1
    with pytest.raises(RuntimeError, match="it was deleted from its system"):
        world.contact.GetSystemODE2RhsContactForces()
    world.solve(0.2, 500, EXPLICIT)
    assert world.mbs.systemData.GetODE2Coordinates_t()[2] == -1
    assert second.GetPythonObject()["numberOfSpheresMarkerBased"] == 0
    world = bouncing()
    world.contact.Reset()
    world.solve(0.2, 500, EXPLICIT)
    assert world.mbs.systemData.GetODE2Coordinates_t()[2] == -1
    world.mbs.Reset()
    assert world.mbs.NumberOfGeneralContacts() == 0


def test_deleted_markers() -> None:
    """Numbers behind a deleted marker move up; a sphere that has lost its marker is named."""
    world = World()
    spare = world.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=0))
    world.point([0, 0, 0.15], [0, 0, -1])
    world.mesh(*grid_mesh(1.0, 2))
    world.mbs.DeleteMarker(spare)
    world.solve(0.2, 500, EXPLICIT)
    assert world.mbs.systemData.GetODE2Coordinates_t()[2] == pytest.approx(1, abs=1e-3)
    number = world.contact.GetSphereMarkerBased(0, True)["markerIndex"]
    with pytest.warns(UserWarning, match="GeneralContact 0: sphere 0 referred to the deleted marker 1"):
        world.mbs.DeleteMarker(number)
    with pytest.raises(IndexError, match="GeneralContact 0, parameter 'sphere 0: markerIndex'"):
        world.mbs.Assemble()


def test_spheres_that_are_added_need_another_assemble() -> None:
    world = bouncing()
    world.mbs.Assemble()
    world.sphere(world.ground, 0.1)
    with pytest.raises(RuntimeError, match="Assemble"):
        world.contact.GetSystemODE2RhsContactForces()


POINTS, FACE = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]
REFUSED: list[tuple[str, dict[str, Any], type[Exception], str]] = [
    ("AddSphereWithMarker", {"radius": 0.0}, ValueError, "'radius': received 0.0, but expected a positive number"),
    ("AddSphereWithMarker", {"radius": float("nan")}, ValueError, "radius"),
    ("AddSphereWithMarker", {"contactStiffness": 0.0}, ValueError, "contactStiffness"),
    ("AddSphereWithMarker", {"contactDamping": -1.0}, ValueError, "contactDamping"),
    ("AddSphereWithMarker", {"frictionMaterialIndex": -2}, ValueError, "or -1: without friction"),
    ("AddSphereWithMarker", {"markerIndex": 7}, IndexError, "marker"),
    ("AddSphereWithMarker", {"markerIndex": exu.NodeIndex(0)}, TypeError, "NodeIndex"),
    ("AddTrianglesRigidBodyBased", {"triangleList": [[0, 1, 3]]}, ValueError, r"triangleList\[0\].*from 0 to 2"),
    ("AddTrianglesRigidBodyBased", {"triangleList": [[0, 1, 1]]}, ValueError, r"triangleList\[0\].*an area"),
    ("AddTrianglesRigidBodyBased", {"triangleList": [[0, 1]]}, ValueError, "triangleList.*3 columns"),
    ("AddTrianglesRigidBodyBased", {"pointList": [[0, 0, np.inf], *POINTS[1:]]}, ValueError, r"pointList\[0\]"),
    ("SetFrictionPairings", {"frictionPairings": [[0.1, 0.2]]}, ValueError, "a square matrix"),
    ("SetFrictionPairings", {"frictionPairings": [[0.1, 0.2], [0.3, 0]]}, ValueError, r"\[0,1\].*action is reaction"),
    ("SetFrictionPairings", {"frictionPairings": [[-0.1]]}, ValueError, "not negative"),
    ("SetFrictionProportionalZone", {"frictionProportionalZone": 0.0}, ValueError, "a positive number"),
    ("SetSearchTreeCellSize", {"numberOfCells": [0, 1, 1]}, ValueError, "3 whole numbers"),
    ("SetSearchTreeBox", {"pMin": [0, 0, 0], "pMax": [1, 1, 0]}, ValueError, "larger than those of pMin"),
    ("ShortestDistanceAlongLine", {"direction": [0, 0, 0]}, ValueError, "direction"),
    ("ShortestDistanceAlongLine", {"minDistance": 2.0, "maxDistance": 1.0}, ValueError, "minDistance"),
    ("ShortestDistanceAlongLine", {"cylinderRadius": 0.1}, ValueError, "a cylinder finds spheres"),
    ("GetSphereMarkerBased", {"localIndex": 1}, IndexError, "there are 1"),
    ("SetSphereMarkerBased", {"localIndex": 0, "frictionMaterialIndex": 1}, ValueError, "frictionPairings"),
    ("GetTriangleRigidBodyBased", {"localIndex": -1}, IndexError, "there are 1"),
    ("SetTriangleRigidBodyBased", {"localIndex": 0, "points": [[0, 0, 0]] * 3}, ValueError, "an area"),
    ("SetTriangleRigidBodyBased", {"localIndex": 0, "points": POINTS, "contactRigidBodyIndex": 1}, ValueError, "less than 1"),
    ("GetActiveContacts", {"typeIndex": TYPES.IndexSpheresMarkerBased, "itemIndex": 5}, IndexError, "itemIndex|localIndex"),
]  # fmt: skip
GOOD: dict[str, dict[str, Any]] = {
    "AddSphereWithMarker": {
        "markerIndex": 0, "radius": 1.0, "contactStiffness": 1.0, "contactDamping": 0.0, "frictionMaterialIndex": 0,
    },
    "AddTrianglesRigidBodyBased": {
        "rigidBodyMarkerIndex": 0, "contactStiffness": 1.0, "contactDamping": 0.0, "frictionMaterialIndex": 0,
        "pointList": POINTS, "triangleList": FACE,
    },
}  # fmt: skip


@pytest.mark.parametrize(("method", "changes", "kind", "expected"), REFUSED)
def test_refused(method: str, changes: dict[str, Any], kind: type[Exception], expected: str) -> None:
    world = World()
    world.point([0, 0, 1])
    world.mesh(POINTS, FACE)
    world.mbs.Assemble()
    before = world.contact.GetPythonObject()
    with pytest.raises(kind, match=expected) as error:
        getattr(world.contact, method)(**GOOD.get(method, {}) | changes)
    assert f"GeneralContact.{method}" in str(error.value)
    assert str(world.contact.GetPythonObject()) == str(before)


def test_refused_when_assembled() -> None:
    world = World()
    world.point([0, 0, 1], material=1)
    with pytest.raises(
        ValueError, match="GeneralContact 0, parameter 'frictionMaterialIndex': received 1, but expected less than 1"
    ):
        world.mbs.Assemble()
    world = World()
    body = world.mbs.CreateMassPoint(referencePosition=[0, 0, 0], physicsMass=1)
    world.mesh(POINTS, FACE, world.mbs.AddMarker(eii.MarkerBodyPosition(bodyNumber=body)))
    with pytest.raises(ValueError, match="rigidBodyMarkerIndex.*MarkerBodyPosition.*a marker with an orientation"):
        world.mbs.Assemble()


@pytest.mark.parametrize("friction", [0.0, 0.3])
def test_spheres_of_one_centre_are_refused(friction: float) -> None:
    """Their contact has no direction, wherever it is asked for; both are named."""

    def stacked() -> World:
        world = World(friction=friction)
        for x in (0.0, 0.5, 0.5):
            world.ball([x, 0, 0])
        world.mbs.Assemble()
        return world

    text = r"GeneralContact 0: spheres 1 \(marker 2\) and 2 \(marker 3\) have one and the same centre"
    for ask in (
        lambda world: world.contact.GetSystemODE2RhsContactForces(),
        lambda world: world.contact.UpdateContacts(world.mbs),
        lambda world: world.solve(0.1, 10, EXPLICIT),
        lambda world: world.solve(0.1, 10, IMPLICIT),
    ):
        with pytest.raises(ValueError, match=text):
            ask(stacked())


def test_spheres_that_come_to_one_centre_are_refused() -> None:
    """Contacts that may be passed through, as their centres meet exactly after one step of 1/4 s."""
    world = World()
    world.point([-0.25, 0, 0], [1, 0, 0], mass=1e12, radius=0.125, stiffness=1e-12)
    world.point([0.25, 0, 0], [-1, 0, 0], mass=1e12, radius=0.125, stiffness=1e-12)
    with pytest.raises(ValueError, match=r"spheres 0 \(marker 1\) and 1 \(marker 2\) have one and the same centre"):
        world.solve(1.0, 4, exu.DynamicSolverType.ExplicitEuler)


def test_spheres_at_one_marker_do_not_touch() -> None:
    """They may have one centre, as the tread and the rim of a wheel."""
    world = World()
    world.ball([0, 0, 0], radius=0.1)
    world.sphere(1, 0.2)
    world.point([0.25, 0, 0], radius=0.1)
    world.mbs.Assemble()
    forces = world.contact.GetSystemODE2RhsContactForces()
    np.testing.assert_allclose(forces, [-500, 0, 0, 0, 0, 0, 500, 0, 0], atol=1e-10)
    world.contact.UpdateContacts(world.mbs)
    assert list(world.contact.GetActiveContacts(TYPES.IndexSpheresMarkerBased, -1)) == [0, 1, 0]


def test_general_contact_belongs_to_a_system() -> None:
    with pytest.raises(RuntimeError, match=r"mbs.AddGeneralContact\(\)"):
        exu.GeneralContact()
    mbs = exu.SystemContainer().AddSystem()
    for method in (mbs.GetGeneralContact, mbs.DeleteGeneralContact):
        with pytest.raises(IndexError, match="there are 0"):
            method(0)
