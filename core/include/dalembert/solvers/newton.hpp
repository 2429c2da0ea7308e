// Solvers that find the state at the end of a step by Newton's method, full or modified.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/redundant_constraints.hpp"
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
  // Moves the current state by the increment; `initial`: to the prediction at the start of a step.
  virtual void compute_update(bool initial) = 0;
  // Values of the system matrix for the current state.
  virtual void compute_jacobian() = 0;

  const RedundantConstraints& redundant_constraints() const override { return redundant_; }

  std::span<double> residual() { return residual_; }
  std::span<double> increment() { return increment_; }
  std::span<double> jacobian_values() { return jacobian_; }
  const Pattern& pattern() const { return *pattern_; }

 protected:
  // As it is compared with the tolerances.
  template <class S>
  S norm_of(const std::vector<S>& residual) const {
    using std::sqrt;
    if constexpr (std::is_same_v<S, double>) return sqrt(sum_of_squares(system(), residual)) / conv.errorCoordinateFactor;
    else return sqrt(sum_of_squares<S>(residual)) / conv.errorCoordinateFactor;
  }
  void examine_constraints_anew() override;
  // As another matrix with them has shown.
  void constraints_are_known(RedundantConstraints found);
  const std::vector<double>* told_multipliers() override;
  void multipliers_renewed() { idle_ = Idle::none; }  // to the smallest ones
  // Make the factors of the matrix in `jacobian_`; false, with the flags set, if it is singular.
  bool factorize();

  // Of the last loop, without those that round-off has kept from making the residual smaller.
  int useful_iterations() const { return it.newtonSteps - loop_.idle; }

  const Pattern* pattern_ = nullptr;
  std::unique_ptr<LinearSolver> linear_;
  bool factorized_ = false;  // what `linear_` was last given
  std::vector<double> residual_, increment_, jacobian_;
  double least_initial_residual_ = 0;  // tolerances are relative to no less
  bool full_newton_ = true;  // a new Jacobian in every iteration

 private:
  friend class Lockstep;
  struct Loop {
    double initial_residual = 0;
    double first_residual = 0;  // after the first iteration
    double best_residual = 0;
    int idle = 0;
    bool restarted = false;      // modified Newton has been started again from the beginning of the step
    bool lost = false;           // the residual is not finite, or beyond all bounds
    bool one_more_step = false;  // after a restart, convergence counts only if confirmed by another iteration
  };

  // ---- redundant constraints (newton_redundancy.cpp) ---------------------------------------------------------------
  // A singular position is passed with the matrix that redundant constraints have, for one step.
  // `unknown`: nobody has looked yet; `announced`: another matrix has shown what the first one will have.
  enum class Treatment { none, passing, lasting, announced, unknown };

  void forget_redundancy();
  void look_for_redundancy_at_start();
  void look_for_redundancy();
  void begin_treatment(LinearSolver& factors);
  void drop_treatment();
  bool treat_from_start_of_step();
  bool treats_redundancy() const;
  bool measure_redundancy();
  void allow_for_gaps();
  bool is_in_singular_position();
  void begin_announced_treatment();
  bool may_leave_out() const;
  void leave_out(const std::vector<DependentEquations>& parts);
  void follow_left_out();
  void include_again();
  bool weigh_again();
  void regularize();
  std::unique_ptr<LinearSolver> treating_solver() const;
  bool find_combinations(double eps, LinearSolver& factors);
  std::unique_ptr<LinearSolver> find_redundancy();
  void end_treatment();
  void look_again_at_redundancy();
  void factorize_anew();
  bool try_harder();
  void take_off_misfit();
  bool leaves_misfit() const;
  double residual_without_misfit();
  bool settle_multipliers();
  bool renews_misfit();
  bool joints_fit();
  void announce_redundancy();
  LinearSolverOptions newton_options() const;
  // By which rows of constraints of velocities are multiplied in `jacobian_`.
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
  double round_off_level();
  // By which ODE2 equations are multiplied in `residual_`.
  virtual double row_scale() const { return 1; }
  std::vector<double> unscaled_residual() const;
  void report_failure();
  void report_not_finite();
  void announce_matrices();
  void announce_inverse();

  Loop loop_;
  RedundantConstraints redundant_;
  Treatment treatment_ = Treatment::none;
  // Where a part of the multipliers from which no force comes has been left in them: in a state whose factors are at hand, or in one without, such as
  // that which a step has started from.
  enum class Idle { none, at_factors, at_state };
  Idle idle_ = Idle::none;
  std::unique_ptr<ConstrainedMotion> forces_;  // of constraints, for those without
  bool predicted_ = false;      // not corrected yet in this loop, in a solution without misfit
  bool looks_at_next_ = false;  // at the next matrix
  bool contradiction_ = false;  // it has converged, and left too much open
  bool tried_harder_ = false, announced_ = false;
  LeftOutEquations left_out_;
  int steps_to_hold_ = 0;                // until their multipliers are found again
  int times_included_ = 0;               // again, since the start of the solution: where equations that were left out did not follow any more
  StepCount treated_since_ = 0;          // step
  bool begun_at_trial_ = false;          // treatment since a matrix of unknowns that Newton's method tried
  bool treatment_failed_ = false;        // within the step in which it was begun
  bool confirmed_ = false;               // redundancy at the start may be that of a singular position
  std::unique_ptr<LinearSolver> plain_;  // while a singular position is passed
  double measured_for_ = 0;              // row_scale() of the matrix that weights are for
  std::vector<double> misfit_;           // gaps that no motion closes, by equation; empty: none
};

}  // namespace dalembert
