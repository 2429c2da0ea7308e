"""Solutions of a few steps, and calls of single parts of solvers."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

import numpy as np

import dalembert as exu

Solver = exu.DynamicSolverType
CLASSES = (
    exu.MainSolverStatic,
    exu.MainSolverImplicitSecondOrder,
    exu.MainSolverDiagonallyImplicit,
    exu.MainSolverExplicit,
)
PARTS = [
    "SolveSteps", "FinalizeSolver", "PreInitializeSolverSpecific", "InitializeSolverOutput", "InitializeSolverPreChecks",
    "InitializeSolverData", "InitializeSolverInitialConditions", "PostInitializeSolverSpecific", "UpdateCurrentTime",
    "InitializeStep", "FinishStep", "DiscontinuousIteration", "Newton", "IncreaseStepSize", "HasAutomaticStepSizeControl",
    "WriteCoordinatesToFile", "WriteSolutionFileHeader", "ComputeNewtonResidual", "ComputeNewtonJacobian",
    "ComputeNewtonUpdate", "PostNewton", "SolveSystem", "InitializeSolver",
]  # fmt: skip
COMPUTED = ["ComputeMassMatrix", "ComputeODE2RHS", "ComputeODE1RHS", "ComputeJacobianODE2RHS", "ComputeJacobianODE1RHS",
            "ComputeJacobianAE", "ComputeAlgebraicEquations", "CheckInitialized"]  # fmt: skip
READ = ["GetSystemMassMatrix", "GetSystemResidual", "GetSystemJacobian", "GetNewtonSolution", "GetAAlgorithmic",
        "GetStartOfStepStateAAlgorithmic", "GetErrorString", "GetDiagnosis", "GetODE2size", "GetAEsize", "GetSolverName",
        "__repr__"]  # fmt: skip


def dynamic(solver: Any) -> Callable[[Any, Any], Any]:
    return lambda mbs, settings: mbs.SolveDynamic(settings, solverType=solver, showCausingItems=False)


SOLVERS: dict[Any, Callable[[Any, Any], Any]] = {
    "static": lambda mbs, settings: mbs.SolveStatic(settings, showCausingItems=False)
} | {
    solver: dynamic(solver)
    for solver in (Solver.GeneralizedAlpha, Solver.TrapezoidalIndex2, Solver.RK44, Solver.ExplicitEuler, Solver.DOPRI5,
                   Solver.VelocityVerlet, Solver.ESDIRK43)
}  # fmt: skip


def some_settings(random: Random) -> tuple[str, Any, Any]:
    """A text, settings of a few steps, and a solver."""
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.timeIntegration.verboseMode = settings.staticSolver.verboseMode = 0
    chosen: dict[str, Any] = {
        "timeIntegration.numberOfSteps": random.choice((1, 2, 3)),
        "timeIntegration.endTime": random.choice((1e-3, 1e-4, 1e-2)),
        "timeIntegration.minimumStepSize": 1e-6,  # a stiff model ends an explicit solver after 1e4 steps
        "staticSolver.numberOfLoadSteps": random.choice((1, 2)),
        "staticSolver.newton.maxIterations": 8,
    }
    some = {
        "timeIntegration.newton.useModifiedNewton": True,
        "timeIntegration.newton.numericalDifferentiation.forODE2": True,
        "timeIntegration.newton.numericalDifferentiation.forAE": True,
        "timeIntegration.newton.useNewtonSolver": False,
        "timeIntegration.adaptiveStep": False,
        "timeIntegration.generalizedAlpha.useIndex2Constraints": True,
        "timeIntegration.generalizedAlpha.useNewmark": True,
        "timeIntegration.generalizedAlpha.computeInitialAccelerations": False,
        "timeIntegration.generalizedAlpha.spectralRadius": random.choice((0.0, 0.5, 1.0)),
        "timeIntegration.discontinuous.maxIterations": random.choice((1, 3)),
        "timeIntegration.explicitIntegration.useLieGroupIntegration": False,
        "linearSolverType": random.choice((exu.LinearSolverType.EigenSparse, exu.LinearSolverType.EigenDense)),
        "linearSolverSettings.ignoreSingularJacobian": True,
        "parallel.numberOfThreads": 2,
        "solutionSettings.sensorsWritePeriod": 1e-4,
        "solutionSettings.solutionWritePeriod": 1e-4,
        "solutionSettings.writeSolutionToFile": True,
        "solutionSettings.binarySolutionFile": True,
        "solutionSettings.writeRestartFile": True,
        "staticSolver.useLoadFactor": False,
        "staticSolver.stabilizerODE2term": 0.1,
        "staticSolver.adaptiveStep": False,
        "staticSolver.constrainODE1coordinates": False,
    }  # fmt: skip
    chosen |= {path: value for path, value in some.items() if random.random() < 0.1}
    for path, value in chosen.items():
        *groups, name = path.split(".")
        owner = settings
        for group in groups:
            owner = getattr(owner, group)
        setattr(owner, name, value)
    return str(chosen), settings, random.choice(list(SOLVERS))


def some_solver_call(random: Random, solvers: list[Any], mbs: Any) -> tuple[str, Callable[[], Any]]:
    """A part of a kept or of a new solver."""
    text, settings, _ = some_settings(random)
    if not solvers or random.random() < 0.2:
        solvers.append(random.choice(CLASSES)())
        del solvers[:-3]
        solver = solvers[-1]
        return f"solver = {solver!r}; solver.InitializeSolver(mbs, {text})", lambda: solver.InitializeSolver(
            mbs, settings
        )
    n = random.randrange(len(solvers))
    solver = solvers[n]
    group = random.choice((PARTS, PARTS, COMPUTED, READ))
    name = random.choice([name for name in group if hasattr(solver, name)])
    arguments = {id(PARTS): (mbs, settings), id(COMPUTED): (mbs,), id(READ): ()}[id(group)]
    if group is READ and random.random() < 0.3:
        matrix = random.choice((np.eye(3), np.zeros((2, 3)), np.zeros(0), np.ones(random.randrange(20))))
        name = random.choice(("SetSystemMassMatrix", "SetSystemResidual"))
        arguments = (matrix,)
    return f"solvers[{n}].{name}(mbs, {text})", lambda: getattr(solver, name)(*arguments)
