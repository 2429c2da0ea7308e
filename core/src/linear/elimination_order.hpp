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

// Approximate minimum degree, for a symmetric pattern. An unknown without a pivot at hand (a multiplier) waits until enough unknowns
// with one have been eliminated around it.
EliminationOrder minimum_degree_order(const Pattern& pattern, const std::vector<bool>& at_hand);

}  // namespace dalembert
