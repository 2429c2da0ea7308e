// Solvers of J x = b for a matrix whose pattern never changes: analysis once, factorization and solution many times.
#pragma once

#include <memory>
#include <span>

#include "dalembert/enums.hpp"
#include "dalembert/system/pattern.hpp"

namespace dalembert {

struct LinearSolverOptions {
  double pivot_threshold = 0;    // a pivot that is not larger counts as zero
  bool ignore_singular = false;  // leave out the equations that depend on others instead of failing
};

class LinearSolver {
 public:
  static constexpr int success = -1;

  virtual ~LinearSolver() = default;
  // `values` in pattern order. Returns success, or the column (an unknown of the system) at which no pivot was left.
  virtual int factorize(std::span<const double> values) = 0;
  // The right-hand side becomes the solution.
  virtual void solve(std::span<double> x) = 0;
};

bool is_dense(LinearSolverType type);
// The pattern must outlive the solver. Refuses LinearSolverType::_None.
std::unique_ptr<LinearSolver> make_linear_solver(const Pattern& pattern, LinearSolverType type,
                                                 const LinearSolverOptions& options);

}  // namespace dalembert
