// Shared functions for the evaluation of constraints: states, conditions, and steps of positions.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "dalembert/solvers/numerical_tangent.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

inline constexpr Weights along_positions{.q = 1, .v = 0, .a = 0, .y = 1, .y_t = 0};
inline constexpr Weights along_velocities{.q = 0, .v = 1, .a = 0, .y = 1, .y_t = 0};
inline constexpr double at_rest = 1e-10;  // speed

inline State without_multipliers(State state) {
  std::ranges::fill(state.lambda, 0.0);
  return state;
}

inline Conditions at_level(Conditions conditions, bool of_rates) {
  conditions.rate_level = of_rates;
  return conditions;
}

// Position gaps, also if a solver enforces velocity constraints.
inline std::vector<double> gaps_of_positions(System& system, const State& state, const Conditions& conditions) {
  std::vector<double> gaps(static_cast<std::size_t>(system.sizes().ae));
  system.gaps(without_multipliers(state), at_level(conditions, false), gaps);
  return gaps;
}

inline double largest(std::span<const double> numbers) {
  double size = 0;
  for (const double x : numbers) size = std::max(size, std::abs(x));
  return size;
}

// Replaces zero masses of ODE2 coordinates by the largest mass of the node with the same unit, or by one.
inline void fill_in_masses(const System& system, std::span<double> masses) {
  const std::vector<int> nodes = system.nodes_of_coordinates();
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  for (std::size_t first = 0, end = 0; first < masses.size(); first = end) {
    double most = 0;
    for (end = first; end < masses.size() && nodes[end] == nodes[first] && units[end] == units[first]; ++end)
      most = std::max(most, masses[end]);
    for (std::size_t j = first; j < end; ++j)
      if (!(masses[j] > 0)) masses[j] = most > 0 ? most : 1;
  }
}

// Largest entry of a motion, relative to the size of the model, or in radians.
inline double relative_size(const System& system, std::span<const double> motion) {
  const std::vector<CoordinateUnit> units = system.coordinate_units();
  const double extent = system.extent();
  double size = 0;
  for (std::size_t i = 0; i < motion.size(); ++i)
    size = std::max(size, std::abs(motion[i]) / (units[i] == CoordinateUnit::meter ? extent : 1));
  return size;
}

inline void move_positions(System& system, std::span<const double> step, std::vector<double>& q) {
  const std::vector<double> before = q, increment(step.begin(), step.end());
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += increment[i];
  if (system.has_lie_nodes()) system.compose(before, increment, q);
}

// Removes ODE1 coordinates from the solution.
inline void leave_out_ode1(const Sizes& s, const Pattern& pattern, std::span<double> matrix) {
  for (int i = s.ode2; i < s.first_ae(); ++i) {
    for_each_row(pattern, i, [&](int column) {
      if (column >= s.first_ae()) matrix[pattern.slot(i, column)] = 0;
    });
    matrix[pattern.slot(i, i)] = 1;
  }
}

// Replaces constraint rows by the transposed columns of constraint forces, which determine the multipliers without force.
inline void replace_gradients_by_forces(const Sizes& s, const Pattern& pattern, std::span<double> matrix) {
  for_each_entry(pattern, [&](int row, int column, std::size_t slot) {
    if (column >= s.first_ae() && row < s.ode2)
      matrix[static_cast<std::size_t>(pattern.slot(column, row))] = matrix[slot];
  });
}

}  // namespace dalembert
