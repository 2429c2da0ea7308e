# Generated from specs/settings/ by codegen/templates/core_settings.pyi.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from collections.abc import Callable, Sequence
from typing import Any, Literal, Self, final

from numpy.typing import ArrayLike

from dalembert._core_enums import DynamicSolverType, ItemType, LinearSolverType, OutputVariableType

class _Settings:
    """What all structures have in common."""

    def GetDictionary(self) -> dict[str, Any]: ...
    def GetDictionaryWithTypeInfo(self) -> dict[str, Any]: ...
    def SetDictionary(self, dictionary: dict[str, Any], /) -> None: ...
    def _equals(self, other: Self, /) -> bool: ...
    def __copy__(self) -> Self: ...
    def __deepcopy__(self, memo: Any, /) -> Self: ...
    def __setstate__(self, state: dict[str, Any], /) -> None: ...

@final
class NewtonNumericalDifferentiationSettings(_Settings):
    """Jacobians by numerical differentiation"""

    addReferenceCoordinatesToEpsilon: bool
    """true: the size of a coordinate, which scales its increment, includes the reference value; acts with doSystemWideDifferentiation or forAE or forODE2 or forODE2connectors only; default: False"""
    doSystemWideDifferentiation: bool
    """true: the whole system is differentiated at once, with all dependencies, at a cost that grows with the square of its size; false: item by item; default: False"""
    forAE: bool
    """true: derivatives of algebraic equations by numerical differentiation, for tests; false: exact ones; default: False"""
    forODE2: bool
    """true: derivatives of second order equations by numerical differentiation; false: exact ones; default: False"""
    forODE2connectors: bool
    """true: derivatives of connector forces by numerical differentiation, for tests; the same as ``forODE2``, because forces of connectors and bodies are differentiated together; false: see ``forODE2``; default: False"""
    jacobianConnectorDerivative: bool
    """true: exact derivatives of connectors include the change of the directions of their forces; false: they leave it out; no effect: exact derivatives always include the change of the directions of forces, at no cost worth saving; default: True"""
    minimumCoordinateSize: float
    """smallest size of a coordinate that is used for its increment, in the units of the coordinate [various; greater than 0]; acts with doSystemWideDifferentiation or forAE or forODE2 or forODE2connectors only; default: 0.01"""
    relativeEpsilon: float
    """increment of a coordinate relative to its size [1; greater than 0 and less than 1]; acts with doSystemWideDifferentiation or forAE or forODE2 or forODE2connectors only; default: 1e-07"""
    def __init__(self, **settings: Any) -> None: ...

