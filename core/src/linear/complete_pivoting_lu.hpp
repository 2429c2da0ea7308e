// LU factors of a dense matrix that may be singular: dependent equations are dropped.
#pragma once

#include <cstdint>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

class CompletePivotingLu final : public LinearSolver {
 public:
  CompletePivotingLu(int size, const LinearSolverOptions& options);
  // Always succeeds.
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;
  LinearSolverStatistics statistics() const override { return {factorizations_, factorizations_, values_.size()}; }

 private:
  double* column(int j) { return values_.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(size_); }
  void exchange_rows(int i, int j);
  void exchange_columns(int i, int j);

  int size_, rank_ = 0;
  double pivot_threshold_;
  std::size_t factorizations_ = 0;
  std::vector<double> values_, inverse_pivot_;
  std::vector<std::int64_t> largest_;  // of each column, in the rows that are left: bits of an absolute value
  std::vector<int> row_exchange_, column_exchange_;
};

}  // namespace dalembert
