// Explicit time integration: Runge-Kutta methods, some with automatic step size, and the velocity Verlet method.
//
// Lie-group nodes follow Munthe-Kaas (1998) in the form of Holzinger and Gerstmayr (Multibody System Dynamics 53, 2021):
// stages add up in the Lie algebra and are composed with the start of the step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dalembert/solvers/constrained_motion.hpp"
#include "dalembert/solvers/mass_operator.hpp"
#include "dalembert/solvers/runge_kutta.hpp"
#include "dalembert/solvers/solver.hpp"
#include "dalembert/solvers/vibration.hpp"

namespace dalembert {

class ExplicitSolver : public Solver {
 public:
  std::string name() const override;
  bool controls_step_size() const override { return method_.controls_step_size(); }
  bool enforces_constraints() const override { return options_.eliminateConstraints; }
  const ConstraintSolver& constraint_solver() const override { return motion_.constraints(); }
  int method_order() const { return verlet_ ? 2 : method_.order; }
  int number_of_stages() const { return verlet_ ? 1 : method_.stages; }

  void read_settings() override;
  void pre_initialize() override;
  void initialize_data() override;
  void post_initialize() override;
  bool newton() override;  // one step of the method
  bool discontinuous_iteration() override;
  bool reduce_step_size() override;
  void free_memory() override;

 protected:
  void save_start_of_step() override;
  std::vector<double> restart_numbers() const override {
    return {growth_limit_, static_cast<double>(stiff_signs_), static_cast<double>(calm_signs_),
            static_cast<double>(warned_of_stiffness_)};
  }
  void forget() override;
  void pattern_revised() override { prepare_motion(); }
  void renew_accelerations() override;
  void examine_constraints_anew() override {
    motion_.examine_anew();
    rank_known_ = false;
  }
  void solve_as_regular() override { motion_.solve_as_regular(); }
  ConstrainedMotion* motion_under_constraints() override { return constrained_ ? &motion_ : nullptr; }
  KnownDerivatives complete_ends() override;
  void advise_on_growth() override;

 private:
  using Vector = std::vector<double>;

  void compute_step();
  void runge_kutta_step();
  void verlet_step();
  // ---- fused steps (one_pass_step.cpp)
  // -------------------------------------------------------------------------------
  void step_at_once();
  void keep_motion();
  void move_by_forces(std::span<const double> negative);
  bool move_by_masses(std::span<const double> negative);
  void compute_stage(int stage);
  // Stages with nonzero weight in a sum of derivatives.
  struct StageWeight {
    std::size_t stage;
    double weight;
  };
  using StageWeights = std::vector<StageWeight>;
  static StageWeights that_count(std::span<const double> weights);
  void move_from_start(const StageWeights& weights, Vector& q, Vector& v, Vector& y);
  // Derivative of the positions at a stage; the first stage uses the velocities at the start without a copy.
  const double* position_rates(std::size_t stage);
  void compute_stage_rates(int stage);
  // Converts derivatives of positions at a stage to the Lie algebra.
  void turn_stage_rates(std::size_t stage);
  void find_first_accelerations();
  // Computes the rates of ODE1 coordinates as well, if `y_t` is given.
  bool accelerations(Vector& a, std::span<double> y_t = {});
  bool divide_by_masses(Vector& a);
  bool masses_are_old() { return renewed_objects_ != system().renewed_objects(); }
  void rates(Vector& y_t);
  void eliminate(Vector& x) const;
  void find_eliminated_coordinates();
  bool mass_couples(const std::vector<int>& coordinates);
  void prepare_motion();
  bool prepare_factors();
  // ---- constraints other than fixed coordinates (explicit_constraints.cpp)
  // -------------------------------------------
  bool constrained_accelerations(Vector& a, std::span<double> y_t);
  bool back_onto_constraints();
  bool lose_constraints();
  void end_of_step();
  // ---- step-size control by the distance of two approximations ------------------------------------------------------
  bool control_step_size();
  double estimated_error();
  double distance_of(const StageWeights& approximation);
  double scaled_error(double second, double first, double old) const;
  void diagnose_error_control() override;
  void tell_of_switches();
  // ---- stiffness (explicit_stiffness.cpp) ------------------------------------------------------------------------------
  double eigenvalue_along_error();
  double stability_limit() const;
  bool at_stability_limit(double step_size);
  void look_for_stiffness(double step_size);
  // ---- failed steps ------------------------------------------------------------------------------------------------
  void begin_to_watch();
  bool stays_bounded() const;
  double size_at_start();
  bool outgrown();
  bool theory_explains_growth();
  bool lose_step();
  void diagnose_growth();
  bool find_bad_evaluation();
  bool is_good(const Vector& a, std::span<const double> y_t);
  const Vibration& fastest_at_start();
  Vibration fastest_with_constraints(const State& still);
  double amplification_of(const Vibration& vibration, double step_size) const;
  bool update_masses();
  void mass_failed(int row);
  void announce_mass_matrix();

  TimeIntegrationExplicitIntegrationSettings options_;
  bool reuses_masses_ = false, events_of_items_ = false;  // settings
  DynamicSolverType type_ = DynamicSolverType::ExplicitEuler;
  RungeKuttaMethod method_;
  std::vector<StageWeights> rows_;  // rows of the coefficients
  StageWeights result_, second_, third_;  // weights of the solution and of the approximations for comparison
  bool verlet_ = false, constant_mass_ = false;
  bool lie_ = false, all_on_group_ = false;  // there are rotations to be composed; all coordinates belong to such nodes
  std::uint64_t renewed_objects_ = 0;  // state of the objects for which the mass matrix was factorized
  // The end of a step is the first stage of the next one, if the system is not changed in between.
  bool nobody_interferes_ = false, end_known_ = false, first_stage_known_ = false;
  bool may_move_at_once_ = false;  // the method has one stage, and only its end is needed
  bool at_once_ = false;  // this step is fused
  bool sums_known_ = false;  // sums of squares after this step:
  double sum_of_v_ = 0, sum_of_a_ = 0;
  int stiff_signs_ = 0, calm_signs_ = 0;  // in the last steps
  bool warned_of_stiffness_ = false;
  bool watches_switches_ = false;  // switches of items affect error estimates
  double growth_limit_ = 0;  // limit for the sum of squares of velocities ...
  std::optional<Vibration> fastest_;  // at the start, computed on demand
  bool watches_coordinates_ = false;  // ... and of coordinates, if the user has set a limit
  bool searching_ = false;  // searches for the first evaluation that is not finite
  bool constrained_ = false, off_constraints_ = false;
  ConstrainedMotion motion_;
  MassOperator mass_;
  std::vector<int> eliminated_;
  // Derivatives at the stages; those of positions at the first stage are the velocities at the start of the step,
  // without a copy.
  std::vector<Vector> stage_q_, stage_v_, stage_y_;
  Vector second_q_, second_v_, second_y_;
  Vector end_a_, end_y_t_;
};

}  // namespace dalembert
