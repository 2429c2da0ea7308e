// Rank and null space of sparse columns of unit length.
//
// The Gram matrix S = C^T C is factorized by an up-looking sparse L D L^T factorization (T. A. Davis, Direct Methods for
// Sparse Linear Systems, SIAM 2006) in an order with little fill. The pivot of a column is its squared remainder after
// projection onto the columns before it. Columns with a remainder below the tolerance are dropped: they depend on others.
#pragma once

#include <span>
#include <vector>

namespace dalembert {

class GramFactors {
 public:
  struct Entry {
    int index;
    double value;
  };
  using Column = std::vector<Entry>;

  // `tolerance` is the limit of squared remainders. Columns may be empty.
  GramFactors(const std::vector<Column>& columns, int rows, double tolerance);

  const std::vector<int>& dependent() const { return dependent_; }  // dropped columns, in order of elimination
  double smallest_pivot() const { return smallest_pivot_; }         // smallest squared remainder of the others; 0 without any
  // The null vector with these entries for the dropped columns, by column.
  std::vector<double> null_vector(std::span<const double> of_dependent) const;

 private:
  // Solves with the factors of the first `end` columns, in order of elimination, without the dropped ones.
  void solve(std::span<double> x, int end) const;
  // Squared remainder of a column, computed from the columns themselves.
  double accurate_remainder(int k) const;
  // Linear combination of the columns that approximates a vector best: x becomes the remainder.
  std::vector<double> combination(std::vector<double>& x, int end) const;

  int size_, rows_;
  std::vector<Column> columns_;    // in order of elimination
  std::vector<int> order_;         // original column, by position
  std::vector<Column> lower_;      // columns of L
  std::vector<double> pivots_;     // zero if dropped
  std::vector<int> dependent_, dropped_;  // original columns, and their positions
  double smallest_pivot_ = 0;
};

}  // namespace dalembert
