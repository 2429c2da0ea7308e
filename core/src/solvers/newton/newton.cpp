#include "dalembert/solvers/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/math/few_numbers.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "diagnosis/finite.hpp"
#include "diagnosis/matrix_text.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// A loop has stagnated when so many iterations in a row have not lowered the best residual by a tenth ...
constexpr int idle_iterations = 3;
// ... although they move the coordinates by less than this, relative to their size ...
constexpr double negligible_increment = 1e-9;
// ... and the residual is at most so many times the rounding errors of the terms that cancel in it.
constexpr double rounding_errors = 1000;
// If there are no loads, the residual consists of rounding errors, which move soft coordinates by up to this size.
constexpr double own_rounding_errors = 10, moved_by_rounding = 1e-6;

// The reduction of the residual in the first iteration measures the nonlinearity of the step, which is proportional to the
// square of the step size, as are integration errors. Below this reduction, the tolerance decreases in proportion ...
constexpr double fine_step = 1e-2;
// ... down to this fraction.
constexpr double negligible_rest = 1e-4;

// Springs and bodies that start along the axes leave most of their Jacobian zero until they have moved.
constexpr int first_jacobians = 8;

}  // namespace

void NewtonSolver::initialize_data() {
  Solver::initialize_data();
  system().complete_pattern();
  full_newton_ = !newton_settings.useModifiedNewton;
  constraints_.forget();
  misfit_.clear();
  take_pattern();
  const auto n = static_cast<std::size_t>(sizes_.total());
  residual_.assign(n, 0.0);
  increment_.assign(n, 0.0);
  idle_ = Idle::none;
}

// Factors remember the pivots of earlier matrices.
void NewtonSolver::forget() {
  Solver::forget();
  full_newton_ = !newton_settings.useModifiedNewton;
  constraints_.forget();
  forces_.reset();
  take_pattern();
  conv.jacobianUpdateRequested = true;
}

void NewtonSolver::pattern_revised() {
  take_pattern();
  conv.jacobianUpdateRequested = true;
}

void NewtonSolver::take_pattern() {
  const Pattern* pattern = &system().pattern(dense());
  if (idle_ == Idle::at_factors) idle_ = Idle::at_state;
  forces_.reset();
  factorized_ = false;
  pattern_ = pattern;
  constraints_.pattern_revised();
  linear_ = new_linear_solver();
  jacobian_.assign(static_cast<std::size_t>(pattern->values()), 0.0);
}

LinearSolverOptions NewtonSolver::newton_options() const {
  LinearSolverOptions options = linear_options();
  options.unsettled_matrices = full_newton_ ? first_jacobians : 0;
  return options;
}

double NewtonSolver::evaluate_residual() {
  if (hooks().pre_newton_residual) {
    const TimedPart time(timer, timer.python);
    hooks().pre_newton_residual(it.currentTime, it.newtonSteps, it.discontinuousIteration);
  }
  const double norm = compute_residual();
  return misfit_.empty() ? norm : residual_without_misfit();
}

// All parts are inlined, because calls dominate the time of small systems.
[[gnu::flatten]] bool NewtonSolver::newton() {
  contradiction_ = false;
  if (iterate_to_the_end() || solves_with_dependent_constraints()) return true;
  report_failure();
  return false;
}

[[gnu::always_inline]] inline bool NewtonSolver::iterate_to_the_end() {
  begin_newton();
  judge_start(evaluate_residual());
  while (goes_on()) {
    if (sizes_.total() > 200) {
      poll_interrupt();
    }
    iterate();
  }
  if (!succeeded()) return false;
  if (leaves_correction()) correct_motion();
  return sizes_.ae == 0 || (rank_known_ && !constraints_.active()) || settle_multipliers();
}

// A second attempt, where constraints may depend on each other that did not at the start.
[[gnu::noinline]] bool NewtonSolver::solves_with_dependent_constraints() {
  if (!(conv.residual < unbounded) || !constraints_.activate()) return false;
  linear_ = new_linear_solver();
  reset_to_start_of_step();
  conv.jacobianUpdateRequested = true;
  if (iterate_to_the_end()) return true;
  solve_as_regular();
  return false;
}

