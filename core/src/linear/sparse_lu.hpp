// LU factors of a sparse matrix with a structurally symmetric pattern.
#pragma once

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

class SparseLu final : public LinearSolver {
 public:
  SparseLu(const Pattern& pattern, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  int empty_column(std::span<const double> values) const;
  int singular_column() const;

  const Pattern& pattern_;
  LinearSolverOptions options_;
  Matrix matrix_;
  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> lu_;
  Eigen::VectorXd solution_;
  bool analyzed_ = false;
};

}  // namespace dalembert
