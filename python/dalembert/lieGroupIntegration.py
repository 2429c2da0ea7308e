"""Explicit Runge-Kutta integration of rotations by rotation vectors, for single bodies and as solver user functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import numpy.typing as npt

from dalembert._checks import FloatArray, shape_error
from dalembert._core import ConfigurationType, Print
from dalembert.lieGroupBasics import CompositionRuleForRotationVectors, TExpSO3Inv

Acceleration = Callable[[FloatArray, FloatArray], npt.ArrayLike]  # arguments: rotation vector and angular velocity
State = list[FloatArray]  # [rotation vector, angular velocity]


# ---- a single rigid body --------------------------------------------------------------------------------------------


def ComputeStepWithRK1(ODE2RHS: Acceleration, v0: npt.ArrayLike, w0: npt.ArrayLike, h: float) -> State:
    """Return [rotation vector (rad), local angular velocity (rad/s)] after an Euler step of h seconds."""
    v, w = np.asarray(v0, dtype=float), np.asarray(w0, dtype=float)
    return ComputeStepWithRK1FromAcceleration(ODE2RHS(v, w), v, w, h)


def ComputeStepWithRK1FromAcceleration(v0_t: npt.ArrayLike, v0: npt.ArrayLike, w0: npt.ArrayLike, h: float) -> State:
    """Return rotation vector and angular velocity after an Euler step with a known angular acceleration (rad/s^2)."""
    w = np.asarray(w0, dtype=float) + h * np.asarray(v0_t, dtype=float)
    return [np.asarray(CompositionRuleForRotationVectors(v0, h * w)), w]


def ComputeStepWithRK4(ODE2RHS: Acceleration, v0: npt.ArrayLike, w0: npt.ArrayLike, h: float) -> State:
    """Return rotation vector (rad) and local angular velocity (rad/s) after a step of the classical RK4 method."""
    w = np.asarray(w0, dtype=float)
    dw, turn = np.zeros(3), np.zeros(3)
    sum_w, sum_turn = np.zeros(3), np.zeros(3)
    for fraction, weight in ((0.0, 1 / 6), (0.5, 1 / 3), (0.5, 1 / 3), (1.0, 1 / 6)):
        turned, rate = fraction * turn, w + fraction * dw
        attitude = np.asarray(CompositionRuleForRotationVectors(v0, turned))
        dw, turn = h * np.asarray(ODE2RHS(attitude, rate)), h * (TExpSO3Inv(turned) @ rate)
        sum_w, sum_turn = sum_w + weight * dw, sum_turn + weight * turn
    return [np.asarray(CompositionRuleForRotationVectors(v0, sum_turn)), w + sum_w]


def RK_SolveEulersEOMWithProposedApproach(
    ODE2RHS: Acceleration, v0: npt.ArrayLike, w0: npt.ArrayLike, tEnd: float, numberOfSteps: int, solver: str
) -> dict[str, FloatArray]:
    """Integrate the rotation of a body to tEnd (s) with 'RK1' or 'RK4'; return time, rotationVector, angularVelocity.

    The arrays have one row per step and one for the start.
    """
    methods = {"RK1": ComputeStepWithRK1, "RK4": ComputeStepWithRK4}
    if solver not in methods:
        raise shape_error("RK_SolveEulersEOMWithProposedApproach: solver", "'RK1' or 'RK4'", solver)
    v, w = np.zeros((numberOfSteps + 1, 3)), np.zeros((numberOfSteps + 1, 3))
    v[0], w[0] = v0, w0
    for i in range(numberOfSteps):
        v[i + 1], w[i + 1] = methods[solver](ODE2RHS, v[i], w[i], tEnd / numberOfSteps)
    return {"time": np.linspace(0.0, tEnd, numberOfSteps + 1), "rotationVector": v, "angularVelocity": w}


# ---- systems, as user function of the implicit solver ---------------------------------------------------------------


def _constrained_coordinates(mainSys: Any, connector: dict[str, Any]) -> list[int]:
    """Return the global coordinates that a coordinate constraint acts on; ground nodes have none."""
    coordinates = []
    for number in connector["markerNumbers"]:
        marker = mainSys.GetMarker(number)
        if marker["markerType"] == "NodeCoordinate":
            node = marker["nodeNumber"]
            if mainSys.GetNode(node)["nodeType"] != "PointGround":
                coordinates.append(mainSys.GetNodeODE2Index(node) + marker["coordinate"])
    return coordinates


def LieGroupExplicitRKInitialize(mainSys: Any) -> None:
    """Find the Lie group nodes and coordinate constraints of an assembled system and keep them in mainSys.sys.

    Constraints may tie a coordinate to ground or to another one, without factor and offset.
    """
    indices, references = [], []
    for i in range(mainSys.systemData.NumberOfNodes()):
        node = mainSys.GetNode(i)
        if node["nodeType"] == "RigidBodyRotVecLG":
            indices.append(mainSys.GetNodeODE2Index(i))
            references.append(np.array(node["referenceCoordinates"][3:6], dtype=float))
    fixed: list[int] = []
    tied: list[list[int]] = []
    for i in range(mainSys.systemData.NumberOfObjects()):
        connector = mainSys.GetObject(i)
        if connector["objectType"] != "ConnectorCoordinate" or not connector["activeConnector"]:
            continue
        if connector["factorValue1"] != 1.0 or connector["offset"] != 0.0:
            Print(f"WARNING: LieGroupExplicitRKInitialize: object {i} is ignored, it needs factorValue1=1 and offset=0")
            continue
        coordinates = _constrained_coordinates(mainSys, connector)
        if len(coordinates) == 2:
            tied.append(coordinates)
        else:
            fixed += coordinates
    mainSys.sys["lieGroupODE2indices"] = indices
    mainSys.sys["lieGroupReferenceRotations"] = references
    mainSys.sys["constrainedToGroundCoordinatesList"] = fixed
    mainSys.sys["constrainedCoordinatesList"] = tied


def ExplicitRKComputeSystemAcceleration(mainSolver: Any, mainSys: Any, nODE2: int) -> FloatArray:
    """Return the ODE2 accelerations of the current state; the first of two tied coordinates carries both masses."""
    mainSolver.ComputeODE2RHS(mainSys)
    forces = np.array(mainSolver.GetSystemResidual()[:nODE2], dtype=float)
    mainSolver.ComputeMassMatrix(mainSys)
    M = np.array(mainSolver.GetSystemMassMatrix()[:nODE2, :nODE2], dtype=float)
    for first, second in mainSys.sys["constrainedCoordinatesList"]:
        M[first, first] += M[first, second] + M[second, first] + M[second, second]
        forces[first] += forces[second]
    return np.asarray(np.linalg.solve(M, forces))


def _rotation_slices(mainSys: Any) -> list[slice]:
    return [slice(i + 3, i + 6) for i in mainSys.sys["lieGroupODE2indices"]]


def LieGroupComputeKstage(
    mainSys: Any,
    u0: FloatArray,
    v0: FloatArray,
    h: float,
    nODE2: int,
    Kprev: FloatArray,
    kprev: FloatArray,
    factK: float,
) -> FloatArray:
    """Return the increments of a stage: displacements, and rotation vectors relative to the start of the step."""
    rates = v0[:nODE2] + factK * kprev
    K = h * rates
    for rotation in _rotation_slices(mainSys):
        K[rotation] = h * (TExpSO3Inv(factK * Kprev[rotation]) @ rates[rotation])
    return np.asarray(K)


def ExplicitRKApplyCoordinateConstraints(mainSys: Any) -> None:
    """Set fixed coordinates to zero and let tied coordinates follow the first of each pair."""
    data = mainSys.systemData
    u, v = np.array(data.GetODE2Coordinates()), np.array(data.GetODE2Coordinates_t())
    for vector in (u, v):
        vector[mainSys.sys["constrainedToGroundCoordinatesList"]] = 0
        for first, second in mainSys.sys["constrainedCoordinatesList"]:
            vector[second] = vector[first]
    data.SetODE2Coordinates(u)
    data.SetODE2Coordinates_t(v)


def _moved(mainSys: Any, u0: FloatArray, increment: FloatArray) -> FloatArray:
    """Return coordinates after an increment: rotation vectors are composed, all others added."""
    u = u0 + increment
    for rotation, reference in zip(_rotation_slices(mainSys), mainSys.sys["lieGroupReferenceRotations"], strict=True):
        u[rotation] = CompositionRuleForRotationVectors(reference + u0[rotation], increment[rotation]) - reference
    return u


def LieGroupUpdateStageSystemCoordinates(
    mainSys: Any, u0: FloatArray, v0: FloatArray, nODE2: int, Kprev: FloatArray, kprev: FloatArray, factK: float
) -> None:
    """Move the current state of the system to a stage: a fraction factK of the increments of the stage before."""
    mainSys.systemData.SetODE2Coordinates(_moved(mainSys, u0[:nODE2], factK * Kprev))
    mainSys.systemData.SetODE2Coordinates_t(v0[:nODE2] + factK * kprev)
    ExplicitRKApplyCoordinateConstraints(mainSys)


def UserFunctionNewtonLieGroupRK4(mainSolver: Any, mainSys: Any, sims: Any) -> bool:
    """Make an explicit fourth order step in place of the Newton iteration; for SetUserFunctionNewton. Returns True.

    LieGroupExplicitRKInitialize must have been called for the assembled system.
    """
    data = mainSys.systemData
    h = mainSolver.it.currentStepSize
    tEnd, tStart = data.GetTime(), data.GetTime(ConfigurationType.StartOfStep)
    n = mainSolver.GetODE2size()
    u0, v0 = np.array(data.GetODE2Coordinates()), np.array(data.GetODE2Coordinates_t())
    k, K = np.zeros(n), np.zeros(n)
    sum_k, sum_K = np.zeros(n), np.zeros(n)
    for fraction, weight in ((0.0, 1 / 6), (0.5, 1 / 3), (0.5, 1 / 3), (1.0, 1 / 6)):
        data.SetTime(tStart + fraction * h)
        if fraction != 0:
            LieGroupUpdateStageSystemCoordinates(mainSys, u0, v0, n, K, k, fraction)
        k, K = (
            h * ExplicitRKComputeSystemAcceleration(mainSolver, mainSys, n),
            LieGroupComputeKstage(mainSys, u0, v0, h, n, K, k, fraction),
        )
        sum_k, sum_K = sum_k + weight * k, sum_K + weight * K
    data.SetTime(tEnd)
    data.SetODE2Coordinates(_moved(mainSys, u0[:n], sum_K))
    data.SetODE2Coordinates_t(v0[:n] + sum_k)
    ExplicitRKApplyCoordinateConstraints(mainSys)
    return True
