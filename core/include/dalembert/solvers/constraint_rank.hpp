// Which constraint equations depend on each other: for counts, texts and reports, never inside a step.
//
// The columns of M^-1/2 G^T, each divided by its length, are decomposed by a sparse QR factorization. A column of which the earlier ones leave less
// than a tolerance depends on them. The null space of G^T follows from the triangle, and everything else from the null space: how many equations
// follow from others, which items could lose some, and what no motion closes of gaps.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "dalembert/solvers/constraint_metric.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class ConstraintRank {
 public:
  struct Item {
    int object;
    std::string item;  // "object 3 'joint' (JointRevoluteZ)"
    int first, rows;   // equations, also those that are off
    int equations;     // that act
    int removable;     // so many of them follow from the equations of all other items
  };

  ConstraintRank() = default;  // nothing is known: no equation depends on others
  // At a state. Gaps leave a part of what vanishes where joints fit: they raise the tolerance.
  // `tolerance`: of squared remainders; 0: by the gaps.
  ConstraintRank(System& system, const State& state, const Conditions& conditions, const ConstraintMetric& metric, double tolerance = 0);

  int count() const { return static_cast<int>(dependent_.size()); }
  int equations_examined() const { return static_cast<int>(rows_.size()); }
  // The smallest squared remainder of an independent column, and whether it is far enough above the tolerance to be sure of the count.
  double weakest() const { return weakest_; }
  bool certain() const { return certain_; }
  bool allows_for_gaps() const { return allows_for_gaps_; }  // joints are so far apart that the tolerance is larger
  std::vector<Item> items(const System& system) const;
  std::vector<int> equations() const;                         // whose multipliers are not unique
  const std::vector<int>& dependent() const { return dependent_; }  // without which the others are independent
  // What no motion closes of these gaps.
  std::vector<double> misfit(std::span<const double> gaps) const;
  // By how much each item would be apart if all others were fulfilled: lines for a diagnosis.
  std::vector<std::string> contradictions(std::span<const double> misfit, const System& system) const;

 private:
  std::vector<int> rows_, dependent_;
  std::vector<double> roots_;       // of the metric, by rows_
  std::vector<CoordinateUnit> units_;
  std::vector<char> acting_;        // by equation
  std::vector<double> null_space_;  // of multipliers times roots_, by rows_: orthonormal columns, one after the other
  double weakest_ = 0;
  bool certain_ = true, allows_for_gaps_ = false;
};

}  // namespace dalembert
