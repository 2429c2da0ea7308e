// Combinations of constraint equations that vanish, found within loops.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "constraints/constraint_blocks.hpp"

namespace dalembert {

// What blocks are made of: entries of the columns of the multipliers, what these are multiplied by for each coordinate, by equation their metric (zero:
// it is not looked at) and whether they are multipliers of constraints of motions.
struct ConstraintEquations {
  const Pattern& pattern;
  std::span<const double> values, scales;
  int first_ae;
  std::span<const int> nodes, rows;  // of ODE2 coordinates; the equations that are looked at
  std::span<const double> weights;
  std::span<const char> multipliers;
  double vanishing;  // the square of what is left of a combination that does, where entries are one
};

// One orthonormal basis per block, in sqrt(D) lambda, by the entries of its equations alone: however weak constraints of other loops are, they
// have no part in it. Empty: blocks are too large, or not independent of each other, or an equation is neither dependent nor clearly independent.
std::vector<Eigen::MatrixXd> local_combinations(const ConstraintEquations& all, const std::vector<ConstraintBlock>& blocks);

}  // namespace dalembert
