// Rank and null space of sparse columns of unit length.
//
// A column depends on others if its squared remainder after projection onto the columns before it is below a tolerance.
// Remainders of up to some hundred columns are those of a sparse QR factorization, which is accurate to round-off. The Gram
// matrix S = C^T C of more columns is factorized by an up-looking sparse L D L^T factorization (T. A. Davis, Direct Methods
// for Sparse Linear Systems, SIAM 2006) in an order with little fill. Its pivots are the squared remainders, with round-off
// of 1e-14 or more; the time is nearly proportional to the number of columns, in contrast to that of QR.
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
  void factorize_accurately(const std::vector<Column>& columns, double tolerance);
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
  std::vector<std::vector<double>> null_vectors_;  // of the dependent columns, if the factorization is QR
};

}  // namespace dalembert
