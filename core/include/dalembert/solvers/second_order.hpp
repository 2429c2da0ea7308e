// Implicit time integration of second-order systems: generalized alpha, Newmark and the trapezoidal rule.
//
// The equations of motion, for coordinates q, velocities v, accelerations a and multipliers lambda, are
//
//   r(q, v, a, lambda, t) = M a + G^T lambda - f = 0,     g(q, t) = 0     (index 3), or   dg/dt = 0   (index 2).
//
// Algorithmic accelerations b approximate those at the time t + (alpha_m - alpha_f) h. A step of size h solves, for n + 1,
//
//   r(q, v, a, lambda, t)_{n+1} = 0,  g_{n+1} = 0
//   (1 - alpha_m) b_{n+1} + alpha_m b_n = (1 - alpha_f) a_{n+1} + alpha_f a_n
//   q_{n+1} = q_n + h v_n + h^2 ((1/2 - beta) b_n + beta b_{n+1})
//   v_{n+1} = v_n + h ((1 - gamma) b_n + gamma b_{n+1})
//
// with alpha_m = (2 rho - 1) / (rho + 1), alpha_f = rho / (rho + 1), gamma = 1/2 + alpha_f - alpha_m,
// beta = (gamma + 1/2)^2 / 4: second order, with the spectral radius rho at infinite frequency. Newmark's method has b = a and
// given beta, gamma; the trapezoidal rule beta = 1/4, gamma = 1/2. First-order coordinates y take y_{n+1} = y_n +
// h/2 (y'_n + y'_{n+1}). On Lie groups q_n + dq is the composition q_n o exp(dq).
//
// Newton's method changes q by dq, v by gamma' dq and a by beta' dq, where gamma' = gamma / (h beta) and
// beta' = (1 - alpha_m) / (h^2 beta (1 - alpha_f)), and solves
//
//   [ beta h^2 (K + gamma' D + beta' M)   G^T ] [ dq                 ]     [ beta h^2 r ]
//   [ G                                   0   ] [ beta h^2 dlambda   ] = - [ g          ]
//
// whose condition does not grow for small h (`row_scale` is beta h^2). The order of calls in a step:
//
//   save_start_of_step
//   compute_update(initial = true): predict         q, v for a_{n+1} = 0
//   compute_residual, compute_jacobian, linear solution, compute_update(false): correct      until convergence
//   finalize_newton                                 b_{n+1}
//
// A start with b = a has a transient of first order in multipliers and velocities; `start_steadily` avoids it.
//
// Chung, Hulbert: A time integration algorithm for structural dynamics with improved numerical dissipation, Journal of
//   Applied Mechanics 60 (1993).
// Arnold, Bruels: Convergence of the generalized-alpha scheme for constrained mechanical systems, Multibody System
//   Dynamics 18 (2007), algorithm 1, with the scaling of equations and multipliers given there.
// Holzinger, Arnold, Gerstmayr: Improving the accuracy of Newmark-based time integration methods for rigid bodies on Lie
//   groups (2022), for the kinematic relations of Lie-group nodes.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "dalembert/solvers/newton.hpp"

namespace dalembert {

class Trace;
class VelocityLead;

class SecondOrderSolver : public NewtonSolver {
 public:
  SecondOrderSolver();
  ~SecondOrderSolver() override;
  std::string name() const override { return "implicit second order time integration"; }

  void read_settings() override;
  void pre_initialize() override;
  void initialize_data() override;
  void initial_conditions() override;
  void post_initialize() override;
  bool keeps_positions() const override { return !conditions_.rate_level; }
  bool reduce_step_size() override;
  void increase_step_size() override;
  double compute_residual() override;
  void compute_update(bool initial) override;
  void compute_jacobian() override;
  void finalize_newton() override;
  bool discontinuous_iteration() override;
  bool controls_step_size() const override { return controls_step_size_; }
  void look_back() override;

  const std::vector<double>& algorithmic_accelerations() const { return algorithmic_; }
  const std::vector<double>& algorithmic_accelerations_at_start() const { return algorithmic_at_start_; }
  // Starts the next integration from the initial accelerations of the system and from these algorithmic ones, instead
  // of computing them.
  void continue_with(std::vector<double> algorithmic) { continued_ = std::move(algorithmic); }

  // Coefficients of the method.
  double newmark_beta = 0.25, newmark_gamma = 0.5, alpha_m = 0.5, alpha_f = 0.5, spectral_radius = 1;

