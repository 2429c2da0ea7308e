// Order of elimination of the unknowns of a sparse matrix, for sparse factors.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// By unknown: 1 if it brings a pivot, -1 if it needs one, 0 if it has one of its own as soon as all around it is eliminated.
using PivotSurplus = std::vector<signed char>;

// Unknowns with a diagonal entry have a pivot. If two unknowns without diagonal entry have their largest entries in
// common, such as an Euler parameter without inertia and its unit-length constraint, each is the pivot of the other,
// and one of them counts as having a pivot. `dependent`: multipliers of redundant constraints.
PivotSurplus pivot_surplus(const Pattern& pattern, std::span<const double> values, std::span<const int> dependent);

// Entry k is the unknown that is eliminated k-th.
using EliminationOrder = std::vector<int>;

// Approximate minimum degree, for a symmetric pattern. An unknown without a pivot at hand (a multiplier) waits until enough unknowns
// with one have been eliminated around it.
EliminationOrder minimum_degree_order(const Pattern& pattern, const PivotSurplus& surplus);

}  // namespace dalembert
