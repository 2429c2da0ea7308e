// LU factors of a dense matrix, stored by columns, with row exchanges.
#pragma once

#include <vector>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

class DenseLu final : public LinearSolver {
 public:
  DenseLu(int size, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;

 private:
  int eliminate();
  int eliminate_all_pivots();
  double* column(int j) { return values_.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(size_); }
  void exchange_rows(int i, int j);
  void exchange_columns(int i, int j);

  int size_;
  int rank_;  // smaller than size_ only when singular matrices are allowed
  LinearSolverOptions options_;
  std::vector<double> values_, work_, inverse_pivot_;
  std::vector<int> row_exchange_, column_exchange_;
};

}  // namespace dalembert
