// How many eigenvalues of a symmetric matrix are negative, by the signs of pivots (Sylvester's law of inertia).
#pragma once

#include <optional>
#include <span>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

// Unknown where a pivot is no more than rounding errors. The matrix is destroyed.
std::optional<int> negative_eigenvalues(std::span<double> symmetric, int size);
// Of a matrix with the pattern of this solver, which keeps its factors; unknown also where these have no symmetric order, or where finding
// it out would take long.
std::optional<int> negative_eigenvalues(const LinearSolver& solver, const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
