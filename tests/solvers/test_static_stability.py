"""Stable and unstable static equilibria, against stiffness and buckling loads in closed form."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest

import dalembert as exu
import dalembert.itemInterface as items
from dalembert.beams import GenerateStraightBeam
from dalembert.rigidBodyUtilities import InertiaCuboid

UNSTABLE = "the equilibrium is unstable"
NODES = [
    exu.NodeType.RotationEulerParameters,
    exu.NodeType.RotationRxyz,
    exu.NodeType.RotationRotationVector,
]


def unstable_directions(mbs: exu.MainSystem, capfd: Any, linear_solver: Any = exu.LinearSolverType.EXUdense) -> int:
    """How many directions the warning of SolveStatic counts; 0 without it."""
    mbs.Assemble()
    s = exu.SimulationSettings()
    s.linearSolverType = linear_solver
    s.solutionSettings.writeSolutionToFile = False
    capfd.readouterr()
    assert mbs.SolveStatic(s)
    found = re.findall(rf"{UNSTABLE}: the smallest disturbance leaves it in (\d+) direction", capfd.readouterr().out)
    assert len(found) <= 1
    return int(found[0]) if found else 0


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize(("share", "expected"), [(1.001, 0), (0.999, 1), (1e-3, 1), (-1e-3, 0)])
def test_a_pendulum_upright(node: Any, share: float, expected: int, capfd: Any) -> None:
    """A spring of `share` times m g l at the hinge makes the upright position stable or not; it hangs if this is
    negative."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    inertia = InertiaCuboid(1000, [0.1, 1, 0.1])
    up = -1 if share < 0 else 1
    body = mbs.CreateRigidBody(
        inertia=inertia, referencePosition=[0, 0.5 * up, 0], gravity=[0, -9.81, 0], nodeType=node
    )
    mbs.CreateRevoluteJoint(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1])
    stiffness = abs(share) * inertia.Mass() * 9.81 * 0.5
    mbs.CreateTorsionalSpringDamper(bodyNumbers=[ground, body], position=[0, 0, 0], axis=[0, 0, 1], stiffness=stiffness)
    assert unstable_directions(mbs, capfd) == expected


@pytest.mark.parametrize("doubled", [False, True])
@pytest.mark.parametrize("up", [1, -1])
def test_a_chain_of_masses(up: int, doubled: bool, capfd: Any) -> None:
    """Upright, each of five rods falls in two directions; hanging, none does. Rods that are there twice change nothing.

    Weak springs across make the first matrix of Newton's method regular, which does not have the forces of the rods.
    """
    mbs = exu.SystemContainer().AddSystem()
    last = ground = mbs.CreateGround()
    for k in range(1, 6):
        mass = mbs.CreateMassPoint(referencePosition=[0, 0, 0.2 * k * up], physicsMass=k, gravity=[0, 0, -9.81])
        for _ in range(1 + doubled):
            mbs.CreateDistanceConstraint(bodyNumbers=[last, mass], distance=0.2)
        mbs.CreateCartesianSpringDamper(
            bodyNumbers=[ground, mass], localPosition0=[0, 0, 0.2 * k * up], stiffness=[1e-3, 1e-3, 0]
        )
        last = mass
    assert unstable_directions(mbs, capfd) == (10 if up == 1 else 0)


@pytest.mark.parametrize(("share", "expected"), [(0.99, 0), (1.01, 1), (4.2, 2)])
def test_a_column_of_beams(share: float, expected: int, capfd: Any) -> None:
    """A column on hinges buckles in one more mode beyond each k^2 Euler loads; 24 elements find these within 0.2 percent."""
    length, E, side = 2.0, 2e11, 0.01
    inertia, count = side**4 / 12, 24
    load = share * np.pi**2 * E * inertia / length**2
    mbs = exu.SystemContainer().AddSystem()
    beam = GenerateStraightBeam(
        mbs,
        positionOfNode0=[0, 0, 0],
        positionOfNode1=[length, 0, 0],
        numberOfElements=count,
        beamTemplate=items.Cable2D(
            physicsMassPerLength=1, physicsBendingStiffness=E * inertia, physicsAxialStiffness=E * side**2
        ),
        gravity=[0, 0, 0],
        fixedConstraintsNode0=[1, 1, 0, 0],
        fixedConstraintsNode1=[0, 1, 0, 0],
    )
    end = mbs.AddMarker(items.MarkerNodePosition(nodeNumber=beam[0][-1]))
    mbs.AddLoad(items.Force(markerNumber=end, loadVector=[-load, 0, 0]))
    assert unstable_directions(mbs, capfd) == expected


