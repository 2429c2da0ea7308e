// Diagonally implicit Runge-Kutta methods with error control, for stiff systems. All stages have one matrix, which is
// reused in further steps.
//
//   M(q) a + f(q, v, t) + G^T lambda = 0    with  v = V + gamma h a,  q = Q + gamma h v    at each stage
//   G a + (G v)_q v + ... = 0               (second derivative of the constraints)
//
// Steps end with a projection onto the constraints of positions and velocities. The method is that of Kennedy,
// Carpenter: Additive Runge-Kutta schemes for convection-diffusion-reaction equations, Applied Numerical Mathematics 44
// (2003): stiffly accurate, L-stable, all stages within the step.
#pragma once

#include <array>
#include <vector>

#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

class DiagonallyImplicitSolver : public Solver {
 public:
  std::string name() const override { return "diagonally implicit time integration (ESDIRK43)"; }
  bool controls_step_size() const override { return true; }
  const ConstraintSolver& constraint_solver() const override { return motion_.constraints(); }
  int method_order() const { return 4; }
  int number_of_stages() const { return stages; }

  void initialize_data() override;
  void post_initialize() override;
  bool newton() override;  // one step of the method
  bool discontinuous_iteration() override;
  bool reduce_step_size() override;
  void free_memory() override;

 protected:
  void save_start_of_step() override;
  std::vector<double> restart_numbers() const override { return {misfit_at_end_, static_cast<double>(after_jump_)}; }
  void forget() override;
  void pattern_revised() override;
  void renew_accelerations() override {
    find_accelerations();
    after_jump_ = true;
  }
  void solve_as_regular() override;
  ConstrainedMotion* motion_under_constraints() override;
  void examine_constraints_anew() override {
    motion_.examine_anew();
    rank_known_ = false;
    masses_.examine_anew();
  }
  KnownDerivatives complete_ends() override { return {true, true}; }
  const std::vector<double>* minimum_norm_multipliers() override;

 private:
  using Vector = std::vector<double>;
  static constexpr int stages = 6;

  // Results of Newton's method.
  enum class Outcome { solved, slow, lost, singular };

  void require_no_algebraic_coordinates() const;
  void prepare_factors();
  void find_accelerations();
  bool find_accelerations_without_masses();
  double misfit_of_accelerations();
  void accelerations_that_fit();
  // ---- stages --------------------------------------------------------------------------------------------------------
  double diagonal() const;  // gamma h
  bool solve_stages();
  Outcome solve_stage(int stage);
  Outcome iterate(int stage, int most_iterations);
  void begin_stage(int stage);
  void predict(int stage);
  void follow_rates();  // computes positions and velocities from accelerations
  void turn_rotations();
  void evaluate_residual();
  double increment_size() const;
  bool at_round_off() const;
  void keep_rates(int stage);
  bool factorize(bool constraints_follow_motion = false);
  bool factors_serve() const;
  // ---- ends of steps -----------------------------------------------------------------------------------------------
  double estimated_error();
  void filter(Vector& error_of_q, Vector& error_of_v, Vector& error_of_y);
  bool back_onto_constraints();
  bool leave_open_gaps();
  bool fail(Outcome outcome);
  // ---- step-size control -------------------------------------------------------------------------------------------
  bool control_step_size();
  double weight(double value, double before) const;

  ConstrainedMotion motion_, masses_;  // of the stages, and for accelerations at the start
  // Minimum-norm multipliers of the state with these coordinates and multipliers.
  struct Smallest {
    ConstrainedMotion motion;
    bool ready = false;
    Vector q, lambda, reported;
  } smallest_;
  bool masses_ready_ = false, warned_of_masses_ = false;
  bool lie_ = false, interferes_ = false, fresh_ = false;
  bool after_jump_ = false;  // true at the start, and after events
  double factorized_for_ = 0;  // gamma h of the factors; zero if there are none
  double rate_ = 1;  // contraction of the error per iteration
  int unassessed_stages_ = 0;  // number of stages with one iteration since the last estimate
  double slowest_ = 0;  // the largest one of the last step
  // Residuals of accelerations, which reveal changes of the system between steps.
  double misfit_at_end_ = 0, misfit_at_start_ = 0;
  std::array<Vector, stages> stage_q_, stage_v_, stage_y_, stage_lambda_;  // derivatives at the stages, and multipliers
  Vector base_q_, base_v_, base_y_, base_turn_, turn_, x_;
};

}  // namespace dalembert
