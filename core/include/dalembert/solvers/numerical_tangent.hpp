// The system matrix by central differences of the residual, and loops over the entries of a pattern.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "dalembert/simulation_settings.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

// Returns whether a setting requests differences instead of exact derivatives.
inline bool wants_differences(const NewtonNumericalDifferentiationSettings& s) {
  return s.doSystemWideDifferentiation || s.forAE || s.forODE2 || s.forODE2connectors;
}

// Computes the matrix of System::tangent; the options select entries that are computed by differences along the same
// directions. Differences of the whole system include all entries, also those that no item declares.
void numerical_tangent(System& system, const State& state, const Conditions& conditions, const Weights& weights,
                       const NewtonNumericalDifferentiationSettings& options, const Pattern& pattern,
                       std::span<double> values);

// Calls f(row, column, slot) for all entries.
template <class F>
void for_each_entry(const Pattern& pattern, F&& f) {
  const int n = pattern.size();
  std::size_t slot = 0;
  for (int column = 0; column < n; ++column) {
    if (pattern.is_dense()) {
      for (int row = 0; row < n; ++row) f(row, column, slot++);
    } else {
      const auto starts = pattern.column_start();
      for (int k = starts[column]; k < starts[column + 1]; ++k) f(pattern.row_index()[k], column, slot++);
    }
  }
}

// Calls f(row) for all rows of one column.
template <class F>
void for_each_row(const Pattern& pattern, int column, F&& f) {
  if (pattern.is_dense()) {
    for (int row = 0; row < pattern.size(); ++row) f(row);
  } else {
    const auto starts = pattern.column_start();
    for (int k = starts[column]; k < starts[column + 1]; ++k) f(pattern.row_index()[k]);
  }
}

// Slots of one column: [begin, middle) are rows below `split`, [middle, end) the others. Rows are sorted.
struct ColumnRange {
  std::size_t begin, middle, end;
};
inline ColumnRange column_range(const Pattern& pattern, int column, int split) {
  const auto n = static_cast<std::size_t>(pattern.size());
  if (pattern.is_dense()) {
    const std::size_t begin = static_cast<std::size_t>(column) * n;
    return {begin, begin + static_cast<std::size_t>(split), begin + n};
  }
  const auto rows = pattern.row_index();
  const int begin = pattern.column_start()[column], end = pattern.column_start()[column + 1];
  const auto middle = std::lower_bound(rows.begin() + begin, rows.begin() + end, split) - rows.begin();
  return {static_cast<std::size_t>(begin), static_cast<std::size_t>(middle), static_cast<std::size_t>(end)};
}
inline int row_in(const Pattern& pattern, const ColumnRange& column, std::size_t slot) {
  return pattern.is_dense() ? static_cast<int>(slot - column.begin) : pattern.row_index()[slot];
}

}  // namespace dalembert
