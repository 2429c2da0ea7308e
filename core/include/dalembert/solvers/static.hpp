// Static equilibrium by Newton's method under a load that grows in steps.
#pragma once

#include <vector>

#include "dalembert/solvers/newton.hpp"

namespace dalembert {

class StaticSolver : public NewtonSolver {
 public:
  bool is_static() const override { return true; }
  std::string name() const override { return "nonlinear static solver"; }
  double load_factor() const override;

  void pre_initialize() override;
  void initial_conditions() override;
  void update_current_time() override;
  bool reduce_step_size() override;
  void increase_step_size() override;
  double compute_residual() override;
  void compute_update(bool initial) override;
  void compute_jacobian() override;
  double geometric_factor() const { return geometric_factor_; }  // of consecutive loads, with loadStepGeometric

 protected:
  int recovery_steps() const override { return settings().staticSolver.adaptiveStepRecoverySteps; }
  int recovery_iterations() const override { return settings().staticSolver.adaptiveStepRecoveryIterations; }

 private:
  double stabilizer() const;
  void compute_mass_matrix();
  void turn_multipliers();

  double geometric_factor_ = 1;
  std::vector<double> mass_;
};

}  // namespace dalembert
