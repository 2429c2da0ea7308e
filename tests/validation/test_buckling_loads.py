"""mbs.ComputeBucklingLoads against closed forms and against solutions of the differential equations of the rod."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from rods import Rod, section
from test_right_angle_frame import argyris_frame

import dalembert as exu

LENGTH, AXIAL, SHEAR, SOFT, STIFF = 2.0, 1e7, 4e6, 3.0, 5.0


def column(elements: int, pinned: bool = False, push: float = 1.0, times: int = 1, **nodes: Any) -> Rod:
    """`times`: joints that say the same."""
    rod = Rod(**nodes)
    chain = rod.add_leg(np.zeros(3), np.eye(3), LENGTH, elements, section([AXIAL, SHEAR, SHEAR, 1, SOFT, STIFF]))
    for _ in range(times):
        if pinned:
            rod.join(rod.ground, rod.marker(chain[0]), np.eye(3), (1, 1, 1, 1, 0, 0))
            rod.join(rod.ground, rod.marker(chain[-1]), np.eye(3), (0, 1, 1, 0, 0, 0))
        else:
            rod.clamp()
    rod.load(chain[-1], exu.Force, [-push, 0, 0])
    rod.mbs.Assemble()
    return rod


@pytest.mark.parametrize("node", [exu.NodeRigidBodyRotVecLG, exu.NodeRigidBodyEP])
@pytest.mark.parametrize(("pinned", "halves"), [(False, (1, 1, 3)), (True, (2, 2, 4))])
def test_columns_of_euler(node: type, pinned: bool, halves: tuple[int, ...]) -> None:
    """Clamped and free, or pinned, in both planes: quarters of waves and EI make the loads, of 1 N; errors are of second order."""
    bending = (SOFT, STIFF, SOFT)
    wanted = np.sort([b * (q * np.pi / (2 * LENGTH)) ** 2 for q, b in zip(halves, bending, strict=True)])
    coarse, fine = (column(n, pinned, node=node).mbs.ComputeBucklingLoads(3) for n in (8, 16))
    assert np.log2((coarse.factors / wanted - 1) / (fine.factors / wanted - 1)) == pytest.approx([2, 2, 2], abs=0.1)
    assert (4 * fine.factors - coarse.factors) / 3 == pytest.approx(wanted, rel=1e-3)
    assert fine.displacements[-7 if node is exu.NodeRigidBodyEP else -6] == pytest.approx(-LENGTH / AXIAL)
    assert np.abs(fine.modes).max(axis=0) == pytest.approx(np.ones(3))


def test_large_columns() -> None:
    """Computed by an iteration that finds a few eigenvalues."""
    small, large = (column(n).mbs.ComputeBucklingLoads(2).factors for n in (16, 96))
    wanted = np.array([SOFT, STIFF]) * (np.pi / (2 * LENGTH)) ** 2
    assert np.abs(large / wanted - 1) == pytest.approx(np.abs(small / wanted - 1) / 36, rel=0.05)


@pytest.mark.parametrize("node", [exu.NodeRigidBodyRotVecLG, exu.NodeRigidBodyEP])
@pytest.mark.parametrize("pinned", [False, True])
@pytest.mark.parametrize("elements", [6, 60])
def test_redundant_joints_change_nothing(elements: int, pinned: bool, node: type) -> None:
    """Their matrix, which is singular, was refused. Steps for differences are those of loads, and multipliers among them others."""
    once, twice, thrice = (column(elements, pinned, times=t, node=node).mbs.ComputeBucklingLoads(2) for t in (1, 2, 3))
    for found in (twice, thrice):
        assert found.factors == pytest.approx(once.factors, rel=1e-6)
        assert found.displacements == pytest.approx(once.displacements, abs=1e-9 * np.abs(once.displacements).max())


def test_load_scales() -> None:
    pushed, pulled = (column(6, push=p).mbs.ComputeBucklingLoads().factors for p in (1.0, -5.0))
    assert pulled == pytest.approx(-pushed / 5, rel=1e-6)


def test_frame_of_argyris() -> None:
    """1.0875 N and, turned around, 0.6804 N: bifurcations from the bent state in the plane of the frame."""
    told = []
    for elements in (8, 16):
        rod, _, tip = argyris_frame(elements, exu.NodeRigidBodyRotVecLG)
        rod.load(tip, exu.Force, [1, 0, 0])
        rod.mbs.Assemble()
        told.append(rod.mbs.ComputeBucklingLoads(2).factors)
    assert (4 * told[1] - told[0]) / 3 == pytest.approx([-0.680427409360, 1.087517937764], rel=1e-3)


def test_refused() -> None:
    rod = column(3, push=0.0)
    with pytest.raises(exu.SolverError, match="no load acts in the initial state"):
        rod.mbs.ComputeBucklingLoads()
    with pytest.raises(ValueError, match="numberOfLoads: expected a positive number, received 0"):
        rod.mbs.ComputeBucklingLoads(0)
    free = Rod()
    nodes = free.add_leg(np.zeros(3), np.eye(3), 1.0, 2, section([1, 1, 1, 1, 1, 1]))
    free.load(nodes[-1], exu.Force, [1, 0, 0])
    free.mbs.Assemble()
    with pytest.raises(exu.SolverError, match="singular"):
        free.mbs.ComputeBucklingLoads()
