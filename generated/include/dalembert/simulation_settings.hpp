// Generated from specs/settings/simulation_settings.toml by codegen/templates/settings.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/settings.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Jacobians by numerical differentiation
struct NewtonNumericalDifferentiationSettings {
  bool addReferenceCoordinatesToEpsilon = false;
  bool doSystemWideDifferentiation = false;
  bool forAE = false;
  bool forODE2 = false;
  bool forODE2connectors = false;
  bool jacobianConnectorDerivative = true;
  double minimumCoordinateSize = 0.01;
  double relativeEpsilon = 1e-07;
};

// Newton's method for the nonlinear equations of a step
struct NewtonSettings {
  double absoluteTolerance = 1e-10;
  bool adaptInitialResidual = true;
  double maximumSolutionNorm = 1e+38;
  int maxIterations = 25;
  int maxModifiedNewtonIterations = 8;
  int maxModifiedNewtonRestartIterations = 7;
  double modifiedNewtonContractivity = 0.5;
  bool modifiedNewtonJacUpdatePerStep = false;
  int newtonResidualMode = 0;
  double relativeTolerance = 1e-08;
  bool useModifiedNewton = false;
  bool useNewtonSolver = true;
  bool weightTolerancePerCoordinate = false;
  NewtonNumericalDifferentiationSettings numericalDifferentiation{};
};

// iterations for contact, friction and other discontinuous states, after Newton's method has converged
struct DiscontinuousSettings {
  bool ignoreMaxIterations = true;
  double iterationTolerance = 1.0;
  int maxIterations = 5;
  bool useRecommendedStepSize = true;
};

// continuation of a solution that was stopped
struct ContinuationSettings {
  bool ifAvailable = false;
  std::string restartFileName = "";
};

// output between the ends of steps
struct DenseOutputSettings {
  bool atRequestedTimes = false;
};

// contact that opens or closes, friction that begins to slide or to stick, and stops
struct EventsSettings {
  bool ofItems = false;
};

// check of the initial values against the constraints
struct InitialConditionsSettings {
  bool checkConstraints = true;
  bool inconsistentIsError = false;
  double positionTolerance = 1e-05;
  double velocityTolerance = 0.01;
};

// selection of the linear solver
struct LinearSolverChoiceSettings {
  bool automatic = true;
};

// settings of the linear solver
struct LinearSolverSettings {
  bool ignoreSingularJacobian = false;
  double pivotThreshold = 0.0;
  bool reuseAnalyzedPattern = false;
  bool showCausingItems = true;
};

// computation with several threads
struct ParallelSettings {
  int multithreadedLLimitJacobians = 20;
  int multithreadedLLimitLoads = 20;
  int multithreadedLLimitMassMatrices = 20;
  int multithreadedLLimitResiduals = 20;
  int numberOfThreads = 1;
  int taskSplitMinItems = 50;
  int taskSplitTasksPerThread = 16;
  bool useLoadBalancing = true;
};

// constraint equations that follow from others, such as those of the second hinge of a door
struct RedundantConstraintsSettings {
  double largestMisfit = 1e-06;
  double momentLength = 0.0;
  bool treat = true;
};

// output to files: contents and intervals
struct SolutionSettings {
  bool appendToFile = false;
  bool binarySolutionFile = false;
  std::string coordinatesSolutionFileName = "coordinatesSolution";
  bool exportAccelerations = true;
  bool exportAlgebraicCoordinates = true;
  bool exportDataCoordinates = true;
  bool exportODE1Velocities = true;
  bool exportVelocities = true;
  int flushFilesDOF = 10000;
  bool flushFilesImmediately = false;
  int outputPrecision = 10;
  double recordImagesInterval = -1.0;
  std::string restartFileName = "restartFile.txt";
  double restartWritePeriod = 0.01;
  bool sensorsAppendToFile = false;
  bool sensorsStoreAndWriteFiles = true;
  bool sensorsWriteFileFooter = false;
  bool sensorsWriteFileHeader = true;
  double sensorsWritePeriod = 0.01;
  std::string solutionInformation = "";
  double solutionWritePeriod = 0.01;
  std::string solverInformationFileName = "solverInformation.txt";
  bool writeFileFooter = true;
  bool writeFileHeader = true;
  bool writeInitialValues = true;
  bool writeRestartFile = false;
  bool writeSolutionToFile = true;
};

// following a path of equilibria by its length instead of the load, over limit points and onto branches
struct StaticSolverArcLengthSettings {
  bool active = false;
  double branchStep = 0.0;
  int desiredIterations = 4;
  double largestStep = 0.0;
  double lowestLoadFactor = -1.0;
  int maximumSteps = 1000;
  bool singularPoints = true;
};

