// Error control of implicit solvers, for second-order accurate methods.
//
// The step size is changed as in Arnold, Hante: Implementation details of a generalized-alpha differential-algebraic
// equation Lie group method, Journal of Computational and Nonlinear Dynamics 12 (2017): algorithmic accelerations have
// a time of their own.
#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/second_order.hpp"
#include "constraints/singular_positions.hpp"
#include "diagnosis/diagnostics.hpp"
#include "steppers/velocity_lead.hpp"

namespace dalembert {

bool SecondOrderSolver::discontinuous_iteration() {
  if (!Solver::discontinuous_iteration()) return false;
  if (it.automaticStepSize) return control_step_size();
  if (lead_->watches()) lead_->watch();
  return true;
}

// Returns the change of a (algorithmic) acceleration within a step of this size.
double SecondOrderSolver::change_of_accelerations(std::size_t i, double step_size) const {
  const State &now = system().state(ConfigurationType::Current),
              &start = system().state(ConfigurationType::StartOfStep);
  if (newmark()) return now.a[i] - start.a[i];
  const double ratio = belong_to_at_start_.accelerations == 0 ? 1 : step_size / belong_to_at_start_.accelerations;
  return algorithmic_[i] - (start.a[i] + ratio * (algorithmic_at_start_[i] - start.a[i]));
}

// Returns the root mean square of errors in units of the tolerances. Positions: the third-order term of the local
// error. Velocities: the same term within a step, which is of second order; third-order estimates are smaller than the
// noise of accelerations of constrained systems.
double SecondOrderSolver::estimated_error() {
  const State &now = current(), &start = start_of_step();
  const double h = it.currentStepSize, constant = std::abs(left_out());
  double sum = 0;
  const auto add = [&](double error, double value) {
    const double e = error / tolerances_.of(value);
    sum += e * e;
  };
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    const double change = change_of_accelerations(i, h);
    add(constant * h * h * change, now.q[i]);
    add(constant * h * change, now.v[i]);
  }
  for (std::size_t i = 0; i < now.y.size(); ++i) add(h * (now.y_t[i] - start.y_t[i]) / 12, now.y[i]);
  return std::sqrt(sum / static_cast<double>(std::max(1, 2 * sizes_.ode2 + sizes_.ode1)));
}

// Accelerations amplify the round-off of positions, the more the smaller the steps are.
double SecondOrderSolver::noise_of_estimates() {
  if (sizes_.ae == 0) return 0;
  double speed = 0;
  for (const double v : current().v) speed = std::max(speed, std::abs(v));
  const double noise = std::numeric_limits<double>::epsilon() * system().extent() / (newmark_beta * it.currentStepSize);
  return std::abs(left_out()) * noise / tolerances_.of(speed);
}

// Always returns false.
[[gnu::noinline]] bool SecondOrderSolver::give_up_at_round_off() {
  Diagnosis& d = diagnostics_->diagnose(FailureReason::round_off);
  d.advice = {"ask for larger errors: with the steps that timeIntegration.absoluteTolerance=" +
                  format_number(tolerances_.absolute) + " and relativeTolerance=" +
                  format_number(tolerances_.relative) + " take, round-off of positions alone is more",
              "use a method of higher order, whose steps are larger (exu.DynamicSolverType.DOP853)"};
  if (singular_->has_weak_constraints()) {
    d.advice.insert(d.advice.begin(),
                    "use a method that constrains accelerations (exu.DynamicSolverType.ESDIRK43 or DOPRI5): this is "
                    "beside a singular position, where gaps of "
                    "round-off leave much more of it in positions, and in estimates of errors");
  }
  return false;
}

// Returns false if the step has to be repeated, or if the solver stops.
bool SecondOrderSolver::control_step_size() {
  if (steps_.ends_are_prescribed()) return true;
  const TimedPart time(timer, timer.errorEstimator);
  const double h = it.currentStepSize, error = it.automaticStepSizeError = estimated_error();
  const double wanted = tolerances_.safety * std::cbrt(1 / std::max(error, 1e-12));
  const bool passes = !(error <= 1) && singular_->passes(error);
  if (passes && singular_->stays()) return false;
  if (!(error <= 1) && !passes) {
    if (noise_of_estimates() > 1) return give_up_at_round_off();
    if (singular_->last_step() > renewed_after_) {  // noise of accelerations persists without numerical damping
      renewed_after_ = it.currentStepIndex;
      steps_.repeat_by_error();
      return !(renews_ = true);
    }
    if (steps_.at_minimum()) {
      if (!hold_at_minimum()) return false;
    } else {
      steps_.reject_by_error(wanted);
      return false;
    }
  } else {
    steps_.within_tolerance();
  }
  steps_.accept(passes ? 1 : wanted);
  if (sizes_.ae == 0) return true;
  if (conditions_.rate_level)
    end_swings();
  else
    lead_->apply(h, it.currentStepSize, error <= 1);
  return true;
}

// Velocity constraints do not determine a part of the accelerations that alternates in sign, and grows whenever the
// step size changes. The acceleration constraints remove it.
void SecondOrderSolver::end_swings() {
  State& now = current();
  std::vector<double> accelerations = ConstrainedMotion::gap_accelerations_without_driving(system(), now, conditions_);
  const std::vector<char>& driven = lead_->row_kinds().driven;
  for (std::size_t k = 0; k < accelerations.size(); ++k)
    if (driven[k]) accelerations[k] = 0;
  const std::span<const double> across = lead_->move_across(accelerations);
  for (std::size_t i = 0; i < now.a.size(); ++i) now.a[i] -= across[i];
}

}  // namespace dalembert
