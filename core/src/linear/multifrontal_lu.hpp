// LU factors of a sparse matrix with symmetric pattern: a tree of small dense matrices (fronts), each of which eliminates some
// unknowns and hands the rest to its parent. The first factorization chooses the pivots, later ones repeat its steps without a
// search and start again only if entries of the factors grow too much.
//
// Duff, Reid: The multifrontal solution of indefinite sparse symmetric linear equations, ACM TOMS 9 (1983).
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "assembly_tree.hpp"
#include "dalembert/linear/linear_solver.hpp"
#include "front_kernels.hpp"
#include "number_storage.hpp"
#include "pivot_search.hpp"

namespace dalembert {

class MultifrontalLu final : public LinearSolver {
 public:
  // `slots`: positions of the pattern's values among the given values; empty: these are the values.
  MultifrontalLu(const Pattern& pattern, const LinearSolverOptions& options, std::vector<int> slots = {});
  int factorize(std::span<const double> given) override;
  void solve(std::span<double> x) override;
  // Variant for unknowns and equations at these positions of a larger system.
  void solve_for(std::span<const int> places, std::span<double> x);
  LinearSolverStatistics statistics() const override;
  // Returns the number of negative eigenvalues of a symmetric matrix, which is eliminated in the order of the present factors; these are kept.
  // Returns nothing if that order has unsymmetric pivots, or if a pivot is of the size of rounding errors (inertia.cpp).
  std::optional<int> negative_eigenvalues(std::span<const double> given);

 private:
  static constexpr int longest_run = 4;  // entries of a column that are added together

  struct Front {
    int pivots, updates, length;  // length: of a column
    int first_slot;  // of the pivots
    std::size_t lower, upper;  // addresses of its factors
    std::size_t columns;  // address of its columns; the update columns are kept until the parent has added them
    std::size_t first_update;  // start of data stored per update
    std::size_t runs, end_of_runs;
    int first_entry;
    std::array<int, longest_run + 3> end_of_entries;  // ends of runs, from the longest to single entries; then by scale
    int children, end_of_children;
  };
  // Destination of an entry of the matrix, or of the first one of a run.
  struct Entry {
    int slot, target;  // slot: in the given values; target: in the columns of the front
  };
  class RunsOfEntries;

  int start_again(std::span<const double> given);
  int search_and_adopt(std::span<const double> values, std::span<const double> given);
  double adopt(std::vector<PivotedFront> fronts, std::span<const double> values, std::span<const double> given);
  void plan(std::vector<PivotedFront> fronts);
  void sort_updates(std::vector<PivotedFront>& fronts, const std::vector<std::vector<int>>& children) const;
  void place_factors(const std::vector<PivotedFront>& fronts);
  std::vector<int> number_slots(const std::vector<PivotedFront>& fronts);
  void place_entries(const std::vector<PivotedFront>& fronts);
  void place_updates(const std::vector<PivotedFront>& fronts, const std::vector<std::vector<int>>& children,
                     const std::vector<int>& slot_of_row);
  void place_columns();
  bool repeat(std::span<const double> given);
  std::optional<int> negative_pivots(const Front& front, double* panel);
  bool regular() const;
  double residual_of_test(std::span<const double> values);
  template <class Place>
  void solve_at(Place&& place, std::span<double> b);
  void assemble(const Front& front, std::span<const double> given);
  template <int Length>
  void take_runs(const Front& front, const double* given, double* to) const;
  void take_over(const Front& child, double* to);
  double* factor(std::size_t place) { return factors_.data() + place; }
  double* columns(const Front& front) { return columns_.data() + front.columns; }

  const Pattern& pattern_;
  LinearSolverOptions options_;
  std::vector<int> slots_;
  const FrontKernels& kernels_;
  int size_;
  bool planned_ = false;
  double growth_ = 0;  // largest entry of L
  double planned_growth_ = 1;  // growth in the factorization that has selected the pivots
  Scaling scaling_;
  std::array<double, 3> scales_ = {};  // scales of entries in the row of a multiplier, in the column of one, in both
  int pivot_slots_ = 0;  // behind them are unknowns without pivot, only if singular matrices are allowed
  std::shared_ptr<const std::vector<FrontStructure>> tree_;
  std::vector<Front> fronts_;
  std::vector<Entry> entries_;
  std::vector<int> children_;
  std::vector<int> places_;  // column of each update in the parent
  std::vector<RowRun> runs_;
  std::vector<FrontSize> sizes_;
  std::vector<int> row_slot_, column_slot_;  // per update
  std::vector<int> row_of_slot_, slot_of_column_;  // slots without an unknown have any row
  std::vector<double> row_scale_, column_scale_;  // by slots, by unknowns
  std::vector<double> inverse_pivot_, least_pivot_;  // by slots; smaller pivots count as zero
  NumberStorage columns_;  // columns of the current front, and update matrices
  NumberStorage factors_;  // factors of all fronts
  std::size_t first_upper_ = 0;  // upper factors in factors_
  std::vector<double> unknowns_, work_;  // by slots, by updates of a front
  LinearSolverStatistics statistics_;
};

}  // namespace dalembert