 protected:
  void reset_to_start_of_step() override;
  void save_start_of_step() override;
  std::span<const double> restart_values() const override { return algorithmic_; }
  std::vector<double> restart_numbers() const override;
  void forget() override;
  KnownDerivatives complete_ends() override {
    return {it.currentStepIndex > 1 || options_.computeInitialAccelerations, it.currentStepIndex > 1};
  }
  void renew_accelerations() override;
  void begin_with_accelerations();
  bool end_rates(ConstrainedMotion& motion);
  bool may_start_steadily() const;
  void start_steadily();
  void start_steadily_in_step();
  void lean(ConstrainedMotion& motion);
  bool was_cut() const;
  // Coefficient of the local error of positions: times the third power of the step size and the rate of accelerations.
  double left_out() const;

 private:
  friend class Lockstep;
  friend class VelocityLead;
  // ---- steps together with solvers of the same model (lockstep/lockstep.hpp) ---------------------------------------
  std::string_view lockstep_obstacle() const;  // reason against solving side by side; empty if there is none
  // Stores the residual with its norm, and the Jacobian, in two parts, for the vectors q, v, a and lambda of the state.
  void trace(Trace& trace);

  // ---- step-size control (implicit_error_control.cpp) ---------------------------------------------------------------
  bool control_step_size();
  double estimated_error();
  double noise_of_estimates();  // in units of the tolerances
  bool give_up_at_round_off();
  double change_of_accelerations(std::size_t i, double step_size) const;
  void end_swings();

  // Computes accelerations and multipliers of the state; returns false, with a warning, if there are none. The motion
  // has its factors at this state, unless an unknown has no pivot.
  bool find_accelerations();
  bool find_accelerations(ConstrainedMotion& motion, int singular);
  bool newmark() const { return options_.useNewmark; }
  double rate_factor() const final { return gamma_prime(); }
  double metric_scale() final { return 1 / (row_scale() * beta_prime()); }
  double row_scale() const final;  // factor of the ODE2 equations in Newton's method
  double beta_prime() const;  // acceleration per increment of a coordinate
  double gamma_prime() const;  // velocity per increment of a coordinate
  void change_step_size();
  void move_algorithmic_accelerations(double ratio);
  void find_velocities_off_constraints();
  void predict();
  void correct();
  void predict_lie_rotations();
  void correct_lie_rotations();
  void evaluate_jacobian(const State& state, const Conditions& conditions, const Weights& weights);
  void simplified_lie_jacobian(const State& state, const Conditions& conditions, const Weights& weights);
  void apply_tangent_operator();
  Weights jacobian_weights() const;
  // `momentary` includes present reactions and inertia forces.
  Conditions jacobian_conditions(bool momentary) const;
  template <class S>
  S scale_residual(std::vector<S>& residual) const;  // returns the norm for the tolerances
  template <class S>
  void scale_jacobian(std::vector<S>& values) const;

  TimeIntegrationGeneralizedAlphaSettings options_;
  bool controls_step_size_ = false;  // setting
  std::vector<double> algorithmic_, algorithmic_at_start_, continued_;
  std::vector<double> lie_increment_;  // sum of increments since the start of the step (simplified relations)
  std::vector<double> increment_of_q_, previous_q_, more_values_;
  bool lie_ = false, simplified_lie_ = false;
  // Step sizes for which algorithmic accelerations, and velocities off constraints, are valid; zero: any size.
  // `begins`: both are unset, and the next step is the first one of a smooth motion, with any size.
  struct StepSizes {
    double accelerations = 0, velocities = 0;
    bool begins = false;
  };
  StepSizes belong_to_, belong_to_at_start_;
  std::vector<double> off_constraints_;  // part of the velocities at the start of a step ...
  StepCount off_constraints_known_ = -1;  // ... which has this index
  bool renews_ = false;  // accelerations are computed anew before the step is repeated
  StepCount renewed_after_ = -2;  // index of a step
  std::unique_ptr<VelocityLead> lead_;
};

// Accelerations and multipliers of given positions and velocities.
struct InitialAccelerations {
  std::vector<double> a, lambda;
  bool decided = true;  // see ConstrainedMotion::follow_motion
};
// Requires factors of `motion` at these positions.
InitialAccelerations initial_accelerations(ConstrainedMotion& motion, System& system, const State& state,
                                           const Conditions& conditions);

}  // namespace dalembert
