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
  bool ignore_singular = false;   // leave out the equations that depend on others instead of failing
  int unsettled_matrices = 0;     // what is zero in the first ones may well be something else in the next
  std::string instructions = {};  // one of instruction_sets(); empty: the first
  std::vector<int> tiny_diagonal = {};  // unknowns whose diagonal entry, if there is one, is too small to count as a pivot
  std::vector<int> dependent = {};  // of these, as many as follow from others: what is left of them at last is that entry
  std::vector<int> left_out = {};   // of these, rows and columns have no part: in solutions they are zero
};

struct LinearSolverStatistics {
  std::size_t factorizations = 0;
  std::size_t pivot_searches = 0;  // factorizations that chose their pivots: the first, and those that growth has forced
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

  // Whether factors may as well be made by listed operations (elimination_list.hpp), digit by digit; then also the rows of the
  // pivots that the last factorization has chosen, and what the reciprocal of none may reach.
  virtual bool may_be_listed() const { return false; }
  virtual std::span<const int> listed_rows() const { return {}; }
  virtual double largest_inverse() const { return 0; }
};

bool is_dense(LinearSolverType type);
// The pattern must outlive the solver. Refuses LinearSolverType::_None.
std::unique_ptr<LinearSolver> make_linear_solver(const Pattern& pattern, LinearSolverType type,
                                                 const LinearSolverOptions& options);

// For which this processor has a fast path, best first; the last one is what every processor has. Results differ by rounding.
std::vector<std::string> instruction_sets();

}  // namespace dalembert
