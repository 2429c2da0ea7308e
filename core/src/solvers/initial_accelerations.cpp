// [M  G^T] [a     ]   [Q              ]
// [G  0  ] [lambda] = [-(G v)_q v     ]   at the start of a time integration.
#include <cmath>

#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/second_order.hpp"

namespace dalembert {

namespace {

// Derivative of the rates of the gaps along the velocity, by a central difference: with constant velocities these are the second
// derivatives of gaps, the first of constraints of velocities.
std::vector<double> gap_acceleration(System& system, const State& state, Conditions conditions) {
  const std::size_t n = state.lambda.size();
  std::vector<double> before(n), after(n), step(state.q.size());
  double speed = 0;
  for (const double v : state.v) speed += v * v;
  speed = std::sqrt(speed);
  if (n == 0 || speed <= 1e-10) return before;
  double size = 1;
  for (const double q : state.q) size = std::max(size, std::abs(q));
  const double eps = 1e-5 * size / speed;
  conditions.rate_level = true;
  State moved = state;
  const auto evaluate = [&](double factor, std::vector<double>& rates) {
    for (std::size_t i = 0; i < step.size(); ++i) {
      step[i] = factor * state.v[i];
      moved.q[i] = state.q[i] + step[i];
    }
    if (system.has_lie_nodes()) system.compose(state.q, step, moved.q);
    system.gaps(moved, conditions, rates);
  };
  evaluate(-eps, before);
  evaluate(eps, after);
  for (std::size_t i = 0; i < n; ++i) after[i] = (after[i] - before[i]) / (2 * eps);
  return after;
}

// Whether the velocities at the start fulfil the constraints of velocities, within the digits that people type. If not, the first step
// jumps, and nothing is known of derivatives along these velocities. `speeds`: sizes of the terms of each equation.
bool fulfilled(System& system, const State& state, const Conditions& conditions, const std::vector<double>& speeds) {
  constexpr double typed = 1e-3;
  std::vector<double> gaps(speeds.size());
  system.gaps(state, conditions, gaps);
  for (std::size_t k = 0; k < speeds.size(); ++k)
    if (speeds[k] > 0 && std::abs(gaps[k]) > typed * speeds[k]) return false;
  return true;
}

}  // namespace

InitialAccelerations initial_accelerations(System& system, const State& state, const Conditions& conditions,
                                           LinearSolverType type, const LinearSolverOptions& options) {
  const Sizes& s = system.sizes();
  const Pattern& pattern = system.pattern(is_dense(type));
  const auto size = static_cast<std::size_t>(pattern.values());
  std::vector<double> matrix(size), velocity_part(size), mass(size), x(static_cast<std::size_t>(s.total()), 0.0);
  State still = state;
  std::fill(still.lambda.begin(), still.lambda.end(), 0.0);
  Conditions position = conditions;
  position.rate_level = false;
  system.mass_matrix(still, pattern, mass);
  system.tangent(still, position, {.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0}, pattern, matrix);

  // Gradients are those of the rates by the velocities: Euler parameters turn a frame without their own lengthening, which
  // the gradient of a gap contains. Constraints of velocities are their own rates, so they are differentiated once, not twice.
  std::vector<double> speeds(static_cast<std::size_t>(s.ae), 0.0);
  std::vector<char> of_velocities(speeds.size(), 0);
  if (s.ae > 0) {
    const auto by_velocity = [&](const Conditions& level) {
      system.tangent(still, level, {.q = 0, .v = 1, .a = 0, .y = 1, .y_t = 0}, pattern, velocity_part);
    };
    const auto each_gradient = [&](auto&& f) {
      for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
        if (row >= s.first_ae() && column < s.ode2) f(static_cast<std::size_t>(row - s.first_ae()), column, slot);
      });
    };
    by_velocity(position);
    each_gradient([&](std::size_t k, int column, std::size_t slot) {
      of_velocities[k] |= velocity_part[slot] != 0;
      speeds[k] += std::abs(velocity_part[slot] * still.v[column]);
    });
    Conditions rates = position;
    rates.rate_level = true;
    by_velocity(rates);
    each_gradient([&](std::size_t, int, std::size_t slot) { matrix[slot] = velocity_part[slot]; });
  }
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (row < s.first_ae() && column < s.first_ae()) {
      matrix[slot] = row < s.ode2 ? mass[slot] : (row == column ? 1.0 : 0.0);
    } else if (row >= s.ode2 && row < s.first_ae()) {
      matrix[slot] = 0;
    }
  });
  system.forces(still, position, std::span(x).first(static_cast<std::size_t>(s.ode2)));
  const std::vector<double> gap = gap_acceleration(system, still, position);
  const bool jumps = !fulfilled(system, still, position, speeds);
  for (int i = 0; i < s.ae; ++i) x[s.first_ae() + i] = jumps && of_velocities[i] ? 0.0 : -gap[i];

  InitialAccelerations result;
  const auto solver = make_linear_solver(pattern, type, options);
  result.singular_row = solver->factorize(matrix);
  if (result.singular_row != LinearSolver::success) return result;
  solver->solve(x);
  result.a.assign(x.begin(), x.begin() + s.ode2);
  result.lambda.assign(x.begin() + s.first_ae(), x.end());
  return result;
}

}  // namespace dalembert
