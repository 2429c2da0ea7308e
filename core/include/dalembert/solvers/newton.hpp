// Solvers that find the state at the end of a step by Newton's method, full or modified.
#pragma once

#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/constraint_solver.hpp"
#include "dalembert/solvers/solver.hpp"
#include "dalembert/system/large_vectors.hpp"

namespace dalembert {

class NewtonSolver : public Solver {
 public:
  void initialize_data() override;
  bool newton() override;
  void free_memory() override;
  void pattern_revised() override;
  void forget() override;

  // Residual of the current state; returns the number that is compared with the tolerances.
  virtual double compute_residual() = 0;
  // Moves the current state by the increment, or to the prediction of a step if `initial`.
  virtual void compute_update(bool initial) = 0;
  // Values of the system matrix for the current state.
  virtual void compute_jacobian() = 0;

  const ConstraintSolver& constraint_solver() const override { return constraints_; }

  std::span<double> residual() { return residual_; }
  std::span<double> increment() { return increment_; }
  std::span<double> jacobian_values() { return jacobian_; }
  const Pattern& pattern() const { return *pattern_; }

 protected:
  // Norm that is compared with the tolerances.
  template <class S>
  S norm_of(const std::vector<S>& residual) const {
    using std::sqrt;
    if constexpr (std::is_same_v<S, double>)
      return sqrt(sum_of_squares(system(), residual)) / conv.errorCoordinateFactor;
    else
      return sqrt(sum_of_squares<S>(residual)) / conv.errorCoordinateFactor;
  }
  void examine_constraints_anew() override;
  const std::vector<double>* minimum_norm_multipliers() override;
  void prepare_constraints(const ConstraintSolver& known);
  void multipliers_renewed() { idle_ = Idle::none; }  // multipliers have minimum norm
  // Factorizes `jacobian_`. Returns false, with flags set, if it is singular.
  bool factorize();

  // Iterations of the last loop, without those in which round-off kept the residual from decreasing.
  int useful_iterations() const { return it.newtonSteps - loop_.idle; }

  const Pattern* pattern_ = nullptr;
  std::unique_ptr<LinearSolver> linear_;
  bool factorized_ = false;  // result of the last factorization
  std::vector<double> residual_, increment_, jacobian_;
  double least_initial_residual_ = 0;  // tolerances are relative to no less
  bool full_newton_ = true;  // a new Jacobian in every iteration

 private:
  friend class Lockstep;
  struct Loop {
    double initial_residual = 0;
    double first_residual = 0;  // residual after the first iteration
    double best_residual = 0;
    std::optional<double> round_off;  // found when it is first needed: increments are small then
    int idle = 0;
    int iterations_to_close = 0;  // constraints, after the tolerances are met
    double gap = 0;               // of constraints in the last static iterate
    bool restarted = false;      // modified Newton has been started again from the beginning of the step
    bool lost = false;           // the residual is not finite, or beyond all bounds
    bool one_more_step = false;  // after a restart, convergence counts only if confirmed by another iteration
  };

  // ---- redundant constraints (newton_constraints.cpp) ---------------------------------------------------------------
  void prepare_constraints();
  void begin_step_with_constraints();
  bool solves_with_dependent_constraints();
  void solve_as_regular() override;
  bool leaves_constraints_open();
  std::unique_ptr<LinearSolver> new_linear_solver() const;
  void choose_eps();
  void take_off_misfit();
  double residual_without_misfit();
  bool settle_multipliers();
  double gap_of_positions();
  // Size of the inverse Jacobian of the coordinates, relative to the inverse masses.
  virtual double metric_scale() = 0;
  LinearSolverOptions newton_options() const;
  // Factor of velocity constraints in `jacobian_`.
  virtual double rate_factor() const { return 1; }

  // ---- the parts of newton ---------------------------------------------------------------------------------------
  void take_pattern();
  bool iterate_to_the_end();
  void begin_newton();
  void judge_start(double residual);
  bool goes_on() const;
  bool begin_iteration();  // true: a new Jacobian is due
  void jacobian_renewed();
  void judge(double residual);
  bool succeeded() const { return conv.newtonConverged && !conv.stopNewton; }
  bool leaves_correction() const;
  void correct_motion();

  void iterate();
  bool check_convergence();
  bool stagnated() const;
  void treat_slow_convergence();
  void restart();
  bool diverged();
  double evaluate_residual();
  double relative_increment();
  double find_round_off_level();
  // Factor of ODE2 equations in `residual_`.
  virtual double row_scale() const { return 1; }
  std::vector<double> unscaled_residual() const;
  void report_failure();
  void report_not_finite();
  void announce_matrices();
  void announce_inverse();

  Loop loop_;
  ConstraintSolver constraints_;
  // Whether multipliers still contain a null-space part, and whether the factors of their state are available.
  enum class Idle { none, at_factors, at_state };
  Idle idle_ = Idle::none;
  std::unique_ptr<ConstrainedMotion> forces_;  // constraint forces, for multipliers of states without factors
  bool contradiction_ = false;   // Newton's method converged with a misfit above the setting
  std::vector<double> misfit_;  // gaps that no motion can close, by equation; may be empty
};

}  // namespace dalembert