// static solver: equilibrium under loads that are increased in steps
struct StaticSolverSettings {
  bool adaptiveStep = true;
  double adaptiveStepDecrease = 0.25;
  double adaptiveStepIncrease = 2.0;
  int adaptiveStepRecoveryIterations = 7;
  int adaptiveStepRecoverySteps = 4;
  bool computeLoadsJacobian = true;
  bool constrainODE1coordinates = true;
  double loadStepDuration = 1.0;
  bool loadStepGeometric = false;
  double loadStepGeometricRange = 1000.0;
  double loadStepStart = 0.0;
  double minimumStepSize = 1e-08;
  int numberOfLoadSteps = 1;
  double stabilizerODE2term = 0.0;
  int stepInformation = 67;
  bool useLoadFactor = true;
  int verboseMode = 1;
  int verboseModeFile = 0;
  StaticSolverArcLengthSettings arcLength{};
  DiscontinuousSettings discontinuous{};
  NewtonSettings newton{};
};

// step-size control by an error estimate
struct StepSizeControlSettings {
  bool implicitSolvers = false;
};

// explicit integrators
struct TimeIntegrationExplicitIntegrationSettings {
  bool computeEndOfStepAccelerations = true;
  bool computeMassMatrixInversePerBody = false;
  DynamicSolverType dynamicSolverType = DynamicSolverType::DOPRI5;
  bool eliminateConstraints = true;
  bool useLieGroupIntegration = true;
};

// generalized-alpha, Newmark and implicit trapezoidal integrators
struct TimeIntegrationGeneralizedAlphaSettings {
  bool computeInitialAccelerations = true;
  bool lieGroupAddTangentOperator = true;
  bool lieGroupSimplifiedKinematicRelations = false;
  double newmarkBeta = 0.25;
  double newmarkGamma = 0.5;
  bool resetAccelerations = false;
  double spectralRadius = 0.9;
  bool storeInitialAlgebraicCoordinates = true;
  bool useIndex2Constraints = false;
  bool useNewmark = false;
};

// time integration
struct TimeIntegrationSettings {
  double absoluteTolerance = 1e-08;
  bool adaptiveStep = true;
  double adaptiveStepDecrease = 0.5;
  double adaptiveStepIncrease = 2.0;
  int adaptiveStepRecoveryIterations = 7;
  int adaptiveStepRecoverySteps = 10;
  bool automaticStepSize = true;
  int computeLoadsJacobian = 0;
  double endTime = 1.0;
  double initialStepSize = 0.0;
  double minimumStepSize = 1e-08;
  double numberOfSteps = 100.0;
  double realtimeFactor = 1.0;
  int realtimeWaitMicroseconds = 1000;
  double relativeTolerance = 1e-08;
  bool reuseConstantMassMatrix = true;
  bool simulateInRealtime = false;
  double startTime = 0.0;
  int stepInformation = 67;
  DynamicSolverType solverType = DynamicSolverType::GeneralizedAlpha;
  double stepSizeMaxIncrease = 2.0;
  double stepSizeSafety = 0.9;
  int verboseMode = 0;
  int verboseModeFile = 0;
  DiscontinuousSettings discontinuous{};
  TimeIntegrationExplicitIntegrationSettings explicitIntegration{};
  TimeIntegrationGeneralizedAlphaSettings generalizedAlpha{};
  NewtonSettings newton{};
};

// settings of the solvers: time integration, static solver, linear algebra, output and threads
struct SimulationSettings {
  bool cleanUpMemory = false;
  bool displayComputationTime = false;
  bool displayGlobalTimers = true;
  bool displayStatistics = false;
  LinearSolverType linearSolverType = LinearSolverType::EXUdense;
  int outputPrecision = 6;
  bool pauseAfterEachStep = false;
  ContinuationSettings continuation{};
  DenseOutputSettings denseOutput{};
  EventsSettings events{};
  InitialConditionsSettings initialConditions{};
  LinearSolverChoiceSettings linearSolverChoice{};
  LinearSolverSettings linearSolverSettings{};
  ParallelSettings parallel{};
  RedundantConstraintsSettings redundantConstraints{};
  SolutionSettings solutionSettings{};
  StaticSolverSettings staticSolver{};
  StepSizeControlSettings stepSizeControl{};
  TimeIntegrationSettings timeIntegration{};
};

// Rows of SimulationSettings and of all structures in it.
const SettingsGroup& simulation_settings_group();

}  // namespace dalembert