def test_a_cable_that_is_too_short_for_its_length(capfd: Any) -> None:
    """Links of springs between supports, compressed by 1 percent: straight, all inner masses of the plane want to leave."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    n = 9
    masses = [mbs.CreateMassPoint(referencePosition=[k, 0, 0], physicsMass=1, create2D=True) for k in range(1, n + 1)]
    for k, pair in enumerate(zip([ground, *masses], [*masses, ground], strict=True)):
        ends = {"localPosition1": [n + 1, 0, 0]} if k == n else {}
        mbs.CreateSpringDamper(bodyNumbers=list(pair), stiffness=1e6, referenceLength=1.01, **ends)
    assert unstable_directions(mbs, capfd) == n


def spring_network(seed: int, compression: float, count: int) -> tuple[exu.MainSystem, int]:
    """Masses at random places, joined by prestressed springs and linear constraints, in balance by constant loads.

    Returns the system, and how many eigenvalues of its stiffness are negative in the null space of the constraints.
    """
    rng = np.random.default_rng(seed)
    places, n = rng.uniform(-1, 1, (count, 3)), 3 * count
    mbs = exu.SystemContainer().AddSystem()
    masses = [mbs.CreateMassPoint(referencePosition=list(p), physicsMass=1) for p in places]
    K, balance = np.zeros((n, n)), np.zeros((count, 3))

    def spring(i: int, j: int | None, anchor: Any = ()) -> None:
        difference = places[i] - (np.array(anchor) if j is None else places[j])
        length, stiffness = float(np.linalg.norm(difference)), rng.uniform(50, 200)
        rest = length * (1 + compression * rng.uniform(-0.2, 1))
        u = difference / length
        block = stiffness * ((1 - rest / length) * (np.eye(3) - np.outer(u, u)) + np.outer(u, u))
        force = stiffness * (length - rest) * u
        a = slice(3 * i, 3 * i + 3)
        K[a, a] += block
        balance[i] += force
        if j is not None:
            b = slice(3 * j, 3 * j + 3)
            K[b, b] += block
            K[a, b] -= block
            K[b, a] -= block
            balance[j] -= force
        mbs.CreateSpringDamper(
            bodyNumbers=[ground if j is None else masses[j], masses[i]],
            localPosition0=list(anchor) or [0, 0, 0],
            stiffness=stiffness,
            referenceLength=rest,
        )

    ground = mbs.CreateGround()
    for i in range(count):
        for anchor in ([2, 0, 0], [0, 2, 0], [0, 0, 2]):
            spring(i, None, anchor)
        for j in rng.choice(count, 3, replace=False):
            if j != i:
                spring(i, int(j))
    rows = []
    for _ in range(count // 3):
        i, j = rng.choice(count, 2, replace=False)
        c, d = rng.integers(0, 3, 2)
        row = np.zeros(n)
        row[3 * i + c], row[3 * j + d] = -1, 1
        if np.linalg.matrix_rank([*rows, row]) > len(rows):
            rows.append(row)
            mbs.CreateCoordinateConstraint(bodyNumbers=[masses[i], masses[j]], coordinates=[int(c), int(d)])
    for mass, force in zip(masses, balance, strict=True):
        mbs.CreateForce(bodyNumber=mass, loadVector=list(force))
    free = np.linalg.svd(np.array(rows))[2][len(rows) :].T
    values = np.linalg.eigvalsh(free.T @ K @ free)
    assert np.abs(values).min() > 1e-4 * np.abs(values).max()
    return mbs, int((values < 0).sum())


@pytest.mark.parametrize("solver", [exu.LinearSolverType.EXUdense, exu.LinearSolverType.EigenSparse])
@pytest.mark.parametrize("count", [6, 14, 40])
def test_networks_of_prestressed_springs(count: int, solver: Any, capfd: Any) -> None:
    """With more and more compression, as many directions are unstable as eigenvalues of the stiffness are negative."""
    counted = []
    for seed, compression in enumerate([0.0, 0.2, 0.5, 1.0, 1.5, 2.0, 3.0]):
        mbs, expected = spring_network(seed, compression, count)
        assert unstable_directions(mbs, capfd, solver) == expected
        counted.append(expected)
    assert min(counted) == 0 < max(counted)


def test_paths_report_singular_points_instead(capfd: Any) -> None:
    """A path by arc length that ends beyond the limit point of a shallow truss, at a tenth of the load upwards."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.CreateGround()
    top = mbs.CreateMassPoint(referencePosition=[1, 0.3, 0], physicsMass=1, create2D=True)
    mbs.CreateCoordinateConstraint(bodyNumbers=[None, top], coordinates=[None, 0])
    mbs.CreateSpringDamper(bodyNumbers=[ground, top], stiffness=1000, referenceLength=np.hypot(1, 0.3))
    mbs.CreateForce(bodyNumber=top, loadVector=[0, -40, 0])
    mbs.Assemble()
    s = exu.SimulationSettings()
    s.solutionSettings.writeSolutionToFile = False
    s.staticSolver.numberOfLoadSteps = 20
    s.staticSolver.arcLength.active = True
    s.staticSolver.arcLength.lowestLoadFactor = -0.1
    mbs.SolveStatic(s)
    assert UNSTABLE not in capfd.readouterr().out
    assert mbs.GetNodeOutput(0, exu.OutputVariableType.Position)[1] < 0  # between the two stable positions
