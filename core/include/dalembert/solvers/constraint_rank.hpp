// The rank of the constraint Jacobian, for counts, messages and reports. Steps do not use it.
//
// The columns of M^-1/2 G^T, each divided by its length, are factorized (`OrthogonalFactors`). A column is redundant if its
// remainder after projection onto earlier columns is below a tolerance. The factors give the null space of G^T, which
// determines the items that could lose equations, and the misfit: the part of gaps that no motion can close. Large null
// spaces are represented by a few random vectors. These have the same nonzero entries, and the same rank in the rows of one
// item.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "dalembert/solvers/constraint_metric.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

class OrthogonalFactors;

class ConstraintRank {
 public:
  struct Item {
    int object;
    std::string item;  // "object 3 'joint' (JointRevoluteZ)"
    int first, rows;  // range of equations, including inactive ones
    int equations;  // number of active equations
    int removable;  // number of equations that follow from those of all other items
  };

  ConstraintRank() = default;  // full rank
  // Rank at a state. `tolerance` is the limit of squared remainders; 0 selects it by the gaps, which change remainders.
  ConstraintRank(System& system, const State& state, const Conditions& conditions, const ConstraintMetric& metric,
                 double tolerance = 0);

  int count() const { return static_cast<int>(dependent_.size()); }
  int equations_examined() const { return static_cast<int>(rows_.size()); }
  // Smallest squared remainder of an independent column. The count is certain if it is far above the tolerance.
  double weakest() const { return weakest_; }
  // Smallest squared remainder in units of the constraint metric. It is small where masses differ by orders of magnitude.
  double strength() const { return strength_; }
  bool certain() const { return certain_; }
  bool allows_for_gaps() const { return allows_for_gaps_; }  // gaps have increased the tolerance
  std::vector<Item> items(const System& system) const;
  std::vector<int> equations() const;  // equations with non-unique multipliers
  // Redundant equations: all others are independent.
  const std::vector<int>& dependent() const { return dependent_; }
  // Part of the gaps that no motion can close. Zero if the null space is represented by random vectors.
  std::vector<double> misfit(std::span<const double> gaps) const;
  // One line per item for a diagnosis: the gap of the item if all other constraints were fulfilled.
  std::vector<std::string> contradictions(std::span<const double> misfit, const System& system) const;

 private:
  const std::vector<double>& null_space() const;
  std::vector<double> null_vectors(std::size_t most) const;
  std::size_t samples() const;  // number of random vectors that represent a large null space

  std::vector<int> rows_, dependent_;
  std::vector<double> roots_;  // square roots of the metric, by rows_
  std::vector<CoordinateUnit> units_;
  std::vector<char> acting_;  // true if the equation acts on a coordinate
  std::vector<double> lengths_;  // of columns, by rows_
  int largest_item_ = 0;  // largest number of equations of an item
  std::shared_ptr<const OrthogonalFactors> factors_;
  // Orthonormal vectors, in multipliers times roots_, one after the other.
  mutable std::vector<double> null_space_;
  mutable bool whole_null_space_ = true;
  double weakest_ = 0, strength_ = 1;
  bool certain_ = true, allows_for_gaps_ = false;
};

}  // namespace dalembert
