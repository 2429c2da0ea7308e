// Which equations make a system matrix singular.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Rows of which a combination vanishes, in ascending order; `values` in pattern order. None if the matrix is regular, or too large
// for a dense elimination with full pivoting.
std::vector<int> dependent_equations(const Pattern& pattern, std::span<const double> values);

// Unknowns that can change together without a change of the right-hand side; empty under the same conditions.
std::vector<int> free_unknowns(const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