void NewtonSolver::solve_as_regular() {
  if (conv.newtonConverged) minimum_norm_multipliers();
  constraints_.deactivate();
  misfit_.clear();
  idle_ = Idle::none;
  linear_ = new_linear_solver();
  conv.jacobianUpdateRequested = true;
}

// Multipliers start from zero, coordinates from the prediction of the integrator.
void NewtonSolver::begin_newton() {
  conv.linearSolverFailed = conv.newtonConverged = conv.newtonSolutionDiverged = conv.stopNewton = false;
  conv.newtonStagnated = false;
  conv.linearSolverCausingRow = -1;
  full_newton_ = !newton_settings.useModifiedNewton;
  loop_ = Loop();
  if (!constraints_.is_prepared()) [[unlikely]]
    prepare_constraints();
  if (constraints_.active()) [[unlikely]]
    begin_step_with_constraints();
  State& now = current();
  clear_numbers(now.lambda.data(), now.lambda.size());
  clear_numbers(increment_.data(), increment_.size());
  compute_update(true);
  it.newtonSteps = 0;
}

void NewtonSolver::judge_start(double residual) {
  loop_.initial_residual = std::max(residual, least_initial_residual_);
  conv.stopNewton = loop_.lost = !(residual < unbounded);
  if (newton_settings.newtonResidualMode == 1) loop_.initial_residual = 2 * newton_settings.relativeTolerance;
  if (loop_.initial_residual <= newton_settings.absoluteTolerance) {
    loop_.initial_residual = 2 * newton_settings.absoluteTolerance;  // at least one iteration, no division by zero
  }
  conv.residual = conv.lastResidual = loop_.best_residual = initial_residual_ = loop_.initial_residual;
  conv.contractivity = 0;
  if (verbose(2)) say(2, "  Newton: initial residual = " + number(loop_.initial_residual) + "\n");
}

bool NewtonSolver::goes_on() const {
  return !conv.linearSolverFailed && !conv.newtonConverged && !conv.stopNewton &&
         it.newtonSteps < newton_settings.maxIterations;
}

bool NewtonSolver::factorize() {
  const TimedPart time(timer, timer.factorization);
  if (constraints_.active()) [[unlikely]]
    choose_eps();
  conv.linearSolverCausingRow = linear_->factorize(jacobian_);
  conv.linearSolverFailed = conv.linearSolverCausingRow != LinearSolver::success;
  factorized_ = !conv.linearSolverFailed;
  return !conv.linearSolverFailed;
}

bool NewtonSolver::begin_iteration() {
  ++it.newtonSteps;
  ++it.newtonStepsCount;
  const bool requested = hooks().jacobian_update_requested && hooks().jacobian_update_requested();
  return conv.jacobianUpdateRequested || full_newton_ || requested;
}

void NewtonSolver::jacobian_renewed() {
  ++it.newtonJacobiCount;
  conv.jacobianUpdateRequested = false;
  if (verbose(2)) say(2, "    Jacobian updated\n");
}

void NewtonSolver::iterate() {
  if (begin_iteration()) {
    {
      const TimedPart time(timer, timer.totalJacobian);
      compute_jacobian();
    }
    if (verbose(4)) announce_matrices();
    if (!factorize()) {
      conv.stopNewton = true;
      return;
    }
    jacobian_renewed();
    if (verbose(5)) announce_inverse();
  }
  correct_motion();
  judge(evaluate_residual());
}

// Corrects the state by the current residual and factors.
void NewtonSolver::correct_motion() {
  if (constraints_.active()) [[unlikely]]
    take_off_misfit();
  {
    const TimedPart time(timer, timer.newtonIncrement);
    copy_numbers(residual_.data(), residual_.size(), increment_.data());
    linear_->solve(increment_);
  }
  compute_update(false);
}

