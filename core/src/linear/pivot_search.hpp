// Chooses the pivots of a sparse factorization from the values of the matrix, front by front.
#pragma once

#include <span>
#include <vector>

#include "assembly_tree.hpp"
#include "dalembert/linear/linear_solver.hpp"
#include "front_kernels.hpp"
#include "scaling.hpp"

namespace dalembert {

// A front with its pivots: entry (rows[k], columns[k]) is the k-th for k < pivots; the rest goes to the parent.
struct PivotedFront {
  std::vector<int> rows, columns;
  int pivots = 0;
};

struct PivotSearch {
  std::vector<PivotedFront> fronts;  // same order as in the tree
  int singular_column = LinearSolver::success;
  int largest_front = 0;  // rows
  bool outgrown = false;  // a front had more rows than it may have: the search has been given up
};

// The order as it stands is good if no entry of L is larger than this.
inline constexpr double harmless_growth = 10;

// Each unknown with its own equation, in the order of the tree.
std::vector<PivotedFront> pivots_in_order(const std::vector<FrontStructure>& tree);

// Partial pivoting within the fronts. Columns without an acceptable pivot are handed to the parent: if it were smaller than
// `smallest_ratio` times the largest entry of its column. If a front without parent
// has such columns, the matrix is singular: they are left over there if the options allow it.
PivotSearch search_pivots(const Pattern& pattern, const std::vector<FrontStructure>& tree,
                          std::span<const double> values, const Scaling& scaling, double smallest_ratio,
                          const LinearSolverOptions& options, const FrontKernels& kernels, int most_rows);

}  // namespace dalembert
