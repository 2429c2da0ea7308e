"""ESDIRK43: order, joints, rotations, stiffness, tolerances, and forces that change between steps."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from bricard_reference import third_corners
from governor_reference import heights_of_slider
from solving import Solver, Variable, new_system, orders, self_orders, settings
from test_andrews import END, Squeezer, angles
from test_bricard import Bricard
from test_explicit_joints import carried_mass, largest_gap, tolerances
from test_four_bar import Bars
from test_governor import Governor
from test_orders import ROTATING, elastic_pendulum, exact, final, tumbling

import dalembert as exu

METHOD = Solver.ESDIRK43


def equal_steps(end: float, steps: int) -> Any:
    s = settings(end, steps, tolerance=1e-13)
    s.timeIntegration.automaticStepSize = False
    return s


def statistics(mbs: Any) -> Any:
    return mbs.sys["dynamicSolver"].it


@pytest.mark.parametrize("damping", [0.0, 3.0])
def test_order(damping: float) -> None:
    def result(n: int) -> np.ndarray:
        mbs, node = elastic_pendulum(damping)
        mbs.SolveDynamic(equal_steps(1.0, n), solverType=METHOD)
        return final(mbs, node)

    if damping:
        assert self_orders(result, 25) == pytest.approx(4, abs=0.3)
    else:
        for observed in orders(lambda n: result(n) - exact(), [25, 50, 100]):
            assert observed == pytest.approx(4, abs=0.3)


@pytest.mark.parametrize("node_type", ROTATING)
def test_order_with_rotations(node_type: str) -> None:
    def result(n: int) -> np.ndarray:
        mbs, body = tumbling(node_type)
        mbs.SolveDynamic(equal_steps(0.5, n), solverType=METHOD)
        outputs = (Variable.Position, Variable.RotationMatrix, Variable.AngularVelocity)
        return np.concatenate([mbs.GetObjectOutputBody(body, v, [0, 0, 0]) for v in outputs])

    assert self_orders(result, 20) == pytest.approx(4, abs=0.4)


@pytest.mark.parametrize("freed", [{}, {5: 0}], ids=["redundant", "regular"])
def test_order_with_joints(freed: dict[int, int]) -> None:
    def error(n: int) -> np.ndarray:
        bricard = Bricard(freed)
        bricard.mbs.SolveDynamic(equal_steps(1.0, n), solverType=METHOD)
        assert largest_gap(bricard.mbs) < 1e-11
        assert bricard.mbs.sys["dynamicSolver"].GetRedundantConstraints()["count"] == (0 if freed else 1)
        return bricard.third_corner() - third_corners()[1.0]

    (observed,) = orders(error, [25, 100])
    assert observed == pytest.approx(4, abs=0.4)


def test_first_order_equations() -> None:
    """x' = -x + 4 y, y' = -4 x - y: a spiral."""

    def error(n: int) -> np.ndarray:
        mbs = new_system()
        node = mbs.AddNode(
            exu.NodeGenericODE1(referenceCoordinates=[0, 0], initialCoordinates=[1, 0], numberOfODE1Coordinates=2)
        )
        mbs.AddObject(exu.ObjectGenericODE1(nodeNumbers=[node], systemMatrix=[[-1, 4], [-4, -1]]))
        mbs.Assemble()
        mbs.SolveDynamic(equal_steps(1.0, n), solverType=METHOD)
        return mbs.systemData.GetODE1Coordinates() - np.exp(-1) * np.array([np.cos(4), -np.sin(4)])

    for observed in orders(error, [20, 40, 80]):
        assert observed == pytest.approx(4, abs=0.2)


def test_the_squeezer_follows_tolerances() -> None:
    """Its motion amplifies errors: a hundredfold for DOPRI5 in 30 ms, more where steps are fewer."""
    counts = []
    for tolerance in (1e-5, 1e-7):
        squeezer = Squeezer()
        squeezer.mbs.SolveDynamic(tolerances(0.03, tolerance, 5), solverType=METHOD)
        error = np.abs(squeezer.angles() - angles(END)).max()
        assert tolerance < error < 1000 * tolerance
        assert largest_gap(squeezer.mbs) < 1e-12
        counts.append(statistics(squeezer.mbs).currentStepIndex)
    assert counts[1] / counts[0] == pytest.approx(100**0.25, rel=0.3)  # the estimate is of fourth order in a step


@pytest.mark.parametrize("node_type", ["NodeRigidBodyEP", "NodeRigidBodyRotVecLG"])
def test_the_governor_with_few_factorizations(node_type: str) -> None:
    """Acceptance number P6: stiff springs with dampers, whose modes vanish in microseconds."""
    governor = Governor(node_type)
    governor.mbs.SolveDynamic(tolerances(2, 1e-8, 20), solverType=METHOD)
    assert 1e-12 < abs(governor.height() - heights_of_slider()[2.0]) < 1e-6
    assert statistics(governor.mbs).newtonJacobiCount <= 200


@pytest.mark.parametrize("stiffness", [1e4, 1e8])
def test_steps_do_not_feel_stiffness_that_has_died(stiffness: float) -> None:
    """A slow swing on a rod that is a stiff spring with a damper: steps are those of the swing."""
    mbs = new_system()
    ground, bob = (
        mbs.CreateGround(),
        mbs.CreateMassPoint(physicsMass=1, referencePosition=[1, 0, 0], gravity=[0, -1, 0]),
    )
    mbs.CreateSpringDamper(bodyNumbers=[ground, bob], stiffness=stiffness, damping=2 * np.sqrt(stiffness))
    mbs.Assemble()
    mbs.SolveDynamic(tolerances(2, 1e-6, 10), solverType=METHOD)
    position = mbs.GetNodeOutput(0, Variable.Position)
    assert 10 < statistics(mbs).currentStepIndex < 250  # explicit methods: some 3e3 and 3e5
    assert np.linalg.norm(position) == pytest.approx(1 + 3 * -position[1] / stiffness, abs=0.3 / stiffness + 1e-6)


@pytest.mark.parametrize(
    ("mechanism", "tolerance"),
    [(lambda: Bars(1), 1e-6), (lambda: Bricard({}), 1e-7), (lambda: Bricard({5: 0}), 1e-7)],
    ids=["four-bar linkage", "Bricard, redundant", "Bricard, regular"],
)
def test_small_steps_hold_the_tolerance_as_well(mechanism: Any, tolerance: float) -> None:
    """If output limits steps, most of them need one iteration, which gives no information on an older matrix: errors
    were up to 36 times the
    tolerance, and grew with the number of steps."""

    def end(tolerance: float) -> np.ndarray:
        mbs = mechanism().mbs
        mbs.SolveDynamic(tolerances(0.5, tolerance, 500), solverType=METHOD)
        return np.asarray(mbs.systemData.GetODE2Coordinates())

    assert np.abs(end(tolerance) - end(1e-11)).max() < 2 * tolerance


def test_a_driven_constraint() -> None:
    mbs, node = carried_mass()
    mbs.SolveDynamic(equal_steps(1, 50), solverType=METHOD)
    assert mbs.GetNodeOutput(node, Variable.Position)[0] == pytest.approx(0.5 * np.sin(3), abs=1e-9)
    assert abs(mbs.systemData.GetAECoordinates()[0]) == pytest.approx(9 * np.sin(3), abs=1e-5)


def test_loads_that_change_between_steps() -> None:
    """A force that PreStep sets for each step: accelerations at its start are those of the new force."""
    mbs = new_system()
    node = mbs.AddNode(exu.NodePoint2D(referenceCoordinates=[0, 0]))
    mass = mbs.AddObject(exu.MassPoint2D(nodeNumber=node, physicsMass=2.0))
    marker = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mass))
    load = mbs.AddLoad(exu.Force(markerNumber=marker, loadVector=[0, 0, 0]))
    forces: list[float] = []

    def pre_step(mbs: Any, t: float) -> bool:
        forces.append(len(forces) % 3 - 0.7)
        mbs.SetLoadParameter(load, "loadVector", [forces[-1], 0, 0])
        return True

    mbs.SetPreStepUserFunction(pre_step)
    mbs.Assemble()
    mbs.SolveDynamic(equal_steps(1, 10), solverType=METHOD)
    assert len(forces) == 10
    velocity = mbs.GetNodeOutput(node, Variable.Velocity)[0]
    assert velocity == pytest.approx(sum(forces) * 0.1 / 2, abs=1e-13)


def test_a_pendulum_of_cable_elements_falls_as_with_other_methods() -> None:
    def tip(method: Any, tolerance: float) -> np.ndarray:
        mbs = new_system()
        cable = exu.utilities.Cable2D(
            physicsMassPerLength=1, physicsBendingStiffness=10, physicsAxialStiffness=1e4, physicsBendingDamping=0.01
        )
        nodes = exu.utilities.GenerateStraightLineANCFCable2D(
            mbs, [0, 0, 0], [2, 0, 0], 4, cable, massProportionalLoad=[0, -9.81, 0], fixedConstraintsNode0=[1, 1, 0, 0]
        )[0]
        mbs.Assemble()
        mbs.SolveDynamic(tolerances(0.5, tolerance, 10), solverType=method)
        return np.array(mbs.GetNodeOutput(nodes[-1], Variable.Position))

    np.testing.assert_allclose(tip(METHOD, 1e-7), tip(Solver.DOP853, 1e-10), rtol=0, atol=3e-6)


def test_derivatives_by_differences() -> None:
    results = []
    for by_differences in (False, True):
        mbs, node = elastic_pendulum()
        s = equal_steps(1.0, 20)
        s.timeIntegration.newton.numericalDifferentiation.forODE2 = by_differences
        mbs.SolveDynamic(s, solverType=METHOD)
        results.append(final(mbs, node))
    np.testing.assert_allclose(results[0], results[1], rtol=0, atol=1e-10)


def test_a_factorization_serves_many_steps() -> None:
    mbs, _ = elastic_pendulum()
    mbs.SolveDynamic(equal_steps(1.0, 200), solverType=METHOD)
    assert statistics(mbs).newtonJacobiCount < 40
    assert statistics(mbs).newtonStepsCount < 200 * 5 * 3


def test_massless_coordinates_are_carried_along() -> None:
    """Two springs in series without a mass between them: stiffness of both in a row; explicit methods divide by the mass."""
    mbs = new_system()
    ground = mbs.AddNode(exu.NodePointGround())
    nodes = [mbs.AddNode(exu.Node1D(referenceCoordinates=[0], initialCoordinates=[x])) for x in (0.5, 1.0)]
    mbs.AddObject(exu.Mass1D(nodeNumber=nodes[1], physicsMass=1.0))
    markers = [mbs.AddMarker(exu.MarkerNodeCoordinate(nodeNumber=n, coordinate=0)) for n in (ground, *nodes)]
    for pair in (markers[:2], markers[1:]):
        mbs.AddObject(exu.ObjectConnectorCoordinateSpringDamper(markerNumbers=pair, stiffness=50))
    mbs.Assemble()
    mbs.SolveDynamic(equal_steps(1, 100), solverType=METHOD)
    assert mbs.systemData.GetODE2Coordinates() == pytest.approx([0.5 * np.cos(5), np.cos(5)], abs=1e-4)


def test_algebraic_coordinates_are_refused() -> None:
    """A mass that slides along a straight, fixed cable: its place there is an algebraic coordinate."""
    mbs = new_system()
    nodes = [mbs.AddNode(exu.NodePoint2DSlope1(referenceCoordinates=[x, 0, 1, 0])) for x in (0, 1)]
    cable = mbs.AddObject(
        exu.ObjectANCFCable2D(
            physicsLength=1,
            physicsMassPerLength=1,
            physicsBendingStiffness=1,
            physicsAxialStiffness=1,
            nodeNumbers=nodes,
        )
    )
    mass = mbs.CreateMassPoint(referencePosition=[0.5, 0, 0], physicsMass=2)
    wire = mbs.AddMarker(exu.MarkerBodyCable2DCoordinates(bodyNumber=cable))
    mbs.AddObject(
        exu.ObjectJointSliding2D(
            name="bead",
            markerNumbers=[mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=mass)), wire],
            slidingMarkerNumbers=[wire],
            slidingMarkerOffsets=[0],
            nodeNumber=mbs.AddNode(exu.NodeGenericData(numberOfDataCoordinates=2, initialCoordinates=[0, 0.5])),
        )
    )
    mbs.Assemble()
    with pytest.raises(
        ValueError, match=r"ESDIRK43.*'bead' \(ObjectJointSliding2D\).*algebraic coordinate.*GeneralizedAlpha"
    ):
        mbs.SolveDynamic(equal_steps(1, 10), solverType=METHOD)
