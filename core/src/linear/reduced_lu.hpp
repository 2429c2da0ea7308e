// A matrix without some of its unknowns and their rows: in solutions, these unknowns are zero.
#pragma once

#include <memory>
#include <vector>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

class ReducedLu final : public LinearSolver {
 public:
  // Without options.left_out.
  ReducedLu(const Pattern& whole, LinearSolverType type, LinearSolverOptions options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;
  LinearSolverStatistics statistics() const override { return solver_->statistics(); }

 private:
  // Values that follow each other in both patterns.
  struct Run {
    std::size_t from;
    int length;
  };
  Pattern reduce(const Pattern& whole);

  std::vector<int> kept_;  // unknowns
  std::vector<Run> runs_;
  Pattern pattern_;
  std::vector<double> values_, x_;
  std::unique_ptr<LinearSolver> solver_;
};

}  // namespace dalembert
