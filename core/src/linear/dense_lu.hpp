// LU factors of a dense matrix with partial pivoting. The row exchanges of one factorization are reused in the next
// one, and searched again only if partial pivoting would differ: results do not depend on earlier matrices. Small
// matrices with many zeros process nonzero entries only.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "elimination_list.hpp"
#include "front_kernels.hpp"

namespace dalembert {

class DenseLu final : public LinearSolver {
 public:
  DenseLu(int size, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;
  LinearSolverStatistics statistics() const override { return statistics_; }
  bool may_be_listed() const override;
  std::span<const int> listed_rows() const override { return row_of_step_; }
  double largest_inverse() const override { return largest_inverse_; }

  // Up to this size, starting the kernels would take longer than the computation: operations are not fused, on any
  // processor.
  static constexpr int tiny = 3;
  // No entry of L is larger if each pivot is the largest entry of its column.
  static constexpr double largest_growth = 1 + 4 * std::numeric_limits<double>::epsilon();

 private:
  struct Listed;
  int factorize_anew(std::span<const double> values);
  int search(std::span<const double> values);
  bool repeat(std::span<const double> values);
  Listed* find_list();
  void use(Listed* list);
  bool is_listed() const { return operations_ != nullptr; }
  void list_operations(std::span<const double> values);
  double factorize_repeated(std::span<const double> values);
  double factorize_whole(std::span<const double> values);
  double factorize_tiny(const double* values);
  double* column(int j) { return factors_.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(length_); }
  void exchange_rows(int i, int j);
  void solve_tiny(double* x);

  int size_, length_;
  double largest_inverse_;  // largest reciprocal of a pivot
  bool searched_ = false;
  const FrontKernels& kernels_;
  std::vector<double> factors_, inverse_pivot_, work_;
  std::vector<int> row_of_step_;
  std::vector<char> occupied_;           // by columns: entries that have differed from zero, and those opposite
  // Operations of the factorization for an order of pivots. Systems in motion come back to few orders.
  struct Listed {
    std::vector<int> row_of_step;
    std::optional<EliminationList> operations;  // empty: the dense kernels take less time
  };
  static constexpr std::size_t most_lists = 32;
  std::vector<Listed> lists_;
  std::size_t made_ = 0;    // lists; more than `most_lists` replace the first ones
  Listed* list_ = nullptr;  // of this order; null: it is made when a matrix comes again
  const EliminationList* operations_ = nullptr;  // of this list
  LinearSolverStatistics statistics_;
};

}  // namespace dalembert
