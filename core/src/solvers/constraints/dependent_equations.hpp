// Equations that make a system matrix singular.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Linearly dependent rows in ascending order, for `values` in pattern order. The result is empty if the matrix is regular, or
// too large for a dense elimination with full pivoting.
std::vector<int> dependent_equations(const Pattern& pattern, std::span<const double> values);

// Linearly dependent columns: unknowns that can change together without a change of the right-hand side.
std::vector<int> free_unknowns(const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
