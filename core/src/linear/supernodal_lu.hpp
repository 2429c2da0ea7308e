// LU factors by Eigen's supernodal method: slower to set up, faster where the factors fill up, as on grids.
#pragma once

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cstddef>
#include <span>

#include "dalembert/system/pattern.hpp"

namespace dalembert {

class SupernodalLu {
 public:
  explicit SupernodalLu(const Pattern& pattern);
  bool factorize(std::span<const double> values);
  void solve(std::span<double> x);
  // Nonzeros of both factors.
  std::size_t entries() const { return static_cast<std::size_t>(lu_.nnzL() + lu_.nnzU()); }

 private:
  using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

  Matrix matrix_;
  Eigen::SparseLU<Matrix, Eigen::COLAMDOrdering<int>> lu_;
  Eigen::VectorXd solution_;
};

}  // namespace dalembert
