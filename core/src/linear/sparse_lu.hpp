// LU factors of a sparse matrix. The first factorization chooses the pivots, later ones repeat its steps without a search
// and start again only if a pivot has become too small.
//
// Gilbert, Peierls: Sparse partial pivoting in time proportional to arithmetic operations, SIAM J. Sci. Stat. Comput. 9
// (1988).  Davis, Palamadai Natarajan: Algorithm 907: KLU, ACM TOMS 37 (2010), for the repeated factorization.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "elimination_order.hpp"
#include "supernodal_lu.hpp"

namespace dalembert {

class SparseLu final : public LinearSolver {
 public:
  SparseLu(const Pattern& pattern, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;

  // Nonzeros of both factors.
  std::size_t entries() const { return lower_.rows.size() + upper_.rows.size() + inverse_pivot_.size(); }

 private:
  struct Columns {
    std::vector<int> start, rows;
    std::vector<double> values;
    void clear() {
      start.assign(1, 0);
      rows.clear();
      values.clear();
    }
  };

  void choose_order(std::span<const double> values);
  bool try_supernodes(std::span<const double> values);
  int factorize_with_pivots(std::span<const double> values, const EliminationOrder& order);
  void reach(int column);
  void visit(int row);
  int choose_pivot(int step, int column);
  void store_column(int step, int pivot_row);
  void number_rows_by_steps();
  void plan_repetition();
  bool repeat(std::span<const double> values);

  const Pattern& pattern_;
  LinearSolverOptions options_;
  int size_;
  bool factorized_ = false;
  std::unique_ptr<SupernodalLu> supernodal_;  // takes over where the factors fill up
  EliminationOrder order_;            // column of each step
  std::vector<int> step_of_row_;      // in which step a row is the pivot; -1: not yet
  Columns lower_, upper_;             // without pivots; rows counted by steps once all pivots are known
  std::vector<double> inverse_pivot_;
  std::vector<double> work_;
  std::vector<int> target_;           // where the entries of the matrix go, in the order of the steps
  std::vector<std::size_t> source_;
  std::vector<int> source_start_;
  // Of the search: rows that a column reaches, in topological order from `top_` on.
  std::vector<int> reached_, stack_, position_;
  std::vector<char> marked_;
  int top_ = 0;
};

}  // namespace dalembert
