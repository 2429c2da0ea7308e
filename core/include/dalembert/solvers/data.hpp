// Counters, flags and times of a solver, with the names under which users read them.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace dalembert {

// Counts of steps need 64 bits: a day of steps of a tiny model does not fit into 32 bits.
using StepCount = std::int64_t;

struct SolverIterationData {
  bool adaptiveStep = true, automaticStepSize = true;
  double automaticStepSizeError = 0;
  StepCount currentStepIndex = 0;
  double currentStepSize = 0, currentTime = 0;
  int discontinuousIteration = 0;
  StepCount discontinuousIterationsCount = 0;
  StepCount eventsCount = 0, eventSolutions = 0;  // events, and steps that were solved to locate them
  double endTime = 0, initialStepSize = 1e-6, lastStepSize = 0, maxStepSize = 0, minStepSize = 0;
  StepCount newtonJacobiCount = 0, newtonStepsCount = 0, numberOfSteps = 0;
  int newtonSteps = 0;
  double recommendedStepSize = -1;
  StepCount rejectedAutomaticStepSizeSteps = 0, rejectedModifiedNewtonSteps = 0;
  // Repeated because contact or friction did not converge, or because Newton's method failed.
  StepCount rejectedDiscontinuousSteps = 0, rejectedNewtonSteps = 0;
  // The extreme step sizes of error control; the shortened last step does not count.
  double smallestStepSize = 0, largestStepSize = 0;
  StepCount stepsAtMaximumStepSize = 0;                               // steps that could not be larger
  StepCount stagnatedNewtonSteps = 0;  // Newton iterations that ended at round-off instead of a tolerance
  // Accepted with an error above the tolerances, at the smallest step size or a singular configuration.
  StepCount stepsAboveTolerance = 0;
  StepCount unsettledSteps = 0;       // accepted although contact or friction had not converged
  StepCount singularPositionSteps = 0;  // steps that passed a singular configuration
  double startTime = 0;

  // Counts that a continued simulation restores; the index of the step is stored separately.
  static constexpr std::array counts{&SolverIterationData::discontinuousIterationsCount,
                                     &SolverIterationData::eventsCount,
                                     &SolverIterationData::eventSolutions,
                                     &SolverIterationData::newtonJacobiCount,
                                     &SolverIterationData::newtonStepsCount,
                                     &SolverIterationData::rejectedAutomaticStepSizeSteps,
                                     &SolverIterationData::rejectedModifiedNewtonSteps,
                                     &SolverIterationData::rejectedDiscontinuousSteps,
                                     &SolverIterationData::rejectedNewtonSteps,
                                     &SolverIterationData::stepsAtMaximumStepSize,
                                     &SolverIterationData::stagnatedNewtonSteps,
                                     &SolverIterationData::stepsAboveTolerance,
                                     &SolverIterationData::unsettledSteps,
                                     &SolverIterationData::singularPositionSteps};

  std::string to_string() const;  // the statistics shown by displayStatistics
};

struct SolverConvergenceData {
  double contractivity = 0, discontinuousIterationError = 0;
  bool discontinuousIterationSuccessful = true;
  double errorCoordinateFactor = 1;
  bool jacobianUpdateRequested = true;
  double lastResidual = 0;
  int linearSolverCausingRow = -1;
  bool linearSolverFailed = false, massMatrixNotInvertible = false;
  bool newtonConverged = false, newtonSolutionDiverged = false;
  bool newtonStagnated = false;  // the residual stopped decreasing at round-off: as accurate as possible
  double residual = 0;
  bool stepReductionFailed = false, stopNewton = false;
};

struct SolverOutputData {
  double cpuLastTimePrinted = 0, cpuSolverStartTime = 0, cpuStartTime = 0;
  bool finishedSuccessfully = false, initializationSuccessful = false;
  StepCount lastDiscontinuousIterationsCount = 0;
  double lastImageRecorded = 0;
  StepCount lastNewtonJacobiCount = 0, lastNewtonStepsCount = 0;
  double lastSensorsWritten = 0, lastSolutionWritten = 0;
  StepCount lastVerboseStepIndex = 0;
  int multiThreadingMode = 0, numberOfThreadsUsed = 1;
  bool trusted = false;  // finished, and no check of the result failed
  bool simulationStoppedByUser = false, simulationStoppedByUserFunction = false, simulationTimeout = false;
  int stepInformation = 0, verboseMode = 0, verboseModeFile = 0;
  bool writeToSolutionFile = false, writeToSolverFile = false;
};

// Seconds per part of the solver. Parts are measured only with displayComputationTime; `total` always.
struct SolverTimer {
  double AERHS = 0, errorEstimator = 0, factorization = 0, integrationFormula = 0;
  double jacobianAE = 0, jacobianODE1 = 0, jacobianODE2 = 0, jacobianODE2_t = 0;  // parts of totalJacobian
  double massMatrix = 0, newtonIncrement = 0, ODE1RHS = 0, ODE2RHS = 0, overhead = 0, postNewton = 0, python = 0;
  double reactionForces = 0, realtimeIdleCPU = 0, total = 0, totalJacobian = 0;
  bool useTimer = true;
  double visualization = 0, writeSolution = 0;

  void reset(bool use);
  double sum() const;
  std::string to_string() const;

  static double now();  // seconds of a steady clock
};

// Adds its lifetime to one part, if times are measured.
class TimedPart {
 public:
  TimedPart(const SolverTimer& timer, double& part) : part_(timer.useTimer ? &part : nullptr) {
    if (part_) *part_ -= SolverTimer::now();
  }
  ~TimedPart() {
    if (part_) *part_ += SolverTimer::now();
  }
  TimedPart(const TimedPart&) = delete;
  TimedPart& operator=(const TimedPart&) = delete;

 private:
  double* part_;
};

// Bits of stepInformation.
namespace step_information {
inline constexpr int time_to_go = 1, newton_iterations = 2, newton_jacobians = 4, discontinuous_iterations = 8,
                     step_size = 16, cpu_time = 32, step_reductions = 64, step_increases = 128, every_step = 1024;
}

}  // namespace dalembert
