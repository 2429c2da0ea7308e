// Accelerations and multipliers at the start of a time integration.
#include <algorithm>
#include <cmath>

#include "constraints/constraint_states.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/second_order.hpp"

namespace dalembert {

namespace {

// Returns the equations that constrain velocities, if initial velocities violate them by more than the digits of typed
// input. The first step then jumps, and derivatives along these velocities are unknown.
std::vector<char> jumping_equations(System& system, const State& state, const Conditions& conditions,
                                    const Pattern& pattern) {
  constexpr double typed = 1e-3;
  const Sizes& s = system.sizes();
  const std::vector<char> none(static_cast<std::size_t>(s.ae), 0);
  if (s.ae == 0 || std::ranges::all_of(state.v, [](double v) { return v == 0; })) return none;
  std::vector<double> gradients(static_cast<std::size_t>(pattern.values()));
  std::vector<char> of_velocities = none;
  std::vector<double> speeds(none.size(), 0.0), gaps(none.size());  // speeds: magnitudes of the terms of each equation
  system.tangent(state, conditions, along_velocities, pattern, gradients);
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row < s.first_ae() || column >= s.ode2) return;
    const int k = row - s.first_ae();
    of_velocities[k] |= gradients[slot] != 0;
    speeds[k] += std::abs(gradients[slot] * state.v[column]);
  });
  system.gaps(state, conditions, gaps);
  for (std::size_t k = 0; k < speeds.size(); ++k)
    if (speeds[k] > 0 && std::abs(gaps[k]) > typed * speeds[k]) return of_velocities;
  return none;
}

}  // namespace

namespace {

InitialAccelerations accelerations_at(ConstrainedMotion& motion, System& system, const State& still,
                                      const Conditions& position, std::span<const char> jumping) {
  const Sizes& s = system.sizes();
  std::vector<double> x(static_cast<std::size_t>(s.total()), 0.0);
  InitialAccelerations result;
  system.forces(still, position, std::span(x).first(static_cast<std::size_t>(s.ode2)));
  const std::vector<double> gap = ConstrainedMotion::gap_acceleration(system, still, position);
  std::vector<double> now(gap.size());  // computed on demand, because it calls user functions once more
  if (!std::ranges::all_of(system.static_signs(), [](double sign) { return sign < 0; }))
    system.gaps(still, position, now);
  for (int i = 0; i < s.ae; ++i)
    x[s.first_ae() + i] = !system.constrains_motion(i) ? -now[i] : jumping[i] ? 0.0 : -gap[i];
  motion.solve(x);
  result.a.assign(x.begin(), x.begin() + s.ode2);
  result.lambda.assign(x.begin() + s.first_ae(), x.end());
  motion.make_smallest(result.lambda);
  return result;
}

}  // namespace

InitialAccelerations initial_accelerations(ConstrainedMotion& motion, System& system, const State& state,
                                           const Conditions& conditions) {
  const State still = without_multipliers(state);
  const Conditions position = at_level(conditions, false);
  const std::vector<char> jumping = jumping_equations(system, still, position, motion.pattern());
  InitialAccelerations result = accelerations_at(motion, system, still, position, jumping);
  if (std::ranges::none_of(jumping, [](char jumps) { return jumps != 0; }))
    result.decided = motion.follow_motion(system, still, position, result.a, result.lambda,
                                          [&](const State& at, std::vector<double>& a, std::vector<double>& lambda) {
                                            InitialAccelerations there =
                                                accelerations_at(motion, system, at, position, jumping);
                                            a = std::move(there.a);
                                            lambda = std::move(there.lambda);
                                          });
  for (int i = 0; i < system.sizes().ae; ++i)
    if (!system.constrains_motion(i)) result.lambda[i] = 0;  // changes within the step
  return result;
}

}  // namespace dalembert
