// [M  G^T] [a     ]   [Q              ]
// [G  0  ] [lambda] = [-(G v)_q v     ]   at any state, also with redundant constraints; and the projection onto the constraints.
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
  // Whether user functions drive constraints is not asked after `end_time`, where they may not be defined.
  void prepare(System& system, LinearSolverType type, const LinearSolverOptions& options, const RedundantConstraintsSettings& settings,
               double end_time = std::numeric_limits<double>::infinity());
  // Constraints may have been switched on or off: their metric is found again at the next factorization.
  void examine_anew();
  // Solves without regularization from now on. The factors have to be computed again.
  void solve_as_regular();
  // The factors at this state. Returns LinearSolver::success, or the unknown without a pivot.
  int factorize(System& system, const State& state, const Conditions& conditions);
  // The same with ones where there are no masses.
  int factorize_with_all_masses(System& system, const State& state, const Conditions& conditions);
  // The same around another matrix than that of the masses, which has been put into `matrix` with the columns of the multipliers.
  // Accelerations that also change velocities by `step` times as much, and with them positions, change gradients, too (0: they do not).
  std::span<double> matrix() { return matrix_; }
  const Pattern& pattern() const { return *pattern_; }
  int factorize_around_matrix(System& system, const State& state, const Conditions& conditions, double step = 0);
  // Gaps at the start of a step, see ConstraintSolver::remember.
  void begin_step(System& system, const State& start, const Conditions& conditions);
  // Of all unknowns; [Q, 0, right-hand sides of the constraints] becomes [a, 0, lambda].
  void solve(std::span<double> x);
  // With the forces Q in `a`, which become accelerations, and the smallest multipliers.
  void accelerations(System& system, const State& state, const Conditions& conditions, std::span<double> a, std::span<double> lambda);
  // At the start of a motion. In a singular position, such as a four-bar that lies flat, many accelerations fulfil the constraints: then `a` and
  // `lambda` become those of the motion that goes on, from positions on both sides along the velocities. False: the sides do not agree.
  // `find` computes accelerations and multipliers at a state, to which the motion has factors.
  using Find = std::function<void(const State& state, std::vector<double>& a, std::vector<double>& lambda)>;
  bool follow_motion(System& system, const State& start, const Conditions& conditions, std::vector<double>& a, std::vector<double>& lambda, const Find& find);
  // Second derivatives of gaps, or derivatives of constraints of velocities, along the motion with the accelerations of the state; what is
  // not active gives its multiplier.
  std::vector<double> gap_accelerations(System& system, const State& state, const Conditions& conditions);
  // The same, without what is prescribed in time.
  static std::vector<double> gap_accelerations_without_driving(System& system, const State& state, const Conditions& conditions);
  // Moves the state by the smallest changes, in the metric of the masses, that close gaps and end their rates, with the factors at
  // hand. False: they do not get small enough.
  bool project(System& system, State& state, const Conditions& conditions);
  // Makes multipliers of a state the smallest ones, in this metric. To be prepared, and for this alone.
  void make_smallest(const ConstraintSolver& metric, System& system, const State& state, const Conditions& conditions, std::span<double> lambda);
  void make_smallest(std::span<double> lambda);  // by the factors at hand
  // Releases what was needed for one solution.
  void free_memory();
  const ConstraintSolver& constraints() const { return constraints_; }
  double largest_misfit() const { return largest_misfit_; }  // that projections have left
  // What no motion closes of the gaps of a state; empty: less than what is worth a warning.
  std::vector<double> misfit(System& system, const State& state, const Conditions& conditions);

  // Second derivatives of gaps, or derivatives of constraints of velocities, along the motion with constant velocities.
  static std::vector<double> gap_acceleration(System& system, const State& state, const Conditions& conditions);

 private:
  // Regularizes and factorizes `matrix_` for a state.
  int factorize_filled(System& system, const State& state, const Conditions& conditions);
  // With constant velocities, and those that are prescribed in time.
  std::vector<double> gap_accelerations_of_velocities(System& system, const State& still, const Conditions& conditions);
  void find_driven(System& system, const State& state, const Conditions& conditions);
  // Whose gaps are rates already.
  void find_constraints_of_velocities(System& system, const State& still, const Conditions& conditions);
  void fill(System& system, const State& state, const Conditions& conditions);
  void fill_for_constraints(System& system, const State& state, const Conditions& conditions);
  void add_driving(System& system, const State& still, const Conditions& conditions, std::vector<double>& gap);
  // Solutions for right-hand sides of the constraints alone; returns the part of the coordinates.
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

// Constraint equations whose gaps are prescribed in time, by user functions, which may not be defined after `end_time`.
std::vector<char> driven_equations(System& system, const State& state, const Conditions& conditions, double end_time);

}  // namespace dalembert
