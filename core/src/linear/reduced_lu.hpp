// A dense matrix without some of its unknowns and their rows: these unknowns are zero in solutions.
#pragma once

#include <memory>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

class ReducedLu final : public LinearSolver {
 public:
  // Ignores options.left_out.
  ReducedLu(int size, LinearSolverType type, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;
  LinearSolverStatistics statistics() const override { return solver_->statistics(); }

 private:
  int size_;
  std::vector<int> kept_;  // unknowns
  Pattern pattern_;
  std::vector<double> values_, x_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace dalembert
