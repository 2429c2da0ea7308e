// In which order the unknowns of a sparse matrix are eliminated, to keep its factors sparse.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Entry k is the unknown that is eliminated k-th.
using EliminationOrder = std::vector<int>;

// Approximate minimum degree, for a symmetric pattern with zeros on the diagonal of `values`: such an unknown (a multiplier)
// waits until enough unknowns with a diagonal entry have been eliminated around it to give it a pivot.
EliminationOrder minimum_degree_order(const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