// A correction by the last residual needs no further evaluation. Without it, the remaining errors of fine steps would add up
// to more than their integration errors.
bool NewtonSolver::leaves_correction() const {
  if (!newton_settings.useNewtonSolver || conv.newtonStagnated) return false;
  const double share = std::clamp(loop_.first_residual / (fine_step * loop_.initial_residual), negligible_rest, 1.0);
  return conv.residual > share * newton_settings.relativeTolerance * loop_.initial_residual;
}

void NewtonSolver::judge(double residual) {
  conv.residual = residual;
  if (newton_settings.newtonResidualMode == 1) {
    const std::span<const double> all(increment_);
    conv.residual = (std::sqrt(sum_of_squares<double>(all.first(static_cast<std::size_t>(sizes_.ode2)))) +
                     std::sqrt(sum_of_squares<double>(
                         all.subspan(static_cast<std::size_t>(sizes_.ode2), static_cast<std::size_t>(sizes_.ode1))))) /
                    conv.errorCoordinateFactor;
  }
  if (verbose(2)) {
    say(2, "    Newton iteration " + std::to_string(it.newtonSteps) + ": residual = " + number(conv.residual) +
               ", relative = " + number(conv.residual / loop_.initial_residual) +
               ", contractivity = " + number(conv.residual / conv.lastResidual) + "\n");
  }
  if (it.newtonSteps == 1) loop_.first_residual = conv.residual;
  loop_.lost = !(residual < unbounded);
  conv.newtonConverged = !loop_.lost && check_convergence();
  if (loop_.one_more_step && conv.newtonConverged) {
    loop_.one_more_step = conv.newtonConverged = false;
  } else if (!conv.newtonConverged) {
    loop_.one_more_step = false;
    treat_slow_convergence();
  }
}

bool NewtonSolver::check_convergence() {
  if (newton_settings.adaptInitialResidual && conv.residual > loop_.initial_residual && it.newtonSteps <= 1) {
    loop_.initial_residual = initial_residual_ = conv.lastResidual = conv.residual;
  }
  if (constraints_.active() && leaves_constraints_open()) return false;
  if (conv.residual / loop_.initial_residual <= newton_settings.relativeTolerance || !newton_settings.useNewtonSolver ||
      conv.residual <= newton_settings.absoluteTolerance) {
    return true;
  }
  loop_.idle = conv.residual < 0.9 * loop_.best_residual ? 0 : loop_.idle + 1;
  loop_.best_residual = std::min(loop_.best_residual, conv.residual);
  if (loop_.idle < idle_iterations || newton_settings.newtonResidualMode != 0) return false;
  const double moved = relative_increment();
  if (!(moved < moved_by_rounding)) return false;
  const double allowed = stagnated() && moved < negligible_increment ? rounding_errors : own_rounding_errors;
  if (!loop_.round_off) loop_.round_off = find_round_off_level();
  if (!(conv.residual <= allowed * *loop_.round_off)) return false;
  conv.newtonStagnated = true;
  ++it.stagnatedNewtonSteps;
  if (verbose(2)) say(2, "    the residual does not fall any more: round-off is reached\n");
  return true;
}

// Idle multipliers of small steps grow by the round-off of gaps, and rounding errors with them, where redundancy lasts.
bool NewtonSolver::stagnated() const {
  return loop_.idle >= idle_iterations && (conv.residual <= 10 * loop_.best_residual || constraints_.active()) &&
         newton_settings.newtonResidualMode == 0;
}

// Size of the last increment of the coordinates against their total values.
[[gnu::noinline]] double NewtonSolver::relative_increment() {
  const State& now = current();
  const State& reference = system().state(ConfigurationType::Reference);
  double total = sum_of_squares<double>(now.y);
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    const double q = now.q[i] + (i < reference.q.size() ? reference.q[i] : 0.0);
    total += q * q;
  }
  const std::span<const double> all(increment_);
  const double moved = sum_of_squares<double>(all.first(static_cast<std::size_t>(sizes_.first_ae())));
  return std::sqrt(moved) / std::max(std::sqrt(total), 1e-5);
}

