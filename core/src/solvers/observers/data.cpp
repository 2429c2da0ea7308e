#include "dalembert/solvers/data.hpp"

#include <chrono>

#include "dalembert/output/numbers.hpp"

namespace dalembert {

std::string SolverIterationData::to_string() const {
  std::string text = "Solver iteration statistics:\n";
  const auto line = [&text](const char* words, StepCount number) {
    text += words;
    append_integer(text, number);
    text += '\n';
  };
  line("total number of steps:        ", currentStepIndex - 1);  // step 0 only writes the initial values
  line("total number of Newton iterations: ", newtonStepsCount);
  line("total number of Newton Jacobians:  ", newtonJacobiCount);
  if (rejectedModifiedNewtonSteps) line("rejected modified Newton steps:    ", rejectedModifiedNewtonSteps);
  if (rejectedAutomaticStepSizeSteps) line("rejected step sizes:               ", rejectedAutomaticStepSizeSteps);
  if (rejectedNewtonSteps) line("rejected by Newton's method:       ", rejectedNewtonSteps);
  if (rejectedDiscontinuousSteps) line("rejected by contact or friction:   ", rejectedDiscontinuousSteps);
  if (largestStepSize > 0) {
    text += "step sizes:                        " + format_number(smallestStepSize, 3) + " to " +
            format_number(largestStepSize, 3) + " s\n";
    line("steps of the largest size allowed: ", stepsAtMaximumStepSize);
  }
  if (stagnatedNewtonSteps) line("Newton loops ended at round-off:   ", stagnatedNewtonSteps);
  return text;
}

void SolverTimer::reset(bool use) {
  *this = SolverTimer();
  useTimer = use;
}

double SolverTimer::sum() const {
  return factorization + newtonIncrement + integrationFormula + ODE2RHS + ODE1RHS + AERHS + totalJacobian + massMatrix +
         reactionForces + postNewton + errorEstimator + writeSolution + overhead + python + realtimeIdleCPU +
         visualization;
}

double SolverTimer::now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string SolverTimer::to_string() const {
  if (!useTimer) return "";
  const struct {
    const char* name;
    double seconds;
  } parts[] = {{"factorization     ", factorization},
               {"newtonIncrement   ", newtonIncrement},
               {"integrationFormula", integrationFormula},
               {"ODE2RHS           ", ODE2RHS},
               {"ODE1RHS           ", ODE1RHS},
               {"AERHS             ", AERHS},
               {"totalJacobian     ", totalJacobian},
               {"massMatrix        ", massMatrix},
               {"reactionForces    ", reactionForces},
               {"errorEstimator    ", errorEstimator},
               {"postNewton        ", postNewton},
               {"python            ", python},
               {"realtimeIdleCPU   ", realtimeIdleCPU},
               {"writeSolution     ", writeSolution},
               {"overhead          ", overhead},
               {"visualization     ", visualization}};
  const double measured = sum();
  std::string text = "Computation times:\n  total    = " + format_number(total, 3) +
                     " seconds\n  measured = " + format_number(measured, 3) + " seconds\n";
  for (const auto& part : parts) {
    if (part.seconds <= 0) continue;
    text += std::string("  ") + part.name + " = " + format_number(100 * part.seconds / measured, 3) + "%\n";
  }
  return text;
}

}  // namespace dalembert
