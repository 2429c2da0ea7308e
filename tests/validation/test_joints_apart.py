"""Joints of closed loops that do not fit together, or are apart at the start or by drift: fits, detection, and
messages."""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
import pytest
from rods import Rod, section
from solving import Solver, settings
from test_bricard import Bricard
from test_redundant import LENGTH_OF_CUBE, NODES, Door, redundancy
from test_units_of_length import hung_door
from tolerances import by_tolerance

import dalembert as exu
from dalembert.solver import SolverError

OF_POSITIONS = (Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ESDIRK43)  # that close gaps of positions


@pytest.mark.parametrize("solver", OF_POSITIONS)
@pytest.mark.parametrize("node", NODES)
def test_misplaced_hinges_are_fitted_with_a_warning(node: Any, solver: Any, capfd: Any) -> None:
    """The least-squares fit halves the misplacement, and so do the gaps of the edges.

    Stages of ``ESDIRK43`` leave Euler parameters off unit length, where such hinges act against each other.
    """
    aligned, misplaced = Door(node=node), Door(misplaced=1e-6, node=node)
    for door in (aligned, misplaced):
        door.mbs.SolveDynamic(settings(2, 200), solverType=solver)
    assert np.abs(misplaced.edge() - aligned.edge()).max() == pytest.approx(5e-7, rel=0.02)
    told = capfd.readouterr().out
    assert told.count("contradict each other") == 1 and "'hinge 0'" in told and "'hinge 1'" in told
    assert 1e-7 < redundancy(misplaced.mbs)["misfit"] < 1e-6


@pytest.mark.parametrize("solver", OF_POSITIONS)
@pytest.mark.parametrize("misplaced", [1e-4, 1e-3, 1e-2])
def test_hinges_that_do_not_fit_are_refused(misplaced: float, solver: Any) -> None:
    with pytest.raises(SolverError) as refused:
        Door(misplaced=misplaced).mbs.SolveDynamic(settings(2, 200), solverType=solver)
    assert refused.value.reason == "contradictoryConstraints" and refused.value.stepIndex == 1
    for hinge in range(2):
        named = [text for text in refused.value.dependentEquations if f"'hinge {hinge}'" in text]
        assert len(named) == 1
        apart = float(named[0].split(": ")[-1].removesuffix(" m"))
        assert abs(apart) == pytest.approx(misplaced, rel=1e-3)


@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5, Solver.ODE23])
def test_errors_of_hinges_that_do_not_fit_are_not_laid_on_jumps(solver: Any) -> None:
    """Tolerances are smaller than the gap that the first step has to close, for any step size."""
    door = Door(misplaced=1e-6)
    (doubt,) = door.mbs.SolveDynamic(by_tolerance(settings(0.2, 20), 1e-8), solverType=solver).doubts
    assert doubt.startswith("errors above the tolerances in ") and "jumps" not in doubt
    assert "contradict each other" in doubt and "'hinge 0'" in doubt and "'hinge 1'" in doubt


def test_steps_that_never_close_hinges_that_do_not_fit_say_so() -> None:
    s = by_tolerance(settings(0.2, 20), 1e-8)
    s.redundantConstraints.largestMisfit = 1e-4
    with pytest.raises(SolverError) as ended:
        Door(misplaced=1e-5).mbs.SolveDynamic(s)
    advice = ended.value.advice[0]
    assert "contradict each other" in advice and "'hinge 0'" in advice and "'hinge 1'" in advice


@pytest.mark.parametrize("gap", [5e-8, 1e-7, 3e-7])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.DOPRI5])
def test_errors_of_doors_beside_their_hinges_are_not_laid_on_jumps(solver: Any, gap: float) -> None:
    """If they could fit, initial values are the cause. The smallest steps end at round-off, also of multipliers that
    closing the gap leaves idle."""
    door = Door()
    moved = np.array(door.mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Initial))
    moved[0] += gap
    door.mbs.systemData.SetODE2Coordinates(moved, exu.ConfigurationType.Initial)
    (doubt,) = door.mbs.SolveDynamic(by_tolerance(settings(0.2, 20), 1e-8), solverType=solver).doubts
    assert "ComputeConsistentInitialConditions" in doubt and "contradict" not in doubt and "'hinge 0'" in doubt
    door.mbs.ComputeConsistentInitialConditions()
    assert door.mbs.SolveDynamic(by_tolerance(settings(0.2, 20), 1e-8), solverType=solver) is True


