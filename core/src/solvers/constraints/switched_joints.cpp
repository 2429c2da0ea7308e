// Constraints that user functions switched on or off between steps.
#include <algorithm>
#include <functional>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

// Inactive equations define their multipliers. The state before the first change is unknown, because it would need calls of
// user functions in each solution.
[[gnu::noinline]] void Solver::look_for_switched_joints() {
  renewed_constraints_ = system_->renewed_constraints();
  State with = without_multipliers(current());
  std::vector<double> without(with.lambda.size()), gaps(without.size());
  system_->gaps(with, conditions_, without);
  std::ranges::fill(with.lambda, 1.0);
  system_->gaps(with, conditions_, gaps);
  std::vector<char> off(without.size());
  std::ranges::transform(gaps, without, off.begin(), std::not_equal_to());
  if (off == equations_off_) return;
  equations_off_ = std::move(off);
  conv.jacobianUpdateRequested = true;
  examine_constraints_anew();
}

// Stores the current state of the constraints.
void Solver::joints_are_examined() {
  renewed_constraints_ = system_->renewed_constraints();
  equations_off_.clear();
}

}  // namespace dalembert
