// Error control of explicit solvers: Hairer, Norsett, Wanner I, section II.4.
#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/explicit.hpp"
#include "dalembert/system/switches.hpp"
#include "constraints/singular_positions.hpp"
#include "control/events.hpp"
#include "diagnosis/diagnostics.hpp"

namespace dalembert {

namespace {

constexpr int few_steps = 4;  // number of steps of minimum size before the stability of their errors is checked

}  // namespace

// Returns an error in units of the tolerances. The scale has signed values instead of magnitudes, for the same step
// sizes as in Exudyn, and is bounded from below where value and tolerance cancel.
double ExplicitSolver::scaled_error(double second, double first, double old) const {
  if (!third_.empty()) return (second - first) / tolerances_.of(std::max(std::abs(first), std::abs(old)));
  const double scale = tolerances_.absolute + std::max(second, old) * tolerances_.relative;
  return (second - first) / std::max(std::abs(scale), 0.01 * tolerances_.absolute);
}

// Uses a third approximation, since two may agree by chance.
double ExplicitSolver::estimated_error() {
  if (third_.empty()) return distance_of(second_);
  const double third = distance_of(third_), second = distance_of(second_);
  return second == 0 ? 0 : second * second / std::sqrt(second * second + 0.01 * third * third);
}

// Returns the root mean square of the difference from the solution over ODE1, positions and velocities.
double ExplicitSolver::distance_of(const StageWeights& approximation) {
  move_from_start(approximation, second_q_, second_v_, second_y_);
  eliminate(second_q_);
  eliminate(second_v_);
  const State &now = current(), &start = start_of_step();
  double sum = 0;
  const auto add_errors = [&](const Vector& second, const Vector& first, const Vector& old) {
    for (std::size_t i = 0; i < second.size(); ++i) {
      const double e = scaled_error(second[i], first[i], old[i]);
      sum += e * e;
    }
  };
  add_errors(second_y_, now.y, start.y);
  add_errors(second_q_, now.q, start.q);
  add_errors(second_v_, now.v, start.v);
  return std::sqrt(sum / (sizes_.ode1 + 2 * sizes_.ode2));
}

// Returns false if the step has to be repeated, or if the solver stops.
bool ExplicitSolver::control_step_size() {
  if (steps_.ends_are_prescribed()) return true;
  const TimedPart time(timer, timer.errorEstimator);
  it.automaticStepSizeError = estimated_error();
  if (std::isnan(it.automaticStepSizeError)) return lose_step();
  const double error = it.automaticStepSizeError == 0 ? 1e-12 : it.automaticStepSizeError;
  const double h = it.currentStepSize;
  const double optimal = h * std::pow(1 / error, 1.0 / method_.order);
  if (optimal < h && singular_->passes(error)) return !(conv.stopNewton = singular_->stays());
  if (optimal < h && h <= it.minStepSize) {
    const bool grows = (steps_.above_tolerance() + 1) % few_steps == 0 && at_stability_limit(h);
    if (grows) diagnose_error_control();
    if (!grows && hold_at_minimum()) {
      steps_.use(it.minStepSize);  // the last step may be smaller
      return true;
    }
    conv.newtonConverged = false;
    conv.stopNewton = true;
    return false;
  }
  steps_.propose(tolerances_.safety * optimal);
  steps_.within_tolerance();
  if (!(optimal < h)) {
    look_for_stiffness(h);
    return true;
  }
  if (sizes_.ae > 0 && it.currentStepSize < StepController::aside * h && singular_->steps_aside())
    steps_.use(StepController::aside * h);
  steps_.repeat_by_error();
  return false;
}

bool ExplicitSolver::discontinuous_iteration() {
  const bool settled = Solver::discontinuous_iteration();
  const bool something_switched = it.discontinuousIteration > 1 || conv.discontinuousIterationError > 0;
  if (watches_switches_ && settled && something_switched) [[unlikely]]
    tell_of_switches();
  return settled;
}

// Warns of items that switch: they keep their state during a step, and so do all approximations that are compared.
[[gnu::noinline]] void ExplicitSolver::tell_of_switches() {
  State end = current();
  end.data = start_of_step().data;
  std::vector<Switch> switches;
  system().find_switches(end, conditions_, switches);
  const auto over = std::ranges::find_if(
      switches, [](const Switch& at) { return at.owner == nullptr && !at.kink && at.value < -at.noise; });
  if (over == switches.end()) return;
  watches_switches_ = false;
  warn(name() + ": " + events_->describe_switch(*over) + " lies within the step of " +
       format_number(conditions_.step_size, 3) + " s that ends at time " + format_number(it.currentTime) +
       ". Items switch at the ends of steps, which estimated errors do not see: results may be off by more than the "
       "tolerances. "
       "simulationSettings.events.ofItems=True lets steps end where items switch");
}

void ExplicitSolver::diagnose_error_control() {
  const State& reference = system().state(ConfigurationType::Reference);
  double noise = 0;  // round-off of coordinates, in units of the tolerances
  for (std::size_t i = 0; i < current().q.size(); ++i) {
    const double q = std::abs(current().q[i]);
    noise =
        std::max(noise, std::numeric_limits<double>::epsilon() * (q + std::abs(reference.q[i])) / tolerances_.of(q));
  }
  const bool below_round_off = noise > 0.1;
  const bool stiff = !below_round_off && at_stability_limit(it.currentStepSize);
  Diagnosis& d = diagnostics_->diagnose(below_round_off ? FailureReason::round_off
                                        : stiff         ? FailureReason::stiff
                                                        : FailureReason::error_control);
  const State &now = current(), &start = start_of_step();
  const auto add_errors = [&](Vector second, const Vector& first, const Vector& old, const char* vector,
                              int first_row) {
    for (std::size_t i = 0; i < second.size(); ++i) second[i] = std::abs(scaled_error(second[i], first[i], old[i]));
    diagnostics_->add_largest(d.values, second, vector, first_row);
  };
  add_errors(second_q_, now.q, start.q, "ODE2", 0);
  add_errors(second_v_, now.v, start.v, "ODE2_t", 0);
  add_errors(second_y_, now.y, start.y, "ODE1", sizes_.ode2);
  if (below_round_off) {
    d.advice = {
        "ask for larger errors (timeIntegration.relativeTolerance, absoluteTolerance): coordinates have no more "
        "digits"};
    return;
  }
  if (stiff) {
    d.advice = {
        "use an implicit method, which is stable with larger steps: exu.DynamicSolverType.ESDIRK43, or "
        "GeneralizedAlpha with "
        "stepSizeControl.implicitSolvers=True",
        "allow smaller steps (timeIntegration.minimumStepSize), if so many are to be taken"};
    return;
  }
  d.advice = {"look for what jumps at the items named above: contact, friction, user functions that are not continuous",
              "use an implicit solver (exu.DynamicSolverType.GeneralizedAlpha) if they are stiff",
              "allow larger errors (timeIntegration.relativeTolerance, absoluteTolerance), or smaller steps "
              "(timeIntegration.minimumStepSize)"};
}

}  // namespace dalembert
