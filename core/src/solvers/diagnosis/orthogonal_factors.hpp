// Rank and null space of sparse columns of unit length: C = Q R by Givens rotations, one row of C after the other.
//
// A. George, M. T. Heath: Solution of sparse linear least squares problems using Givens rotations, Linear Algebra and its
// Applications 34 (1980), 69-83. A column depends on those before it if its remainder after projection onto them, the
// diagonal entry of R, is small. The rest of that row is then rotated into the later rows (M. T. Heath: Some extensions of an
// algorithm for sparse linear least squares problems, SIAM J. Sci. Stat. Comput. 3 (1982), 223-237).
#pragma once

#include <span>
#include <vector>

namespace dalembert {

class OrthogonalFactors {
 public:
  struct Entry {
    int index;
    double value;
  };
  using Vector = std::vector<Entry>;  // sparse, with ascending indices if it is a row of R

  // `tolerance` is the limit of squared remainders. Columns may be empty.
  OrthogonalFactors(const std::vector<Vector>& columns, int rows, double tolerance);

  const std::vector<int>& dependent() const { return dependent_; }  // columns, in order of elimination
  double smallest_pivot() const { return smallest_pivot_; }  // smallest squared remainder of the others; 0 without any
  // Smallest squared remainder, where each one is multiplied by the factor of its column.
  double smallest_pivot(std::span<const double> factors) const;
  // The null vector with these entries for the dependent columns, by column.
  std::vector<double> null_vector(std::span<const double> of_dependent) const;
  // Solves C^T C y = b for the independent columns; the others get zero.
  std::vector<double> solve_normal_equations(std::span<const double> b) const;

 private:
  void rotate_in(Vector row);

  std::vector<int> order_;  // column, by position in the elimination
  std::vector<Vector> rows_;  // of R, by position; the first entry is that of the diagonal; empty if dependent
  std::vector<int> dependent_;
  double smallest_pivot_ = 0;
  Vector pivot_, other_;  // storage of rotations
};

}  // namespace dalembert
