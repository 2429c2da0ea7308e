"""Static solutions of closed loops whose iterations go to where no joints fit."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from solving import Variable, new_system
from test_redundant import NODES, ClosedChain, assert_smallest, redundancy

import dalembert as exu
from dalembert.rigidBodyUtilities import InertiaCuboid

STIFFNESS = 30.0  # N m / rad, of springs that hold the joints
GRAVITY, DENSITY, SECTION = [3, -9.81, 0], 1000.0, [0.1, 0.05]


def place_on_coupler(along: float) -> np.ndarray:
    """Positions from the angles of the bars in the plane: the path of equilibria along which the weight grows, in 400
    steps."""
    corners = np.array(corners_of_loop())[:, :2]
    bars = np.diff(corners, axis=0)
    lengths, start = np.linalg.norm(bars, axis=1), np.unwrap(np.arctan2(bars[:, 1], bars[:, 0]))
    masses = DENSITY * np.prod(SECTION) * lengths
    carried = masses / 2 + np.array([masses[1:].sum(), masses[2:].sum(), 0])  # derivative by the direction
    from_before = np.array([[1, 0, 0], [-1, 1, 0], [0, -1, 1]])  # springs resist turns against the bar before

    springs, unknowns = STIFFNESS * from_before.T @ from_before, np.zeros(5)  # turns, and forces at the last joint
    for share in np.linspace(0, 1, 401):
        for _ in range(20):
            turned, forces = unknowns[:3], unknowns[3:]
            ends = lengths[:, None] * np.stack([np.cos(start + turned), np.sin(start + turned)], axis=1)
            normals, weights = np.stack([-ends[:, 1], ends[:, 0]], axis=1), share * carried[:, None] * GRAVITY[:2]
            moments = springs @ turned - normals @ forces - np.sum(normals * weights, axis=1)
            residual = np.concatenate([moments, -(corners[0] + ends.sum(axis=0) - corners[-1])])
            stiffness = springs + np.diag(ends @ forces + np.sum(ends * weights, axis=1))
            unknowns -= np.linalg.solve(np.block([[stiffness, -normals], [-normals.T, np.zeros((2, 2))]]), residual)
            if np.abs(residual).max() < 1e-11:
                break
        assert np.abs(residual).max() < 1e-11
    angles = start + unknowns[:3]
    heading = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return np.array([*corners[0] + lengths[0] * heading[0] + (lengths[1] / 2 + along) * heading[1], 0])


def corners_of_loop() -> list[np.ndarray]:
    random = np.random.default_rng(3)
    angles, radii = np.sort(random.uniform(0, 2 * np.pi, 4)) + 0.3 * np.arange(4), random.uniform(0.6, 1.4, 4)
    return [np.array([r * np.cos(a), r * np.sin(a), 0]) for a, r in zip(angles, radii, strict=True)]


def soft_loop(node: Any, frees_three: bool) -> tuple[Any, Any]:
    """Three bars whose weight turns them far; the last joint states three equations that follow from others, or is free of them."""
    corners, mbs = corners_of_loop(), new_system()
    bodies = [mbs.CreateGround()]
    for start, end in zip(corners[:-1], corners[1:], strict=True):
        length = float(np.linalg.norm(end - start))
        along = (end - start) / length
        body = mbs.CreateRigidBody(
            referencePosition=(start + end) / 2,
            referenceRotationMatrix=np.column_stack([along, np.cross([0, 0, 1], along), [0, 0, 1]]),
            inertia=InertiaCuboid(DENSITY, [length, *SECTION]),
            gravity=GRAVITY,
            nodeType=node,
        )
        mbs.CreateGenericJoint(bodyNumbers=[body, bodies[-1]], position=start, constrainedAxes=[1, 1, 1, 1, 1, 0])
        mbs.CreateTorsionalSpringDamper(
            bodyNumbers=[bodies[-1], body], position=start, axis=[0, 0, 1], stiffness=STIFFNESS
        )
        bodies.append(body)
    axes = [1, 1, 0, 0, 0, 0] if frees_three else [1, 1, 1, 1, 1, 0]
    mbs.CreateGenericJoint(bodyNumbers=[bodies[-1], bodies[0]], position=corners[-1], constrainedAxes=axes)
    mbs.Assemble()
    return mbs, bodies[2]


@pytest.mark.parametrize("frees_three", [False, True], ids=["redundant", "regular"])
@pytest.mark.parametrize(
    "node", [exu.NodeType.RotationRotationVector, exu.NodeType.RotationRxyz, exu.NodeType.RotationEulerParameters]
)
def test_a_soft_loop_turns_far_in_one_load_step(node: Any, frees_three: bool) -> None:
    """If iterations of the full load diverge, smaller steps follow: joints that fitted before were said to contradict
    each other.

    All arrive at the end of the path along which the weight grows.
    """
    mbs, coupler = soft_loop(node, frees_three)
    s = exu.SimulationSettings()
    s.staticSolver.verboseMode = 0
    s.solutionSettings.writeSolutionToFile = False
    assert mbs.SolveStatic(s) is True
    place = mbs.GetObjectOutputBody(coupler, Variable.Position, [0.1, 0, 0])
    np.testing.assert_allclose(place, place_on_coupler(0.1), rtol=0, atol=1e-7)  # accuracy of static solutions


def held_chain(bars: int, seed: int, node: Any, unit: float = 1, freed: bool = False, apart: float = 0) -> ClosedChain:
    """A planar loop in space, solved under its weight: springs hold as many joints as there are motions; the last joint
    may have no redundant equations, or a gap (m)."""
    chain = ClosedChain(np.random.default_rng(1000 * bars + seed), bars, node, unit)
    mbs = chain.mbs

    def parameters(joint: Any) -> dict[str, Any]:
        names = ("markerNumbers", "rotationMarker0", "rotationMarker1")
        return {name: mbs.GetObject(joint)[name] for name in names}

    for joint in chain.joints[: bars - 2]:
        mbs.AddObject(exu.TorsionalSpringDamper(**parameters(joint), stiffness=3e4 * unit**2))
    first = mbs.GetObject(chain.joints[-1])["markerNumbers"][0]
    place = np.array(mbs.GetMarker(first)["localPosition"])
    mbs.SetMarkerParameter(first, "localPosition", place + apart * unit * np.array([0.3, 0.5, -0.6]))
    if freed:
        mbs.AddObject(exu.GenericJoint(**parameters(chain.joints[-1]), constrainedAxes=[1, 1, 0, 0, 0, 0]))
        mbs.SetObjectParameter(chain.joints[-1], "activeConnector", False)
    mbs.Assemble()
    s = exu.SimulationSettings()
    s.staticSolver.verboseMode = 0
    s.staticSolver.newton.relativeTolerance = 1e-10
    s.solutionSettings.writeSolutionToFile = False
    s.redundantConstraints.momentLength = unit
    assert mbs.SolveStatic(s) is True
    return chain


def places(chain: ClosedChain) -> np.ndarray:
    """Lengths of the bars, in m."""
    nodes = range(chain.mbs.systemData.NumberOfNodes())
    return np.array([chain.mbs.GetNodeOutput(node, Variable.Position) for node in nodes]) / chain.unit


def reactions(chain: ClosedChain) -> np.ndarray:
    """Forces in N and moments in N m."""
    forces, moments = (
        np.array([chain.mbs.GetObjectOutput(joint, of) for joint in chain.joints])
        for of in (Variable.ForceLocal, Variable.TorqueLocal)
    )
    return np.concatenate([forces / chain.unit, moments / chain.unit**2])


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("bars", [3, 4, 6])
@pytest.mark.parametrize("seed", [2, 6, 9])
def test_loops_on_springs_under_their_weight(seed: int, bars: int, node: Any) -> None:
    """If springs resist only some motions, the stiffness gave wrong numbers of redundant equations, and reactions of up
    to a thousand times the minimum-norm ones."""
    freed, redundant = held_chain(bars, seed, node, freed=True), held_chain(bars, seed, node)
    assert redundancy(redundant.mbs, "staticSolver")["count"] == 3
    np.testing.assert_allclose(places(redundant), places(freed), rtol=0, atol=1e-9)
    assert_smallest(redundant.mbs, 1.0)
    iterations = [model.mbs.sys["staticSolver"].it.newtonStepsCount for model in (redundant, freed)]
    assert iterations[0] <= iterations[1] + 2  # redundant equations do not slow Newton's method down
    in_mm = held_chain(bars, seed, node, 1e3)
    assert redundancy(in_mm.mbs, "staticSolver")["count"] == 3
    np.testing.assert_allclose(places(in_mm), places(freed), rtol=0, atol=1e-9)
    wanted = reactions(redundant)
    assert np.linalg.norm(reactions(in_mm) - wanted) < 1e-6 * np.linalg.norm(wanted)


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("unit", [1, 1e3], ids=["m", "mm"])
@pytest.mark.parametrize(("bars", "seed"), [(3, 2), (3, 9), (4, 1), (6, 2)])
@pytest.mark.parametrize("apart", [1e-7, 1e-6])
def test_loops_on_springs_that_hardly_fit(apart: float, bars: int, seed: int, unit: float, node: Any) -> None:
    """Contradictory joints move bars by the size of the gap; it went along the motion, by a thousand times as much."""
    freed, redundant = (held_chain(bars, seed, node, unit, freed, apart) for freed in (True, False))
    found = redundancy(redundant.mbs, "staticSolver")
    assert found["count"] == 3 and 0.001 * apart < found["misfit"] < apart
    np.testing.assert_allclose(places(redundant), places(freed), rtol=0, atol=2 * apart)
