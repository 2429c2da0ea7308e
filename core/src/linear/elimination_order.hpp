// In which order the unknowns of a sparse matrix are eliminated, to keep its factors sparse.
#pragma once

#include <span>
#include <vector>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

// Entry k is the column that is eliminated k-th.
using EliminationOrder = std::vector<int>;

// For matrices with zeros on the diagonal: each such unknown (a multiplier) is paired with a neighbour, pairs are ordered by
// approximate minimum degree, and the neighbour goes first.
EliminationOrder paired_minimum_degree_order(const Pattern& pattern, std::span<const double> values);
// For any pivot order within a column.
EliminationOrder column_order(const Pattern& pattern);

}  // namespace dalembert
