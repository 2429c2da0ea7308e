"""Elements of one law, bodies and joints are computed side by side, up to as many as registers hold: results are those
of single evaluations."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from registers import each_width, numbers_in_registers, run_with_instructions

import dalembert as exu
from dalembert._core import testing
from dalembert.itemInterface import Cable2D, NodePoint2DSlope1, NodePointSlope1, ObjectANCFCable
from dalembert.rigidBodyUtilities import RigidBodyInertia

LAW = {
    "physicsLength": 0.5,
    "physicsMassPerLength": 2,
    "physicsBendingStiffness": 3,
    "physicsAxialStiffness": 1e4,
    "physicsBendingDamping": 0.4,
    "physicsAxialDamping": 5,
}
WEIGHTS = {"cq": 0.7, "cv": 1.3, "ca": 0.4}
ROUNDING = 1e-13  # relative to the largest entry: wide registers fuse products and sums


def cables(laws: list[dict[str, Any]], dimension: int = 2) -> exu.MainSystem:
    """Cables that are not connected, on nodes of their own."""
    mbs = exu.SystemContainer().AddSystem()
    node, cable = (NodePoint2DSlope1, Cable2D) if dimension == 2 else (NodePointSlope1, ObjectANCFCable)
    rest = [0.0] * (dimension - 1)
    for law in laws:
        nodes = [mbs.AddNode(node(referenceCoordinates=[x, *rest, 1, *rest])) for x in (0, law["physicsLength"])]
        mbs.AddObject(cable(nodeNumbers=nodes, **law))
    mbs.Assemble()
    return mbs


def equations(mbs: exu.MainSystem, q: Any, v: Any, a: Any) -> tuple[np.ndarray, np.ndarray]:
    state = testing.State(mbs)
    state.q, state.v, state.a = q.ravel(), v.ravel(), a.ravel()
    return testing.residual(mbs, state), testing.tangent(mbs, state, **WEIGHTS)


def difference(values: np.ndarray, others: np.ndarray) -> float:
    return float(np.abs(values - others).max() / np.abs(others).max())


@pytest.mark.parametrize("count", [2, 4, 7, 8, 11, 21], ids="{} elements".format)
@pytest.mark.parametrize("rule", [0, 1, 2], ids="rule {}".format)
@pytest.mark.parametrize("different", [None, 1], ids=["one law", "one of another law"])
@pytest.mark.parametrize("dimension", [2, 3], ids=["in the plane", "in space"])
def test_elements_side_by_side(count: int, rule: int, different: int | None, dimension: int) -> None:
    """Numbers move in fours; sizes of a spatial node are not a multiple."""
    n = 4 * dimension
    laws = [LAW | {"useReducedOrderIntegration": rule} for _ in range(count)]
    if different is not None:
        laws[different] |= {"physicsAxialStiffness": 2e4}
    q, v, a = np.random.default_rng(count).normal(scale=0.1, size=(3, count, n))
    residual, tangent = equations(cables(laws, dimension), q, v, a)
    for i, law in enumerate(laws):
        own = slice(n * i, n * i + n)
        alone = equations(cables([law], dimension), q[i], v[i], a[i])
        assert difference(residual[own], alone[0]) < ROUNDING
        assert difference(tangent[own, own], alone[1]) < ROUNDING
        assert np.abs(alone[0]).max() > 1


def test_a_law_that_changes() -> None:
    """One of four items gets another stiffness after assembly: it alone changes."""
    mbs = cables([LAW] * 4)
    q, v, a = np.random.default_rng(1).normal(scale=0.1, size=(3, 4, 8))
    before, _ = equations(mbs, q, v, a)
    mbs.SetObjectParameter(1, "physicsAxialStiffness", 3e4)
    after, _ = equations(mbs, q, v, a)
    changes = [difference(after[8 * i : 8 * i + 8], before[8 * i : 8 * i + 8]) for i in range(4)]
    assert changes.pop(1) > 0.1
    assert max(changes) < ROUNDING
    mbs.SetObjectParameter(1, "physicsAxialStiffness", LAW["physicsAxialStiffness"])
    assert np.array_equal(equations(mbs, q, v, a)[0], before)


def chain(count: int) -> exu.MainSystem:
    """Bodies of different masses, some of them eccentric, with joints of two types between them, one of which is off."""
    mbs = exu.SystemContainer().AddSystem()
    random = np.random.default_rng(count)
    previous = mbs.AddObject(exu.ObjectGround())
    for i in range(count):
        node = mbs.AddNode(exu.NodeRigidBodyEP(referenceCoordinates=[i, 0, 0, 1, 0, 0, 0]))
        inertia = RigidBodyInertia(
            mass=1 + i,
            inertiaTensor=random.uniform(1, 1.5) * np.eye(3) + 0.1 * np.outer(*[random.uniform(size=3)] * 2),
            com=random.normal(size=3) if i % 3 == 1 else np.zeros(3),
            inertiaTensorAtCOM=True,
        )
        body = mbs.AddObject(
            exu.ObjectRigidBody(
                physicsMass=inertia.Mass(),
                physicsInertia=inertia.GetInertia6D(),
                physicsCenterOfMass=inertia.COM(),
                nodeNumber=node,
            )
        )
        ends = [
            mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=b, localPosition=random.normal(size=3)))
            for b in (previous, body)
        ]
        joint = exu.ObjectJointRevoluteZ if i % 5 else exu.ObjectJointPrismaticX
        mbs.AddObject(joint(markerNumbers=ends, activeConnector=i != 3))
        mass = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
        mbs.AddLoad(exu.LoadMassProportional(markerNumber=mass, loadVector=[3, 1, -9]))
        previous = body
    mbs.Assemble()
    return mbs


def equations_of_chain(count: int) -> tuple[np.ndarray, np.ndarray]:
    mbs, random = chain(count), np.random.default_rng(count)
    state = testing.State(mbs)
    state.q, state.v, state.a = random.normal(scale=0.3, size=(3, 7 * count))
    state.lam = random.normal(size=6 * count)
    return testing.residual(mbs, state), testing.tangent(mbs, state, **WEIGHTS)


EQUATIONS = """
import numpy as np
from test_lanes import LAW, cables, equations, equations_of_chain
q, v, a = np.random.default_rng(1).normal(scale=0.1, size=(3, 15, 8))
w, u, b = np.random.default_rng(2).normal(scale=0.1, size=(3, 11, 12))
for parts in (equations(cables([LAW] * 15), q, v, a), equations(cables([LAW] * 11, 3), w, u, b), *(equations_of_chain(count) for count in (1, 2, 6, 9, 13))):
    for values in parts:
        print(*(value.hex() for value in values.ravel()))
"""


@each_width
def test_registers_do_not_change_results(wide: str) -> None:
    """Forces and derivatives are the same in registers of any width, but for rounding."""
    expected, values = (numbers_in_registers(EQUATIONS, name) for name in ("portable", wide))
    for some, others in zip(values, expected, strict=True):
        assert difference(some, others) < ROUNDING
    sizes = [120, 132, *(13 * count for count in (1, 2, 6, 9, 13))]
    assert [some.size for some in values] == [n for size in sizes for n in (size, size**2)]


def test_unknown_instructions_are_refused() -> None:
    run = run_with_instructions(EQUATIONS, "sse9")
    assert run.returncode != 0
    assert "DALEMBERT_INSTRUCTIONS: received 'sse9'; expected portable, avx2 or avx512" in run.stderr
