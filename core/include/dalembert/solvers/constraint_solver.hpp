// Solutions of equations of motion whose constraints may be redundant:
//
//   [ A   G^T    ] [ x      ]   [ f ]
//   [ G  -eps D  ] [ lambda ] = [ g ]
//
// D is the constraint metric: one number for the forces of a mechanism, and one for its moments (`ConstraintMetric`). With eps > 0, the matrix is
// regular also where constraints depend on each other. Residuals are exact, so Newton's method converges to the solution of the constraints
// themselves: eps changes the path, not the result (proximal point method, Rockafellar 1976).
//
// With S = G A^-1 G^T, the operator P = eps (S + eps D)^-1 D leaves multipliers without forces (the null space of G^T) as they are, and multiplies all
// others by about eps. One solution evaluates it: P y = -(multipliers of the solution for f = 0, g = eps D y). It
//   - takes idle parts off multipliers, which makes them the smallest ones with the same forces (`make_smallest`), and
//   - finds what no motion closes of gaps (`misfit`): that part would add to the multipliers in each iteration.
//
// eps is larger where joints do not fit: a gap of relative size g leaves a constraint of relative strength g^2 in place of a redundant one, and the
// mechanism is to move as if it were not there.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/constraint_rank.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class ConstraintSolver {
 public:
  // Of steps of a motion, of accelerations in a state, and of static equilibria, whose iterates are far off the constraints.
  enum class Matrix { motion, accelerations, statics };

  // Finds the metric at a state. The solver is active where constraints depend on each other, or nearly so. Regular models are solved as if it were not
  // there; they keep their numbers.
  void prepare(System& system, const State& state, const Conditions& conditions, const RedundantConstraintsSettings& settings, bool treats, Matrix kind);
  // What is worth a warning: a misfit relative to the size of the mechanism.
  static constexpr double silent_misfit = 1e-11;

  void forget() { *this = ConstraintSolver(); }
  bool is_prepared() const { return prepared_; }
  bool active() const { return active_; }
  // Where a matrix is singular, or Newton's method fails, a loop of joints may be in a singular position. False: there are no loops, or it is active.
  bool activate();
  void deactivate() { active_ = false; }

  // ---- gaps ----------------------------------------------------------------------------------------------------------
  // The largest gap of positions, relative to the size of the mechanism, or in radians.
  double largest(std::span<const double> gaps) const;
  // The same, also of equations that are never redundant, such as unit lengths of Euler parameters.
  double largest_of_all(std::span<const double> gaps) const;
  double unit(int equation) const { return units_[static_cast<std::size_t>(equation)]; }
  std::span<const double> units() const { return units_; }
  // A gap at the start of a step: joints may be that far apart for as long as they are active.
  void remember(double gap) { largest_gap_ = std::max(largest_gap_, gap); }
  double largest_gap() const { return largest_gap_; }
  // Chooses eps for an iterate with this gap. Joints that do not fit need misfits taken off.
  void choose(double gap, bool of_rates = false);
  bool joints_fit() const { return fit_; }

  // ---- matrices and solutions --------------------------------------------------------------------------------------------
  LinearSolverOptions options(LinearSolverOptions options) const;
  // Puts -eps D on the diagonal where it is zero. Rows of constraints of velocities (`all_rates`: of all) are multiplied by `rate` in the matrix.
  // `scale`: of A^-1 relative to the inverse masses.
  void regularize(const Pattern& pattern, std::span<double> values, double scale, double rate, bool all_rates);
  void pattern_revised() { slots_.clear(); }
  // By factors of the regularized matrix: what no motion closes of these right-hand sides (by AE number).
  std::vector<double> misfit(LinearSolver& factors, std::span<const double> gaps);
  // Solves with the exact constraints for all unknowns; multipliers are some of those that solve it.
  void solve(LinearSolver& factors, std::span<double> x);
  // Makes multipliers the smallest ones, in the metric, that exert the same forces.
  void make_smallest(LinearSolver& factors, std::span<double> multipliers);

  double eps() const { return eps_; }
  std::span<const int> rows() const { return rows_; }

 private:
  double entry(int equation) const { return entries_[static_cast<std::size_t>(equation)]; }
  // Solves for right-hand sides of constraints; multipliers are in the part from first_ae_.
  std::span<double> solve_for(LinearSolver& factors, std::span<const double> gaps);

  bool prepared_ = false, active_ = false, fit_ = true;
  Matrix kind_ = Matrix::motion;
  double eps_ = 0, largest_gap_ = 0;
  int first_ae_ = 0;
  std::vector<int> rows_;          // equations with a metric
  std::vector<double> metric_;     // D around the masses, by equation; zero: never redundant
  std::vector<double> units_;      // of gaps, by equation
  std::vector<char> of_velocities_;
  std::vector<double> entries_;    // of the diagonal, by equation
  std::vector<int> slots_;         // of the diagonal, by rows_
  std::vector<double> x_, rest_, p_;
};

// exp(median(log(M_jj / |A_jj|))): the scale of A^-1 relative to that of the inverse masses.
double scale_of_masses(std::span<const double> masses, const Pattern& pattern, std::span<const double> matrix, int ode2);

}  // namespace dalembert
