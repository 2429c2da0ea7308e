// Explicit solvers: steps that lead to numbers that are not finite, or out of all bounds.
#include <algorithm>
#include <cmath>
#include <exception>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "dalembert/system/large_vectors.hpp"
#include "finite.hpp"
#include "stability.hpp"

namespace dalembert {

namespace {

// When the sum of squares of coordinates and velocities has grown by so much, theory is asked whether the steps are the reason ...
constexpr double noticeable_growth = 1e20;
// ... which they are if it predicts at least so much for the numbers themselves.
constexpr double predicted_growth = 1e5;

double size_of_motion(const System& system, const State& state) { return sum_of_squares(system, state.q) + sum_of_squares(system, state.v); }

}  // namespace

void ExplicitSolver::begin_to_watch() {
  growth_limit_ = std::min(newton_settings.maximumSolutionNorm, unbounded * unbounded);
  watches_coordinates_ = newton_settings.maximumSolutionNorm < NewtonSettings{}.maximumSolutionNorm;
  if (it.automaticStepSize) return;  // keeps to stable steps
  growth_limit_ = std::min(growth_limit_, noticeable_growth * std::max(1.0, size_of_motion(system(), current())));
}

// Whether the state is lost, not only larger than was to be expected at the start. Theory is asked once.
[[gnu::noinline]] bool ExplicitSolver::outgrown() {
  const State& now = current();
  const double largest = std::min(newton_settings.maximumSolutionNorm, unbounded * unbounded);
  if (!all_finite(now) || !(size_of_motion(system(), now) < largest && sum_of_squares(system(), now.y) < unbounded * unbounded)) return true;
  growth_limit_ = largest;
  return theory_explains_growth();
}

bool ExplicitSolver::theory_explains_growth() {
  const Vibration fastest = fastest_at_start();
  return std::pow(amplification_of(fastest, it.currentStepSize), it.currentStepIndex) > predicted_growth;
}

double ExplicitSolver::amplification_of(const Vibration& vibration, double step_size) const {
  return verlet_ ? verlet_amplification(vibration, step_size) : amplification(method_, vibration, step_size);
}

// User functions may raise what they like: then nothing is known.
Vibration ExplicitSolver::fastest_at_start() {
  try {
    return fastest_vibration(system(), initial(), conditions_, mass_, eliminated_);
  } catch (const std::exception&) {
    return {};
  }
}

// False, always: with error control, a much smaller step may do; otherwise the solver gives up.
[[gnu::noinline]] bool ExplicitSolver::lose_step() {
  conv.newtonConverged = conv.linearSolverFailed = conv.massMatrixNotInvertible = false;
  if (it.automaticStepSize && it.currentStepSize > it.minStepSize) {
    ++it.rejectedAutomaticStepSizeSteps;
    it.currentStepSize = std::max(it.minStepSize, 0.1 * it.currentStepSize);
    return false;
  }
  conv.stopNewton = true;
  diagnose_growth();
  return false;
}

void ExplicitSolver::diagnose_growth() {
  if (find_bad_evaluation() || !all_finite(current())) return diagnose_not_finite();
  Diagnosis& d = diagnose(FailureReason::unbounded);
  add_largest(d.values, current().q, "ODE2", 0);
  add_largest(d.values, current().v, "ODE2_t", 0);
  add_largest(d.values, current().y, "ODE1", sizes_.ode2);
  advise_on_growth();
  d.advice.push_back("check parameters and loads of the items named above for wrong units and signs");
  d.advice.push_back("if numbers of this size are meant, raise timeIntegration.newton.maximumSolutionNorm, with which the squared norms of "
                     "coordinates and velocities are compared");
}

// Repeats the step up to the first evaluation that is not finite; the current state is that of this evaluation.
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
  const Vibration fastest = fastest_at_start();
  const double h = it.currentStepSize;
  const auto amplified = [&](double step_size) { return amplification_of(fastest, step_size); };
  if (const double stable = largest_stable_step(fastest, h, amplified); stable < h) {
    std::string text = "the fastest vibration at the start, " + format_number(fastest.frequency) + " rad/s at " +
                       system().describe_row(fastest.coordinate) + ", grows with these steps; ";
    text += stable > 0 ? "this method is stable with steps up to " + format_number(stable, 3) + " s, timeIntegration.numberOfSteps=" +
                             format_number(std::ceil((it.endTime - it.startTime) / stable), 10)
                       : "this method amplifies it with all steps";
    diagnosis_.advice.push_back(std::move(text));
  } else {
    Solver::advise_on_growth();
  }
  diagnosis_.advice.push_back("use an implicit solver (exu.DynamicSolverType.GeneralizedAlpha), which stays stable with larger steps");
}

[[gnu::noinline]] void ExplicitSolver::mass_failed(int row) {
  conv.linearSolverFailed = conv.massMatrixNotInvertible = true;
  conv.linearSolverCausingRow = row;
  diagnose(FailureReason::mass_matrix).advice = {
      "give every coordinate of these items mass or inertia: explicit solvers divide by it",
      "use an implicit solver (exu.DynamicSolverType.GeneralizedAlpha), which needs no mass"};
}

}  // namespace dalembert
