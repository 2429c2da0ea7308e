// LU factors of a sparse matrix with symmetric pattern: a tree of small dense matrices (fronts), each of which eliminates some
// unknowns and hands the rest to its parent. The first factorization chooses the pivots, later ones repeat its steps without a
// search and start again only if entries of the factors grow too much.
//
// Duff, Reid: The multifrontal solution of indefinite sparse symmetric linear equations, ACM TOMS 9 (1983).
#pragma once

#include <cstddef>
#include <vector>

#include "assembly_tree.hpp"
#include "dalembert/linear/linear_solver.hpp"
#include "front_kernels.hpp"
#include "pivot_search.hpp"

namespace dalembert {

class MultifrontalLu final : public LinearSolver {
 public:
  MultifrontalLu(const Pattern& pattern, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;
  LinearSolverStatistics statistics() const override;

 private:
  struct Front {
    int pivots, updates, length;    // length: of a column
    int first_step;                 // of the pivots
    std::size_t panel, upper;       // where the pivot columns and the rest of the pivot rows are stored
    std::size_t right;              // where the other columns are while the parent needs them
    std::size_t first_update;       // of what is stored per update
    int updates_in_panel;           // updates whose columns are pivots of the parent
    int panel_entries, right_entries, end_of_entries;
    int children, end_of_children;
  };
  // Where an entry of the matrix goes.
  struct Entry {
    int slot;              // in the values of the matrix
    unsigned target : 30;  // in the panel or in the columns right of it
    unsigned scale : 2;    // as index into scales_: 1 in a row, 2 in a column of a multiplier
  };
  // What is done with one row and column that a front leaves to its parent.
  struct Update {
    int row, column;              // its place in the parent; the column as offset in the panel or right of it
    int row_step, column_step;
  };
  struct alignas(64) Line {
    double values[8];
  };

  int start_again(std::span<const double> values);
  void plan(PivotSearch search);
  void sort_updates(std::vector<PivotedFront>& fronts, const std::vector<std::vector<int>>& children) const;
  void number_steps(const std::vector<PivotedFront>& fronts);
  void place_entries(const std::vector<PivotedFront>& fronts);
  void place_updates(const std::vector<PivotedFront>& fronts, const std::vector<std::vector<int>>& children);
  void place_columns();
  bool repeat(std::span<const double> values);
  bool regular() const;
  double residual_of_test(std::span<const double> values);
  void assemble(const Front& front, std::span<const double> values);
  void take_over(const Front& child, const Front& front);
  double* factor(std::size_t place) { return factors_.data()->values + place; }
  double* right(const Front& front) { return columns_.data()->values + front.right; }

  const Pattern& pattern_;
  LinearSolverOptions options_;
  const FrontKernels& kernels_;
  int size_;
  bool planned_ = false;
  double growth_ = 0;          // largest entry of L
  double planned_growth_ = 1;  // in the factorization that has chosen the pivots
  Scaling scaling_;
  double scales_[4] = {1, 1, 1, 1};
  int left_out_ = 0;  // unknowns without pivot, the last steps; only if singular matrices are allowed
  std::vector<FrontStructure> tree_;
  std::vector<Front> fronts_;
  std::vector<Entry> entries_;
  std::vector<int> children_;
  std::vector<Update> updates_;
  std::vector<int> row_of_step_, column_of_step_;
  std::vector<double> row_scale_, column_scale_;  // by steps
  std::vector<Line> factors_, columns_;
  std::vector<double> inverse_pivot_, steps_, work_, others_;
  LinearSolverStatistics statistics_;
};

}  // namespace dalembert
