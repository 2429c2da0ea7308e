"""A model for each setting of the solvers on which it makes a difference, and the place of the difference.

A case changes one setting of a run; `given` are settings of both runs. Groups that time integration and the static solver
share are listed once, in `SHARED`, with a model for each.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import setting_models as models
from setting_models import Run

import dalembert as exu

Observe = Callable[[Run], Any]


class Case(NamedTuple):
    value: Any
    observe: Observe
    model: Callable[[], Any] = models.oscillation
    given: Mapping[str, Any] = {}
    solver: str = "implicit"
    times: int = 1  # number of solutions in sequence


# ---- effects of settings
# -----------------------------------------------------------------------------------------------


def steps(run: Run) -> Any:
    return run.it.currentStepIndex


def iterations(run: Run) -> Any:
    return run.it.newtonStepsCount


def jacobians(run: Run) -> Any:
    return run.it.newtonJacobiCount


def repetitions(run: Run) -> Any:
    return run.it.discontinuousIterationsCount


def times(run: Run) -> Any:
    return run.table[:, 0].tolist()


def motion(run: Run) -> Any:
    return run.table.tolist()


def state(run: Run) -> Any:
    return run.state


def solved(run: Run) -> Any:
    return run.error == ""


def names(run: Run) -> Any:
    return sorted(run.files)


def says(text: str) -> Observe:
    return lambda run: text in run.printed


def named(text: str) -> Observe:
    return lambda run: text in run.error + run.printed


def digits(run: Run) -> Any:
    return re.findall(r"residual = (\S+),", run.printed)


def solution(run: Run) -> Any:
    return run.files.get("coordinatesSolution.txt")


def sensor(run: Run) -> Any:
    return run.files.get("sensor.txt")


def during(name: str) -> Observe:
    """Contents of the file after each step."""
    return lambda run: [files.get(name) for files in run.seen]


def waits_longer_than(seconds: float) -> Observe:
    return lambda run: run.idle > seconds


# ---- cases -------------------------------------------------------------------------------------------------------------

LOUD = {"verboseMode": 2}
FILES = {"solutionSettings.writeSolutionToFile": True}
RESTART = {"solutionSettings.writeRestartFile": True, "solutionSettings.restartWritePeriod": 0.5}
LOUD_DYNAMICS = {"timeIntegration.verboseMode": 2}

GENERAL: dict[str, Case] = {
    "cleanUpMemory": Case(True, lambda run: run.residual_size),
    "displayComputationTime": Case(True, says("Computation times")),
    "displayStatistics": Case(True, says("iteration statistics")),
    "linearSolverType": Case(exu.LinearSolverType.EigenSparse, solved, models.coupled_by_the_user),
    "outputPrecision": Case(3, digits, given=LOUD_DYNAMICS),
    "initialConditions.checkConstraints": Case(False, named("contradict"), models.open_pendulum),
    "initialConditions.inconsistentIsError": Case(True, solved, models.open_pendulum),
    "initialConditions.positionTolerance": Case(0.1, named("contradict"), models.open_pendulum),
    "initialConditions.velocityTolerance": Case(10.0, named("contradict"), models.stretching_pendulum),
    "linearSolverSettings.ignoreSingularJacobian": Case(
        True,
        solved,
        models.redundant,
        {"linearSolverType": exu.LinearSolverType.EigenDense, "redundantConstraints.treat": False},
    ),
    "linearSolverSettings.pivotThreshold": Case(1e6, solved),
    "linearSolverSettings.showCausingItems": Case(
        False, named("twice"), models.redundant, {"redundantConstraints.treat": False}, solver="static"
    ),
    "continuation.ifAvailable": Case(True, solved, given={"solutionSettings.restartFileName": "/dev/null"}),
    "continuation.restartFileName": Case("/dev/null", solved),
    "events.ofItems": Case(True, motion, models.stopping),
    "denseOutput.atRequestedTimes": Case(True, times, given={"solutionSettings.sensorsWritePeriod": 0.15}),
    "redundantConstraints.largestMisfit": Case(1e-2, solved, models.contradictory),
    "redundantConstraints.momentLength": Case(20.0, motion, models.door),
    "redundantConstraints.treat": Case(False, solved, models.redundant),
    "linearSolverChoice.automatic": Case(False, says("linear solver: sparse"), models.chain, LOUD_DYNAMICS),
    "stepSizeControl.implicitSolvers": Case(True, steps),
    "parallel.numberOfThreads": Case(
        2, lambda run: run.threads, models.long_chain, {"linearSolverType": exu.LinearSolverType.EigenSparse}
    ),
}

SOLUTION: dict[str, Case] = {
    "appendToFile": Case(True, solution, given=FILES, times=2),
    "binarySolutionFile": Case(True, names, given=FILES),
    "coordinatesSolutionFileName": Case("other", names, given=FILES),
    "exportAccelerations": Case(False, solution, models.everything, FILES),
    "exportAlgebraicCoordinates": Case(False, solution, models.everything, FILES),
    "exportDataCoordinates": Case(False, solution, models.everything, FILES),
    "exportODE1Velocities": Case(False, solution, models.everything, FILES),
    "exportVelocities": Case(False, solution, models.everything, FILES),
    "flushFilesDOF": Case(1, during("coordinatesSolution.txt"), models.watched, FILES),
    "flushFilesImmediately": Case(True, during("coordinatesSolution.txt"), models.watched, FILES),
    "outputPrecision": Case(3, solution, given=FILES),
    "recordImagesInterval": Case(0.5, names),
    "restartFileName": Case("other.txt", names, given=RESTART),
    "restartWritePeriod": Case(0.1, during("restartFile.txt"), models.watched, RESTART),
    "sensorsAppendToFile": Case(True, sensor, times=2),
    "sensorsStoreAndWriteFiles": Case(False, names),
    "sensorsWriteFileFooter": Case(True, sensor),
    "sensorsWriteFileHeader": Case(False, sensor),
    "sensorsWritePeriod": Case(0.5, times),
    "solutionInformation": Case("a text", solution, given=FILES),
    "solutionWritePeriod": Case(0.5, solution, given=FILES),
    "solverInformationFileName": Case("other.txt", names, given={"timeIntegration.verboseModeFile": 1}),
    "writeFileFooter": Case(False, solution, given=FILES),
    "writeFileHeader": Case(False, solution, given=FILES),
    "writeInitialValues": Case(False, times),
    "writeRestartFile": Case(True, names),
    "writeSolutionToFile": Case(False, names, given=FILES),
}

# A load that Newton's method cannot reach at once in so few iterations.
STUBBORN = {"newton.maxIterations": 4, "minimumStepSize": 1e-6}
COARSE = {"newton.relativeTolerance": 1e-3}
MODIFIED = {"newton.useModifiedNewton": True}
DIFFERENCES = "newton.numericalDifferentiation."
BY_DIFFERENCES = {**COARSE, f"{DIFFERENCES}forODE2": True}
HARD = {"discontinuous.iterationTolerance": 1e-9}

# Below timeIntegration and staticSolver, with models of motion and of rest.
SHARED: dict[str, Case] = {
    "adaptiveStep": Case(False, solved, models.steep, STUBBORN),
    "adaptiveStepDecrease": Case(0.1, steps, models.steep, STUBBORN),
    "adaptiveStepIncrease": Case(1.1, steps, models.steep, {**STUBBORN, "adaptiveStepRecoverySteps": 1}),
    "adaptiveStepRecoveryIterations": Case(0, steps, models.steep, {**STUBBORN, "adaptiveStepRecoverySteps": 1}),
    "adaptiveStepRecoverySteps": Case(1, steps, models.steep, STUBBORN),
    "minimumStepSize": Case(0.9, solved, models.steep, {"newton.maxIterations": 4}),
    "stepInformation": Case(0, says("Nit/step"), given=LOUD),
    "verboseMode": Case(4, says("Jacobian =\n")),
    "verboseModeFile": Case(1, names),
    "discontinuous.ignoreMaxIterations": Case(
        False, solved, models.switching, {"discontinuous.maxIterations": 1, "adaptiveStep": False}
    ),
    "discontinuous.iterationTolerance": Case(10.0, repetitions, models.switching),
    "discontinuous.maxIterations": Case(1, repetitions, models.switching),
    "discontinuous.useRecommendedStepSize": Case(False, steps, models.recommending),
    "newton.absoluteTolerance": Case(1.0, iterations, models.nonlinear),
    "newton.adaptInitialResidual": Case(
        False,
        iterations,
        models.starting_in_balance,
        {"/timeIntegration.generalizedAlpha.computeInitialAccelerations": False},
    ),
    "newton.maximumSolutionNorm": Case(1e-9, solved, models.nonlinear, {"adaptiveStep": False}),
    "newton.maxIterations": Case(1, solved, models.nonlinear, {"adaptiveStep": False}),
    "newton.maxModifiedNewtonIterations": Case(1, jacobians, models.nonlinear, MODIFIED),
    "newton.maxModifiedNewtonRestartIterations": Case(
        1,
        lambda run: run.it.rejectedModifiedNewtonSteps,
        models.nonlinear,
        {**MODIFIED, "newton.maxModifiedNewtonIterations": 1, "newton.modifiedNewtonContractivity": 1e8},
    ),
    "newton.modifiedNewtonContractivity": Case(1e-6, jacobians, models.nonlinear, MODIFIED),
    "newton.modifiedNewtonJacUpdatePerStep": Case(True, jacobians, models.nonlinear, MODIFIED),
    "newton.newtonResidualMode": Case(1, iterations, models.nonlinear),
    "newton.relativeTolerance": Case(1e-2, iterations, models.nonlinear),
    "newton.useModifiedNewton": Case(True, jacobians, models.nonlinear),
    "newton.useNewtonSolver": Case(False, iterations, models.nonlinear),
    "newton.weightTolerancePerCoordinate": Case(
        True, iterations, models.many, {**MODIFIED, "newton.relativeTolerance": 0.0, "newton.absoluteTolerance": 1e-4}
    ),
    f"{DIFFERENCES}addReferenceCoordinatesToEpsilon": Case(True, state, models.nonlinear, BY_DIFFERENCES),
    f"{DIFFERENCES}doSystemWideDifferentiation": Case(True, iterations, models.reading_another),
    f"{DIFFERENCES}forAE": Case(True, state, models.pendulum, COARSE),
    f"{DIFFERENCES}forODE2": Case(True, state, models.nonlinear, COARSE),
    f"{DIFFERENCES}forODE2connectors": Case(True, state, models.nonlinear, COARSE),
    f"{DIFFERENCES}minimumCoordinateSize": Case(10.0, state, models.nonlinear, BY_DIFFERENCES),
    f"{DIFFERENCES}relativeEpsilon": Case(1e-2, state, models.nonlinear, BY_DIFFERENCES),
}

ALONG = {"arcLength.active": True, "numberOfLoadSteps": 20}
STATIC: dict[str, Case] = {
    "computeLoadsJacobian": Case(False, iterations, models.following_load),
    "constrainODE1coordinates": Case(False, state, models.everything),
    "arcLength.active": Case(True, times, models.truss),
    "arcLength.branchStep": Case(0.1, motion, models.steep_truss, {**ALONG, "arcLength.lowestLoadFactor": 0.0}),
    "arcLength.desiredIterations": Case(2, steps, models.truss, ALONG),
    "arcLength.largestStep": Case(0.05, steps, models.truss, ALONG),
    "arcLength.lowestLoadFactor": Case(0.0, times, models.truss, ALONG),
    "arcLength.maximumSteps": Case(3, solved, models.truss, ALONG),
    "arcLength.singularPoints": Case(False, times, models.truss, ALONG),
    "loadStepDuration": Case(2.0, times),
    "loadStepGeometric": Case(True, times),
    "loadStepGeometricRange": Case(10.0, times, given={"loadStepGeometric": True}),
    "loadStepStart": Case(2.0, times),
    "numberOfLoadSteps": Case(3, steps),
    "stabilizerODE2term": Case(1e3, motion),
    "useLoadFactor": Case(False, motion),
}

CONTROLLED = "DOPRI5"
NEWMARK = {"generalizedAlpha.useNewmark": True}
SIMPLIFIED = {"generalizedAlpha.lieGroupSimplifiedKinematicRelations": True, **COARSE}
MEASURED = {"/displayComputationTime": True, "endTime": 0.1}
REAL_TIME = {**MEASURED, "simulateInRealtime": True}
DYNAMIC: dict[str, Case] = {
    "absoluteTolerance": Case(1e-3, steps, solver=CONTROLLED),
    "automaticStepSize": Case(False, steps, solver=CONTROLLED),
    "computeLoadsJacobian": Case(1, iterations, models.following_load),
    "endTime": Case(2.0, times),
    "initialStepSize": Case(1e-4, times, solver=CONTROLLED),
    "numberOfSteps": Case(20, steps),
    "realtimeFactor": Case(1e6, waits_longer_than(0.05), given=REAL_TIME),
    "realtimeWaitMicroseconds": Case(300_000, waits_longer_than(0.2), given={**REAL_TIME, "endTime": 0.01}),
    "relativeTolerance": Case(1e-2, steps, solver=CONTROLLED, given={"absoluteTolerance": 1e-12}),
    "reuseConstantMassMatrix": Case(False, says("massMatrix"), solver="RK44", given=MEASURED),
    "simulateInRealtime": Case(True, waits_longer_than(0.05), given=MEASURED),
    "solverType": Case(exu.DynamicSolverType.ExplicitEuler, motion, solver="MainSolverExplicit"),
    "startTime": Case(0.5, times),
    "stepSizeMaxIncrease": Case(1.1, steps, solver=CONTROLLED, given={"initialStepSize": 1e-4}),
    "stepSizeSafety": Case(0.3, steps, solver=CONTROLLED),
    "explicitIntegration.computeEndOfStepAccelerations": Case(False, state, solver="RK44"),
    "explicitIntegration.dynamicSolverType": Case(
        exu.DynamicSolverType.ExplicitEuler, motion, solver="MainSolverExplicit"
    ),
    "explicitIntegration.eliminateConstraints": Case(False, state, models.held, solver="RK44"),
    "explicitIntegration.useLieGroupIntegration": Case(False, state, models.top, solver="RK44"),
    "generalizedAlpha.computeInitialAccelerations": Case(False, motion),
    "generalizedAlpha.lieGroupAddTangentOperator": Case(False, state, models.top, SIMPLIFIED),
    "generalizedAlpha.lieGroupSimplifiedKinematicRelations": Case(True, state, models.top),
    "generalizedAlpha.newmarkBeta": Case(0.3, motion, given=NEWMARK),
    "generalizedAlpha.newmarkGamma": Case(0.6, motion, given=NEWMARK),
    "generalizedAlpha.resetAccelerations": Case(
        True, motion, models.accelerated, {"generalizedAlpha.computeInitialAccelerations": False}
    ),
    "generalizedAlpha.spectralRadius": Case(0.5, motion),
    "generalizedAlpha.storeInitialAlgebraicCoordinates": Case(
        False, solution, models.pendulum, {"/solutionSettings.writeSolutionToFile": True}
    ),
    "generalizedAlpha.useIndex2Constraints": Case(True, state, models.pendulum, NEWMARK),
    "generalizedAlpha.useNewmark": Case(True, motion),
}


def _below(group: str, cases: Mapping[str, Case], solver: str | None = None) -> dict[str, Case]:
    """Cases with the paths of the group; a given path that begins with a slash is not below it."""
    found = {}
    for path, case in cases.items():
        given = {name[1:] if name.startswith("/") else f"{group}.{name}": v for name, v in case.given.items()}
        found[f"{group}.{path}"] = case._replace(given=given, solver=solver or case.solver)
    return found


CASES: dict[str, Case] = {
    **GENERAL,
    **{f"solutionSettings.{path}": case for path, case in SOLUTION.items()},
    **_below("timeIntegration", SHARED),
    **_below("staticSolver", SHARED, "static"),
    **_below("timeIntegration", DYNAMIC),
    **_below("staticSolver", STATIC, "static"),
}
