// Divergence detection of explicit solvers: values that are not finite or out of bounds.
#include <algorithm>
#include <cmath>
#include <exception>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "dalembert/system/large_vectors.hpp"
#include "diagnosis/finite.hpp"
#include "diagnosis/stability.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

// Growth of the sum of squares of coordinates and velocities after which linear theory is evaluated, and the factor for
// further evaluations: if velocities change within a step by their own size, or after enormous growth.
constexpr double noticeable_growth = 100, enormous_growth = 1e20, further_growth = 4;
// Predicted amplification that makes the steps the cause of the growth.
constexpr double predicted_growth = 1e5;

double size_of_motion(const System& system, const State& state) {
  return sum_of_squares(system, state.q) + sum_of_squares(system, state.v);
}

}  // namespace

void ExplicitSolver::begin_to_watch() {
  fastest_.reset();
  growth_limit_ = std::min(newton_settings.maximumSolutionNorm, unbounded * unbounded);
  watches_coordinates_ = newton_settings.maximumSolutionNorm < NewtonSettings{}.maximumSolutionNorm;
  if (it.automaticStepSize) return;  // error control keeps steps stable
  growth_limit_ = std::min(growth_limit_, noticeable_growth * size_at_start());
}

double ExplicitSolver::size_at_start() { return std::max(1.0, size_of_motion(system(), initial())); }

// Returns whether the state has diverged, as opposed to large initial values.
[[gnu::noinline]] bool ExplicitSolver::outgrown() {
  const State& now = current();
  const double largest = std::min(newton_settings.maximumSolutionNorm, unbounded * unbounded);
  if (!all_finite(now) ||
      !(size_of_motion(system(), now) < largest && sum_of_squares(system(), now.y) < unbounded * unbounded))
    return true;
  const double size = size_of_motion(system(), now), enormous = enormous_growth * size_at_start(),
               h = it.currentStepSize;
  growth_limit_ = std::min(largest, size < enormous ? std::min(further_growth * size, enormous) : largest);
  const bool is_rough = h * h * sum_of_squares(system(), now.a) > sum_of_squares(system(), now.v);
  return (is_rough || size >= enormous) && theory_explains_growth();
}

bool ExplicitSolver::theory_explains_growth() {
  return std::pow(amplification_of(fastest_at_start(), it.currentStepSize), it.currentStepIndex) > predicted_growth;
}

double ExplicitSolver::amplification_of(const Vibration& vibration, double step_size) const {
  return verlet_ ? verlet_amplification(vibration, step_size) : amplification(method_, vibration, step_size);
}

// User functions may raise any exception; the result is then empty.
const Vibration& ExplicitSolver::fastest_at_start() {
  if (fastest_) return *fastest_;
  fastest_.emplace();
  State still = initial();
  std::ranges::fill(still.a, 0.0);
  std::ranges::fill(still.lambda, 0.0);
  if (still.q.empty()) return *fastest_;
  try {
    if (constrained_)
      *fastest_ = fastest_with_constraints(still);
    else if (mass_.update(system(), still) == LinearSolver::success)
      *fastest_ = fastest_vibration(
          system(), still, conditions_,
          [&](Vector& x) { return mass_.solve(system(), still, x) == LinearSolver::success; }, eliminated_);
  } catch (const std::exception&) {
  }
  return *fastest_;
}

Vibration ExplicitSolver::fastest_with_constraints(const State& still) {
  ConstrainedMotion motion;
  prepare(motion);
  const bool regular = motion.factorize(system(), still, conditions_) == LinearSolver::success;
  if (!regular) return {};
  Vector all(static_cast<std::size_t>(sizes_.total()));
  const auto accelerate = [&](Vector& x) {
    std::fill(std::ranges::copy(x, all.begin()).out, all.end(), 0.0);
    motion.solve(all);
    std::copy_n(all.begin(), x.size(), x.begin());
    return true;
  };
  return fastest_vibration(system(), still, conditions_, accelerate, {});
}

