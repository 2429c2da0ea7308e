#include "dalembert/solvers/open_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/constraint_states.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

namespace {

constexpr int dense_limit = 40;  // unknowns
// Factor of the position tolerance for solvers with velocity constraints, whose drift is an integration error.
constexpr double tolerated_drift = 1000;

// Calls f(constraint, coordinate, derivative) for the entries of the constraint Jacobian with these weights.
template <class F>
void each_gradient(System& system, const State& state, const Conditions& conditions, const Weights& weights, F&& f) {
  const Sizes& s = system.sizes();
  const Pattern& pattern = system.pattern(s.total() <= dense_limit);
  std::vector<double> values(static_cast<std::size_t>(pattern.values()));
  system.tangent(state, conditions, weights, pattern, values);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row >= s.first_ae() && column < s.ode2 && values[slot] != 0) f(row - s.first_ae(), column, values[slot]);
  });
}

const char* symbol(CoordinateUnit unit) {
  switch (unit) {
    case CoordinateUnit::meter: return " m";
    case CoordinateUnit::radian: return " rad";
    default: return "";
  }
}

}  // namespace

std::string OpenConstraint::text(const System& system) const {
  const bool bare = unit == CoordinateUnit::unknown;
  const std::string item = system.describe_row(system.sizes().first_ae() + row);
  if (!of_rate) return item + ": gap " + format_number(gap) + symbol(unit);
  return item + ": rate of the gap " + format_number(gap) + (bare ? " 1/s" : symbol(unit) + std::string("/s"));
}

ConstraintRates constraint_rates(System& system, const State& state, const Conditions& conditions, double latest) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  const State still = without_multipliers(state);
  const Conditions position = at_level(conditions, false), rate = at_level(conditions, true);
  ConstraintRates now{std::vector<double>(n), std::vector<double>(n), std::vector<char>(n), std::vector<CoordinateUnit>(n)};
  std::vector<double> along(n), before(n), after(n), later(n);  // `along` is the contribution of the velocities
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  each_gradient(system, still, position, along_velocities, [&](int k, int, double) { now.of_velocities[k] = 1; });
  each_gradient(system, still, rate, along_velocities, [&](int k, int j, double g) {
    along[k] += g * state.v[j];
    now.speeds[k] += std::abs(g * state.v[j]);
    now.units[k] = std::max(now.units[k], units[j]);
  });
  system.gaps(still, rate, now.rates);
  if (conditions.rate_level) return now;  // the solver enforces these rates
  // User functions may be undefined before the start or after the end: one-sided differences of second order.
  State moved = still;
  const double length = 1e-5 * std::max(1.0, std::abs(state.time)), step = state.time + 2 * length > latest ? -length : length;
  const auto gaps_after = [&](double time, std::vector<double>& gaps) {
    moved.time = state.time + time;
    system.gaps(moved, position, gaps);
  };
  gaps_after(0, before);
  gaps_after(step, after);
  gaps_after(2 * step, later);
  for (std::size_t k = 0; k < n; ++k)
    if (!now.of_velocities[k] && (after[k] != before[k] || later[k] != before[k]))
      now.rates[k] = along[k] + (4 * after[k] - 3 * before[k] - later[k]) / (2 * step);
  return now;
}

namespace {

// Rates are not evaluated for static solvers: user functions may not support them.
ConstraintRates constraints_at_rest(System& system, const State& state, const Conditions& conditions) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  const State still = without_multipliers(state);
  ConstraintRates now{std::vector<double>(n), std::vector<double>(n), std::vector<char>(n), std::vector<CoordinateUnit>(n)};
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  each_gradient(system, still, conditions, along_velocities, [&](int k, int, double) { now.of_velocities[k] = 1; });
  each_gradient(system, still, conditions, along_positions, [&](int k, int j, double) { now.units[k] = std::max(now.units[k], units[j]); });
  return now;
}

}  // namespace

std::vector<OpenConstraint> open_constraints(System& system, const State& state, const Conditions& conditions,
                                             const GapTolerances& tolerances) {
  std::vector<OpenConstraint> open;
  const State still = without_multipliers(state);
  std::vector<double> gaps(still.lambda.size()), rates(gaps.size());
  system.gaps(still, at_level(conditions, false), gaps);
  if (tolerances.rates) system.gaps(still, at_level(conditions, true), rates);
  if (std::max(largest(gaps), largest(rates)) <= tolerances.position * std::min(1.0, smallest_unit(system))) return open;

  const std::vector<double> sizes = constraint_metric(system, still, at_level(conditions, false)).units;
  const ConstraintRates now = tolerances.rates ? constraint_rates(system, state, conditions)
                                               : constraints_at_rest(system, state, at_level(conditions, false));
  const auto look = [&](int k, bool of_rate, double gap, double speed) {
    const CoordinateUnit unit = now.units[k];
    const double limit =
        std::max(tolerances.position * (unit == CoordinateUnit::meter ? sizes[static_cast<std::size_t>(k)] : 1.0), speed * tolerances.velocity);
    if (std::abs(gap) > limit) open.push_back({k, of_rate, gap, std::abs(gap) / std::max(limit, 1e-300), unit});
  };
  for (int k = 0; k < system.sizes().ae; ++k) {
    if (!system.constrains_motion(k)) continue;
    if (!now.of_velocities[k]) look(k, false, gaps[k], 0);
    if (tolerances.rates) look(k, true, now.rates[k], now.speeds[k]);
  }
  std::ranges::stable_sort(open, std::ranges::greater{}, &OpenConstraint::excess);
  return open;
}

