// Combinations of the columns of a sparse matrix that vanish, by orthogonal elimination of groups of rows.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace dalembert {

struct SparseEntry {
  int row, column;
  double value;
};

// An orthonormal basis of what the matrix takes to zero; `groups`: of each row, all of a group in a row. Groups with few neighbours go first, and fronts hold
// what is left around them, so that columns of chains and ladders take linear time, but for the basis itself. None: a column is neither dependent nor clearly
// independent of others, by what is left of it behind them: less than `dependent`, or more than `independent`.
std::optional<Eigen::MatrixXd> sparse_kernel(int columns, std::span<const int> groups, std::span<const SparseEntry> entries, double dependent, double independent);

}  // namespace dalembert
