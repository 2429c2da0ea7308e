// Solvers that find the state at the end of a step by Newton's method, full or modified.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"
#include "dalembert/solvers/solver.hpp"

namespace dalembert {

class NewtonSolver : public Solver {
 public:
  void initialize_data() override;
  bool newton() override;

  // Residual of the current state; returns the number that is compared with the tolerances.
  virtual double compute_residual() = 0;
  // Moves the current state by the increment; `initial`: to the prediction at the start of a step.
  virtual void compute_update(bool initial) = 0;
  // Values of the system matrix for the current state.
  virtual void compute_jacobian() = 0;

  std::span<double> residual() { return residual_; }
  std::span<double> increment() { return increment_; }
  std::span<double> jacobian_values() { return jacobian_; }
  const Pattern& pattern() const { return *pattern_; }

 protected:
  // Adds what the user's system Jacobian function gives.
  void add_user_jacobian(double q, double v, double y);
  double norm_of_residual() const;
  // Make the factors of the matrix in `jacobian_`; false, with the flags set, if it is singular.
  bool factorize();

  const Pattern* pattern_ = nullptr;
  std::unique_ptr<LinearSolver> linear_;
  std::vector<double> residual_, increment_, jacobian_;
  bool full_newton_ = true;  // a new Jacobian in every iteration

 private:
  struct Loop;
  void start(Loop& loop);
  void iterate(Loop& loop);
  bool check_convergence(Loop& loop);
  bool stagnated(const Loop& loop) const;
  void treat_slow_convergence(Loop& loop);
  void restart(Loop& loop);
  bool diverged();
  double evaluate_residual();
  double relative_increment();
  double round_off_level();
  void report_failure(const Loop& loop);
  // Refuses entries of the user's Jacobian that the system matrix has no place for.
  void check_entry(const MatrixEntry& entry) const;
};

}  // namespace dalembert
