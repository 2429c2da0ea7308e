"""Mass matrices: it is symmetric, positive, the derivative of the residual, and agrees with the equations of Newton and
Euler."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import dalembert as exu
from dalembert._core import testing
from dalembert.testing.scenes import BODIES, ITEMS, of_one_coordinate, on_one_frame
from dalembert.testing.tangents import random_state
from dalembert.testing.variants import Variant, variants_about
from dalembert.utilities import InertiaCuboid

BODY_TYPES = ("Body", "SuperElement", "FiniteElement")
VARIANTS = [v for item in ITEMS.values() if item.ready and item.object_type in BODY_TYPES for v in variants_about(item)]
each_body = pytest.mark.parametrize("variant", VARIANTS, ids=lambda variant: variant.id)
RIGID = [carrier for carrier in BODIES if on_one_frame(carrier) and not of_one_coordinate(carrier)]


@each_body
def test_mass_matrix_is_symmetric_and_positive(variant: Variant) -> None:
    scene = variant.build(seed=31)
    s = random_state(scene, seed=32)
    mass = testing.mass_matrix(scene.mbs, s)
    scale = np.abs(mass).max()
    np.testing.assert_allclose(mass, mass.T, rtol=0, atol=1e-14 * scale)
    # Euler parameters have one direction without inertia per node: their norm.
    norms = sum(kind.frame == "ep" for _, kind, _ in scene.nodes)
    values = np.linalg.eigvalsh(mass)
    np.testing.assert_allclose(values[:norms], 0, atol=1e-13 * scale)
    assert values[norms] > 1e-4 * scale


@each_body
def test_mass_matrix_is_the_derivative_by_accelerations(variant: Variant) -> None:
    scene = variant.build(seed=33)
    s = random_state(scene, seed=34)
    n, mass = len(s.q), testing.mass_matrix(scene.mbs, s)
    np.testing.assert_array_equal(mass, testing.mass_matrix(scene.mbs, s, dense=False))
    tangent = testing.tangent(scene.mbs, s, cq=0, cv=1e-300, ca=1)[:n, :n]
    np.testing.assert_allclose(tangent, mass, rtol=0, atol=1e-13 * np.abs(mass).max())
    with_inertia = testing.residual(scene.mbs, s)[:n]
    base = s.copy()
    base.a = 0 * s.a
    difference = with_inertia - testing.residual(scene.mbs, base)[:n]
    np.testing.assert_allclose(difference, mass @ s.a, rtol=0, atol=1e-12 * np.abs(with_inertia).max())


@each_body
def test_constant_mass_matrices_are_constant(variant: Variant) -> None:
    scene = variant.build(seed=35)
    first, second = (testing.mass_matrix(scene.mbs, random_state(scene, seed)) for seed in (36, 37))
    if testing.constant_mass_matrix(scene.mbs):
        np.testing.assert_array_equal(first, second)
    elif not variant.functions and dict(variant.options).get(
        "physicsUseCouplingTerms", True
    ):  # may be constant without
        assert np.abs(first - second).max() > 1e-3 * np.abs(first).max()


def test_which_mass_matrices_are_constant() -> None:
    constant = {v.pairs[0][1]: testing.constant_mass_matrix(v.build().mbs) for v in VARIANTS if not v.functions}
    names = (
        "ObjectRigidBody",
        "ObjectRigidBody2D",
        "ObjectFFRFreducedOrder",
        "ObjectFFRF",
        "ObjectALEANCFCable2D",
        "ObjectKinematicTree",
    )
    turning = {carrier for carrier in constant if carrier[0] in names}
    beam = "ObjectBeamGeometricallyExact"  # the mass matrix of Lie-group velocities is constant
    turning |= {(beam, node) for node in ("NodeRigidBodyEP", "NodeRigidBodyRxyz")}
    assert all(constant[carrier] for carrier in constant.keys() - turning)
    assert not any(constant[carrier] for carrier in turning)


@pytest.mark.parametrize("carrier", RIGID, ids="/".join)
def test_newton_euler(carrier: tuple[str, str]) -> None:
    """The inertia force about the node, from mass, centre of mass and inertia alone."""
    scene = Variant(carrier[0], (("", carrier), ("", carrier))).build(seed=38)
    wrenches = scene.wrenches(testing.residual(scene.mbs, scene.state()))
    for body, (_, kind, m), wrench in zip(scene.bodies, scene.nodes, wrenches, strict=True):
        data = scene.mbs.GetObject(body)
        mass, turn = data["physicsMass"], m.rotation if kind.frame != "point" else np.eye(3)
        j = data.get("physicsInertia", np.zeros(6))
        j = (
            np.diag([0, 0, j])
            if np.ndim(j) == 0
            else np.array([[j[0], j[5], j[4]], [j[5], j[1], j[3]], [j[4], j[3], j[2]]])
        )
        inertia = turn @ j @ turn.T
        arm = turn @ np.resize([*data.get("physicsCenterOfMass", []), 0.0, 0.0, 0.0], 3)
        omega, alpha = (
            (m.angular_velocity, m.angular_acceleration) if kind.frame != "point" else (np.zeros(3), np.zeros(3))
        )
        acceleration = m.acceleration + np.cross(alpha, arm) + np.cross(omega, np.cross(omega, arm))
        force = mass * acceleration
        moment = inertia @ alpha + np.cross(omega, inertia @ omega) + mass * np.cross(arm, m.acceleration)
        wanted = np.concatenate([force, moment])
        rows = [0, 1, 5] if kind.planar and kind.frame != "point" else [0, 1] if kind.planar else range(6)
        np.testing.assert_allclose(wrench[rows], wanted[rows], rtol=0, atol=1e-12 * np.abs(wanted).max())


def _spinning(node_type: Any, center: list[float]) -> Any:
    mbs = exu.SystemContainer().AddSystem()
    mbs.CreateRigidBody(
        inertia=InertiaCuboid(1000, [0.4, 0.2, 0.1]).Translated(center),
        nodeType=node_type,
        initialAngularVelocity=[3, 7, 1],
        gravity=[0, 0, -9.81],
    )
    mbs.Assemble()
    return mbs


@pytest.mark.parametrize(("node", "center", "constant"), [
    ("RotationRotationVector", [0.0, 0.0, 0.0], True),
    ("RotationRotationVector", [0.1, 0.0, 0.0], False),
    ("RotationEulerParameters", [0.0, 0.0, 0.0], False),
])  # fmt: skip
def test_spins_about_the_centre_of_mass_have_a_constant_mass_matrix(
    node: str, center: list[float], constant: bool
) -> None:
    mbs = _spinning(getattr(exu.NodeType, node), center)
    assert testing.constant_mass_matrix(mbs) == constant


@pytest.mark.parametrize(("parameter", "value"), [("physicsMass", 30.0), ("physicsCenterOfMass", [0.0, 0.02, 0.0])])
@pytest.mark.parametrize("solver", [exu.DynamicSolverType.RK44, exu.DynamicSolverType.VelocityVerlet])
def test_explicit_solvers_notice_other_masses(solver: Any, parameter: str, value: Any) -> None:
    """A stored constant matrix has the same effect as one that is computed in every evaluation, also after a change."""

    def end(reuse: bool, change: bool) -> np.ndarray:
        mbs = _spinning(exu.NodeType.RotationRotationVector, [0.0, 0.0, 0.0])
        mbs.AddLoad(
            exu.LoadForceVector(markerNumber=mbs.AddMarker(exu.MarkerBodyRigid(bodyNumber=0)), loadVector=[0, 50, 0])
        )

        def heavier(mbs: Any, t: float) -> bool:
            if change and t > 0.05:
                mbs.SetObjectParameter(0, parameter, value)
            return True

        mbs.SetPreStepUserFunction(heavier)
        mbs.Assemble()
        settings = exu.SimulationSettings()
        settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = 100, 0.1
        settings.timeIntegration.reuseConstantMassMatrix = reuse
        mbs.SolveDynamic(settings, solverType=solver)
        return np.concatenate([mbs.systemData.GetODE2Coordinates(), mbs.systemData.GetODE2Coordinates_t()])

    np.testing.assert_allclose(end(True, True), end(False, True), rtol=0, atol=1e-14 * np.abs(end(False, True)).max())
    assert np.abs(end(True, True) - end(True, False)).max() > 1e-3


SLOPES = {
    "NodePointSlope1": [1, 2, 3, 0, 0, 1],
    "NodePointSlope12": [1, 2, 3, 0, 2, 0, -2, 0, 0],
    "NodePointSlope23": [1, 2, 3, 0, 2, 0, -2, 0, 0],
    "NodePoint2DSlope1": [1, 2, 0, -2],
}


@pytest.mark.parametrize("name", SLOPES)
def test_point_masses_do_not_turn_with_slopes(mbs: exu.MainSystem, name: str) -> None:
    """A point mass on a node with slopes adds its mass and weight to the position; forces have no moment on slopes, for
    any lever arm."""
    size = 2 if name.endswith("2DSlope1") else 3
    node = mbs.AddNode(getattr(exu, name)(referenceCoordinates=SLOPES[name]))
    kind = exu.ObjectMassPoint2D if size == 2 else exu.ObjectMassPoint
    body = mbs.AddObject(kind(nodeNumber=node, physicsMass=2.5))
    at = mbs.AddMarker(exu.MarkerBodyPosition(bodyNumber=body, localPosition=[0.5, 0.25, 0]))
    mass = mbs.AddMarker(exu.MarkerBodyMass(bodyNumber=body))
    mbs.AddLoad(exu.LoadForceVector(markerNumber=at, loadVector=[1, 2, 4]))
    mbs.AddLoad(exu.LoadMassProportional(markerNumber=mass, loadVector=[0, -10, 0]))
    mbs.Assemble()
    state = testing.State(mbs)
    coordinates = len(state.q)
    expected = np.zeros((coordinates, coordinates))
    expected[:size, :size] = 2.5 * np.eye(size)
    np.testing.assert_array_equal(testing.mass_matrix(mbs, state), expected)
    np.testing.assert_array_equal(
        testing.residual(mbs, state)[:coordinates], -np.r_[[1, 2 - 25, 4][:size], np.zeros(coordinates - size)]
    )
    place = np.r_[SLOPES[name][:size], np.zeros(3 - size)] + [0.5, 0.25, 0]
    assert mbs.GetMarkerOutput(at, exu.OutputVariableType.Position).tolist() == place.tolist()
    turn = mbs.GetObjectOutputBody(body, exu.OutputVariableType.RotationMatrix, [0, 0, 0])
    np.testing.assert_array_equal(turn, np.eye(3).ravel())
