// Accelerations and multipliers at any state, also with redundant constraints, and the projection onto the constraints:
//
// [M  G^T] [a     ]   [Q          ]
// [G  0  ] [lambda] = [-(G v)_q v ]
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/constraint_solver.hpp"

namespace dalembert {

class ConstrainedMotion {
 public:
  // User functions that prescribe gaps are not called after `end_time`, when they may be undefined.
  void prepare(System& system, LinearSolverType type, const LinearSolverOptions& options,
               const RedundantConstraintsSettings& settings, double end_time = std::numeric_limits<double>::infinity());
  // Call this after constraints were switched on or off: the next factorization computes their metric again.
  void examine_anew();
  // Disables the regularization. The factors have to be computed again.
  void solve_as_regular();
  // Computes the factors at a state. Returns LinearSolver::success, or the unknown without a pivot.
  int factorize(System& system, const State& state, const Conditions& conditions);
  // The same with unit masses for coordinates without mass.
  int factorize_with_all_masses(System& system, const State& state, const Conditions& conditions);
  // The same with another matrix in place of the masses, which the caller has written to `matrix` together with the columns
  // of the multipliers. If a step changes velocities by `step` times the accelerations, the constraint gradients change too
  // (0: they do not).
  std::span<double> matrix() { return matrix_; }
  const Pattern& pattern() const { return *pattern_; }
  int factorize_around_matrix(System& system, const State& state, const Conditions& conditions, double step = 0);
  // Registers gaps at the start of a step (ConstraintSolver::remember).
  void begin_step(System& system, const State& start, const Conditions& conditions);
  // Solves for all unknowns: [Q, 0, right-hand sides of the constraints] becomes [a, 0, lambda].
  void solve(std::span<double> x);
  // Replaces the forces Q in `a` by accelerations, and computes minimum-norm multipliers.
  void accelerations(System& system, const State& state, const Conditions& conditions, std::span<double> a,
                     std::span<double> lambda);
  // In a singular position, such as that of a flat four-bar, many accelerations fulfil the constraints. `follow_motion`
  // replaces `a` and `lambda` at the start of a motion by the limits from positions on both sides along the velocities. It
  // returns false if the sides do not agree. `find` computes accelerations and multipliers at a state with factors.
  using Find = std::function<void(const State& state, std::vector<double>& a, std::vector<double>& lambda)>;
  bool follow_motion(System& system, const State& start, const Conditions& conditions, std::vector<double>& a,
                     std::vector<double>& lambda, const Find& find);
  // Second derivatives of gaps, or first derivatives of velocity constraints, along the motion with the accelerations of the
  // state. Entries of inactive constraints are their multipliers.
  std::vector<double> gap_accelerations(System& system, const State& state, const Conditions& conditions);
  // The same without contributions of prescribed functions of time.
  static std::vector<double> gap_accelerations_without_driving(System& system, const State& state,
                                                               const Conditions& conditions);
  // Projects positions and velocities onto the constraints, by the smallest changes in the metric of the masses, with the
  // current factors. Returns false if gaps or rates remain too large.
  bool project(System& system, State& state, const Conditions& conditions);
  // Replaces multipliers of a state by those with minimum norm in this metric. The object must not have another use.
  void make_smallest(const ConstraintSolver& metric, System& system, const State& state, const Conditions& conditions,
                     std::span<double> lambda);
  void make_smallest(std::span<double> lambda);  // with the current factors
  // Releases the memory of a solution.
  void free_memory();
  const ConstraintSolver& constraints() const { return constraints_; }
  double largest_misfit() const { return largest_misfit_; }  // after projections
  // Part of the gaps of a state that no motion can close; empty if it is too small for a warning.
  std::vector<double> misfit(System& system, const State& state, const Conditions& conditions);

  // Second derivatives of gaps, or first derivatives of velocity constraints, along the motion with constant velocities.
  static std::vector<double> gap_acceleration(System& system, const State& state, const Conditions& conditions);

 private:
  // Regularizes and factorizes `matrix_` at a state.
  int factorize_filled(System& system, const State& state, const Conditions& conditions);
  // The same including contributions of prescribed functions of time.
  std::vector<double> gap_accelerations_of_velocities(System& system, const State& still, const Conditions& conditions);
  void find_driven(System& system, const State& state, const Conditions& conditions);
  // Finds constraints with gaps that are velocities.
  void find_constraints_of_velocities(System& system, const State& still, const Conditions& conditions);
  void fill(System& system, const State& state, const Conditions& conditions);
  void fill_for_constraints(System& system, const State& state, const Conditions& conditions);
  void add_driving(System& system, const State& still, const Conditions& conditions, std::vector<double>& gap);
  // Solves for right-hand sides of constraints. Returns the coordinates.
  std::span<const double> move(std::span<const double> gaps);

  LinearSolverType type_ = LinearSolverType::EXUdense;
  LinearSolverOptions options_;
  RedundantConstraintsSettings settings_;
  const Pattern* pattern_ = nullptr;
  int ode2_ = 0, first_ae_ = 0;
  bool treats_redundancy_ = false, is_driven_ = false;
  double largest_misfit_ = 0, end_time_ = 0;
  std::unique_ptr<LinearSolver> factors_;
  std::vector<double> matrix_, part_, x_;
  std::vector<char> of_velocities_, driven_;
  ConstraintSolver constraints_;
};

// Constraint equations with gaps prescribed in time by user functions, which may be undefined after `end_time`.
std::vector<char> driven_equations(System& system, const State& state, const Conditions& conditions, double end_time);

}  // namespace dalembert
