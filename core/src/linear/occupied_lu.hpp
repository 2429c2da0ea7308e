// A sparse matrix with a mostly zero pattern, such as a mass matrix on the pattern of a tangent: only nonzero entries
// are analysed and factorized, and unknowns without neighbours are divided by their diagonal entries. If another
// entry becomes nonzero, the whole pattern is used, as for the first matrices if these may differ from later ones.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "multifrontal_lu.hpp"

namespace dalembert {

class OccupiedLu final : public LinearSolver {
 public:
  OccupiedLu(const Pattern& pattern, const LinearSolverOptions& options);
  int factorize(std::span<const double> values) override;
  void solve(std::span<double> x) override;
  LinearSolverStatistics statistics() const override;
  // As MultifrontalLu has them.
  std::optional<int> negative_eigenvalues(std::span<const double> values) const;

 private:
  // An unknown without neighbours.
  struct Lone {
    int unknown, slot;
    double inverse;
  };
  bool mostly_zeros(std::span<const double> values) const;
  void take(const std::vector<char>& occupied);
  std::vector<char> occupied_slots(std::span<const double> values) const;
  void find_neighbours(const std::vector<char>& occupied);
  int factorize_occupied(std::span<const double> values);
  void take_whole_pattern();
  void count_as_earlier();

  const Pattern& pattern_;
  LinearSolverOptions options_;
  int unsettled_;
  bool chosen_ = false;
  std::optional<Pattern> occupied_;  // pattern of the unknowns with neighbours
  std::vector<Lone> lone_;
  std::vector<int> coupled_;  // unknowns with neighbours
  std::vector<int> zeros_;    // slots in the whole pattern that must stay zero
  std::unique_ptr<MultifrontalLu> solver_;
  LinearSolverStatistics earlier_;  // statistics of previous solvers
};

}  // namespace dalembert
