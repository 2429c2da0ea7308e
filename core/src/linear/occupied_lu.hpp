// A sparse matrix whose pattern is for the most part zeros, as a mass matrix on the pattern of a tangent: what is not zero is
// analysed and factorized alone. Should another entry become nonzero, the whole pattern is taken.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "multifrontal_lu.hpp"

namespace dalembert {

class OccupiedLu final : public LinearSolver {
 public:
  OccupiedLu(const Pattern& pattern, const LinearSolverOptions& options)
      : pattern_(pattern), options_(options), solver_(std::make_unique<MultifrontalLu>(pattern, options)) {}
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override { solver_->solve(x); }
  LinearSolverStatistics statistics() const override;

 private:
  bool mostly_zeros(std::span<const double> values) const;
  void select(std::span<const double> values);
  bool gather(std::span<const double> values);
  void take_whole_pattern();

  const Pattern& pattern_;
  LinearSolverOptions options_;
  bool chosen_ = false;
  std::optional<Pattern> occupied_;
  std::vector<int> slots_, zeros_;  // in the whole pattern: of the occupied entries, and the others
  std::vector<double> gathered_;
  std::unique_ptr<MultifrontalLu> solver_;
  LinearSolverStatistics earlier_;  // of the solver of what was occupied
};

}  // namespace dalembert
