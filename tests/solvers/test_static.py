"""The static solver: load steps, step sizes, forces of constraints."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from oscillators import Oscillator, Variable, mass, oscillator

import dalembert as exu
from dalembert.itemInterface import CoordinateConstraint
from dalembert.solver import SolverError


def static_settings(steps: int = 1) -> Any:
    settings = exu.SimulationSettings()
    settings.staticSolver.numberOfLoadSteps = steps
    settings.staticSolver.newton.relativeTolerance = 1e-12
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = 1e-9  # every step
    return settings


def hardening(stiffness: float, cubic: float) -> Any:
    def law(mbs: Any, t: float, item: int, u: float, v: float, k: float, d: float, offset: float) -> float:
        return stiffness * u + cubic * u**3

    return law


def loaded(force: float, **parameters: Any) -> Oscillator:
    model = oscillator(position=0.0, speed=0.0, **parameters)
    model.load(force)
    return model


def test_linear_spring_follows_the_load() -> None:
    model = loaded(6.0, stiffness=80.0)
    model.mbs.SolveStatic(static_settings(4))
    # A single iteration is exact for a linear system: rounding errors are left.
    np.testing.assert_allclose(model.table(), [[f, f * 6 / 80] for f in (0, 0.25, 0.5, 0.75, 1)], rtol=0, atol=1e-15)
    it = model.mbs.sys["staticSolver"].it
    assert (it.currentStepIndex - 1, it.newtonStepsCount) == (4, 4)


@pytest.mark.parametrize("steps", [1, 5])
def test_nonlinear_spring(steps: int) -> None:
    model = loaded(9.0, law=hardening(10.0, 1000.0))
    model.mbs.SolveStatic(static_settings(steps))
    root = [r.real for r in np.roots([1000.0, 0, 10.0, -9.0]) if abs(r.imag) < 1e-12]
    # The residual is below 1e-12 of the load; the tangent is above 10.
    assert model.position == pytest.approx(root[0], abs=1e-12)


def test_geometric_load_steps() -> None:
    model = loaded(8.0, stiffness=80.0)
    settings = static_settings(4)
    settings.staticSolver.loadStepGeometric = True
    settings.staticSolver.loadStepGeometricRange = 1000.0
    model.mbs.SolveStatic(settings)
    np.testing.assert_allclose(model.table()[1:, 1], 0.1 * np.array([1e-3, 1e-2, 1e-1, 1]), rtol=1e-12)
    assert model.mbs.sys["staticSolver"].loadStepGeometricFactor == pytest.approx(10, rel=1e-14)


def test_geometric_load_steps_become_smaller_where_newton_fails() -> None:
    """From each load to the next, the factor becomes its root; every position is that of its load."""
    model = loaded(9.0, law=hardening(0.01, 1000.0))
    settings = static_settings(2)
    settings.staticSolver.newton.maxIterations = 5
    settings.staticSolver.loadStepGeometric = True
    settings.staticSolver.adaptiveStep = False
    with pytest.raises(SolverError, match="Newton's method did not converge"):
        model.mbs.SolveStatic(settings)
    settings.staticSolver.adaptiveStep = True
    assert model.mbs.SolveStatic(settings)
    factor, position = model.table()[1:].T
    np.testing.assert_allclose(
        1000 * position**3 + 0.01 * position, 9.0 * factor, rtol=1e-8
    )  # the tolerance of Newton's method
    ratios = np.log(factor[1:] / factor[:-1]) / np.log(1000)  # the last step is shortened to the full load
    assert len(ratios) > 2 and factor[-1] == 1
    np.testing.assert_allclose(np.log2(ratios[:-1]), np.round(np.log2(ratios[:-1])), atol=1e-6)


def test_full_load_in_every_step_without_load_factor() -> None:
    model = loaded(8.0, stiffness=80.0)
    settings = static_settings(2)
    settings.staticSolver.useLoadFactor = False
    model.mbs.SolveStatic(settings)
    np.testing.assert_allclose(model.table()[1:, 1], [0.1, 0.1], rtol=1e-14)


def test_small_steps_where_newton_fails_with_large_ones() -> None:
    """Newton's method overshoots from zero on the weak tangent of a hardening spring; few iterations are allowed."""
    model = loaded(9.0, law=hardening(0.01, 1000.0))
    settings = static_settings(1)
    settings.staticSolver.newton.maxIterations = 12
    settings.staticSolver.adaptiveStep = False
    settings.staticSolver.verboseMode = 0
    with pytest.raises(SolverError, match="Newton's method did not converge"):
        model.mbs.SolveStatic(settings)
    settings.staticSolver.adaptiveStep = True
    model.mbs.SolveStatic(settings)
    it = model.mbs.sys["staticSolver"].it
    assert it.currentStepIndex - 1 > 1
    assert it.currentTime == 1.0
    assert 1000 * model.position**3 + 0.01 * model.position == pytest.approx(9.0, rel=1e-10)


@pytest.mark.parametrize("force", [5.0, -2.0])
def test_force_of_a_constraint(force: float) -> None:
    """Static and dynamic solvers count multipliers with opposite signs; the coordinate that is held does not move."""
    multipliers = []
    for solve in ("SolveStatic", "SolveDynamic"):
        model = mass(position=0.0, speed=0.0)
        held = model.mbs.AddObject(CoordinateConstraint(markerNumbers=[model.ground, model.marker]))
        model.load(force)
        model.mbs.Assemble()
        getattr(model.mbs, solve)(static_settings())
        assert model.position == pytest.approx(0, abs=1e-14)
        multipliers.append(model.mbs.systemData.GetAECoordinates()[0])
        assert model.mbs.GetObjectOutput(held, Variable.Force) == pytest.approx(multipliers[-1], rel=1e-12)
    np.testing.assert_allclose(multipliers, [-force, force], rtol=1e-10)