// Always returns false. A much smaller step may succeed with error control; otherwise the solver stops.
[[gnu::noinline]] bool ExplicitSolver::lose_step() {
  conv.newtonConverged = conv.linearSolverFailed = conv.massMatrixNotInvertible = false;
  if (it.automaticStepSize && !steps_.at_minimum()) {
    steps_.shrink_by_error(0.1);
    return false;
  }
  conv.stopNewton = true;
  diagnose_growth();
  return false;
}

void ExplicitSolver::diagnose_growth() {
  if (find_bad_evaluation() || !all_finite(current())) return diagnostics_->diagnose_not_finite();
  Diagnosis& d = diagnostics_->diagnose(FailureReason::unbounded);
  diagnostics_->add_largest(d.values, current().q, "ODE2", 0);
  diagnostics_->add_largest(d.values, current().v, "ODE2_t", 0);
  diagnostics_->add_largest(d.values, current().y, "ODE1", sizes_.ode2);
  advise_on_growth();
  d.advice.push_back("check parameters and loads of the items named above for wrong units and signs");
  d.advice.push_back(
      "if numbers of this size are meant, raise timeIntegration.newton.maximumSolutionNorm, with which the squared "
      "norms of "
      "coordinates and velocities are compared");
}

// Repeats the step up to the first evaluation that is not finite, and leaves its state as the current one.
bool ExplicitSolver::find_bad_evaluation() {
  const State after = current();
  current() = start_of_step();
  searching_ = true;
  first_stage_known_ = false;
  compute_step();
  searching_ = false;
  const bool found = conv.linearSolverFailed;
  conv.linearSolverFailed = conv.massMatrixNotInvertible = false;
  if (!found) current() = after;
  return found;
}

[[gnu::noinline]] bool ExplicitSolver::is_good(const Vector& a, std::span<const double> y_t) {
  if (all_finite(a) && all_finite(y_t)) return true;
  State& now = current();
  if (&a != &now.a) now.a = a;
  std::copy(y_t.begin(), y_t.end(), now.y_t.begin());
  conv.linearSolverFailed = true;
  return false;
}

void ExplicitSolver::advise_on_growth() {
  const Vibration& fastest = fastest_at_start();
  const double h = it.currentStepSize;
  const auto amplified = [&](double step_size) { return amplification_of(fastest, step_size); };
  if (const double stable = largest_stable_step(fastest, h, amplified); stable < h) {
    const std::string what =
        fastest.creeps()
            ? "what is damped fastest at the start, by a rate of " + format_number(fastest.rate()) + " 1/s at "
            : "the fastest vibration at the start, " + format_number(fastest.frequency) + " rad/s at ";
    std::string text = what + system().describe_row(fastest.coordinate) + ", grows with these steps; ";
    text += stable > 0 ? "this method is stable with steps up to " + format_number(stable, 3) +
                             " s, timeIntegration.numberOfSteps=" +
                             format_number(std::ceil((it.endTime - it.startTime) / stable), 10)
                       : "this method amplifies it with all steps";
    diagnosis_.advice.push_back(std::move(text));
  } else {
    Solver::advise_on_growth();
  }
  diagnosis_.advice.push_back(
      "use an implicit solver (exu.DynamicSolverType.GeneralizedAlpha), which stays stable with larger steps");
}

[[gnu::noinline]] void ExplicitSolver::mass_failed(int row) {
  conv.linearSolverFailed = conv.massMatrixNotInvertible = true;
  conv.linearSolverCausingRow = row;
  diagnostics_->diagnose(FailureReason::mass_matrix).advice = {
      "give every coordinate of these items mass or inertia: explicit solvers divide by it",
      "use an implicit solver (exu.DynamicSolverType.GeneralizedAlpha), which needs no mass"};
}

}  // namespace dalembert
