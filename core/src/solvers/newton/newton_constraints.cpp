// Newton's method with constraints that may be redundant, or slightly inconsistent.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/newton.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

constexpr double silent_misfit = ConstraintSolver::silent_misfit;
constexpr double torn_apart =
    0.5;  // largest gap of static iterates, relative to the size of the mechanism or in radians

}  // namespace

std::unique_ptr<LinearSolver> NewtonSolver::new_linear_solver() const {
  return make_linear_solver(*pattern_, linear_type(), constraints_.options(newton_options()));
}

// Called at the start of a solution, and after constraints were switched on or off.
[[gnu::noinline]] void NewtonSolver::prepare_constraints() {
  const bool treats =
      sizes_.ae > 0 && settings().redundantConstraints.treat && !settings().linearSolverSettings.ignoreSingularJacobian;
  constraints_.prepare(system(), current(), conditions_, settings().redundantConstraints, treats,
                       is_static() ? ConstraintSolver::Matrix::statics : ConstraintSolver::Matrix::motion);
  if (!constraints_.active()) return;
  linear_ = new_linear_solver();
  conv.jacobianUpdateRequested = true;
}

// The state is that of the initial accelerations, which have just been computed.
void NewtonSolver::prepare_constraints(const ConstraintSolver& known) {
  if (constraints_.is_prepared() || !known.is_prepared()) return;
  constraints_.prepare(known, ConstraintSolver::Matrix::motion);
  if (!constraints_.active() || !linear_) return;
  linear_ = new_linear_solver();
  conv.jacobianUpdateRequested = true;
}

void NewtonSolver::examine_constraints_anew() {
  if (!constraints_.is_prepared()) return;
  minimum_norm_multipliers();
  constraints_.forget();
  rank_known_ = false;
}

double NewtonSolver::gap_of_positions() {
  return constraints_.largest(gaps_of_positions(system(), current(), conditions_));
}

// If static iterates violate constraints, eps is large, and a correction closes only a part of the gaps. Dependent equations
// that were left free, and whose gaps do not close together with the others, are held from then on.
bool NewtonSolver::leaves_constraints_open() {
  constexpr double closed = 1e-10, nearly_closed = 1e-8;  // relative to the size of the mechanism
  constexpr int most_iterations = 3;
  if (!is_static()) return false;
  const auto gaps = std::span<const double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  const double gap = constraints_.largest(gaps), before = std::exchange(loop_.gap, gap);
  if (!(gap > (loop_.iterations_to_close < most_iterations ? closed : nearly_closed))) return false;
  if (constraints_.frees_dependent() && it.newtonSteps > most_iterations && gap > 0.5 * before) {
    constraints_.hold_dependent();
    conv.jacobianUpdateRequested = true;
  }
  loop_.iterations_to_close += conv.residual <= newton_settings.relativeTolerance * loop_.initial_residual;
  return true;
}

void NewtonSolver::begin_step_with_constraints() {
  if (idle_ == Idle::at_factors) idle_ = Idle::at_state;
  misfit_.clear();
  if (!is_static()) constraints_.remember(gap_of_positions());
}

// Selects eps by the gap of the iterate. The prediction of a step violates the constraints.
void NewtonSolver::choose_eps() {
  double gap = 0;
  if (is_static() || !constraints_.joints_fit() || it.newtonSteps <= 1) {
    if (conditions_.rate_level) {
      gap = gap_of_positions();
    } else {
      std::vector<double> gaps(residual_.begin() + sizes_.first_ae(), residual_.end());
      for (std::size_t k = 0; k < misfit_.size(); ++k) gaps[k] += misfit_[k];
      gap = constraints_.largest(gaps);
    }
  }
  if (is_static() && gap > torn_apart) conv.stopNewton = true;  // continues with a smaller load step
  constraints_.choose(gap, conditions_.rate_level);
  constraints_.regularize(*pattern_, jacobian_, metric_scale(), rate_factor(), conditions_.rate_level);
}

// Subtracts the misfit from the residual. Otherwise, multipliers would increase by it in each iteration.
[[gnu::noinline]] void NewtonSolver::take_off_misfit() {
  if (constraints_.joints_fit()) return;
  const auto gaps = std::span<double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  for (std::size_t k = 0; k < misfit_.size(); ++k) gaps[k] += misfit_[k];
  misfit_ = constraints_.misfit(*linear_, gaps);
  for (std::size_t k = 0; k < misfit_.size(); ++k) gaps[k] -= misfit_[k];
}

double NewtonSolver::residual_without_misfit() {
  const auto gaps = std::span<double>(residual_).subspan(static_cast<std::size_t>(sizes_.first_ae()));
  for (std::size_t k = 0; k < gaps.size(); ++k) gaps[k] -= misfit_[k];
  return norm_of(unscaled_residual());
}

// Multipliers start at zero in each step, so that the removal of their null-space part does not change the motion. It is
// done when they are read, with the constraint forces of the current state if those of the factors differ.
const std::vector<double>* NewtonSolver::minimum_norm_multipliers() {
  const Idle idle = std::exchange(idle_, Idle::none);
  if (idle == Idle::none) return nullptr;
  if (idle == Idle::at_factors) {
    constraints_.make_smallest(*linear_, current().lambda);
  } else {
    if (!forces_) prepare(*(forces_ = std::make_unique<ConstrainedMotion>()));
    forces_->make_smallest(constraints_, system(), current(), conditions_, current().lambda);
  }
  return nullptr;
}

// Called after convergence of Newton's method. Returns false if the misfit exceeds the setting.
[[gnu::noinline]] bool NewtonSolver::settle_multipliers() {
  if (!constraints_.active()) {
    find_rank();
    return true;
  }
  double misfit = misfit_.empty() ? 0 : constraints_.largest(misfit_);
  if (conditions_.rate_level) misfit = 0;
  if (misfit > settings().redundantConstraints.largestMisfit) {
    conv.newtonConverged = false;
    conv.stopNewton = contradiction_ = true;
    return false;
  }
  contradiction_ = false;
  if (misfit > silent_misfit && !conditions_.rate_level) diagnostics_->warn_of_contradiction(misfit_);
  largest_misfit_ = std::max(largest_misfit_, misfit);
  // Rows of velocity constraints differ from constraint forces, and static stiffness may be nearly singular: in these cases,
  // the factors cannot compute minimum-norm multipliers.
  idle_ = full_newton_ && !conditions_.rate_level && !is_static() ? Idle::at_factors : Idle::at_state;
  if (!rank_known_) [[unlikely]] {  // the start may have had gaps, or may have been a singular position
    find_rank();
    if (!constraints_.active()) return true;
  }
  if (!multipliers_may_wait() && !conditions_.rate_level) minimum_norm_multipliers();
  return true;
}

}  // namespace dalembert