namespace {

std::string listed(const std::vector<OpenConstraint>& open, const System& system) {
  constexpr std::size_t most = 5;
  std::string text = std::to_string(open.size()) + (open.size() == 1 ? " constraint equation:" : " constraint equations:");
  for (std::size_t i = 0; i < std::min(most, open.size()); ++i) text += "\n  " + open[i].text(system);
  return open.size() > most ? text + "\n  ..." : text;
}

}  // namespace

// Static solvers are allowed to close gaps.
void Solver::check_constraints() {
  const auto& s = settings_->initialConditions;
  if (!s.checkConstraints || sizes_.ae == 0 || !enforces_constraints()) return;
  const auto open = open_constraints(*system_, current(), conditions_, {s.positionTolerance, s.velocityTolerance, !is_static()});
  if (open.empty()) return;
  const bool any_rate = std::ranges::any_of(open, &OpenConstraint::of_rate), any_gap = !std::ranges::all_of(open, &OpenConstraint::of_rate);
  std::string text = name() + ": the initial values contradict " + listed(open, *system_) + "\n ";
  if (any_gap && is_static()) text += " The load steps close the gaps.";
  if (any_gap && !is_static()) {
    text += conditions_.rate_level ? " Gaps stay: velocities alone are constrained here."
                                   : " Gaps close in the first step, with large velocities and forces.";
  }
  if (any_rate) text += " Velocities against constraints vanish in the first step.";
  text += " mbs.ComputeConsistentInitialConditions() finds initial values that fulfil all constraints; "
          "simulationSettings.initialConditions says what is tolerated.";
  if (s.inconsistentIsError) throw ModelError(ErrorKind::value, text);
  if (is_static()) say(1, text + "\n");
  else warn(text);
}

// Called after actions of an event and the projection onto the constraints.
[[gnu::noinline]] void Solver::warn_of_actions_against_constraints(int singular_row) {
  const auto& s = settings_->initialConditions;
  if (!s.checkConstraints || warned_of_actions_) return;
  const auto open = open_constraints(*system_, current(), conditions_, {s.positionTolerance, s.velocityTolerance, true});
  if (open.empty()) return;
  warned_of_actions_ = true;
  std::string text = name() + ": the action of an event contradicts " + listed(open, *system_) + "\n  That cannot be mended at once";
  if (singular_row != LinearSolver::success)
    text += ", as mass matrix and constraints are singular at unknown " + std::to_string(singular_row) + " (" + system_->describe_row(singular_row) + ")";
  warn(text + ", and leads to large velocities and forces in the next step: let the action leave positions and velocities that fulfil all constraints.");
}

// A first step that closes larger gaps than the tolerances has large errors, independently of the step size.
[[gnu::noinline]] std::string Solver::constraints_that_close_at_start() {
  if (sizes_.ae == 0 || !enforces_constraints()) return {};
  const double tolerance = settings_->timeIntegration.absoluteTolerance;
  const auto open = open_constraints(*system_, initial(), conditions_, {tolerance, tolerance, true});
  if (open.empty()) return {};
  const std::string text = "the first steps close what initial values leave open by more than the tolerances, of " + listed(open, *system_) + "\n  ";
  if (told_contradiction_.empty()) return text + "Begin with mbs.ComputeConsistentInitialConditions(), or allow larger errors";
  return text + "No state fulfils all: " + told_contradiction_ +
         "\n  Move or turn the markers of these joints until they fit, free equations that others state as well, or allow larger errors";
}

void Solver::look_back() {
  const auto steps = [](StepCount n) { return std::to_string(n) + (n == 1 ? " step" : " steps"); };
  if (it.stepsAboveTolerance > 0) {
    doubts_.push_back("errors above the tolerances in " + steps(it.stepsAboveTolerance) +
                      ": " + (closing_at_start_.empty() ? "look for jumps, or lower timeIntegration.minimumStepSize; a mechanism that "
                                                          "passes a singular position cannot be computed more accurately there"
                                                        : closing_at_start_));
  }
  if (it.unsettledSteps > 0) {
    doubts_.push_back("contact or friction that has not settled in " + steps(it.unsettledSteps) +
                      ": use smaller steps, or more discontinuous.maxIterations");
  }
  std::vector<std::string> observed = is_static() ? angles_.doubts_of_equilibrium(*system_) : angles_.doubts(it.automaticStepSize);
  std::ranges::copy(rebounds_.doubts([this](const Switch& at) { return describe_switch(at); }), std::back_inserter(observed));
  for (std::string& doubt : observed) {
    if (!verbose(1)) warn(doubt);
    doubts_.push_back(std::move(doubt));
  }
  const auto& s = settings_->initialConditions;
  if (s.checkConstraints && sizes_.ae > 0) {
    const double tolerance = (conditions_.rate_level ? tolerated_drift : 1) * s.positionTolerance;
    // Regularization may open the rates of constraints that are very weak relative to others.
    const auto open = open_constraints(*system_, current(), conditions_, {tolerance, s.velocityTolerance, constraint_solver().active()});
    if (!open.empty()) doubts_.push_back("open at the end: " + listed(open, *system_) + "\n  Use smaller steps, or a solver that keeps constraints of positions");
  }
  output.trusted = doubts_.empty();
}

}  // namespace dalembert
