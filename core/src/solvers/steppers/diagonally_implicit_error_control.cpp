// Error control of diagonally implicit methods. The filter keeps errors of stiff components, which decay in the next
// steps, from reducing the step size: Hairer, Wanner, Solving Ordinary Differential Equations II, section IV.8.
#include <algorithm>
#include <cmath>

#include "steppers/combination.hpp"
#include "dalembert/solvers/diagonally_implicit.hpp"
#include "constraints/singular_positions.hpp"

namespace dalembert {

namespace {

constexpr double order_of_error = 4;  // of the embedded method, within a step

// Weights of the solution minus weights of the embedded method of third order.
constexpr double differences[] = {
    82889.0 / 524892 - 4586570599.0 / 29645900160, 0,
    15625.0 / 83664 - 178811875.0 / 945068544,     69875.0 / 102672 - 814220225.0 / 1159782912,
    -2260.0 / 8211 + 3700637.0 / 11593932,         1.0 / 4 - 61727.0 / 225920};

}  // namespace

// Returns the root mean square of errors in units of the tolerances. The filter is not used after a jump, because
// decaying components are then part of the solution.
double DiagonallyImplicitSolver::estimated_error() {
  const TimedPart time(timer, timer.errorEstimator);
  const State &now = current(), &start = start_of_step();
  const double h = it.currentStepSize;
  const auto errors = [h](const std::array<Vector, stages>& rates) {
    Vector error(rates.front().size());
    for (std::size_t i = 0; i < error.size(); ++i) {
      for (std::size_t j = 0; j < rates.size(); ++j) error[i] += differences[j] * rates[j][i];
      error[i] *= h;
    }
    return error;
  };
  Vector of_q = errors(stage_q_), of_v = errors(stage_v_), of_y = errors(stage_y_);
  if (!after_jump_) filter(of_q, of_v, of_y);
  double sum = 0;
  const auto add_error = [&](double error, double value, double old) {
    const double e = error / weight(value, old);
    sum += e * e;
  };
  for (std::size_t i = 0; i < of_q.size(); ++i) {
    add_error(of_q[i], now.q[i], start.q[i]);
    add_error(of_v[i], now.v[i], start.v[i]);
  }
  for (std::size_t i = 0; i < of_y.size(); ++i) add_error(of_y[i], now.y[i], start.y[i]);
  return std::sqrt(sum / std::max(1, 2 * sizes_.ode2 + sizes_.ode1));
}

// Replaces errors e by (1 - gamma h J)^-1 e, with the Jacobian J of the first-order system and the present factors: M
// a' = M e_v - gamma h K e_q follows from two residuals, with coordinates moved by -gamma h e_q.
void DiagonallyImplicitSolver::filter(Vector& error_of_q, Vector& error_of_v, Vector& error_of_y) {
  State& now = current();
  const double g = diagonal();
  Vector before(x_.size());
  system().residual(now, conditions_, before);
  const Vector q = now.q, a = now.a, y_t = now.y_t;
  for (std::size_t i = 0; i < q.size(); ++i) {
    turn_[i] = -g * error_of_q[i];
    now.q[i] += turn_[i];
    now.a[i] += error_of_v[i];
  }
  if (lie_) system().compose(q, turn_, now.q);
  for (std::size_t i = 0; i < y_t.size(); ++i) now.y_t[i] += error_of_y[i];
  system().residual(now, conditions_, x_);
  now.q = q;
  now.a = a;
  now.y_t = y_t;
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] -= before[i];
  std::fill(x_.begin() + sizes_.first_ae(), x_.end(), 0.0);
  motion_.solve(x_);
  for (std::size_t i = 0; i < q.size(); ++i) {
    error_of_v[i] = x_[i];
    error_of_q[i] += g * x_[i];
  }
  std::copy_n(x_.begin() + sizes_.ode2, error_of_y.size(), error_of_y.begin());
}

// Returns false if the step has to be repeated, or if the solver stops.
bool DiagonallyImplicitSolver::control_step_size() {
  if (steps_.ends_are_prescribed()) return true;
  const double error = it.automaticStepSizeError;
  const double wanted = tolerances_.safety * std::pow(1 / std::max(error, 1e-12), 1 / order_of_error);
  const bool passes = !(error <= 1) && singular_->passes(error);
  if (passes && singular_->stays()) return false;
  if (!(error <= 1) && !passes) {
    if (steps_.at_minimum()) {
      if (!hold_at_minimum()) return false;
    } else {
      const double smaller = sizes_.ae > 0 && !(wanted > StepController::aside) && singular_->steps_aside()
                                 ? StepController::aside
                                 : wanted;
      steps_.reject_by_error(smaller);
      return false;
    }
  } else {
    steps_.within_tolerance();
  }
  after_jump_ = false;
  steps_.accept(passes ? 1 : wanted);
  return true;
}

bool DiagonallyImplicitSolver::reduce_step_size() {
  it.currentTime = current().time;
  if (steps_.take_rejection_by_error()) return true;
  const bool may_be_singular = sizes_.ae > 0 && (diagnosis_.reason == FailureReason::newton ||
                                                 diagnosis_.reason == FailureReason::open_constraints);
  if (steps_.at_minimum()) {
    if (may_be_singular && singular_->is_near()) singular_->report();
    return false;
  }
  const bool beside = may_be_singular && singular_->steps_aside();
  // Small steps may lead to another branch.
  if (may_be_singular && !beside && singular_->is_near()) ++it.stepsAboveTolerance;
  steps_.reject(it.currentStepSize, beside ? StepController::aside : steps_.decrease());
  return true;
}

bool DiagonallyImplicitSolver::discontinuous_iteration() {
  if (interferes_) accelerations_that_fit();
  return Solver::discontinuous_iteration() && (!it.automaticStepSize || control_step_size());
}

}  // namespace dalembert