@final
class NewtonSettings(_Settings):
    """Newton's method for the nonlinear equations of a step"""

    absoluteTolerance: float
    """the iteration ends if the error is below this value, in the units of the residual [various]; default: 1e-10"""
    adaptInitialResidual: bool
    """true: if the residual grows in the first iteration, the larger value is the one that has to be reduced by the relative tolerance; useful for steps that start with a residual near zero; default: True"""
    maximumSolutionNorm: float
    """the solver stops with an error if the squared norm of coordinates or velocities reaches this value: explicit solvers after every step (coordinates only with values below the default), Newton's method while it has not converged [various; greater than 0]; default: 1e+38"""
    maxIterations: int
    """number of iterations of all kinds after which a step has failed [at least 1]; default: 25"""
    maxModifiedNewtonIterations: int
    """number of iterations with an old Jacobian after which it is computed anew; acts with useModifiedNewton only; default: 8"""
    maxModifiedNewtonRestartIterations: int
    """number of iterations with a renewed Jacobian after which the step goes on with full Newton; acts with useModifiedNewton only; default: 7"""
    modifiedNewtonContractivity: float
    """largest ratio of the errors of two iterations that an old Jacobian may show; above it the Jacobian is computed anew [1]; acts with useModifiedNewton only; default: 0.5"""
    modifiedNewtonJacUpdatePerStep: bool
    """true: modified Newton computes the Jacobian once per step; false: only when convergence asks for it; acts with useModifiedNewton only; default: False"""
    newtonResidualMode: int
    """quantity that measures the error: 0 the residual, 1 the increment of the coordinates of differential equations [from 0 to 1]; default: 0"""
    relativeTolerance: float
    """the iteration ends if the error has fallen below this fraction of the initial one; fine steps also apply the correction of the last residual, so that smaller steps are more accurate [1; from 0 to 1]; default: 1e-08"""
    useModifiedNewton: bool
    """true: the Jacobian and its factorization are kept as long as convergence allows; false: computed in every iteration; default: False"""
    useNewtonSolver: bool
    """true: nonlinear equations; false: one linear step; default: True"""
    weightTolerancePerCoordinate: bool
    """true: the norm of the error is divided by the root of the number of coordinates, so that tolerances do not depend on the size of the model; false: plain norm; default: False"""
    @property
    def numericalDifferentiation(self) -> NewtonNumericalDifferentiationSettings: ...
    @numericalDifferentiation.setter
    def numericalDifferentiation(self, value: NewtonNumericalDifferentiationSettings | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class DiscontinuousSettings(_Settings):
    """iterations for contact, friction and other discontinuous states, after Newton's method has converged"""

    ignoreMaxIterations: bool
    """true: the step is accepted when the maximum number of iterations is reached; false: it has failed; default: True"""
    iterationTolerance: float
    """largest error of the discontinuous states that is accepted; an absolute value, in the units of the contact or friction item [various]; default: 1.0"""
    maxIterations: int
    """number of discontinuous iterations in one step [at least 1]; default: 5"""
    useRecommendedStepSize: bool
    """true: the step size follows recommendations of items, for example at the start of a contact; false: they are ignored; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class ContinuationSettings(_Settings):
    """continuation of a solution that was stopped"""

    ifAvailable: bool
    """true: ``SolveDynamic`` and ``SolveStatic`` go on from the file ``solutionSettings.restartFileName`` if it exists, else they start from the initial values; a ``restartFileName`` given here is used in any case; default: False"""
    restartFileName: str
    """restart file of a solution with the same model, solver and settings; its start time, end time and number of steps are those of the whole solution. Solution and sensor files continue at their position in the restart file; later rows are overwritten. Empty: start from the initial values; default: ''"""
    def __init__(self, **settings: Any) -> None: ...

@final
class DenseOutputSettings(_Settings):
    """output between the ends of steps"""

    atRequestedTimes: bool
    """true: solution and sensors are written at the multiples of ``solutionWritePeriod`` and ``sensorsWritePeriod``, counted from the start, and at the end; within steps by Hermite interpolation of coordinates, velocities and accelerations. Data coordinates are those of the end of the step. False: they are written at the first end of a step at which the period is over. Static solvers write at their load steps; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class EventsSettings(_Settings):
    """contact that opens or closes, friction that begins to slide or to stick, and stops"""

    ofItems: bool
    """true: dynamic solvers locate events of contact, friction and stops of items, GeneralContact, and sliding joints that pass from element to element: a step with an event is solved again such that it ends there, and accelerations are recomputed. An item that switches repeatedly, each time within two steps, raises an error with its name. False: items switch in the discontinuous iteration, at the end of a step; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class InitialConditionsSettings(_Settings):
    """check of the initial values against the constraints"""

    checkConstraints: bool
    """evaluate the gap and the rate of the gap of every constraint before the first step, and name the worst of those that are not fulfilled; the static solver looks at gaps only, closes them, and says so if its verboseMode is at least 1; default: True"""
    inconsistentIsError: bool
    """true: constraints that are not fulfilled at the start are an error; false: a warning; default: False"""
    positionTolerance: float
    """largest gap that is not reported: relative to the size of the mechanism, which is the diagonal of the box around the nodes and markers of bodies that constraints connect, or in rad; 1000 times as much is tolerated at the end of solutions that constrain velocities [1]; default: 1e-05"""
    velocityTolerance: float
    """largest rate of a gap that is not reported, relative to the sum of the magnitudes of the velocities that meet in the constraint; rates that open a gap of less than positionTolerance in one second are not reported [1]; default: 0.01"""
    def __init__(self, **settings: Any) -> None: ...

@final
class LinearSolverChoiceSettings(_Settings):
    """selection of the linear solver"""

    automatic: bool
    """true: dense matrices are used up to 32 unknowns and sparse ones above; setting ``linearSolverType`` makes this false; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class LinearSolverSettings(_Settings):
    """settings of the linear solver"""

    ignoreSingularJacobian: bool
    """true: a singular system matrix is no error, and one of the possible solutions is taken, for example with redundant constraints; only with a dense solver with full pivoting, and to be checked with care; false: a singular matrix stops the solver; default: False"""
    pivotThreshold: float
    """a pivot below this value is treated as zero, so that an almost singular matrix is reported; dense solvers only; 0: exact zeros only [1]; default: 0.0"""
    reuseAnalyzedPattern: bool
    """true: the symbolic analysis of a sparse matrix is used for all factorizations with the same pattern; no effect: a sparse matrix is always analyzed once for all factorizations with the same pattern; default: False"""
    showCausingItems: bool
    """name the items whose equations make the system matrix singular when the solver fails; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class ParallelSettings(_Settings):
    """computation with several threads"""

    multithreadedLLimitJacobians: int
    """number of items from which on Jacobians are evaluated in parallel; no effect: how work is divided among threads follows from the size of the system alone, so that results do not depend on it; default: 20"""
    multithreadedLLimitLoads: int
    """number of loads from which on these are evaluated in parallel; no effect: how work is divided among threads follows from the size of the system alone, so that results do not depend on it; default: 20"""
    multithreadedLLimitMassMatrices: int
    """number of bodies from which on mass matrices are evaluated in parallel; no effect: how work is divided among threads follows from the size of the system alone, so that results do not depend on it; default: 20"""
    multithreadedLLimitResiduals: int
    """number of items from which on residuals are evaluated in parallel; no effect: how work is divided among threads follows from the size of the system alone, so that results do not depend on it; default: 20"""
    numberOfThreads: int
    """number of threads that share the evaluation of residuals, tangents and explicit right-hand sides; limited by the number of cores; results are bit-identical; default: 1"""
    taskSplitMinItems: int
    """number of items from which on work is split into several parts per thread; no effect: how work is divided among threads follows from the size of the system alone, so that results do not depend on it; default: 50"""
    taskSplitTasksPerThread: int
    """number of parts of work per thread; no effect: how work is divided among threads follows from the size of the system alone, so that results do not depend on it; default: 16"""
    useLoadBalancing: bool
    """true: threads that are ready take over work of others; false: fixed share per thread; no effect: threads that are ready always take over work of others; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class RedundantConstraintsSettings(_Settings):
    """constraint equations that follow from others, such as those of the second hinge of a door"""

    largestMisfit: float
    """gap that redundant constraints which contradict each other may leave, relative to the size of their mechanism, or in rad: up to it the solver distributes it among them and warns, above it is an error [1]; default: 1e-06"""
    momentLength: float
    """the smallest reactions are those with the smallest sum of squares of forces and of moments divided by this length; 0: the size of the mechanism, which is the diagonal of the box around the nodes and markers of bodies that constraints connect, but at most 20 radii of gyration of its bodies (on average) [m]; default: 0.0"""
    treat: bool
    """true: find redundant constraints and solve in spite of them; false: a matrix that they make singular stops the solver, and where round-off hides that, reactions are arbitrary; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class SolutionSettings(_Settings):
    """output to files: contents and intervals"""

    appendToFile: bool
    """true: solution and solver information are appended to existing files; false: existing files are replaced; binary files are always replaced; default: False"""
    binarySolutionFile: bool
    """true: the solution file is binary, with 8 byte numbers if ``outputPrecision`` is at least 8 and with 4 byte numbers otherwise; false: text; default: False"""
    coordinatesSolutionFileName: str
    """solution file with all coordinates, with its path; directories are created; the default ending is .txt or, for a binary file, .sol; default: 'coordinatesSolution'"""
    exportAccelerations: bool
    """write the accelerations of second order coordinates to the solution file; default: True"""
    exportAlgebraicCoordinates: bool
    """write algebraic variables, such as Lagrange multipliers, to the solution file; default: True"""
    exportDataCoordinates: bool
    """write data variables to the solution file; default: True"""
    exportODE1Velocities: bool
    """write the time derivatives of first order coordinates to the solution file; default: True"""
    exportVelocities: bool
    """write the velocities of second order coordinates to the solution file; default: True"""
    flushFilesDOF: int
    """number of coordinates from which on the solution file is flushed at every output, independently of ``flushFilesImmediately``; default: 10000"""
    flushFilesImmediately: bool
    """true: files are complete after every output, which costs time in models with short steps; false: output is buffered; default: False"""
    outputPrecision: int
    """number of significant digits in solution and sensor files [from 1 to 17]; default: 10"""
    recordImagesInterval: float
    """simulated time between two images of the main view that are saved while the solver runs; negative: no images [s]; default: -1.0"""
    restartFileName: str
    """restart file, with its path; it takes the place of the one before when it is complete and on the disk, and the one before is kept under the same name with .bck behind; default: 'restartFile.txt'"""
    restartWritePeriod: float
    """simulated time between two updates of the restart file [s]; acts with writeRestartFile only; default: 0.01"""
    sensorsAppendToFile: bool
    """true: sensor values are appended to existing files and stored values; false: these are replaced; default: False"""
    sensorsStoreAndWriteFiles: bool
    """false: sensors neither write files nor store values; default: True"""
    sensorsWriteFileFooter: bool
    """write a footer to sensor files when the solver has finished; default: False"""
    sensorsWriteFileHeader: bool
    """write a header to sensor files; default: True"""
    sensorsWritePeriod: float
    """simulated time between two outputs of sensors, to file and memory; 0: every step [s]; default: 0.01"""
    solutionInformation: str
    """text that is written to the header of the solution file and shown in the render window; default: ''"""
    solutionWritePeriod: float
    """simulated time between two outputs to the solution file; 0: every step [s]; default: 0.01"""
    solverInformationFileName: str
    """file for the information of the solver, as much as ``verboseModeFile`` says; directories are created; default: 'solverInformation.txt'"""
    writeFileFooter: bool
    """write a footer with convergence and computation time to the solution file when the solver has finished; default: True"""
    writeFileHeader: bool
    """write a header to the solution file; default: True"""
    writeInitialValues: bool
    """write the state at the start to solution and sensor files; false avoids double lines when files are appended; default: True"""
    writeRestartFile: bool
    """write the restart file from time to time; default: False"""
    writeSolutionToFile: bool
    """write the solution file; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class StaticSolverArcLengthSettings(_Settings):
    """following a path of equilibria by its length instead of the load, over limit points and onto branches"""

    active: bool
    """true: each step has a length, the norm of the displacements of second order coordinates, and the load factor follows; the path ends at load factor 1 or at ``lowestLoadFactor``. The first step is as long as the displacements of one load step of ``numberOfLoadSteps``, and none changes the load by much more than such a step does. Solution and sensors are written after every step, with the quasi-time that belongs to the load; default: False"""
    branchStep: float
    """largest coordinate of the step along the null vector of the matrix by which the path leaves the first bifurcation point, positive or negative: two sides of a branch; 0: bifurcation points are passed [various]; acts with active only; default: 0.0"""
    desiredIterations: int
    """number of Newton iterations that steps are meant to take: longer steps follow those that took fewer, shorter steps those that took more [at least 1]; acts with active only; default: 4"""
    largestStep: float
    """largest length of a step, the norm of the displacements of all second order coordinates; 0: no bound [various]; acts with active only; default: 0.0"""
    lowestLoadFactor: float
    """load factor below which the path ends as well, where it turns back so far [1; at most 0]; acts with active only; default: -1.0"""
    maximumSteps: int
    """number of steps after which a path that has met neither of its ends is an error [at least 1]; acts with active only; default: 1000"""
    singularPoints: bool
    """true: look for steps in which an eigenvalue of the matrix changes its sign, and end a step at the point where it does; a few eigenvalues next to zero are followed; acts with active only; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class StaticSolverSettings(_Settings):
    """static solver: equilibrium under loads that are increased in steps"""

    adaptiveStep: bool
    """true: a load step that fails is repeated with a smaller step; false: it is an error; default: True"""
    adaptiveStepDecrease: float
    """factor of the step size when a step has failed [1; greater than 0 and less than 1]; acts with adaptiveStep only; default: 0.25"""
    adaptiveStepIncrease: float
    """factor of the step size when it may grow again after a reduction, up to its regular value; 1: it does not grow [1; at least 1]; acts with adaptiveStep only; default: 2.0"""
    adaptiveStepRecoveryIterations: int
    """a step counts for recovery if it took at most this number of Newton and discontinuous iterations; acts with adaptiveStep only; default: 7"""
    adaptiveStepRecoverySteps: int
    """number of steps after a reduction before the step size is increased; acts with adaptiveStep only; default: 4"""
    computeLoadsJacobian: bool
    """take derivatives of loads with respect to the coordinates into the Jacobian; needed for good convergence if loads depend on coordinates; default: True"""
    constrainODE1coordinates: bool
    """true: first order coordinates keep their initial values; false: they are found such that their time derivatives vanish; default: True"""
    loadStepDuration: float
    """quasi-time from the first to the last load step, as seen by loads that depend on time [s]; default: 1.0"""
    loadStepGeometric: bool
    """true: the load factors form a geometric series, for problems that need small first steps; false: equal load steps; default: False"""
    loadStepGeometricRange: float
    """range of the geometric series: load factor i of n is this number to the power (i - n)/(n - 1) [1; greater than 1]; acts with loadStepGeometric only; default: 1000.0"""
    loadStepStart: float
    """quasi-time at which the load steps start [s]; default: 0.0"""
    minimumStepSize: float
    """smallest step of the quasi-time; the solver stops with an error below it [s]; default: 1e-08"""
    numberOfLoadSteps: int
    """number of load steps; 1: the full load is applied at once; default: 1"""
    stabilizerODE2term: float
    """factor of a mass proportional term that is added to the Jacobian of the second order equations, and that fades out as one minus the square of the load factor: it needs several load steps. It finds equilibria of pendulums, which have no initial stiffness; 0: not used [1]; default: 0.0"""
    stepInformation: int
    """sum of numbers that select the contents of a line about a step: 1 remaining time, 2 Newton iterations, 4 Jacobians, 8 discontinuous iterations, 16 step size, 32 CPU time, 64 warnings when a step is reduced, 128 increases of the step size, 1024 every step; 0 shows the time only; default: 67"""
    useLoadFactor: bool
    """true: loads are multiplied with the load factor, which goes from 0 to 1; false: loads act in full, for loads that follow the quasi-time by themselves; default: True"""
    verboseMode: int
    """amount of output on the console: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5); default: 1"""
    verboseModeFile: int
    """amount of output in the solver information file: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5); default: 0"""
    @property
    def arcLength(self) -> StaticSolverArcLengthSettings: ...
    @arcLength.setter
    def arcLength(self, value: StaticSolverArcLengthSettings | dict[str, Any]) -> None: ...
    @property
    def discontinuous(self) -> DiscontinuousSettings: ...
    @discontinuous.setter
    def discontinuous(self, value: DiscontinuousSettings | dict[str, Any]) -> None: ...
    @property
    def newton(self) -> NewtonSettings: ...
    @newton.setter
    def newton(self, value: NewtonSettings | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class StepSizeControlSettings(_Settings):
    """step-size control by an error estimate"""

    implicitSolvers: bool
    """true: implicit solvers estimate the error of coordinates and velocities in each step, and repeat steps whose error is above the tolerances, if ``timeIntegration.automaticStepSize`` is true; false: they take equal steps; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class TimeIntegrationExplicitIntegrationSettings(_Settings):
    """explicit integrators"""

    computeEndOfStepAccelerations: bool
    """true: accelerations are evaluated at the end of each step; false: those of the last stage are shown, which saves one evaluation per step; default: True"""
    computeMassMatrixInversePerBody: bool
    """true: mass matrices are inverted body by body, which is fast but wrong if bodies share nodes; false: the system mass matrix is factorized; no effect: the mass matrix is always inverted in blocks that are not coupled, body by body where bodies share no nodes; default: False"""
    dynamicSolverType: DynamicSolverType
    """method that is used when the solver is called without one; default: DynamicSolverType.DOPRI5"""
    eliminateConstraints: bool
    """true: constraints that fix single coordinates to ground are eliminated; false: they are ignored; other constraints cannot be treated; default: True"""
    useLieGroupIntegration: bool
    """true: rotation vectors of Lie group nodes are updated by composition; needed for such nodes; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class TimeIntegrationGeneralizedAlphaSettings(_Settings):
    """generalized-alpha, Newmark and implicit trapezoidal integrators"""

    computeInitialAccelerations: bool
    """true: initial accelerations, and rates of first-order coordinates, are computed from the equations of motion, without the second time derivatives of prescribed motions of user functions; false: they are taken from the system or set to zero; default: True"""
    lieGroupAddTangentOperator: bool
    """true: the tangent operator of the Lie group nodes is part of the Jacobian, for better convergence; acts with lieGroupSimplifiedKinematicRelations only; default: True"""
    lieGroupSimplifiedKinematicRelations: bool
    """true: kinematic relations of Lie group nodes after Brüls and Cardona; false: more accurate ones; default: False"""
    newmarkBeta: float
    """parameter beta of the Newmark method; 1/4 with gamma 1/2 is the trapezoidal rule [1; greater than 0 and at most 1]; acts with useNewmark only; default: 0.25"""
    newmarkGamma: float
    """parameter gamma of the Newmark method; 1/2 gives no numerical damping [1; greater than 0 and at most 1.5]; acts with useNewmark only; default: 0.5"""
    resetAccelerations: bool
    """true: initial accelerations that are not computed are set to zero; false: they continue from the system; only without ``computeInitialAccelerations``; default: False"""
    spectralRadius: float
    """spectral radius at infinite frequency: 1 no numerical damping, 0 largest; has to be below 1 for constraints on position level [1; from 0 to 1]; default: 0.9"""
    storeInitialAlgebraicCoordinates: bool
    """true: the algebraic variables that belong to the computed initial accelerations become initial values; default: True"""
    useIndex2Constraints: bool
    """true: constraints are fulfilled on velocity level (index 2), and Euler parameters are divided by their length after each step; false: on position level (index 3); default: False"""
    useNewmark: bool
    """true: Newmark method with the parameters given here; false: generalized-alpha; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class TimeIntegrationSettings(_Settings):
    """time integration"""

    absoluteTolerance: float
    """absolute tolerance of the error control of explicit integrators, in the units of the coordinates [various; greater than 0]; default: 1e-08"""
    adaptiveStep: bool
    """true: an implicit step that fails is repeated with a smaller step size; false: it is an error; default: True"""
    adaptiveStepDecrease: float
    """factor of the step size when a step has failed [1; greater than 0 and less than 1]; acts with adaptiveStep or automaticStepSize only; default: 0.5"""
    adaptiveStepIncrease: float
    """factor of the step size when it may grow again after a reduction, up to its regular value; 1: it does not grow [1; at least 1]; acts with adaptiveStep or automaticStepSize only; default: 2.0"""
    adaptiveStepRecoveryIterations: int
    """a step counts for recovery if it took at most this number of Newton and discontinuous iterations; acts with adaptiveStep or automaticStepSize only; default: 7"""
    adaptiveStepRecoverySteps: int
    """number of steps after a reduction before the step size is increased; acts with adaptiveStep or automaticStepSize only; default: 10"""
    automaticStepSize: bool
    """true: integrators with an error estimate choose the step size; (endTime - startTime)/numberOfSteps is its upper bound; false: constant step size; default: True"""
    computeLoadsJacobian: int
    """derivatives of loads in the Jacobian of implicit integrators: no derivatives (0), with respect to the coordinates (1), also with respect to the velocities (2) [from 0 to 2]; default: 0"""
    endTime: float
    """time at which the integration ends [s]; default: 1.0"""
    initialStepSize: float
    """first step size when the step size is automatic; 0: the largest step size [s]; default: 0.0"""
    minimumStepSize: float
    """lower bound of the step size; an implicit solver that would need a smaller one stops with an error; automatic step sizes continue at the bound with a warning, and stop with an error if 100 steps in a row exceed the tolerances [s]; default: 1e-08"""
    numberOfSteps: float
    """number of steps of equal size from startTime to endTime; a whole number, but for rounding [1; from 1 to 1e+15]; default: 100.0"""
    realtimeFactor: float
    """simulated seconds per second of real time when simulating in real time: greater than 1 is fast motion, smaller than 1 slow motion [1]; acts with simulateInRealtime only; default: 1.0"""
    realtimeWaitMicroseconds: int
    """waiting time in microseconds between two looks at the clock when simulating in real time; small values are more accurate and cost more CPU time; acts with simulateInRealtime only; default: 1000"""
    relativeTolerance: float
    """relative tolerance of the error control of explicit integrators [1; from 0 to 1]; default: 1e-08"""
    reuseConstantMassMatrix: bool
    """true: mass matrices that do not depend on the state are computed once, and again when parameters of objects have changed; false: they are computed in every evaluation; default: True"""
    simulateInRealtime: bool
    """true: the solver waits until real time has caught up with the simulated time; it does not wait when it is too slow; default: False"""
    startTime: float
    """time at which the integration starts [s]; default: 0.0"""
    stepInformation: int
    """sum of numbers that select the contents of a line about a step: 1 remaining time, 2 Newton iterations, 4 Jacobians, 8 discontinuous iterations, 16 step size, 32 CPU time, 64 warnings when a step is reduced, 128 increases of the step size, 1024 every step; 0 shows the time only; default: 67"""
    solverType: DynamicSolverType
    """method of ``SolveDynamic`` when it is called without ``solverType``; ``MainSolverExplicit`` uses it if it is an explicit one, else ``explicitIntegration.dynamicSolverType``; default: DynamicSolverType.GeneralizedAlpha"""
    stepSizeMaxIncrease: float
    """largest factor by which the automatic step size grows from one step to the next [1; at least 1]; default: 2.0"""
    stepSizeSafety: float
    """factor of the step size that the error estimate allows; smaller values avoid rejected steps [1; greater than 0 and at most 1]; default: 0.9"""
    verboseMode: int
    """amount of output on the console: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5); default: 0"""
    verboseModeFile: int
    """amount of output in the solver information file: no output (0), occasional lines (1), a line per step (2), also the solution (3), mass matrix and Jacobian (4), inverse of the Jacobian (5); default: 0"""
    @property
    def discontinuous(self) -> DiscontinuousSettings: ...
    @discontinuous.setter
    def discontinuous(self, value: DiscontinuousSettings | dict[str, Any]) -> None: ...
    @property
    def explicitIntegration(self) -> TimeIntegrationExplicitIntegrationSettings: ...
    @explicitIntegration.setter
    def explicitIntegration(self, value: TimeIntegrationExplicitIntegrationSettings | dict[str, Any]) -> None: ...
    @property
    def generalizedAlpha(self) -> TimeIntegrationGeneralizedAlphaSettings: ...
    @generalizedAlpha.setter
    def generalizedAlpha(self, value: TimeIntegrationGeneralizedAlphaSettings | dict[str, Any]) -> None: ...
    @property
    def newton(self) -> NewtonSettings: ...
    @newton.setter
    def newton(self, value: NewtonSettings | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class SimulationSettings(_Settings):
    """settings of the solvers: time integration, static solver, linear algebra, output and threads"""

    cleanUpMemory: bool
    """true: the solver frees its memory when it has finished; false: it keeps it for the next computation; default: False"""
    displayComputationTime: bool
    """print how the computation time is distributed when the solver has finished; default: False"""
    displayGlobalTimers: bool
    """print global timers when the solver has finished; no effect: there are no global timers; displayComputationTime shows where time goes; default: True"""
    displayStatistics: bool
    """print numbers of steps, iterations, Jacobians and rejected steps when the solver has finished; default: False"""
    linearSolverType: LinearSolverType
    """direct solver of the linear systems; default: LinearSolverType.EXUdense"""
    outputPrecision: int
    """number of significant digits in texts on the console [from 1 to 17]; default: 6"""
    pauseAfterEachStep: bool
    """wait for the space bar in the renderer after each step; no effect: solvers wait where space is pressed on the page; a PostStep user function may wait; default: False"""
    @property
    def continuation(self) -> ContinuationSettings: ...
    @continuation.setter
    def continuation(self, value: ContinuationSettings | dict[str, Any]) -> None: ...
    @property
    def denseOutput(self) -> DenseOutputSettings: ...
    @denseOutput.setter
    def denseOutput(self, value: DenseOutputSettings | dict[str, Any]) -> None: ...
    @property
    def events(self) -> EventsSettings: ...
    @events.setter
    def events(self, value: EventsSettings | dict[str, Any]) -> None: ...
    @property
    def initialConditions(self) -> InitialConditionsSettings: ...
    @initialConditions.setter
    def initialConditions(self, value: InitialConditionsSettings | dict[str, Any]) -> None: ...
    @property
    def linearSolverChoice(self) -> LinearSolverChoiceSettings: ...
    @linearSolverChoice.setter
    def linearSolverChoice(self, value: LinearSolverChoiceSettings | dict[str, Any]) -> None: ...
    @property
    def linearSolverSettings(self) -> LinearSolverSettings: ...
    @linearSolverSettings.setter
    def linearSolverSettings(self, value: LinearSolverSettings | dict[str, Any]) -> None: ...
    @property
    def parallel(self) -> ParallelSettings: ...
    @parallel.setter
    def parallel(self, value: ParallelSettings | dict[str, Any]) -> None: ...
    @property
    def redundantConstraints(self) -> RedundantConstraintsSettings: ...
    @redundantConstraints.setter
    def redundantConstraints(self, value: RedundantConstraintsSettings | dict[str, Any]) -> None: ...
    @property
    def solutionSettings(self) -> SolutionSettings: ...
    @solutionSettings.setter
    def solutionSettings(self, value: SolutionSettings | dict[str, Any]) -> None: ...
    @property
    def staticSolver(self) -> StaticSolverSettings: ...
    @staticSolver.setter
    def staticSolver(self, value: StaticSolverSettings | dict[str, Any]) -> None: ...
    @property
    def stepSizeControl(self) -> StepSizeControlSettings: ...
    @stepSizeControl.setter
    def stepSizeControl(self, value: StepSizeControlSettings | dict[str, Any]) -> None: ...
    @property
    def timeIntegration(self) -> TimeIntegrationSettings: ...
    @timeIntegration.setter
    def timeIntegration(self, value: TimeIntegrationSettings | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsViewCamera(_Settings):
    """camera of a view"""

    @property
    def cameraPosition(self) -> list[float]:
        """shift of the camera, in the frame of the view; relative to the tracked marker if there is one [3; m]; no effect: the view follows from its center, rotation and zoom; default: [0.0, 0.0, 0.0]"""
    @cameraPosition.setter
    def cameraPosition(self, value: ArrayLike) -> None: ...
    clippingPlaneDistance: float
    """distance of the clipping plane from the origin, along its normal [m]; default: 0.0"""
    @property
    def clippingPlaneNormal(self) -> list[float]:
        """normal of a plane behind which faces are not drawn, the half-space in direction of the normal being cut off; zeros: no clipping [3; 1]; default: [0.0, 0.0, 0.0]"""
    @clippingPlaneNormal.setter
    def clippingPlaneNormal(self, value: ArrayLike) -> None: ...
    modelCentricView: bool
    """true: zooming and rotating move the model and the camera sees all of it; false: the camera moves through the model; no effect: views always turn about their center; default: True"""
    @property
    def nearFarPlaneOffset(self) -> list[float]:
        """nearest and farthest visible distance (m), and a number that is 1 to use them and 0 to compute them from the size of the scene [3; various]; no effect: nothing is too near or too far away to be drawn; default: [0.0, 0.0, 0.0]"""
    @nearFarPlaneOffset.setter
    def nearFarPlaneOffset(self, value: ArrayLike) -> None: ...
    perspective: float
    """amount of perspective, the tangent of half the field of view; 0: parallel projection [1]; default: 0.0"""
    trackMarker: int
    """number of the marker that the view follows; -1: none; no effect on pages: pages look from where their readers want; default: -1"""
    trackMarkerMbsNumber: int
    """number of the system in the container that the tracked marker belongs to; the first is 0; no effect on pages: pages look from where their readers want; default: 0"""
    @property
    def trackMarkerOrientation(self) -> list[float]:
        """1 in all three components to follow the rotation of the marker, zeros to keep the direction of view [3; 1]; no effect on pages: pages look from where their readers want; default: [0.0, 0.0, 0.0]"""
    @trackMarkerOrientation.setter
    def trackMarkerOrientation(self, value: ArrayLike) -> None: ...
    @property
    def trackMarkerPosition(self) -> list[float]:
        """for x, y and z: 1 to follow the marker in this direction, 0 not to [3; 1]; no effect on pages: pages look from where their readers want; default: [1.0, 1.0, 1.0]"""
    @trackMarkerPosition.setter
    def trackMarkerPosition(self, value: ArrayLike) -> None: ...
    useRaytracer: bool
    """true: images are made by the ray tracer; no effect on pages: pages have no rays; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsViewScene(_Settings):
    """contents of a view"""

    drawCoordinateSystem: int
    """coordinate system in the corner: 0 hidden, 1 lines with text, 2 arrows, 3 arrows with text; no effect on pages: pages have lights, lines and words of their own; default: 2"""
    drawWorldBasis: bool
    """draw the global frame at the origin; that of view0 is for all views; default: False"""
    facesTransparent: bool
    """draw all faces transparent; default: False"""
    showFaceEdges: bool
    """draw the edges of faces; default: False"""
    showFaces: bool
    """draw faces; faces off and edges on give a wire frame; default: True"""
    showLines: bool
    """draw lines, other than edges; no effect on pages: pages have lights, lines and words of their own; default: True"""
    showMeshEdges: bool
    """draw the edges of finite elements; that of view0 is for all views; default: True"""
    showMeshFaces: bool
    """draw the faces of finite elements; that of view0 is for all views; default: True"""
    worldBasisSize: float
    """length of the axes of the global frame [m]; that of view0 is for all views; default: 1.0"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsViewWindow(_Settings):
    """window of a view"""

    alwaysOnTop: bool
    """the window stays above other windows; no effect: pages are in windows of the browser, with its mouse; default: False"""
    globalFontSize: float
    """size of the font, about in pixels [1]; no effect on pages: pages have lights, lines and words of their own; default: 12.0"""
    lockModelView: bool
    """mouse and keys do not change the view; no effect: pages are in windows of the browser, with its mouse; default: False"""
    maximize: bool
    """open the window in full size; no effect: pages are in windows of the browser, with its mouse; default: False"""
    @property
    def renderWindowSize(self) -> list[int]:
        """width and height of the window at the start, in pixels [2]; default: [1024, 768]"""
    @renderWindowSize.setter
    def renderWindowSize(self, value: Sequence[int]) -> None: ...
    showComputationInfo: bool
    """show version, solver and other information in the window; no effect on pages: pages have lights, lines and words of their own; default: True"""
    showMouseCoordinates: bool
    """show the position of the mouse in the model and its distance from the last click; no effect: pages are in windows of the browser, with its mouse; default: False"""
    showRenderStateInfo: bool
    """show zoom, center and rotation of the view; no effect: pages are in windows of the browser, with its mouse; default: False"""
    showWindow: bool
    """true: the window is shown at the start; false: it starts as an icon; no effect: pages are in windows of the browser, with its mouse; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsView(_Settings):
    """a view of the model"""

    @property
    def camera(self) -> VSettingsViewCamera: ...
    @camera.setter
    def camera(self, value: VSettingsViewCamera | dict[str, Any]) -> None: ...
    @property
    def scene(self) -> VSettingsViewScene: ...
    @scene.setter
    def scene(self, value: VSettingsViewScene | dict[str, Any]) -> None: ...
    @property
    def window(self) -> VSettingsViewWindow: ...
    @window.setter
    def window(self, value: VSettingsViewWindow | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsLight(_Settings):
    """one light"""

    constantAttenuation: float
    """constant term of the attenuation, whose inverse weakens the light; used for lights with a position, by the ray tracer only [1]; no effect on pages: pages have lights, lines and words of their own; default: 1.0"""
    diffuse: float
    """strength of the light that is scattered by faces [1]; no effect on pages: pages have lights, lines and words of their own; default: 0.5"""
    enable: bool
    """switch the light on; no effect on pages: pages have lights, lines and words of their own; default: True"""
    lightRadius: float
    """radius of the light for soft shadows; a light at infinity is as large as it would be at its position [m]; no effect on pages: pages have lights, lines and words of their own; no effect without rays: only the ray tracer has it, see view0.camera.useRaytracer; default: 0.1"""
    linearAttenuation: float
    """term of the attenuation that grows with the distance; used for lights with a position [1/m]; no effect on pages: pages have lights, lines and words of their own; no effect without rays: only the ray tracer has it, see view0.camera.useRaytracer; default: 0.0"""
    @property
    def position(self) -> list[float]:
        """position of the light if the fourth number is 1; direction towards a light at infinity if it is 0 [4; m]; no effect on pages: pages have lights, lines and words of their own; default: [2.0, 2.0, 10.0, 0.0]"""
    @position.setter
    def position(self, value: ArrayLike) -> None: ...
    quadraticAttenuation: float
    """term of the attenuation that grows with the square of the distance; used for lights with a position [1/m^2]; no effect on pages: pages have lights, lines and words of their own; no effect without rays: only the ray tracer has it, see view0.camera.useRaytracer; default: 0.0"""
    shadow: float
    """whether this light casts shadows, which are those of the ray tracer: any number above 0, however large; shadows cost rendering time [1]; no effect on pages: pages have lights, lines and words of their own; no effect without rays: only the ray tracer has it, see view0.camera.useRaytracer; default: 0.0"""
    specular: float
    """strength of highlights [1]; no effect on pages: pages have lights, lines and words of their own; default: 0.5"""
    useCameraFrame: bool
    """true: position and direction are fixed to the camera; false: to the model; without the ray tracer, lights turn with the viewer, as do those whose position is the default; no effect on pages: pages have lights, lines and words of their own; no effect without rays: only the ray tracer has it, see view0.camera.useRaytracer; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsMaterial(_Settings):
    """a material of the ray tracer"""

    alpha: float
    """opacity, from 0 to 1 [1]; default: 1.0"""
    @property
    def baseColor(self) -> list[float]:
        """red, green and blue of faces without a color of their own [3; 1]; default: [0.4, 0.4, 0.9]"""
    @baseColor.setter
    def baseColor(self, value: ArrayLike) -> None: ...
    @property
    def emission(self) -> list[float]:
        """red, green and blue of light that the material emits [3; 1]; default: [0.0, 0.0, 0.0]"""
    @emission.setter
    def emission(self, value: ArrayLike) -> None: ...
    ior: float
    """index of refraction of transparent materials; 1: none [1]; default: 1.0"""
    name: str
    """name of the material; no effect: materials are known by their numbers; default: 'default'"""
    reflectivity: float
    """share of light that is reflected, from 0 (rough) to 1 (mirror); costs rendering time [1]; default: 0.0"""
    shininess: float
    """sharpness of highlights; below 5 dull, above 50 glossy [1]; default: 32.0"""
    @property
    def specular(self) -> list[float]:
        """red, green and blue of highlights [3; 1]; default: [0.6, 0.6, 0.6]"""
    @specular.setter
    def specular(self, value: ArrayLike) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsNodes(_Settings):
    """drawing of nodes"""

    basisSize: float
    """length of the axes of node frames [m]; default: 0.2"""
    @property
    def defaultColor(self) -> list[float]:
        """red, green, blue and opacity of nodes without a color of their own, each from 0 to 1 [4; 1]; default: [0.2, 0.2, 1.0, 1.0]"""
    @defaultColor.setter
    def defaultColor(self, value: ArrayLike) -> None: ...
    defaultSize: float
    """size of nodes without a size of their own; negative: chosen from the size of the scene [m]; default: -1.0"""
    drawNodesAsPoint: bool
    """true: nodes are points of the size ``general.pointSize`` and frames are lines, which is fast; false: spheres or circles; no effect: nodes are balls; default: True"""
    show: bool
    """draw nodes; default: True"""
    showBasis: bool
    """draw the axes of nodes with orientation; default: False"""
    showNodalSlopes: int
    """draw the slope vectors of nodes that have them; 0: no; default: 0"""
    showNumbers: bool
    """draw the numbers of nodes; default: False"""
    tiling: int
    """number of segments of a node that is drawn as a sphere; circles have four times as many; no effect: spheres are round; default: 4"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsBodiesBeams(_Settings):
    """drawing of beams and cables"""

    axialTiling: int
    """number of segments along the axis of a beam element; default: 8"""
    crossSectionFilled: bool
    """true: cross sections are solid, if the element can do so; false: wire frame; no effect: cross sections are solid; default: True"""
    crossSectionTiling: int
    """number of faces over the height of a beam that is drawn flat; default: 4"""
    drawVertical: bool
    """draw the contour variable as a diagram normal to the beam axis; default: False"""
    @property
    def drawVerticalColor(self) -> list[float]:
        """red, green, blue and opacity of the diagram along the beam axis, each from 0 to 1 [4; 1]; default: [0.2, 0.2, 0.2, 1.0]"""
    @drawVerticalColor.setter
    def drawVerticalColor(self, value: ArrayLike) -> None: ...
    drawVerticalFactor: float
    """length in the drawing (m) per unit of the contour variable [various]; default: 1.0"""
    drawVerticalLines: bool
    """draw lines from the beam axis to the diagram; default: True"""
    drawVerticalOffset: float
    """value that is added to the contour variable before it is scaled [various]; default: 0.0"""
    drawVerticalValues: bool
    """write values at the lines of the diagram; they are interpolated ones; default: False"""
    reducedAxialInterploation: bool
    """true: contour variables are interpolated along the axis with a lower order, which hides oscillations; false: like the element; no effect: numbers along a beam are those of its points; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsBodiesKinematicTree(_Settings):
    """drawing of kinematic trees"""

    frameSize: float
    """length of the axes of joint and center of mass frames [m]; default: 0.2"""
    showCOMframes: bool
    """draw a frame at the center of mass of each link; default: False"""
    showFramesNumbers: bool
    """write object and link numbers at the frames; default: False"""
    showJointFrames: bool
    """draw a frame at each joint of trees without graphics data, whose links would hide it; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsBodiesShells(_Settings):
    """drawing of plates and shells"""

    drawSolid: bool
    """true: with thickness; false: the mid-surface only; default: True"""
    thicknessFactor: float
    """factor of the thickness in the drawing [1]; default: 1.0"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsBodies(_Settings):
    """drawing of bodies"""

    @property
    def defaultColor(self) -> list[float]:
        """red, green, blue and opacity of bodies without a color of their own, each from 0 to 1 [4; 1]; default: [0.3, 0.3, 1.0, 1.0]"""
    @defaultColor.setter
    def defaultColor(self, value: ArrayLike) -> None: ...
    @property
    def defaultSize(self) -> list[float]:
        """edge lengths in x, y and z of the block that stands for a body without shapes [3; m]; no effect: bodies without shapes are drawn as large as their markers say; default: [1.0, 1.0, 1.0]"""
    @defaultSize.setter
    def defaultSize(self, value: ArrayLike) -> None: ...
    deformationScaleFactor: float
    """factor of the deformation of finite element meshes in floating frame bodies [1]; default: 1.0"""
    show: bool
    """draw bodies; default: True"""
    showNumbers: bool
    """draw the numbers of bodies; default: False"""
    @property
    def beams(self) -> VSettingsBodiesBeams: ...
    @beams.setter
    def beams(self, value: VSettingsBodiesBeams | dict[str, Any]) -> None: ...
    @property
    def kinematicTree(self) -> VSettingsBodiesKinematicTree: ...
    @kinematicTree.setter
    def kinematicTree(self, value: VSettingsBodiesKinematicTree | dict[str, Any]) -> None: ...
    @property
    def shells(self) -> VSettingsBodiesShells: ...
    @shells.setter
    def shells(self, value: VSettingsBodiesShells | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsConnectors(_Settings):
    """drawing of connectors, joints and constraints"""

    contactPointsDefaultSize: float
    """size of contact points; no effect, see ``contact.contactPointsDefaultSize`` [m]; no effect: contacts are drawn as the shapes that touch; default: 0.02"""
    @property
    def defaultColor(self) -> list[float]:
        """red, green, blue and opacity of connectors without a color of their own, each from 0 to 1 [4; 1]; default: [0.2, 0.2, 1.0, 1.0]"""
    @defaultColor.setter
    def defaultColor(self, value: ArrayLike) -> None: ...
    defaultSize: float
    """size of connectors without a size of their own; negative: chosen from the size of the scene [m]; default: 0.1"""
    jointAxesLength: float
    """length of joint axes [m]; default: 0.2"""
    jointAxesRadius: float
    """radius of joint axes [m]; no effect: the axes of frames have the proportions of all frames; default: 0.02"""
    show: bool
    """draw connectors; default: True"""
    showContact: bool
    """draw contact points and lines of contacts between circles and cables; no effect: contacts are drawn as the shapes that touch; default: False"""
    showJointAxes: bool
    """draw the axes of joints in space; default: False"""
    showNumbers: bool
    """draw the numbers of connectors; default: False"""
    springNumberOfWindings: int
    """number of windings of springs; more than 500 are drawn as 500; default: 8"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsMarkers(_Settings):
    """drawing of markers"""

    @property
    def defaultColor(self) -> list[float]:
        """red, green, blue and opacity of markers without a color of their own, each from 0 to 1 [4; 1]; default: [0.1, 0.5, 0.1, 1.0]"""
    @defaultColor.setter
    def defaultColor(self, value: ArrayLike) -> None: ...
    defaultSize: float
    """size of markers without a size of their own; negative: chosen from the size of the scene [m]; default: -1.0"""
    drawSimplified: bool
    """draw markers with simple symbols; no effect: markers are cubes; default: True"""
    show: bool
    """draw markers; default: True"""
    showNumbers: bool
    """draw the numbers of markers; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsLoads(_Settings):
    """drawing of loads"""

    @property
    def defaultColor(self) -> list[float]:
        """red, green, blue and opacity of loads without a color of their own, each from 0 to 1 [4; 1]; default: [0.7, 0.1, 0.1, 1.0]"""
    @defaultColor.setter
    def defaultColor(self, value: ArrayLike) -> None: ...
    defaultRadius: float
    """radius of load arrows [m]; default: 0.005"""
    defaultSize: float
    """size of loads without a size of their own; negative: chosen from the size of the scene [m]; default: 0.2"""
    drawSimplified: bool
    """draw loads with simple symbols; no effect: loads are arrows; default: True"""
    drawWithUserFunction: bool
    """true: loads with user functions are drawn with their current value; needs ``fixedLoadSize`` false to show more than the direction; no effect: loads are drawn as they are given; default: True"""
    fixedLoadSize: bool
    """true: arrows of loads have the same length; false: the length is proportional to the load; default: True"""
    loadSizeFactor: float
    """length of an arrow (m) per unit of the load (N or Nm), if ``fixedLoadSize`` is false [various]; default: 0.1"""
    show: bool
    """draw loads; default: True"""
    showNumbers: bool
    """draw the numbers of loads; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsSensorsTraces(_Settings):
    """traces of sensors in the render window"""

    lineWidth: float
    """width of trace lines in pixels [1]; no effect on pages: pages have lights, lines and words of their own; default: 2.0"""
    @property
    def listOfPositionSensors(self) -> list[int]:
        """numbers of the position sensors whose traces are drawn; they have to store their values; empty: all position sensors [n]; default: []"""
    @listOfPositionSensors.setter
    def listOfPositionSensors(self, value: Sequence[int]) -> None: ...
    @property
    def listOfTriadSensors(self) -> list[int]:
        """numbers of sensors of rotation matrices whose axes are drawn along the traces; each position sensor in the list has one [n]; default: []"""
    @listOfTriadSensors.setter
    def listOfTriadSensors(self, value: Sequence[int]) -> None: ...
    @property
    def listOfVectorSensors(self) -> list[int]:
        """numbers of sensors of vectors that are drawn along the traces; each position sensor in the list has one [n]; default: []"""
    @listOfVectorSensors.setter
    def listOfVectorSensors(self, value: Sequence[int]) -> None: ...
    positionsShowEvery: int
    """only every position of this number is part of the trace; default: 1"""
    sensorsMbsNumber: int
    """number of the system in the container that the sensors belong to; the first is 0; default: 0"""
    showCurrent: bool
    """draw the values at the time that is shown; default: True"""
    showFuture: bool
    """draw the trace after the time that is shown, as far as it is known; default: False"""
    showPast: bool
    """draw the trace before the time that is shown; default: True"""
    showPositionTrace: bool
    """draw traces of positions; default: False"""
    showTriads: bool
    """draw axes along the traces; default: False"""
    showVectors: bool
    """draw vectors along the traces; default: False"""
    timeSpan: float
    """length of the trace in simulated time, into past and future; 0: not limited [s]; default: 0.0"""
    @property
    def traceColors(self) -> list[float]:
        """red, green, blue and opacity of the traces one after the other, four numbers per trace; used again from the start if there are more traces [n; 1]; default: [0.2, 0.2, 0.2, 1.0, 0.8, 0.2, 0.2, 1.0, 0.2, 0.8, 0.2, 1.0, 0.2, 0.2, 0.8, 1.0, 0.2, 0.8, 0.8, 1.0, 0.8, 0.2, 0.8, 1.0, 0.8, 0.4, 0.1, 1.0]"""
    @traceColors.setter
    def traceColors(self, value: ArrayLike) -> None: ...
    triadSize: float
    """length of the axes along the traces [m]; default: 0.1"""
    triadsShowEvery: int
    """only axes of every position of this number are drawn; default: 1"""
    vectorScaling: float
    """length in the drawing (m) per unit of the vector [various]; default: 0.01"""
    vectorsShowEvery: int
    """only vectors of every position of this number are drawn; default: 1"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsSensors(_Settings):
    """drawing of sensors"""

    @property
    def defaultColor(self) -> list[float]:
        """red, green, blue and opacity of sensors without a color of their own, each from 0 to 1 [4; 1]; default: [0.6, 0.6, 0.1, 1.0]"""
    @defaultColor.setter
    def defaultColor(self, value: ArrayLike) -> None: ...
    defaultSize: float
    """size of sensors without a size of their own; negative: chosen from the size of the scene [m]; default: -1.0"""
    drawSimplified: bool
    """draw sensors with simple symbols; no effect: sensors are cubes; default: True"""
    show: bool
    """draw sensors; default: True"""
    showNumbers: bool
    """draw the numbers of sensors; default: False"""
    @property
    def traces(self) -> VSettingsSensorsTraces: ...
    @traces.setter
    def traces(self, value: VSettingsSensorsTraces | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsContourAdvanced(_Settings):
    """color scale of contours"""

    colorBarPrecision: int
    """number of significant digits in the color bar, 16 at most; no effect on pages: pages have lights, lines and words of their own; default: 4"""
    colorBarTiling: int
    """number of steps of the color bar; no effect on pages: pages have lights, lines and words of their own; default: 12"""
    @property
    def contourColor0(self) -> list[float]:
        """color at the start of the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.1, 0.1, 0.9, 1.0]"""
    @contourColor0.setter
    def contourColor0(self, value: ArrayLike) -> None: ...
    @property
    def contourColor1(self) -> list[float]:
        """color at one quarter of the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.1, 0.9, 0.9, 1.0]"""
    @contourColor1.setter
    def contourColor1(self, value: ArrayLike) -> None: ...
    @property
    def contourColor2(self) -> list[float]:
        """color at the middle of the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.1, 0.9, 0.1, 1.0]"""
    @contourColor2.setter
    def contourColor2(self, value: ArrayLike) -> None: ...
    @property
    def contourColor3(self) -> list[float]:
        """color at three quarters of the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.9, 0.9, 0.1, 1.0]"""
    @contourColor3.setter
    def contourColor3(self, value: ArrayLike) -> None: ...
    @property
    def contourColor4(self) -> list[float]:
        """color at the end of the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.9, 0.1, 0.1, 1.0]"""
    @contourColor4.setter
    def contourColor4(self, value: ArrayLike) -> None: ...
    @property
    def contourColorMax(self) -> list[float]:
        """color of values above the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.9, 0.9, 0.9, 1.0]"""
    @contourColorMax.setter
    def contourColorMax(self, value: ArrayLike) -> None: ...
    @property
    def contourColorMin(self) -> list[float]:
        """color of values below the range: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; default: [0.1, 0.1, 0.1, 1.0]"""
    @contourColorMin.setter
    def contourColorMin(self, value: ArrayLike) -> None: ...
    showColorBar: bool
    """show the color bar; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsContour(_Settings):
    """coloring by an output variable"""

    alphaTransparency: float
    """opacity of contour colors, from 0 to 1 [1]; default: 1.0"""
    automaticRange: bool
    """true: the colors span the values that occur; false: from ``minValue`` to ``maxValue``; default: True"""
    maxValue: float
    """largest value of the color scale, in the unit of the output variable [various]; default: 1.0"""
    minValue: float
    """smallest value of the color scale, in the unit of the output variable [various]; default: 0.0"""
    nodesColored: bool
    """color nodes as well; default: True"""
    outputVariable: OutputVariableType
    """output variable that is shown as color; ``_None``: none; default: OutputVariableType._None"""
    outputVariableComponent: int
    """component of the output variable, from 0; -1: its norm; default: 0"""
    reduceRange: bool
    """true: an automatic range shrinks with the values, which suits static computations; false: it only grows; default: True"""
    rigidBodiesColored: bool
    """color rigid bodies and mass points as well; default: True"""
    @property
    def advanced(self) -> VSettingsContourAdvanced: ...
    @advanced.setter
    def advanced(self, value: VSettingsContourAdvanced | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsContact(_Settings):
    """drawing of general contact"""

    @property
    def colorBoundingBoxes(self) -> list[float]:
        """red, green, blue and opacity of bounding boxes, each from 0 to 1 [4; 1]; default: [0.9, 0.1, 0.1, 1.0]"""
    @colorBoundingBoxes.setter
    def colorBoundingBoxes(self, value: ArrayLike) -> None: ...
    @property
    def colorSearchTree(self) -> list[float]:
        """red, green, blue and opacity of the search tree, each from 0 to 1 [4; 1]; default: [0.1, 0.1, 0.9, 1.0]"""
    @colorSearchTree.setter
    def colorSearchTree(self, value: ArrayLike) -> None: ...
    @property
    def colorSpheres(self) -> list[float]:
        """red, green, blue and opacity of contact spheres, each from 0 to 1 [4; 1]; default: [0.8, 0.5, 0.2, 1.0]"""
    @colorSpheres.setter
    def colorSpheres(self, value: ArrayLike) -> None: ...
    @property
    def colorTori(self) -> list[float]:
        """red, green, blue and opacity of contact tori, each from 0 to 1 [4; 1]; no effect: general contact has no tori; default: [0.8, 0.2, 0.8, 1.0]"""
    @colorTori.setter
    def colorTori(self, value: ArrayLike) -> None: ...
    @property
    def colorTriangles(self) -> list[float]:
        """red, green, blue and opacity of contact triangles, each from 0 to 1 [4; 1]; default: [0.5, 0.5, 0.5, 1.0]"""
    @colorTriangles.setter
    def colorTriangles(self, value: ArrayLike) -> None: ...
    contactForcesFactor: float
    """length of a contact force in the drawing per newton [m/N]; default: 0.001"""
    contactPointsDefaultSize: float
    """size of contact points, and twice the width of forces; negative, or not set: chosen from the size of the scene [m]; default: 0.001"""
    showBoundingBoxes: bool
    """draw the bounding boxes of contact partners; slow if there are many; default: False"""
    showContactForces: bool
    """draw points of contact in general contact, and the forces there on the spheres; default: False"""
    showContactForcesValues: bool
    """write the values of contact forces that are drawn, in newton; default: False"""
    showSearchTree: bool
    """draw the outer box of the search tree, where SetSearchTreeBox has given one; default: False"""
    showSearchTreeCells: bool
    """draw all cells of the search tree, where its box and SetSearchTreeCellSize have given them, the redder the more partners they hold; slow if there are many; default: False"""
    showSpheres: bool
    """draw contact spheres; default: False"""
    showTori: bool
    """draw contact tori; no effect: general contact has no tori; default: False"""
    showTriangles: bool
    """draw contact triangles; default: False"""
    tilingCurves: int
    """number of segments of contact curves; no effect: general contact has no curves of its own; default: 8"""
    tilingSpheres: int
    """number of segments of contact spheres; no effect: spheres are round; default: 4"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsOpenGLAdvanced(_Settings):
    """OpenGL renderer: initial view, lighting and text"""

    @property
    def clippingPlaneColor(self) -> list[float]:
        """red, green and blue of cut faces at a clipping plane; the fourth number chooses the color: 0 nothing is drawn, 1 this color, 2 the color of the body [4; 1]; no effect: cut faces are not closed; default: [0.7, 0.5, 0.5, 0.0]"""
    @clippingPlaneColor.setter
    def clippingPlaneColor(self, value: ArrayLike) -> None: ...
    depthSorting: bool
    """true: faces are sorted by depth, so that transparent ones are drawn correctly, at more cost; no effect: transparent faces are always sorted; default: False"""
    enableLighting: bool
    """true: faces are lit; false: plain colors; no effect on pages: pages have lights, lines and words of their own; default: True"""
    @property
    def faceNormalsColor(self) -> list[float]:
        """red, green, blue and opacity of normals of faces, each from 0 to 1 [4; 1]; default: [0.8, 0.2, 0.2, 1.0]"""
    @faceNormalsColor.setter
    def faceNormalsColor(self, value: ArrayLike) -> None: ...
    @property
    def initialCenterPoint(self) -> list[float]:
        """point of the model in the middle of the window at the start; only without ``general.autoFitScene`` and with a model centric view [3; m]; default: [0.0, 0.0, 0.0]"""
    @initialCenterPoint.setter
    def initialCenterPoint(self, value: ArrayLike) -> None: ...
    initialMaxSceneSize: float
    """size of the scene at the start; only without ``general.autoFitScene`` [m]; no effect: the size is found from what is drawn; default: 1.0"""
    @property
    def initialModelRotation(self) -> list[list[float]]:
        """rotation matrix of the view at the start; only with a model centric view [3 x 3; 1]; default: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]"""
    @initialModelRotation.setter
    def initialModelRotation(self, value: ArrayLike) -> None: ...
    initialZoom: float
    """zoom at the start; only without ``general.autoFitScene`` [1; greater than 0]; default: 1.0"""
    lightModelLocalViewer: bool
    """true: highlights are computed with the position of the camera; false: with the direction of view only; no effect: highlights are those of a viewer far away; default: False"""
    lightModelTwoSide: bool
    """light the back of faces too; no effect: both sides of faces are always lit; default: False"""
    lineSmooth: bool
    """smooth lines; no effect: lines are always smooth; default: True"""
    polygonOffset: float
    """shift of faces away from the viewer, so that lines on them stay visible [1]; no effect: lines on faces are seen anyway; default: 0.05"""
    shadeModelSmooth: bool
    """true: shading is interpolated between the corners of faces; false: one shade per face; no effect on pages: pages have lights, lines and words of their own; default: True"""
    shadowPolygonOffset: float
    """shift of shadows against artifacts; smaller for large scenes, larger for thin bodies [1]; no effect: there are no shadows; default: 0.1"""
    showBoundingBox: bool
    """draw the bounding box of the scene that zooming to all uses; default: False"""
    textLineSmooth: bool
    """smooth the lines of text; no effect: texts are drawn with a font of outlines; default: False"""
    textLineWidth: float
    """width of the lines of text in pixels [1]; no effect: texts are drawn with a font of outlines; default: 1.0"""
    @property
    def vertexNormalsColor(self) -> list[float]:
        """red, green, blue and opacity of normals at the corners of faces, each from 0 to 1 [4; 1]; default: [0.8, 0.2, 0.2, 1.0]"""
    @vertexNormalsColor.setter
    def vertexNormalsColor(self, value: ArrayLike) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsOpenGL(_Settings):
    """OpenGL renderer: faces, lines and material"""

    drawFaceNormals: bool
    """draw the normals of faces, to find errors in meshes; default: False"""
    drawNormalsLength: float
    """length of normals [m]; default: 0.1"""
    drawVertexNormals: bool
    """draw the normals at the corners of faces, to find errors in meshes; default: False"""
    @property
    def faceEdgesColor(self) -> list[float]:
        """color of the edges of faces: red, green and blue from 0 to 1; the fourth number is not used [4; 1]; no effect on pages: pages have lights, lines and words of their own; default: [0.2, 0.2, 0.2, 1.0]"""
    @faceEdgesColor.setter
    def faceEdgesColor(self, value: ArrayLike) -> None: ...
    faceTransparencyGlobal: float
    """largest opacity of faces when ``scene.facesTransparent`` is set [1]; default: 0.4"""
    @property
    def lightModelAmbient(self) -> list[float]:
        """red, green and blue of light that comes from everywhere, for faces that no light reaches; used by the ray tracer as well; the fourth number is not used [4; 1]; no effect on pages: pages have lights, lines and words of their own; default: [0.4, 0.4, 0.4, 1.0]"""
    @lightModelAmbient.setter
    def lightModelAmbient(self, value: ArrayLike) -> None: ...
    lineWidth: float
    """width of lines in pixels [1]; no effect on pages: pages have lights, lines and words of their own; default: 1.0"""
    materialShininess: float
    """sharpness of highlights; larger is sharper [1]; no effect on pages: pages have lights, lines and words of their own; default: 32.0"""
    @property
    def materialSpecular(self) -> list[float]:
        """red, green and blue of highlights; the fourth number is not used [4; 1]; no effect on pages: pages have lights, lines and words of their own; default: [0.6, 0.6, 0.6, 1.0]"""
    @materialSpecular.setter
    def materialSpecular(self, value: ArrayLike) -> None: ...
    multiSampling: int
    """number of samples per pixel against jagged edges, of which there are at least 4 and at most 64; the next square number is taken; no effect on pages: pages have lights, lines and words of their own; default: 1"""
    zMaxSceneFactor: float
    """depth of the visible space relative to the size of the scene; too small cuts near and far parts off, too large makes faces flicker [1]; no effect: nothing is too far away to be drawn; default: 2.0"""
    @property
    def advanced(self) -> VSettingsOpenGLAdvanced: ...
    @advanced.setter
    def advanced(self, value: VSettingsOpenGLAdvanced | dict[str, Any]) -> None: ...
    @property
    def light0(self) -> VSettingsLight: ...
    @light0.setter
    def light0(self, value: VSettingsLight | dict[str, Any]) -> None: ...
    @property
    def light1(self) -> VSettingsLight: ...
    @light1.setter
    def light1(self, value: VSettingsLight | dict[str, Any]) -> None: ...
    @property
    def light2(self) -> VSettingsLight: ...
    @light2.setter
    def light2(self, value: VSettingsLight | dict[str, Any]) -> None: ...
    @property
    def light3(self) -> VSettingsLight: ...
    @light3.setter
    def light3(self, value: VSettingsLight | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsRaytracerAdvanced(_Settings):
    """software ray tracer: quality and speed"""

    @property
    def backgroundColorReflections(self) -> list[float]:
        """red, green and blue that reflected rays see where they leave the scene; the fourth number is not used [4; 1]; default: [0.4, 0.4, 0.4, 1.0]"""
    @backgroundColorReflections.setter
    def backgroundColorReflections(self, value: ArrayLike) -> None: ...
    searchTreeFactor: int
    """factor of the number of cells of the search tree, from 1 to 128, for scenes with unevenly distributed faces; no effect: the tree follows from the shapes; default: 1"""
    shadowScalingFactor: int
    """factor by which the map of soft shadows is coarser than the image, from 0 to 16; 0: shadows are sampled as the image is; no effect: shadows are sampled as the image is; default: 3"""
    shadowSmoothingSteps: int
    """number of smoothing steps of the map of soft shadows, from 0 to 32; no effect: shadows are sampled as the image is; default: 3"""
    showText: bool
    """true: texts are part of the image; false: no text; default: True"""
    tilesPerThread: int
    """number of parts of the image per thread, for an even load; the image does not depend on it; default: 12"""
    zBiasLines: float
    """shift of lines towards the viewer relative to the size of the scene, so that lines on faces are visible [1]; default: 0.001"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsRaytracer(_Settings):
    """software ray tracer"""

    @property
    def globalFogColor(self) -> list[float]:
        """red, green, blue and opacity of fog, each from 0 to 1 [4; 1]; default: [0.5, 0.5, 0.5, 1.0]"""
    @globalFogColor.setter
    def globalFogColor(self, value: ArrayLike) -> None: ...
    globalFogDensity: float
    """density of fog relative to the size of the scene; 0: no fog [1]; default: 0.0"""
    imageSizeFactor: int
    """factor by which the image is smaller than the window, from 1 to 16, for fast previews; default: 1"""
    keepWindowActive: bool
    """true: the window is kept responsive during long renderings; no effect: images are made at once, and no window waits for them; default: False"""
    lightRadiusVariations: int
    """number of positions on a light that are sampled for soft shadows, from 1 (hard shadows) to 256; default: 1"""
    maxReflectionDepth: int
    """number of reflections that a ray follows, 32 at most; default: 2"""
    maxTransparencyDepth: int
    """number of transparent faces that a ray passes, 32 at most; default: 2"""
    multiSampling: int
    """number of samples per pixel in each direction, from 1 to 4; the cost grows with its square; default: 1"""
    numberOfThreads: int
    """number of threads, at most one for each core; the image does not depend on it; default: 8"""
    verbose: int
    """amount of output on rendering: 0 no output, 1 times and counters, 2 or more details; default: 0"""
    @property
    def advanced(self) -> VSettingsRaytracerAdvanced: ...
    @advanced.setter
    def advanced(self, value: VSettingsRaytracerAdvanced | dict[str, Any]) -> None: ...
    @property
    def material0(self) -> VSettingsMaterial: ...
    @material0.setter
    def material0(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material1(self) -> VSettingsMaterial: ...
    @material1.setter
    def material1(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material2(self) -> VSettingsMaterial: ...
    @material2.setter
    def material2(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material3(self) -> VSettingsMaterial: ...
    @material3.setter
    def material3(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material4(self) -> VSettingsMaterial: ...
    @material4.setter
    def material4(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material5(self) -> VSettingsMaterial: ...
    @material5.setter
    def material5(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material6(self) -> VSettingsMaterial: ...
    @material6.setter
    def material6(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material7(self) -> VSettingsMaterial: ...
    @material7.setter
    def material7(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material8(self) -> VSettingsMaterial: ...
    @material8.setter
    def material8(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    @property
    def material9(self) -> VSettingsMaterial: ...
    @material9.setter
    def material9(self, value: VSettingsMaterial | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsGeneral(_Settings):
    """general settings of drawing and window"""

    autoFitScene: bool
    """fit the scene into the window when the renderer starts; default: True"""
    axesTiling: int
    """number of segments of axes and arrows; default: 12"""
    @property
    def backgroundColor(self) -> list[float]:
        """red, green, blue and opacity of the background, at the top if it has a gradient, each from 0 to 1 [4; 1]; default: [1.0, 1.0, 1.0, 1.0]"""
    @backgroundColor.setter
    def backgroundColor(self, value: ArrayLike) -> None: ...
    @property
    def backgroundColorBottom(self) -> list[float]:
        """red, green, blue and opacity of the background at the bottom if it has a gradient, each from 0 to 1 [4; 1]; no effect on pages: pages have lights, lines and words of their own; default: [0.8, 0.8, 1.0, 1.0]"""
    @backgroundColorBottom.setter
    def backgroundColorBottom(self, value: ArrayLike) -> None: ...
    boundingBoxZoomAllFactor: float
    """space around the bounding box after zooming to all, as a factor of its size [1]; default: 1.2"""
    boundingBoxZoomAllOffset: float
    """smallest size of the bounding box when zooming to all [m]; no effect: the space around a system is a part of its size; default: 0.01"""
    circleTiling: int
    """number of segments of circles; the minimum is 2; no effect: circles have 32 segments; default: 16"""
    coordinateSystemSize: float
    """size of the coordinate system in the corner, relative to the font size [1]; no effect on pages: pages have lights, lines and words of their own; default: 5.0"""
    cylinderTiling: int
    """number of segments around cylinders; the minimum is 2; default: 16"""
    graphicsUpdateInterval: float
    """real time between two updates of the drawing while a solver runs [s]; default: 0.1"""
    limitWindowToScreenSize: bool
    """true: windows are not larger than the screen; false: larger windows are allowed; no effect: pages are in windows of the browser, with its mouse; default: True"""
    linuxDisplayScaleFactor: float
    """factor of fonts in windows and dialogs on Linux [1]; no effect: pages are in windows of the browser, with its mouse; default: 1.0"""
    minSceneSize: float
    """smallest size of the scene, for models without extension; positive [m]; no effect: sizes are parts of the system, however small it is; default: 0.1"""
    pointSize: float
    """size of points [m]; no effect: nodes are balls, in proportion to the scene; default: 0.01"""
    reallyQuitTimeLimit: float
    """duration of a computation from which on closing the window asks for confirmation; 0: always [s]; no effect: pages are in windows of the browser, with its mouse; default: 900.0"""
    rendererPrecision: int
    """number of significant digits in the render window, 16 at most; no effect on pages: pages have lights, lines and words of their own; default: 4"""
    rendererStartupTimeout: int
    """time in milliseconds that a start of the renderer may take; no effect: pages are in windows of the browser, with its mouse; default: 2500"""
    renderWindowString: str
    """text that is shown in the render window; no effect on pages: pages have lights, lines and words of their own; default: ''"""
    showHelpOnStartup: int
    """seconds for which help is shown when the renderer starts; 0: none; no effect: pages are in windows of the browser, with its mouse; default: 5"""
    showSolutionInformation: bool
    """show the text of ``solutionSettings.solutionInformation``; no effect: pages are in windows of the browser, with its mouse; default: True"""
    showSolverInformation: bool
    """show name and state of the solver; no effect: pages are in windows of the browser, with its mouse; default: True"""
    showSolverTime: bool
    """show the simulated time; no effect on pages: pages have lights, lines and words of their own; default: True"""
    sphereTiling: int
    """number of segments of spheres; the minimum is 2; no effect: spheres are round; default: 6"""
    textAlwaysInFront: bool
    """true: texts of items are drawn in front of everything; false: faces can hide them; no effect: texts are always in front; default: True"""
    @property
    def textColor(self) -> list[float]:
        """red, green, blue and opacity of texts of the window, each from 0 to 1 [4; 1]; default: [0.0, 0.0, 0.0, 1.0]"""
    @textColor.setter
    def textColor(self, value: ArrayLike) -> None: ...
    textHasBackground: bool
    """draw a background behind texts of items; no effect on pages: pages have lights, lines and words of their own; default: False"""
    textOffsetFactor: float
    """shift of texts of items towards the viewer relative to the size of the scene; only without ``textAlwaysInFront`` [1]; no effect: texts stand beside their points, by pixels; default: 0.005"""
    threadSafeGraphicsUpdate: bool
    """true: the state that is drawn is copied under a lock; false: faster, but pictures may mix two states; no effect: pictures always use a copy of the state; default: True"""
    useBitmapText: bool
    """true: texts are drawn from bitmaps; false: from lines; no effect: texts are drawn with a font of outlines; default: True"""
    useGradientBackground: bool
    """draw the background with a vertical gradient; no effect on pages: pages have lights, lines and words of their own; default: False"""
    useMultiThreadedRendering: bool
    """true: the renderer runs in a thread of its own; false: in the thread of the solver; set it before the renderer starts; no effect: pages are in windows of the browser, with its mouse; default: True"""
    useWindowsDisplayScaleFactor: bool
    """scale fonts with the display scaling of Windows; no effect: pages are in windows of the browser, with its mouse; default: True"""
    zoomAllUseBoundingBox: bool
    """true: zooming to all uses the exact bounding box of the scene, without perspective; false: an estimate; no effect: zooming to all always uses the box around everything; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsInteractiveAdvanced(_Settings):
    """highlighting, selection, and speed of keys and mouse"""

    @property
    def highlightColor(self) -> list[float]:
        """red, green, blue and opacity of the highlighted item, each from 0 to 1 [4; 1]; default: [0.8, 0.05, 0.05, 0.75]"""
    @highlightColor.setter
    def highlightColor(self, value: ArrayLike) -> None: ...
    @property
    def highlightOtherColor(self) -> list[float]:
        """red, green, blue and opacity of all other items while one is highlighted, each from 0 to 1 [4; 1]; default: [0.5, 0.5, 0.5, 0.4]"""
    @highlightOtherColor.setter
    def highlightOtherColor(self, value: ArrayLike) -> None: ...
    joystickScaleRotation: float
    """factor of joystick rotations [1]; no effect: pages are in windows of the browser, with its mouse; default: 200.0"""
    joystickScaleTranslation: float
    """factor of joystick translations [1]; no effect: pages are in windows of the browser, with its mouse; default: 6.0"""
    keypressRotationStep: float
    """rotation of the view per key press [deg]; default: 5.0"""
    keypressTranslationStep: float
    """translation of the view per key press, relative to the window [1]; default: 0.1"""
    mouseMoveRotationFactor: float
    """rotation of the view per pixel of mouse movement [deg]; no effect: pages are in windows of the browser, with its mouse; default: 1.0"""
    pauseWithSpacebar: bool
    """the space bar pauses and continues a computation; default: True"""
    selectionHighlights: bool
    """a click highlights an item; default: True"""
    selectionLeftMouse: bool
    """a left click shows a short description of an item; default: True"""
    selectionLeftMouseItemTypes: int
    """kinds of items that a left click selects, a sum of 1 nodes, 2 objects, 4 markers, 8 loads, 16 sensors; default: 31"""
    selectionRightMouse: bool
    """a right click shows all parameters of an item; no effect: a click with either button shows the same; default: True"""
    selectionRightMouseGraphicsData: bool
    """a right click shows the graphics data as well, which may be long; default: False"""
    zoomStepFactor: float
    """factor of the zoom per key press or step of the mouse wheel [1]; default: 1.15"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsInteractiveOpenVR(_Settings):
    """virtual reality by OpenVR"""

    actionManifestFileName: str
    """absolute path of the file with the actions of the devices; no effect: pages are in windows of the browser, with its mouse; default: 'C:/openVRactionsManifest.json'"""
    enable: bool
    """use OpenVR, if the package is built with it; no effect: pages are in windows of the browser, with its mouse; default: False"""
    logLevel: int
    """amount of output: -1 no output, 0 errors, 1 warnings, 2 information, 3 for debugging; no effect: pages are in windows of the browser, with its mouse; default: 1"""
    showCompanionWindow: bool
    """show the views of both eyes in a window; no effect: pages are in windows of the browser, with its mouse; default: True"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsInteractive(_Settings):
    """interaction with the render window"""

    autoRotateModelView: bool
    """rotate the view by itself; no effect: pages are in windows of the browser, with its mouse; default: False"""
    @property
    def autoRotationVelocity(self) -> list[float]:
        """angular velocity of the rotating view [3; rad/s]; no effect: pages are in windows of the browser, with its mouse; default: [0.0, 0.0, 1.047198]"""
    @autoRotationVelocity.setter
    def autoRotationVelocity(self, value: ArrayLike) -> None: ...
    highlightItemIndex: int
    """number of the item that is highlighted; -1: none; default: -1"""
    highlightItemType: ItemType
    """kind of the item that is highlighted; default: ItemType._None"""
    highlightMbsNumber: int
    """number of the system in the container whose item is highlighted; the first is 0; default: 0"""
    ignoreKeys: bool
    """true: keys, except for escape and F2, are left to the key press user function; default: False"""
    logMouseCoordinates: bool
    """write mouse coordinates to the console as well, if they are shown; no effect: pages are in windows of the browser, with its mouse; default: True"""
    useJoystickInput: bool
    """move and rotate the view with a six-axis joystick, if there is one; no effect: pages are in windows of the browser, with its mouse; default: True"""
    @property
    def advanced(self) -> VSettingsInteractiveAdvanced: ...
    @advanced.setter
    def advanced(self, value: VSettingsInteractiveAdvanced | dict[str, Any]) -> None: ...
    @property
    def openVR(self) -> VSettingsInteractiveOpenVR: ...
    @openVR.setter
    def openVR(self, value: VSettingsInteractiveOpenVR | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsDialogs(_Settings):
    """dialogs"""

    alphaTransparency: float
    """opacity of dialogs, from 0 to 1 [1]; no effect: pages are in windows of the browser, with its mouse; default: 0.94"""
    alwaysTopmost: bool
    """dialogs stay above other windows; no effect: pages are in windows of the browser, with its mouse; default: True"""
    fontScalingMacOS: float
    """factor of fonts in dialogs on macOS [1]; no effect: pages are in windows of the browser, with its mouse; default: 1.35"""
    multiThreadedDialogs: bool
    """true: the render window follows changes while a dialog is open; false: when it is closed; no effect: pages are in windows of the browser, with its mouse; default: True"""
    openTreeView: bool
    """open all branches of the dialog of visualization settings; no effect: pages are in windows of the browser, with its mouse; default: False"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VSettingsExportImages(_Settings):
    """export of images"""

    heightAlignment: int
    """the height of an image is a multiple of this number of pixels; 2 suits video encoders; default: 2"""
    saveImageAsTextCircles: bool
    """write circles, in the format TXT; no effect: images are saved as PNG; default: True"""
    saveImageAsTextLines: bool
    """write lines, in the format TXT; no effect: images are saved as PNG; default: True"""
    saveImageAsTextTexts: bool
    """write texts, in the format TXT; no effect: images are saved as PNG; default: False"""
    saveImageAsTextTriangles: bool
    """write triangles, in the format TXT; no effect: images are saved as PNG; default: False"""
    saveImageFileCounter: int
    """number of the next image; increased with each image; default: 0"""
    saveImageFileName: str
    """path and start of the names of image files, to which number and ending are added; directories are created; default: 'images/frame'"""
    saveImageFormat: str
    """format of images: PNG, TGA, or TXT for the lines and faces of the scene in text form; default: 'PNG'"""
    saveImageSingleFile: bool
    """true: the file name has no number, so that a new image replaces the one before; false: numbered files; default: False"""
    saveImageTimeOut: int
    """time in milliseconds that saving an image may take; no effect: pages are in windows of the browser, with its mouse; default: 5000"""
    widthAlignment: int
    """the width of an image is a multiple of this number of pixels; 4 suits video encoders; default: 4"""
    def __init__(self, **settings: Any) -> None: ...

@final
class VisualizationSettings(_Settings):
    """settings of the renderer"""

    @property
    def nodes(self) -> VSettingsNodes: ...
    @nodes.setter
    def nodes(self, value: VSettingsNodes | dict[str, Any]) -> None: ...
    @property
    def bodies(self) -> VSettingsBodies: ...
    @bodies.setter
    def bodies(self, value: VSettingsBodies | dict[str, Any]) -> None: ...
    @property
    def connectors(self) -> VSettingsConnectors: ...
    @connectors.setter
    def connectors(self, value: VSettingsConnectors | dict[str, Any]) -> None: ...
    @property
    def markers(self) -> VSettingsMarkers: ...
    @markers.setter
    def markers(self, value: VSettingsMarkers | dict[str, Any]) -> None: ...
    @property
    def loads(self) -> VSettingsLoads: ...
    @loads.setter
    def loads(self, value: VSettingsLoads | dict[str, Any]) -> None: ...
    @property
    def sensors(self) -> VSettingsSensors: ...
    @sensors.setter
    def sensors(self, value: VSettingsSensors | dict[str, Any]) -> None: ...
    @property
    def contour(self) -> VSettingsContour: ...
    @contour.setter
    def contour(self, value: VSettingsContour | dict[str, Any]) -> None: ...
    @property
    def contact(self) -> VSettingsContact: ...
    @contact.setter
    def contact(self, value: VSettingsContact | dict[str, Any]) -> None: ...
    @property
    def view0(self) -> VSettingsView: ...
    @view0.setter
    def view0(self, value: VSettingsView | dict[str, Any]) -> None: ...
    @property
    def view1(self) -> VSettingsView: ...
    @view1.setter
    def view1(self, value: VSettingsView | dict[str, Any]) -> None: ...
    @property
    def view2(self) -> VSettingsView: ...
    @view2.setter
    def view2(self, value: VSettingsView | dict[str, Any]) -> None: ...
    @property
    def view3(self) -> VSettingsView: ...
    @view3.setter
    def view3(self, value: VSettingsView | dict[str, Any]) -> None: ...
    @property
    def openGL(self) -> VSettingsOpenGL: ...
    @openGL.setter
    def openGL(self, value: VSettingsOpenGL | dict[str, Any]) -> None: ...
    @property
    def raytracer(self) -> VSettingsRaytracer: ...
    @raytracer.setter
    def raytracer(self, value: VSettingsRaytracer | dict[str, Any]) -> None: ...
    @property
    def general(self) -> VSettingsGeneral: ...
    @general.setter
    def general(self, value: VSettingsGeneral | dict[str, Any]) -> None: ...
    @property
    def interactive(self) -> VSettingsInteractive: ...
    @interactive.setter
    def interactive(self, value: VSettingsInteractive | dict[str, Any]) -> None: ...
    @property
    def dialogs(self) -> VSettingsDialogs: ...
    @dialogs.setter
    def dialogs(self, value: VSettingsDialogs | dict[str, Any]) -> None: ...
    @property
    def exportImages(self) -> VSettingsExportImages: ...
    @exportImages.setter
    def exportImages(self, value: VSettingsExportImages | dict[str, Any]) -> None: ...
    def __init__(self, **settings: Any) -> None: ...
