// Solutions of linear equations with constraints that may be redundant:
//
//   [ A   G^T    ] [ x      ]   [ f ]
//   [ G  -eps D  ] [ lambda ] = [ g ]
//
// A is the mass matrix, the stiffness matrix, or the matrix of Newton's method for the coordinates; G is the constraint
// Jacobian. D is the constraint metric (`ConstraintMetric`): one number for the forces of a mechanism, and one for its
// moments. For eps > 0 the matrix is regular even if constraints are redundant. Residuals remain exact, so that iterations
// converge to the solution of the original constraints. This is the proximal point method (Rockafellar 1976).
//
// Let S = G A^-1 G^T. The operator P = eps (S + eps D)^-1 D keeps multipliers that exert no force (the null space of G^T)
// and multiplies all others by approximately eps. One solution evaluates it: P y is the negative multiplier part of the
// solution for f = 0, g = eps D y. The operator has two uses:
//   - It removes the null-space part of multipliers (`make_smallest`). The result has the minimum norm of all multipliers
//     with the same forces.
//   - Its transpose gives the misfit: the part of constraint violations that no motion can close. Multipliers would
//     increase by this part in each iteration.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

// The factors that are passed are those of the matrix with the entries -eps D.
class ProximalEquations {
 public:
  ProximalEquations() = default;
  // metric: D by equation; zero if an equation is never redundant. The unknowns of the equations start at `first`.
  ProximalEquations(int first, std::vector<double> metric);

  std::span<const double> metric() const { return metric_; }
  const std::vector<int>& rows() const { return rows_; }  // equations with a metric
  // Entries -eps D of the matrix, by equation; zero where an equation is not regularized.
  std::span<double> entries() { return entries_; }

  // Solves with exact constraints by iterative refinement. Multipliers are not unique. `fit` = false: constraints contradict
  // each other, and their misfit is left open.
  void solve(LinearSolver& factors, std::span<double> x, bool fit);
  // The part of constraint violations that no motion can close, by equation.
  std::vector<double> misfit(LinearSolver& factors, std::span<const double> gaps);
  // Replaces multipliers by those with minimum norm in the metric that exert the same forces.
  void make_smallest(LinearSolver& factors, std::span<double> multipliers);

 private:
  // Solves for right-hand sides of constraints. Returns all unknowns.
  std::span<double> solve_for(LinearSolver& factors, std::span<const double> gaps);

  std::size_t first_ = 0;
  std::vector<int> rows_;
  std::vector<double> metric_, entries_;
  std::vector<double> x_, rest_;
};

}  // namespace dalembert