// Rounding errors to be expected in the residual: eps |K| |q| + eps |D| |v| + eps |M| |a| + eps |G^T| |lambda|, after Oettli
// and Prager (1964).
[[gnu::noinline]] double NewtonSolver::find_round_off_level() {
  const State& now = current();
  const State& reference = system().state(ConfigurationType::Reference);
  const int n = sizes_.ode2, first_ae = sizes_.first_ae();
  std::vector<double> values(jacobian_.size()), size(static_cast<std::size_t>(sizes_.total()), 0.0);
  const auto magnitude = [&](int column) {
    if (column < n) return std::abs(now.q[column]) + (reference.q.empty() ? 0.0 : std::abs(reference.q[column]));
    return column < first_ae ? std::abs(now.y[column - n]) : std::abs(now.lambda[column - first_ae]);
  };
  Conditions conditions = conditions_;
  conditions.follows_residual = true;
  system().tangent(now, conditions, {.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0}, pattern(), values);
  for_each_entry(pattern(),
                 [&](int row, int column, std::size_t k) { size[row] += std::abs(values[k]) * magnitude(column); });
  if (!is_static()) {
    system().tangent(now, conditions, {.q = 0, .v = 1, .a = 0, .y = 0, .y_t = 0}, pattern(), values);
    for_each_entry(pattern(), [&](int row, int column, std::size_t k) {
      if (column < n) size[row] += std::abs(values[k] * now.v[column]);
    });
    system().mass_matrix(now, pattern(), values);
    for_each_entry(pattern(), [&](int row, int column, std::size_t k) {
      if (row < n && column < n) size[row] += std::abs(values[k] * now.a[column]);
    });
  }
  return std::numeric_limits<double>::epsilon() * std::sqrt(sum_of_squares<double>(size)) / conv.errorCoordinateFactor;
}

// Squares of norms are compared with maximumSolutionNorm, as users of this setting are used to.
bool NewtonSolver::diverged() {
  if (loop_.lost) return true;
  const State& now = current();
  const double limit = newton_settings.maximumSolutionNorm;
  const double q = sum_of_squares(system(), now.q), v = is_static() ? 0 : sum_of_squares(system(), now.v),
               lambda = sum_of_squares(system(), now.lambda);
  return q >= limit || v >= limit || std::isnan(q) || std::isnan(v) || std::isnan(lambda);
}

// Modified Newton first asks for a new Jacobian, then for full Newton; if it diverges, it starts again.
[[gnu::noinline]] void NewtonSolver::treat_slow_convergence() {
  conv.newtonSolutionDiverged = false;
  if (diverged()) {
    if (full_newton_) {
      conv.stopNewton = true;
      say(1, "  the solution diverged\n");
    } else {
      conv.newtonSolutionDiverged = true;
    }
  }
  const NewtonSettings& s = newton_settings;
  if (!full_newton_ && it.newtonSteps > s.maxModifiedNewtonIterations) {
    conv.jacobianUpdateRequested = true;
    const int further = s.modifiedNewtonJacUpdatePerStep ? 0 : s.maxModifiedNewtonRestartIterations;
    if (it.newtonSteps > s.maxModifiedNewtonIterations + further) {
      full_newton_ = true;
      ++it.rejectedModifiedNewtonSteps;
    }
  }
  conv.contractivity = conv.residual / conv.lastResidual;
  conv.lastResidual = conv.residual;
  const bool bad_contractivity = conv.contractivity > s.modifiedNewtonContractivity && it.newtonSteps > 2;
  if (full_newton_ || !(conv.newtonSolutionDiverged || bad_contractivity)) return;
  conv.jacobianUpdateRequested = true;
  if (loop_.restarted) {
    full_newton_ = true;
    ++it.rejectedModifiedNewtonSteps;
  }
  if (!conv.stopNewton && (conv.newtonSolutionDiverged || conv.contractivity > 2 || full_newton_)) restart();
}

