// Step sizes from estimated errors of implicit solvers, and steps of the smallest size whose error is above the tolerances.
#include <algorithm>
#include <cmath>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace {

constexpr double smallest_factor = 0.2;  // of the step size after a step with a large error
constexpr double not_worth_it = 1.2;     // an increase, which costs a factorization and accuracy of algorithmic accelerations
constexpr double last_stretch = 1.1;     // a rest of the simulation that is not much longer than a step is one

}  // namespace

void Solver::choose_smaller_step(double wanted) {
  const double factor = std::isfinite(wanted) ? std::clamp(wanted, smallest_factor, 1.0) : smallest_factor;
  ++it.rejectedAutomaticStepSizeSteps;
  it.currentStepSize = std::max(it.minStepSize, it.currentStepSize * factor);
}

void Solver::choose_next_step(double wanted) {
  const double h = it.currentStepSize, factor = std::clamp(wanted, smallest_factor, settings().timeIntegration.stepSizeMaxIncrease);
  const double next = std::clamp(factor > 1 && factor < not_worth_it ? h : h * factor, it.minStepSize, std::max(it.minStepSize, it.maxStepSize));
  const double rest = it.endTime - it.currentTime;
  it.currentStepSize = next < rest && rest < last_stretch * next ? rest : next;
}

void Solver::count_step_size() {
  const double h = conditions_.step_size;
  it.smallestStepSize = it.largestStepSize == 0 ? h : std::min(it.smallestStepSize, h);
  it.largestStepSize = std::max(it.largestStepSize, h);
  if (h >= it.maxStepSize) ++it.stepsAtMaximumStepSize;
}

[[gnu::noinline]] bool Solver::hold_at_minimum() {
  constexpr int most = 100;  // a jump is passed in a few of them; so many in a row do not come from one
  if (!warned_minimum_) {
    warn("automatic step size reached timeIntegration.minimumStepSize at time " + format_number(it.currentTime) +
         "; the error becomes larger than the tolerances");
    warned_minimum_ = true;
    if (it.currentStepIndex <= 1) closing_at_start_ = constraints_that_close_at_start();
  }
  if (++steps_above_tolerance_ > most) {
    diagnose_error_control();
    return false;
  }
  ++it.stepsAboveTolerance;
  return true;
}

void Solver::diagnose_error_control() {
  diagnose(FailureReason::error_control).advice = {
      "look for what jumps: contact, friction, user functions that are not continuous",
      "allow larger errors (timeIntegration.relativeTolerance, absoluteTolerance), or smaller steps (timeIntegration.minimumStepSize)"};
}

}  // namespace dalembert
