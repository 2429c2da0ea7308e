// Constraint equations that follow from others and have no part in the system matrix: factors cost what those of a mechanism without these equations
// do. They are fulfilled with the others, as residuals tell, and their multipliers may be any: those that all multipliers were smallest with not long
// ago leave little to take off where somebody looks.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "dalembert/linear/linear_solver.hpp"

namespace dalembert {

// Equations of which some follow from the others.
struct DependentEquations {
  std::vector<int> all, dependent;
};

class LeftOutEquations {
 public:
  LeftOutEquations() = default;  // none
  // `weights`: of the squares of multipliers, by equation; zero for those that multipliers of others may change.
  LeftOutEquations(const std::vector<DependentEquations>& parts, std::span<const double> weights, int first_ae);
  bool empty() const { return equations_.empty(); }
  LinearSolverOptions options(LinearSolverOptions options) const;

  void hold(std::span<const double> multipliers);
  void put_held(std::span<double> multipliers) const {
    for (std::size_t i = 0; i < held_.size(); ++i) multipliers[static_cast<std::size_t>(equations_[i])] = held_[i];
  }
  // Makes multipliers the smallest ones that exert the same forces, by factors with these options of this matrix. False: not all of what is left
  // out follows from others there.
  bool make_smallest(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors, std::span<double> multipliers);
  // That `make_smallest` takes.
  int solutions() const { return static_cast<int>(groups_.size()); }
  // Of which others are better left out: their multipliers have outgrown those of some that are, when all were made smallest last. None: these are good.
  std::vector<DependentEquations> better() const;

 private:
  struct Term {
    int equation;
    double factor;
  };
  // Multipliers from which no force comes. The first is that of an equation that is left out.
  using Combination = std::vector<Term>;
  // Combinations that have equations in common, and these, which have weights.
  struct Cluster {
    std::vector<int> combinations, equations;
  };

  bool renew(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors);
  bool find(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors);
  void improve(const Pattern& pattern, std::span<const double> matrix, LinearSolver& factors);
  double rest_of_forces(const Combination& combination, const Pattern& pattern, std::span<const double> matrix);
  void add_equations_without_weight(const Pattern& pattern, std::span<const double> matrix);
  void allow_all_equations();
  void drop_small_terms();
  void find_groups();
  void find_clusters();
  std::vector<std::vector<int>> users() const;
  Eigen::MatrixXd weighed(const Cluster& cluster) const;
  double root(int equation) const { return roots_[static_cast<std::size_t>(equation)]; }
  double weighed(const Term& term) const { return root(term.equation) * term.factor; }
  Combination& combination(int i) { return combinations_[static_cast<std::size_t>(i)]; }
  const Combination& combination(int i) const { return combinations_[static_cast<std::size_t>(i)]; }

  std::vector<int> equations_;
  std::vector<double> held_;  // multipliers
  std::vector<double> roots_;
  int first_ae_ = 0;
  std::vector<Combination> combinations_;  // by equation that is left out
  std::vector<std::vector<int>> groups_;   // of those without equations in common: one solution finds all of a group
  std::vector<Cluster> clusters_;
  std::vector<double> x_, sizes_;
  std::vector<std::size_t> touched_;  // coordinates
};

}  // namespace dalembert