def test_imposed_displacement_in_steps() -> None:
    model = oscillator(position=0.0, speed=0.0, stiffness=80.0)
    model.mbs.AddObject(
        CoordinateConstraint(
            markerNumbers=[model.ground, model.marker],
            offset=0.0,
            offsetUserFunction=lambda mbs, t, item, offset: 0.2 * t,
        )
    )
    model.mbs.Assemble()
    model.mbs.SolveStatic(static_settings(4))
    np.testing.assert_allclose(model.table()[:, 1], [0, 0.05, 0.1, 0.15, 0.2], rtol=0, atol=1e-15)
    # The spring pulls back with 16 N.
    assert abs(model.mbs.systemData.GetAECoordinates()[0]) == pytest.approx(16, rel=1e-12)


def test_result_as_initial_values() -> None:
    model = loaded(6.0, stiffness=80.0)
    model.mbs.SolveStatic(static_settings(), updateInitialValues=True)
    settings = static_settings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = 1.0, 100
    model.mbs.SolveDynamic(settings)
    np.testing.assert_allclose(model.table()[:, 1], 6 / 80, rtol=1e-13)  # it rests


def test_stabilizer_fades_out() -> None:
    """Held by the stabilizer, a free mass moves in proportion to the load, and the matrix is regular before the end."""
    model = loaded(6.0, stiffness=80.0)
    settings = static_settings(5)
    settings.staticSolver.stabilizerODE2term = 100.0
    model.mbs.SolveStatic(settings)
    start, now, factors = 0.0, [], np.arange(1, 6) / 5
    for factor in factors:  # (k + s (1 - f^2) m) x = f F + s (1 - f^2) m x_start
        stabilizer = 100 * (1 - factor**2) * 2.0
        start = (factor * 6 + stabilizer * start) / (80 + stabilizer)
        now.append(start)
    np.testing.assert_allclose(model.table()[1:, 1], now, rtol=1e-12)
    assert model.position == pytest.approx(6 / 80, rel=1e-12)


def test_ground_may_be_moved_between_solutions() -> None:
    """Frames of resting markers are evaluated once, and again when parameters under them change."""
    mbs = exu.SystemContainer().AddSystem()
    ground = mbs.AddObject(exu.ObjectGround())
    node = mbs.AddNode(exu.NodePoint())
    body = mbs.AddObject(exu.ObjectMassPoint(nodeNumber=node, physicsMass=1))
    markers = [mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=b)) for b in (ground, body)]
    mbs.AddObject(exu.ObjectConnectorCartesianSpringDamper(markerNumbers=markers, stiffness=[10, 20, 30]))
    mbs.Assemble()
    for place in ([0, 0, 0], [0.1, -0.2, 0.3]):
        mbs.SetObjectParameter(ground, "referencePosition", place)
        mbs.SolveStatic(static_settings())
        # A linear spring without load: the point meets the ground up to round-off.
        np.testing.assert_allclose(mbs.GetNodeOutput(node, Variable.Position), place, rtol=0, atol=1e-14)


@pytest.mark.parametrize("angle", [0.0, 0.7, 1.9, np.pi / 2])
@pytest.mark.parametrize("load", [0.0, 1e-9, 1.0])
def test_a_stiff_beam_in_any_direction(angle: float, load: float) -> None:
    """Forces without loads are round-off only. A cantilever of steel bends by F l^3 / (3 E I)."""
    E, diameter, length, count = 200e9, 0.01, 0.785, 16
    area, inertia = np.pi * diameter**2 / 4, np.pi * diameter**4 / 64
    G = E / 2.6
    section = exu.BeamSection()
    section.stiffnessMatrix = np.diag(
        [E * area, 0.9 * G * area, 0.9 * G * area, 2 * G * inertia, E * inertia, E * inertia]
    )
    section.massPerLength, section.inertia = 1, np.eye(3)
    mbs = exu.SystemContainer().AddSystem()
    direction = np.array([np.cos(angle), np.sin(angle), 0])
    nodes = [
        mbs.AddNode(exu.NodeRigidBodyRotVecLG(referenceCoordinates=[*(x * direction), 0, 0, angle]))
        for x in np.linspace(0, length, count + 1)
    ]
    for pair in zip(nodes[:-1], nodes[1:], strict=True):
        mbs.AddObject(
            exu.ObjectBeamGeometricallyExact(physicsLength=length / count, sectionData=section, nodeNumbers=list(pair))
        )
    ground = mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=mbs.AddObject(exu.ObjectGround())))
    start, end = (mbs.AddMarker(exu.MarkerNodeRigid(nodeNumber=n)) for n in (nodes[0], nodes[-1]))
    mbs.AddObject(
        exu.GenericJoint(markerNumbers=[ground, start], rotationMarker1=exu.rigidBodyUtilities.RotationMatrixZ(-angle))
    )
    normal = np.array([-direction[1], direction[0], 0])
    mbs.AddLoad(exu.Force(markerNumber=end, loadVector=list(load * normal)))
    mbs.Assemble()
    settings = static_settings()
    settings.staticSolver.newton.relativeTolerance = 1e-8
    assert mbs.SolveStatic(settings)
    bent = float(mbs.GetNodeOutput(nodes[-1], exu.OutputVariableType.Displacement) @ normal)
    # bending as in the closed form within 1e-3 (shear, elements); rounding of the stiff axial forces bends it by less than 1e-8 m
    assert bent == pytest.approx(load * length**3 / (3 * E * inertia), rel=1e-3, abs=1e-8)
