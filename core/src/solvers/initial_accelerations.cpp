// [M  G^T] [a     ]   [Q              ]
// [G  0  ] [lambda] = [-(G v)_q v     ]   at the start of a time integration.
#include <algorithm>
#include <cmath>

#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/solvers/second_order.hpp"

namespace dalembert {

namespace {

constexpr Weights along_positions{.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0};
constexpr Weights along_velocities{.q = 0, .v = 1, .a = 0, .y = 1, .y_t = 0};

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

// Which equations constrain velocities, if the velocities at the start do not fulfil them within the digits that people type: then the
// first step jumps, and nothing is known of derivatives along these velocities. `gradients` has room for the values of the pattern.
std::vector<char> jumping_equations(System& system, const State& state, const Conditions& conditions, const Pattern& pattern,
                                    std::span<double> gradients) {
  constexpr double typed = 1e-3;
  const Sizes& s = system.sizes();
  const std::vector<char> none(static_cast<std::size_t>(s.ae), 0);
  if (std::ranges::all_of(state.v, [](double v) { return v == 0; })) return none;
  std::vector<char> of_velocities = none;
  std::vector<double> speeds(none.size(), 0.0), gaps(none.size());  // speeds: sizes of the terms of each equation
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

// Columns of ODE1 coordinates and of multipliers leave these out of the solution.
void leave_out_ode1(const Sizes& s, const Pattern& pattern, std::span<double> matrix) {
  for (int i = s.ode2; i < s.first_ae(); ++i) {
    for_each_row(pattern, i, [&](int column) {
      if (column >= s.first_ae()) matrix[pattern.slot(i, column)] = 0;
    });
    matrix[pattern.slot(i, i)] = 1;
  }
}

// The columns of the multipliers and the rows of the constraints, around the mass matrix.
//
// Gradients are those of the rates by the velocities: Euler parameters turn a frame without their own lengthening, which
// the gradient of a gap contains. Constraints of velocities are their own rates, so they are differentiated once, not twice.
void add_constraints(System& system, const State& state, Conditions conditions, const Pattern& pattern, std::span<double> matrix,
                     std::span<double> part) {
  const int end_of_ode2 = system.sizes().ode2, first_ae = system.sizes().first_ae();
  const auto take = [&](std::size_t begin, std::size_t end) { std::copy(part.data() + begin, part.data() + end, matrix.data() + begin); };
  system.tangent(state, conditions, along_positions, pattern, part);
  for (int j = 0; j < pattern.size(); ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae);
    if (j >= end_of_ode2) take(j < first_ae ? column.middle : column.begin, column.end);
  }
  conditions.rate_level = true;
  system.tangent(state, conditions, along_velocities, pattern, part);
  for (int j = 0; j < end_of_ode2; ++j) {
    const ColumnRange column = column_range(pattern, j, first_ae);
    take(column.middle, column.end);
  }
}

}  // namespace

InitialAccelerations initial_accelerations(System& system, const State& state, const Conditions& conditions,
                                           LinearSolverType type, const LinearSolverOptions& options) {
  const Sizes& s = system.sizes();
  const Pattern& pattern = system.pattern(is_dense(type));
  std::vector<double> matrix(static_cast<std::size_t>(pattern.values())), x(static_cast<std::size_t>(s.total()), 0.0);
  std::vector<char> jumping;
  State still = state;
  std::fill(still.lambda.begin(), still.lambda.end(), 0.0);
  Conditions position = conditions;
  position.rate_level = false;
  system.mass_matrix(still, pattern, matrix);
  if (s.ae > 0) {
    std::vector<double> part(matrix.size());
    jumping = jumping_equations(system, still, position, pattern, part);
    add_constraints(system, still, position, pattern, matrix, part);
  }
  leave_out_ode1(s, pattern, matrix);
  system.forces(still, position, std::span(x).first(static_cast<std::size_t>(s.ode2)));
  const std::vector<double> gap = gap_acceleration(system, still, position);
  std::vector<double> now(gap.size());  // asked for only if it is needed: user functions are called once more
  if (!std::ranges::all_of(system.static_signs(), [](double sign) { return sign < 0; })) system.gaps(still, position, now);
  for (int i = 0; i < s.ae; ++i) x[s.first_ae() + i] = !system.constrains_motion(i) ? -now[i] : jumping[i] ? 0.0 : -gap[i];

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
