"""Terms that are no items choose their pairs between steps, and the pattern of the matrix follows. General contact, spheres in a box."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from test_general_contact import G, World

import dalembert as exu
from dalembert._core import testing

RADIUS, MASS, STIFFNESS = 0.1, 0.5, 2e3  # of a pair: each of its surfaces is twice as stiff
CORNERS = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
FACES = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]  # normals lead inwards


class Box:
    """Spheres on a grid, with random velocities; those of one row are heavier."""

    def __init__(self, rows: int = 3, size: float = 1.0, division: int | None = None, seed: int = 1) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        contact = mbs.AddGeneralContact()
        contact.SetFrictionPairings([[0.0]])
        ground = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.CreateGround()))
        triangles = [[f[0], *pair] for f in FACES for pair in (f[1:3], f[2:4])]
        contact.AddTrianglesRigidBodyBased(ground, 2 * STIFFNESS, 0.0, 0, size * CORNERS, triangles)
        rng = np.random.default_rng(seed)
        axis = 2.6 * RADIUS * np.arange(rows)
        places = np.array(np.meshgrid(axis, axis, axis)).reshape(3, -1).T
        places += (size - places.max(axis=0) - places.min(axis=0)) / 2
        self.masses = np.where(np.arange(len(places)) % rows == 0, 2 * MASS, MASS)
        for place, mass in zip(places, self.masses, strict=True):
            node = mbs.AddNode(exu.NodePoint(referenceCoordinates=place, initialVelocities=rng.uniform(-2, 2, 3)))
            body = mbs.AddObject(exu.ObjectMassPoint(physicsMass=mass, nodeNumber=node))
            marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body))
            contact.AddSphereWithMarker(marker, RADIUS, 2 * STIFFNESS, 0.0, 0)
        mbs.Assemble()
        if division is not None:
            testing.divide(mbs, division, threads=1)
        self.size = size

    def solve(self, end: float, steps: int, **options: Any) -> None:
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        settings.linearSolverType = options.get("linear", exu.LinearSolverType.EigenSparse)
        settings.parallel.numberOfThreads = options.get("threads", 1)
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps, time.verboseMode = end, steps, 0
        time.generalizedAlpha.spectralRadius = 1
        time.newton.useModifiedNewton = options.get("modified", False)
        time.newton.relativeTolerance = 1e-10
        time.discontinuous.iterationTolerance = 1e-6
        time.discontinuous.maxIterations = 20
        self.mbs.SolveDynamic(settings)

    def state(self) -> tuple[np.ndarray, np.ndarray]:
        data, of = self.mbs.systemData, exu.ConfigurationType
        q = data.GetODE2Coordinates(of.Reference) + data.GetODE2Coordinates()
        return q.reshape(-1, 3), data.GetODE2Coordinates_t().reshape(-1, 3)

    def momenta(self) -> np.ndarray:
        x, v = self.state()
        p = self.masses[:, None] * v
        return np.concatenate([p.sum(axis=0), np.cross(x, p).sum(axis=0)])

    def energy(self) -> float:
        x, v = self.state()
        i, j = np.triu_indices(len(x), 1)
        overlaps = [2 * RADIUS - np.linalg.norm(x[i] - x[j], axis=1), RADIUS - x, x - self.size + RADIUS]
        stored = sum((np.maximum(overlap, 0) ** 2).sum() for overlap in overlaps)
        return float((self.masses @ (v**2).sum(axis=1) + STIFFNESS * stored) / 2)


@pytest.mark.parametrize("linear", [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenDense])
def test_pattern_follows_the_search(linear: Any) -> None:
    """Motion in contact is that of dense matrices, which need no pattern."""
    dense, sparse = Box(), Box()
    dense.solve(0.15, 300, linear=linear)
    sparse.solve(0.15, 300)
    assert testing.pattern_revisions(dense.mbs) == 0
    assert 3 < testing.pattern_revisions(sparse.mbs) < 300
    assert np.abs(sparse.state()[1] - Box().state()[1]).max() > 1
    for one, other in zip(dense.state(), sparse.state(), strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-7)


def test_modified_newton_makes_a_new_matrix_when_the_pattern_changes() -> None:
    modified, full = Box(), Box()
    modified.solve(0.1, 200, modified=True)
    full.solve(0.1, 200)
    np.testing.assert_allclose(modified.state()[0], full.state()[0], rtol=0, atol=1e-7)


def test_momentum_without_walls() -> None:
    """Linear momentum to rounding; angular momentum and energy up to the square of the step."""
    errors = []
    for steps in (200, 400):
        box = Box(size=10.0)
        momenta, energy = box.momenta(), box.energy()
        box.solve(0.2, steps)
        np.testing.assert_allclose(box.momenta()[:3], momenta[:3], rtol=0, atol=1e-11)
        errors.append([np.abs(box.momenta() - momenta)[3:].max(), abs(box.energy() - energy)])
    assert errors[1][0] < 2e-4 * np.abs(momenta[3:]).max()
    assert errors[1][1] < 2e-3 * energy


def test_energy_between_walls() -> None:
    box = Box()
    energy = box.energy()
    box.solve(0.5, 4000)
    x, _ = box.state()
    assert (x > 0).all() and (x < box.size).all()
    assert box.energy() == pytest.approx(energy, rel=2e-3)


def test_history_is_set_back_when_a_step_fails() -> None:
    """A step in which a bristle gives way is refused, and taken in two halves: bit-identical to two steps from the
    start."""
    results = []
    for steps in (1, 2):
        world = World(0.3)
        world.contact.SetFrictionBristles(0.8, 1.0, 1.0)
        world.mesh([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], [[0, 1, 2], [0, 2, 3]])
        block = world.point([0, 0, 0.1 - G / 1e4], [0.3, 0, 0])  # it sinks as far as its weight wants
        marker = world.mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=block))
        world.mbs.AddLoad(exu.LoadForceVector(markerNumber=marker, loadVector=[0, 0, -G]))
        world.mbs.Assemble()
        refusals = [0.0, 1e9] if steps == 1 else [0.0]
        world.mbs.SetPostNewtonUserFunction(
            lambda mbs, t, left=refusals: [left.pop() if len(left) > 1 else left[0], -1]
        )
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps, time.verboseMode = 0.01, steps, 0
        time.adaptiveStep, time.adaptiveStepDecrease = True, 0.5
        time.discontinuous.maxIterations, time.discontinuous.iterationTolerance = 1, 1e8
        time.discontinuous.ignoreMaxIterations = False
        world.mbs.SolveDynamic(settings)
        assert len(refusals) == 1
        results.append(np.concatenate([world.output(block, name) for name in ("Position", "Velocity", "Acceleration")]))
    assert 0 < results[0][3] < 0.3  # it was slowed down
    np.testing.assert_array_equal(*results)


def test_any_number_of_threads_gives_the_same_bits() -> None:
    results = []
    for threads in (1, 2):
        box = Box(rows=4, size=1.3, division=24)
        box.solve(0.05, 100, threads=threads)
        results.append(np.concatenate(box.state()))
    assert testing.pattern_revisions(box.mbs) > 0
    np.testing.assert_array_equal(*results)
