"""Threads share the evaluation of large systems; nothing of it shows in results."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pytest

import dalembert as exu

STIFFNESS, DAMPING, MASS = 4e4, 3.0, 0.05
SIDE = 64  # points: 12 288 coordinates, four regions


def settings(threads: int, steps: int = 4) -> exu.SimulationSettings:
    s = exu.SimulationSettings()
    s.timeIntegration.numberOfSteps, s.timeIntegration.endTime = steps, 1e-4 * steps
    s.timeIntegration.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    s.linearSolverType = exu.LinearSolverType.EigenSparse
    s.parallel.numberOfThreads = threads
    return s


def net(order: Any = None) -> tuple[exu.MainSystem, list[Any], list[Any]]:
    """Points on a square, tied to their neighbours and thrown upwards in the middle; `order`: in which they are added."""
    mbs = exu.SystemContainer().AddSystem()
    points: list[Any] = [None] * SIDE**2
    for k in order if order is not None else range(SIDE**2):
        i, j = divmod(int(k), SIDE)
        speed = 3.0 if abs(i - SIDE / 2) < 5 and abs(j - SIDE / 2) < 5 else 0.0
        node = mbs.AddNode(exu.NodePoint(referenceCoordinates=[i, j, 0], initialVelocities=[0, 0, speed]))
        mbs.AddObject(exu.ObjectMassPoint(nodeNumber=node, physicsMass=MASS))
        points[k] = mbs.AddMarker(exu.MarkerNodePosition(nodeNumber=node))
    springs = []
    for i in range(SIDE):
        for j in range(SIDE):
            for other in ((i + 1, j), (i, j + 1)):
                if max(other) == SIDE:
                    continue
                markers = [points[i * SIDE + j], points[other[0] * SIDE + other[1]]]
                springs.append(
                    mbs.AddObject(
                        exu.ObjectConnectorSpringDamper(
                            markerNumbers=markers, referenceLength=0.98, stiffness=STIFFNESS, damping=DAMPING
                        )
                    )
                )
    return mbs, points, springs


def chain(bodies: int = 1000) -> exu.MainSystem:
    """Rigid bodies on Euler parameters, hinged to each other: 7000 coordinates, two regions."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddObject(exu.ObjectGround())
    last = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=ground))
    for i in range(bodies):
        node = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[i + 0.5, 0, 0, 1, 0, 0, 0]))
        body = mbs.AddObject(
            exu.ObjectRigidBody(nodeNumber=node, physicsMass=1, physicsInertia=[0.1, 0.2, 0.2, 0, 0, 0])
        )
        ends = [mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=body, localPosition=[x, 0, 0])) for x in (-0.5, 0.5)]
        mbs.AddObject(exu.ObjectJointRevoluteZ(markerNumbers=[last, ends[0]]))
        mbs.AddLoad(
            exu.LoadMassProportional(
                markerNumber=mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body)), loadVector=[0, -9.81, 0]
            )
        )
        last = ends[1]
    return mbs


CORES = len(os.sched_getaffinity(0))


def solved(mbs: exu.MainSystem, threads: int, solver: Any) -> np.ndarray:
    """Skips the test where so many threads cannot run side by side: a solver takes as many as there are cores at most."""
    if threads > CORES:
        pytest.skip(f"{threads} threads need as many cores, here are {CORES}: nothing is compared")
    mbs.Assemble()
    mbs.SolveDynamic(settings(threads), solverType=solver)
    system = mbs.systemData
    return np.concatenate([system.GetODE2Coordinates(), system.GetODE2Coordinates_t(), system.GetAECoordinates()])


@pytest.mark.parametrize("threads", [2, 4])
@pytest.mark.parametrize("solver", ["RK44", "VelocityVerlet", "GeneralizedAlpha"])
def test_nets_move_alike_with_any_number_of_threads(solver: str, threads: int) -> None:
    kind = getattr(exu.DynamicSolverType, solver)
    shared = solved(net()[0], threads, kind)
    alone = solved(net()[0], 1, kind)
    np.testing.assert_array_equal(shared, alone)
    assert np.abs(alone[: 3 * SIDE**2]).max() > 1e-4  # it moves


def test_chains_move_alike_with_any_number_of_threads() -> None:
    kind = exu.DynamicSolverType.GeneralizedAlpha
    np.testing.assert_array_equal(solved(chain(), 2, kind), solved(chain(), 1, kind))


def test_the_order_of_nodes_does_not_matter() -> None:
    """Neighbours far apart in the numbering: most springs lie across regions. Sums have another order: round-off."""
    order = np.random.default_rng(1).permutation(SIDE**2)
    kind = exu.DynamicSolverType.VelocityVerlet
    mixed, straight = solved(net(order)[0], 2, kind), solved(net()[0], 1, kind)
    n = 3 * SIDE**2
    for part in (slice(0, n), slice(n, 2 * n)):
        one = mixed[part].reshape(-1, 3)
        other = straight[part].reshape(-1, 3)[order]
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-12 * max(1, np.abs(other).max()))


@pytest.mark.parametrize(("bodies", "used"), [(1000, 2), (50, 1)])
def test_solvers_report_the_number_of_threads(bodies: int, used: int) -> None:
    mbs = chain(bodies)
    mbs.Assemble()
    solver = exu.MainSolverImplicitSecondOrder()
    solver.SolveSystem(mbs, settings(8, steps=1))
    assert solver.output.numberOfThreadsUsed == min(used, CORES)


def test_functions_of_the_user_are_called_by_the_thread_of_the_solver() -> None:
    """Also those that come after Assemble, to an item inside of a region."""

    def pull(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, f: float) -> float:
        return k * u + d * v

    kind = exu.DynamicSolverType.VelocityVerlet
    built_in = solved(net()[0], 1, kind)
    mbs, _, springs = net()
    mbs.Assemble()
    for spring in springs[:: len(springs) // 7]:
        mbs.SetObjectParameter(spring, "springForceUserFunction", pull)
    mbs.SolveDynamic(settings(2), solverType=kind)
    n = 3 * SIDE**2
    # The same force but for the order of its products.
    np.testing.assert_allclose(mbs.systemData.GetODE2Coordinates(), built_in[:n], rtol=0, atol=1e-13)


def test_errors_of_the_user_pass_through() -> None:
    def broken(*_: Any) -> float:
        raise ZeroDivisionError("no force today")

    mbs, _, springs = net()
    mbs.SetObjectParameter(springs[5], "springForceUserFunction", broken)
    mbs.Assemble()
    with pytest.raises(ZeroDivisionError, match="no force today"):
        mbs.SolveDynamic(settings(2), solverType=exu.DynamicSolverType.RK44)
    mbs.SetObjectParameter(springs[5], "springForceUserFunction", 0)
    mbs.SolveDynamic(settings(2), solverType=exu.DynamicSolverType.RK44)