def freedoms(mbs: Any) -> list[int]:
    """Count by elimination, by singular values, and by eigenvalues."""
    counts = [mbs.ComputeSystemDegreeOfFreedom(useSVD=by)["degreeOfFreedom"] for by in (False, True)]
    return [*counts, len(mbs.ComputeODE2Eigenvalues()[0])]


@pytest.mark.parametrize("misplaced", [1e-8, 1e-7, 1e-6])
@pytest.mark.parametrize("node", NODES)
def test_degrees_of_freedom_where_hinges_hardly_fit(node: Any, misplaced: float) -> None:
    """Fitted as closely as possible, their axes are not parallel by as much, which singular values took for a constraint without a word."""
    door = Door(node=node, misplaced=misplaced)
    with pytest.warns(UserWarning, match="constraints contradict each other"):
        door.mbs.ComputeConsistentInitialConditions()
    with pytest.warns(UserWarning, match="joints are apart") as told:
        assert freedoms(door.mbs) == [1, 1, 1]
    assert all("'hinge 0'" in str(w.message) and "'hinge 1'" in str(w.message) for w in told) and len(told) <= 2


@pytest.mark.parametrize("turned", [1e-7, 1e-6])
def test_degrees_of_freedom_where_hinges_are_turned(turned: float) -> None:
    mbs = hung_door(1, 0, turned)
    with pytest.warns(UserWarning, match="constraints contradict each other"):
        mbs.ComputeConsistentInitialConditions()
    with pytest.warns(UserWarning, match="joints are apart"):
        assert freedoms(mbs) == [1, 1, 1]


@pytest.mark.parametrize("gap", [1e-8, 1e-6, 3e-5, 1e-3, 1e-2])
def test_degrees_of_freedom_beside_hinges(gap: float) -> None:
    """Initial values with gaps that hide redundant constraints: they are counted nevertheless, or reported."""
    door = Door()
    assert freedoms(door.mbs) == [1, 1, 1]
    moved = np.array(door.mbs.systemData.GetODE2Coordinates(exu.ConfigurationType.Initial))
    moved[:3] += gap * np.array([0.3, -0.8, 0.5])
    moved[4:] += gap * np.array([0.6, 0.7, -0.4])  # of Euler parameters
    door.mbs.systemData.SetODE2Coordinates(moved, exu.ConfigurationType.Initial)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        found = freedoms(door.mbs)
    if gap < 1e-4:
        assert found == [1, 1, 1]
    else:
        assert any("ComputeConsistentInitialConditions" in str(w.message) for w in told)
    door.mbs.ComputeConsistentInitialConditions()
    assert freedoms(door.mbs) == [1, 1, 1]


def clamped_beam(apart: float) -> Any:
    """A beam of 2 m, 5 cm thick, whose ends are clamped twice, the second time with an offset (m)."""
    rod, E, thick = Rod(), 2e9, 0.05
    area, second_moment = thick**2, thick**4 / 12
    shear = E / 2.6 * 0.85 * area
    stiffness = [E * area, shear, shear, E / 1.3 * second_moment, E * second_moment, E * second_moment]
    of = section(stiffness, 1000 * area, 1000 * second_moment * np.array([2, 1, 1]))
    nodes = rod.add_leg(np.zeros(3), np.eye(3), 2, 8, of)
    for node, x in ((nodes[0], 0), (nodes[-1], 2)):
        for beside in (0, apart):
            place = exu.MarkerBodyRigid(bodyNumber=0, localPosition=[x, beside, 0])
            rod.join(rod.mbs.AddMarker(place), rod.marker(node), np.eye(3))
    rod.mbs.Assemble()
    return rod.mbs