void NewtonSolver::restart() {
  loop_.restarted = true;
  conv.residual = conv.lastResidual = loop_.initial_residual;
  reset_to_start_of_step();
  std::fill(current().lambda.begin(), current().lambda.end(), 0.0);
  std::fill(increment_.begin(), increment_.end(), 0.0);
  compute_update(true);
  evaluate_residual();
  loop_.one_more_step = true;
  loop_.idle = 0;
  loop_.round_off.reset();
  if (verbose(2)) say(2, "    Newton started again from the beginning of the step\n");
}

[[gnu::noinline]] void NewtonSolver::report_failure() {
  const bool lost = !all_finite(jacobian_) || loop_.lost;
  const bool has_left = !lost && !diagnostics_->contradiction_text().empty() && !misfit_.empty() &&
                        diagnostics_->has_left_constraints(misfit_);
  const bool apart = !lost && !conditions_.rate_level && !misfit_.empty() &&
                     constraints_.largest(misfit_) > settings().redundantConstraints.largestMisfit;
  if (contradiction_ || has_left || apart) return diagnostics_->diagnose_contradiction(misfit_);
  if (lost)
    report_not_finite();
  else if (conv.linearSolverFailed)
    diagnostics_->diagnose_singular_matrix(*pattern_, jacobian_);
  else
    diagnostics_->diagnose(FailureReason::newton, unscaled_residual());
  if (lost || conv.linearSolverFailed) return;
  if ((output.stepInformation & step_information::step_reductions) || verbose(2)) {
    say(1, "  Newton (step " + std::to_string(it.currentStepIndex) + ", t = " + number(it.currentTime) +
               ") did not converge in " + std::to_string(it.newtonSteps) +
               " iterations; relative error = " + number(conv.residual / loop_.initial_residual) + "\n");
  }
}

std::vector<double> NewtonSolver::unscaled_residual() const {
  std::vector<double> residual = residual_;
  for (int i = 0; i < sizes_.ode2; ++i) residual[i] /= row_scale();
  return residual;
}

// A matrix that is not finite makes all coordinates so: its rows are named then. Other steps may lead past such a place.
void NewtonSolver::report_not_finite() {
  conv.linearSolverFailed = conv.massMatrixNotInvertible = false;
  std::vector<double> rows = unscaled_residual();
  if (!all_finite(jacobian_)) {
    std::ranges::fill(rows, 0.0);
    for_each_entry(*pattern_, [&](int row, int, std::size_t slot) { rows[row] += 0 * jacobian_[slot]; });
    current() = start_of_step();
  }
  diagnostics_->diagnose_not_finite(rows);
}

[[gnu::noinline]] void NewtonSolver::announce_matrices() {
  const int digits = settings().outputPrecision;
  if (!is_static() && sizes_.ode2 > 0) {
    std::vector<double> mass(jacobian_.size());
    system().mass_matrix(current(), pattern(), mass);
    say(4, "  mass matrix =\n    " + matrix_text(dense_rows(pattern(), mass, sizes_.ode2), sizes_.ode2, digits) + "\n");
  }
  say(4, "  Jacobian =\n    " + matrix_text(dense_rows(pattern(), jacobian_, sizes_.total()), sizes_.total(), digits) +
             "\n");
}

// Column by column from the factors.
[[gnu::noinline]] void NewtonSolver::announce_inverse() {
  const auto n = static_cast<std::size_t>(sizes_.total());
  std::vector<double> inverse(n * n), column(n);
  for (std::size_t j = 0; j < n; ++j) {
    std::fill(column.begin(), column.end(), 0.0);
    column[j] = 1;
    linear_->solve(column);
    for (std::size_t i = 0; i < n; ++i) inverse[i * n + j] = column[i];
  }
  say(5, "  inverse of the Jacobian =\n    " + matrix_text(inverse, sizes_.total(), settings().outputPrecision) + "\n");
}

void NewtonSolver::free_memory() {
  linear_.reset();
  for (std::vector<double>* numbers : {&residual_, &increment_, &jacobian_}) *numbers = {};
}

}  // namespace dalembert
