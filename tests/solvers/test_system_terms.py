"""A contribution that is no item: it finds its pairs between steps, and the pattern of the matrix follows. Spheres in a box."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing

RADIUS, MASS, STIFFNESS = 0.1, 0.5, 2e3


class Box:
    """Spheres on a grid, with random velocities; those of one row are heavier."""

    def __init__(
        self, rows: int = 3, size: float = 1.0, division: int | None = None, seed: int = 1, **contact: Any
    ) -> None:
        self.mbs = mbs = exu.SystemContainer().AddSystem()
        rng = np.random.default_rng(seed)
        axis = 2.6 * RADIUS * np.arange(rows)
        places = np.array(np.meshgrid(axis, axis, axis)).reshape(3, -1).T
        places += (size - places.max(axis=0) - places.min(axis=0)) / 2
        self.masses = np.where(np.arange(len(places)) % rows == 0, 2 * MASS, MASS)
        self.markers = []
        for place, mass in zip(places, self.masses, strict=True):
            node = mbs.AddNode(exu.NodePoint(referenceCoordinates=place, initialVelocities=rng.uniform(-2, 2, 3)))
            body = mbs.AddObject(exu.ObjectMassPoint(physicsMass=mass, nodeNumber=node))
            self.markers.append(mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body)))
        mbs.Assemble()
        if division is not None:
            testing.divide(mbs, division, threads=1)
        self.size = size
        numbers, radii = [int(m) for m in self.markers], [RADIUS] * len(places)
        options = {"margin": 0.05, "stiffness": STIFFNESS, **contact}
        testing.add_spheres_in_box(mbs, numbers, radii, [0.0] * 3, [size] * 3, **options)

    def solve(
        self, end: float, steps: int, solver: Any = exu.DynamicSolverType.GeneralizedAlpha, **options: Any
    ) -> None:
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
        self.mbs.SolveDynamic(settings, solverType=solver)

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


def test_pattern_follows_what_is_found() -> None:
    """The same motion as with a pattern of all pairs, which never changes."""
    boxes = [Box(all_pairs=everything) for everything in (False, True)]
    for box in boxes:
        box.solve(0.15, 300)
    found, everything = (testing.pattern_revisions(box.mbs) for box in boxes)
    assert 3 < found < 300
    assert everything <= 1
    assert np.abs(boxes[0].state()[1] - Box().state()[1]).max() > 1
    for one, other in zip(boxes[0].state(), boxes[1].state(), strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-7)


@pytest.mark.parametrize("linear", [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenDense])
def test_dense_matrices_need_no_revision(linear: Any) -> None:
    dense, sparse = Box(), Box()
    dense.solve(0.1, 200, linear=linear)
    sparse.solve(0.1, 200)
    assert testing.pattern_revisions(dense.mbs) == 0
    np.testing.assert_allclose(dense.state()[0], sparse.state()[0], rtol=0, atol=1e-8)


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


@pytest.mark.parametrize("restitution", [1.0, 0.7])
def test_history_of_pairs_survives(restitution: float) -> None:
    """Explicit steps need no matrix: bit for bit those of all pairs, whose data are never dropped."""
    boxes = [Box(restitution=restitution, all_pairs=everything) for everything in (False, True)]
    before = boxes[0].energy()
    for box in boxes:
        box.solve(0.2, 2000, exu.DynamicSolverType.RK44)
    for one, other in zip(boxes[0].state(), boxes[1].state(), strict=True):
        np.testing.assert_array_equal(one, other)
    lost = 1 - boxes[0].energy() / before
    assert abs(lost) < 2e-3 if restitution == 1 else lost > 0.05


def test_restitution_of_one_impact() -> None:
    """The speed at the begin of the impact is kept with the pair until it ends."""
    box = Box(rows=1, restitution=0.95)
    box.mbs.systemData.SetODE2Coordinates_t([0, 0, -2], exu.ConfigurationType.Initial)
    box.solve(0.35, 7000)
    assert box.state()[1][0, 2] == pytest.approx(2 * 0.95, rel=0.005)  # of Hunt and Crossley, for restitutions near 1


def test_history_is_set_back_when_a_step_fails() -> None:
    """A step in which a contact closes is refused, and taken in two halves: bit for bit what two steps give from the start."""
    results = []
    for steps in (1, 2):
        box = Box(rows=1, restitution=0.8, margin=1.0)
        height = box.state()[0][0, 2] - RADIUS
        box.mbs.systemData.SetODE2Coordinates_t([0, 0, -height / 0.0055], exu.ConfigurationType.Initial)
        refusals = [0.0, 1e9] if steps == 1 else [0.0]
        box.mbs.SetPostNewtonUserFunction(lambda mbs, t, left=refusals: [left.pop() if len(left) > 1 else left[0], -1])
        settings = exu.SimulationSettings()
        settings.solutionSettings.writeSolutionToFile = False
        time = settings.timeIntegration
        time.endTime, time.numberOfSteps, time.verboseMode = 0.01, steps, 0
        time.adaptiveStep, time.adaptiveStepDecrease = True, 0.5
        time.discontinuous.maxIterations, time.discontinuous.iterationTolerance = 1, 1e8
        time.discontinuous.ignoreMaxIterations = False
        box.mbs.SolveDynamic(settings)
        assert len(refusals) == 1
        results.append(np.concatenate(box.state()))
    np.testing.assert_array_equal(*results)


def test_any_number_of_threads_gives_the_same_bits() -> None:
    results = []
    for threads in (1, 2):
        box = Box(rows=4, size=1.3, division=24)
        box.solve(0.05, 100, threads=threads)
        results.append(np.concatenate(box.state()))
    assert testing.pattern_revisions(box.mbs) > 0
    np.testing.assert_array_equal(*results)


def test_another_assembling_makes_a_system_without_it() -> None:
    box = Box(rows=2, size=0.3)
    r = testing.residual(box.mbs, testing.State(box.mbs))
    box.mbs.Assemble()
    box.solve(0.01, 10)
    assert np.isfinite(r).all()
    assert testing.pattern_revisions(box.mbs) == 0