@pytest.mark.parametrize("solver", [None, *OF_POSITIONS[::2]])
def test_tolerance_of_a_clamp_is_relative_to_the_beam(solver: Any) -> None:
    """The reference is not the radius of gyration of its node, for which 1e-6 m would be too much. The least-squares
    fit is off by half of the distance of the clamps."""

    def solve(apart: float) -> None:
        mbs, s = clamped_beam(apart), settings(0.01, 10)
        if solver is None:
            mbs.SolveStatic(s)
        else:
            mbs.SolveDynamic(s, solverType=solver)
        name = "staticSolver" if solver is None else "dynamicSolver"
        assert mbs.sys[name].GetRedundantConstraints()["misfit"] == pytest.approx(apart / 2 / 2, rel=1e-3)

    solve(1e-6)
    with pytest.raises(SolverError) as refused:
        solve(1e-5)
    assert refused.value.reason == "contradictoryConstraints"


def test_a_larger_misfit_may_be_allowed() -> None:
    s = settings(0.1, 10)
    s.redundantConstraints.largestMisfit = 1e-4
    Door(misplaced=1e-4).mbs.SolveDynamic(s)


@pytest.mark.parametrize("misplaced", [1e-8, 1e-7, 1e-6])
@pytest.mark.parametrize("node", NODES[:2])
def test_joints_that_hardly_fit_are_fitted_at_the_start(misplaced: float, node: Any) -> None:
    """Fit of solvers: all turn as far, and as fast, as they do where hinges fit; further apart, they are refused."""
    angles, speeds = [], []
    for apart in (misplaced, 1e-9):
        door = Door(misplaced=apart, node=node)
        data, initial = door.mbs.systemData, exu.ConfigurationType.Initial
        q = np.array(data.GetODE2Coordinates(initial))
        data.SetODE2Coordinates(list(q + 0.01), initial)
        data.SetODE2Coordinates_t([0, 0.9] + [0] * (len(q) - 2), initial)
        with pytest.warns(UserWarning, match="contradict each other(.|\n)*'hinge 1'"):
            found = door.mbs.ComputeConsistentInitialConditions()
        assert 0.1 * apart < found.positionGaps[1] < apart and found.redundantEquations == 5
        angles.append(np.array(data.GetODE2Coordinates(initial)))
        speeds.append(np.array(data.GetODE2Coordinates_t(initial)))
    np.testing.assert_allclose(angles[0], angles[1], rtol=0, atol=10 * misplaced)
    np.testing.assert_allclose(speeds[0], speeds[1], rtol=0, atol=1e-3)
    with pytest.raises(ValueError, match="'hinge 1' .*, equation 0: gap"):
        Door(misplaced=1e-5, node=node).mbs.ComputeConsistentInitialConditions()


@pytest.mark.parametrize("gap", [1e-5, 1e-4, 1e-3])
@pytest.mark.parametrize("solver", [Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.DOPRI5])
def test_what_is_redundant_is_found_where_joints_are_apart_at_the_start(solver: Solver, gap: float) -> None:
    """Six bars whose coordinates are off move as those with one equation less; they were 0.25 m apart without the
    redundant one."""
    ends = []
    for free in ({}, {5: 0}):
        mechanism = Bricard(free)
        data, initial = mechanism.mbs.systemData, exu.ConfigurationType.Initial
        q = np.array(data.GetODE2Coordinates(initial))
        data.SetODE2Coordinates(list(q + gap * np.random.default_rng(3).uniform(-1, 1, len(q))), initial)
        mechanism.mbs.SolveDynamic(settings(0.5, 200, spectral_radius=0.8), solverType=solver)
        assert redundancy(mechanism.mbs)["count"] == (not free)
        ends.append(mechanism.third_corner())
    assert ends[0] == pytest.approx(ends[1], abs=2 * gap)


