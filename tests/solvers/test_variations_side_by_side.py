"""Variations whose steps are computed together, in the lanes of registers: results are bit-identical to separate
solutions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from ensembles import Result, Variable, alone, assert_equal, crank, settings

import dalembert as exu
from dalembert.itemInterface import (
    LoadCoordinate,
    MarkerNodeCoordinate,
    Mass1D,
    Node1D,
    NodePointGround,
    ObjectConnectorCoordinate,
    ObjectConnectorCoordinateSpringDamper,
    SensorNode,
)
from dalembert.rigidBodyUtilities import InertiaCuboid

CRANK = 0.1  # m
LANES = 8  # variations that go together


def rods(count: int) -> np.ndarray:
    return np.linspace(0.25, 0.35, count)


def torques(count: int) -> np.ndarray:
    return np.column_stack([np.zeros((count, 2)), np.geomspace(0.01, 30, count)])


def vary_crank(solver_settings: Any, count: int, **options: Any) -> Any:
    """Rods, inertias and torques that differ in every variation; large torques take more iterations."""
    mbs, nodes, bodies, (left, right) = crank(0.3)
    rod, zero = rods(count), np.zeros(count)
    return mbs.SolveVariations(
        {
            (nodes[1], "referenceCoordinates"): np.column_stack([CRANK + rod / 2, zero, zero]),
            (nodes[2], "referenceCoordinates"): np.column_stack([CRANK + rod, zero, zero]),
            (left, "localPosition"): np.column_stack([-rod / 2, zero, zero]),
            (right, "localPosition"): np.column_stack([rod / 2, zero, zero]),
            (bodies[1], "physicsInertia"): rod**2 / 24,
            (exu.LoadIndex(0), "loadVector"): torques(count),
        },
        solver_settings,
        storeHistories=True,
        storeCoordinates=True,
        **options,
    )


def cranks_alone(solver_settings: Any, count: int) -> list[Result]:
    wanted = []
    for rod, torque in zip(rods(count), torques(count), strict=True):
        mbs, _, bodies, _ = crank(rod)
        mbs.SetObjectParameter(bodies[1], "physicsInertia", rod**2 / 24)
        mbs.SetLoadParameter(0, "loadVector", torque)
        wanted.append(alone(mbs, lambda mbs=mbs: mbs.SolveDynamic(solver_settings)))
    return wanted


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("modified", [False, True], ids=["full", "modified"])
@pytest.mark.parametrize("count", [3, LANES, 21])
def test_cranks_agree_with_separate_solutions(count: int, modified: bool, threads: int) -> None:
    s = settings(0.1, 100)
    s.timeIntegration.newton.useModifiedNewton = modified
    results = vary_crank(s, count, numberOfThreads=threads)
    assert_equal(results, cranks_alone(s, count))
    slow = (
        torques(count)[:, 2] < 3
    )  # others rotate by more than the stability limit of equal steps: their velocities are corrected, alone
    assert modified or threads > 1 or results.sideBySide[slow].all()


@pytest.mark.parametrize(
    ("adaptive", "index2", "radius", "mode"), [(True, False, 0.9, 0), (False, True, 1, 0), (False, False, 0.5, 1)]
)
def test_integrators_and_settings(adaptive: bool, index2: bool, radius: float, mode: int) -> None:
    s = settings(0.0937, 41)  # the last step is shorter where steps are summed up
    s.timeIntegration.adaptiveStep = adaptive
    s.timeIntegration.newton.newtonResidualMode = mode
    s.timeIntegration.generalizedAlpha.spectralRadius = radius
    s.timeIntegration.generalizedAlpha.useIndex2Constraints = index2
    s.timeIntegration.generalizedAlpha.useNewmark = index2
    results = vary_crank(s, 11, numberOfThreads=1)
    assert_equal(results, cranks_alone(s, 11))
    assert results.sideBySide[torques(11)[:, 2] < 3].all()


def chain(masses: int = 6) -> Any:
    """Masses along one axis, with springs and dampers between them and to the ground; one is pulled."""
    mbs = exu.SystemContainer().AddSystem()
    rest = mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=mbs.AddNode(NodePointGround()), coordinate=0))
    ends = [rest]
    for k in range(masses):
        node = mbs.AddNode(Node1D(referenceCoordinates=[0.1 * k], initialVelocities=[0.2 * (-1) ** k]))
        mbs.AddObject(Mass1D(nodeNumber=node, physicsMass=0.5 + 0.1 * k))
        ends.append(mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0)))
        mbs.AddObject(
            ObjectConnectorCoordinateSpringDamper(markerNumbers=ends[-2:], stiffness=200 + 10 * k, damping=0.3)
        )
        mbs.AddSensor(SensorNode(nodeNumber=node, outputVariableType=Variable.Coordinates, storeInternal=True))
    mbs.AddLoad(LoadCoordinate(markerNumber=ends[-1], load=1.5))
    mbs.Assemble()
    return mbs


def first_spring() -> Any:
    return exu.ObjectIndex(1)


def test_chains_of_masses() -> None:
    stiffness = np.geomspace(1, 1e5, 13)
    stiffness[4] = 0
    wanted = []
    for k in stiffness:
        mbs = chain()
        mbs.SetObjectParameter(first_spring(), "stiffness", k)
        wanted.append(alone(mbs, lambda mbs=mbs: mbs.SolveDynamic(settings())))
    results = chain().SolveVariations(
        {(first_spring(), "stiffness"): stiffness},
        settings(),
        storeHistories=True,
        storeCoordinates=True,
        numberOfThreads=1,
    )
    assert_equal(results, wanted)
    assert results.sideBySide.all()


@pytest.mark.parametrize("common", [0.0, 1.0])
def test_a_value_that_differs_from_a_common_one(common: float) -> None:
    """Products with one, and sums of products with zero, are left out where all variations have them."""
    dampings = np.array([common, 0.3])

    def damped(value: float) -> Any:
        mbs = chain(3)
        for spring in (1, 3, 5):
            mbs.SetObjectParameter(exu.ObjectIndex(spring), "damping", common)
        mbs.SetObjectParameter(exu.ObjectIndex(3), "damping", value)
        return mbs

    varied = {(exu.ObjectIndex(3), "damping"): dampings}
    results = damped(common).SolveVariations(
        varied, settings(), storeHistories=True, storeCoordinates=True, numberOfThreads=1
    )
    systems = [damped(value) for value in dampings]
    assert_equal(results, [alone(mbs, lambda mbs=mbs: mbs.SolveDynamic(settings())) for mbs in systems])
    assert results.sideBySide.all()


def held_together() -> Any:
    """Two masses with the same motion: rows change places in the elimination, which ones depends on the masses."""
    mbs = chain(2)
    ends = [mbs.AddMarker(MarkerNodeCoordinate(nodeNumber=exu.NodeIndex(n), coordinate=0)) for n in (1, 2)]
    mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=ends, offset=0.1))
    mbs.Assemble()
    return mbs


def held() -> Any:
    mbs = chain(1)
    mbs.AddObject(ObjectConnectorCoordinate(markerNumbers=[exu.MarkerIndex(0), exu.MarkerIndex(1)]))
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize("modified", [False, True], ids=["full", "modified"])
@pytest.mark.parametrize(
    ("make", "unknowns"),
    [
        (lambda: chain(1), 1),
        (lambda: chain(2), 2),
        (held, 2),
        (held_together, 3),
        (lambda: chain(3), 3),
        (lambda: chain(4), 4),
    ],
)
def test_few_unknowns(make: Callable[[], Any], unknowns: int, modified: bool) -> None:
    """Masses over nine decades, so that pivots lie in different rows."""
    masses, stiffness = np.geomspace(1e-4, 1e5, 13), np.geomspace(1, 1e6, 13)[::-1]
    s = settings()
    s.timeIntegration.newton.useModifiedNewton = modified
    varied = {(exu.ObjectIndex(0), "physicsMass"): masses, (first_spring(), "stiffness"): stiffness}
    mbs = make()
    assert mbs.systemData.ODE2Size() + mbs.systemData.AEsize() == unknowns
    results = mbs.SolveVariations(varied, s, storeHistories=True, storeCoordinates=True, numberOfThreads=1)
    wanted = []
    for mass, k in zip(masses, stiffness, strict=True):
        mbs.SetObjectParameter(exu.ObjectIndex(0), "physicsMass", mass)
        mbs.SetObjectParameter(first_spring(), "stiffness", k)
        mbs.Assemble()
        wanted.append(alone(mbs, lambda mbs=mbs: mbs.SolveDynamic(s)))
    assert_equal(results, wanted)
    assert results.sideBySide.all()


def hanging_masses() -> tuple[Any, dict[str, Any]]:
    """Five masses in a row between two supports, on springs along lines and along axes, with gravity and a force; and its items."""
    mbs = exu.SystemContainer().AddSystem()
    ends = [mbs.CreateGround(), mbs.CreateGround(referencePosition=[3, 0, 0.2])]
    masses = [
        mbs.CreateMassPoint(
            referencePosition=[0.5 * k, 0.1 * k**2, -0.05 * k],
            initialVelocity=[0.1 * k, 0, -0.3],
            physicsMass=0.3 + 0.1 * k,
            gravity=[0, -9.81, 0],
        )
        for k in range(1, 6)
    ]
    row = [ends[0], *masses, ends[1]]
    springs = [
        mbs.CreateSpringDamper(
            bodyNumbers=row[k : k + 2], referenceLength=0.4, stiffness=300 + k, damping=0.5 * k, force=2
        )
        for k in range(6)
    ]
    loose = mbs.CreateSpringDamper(bodyNumbers=[row[1], row[4]], stiffness=50)
    mbs.SetObjectParameter(loose, "activeConnector", False)
    mbs.CreateCartesianSpringDamper(bodyNumbers=[row[2], row[5]], stiffness=[20, 30, 40], damping=[1, 2, 3])
    force = mbs.CreateForce(bodyNumber=masses[2], loadVector=[1, 2, 3])
    for k in (0, 3):
        mbs.AddSensor(
            exu.SensorBody(
                bodyNumber=masses[k], outputVariableType=Variable.Position, storeInternal=True, writeToFile=False
            )
        )
    mbs.Assemble()
    return mbs, {"mass": masses[1], "spring": springs[2], "force": force}


@pytest.mark.parametrize("modified", [False, True], ids=["full", "modified"])
def test_mass_points_in_space(modified: bool) -> None:
    """Springs from slack to stiff: two to several iterations per step."""
    count = 13
    mbs, items = hanging_masses()
    varied = {
        (items["mass"], "physicsMass"): np.geomspace(0.05, 20, count),
        (items["spring"], "stiffness"): np.geomspace(1, 1e5, count),
        (items["spring"], "referenceLength"): np.linspace(0, 1, count),
        (items["force"], "loadVector"): np.column_stack([np.linspace(-5, 5, count), np.ones(count), np.zeros(count)]),
    }
    s = settings(0.3, 60)
    s.timeIntegration.newton.useModifiedNewton = modified
    results = mbs.SolveVariations(varied, s, storeHistories=True, storeCoordinates=True, numberOfThreads=1)
    wanted = []
    for k in range(count):
        other, items = hanging_masses()
        for (item, name), values in zip(
            [
                (items["mass"], "physicsMass"),
                (items["spring"], "stiffness"),
                (items["spring"], "referenceLength"),
            ],
            list(varied.values())[:3],
            strict=True,
        ):
            other.SetObjectParameter(item, name, values[k])
        other.SetLoadParameter(items["force"], "loadVector", list(varied.values())[3][k])
        wanted.append(alone(other, lambda other=other: other.SolveDynamic(s)))
    assert_equal(results, wanted)
    assert modified or results.sideBySide.all()


def test_points_that_coincide_are_solved_alone() -> None:
    """A spring whose ends lie on each other has no direction: the solver of a single system handles it."""
    mbs = exu.SystemContainer().AddSystem()
    mass = mbs.CreateMassPoint(physicsMass=1)
    mbs.CreateSpringDamper(bodyNumbers=[mbs.CreateGround(), mass], referenceLength=0.5, stiffness=10)
    mbs.Assemble()
    start = np.zeros((5, 3))
    start[:, 1] = [0.1, 0, 0.2, 0, 0.3]  # above the support, or in it, where nothing moves the mass
    s = settings(0.1, 20)
    results = mbs.SolveVariations({}, s, initialCoordinates={"ODE2": start}, storeCoordinates=True, numberOfThreads=1)
    assert results.success.all()
    np.testing.assert_array_equal(results.sideBySide, start[:, 1] != 0)
    for k in range(len(start)):
        mbs.systemData.SetODE2Coordinates(start[k], exu.ConfigurationType.Initial)
        mbs.SolveDynamic(s)
        np.testing.assert_array_equal(results.coordinates["ODE2"][k], mbs.systemData.GetODE2Coordinates())


def test_a_variation_that_fails_does_not_affect_others() -> None:
    """A coordinate is singular without mass, springs and dampers; a tolerance below round-off takes iterations."""
    count, singular, hasty, strict = 11, 2, 5, 7
    masses, stiffness = np.linspace(1, 2, count), np.full(count, 200.0)
    masses[singular] = 0
    iterations, tolerances = np.full(count, 25), np.full(count, 1e-13)
    iterations[hasty], tolerances[[hasty, strict]] = 2, 1e-25
    mbs = chain(4)
    mbs.SetObjectParameter(exu.ObjectIndex(7), "stiffness", 0)  # the last mass is free
    mbs.SetObjectParameter(exu.ObjectIndex(7), "damping", 0)
    s = settings()
    varied = {(exu.ObjectIndex(6), "physicsMass"): masses, (first_spring(), "stiffness"): stiffness}
    newton = "timeIntegration.newton"
    varied_settings = {
        f"{newton}.maxIterations": iterations,
        f"{newton}.relativeTolerance": tolerances,
        f"{newton}.absoluteTolerance": tolerances,
    }
    results = mbs.SolveVariations(
        varied,
        s,
        settings=varied_settings,
        storeCoordinates=True,
        numberOfThreads=1,
    )
    failed = np.isin(np.arange(count), [singular, hasty])
    np.testing.assert_array_equal(results.success, ~failed)
    np.testing.assert_array_equal(results.sideBySide, ~failed)
    assert "the system matrix is singular" in results.messages[singular]
    assert "Newton's method did not converge" in results.messages[hasty]
    good = {key: values[~failed] for key, values in varied.items()}
    without = mbs.SolveVariations(
        good,
        s,
        settings={name: values[~failed] for name, values in varied_settings.items()},
        storeCoordinates=True,
        numberOfThreads=1,
    )
    np.testing.assert_array_equal(results.sensorValues[~failed], without.sensorValues)
    np.testing.assert_array_equal(results.coordinates["ODE2_tt"][~failed], without.coordinates["ODE2_tt"])


def test_variations_with_other_operations_are_solved_alone() -> None:
    """An eccentric body has terms that others lack."""
    mbs, _, bodies, _ = crank(0.3)
    centres = np.zeros((10, 2))
    centres[3] = [0.01, -0.02]
    s = settings(0.05, 50)
    results = mbs.SolveVariations(
        {(bodies[1], "physicsCenterOfMass"): centres}, s, storeCoordinates=True, numberOfThreads=1
    )
    np.testing.assert_array_equal(results.sideBySide, centres[:, 0] == 0)
    for k in (0, 3):
        mbs.SetObjectParameter(bodies[1], "physicsCenterOfMass", centres[k])
        mbs.SolveDynamic(s)
        np.testing.assert_array_equal(results.coordinates["ODE2"][k], mbs.systemData.GetODE2Coordinates())
        np.testing.assert_array_equal(results.coordinates["AE"][k], mbs.systemData.GetAECoordinates())


def no_change(mbs: Any, s: Any) -> None:
    pass


def differences(mbs: Any, s: Any) -> None:
    s.timeIntegration.newton.numericalDifferentiation.forODE2 = True


def rod_in_space(mbs: Any, s: Any) -> None:
    ends = [mbs.CreateGround(), mbs.CreateMassPoint(referencePosition=[1, 0, 0], physicsMass=1)]
    mbs.CreateDistanceConstraint(bodyNumbers=ends, distance=1)
    mbs.Assemble()


def rigid_body(mbs: Any, s: Any) -> None:
    mbs.CreateRigidBody(inertia=InertiaCuboid(1000, [0.1, 0.1, 0.1]))
    mbs.Assemble()


@pytest.mark.parametrize(
    ("change", "masses", "count", "solver", "reason"),
    [
        (no_change, 6, 1, "GeneralizedAlpha", "no other variation is left for its thread"),
        (no_change, 33, 4, "GeneralizedAlpha", "the linear solver, or more than 32 unknowns"),
        (no_change, 6, 4, "ExplicitEuler", "the solver: only implicit ones of second order take steps side by side"),
        (differences, 6, 4, "GeneralizedAlpha", "derivatives by differences"),
        (rod_in_space, 6, 4, "GeneralizedAlpha", "ObjectConnectorDistance"),
        (rigid_body, 6, 4, "GeneralizedAlpha", "nodes that rotate in space"),
    ],
)
def test_obstacles_are_reported(change: Any, masses: int, count: int, solver: str, reason: str) -> None:
    mbs, s = chain(masses), settings(0.01, 10)
    change(mbs, s)
    varied = {(first_spring(), "stiffness"): np.linspace(100, 200, count)}
    results = mbs.SolveVariations(varied, s, solverType=exu.DynamicSolverType[solver], numberOfThreads=1)
    assert results.success.all() and results.alone == [reason] * count
    assert f"0 side by side (in the way: {reason})" in repr(results)
