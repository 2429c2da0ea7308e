// Velocities normal to the constraints in equal steps of generalized alpha.
//
// The method determines positions by the constraints, and these velocities by a recursion that oscillates, and may grow,
// where constraints turn quickly. Once oscillations are found, each step replaces these velocities by their smooth value,
// the lead -C h^2 G da/dt, for which the reactions of the next step are of second order
// (docs/theory/constrained_steps.rst). An object serves one solution.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "control/solver_part.hpp"
#include "dalembert/solvers/second_order.hpp"

namespace dalembert {

class VelocityLead : public SolverPart {
 public:
  static constexpr std::size_t restart_size = 8;
  explicit VelocityLead(SecondOrderSolver& method);

  void forget();  // all data that are not in a restart file
  bool active() const { return active_; }
  bool watches() const { return sizes_.ae > 0 && !conditions_.rate_level && !it.automaticStepSize; }
  void watch();  // called after each step of equal size
  bool accelerations_alternate();
  bool closes_gaps_of_start();
  std::vector<std::string> doubts() const;

  // Replaces the velocities normal to the constraints by the lead for a next step of size `next`, or by zero if accelerations
  // have jumped. Returns the square of the change in the norm of the step matrix.
  double apply(double step_size, double next, bool smooth);
  std::vector<double> rates_at(const State& state);
  // The velocities with these constraint rates and the smallest norm in the step matrix, by its last factors.
  std::span<const double> move_across(std::span<const double> rates);
  // Constraint equations that are prescribed in time, and those that constrain velocities.
  struct RowKinds {
    std::vector<char> driven, of_velocities;
  };
  const RowKinds& row_kinds();

  std::vector<double> restart_numbers() const;
  void resume(const std::array<double, restart_size>& numbers);

 private:
  bool velocities_oscillate();
  void lead_and_judge();
  void count_doubt(StepCount& steps, double& since) const;
  std::vector<double> velocities_across(double step_size, bool as_driven);
  std::vector<double> rates_with_lead(double factor, std::span<const double> change);
  // Returns false if the linear solver has been replaced since the last factorization, because constraints were
  // examined anew.
  bool has_factors() const { return method_.linear_->statistics().factorizations > 0; }
  double step_energy(std::span<const double> v) const;

  SecondOrderSolver& method_;
  RowKinds row_kinds_;  // empty: unknown
  bool active_ = false;  // from the first step on in which velocities oscillate
  double largest_speed_ = 0;  // so far
  double largest_energy_ = 0;  // since the lead is used
  StepCount steps_with_lead_ = 0;
  StepCount coarse_ = 0, not_led_ = 0;  // steps with a warning, and the time of the first one
  double coarse_since_ = 0, not_led_since_ = 0;
  std::optional<bool> begins_open_;  // initial values contradict the constraints
  double step_size_ = 0;  // of the last steps
  double negligible_speed_ = 0;  // for this size
  int equal_steps_ = 0;  // in succession
  int steps_to_wait_ = 0;  // until velocities across constraints are evaluated again
  std::vector<double> accelerations_, change_;  // algorithmic ones at the end of the last step, and their change in it
  std::vector<double> across_;  // velocities across constraints in the last step; empty: unknown
  std::uint64_t constraints_renewed_ = 0;
};

}  // namespace dalembert
