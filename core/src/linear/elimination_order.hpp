// In which order the unknowns of a sparse matrix are eliminated, to keep its factors sparse.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Which unknowns bring a pivot: those with a diagonal entry. Of two without one that have their largest entries in common,
// such as an Euler parameter without inertia and the condition of unit length, either is the other's pivot: one brings it.
std::vector<bool> pivots_at_hand(const Pattern& pattern, std::span<const double> values);

// Entry k is the unknown that is eliminated k-th.
using EliminationOrder = std::vector<int>;

// Approximate minimum degree, for a symmetric pattern with zeros on the diagonal of `values`: such an unknown (a multiplier)
// waits until enough unknowns with a diagonal entry have been eliminated around it to give it a pivot.
EliminationOrder minimum_degree_order(const Pattern& pattern, std::span<const double> values);

}  // namespace dalembert
