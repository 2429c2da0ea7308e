// How many eigenvalues of a symmetric matrix are negative, by the signs of pivots (Sylvester's law of inertia).
#pragma once

#include <optional>
#include <span>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

// Unknown where a pivot is no more than rounding errors. The matrix is destroyed.
std::optional<int> negative_eigenvalues(std::span<double> symmetric, int size);
// Returns the number of negative eigenvalues of a matrix with the pattern of this solver, whose factors are kept. Returns nothing if the
// elimination order of the factors is not symmetric, or if the count would take long.
std::optional<int> negative_eigenvalues(const LinearSolver& solver, const Pattern& pattern,
                                        std::span<const double> values);

}  // namespace dalembert
