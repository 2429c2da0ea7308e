// [M  G^T] [a     ]   [Q              ]
// [G  0  ] [lambda] = [-(G v)_q v     ]   at any state, also with redundant constraints; and the way back onto the constraints.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/simulation_settings.hpp"
#include "dalembert/solvers/redundant_constraints.hpp"

namespace dalembert {

class ConstrainedMotion {
 public:
  // Whether user functions drive constraints is not asked after `end_time`, where they may not be defined.
  void prepare(System& system, LinearSolverType type, const LinearSolverOptions& options, const RedundantConstraintsSettings& settings,
               double end_time = std::numeric_limits<double>::infinity());
  // Which constraints are redundant shows where they hold: at starts of steps, and not in what is tried from there. At the first of them, and
  // once again after something has been found, or singular matrices have been passed.
  bool to_be_examined(const State& start_of_step) const;
  // Actions of the user may have switched constraints on or off.
  void examine_anew() { examines_anew_ = is_examined(); }
  bool is_examined() const { return knowledge_ != Knowledge::none; }
  bool in_singular_position() const { return knowledge_ == Knowledge::passing; }
  // Whether factors at hand serve no longer.
  bool examine(System& system, const State& start_of_step, const Conditions& conditions);
  // The factors at this state; success, or the unknown without a pivot. The first state is examined.
  int factorize(System& system, const State& state, const Conditions& conditions);
  // The same, where `known` has found that some of these constraints follow from others; with ones where there are no masses. To be prepared, and
  // for this alone.
  int factorize(const RedundantConstraints& known, System& system, const State& state, const Conditions& conditions);
  // The same around another matrix than that of the masses, which has been put here, with the columns of the multipliers.
  std::span<double> matrix() { return matrix_; }
  const Pattern& pattern() const { return *pattern_; }
  // Where accelerations also change velocities, by a `step` times as much, and with them positions, constraints may do so, too.
  int factorize_around_matrix(System& system, const State& state, const Conditions& conditions, double step = 0);
  // Of all unknowns; [Q, 0, right-hand sides of the constraints] becomes [a, 0, lambda].
  void solve(std::span<double> x);
  // The same for an increment of Newton's method. What no motion closes of the second derivatives of gaps would make multipliers larger in each
  // iteration: the first ones find it, and the next ones do without.
  void begin_iterations() { kept_.clear(); }
  void solve_increment(std::span<double> x);
  // With the forces Q in `a`, which become accelerations. False: of the motions that are possible from here on, nothing tells which one it will be.
  bool accelerations(System& system, const State& state, const Conditions& conditions, std::span<double> a, std::span<double> lambda);
  // Where the position at the start is a singular one, which shows a moment later, many accelerations fulfil the constraints: the ones that the
  // motion goes on with, and its multipliers, replace those that have been found, and so does what is redundant then. False: a moment later does
  // not tell either.
  bool leave_singular_position(System& system, const State& start, Conditions conditions, std::span<double> a, std::span<double> lambda);
  // Second derivatives of gaps, or derivatives of constraints of velocities, along the motion with the accelerations of the state; what is
  // not active gives its multiplier.
  std::vector<double> gap_accelerations(System& system, const State& state, const Conditions& conditions);
  // The same, without what is prescribed in time.
  static std::vector<double> gap_accelerations_without_driving(System& system, const State& state, const Conditions& conditions);
  // Moves the state by the smallest changes, in the metric of the masses, that close gaps and end their rates, with the factors at
  // hand. False: they do not get small enough.
  bool project(System& system, State& state, const Conditions& conditions);
  // Makes multipliers of a state the smallest ones, where `known` has found that some constraints follow from others. To be prepared, and for this
  // alone.
  void take_off_idle_part(const RedundantConstraints& known, System& system, const State& state, const Conditions& conditions, std::span<double> lambda);
  // A state further on, on the constraints: along the velocities, and where any forces would lead, by this part of the size of the model, or so many
  // radians. To be prepared.
  State moved_by(double part, System& system, const State& at, const Conditions& conditions);
  // All but what has been found out.
  void free_memory();
  const RedundantConstraints& redundant() const { return redundant_; }
  double largest_misfit() const { return largest_misfit_; }  // that projections have left
  // What no motion closes of the gaps of a state; empty: nothing worth a word.
  std::vector<double> misfit(System& system, const State& state, const Conditions& conditions) const;