@pytest.mark.parametrize("gap", [1e-3, 1e-2])
def test_what_is_redundant_is_found_when_gaps_have_been_closed(gap: float) -> None:
    """The first matrix does not show redundancy if joints have large gaps; reactions became 1e5 times as large as the
    smallest ones."""
    found = []
    for apart in (0, gap):
        mbs, initial = Bricard({}).mbs, exu.ConfigurationType.Initial
        fixed = exu.itemInterface.MarkerBodyPosition(bodyNumber=0, localPosition=[2, -1, 0.5])
        for body in range(1, 6):
            markers = [mbs.AddMarker(fixed), mbs.AddMarker(exu.itemInterface.MarkerBodyPosition(bodyNumber=body))]
            mbs.AddObject(exu.itemInterface.CartesianSpringDamper(markerNumbers=markers, stiffness=[5, 5, 5]))
        mbs.Assemble()
        q = np.array(mbs.systemData.GetODE2Coordinates(initial))
        mbs.systemData.SetODE2Coordinates(list(q + apart * np.random.default_rng(3).uniform(-1, 1, len(q))), initial)
        s = settings(1, 5)
        s.staticSolver.numberOfLoadSteps = 5
        s.redundantConstraints.momentLength = LENGTH_OF_CUBE
        mbs.SolveStatic(s)
        assert redundancy(mbs, "staticSolver")["count"] == 1
        found.append(np.array(mbs.systemData.GetAECoordinates()))
    np.testing.assert_allclose(found[1], found[0], rtol=0, atol=1e-6 * np.abs(found[0]).max())


@pytest.mark.parametrize("steps", [8, 10, 12, 15, 20])
def test_what_iterates_leave_open_is_no_contradiction(steps: int) -> None:
    """Steps turn bodies by up to half a radian. Joints fit all the same, and move as those with one equation less; they were left open by up to 1e-7
    of their size, and the third corner was up to 8e-5 m away.
    """
    ends = []
    for free in ({}, {5: 0}):
        mechanism = Bricard(free)
        mechanism.mbs.SolveDynamic(settings(1.5, steps, spectral_radius=0.6))
        ends.append(mechanism.third_corner())
        assert redundancy(mechanism.mbs)["misfit"] < 1e-10
    assert ends[0] == pytest.approx(ends[1], abs=1e-6)


@pytest.mark.parametrize("steps", [30, 40, 50, 80])
def test_what_is_redundant_is_found_again_where_joints_have_drifted_apart(steps: int) -> None:
    """Velocity constraints, with gaps of up to 2e-4 of their size: an action of an event begins anew there. Motions
    with gaps due to drift are those with one equation less; the third corner is off by 0.2 m and more without the
    redundant equation.
    """

    def turn_back(mbs: Any, t: float, event: int, direction: int) -> bool:
        v = np.array(mbs.systemData.GetODE2Coordinates_t())
        mbs.systemData.SetODE2Coordinates_t(list(-0.7 * v), configuration=exu.ConfigurationType.Current)
        return True

    s = settings(1, steps, spectral_radius=1.0)
    s.timeIntegration.generalizedAlpha.useIndex2Constraints = True
    s.timeIntegration.generalizedAlpha.useNewmark = True
    full, freed = Bricard({}), Bricard({5: 0})
    for mechanism in (full, freed):
        mechanism.mbs.SetEventsUserFunction(lambda mbs, t: [(t - 0.6531, 1)])
        mechanism.mbs.SetEventActionUserFunction(turn_back)
        mechanism.mbs.SolveDynamic(s)
    assert redundancy(full.mbs)["count"] == 1
    assert full.third_corner() == pytest.approx(freed.third_corner(), abs=0.1 / steps**2)


def test_motions_that_leave_joints_are_told_from_joints_that_do_not_fit(capfd: Any) -> None:
    """Equal steps of index 3 without damping are unstable, and are not corrected if a function sets parameters of
    constraints in each step."""
    mbs = Bricard({}).mbs
    mbs.SetPreStepUserFunction(lambda mbs, t: mbs.SetObjectParameter(7, "activeConnector", True) or True)
    with pytest.raises(SolverError) as refused:
        mbs.SolveDynamic(settings(25, 5000, spectral_radius=1.0))
    assert refused.value.reason == "openConstraints"
    assert (
        "have fitted together at the start" in refused.value.advice[0] and "spectralRadius" in refused.value.advice[0]
    )
    told = capfd.readouterr().out
    assert told.count("the motion leaves what redundant constraints allow") == 1 and "contradict" not in told
    for spectral_radius in (0.9, 1.0):
        good = Bricard({})
        assert good.mbs.SolveDynamic(settings(25, 5000, spectral_radius=spectral_radius)) is True
        assert abs(good.energy()) < 1e-5
