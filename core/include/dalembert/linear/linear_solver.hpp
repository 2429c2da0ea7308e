// Solvers of J x = b for a matrix whose pattern never changes: analysis once, factorization and solution many times.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dalembert/enums.hpp"
#include "dalembert/system/pattern.hpp"

namespace dalembert {

struct LinearSolverOptions {
  double pivot_threshold = 0;     // a pivot that is not larger counts as zero
  bool ignore_singular = false;  // drop dependent equations instead of failing
  int unsettled_matrices = 0;  // zeros in the first matrices may become nonzero in later ones
  std::string instructions = {};  // one of instruction_sets(); empty: the first
  std::vector<int> tiny_diagonal =
      {};  // unknowns whose diagonal entry, if there is one, is too small to count as a pivot
  std::vector<int> dependent = {};  // redundant ones among these: their last pivots are that entry
};

struct LinearSolverStatistics {
  std::size_t factorizations = 0;
  std::size_t pivot_searches =
      0;  // factorizations that chose their pivots: the first, and those that growth has forced
  std::size_t entries = 0;         // numbers in the factors
};

class LinearSolver {
 public:
  static constexpr int success = -1;

  virtual ~LinearSolver() = default;
  // `values` in pattern order. Returns success, or the column (an unknown of the system) at which no pivot was left.
  virtual int factorize(std::span<const double> values) = 0;
  // The right-hand side becomes the solution.
  virtual void solve(std::span<double> x) = 0;
  virtual LinearSolverStatistics statistics() const = 0;

  // Whether factors may as well be computed by listed operations (elimination_list.hpp), bit-identical; if so, also
  // the pivot rows of the last factorization, and the upper bound of the reciprocal pivots.
  virtual bool may_be_listed() const { return false; }
  virtual std::span<const int> listed_rows() const { return {}; }
  virtual double largest_inverse() const { return 0; }
};

bool is_dense(LinearSolverType type);
// The pattern must outlive the solver. Rejects LinearSolverType::_None.
std::unique_ptr<LinearSolver> make_linear_solver(const Pattern& pattern, LinearSolverType type,
                                                 const LinearSolverOptions& options);

// Instruction sets with a fast path on this processor, best first; the last one is supported by every processor.
// Results differ by rounding.
std::vector<std::string> instruction_sets();

}  // namespace dalembert
