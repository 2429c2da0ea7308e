// Explicit solvers with joints: accelerations and multipliers of each stage, and projection onto the constraints at the
// end of a step.
#include <algorithm>

#include "dalembert/solvers/explicit.hpp"
#include "constraints/singular_positions.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

bool ExplicitSolver::constrained_accelerations(Vector& a, std::span<double> y_t) {
  State& now = current();
  {
    const TimedPart time(timer, timer.massMatrix);
    if (const int row = motion_.factorize(system(), now, conditions_); row != LinearSolver::success) {
      mass_failed(row);
      return false;
    }
  }
  {
    const TimedPart time(timer, timer.ODE2RHS);
    system().right_hand_sides(now, conditions_, a, y_t);
  }
  const TimedPart time(timer, timer.newtonIncrement);
  motion_.accelerations(system(), now, conditions_, a, now.lambda);
  if (it.currentStepIndex <= 1 && now.time == start_of_step().time) [[unlikely]] {
    const auto find = [&](const State& at, Vector& of_a, Vector& of_lambda) {
      Vector y_rates(y_t.size());
      system().right_hand_sides(at, conditions_, of_a, y_rates);
      motion_.accelerations(system(), at, conditions_, of_a, of_lambda);
    };
    if (!motion_.follow_motion(system(), now, conditions_, a, now.lambda, find)) singular_->warn_of_undecided_start();
  }
  return !searching_ || is_good(a, y_t);
}

// Projects with the factors of the last stage, which are accurate enough for the violation of one step.
bool ExplicitSolver::back_onto_constraints() {
  State& now = current();
  off_constraints_ = !motion_.project(system(), now, conditions_);
  if (off_constraints_) return false;
  largest_misfit_ = std::max(largest_misfit_, motion_.largest_misfit());
  if (diagnostics_->contradiction_text().empty())
    if (const std::vector<double> misfit = motion_.misfit(system(), now, conditions_); !misfit.empty()) [[unlikely]]
      diagnostics_->warn_of_contradiction(misfit);
  return true;
}

// Always returns false. A smaller step may succeed with error control.
[[gnu::noinline]] bool ExplicitSolver::lose_constraints() {
  constexpr double much_smaller = 0.25;
  conv.newtonConverged = false;
  if (it.automaticStepSize && !steps_.at_minimum()) {
    steps_.shrink_by_error(singular_->steps_aside() ? StepController::aside : much_smaller);
    return false;
  }
  conv.stopNewton = true;
  diagnostics_->diagnose_open_gaps();
  return false;
}

}  // namespace dalembert