  // Second derivatives of gaps, or derivatives of constraints of velocities, along the motion with constant velocities.
  static std::vector<double> gap_acceleration(System& system, const State& state, const Conditions& conditions);

 private:
  // Of redundant constraints. `first`: as the first state has shown, which may be a singular position; `beside`: that was one, and a moment later
  // has shown; `confirmed`: another start of a step has shown the same; `passing`: a matrix was singular, and is not beside
  // this position.
  enum class Knowledge { none, first, beside, confirmed, passing };

  int factorize_filled(System& system, const State& state, const Conditions& conditions);
  // With constant velocities, and those that are prescribed in time.
  std::vector<double> gap_accelerations_of_velocities(System& system, const State& still, const Conditions& conditions);
  void find_driven(System& system, const State& state, const Conditions& conditions);
  // Whose gaps are rates already.
  void find_constraints_of_velocities(System& system, const State& still, const Conditions& conditions);
  void fill(System& system, const State& state, const Conditions& conditions);
  void fill_for_constraints(System& system, const State& state, const Conditions& conditions);
  int examine_filled(System& system, const State& state, const Conditions& conditions);
  bool follow_from_others(System& system, const State& state, const Conditions& conditions);
  bool measure_redundancy(System& system, const State& state, const Conditions& conditions);
  bool look_for_redundancy(System& system, const State& state, const Conditions& conditions, int& singular);
  bool treat_redundancy(System& system, const State& state, const Conditions& conditions, int& singular);
  int pass_singular_matrix(System& system, int singular);
  bool pass(int& singular);
  bool is_regular_beside(const ConstrainedMotion& other, System& system, const State& at, const Conditions& conditions, std::span<const double> step);
  void add_free_motion(double part, const System& system, const State& at, std::span<double> step);
  bool same_follow_beside(System& system, const State& at, const Conditions& conditions, std::span<const double> step);
  bool fewer_follow_beside(System& system, const State& at, const Conditions& conditions);
  bool accelerations_after(double time, System& system, const State& start, const Conditions& conditions, std::vector<double>& a,
                           std::vector<double>& lambda);
  bool accelerations_beside(double part, const ConstrainedMotion& other, System& system, const State& start, const Conditions& conditions,
                            std::vector<double>& a, std::vector<double>& lambda);
  void follow_velocities(System& system, const State& start, const Conditions& conditions, std::span<double> a, std::span<double> lambda);
  void weigh_again(System& system);
  void add_driving(System& system, const State& still, const Conditions& conditions, std::vector<double>& gap);
  // Solutions for right-hand sides of the constraints alone; returns the part of the coordinates.
  std::span<const double> move(std::span<const double> gaps);
  void close_what_eps_leaves(int times, std::span<double> x);

  LinearSolverType type_ = LinearSolverType::EXUdense;
  LinearSolverOptions options_;
  RedundantConstraintsSettings settings_;
  const Pattern* pattern_ = nullptr;
  int ode2_ = 0, first_ae_ = 0;
  int followed_ = 0;  // combinations that factors for idle parts have been made for
  bool treats_redundancy_ = false, is_driven_ = false, looks_beside_ = true, examines_anew_ = false;
  Knowledge knowledge_ = Knowledge::none;
  double examined_at_ = 0;  // time
  double largest_misfit_ = 0, end_time_ = 0;
  std::unique_ptr<LinearSolver> factors_;
  std::vector<double> matrix_, part_, x_, rest_, kept_;
  std::vector<double> gaps_;  // of the positions in which constraints have been measured
  std::vector<char> of_velocities_, driven_;
  RedundantConstraints redundant_;
};

// Constraint equations whose gaps are prescribed in time, by user functions, which may not be defined after `end_time`.
std::vector<char> driven_equations(System& system, const State& state, const Conditions& conditions, double end_time);

}  // namespace dalembert
