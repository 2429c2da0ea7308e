#include "dalembert/solvers/open_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/constraint_states.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/output/numbers.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"

namespace dalembert {

namespace {

constexpr int dense_limit = 40;  // unknowns

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

std::vector<double> rates_of_gaps(System& system, const State& state, const Conditions& conditions, double latest,
                                  std::span<const char> of_velocities) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  const Conditions position = at_level(conditions, false), rate = at_level(conditions, true);
  std::vector<double> rates(n), at_rest(n), before(n), after(n), later(n);
  State moved = without_multipliers(state);
  system.gaps(moved, rate, rates);
  if (conditions.rate_level) return rates;  // the solver enforces these rates
  // User functions may be undefined before the start or after the end: one-sided differences of second order.
  const double length = 1e-6 * std::sqrt(std::max(1.0, std::abs(state.time))),
               side = state.time + 2 * length > latest ? -length : length, step = (state.time + side) - state.time;
  const auto gaps_after = [&](double time, std::vector<double>& gaps) {
    moved.time = state.time + time;
    system.gaps(moved, position, gaps);
  };
  gaps_after(0, before);
  gaps_after(step, after);
  gaps_after(2 * step, later);
  const auto is_driven = [&](std::size_t k) {
    return !of_velocities[k] && (after[k] != before[k] || later[k] != before[k]);
  };
  // Rates are linear in the velocities; the rest of them is prescribed in time, by a function of its own if it is not zero.
  moved.time = state.time;
  std::ranges::fill(moved.v, 0.0);
  system.gaps(moved, rate, at_rest);
  for (std::size_t k = 0; k < n; ++k)
    if (is_driven(k) && at_rest[k] == 0) rates[k] += (4 * after[k] - 3 * before[k] - later[k]) / (2 * step);
  return rates;
}

std::vector<int> equations_without_rates(System& system, const State& state, const Conditions& conditions,
                                         double start) {
  constexpr int samples = 8;
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  std::vector<double> gaps(n), first(n), rates(n);
  std::vector<char> moves(n, 0), has_rate(n, 0);
  State still = without_multipliers(state);
  std::ranges::fill(still.v, 0.0);
  for (int i = 0; i < samples; ++i) {
    still.time = state.time + (start - state.time) * i / samples;
    system.gaps(still, at_level(conditions, false), gaps);
    system.gaps(still, at_level(conditions, true), rates);
    if (i == 0) first = gaps;
    for (std::size_t k = 0; k < n; ++k) moves[k] |= gaps[k] != first[k], has_rate[k] |= rates[k] != 0;
  }
  std::vector<int> found;
  for (std::size_t k = 0; k < n; ++k)
    if (moves[k] && !has_rate[k]) found.push_back(static_cast<int>(k));
  return found;
}

ConstraintRates constraint_rates(System& system, const State& state, const Conditions& conditions, double latest) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  const State still = without_multipliers(state);
  ConstraintRates now{{}, std::vector<double>(n), std::vector<char>(n), std::vector<CoordinateUnit>(n)};
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  each_gradient(system, still, at_level(conditions, false), along_velocities,
                [&](int k, int, double) { now.of_velocities[k] = 1; });
  each_gradient(system, still, at_level(conditions, true), along_velocities, [&](int k, int j, double g) {
    now.speeds[k] += std::abs(g * state.v[j]);
    now.units[k] = std::max(now.units[k], units[j]);
  });
  now.rates = rates_of_gaps(system, state, conditions, latest, now.of_velocities);
  return now;
}

namespace {

// Rates are not evaluated for static solvers: user functions may not support them.
ConstraintRates constraints_at_rest(System& system, const State& state, const Conditions& conditions) {
  const auto n = static_cast<std::size_t>(system.sizes().ae);
  const State still = without_multipliers(state);
  ConstraintRates now{std::vector<double>(n), std::vector<double>(n), std::vector<char>(n),
                      std::vector<CoordinateUnit>(n)};
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  each_gradient(system, still, conditions, along_velocities, [&](int k, int, double) { now.of_velocities[k] = 1; });
  each_gradient(system, still, conditions, along_positions,
                [&](int k, int j, double) { now.units[k] = std::max(now.units[k], units[j]); });
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
  if (std::max(largest(gaps), largest(rates)) <= tolerances.position * std::min(1.0, smallest_unit(system)))
    return open;

  const std::vector<double> sizes = constraint_metric(system, still, at_level(conditions, false)).units;
  const ConstraintRates now = tolerances.rates ? constraint_rates(system, state, conditions)
                                               : constraints_at_rest(system, state, at_level(conditions, false));
  const auto look = [&](int k, bool of_rate, double gap, double speed) {
    const CoordinateUnit unit = now.units[k];
    const double limit =
        std::max(tolerances.position * (unit == CoordinateUnit::meter ? sizes[static_cast<std::size_t>(k)] : 1.0),
                 speed * tolerances.velocity);
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

std::string listed(const std::vector<OpenConstraint>& open, const System& system) {
  constexpr std::size_t most = 5;
  std::string text =
      std::to_string(open.size()) + (open.size() == 1 ? " constraint equation:" : " constraint equations:");
  for (std::size_t i = 0; i < std::min(most, open.size()); ++i) text += "\n  " + open[i].text(system);
  return open.size() > most ? text + "\n  ..." : text;
}

}  // namespace dalembert
