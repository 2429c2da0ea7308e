"""Elements of one law are computed side by side: each gets to the last bit what it gets alone."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.itemInterface import Cable2D, NodePoint2DSlope1

LAW = {
    "physicsLength": 0.5,
    "physicsMassPerLength": 2,
    "physicsBendingStiffness": 3,
    "physicsAxialStiffness": 1e4,
    "physicsBendingDamping": 0.4,
    "physicsAxialDamping": 5,
}
WEIGHTS = {"cq": 0.7, "cv": 1.3, "ca": 0.4}


def cables(laws: list[dict[str, Any]]) -> exu.MainSystem:
    """Cables that are not connected, on nodes of their own."""
    mbs = exu.SystemContainer().AddSystem()
    for law in laws:
        nodes = [mbs.AddNode(NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, law["physicsLength"])]
        mbs.AddObject(Cable2D(nodeNumbers=nodes, **law))
    mbs.Assemble()
    return mbs


def equations(mbs: exu.MainSystem, q: Any, v: Any, a: Any) -> tuple[np.ndarray, np.ndarray]:
    state = testing.State(mbs)
    state.q, state.v, state.a = q.ravel(), v.ravel(), a.ravel()
    return testing.residual(mbs, state), testing.tangent(mbs, state, **WEIGHTS)


@pytest.mark.parametrize("count", [4, 7, 8], ids="{} elements".format)
@pytest.mark.parametrize("rule", [0, 1, 2], ids="rule {}".format)
@pytest.mark.parametrize("different", [None, 2], ids=["one law", "one of another law"])
def test_elements_side_by_side(count: int, rule: int, different: int | None) -> None:
    laws = [LAW | {"useReducedOrderIntegration": rule} for _ in range(count)]
    if different is not None:
        laws[different] |= {"physicsAxialStiffness": 2e4}
    q, v, a = np.random.default_rng(count).normal(scale=0.1, size=(3, count, 8))
    residual, tangent = equations(cables(laws), q, v, a)
    for i, law in enumerate(laws):
        own = slice(8 * i, 8 * i + 8)
        alone = equations(cables([law]), q[i], v[i], a[i])
        assert np.array_equal(residual[own], alone[0])
        assert np.array_equal(tangent[own, own], alone[1])
        assert np.abs(alone[0]).max() > 1


def test_a_law_that_changes() -> None:
    """One of four gets another stiffness after assembly: it alone changes."""
    mbs = cables([LAW] * 4)
    q, v, a = np.random.default_rng(1).normal(scale=0.1, size=(3, 4, 8))
    before, _ = equations(mbs, q, v, a)
    mbs.SetObjectParameter(1, "physicsAxialStiffness", 3e4)
    after, _ = equations(mbs, q, v, a)
    changed = before != after
    assert changed[8:16].any()
    assert not changed[:8].any()
    assert not changed[16:].any()
    mbs.SetObjectParameter(1, "physicsAxialStiffness", LAW["physicsAxialStiffness"])
    assert np.array_equal(equations(mbs, q, v, a)[0], before)


EQUATIONS_OF_CABLES = """
import numpy as np
from test_lanes import LAW, cables, equations
q, v, a = np.random.default_rng(1).normal(scale=0.1, size=(3, 8, 8))
for values in equations(cables([LAW] * 8), q, v, a):
    print(values.tobytes().hex())
"""


def run_with_instructions(name: str) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"DALEMBERT_INSTRUCTIONS": name, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))}
    return subprocess.run([sys.executable, "-c", EQUATIONS_OF_CABLES], capture_output=True, text=True, env=environment)


def test_registers_do_not_change_results() -> None:
    """Forces and masses of the elements are the same in registers of any width."""
    results = {run_with_instructions(name).stdout for name in ("portable", "avx2")}
    assert len(results) == 1
    assert len(results.pop()) > 16 * 64 * 65


def test_unknown_instructions_are_refused() -> None:
    run = run_with_instructions("sse9")
    assert run.returncode != 0
    assert "DALEMBERT_INSTRUCTIONS: received 'sse9'; expected portable, avx2 or avx512" in run.stderr
