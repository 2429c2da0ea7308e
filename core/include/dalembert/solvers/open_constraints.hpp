// Constraints that a state violates.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "dalembert/system/system.hpp"

namespace dalembert {

struct OpenConstraint {
  int row = -1;          // index of the equation
  bool of_rate = false;  // true if the velocities violate the constraint
  double gap = 0;        // gap, or its rate
  double excess = 0;     // gap divided by the tolerance
  CoordinateUnit unit = CoordinateUnit::unknown;

  std::string text(const System& system) const;  // "object 3 'joint' (JointRevoluteZ), equation 2: gap 0.05 m"
};

struct GapTolerances {
  double position = 0;  // relative to the extent of the model, or in rad
  double velocity = 0;  // relative to the sum of velocities in a constraint
  bool rates = true;    // whether rates are checked
};

// Violated constraints, the worst one first. Takes two evaluations if all constraints are fulfilled.
std::vector<OpenConstraint> open_constraints(System& system, const State& state, const Conditions& conditions,
                                             const GapTolerances& tolerances);

// Rates of constraint equations, by equation.
struct ConstraintRates {
  std::vector<double> rates;          // by differences of the gaps if user functions prescribe them
  std::vector<double> speeds;         // sums of the magnitudes of all velocities in an equation
  std::vector<char> of_velocities;    // true for velocity constraints
  std::vector<CoordinateUnit> units;  // units of the gaps
};
// User functions are evaluated slightly later than the state, or earlier close to the latest time.
ConstraintRates constraint_rates(System& system, const State& state, const Conditions& conditions,
                                 double latest = std::numeric_limits<double>::infinity());
// Its `rates` alone, without derivatives; `of_velocities` is that of an earlier state.
std::vector<double> rates_of_gaps(System& system, const State& state, const Conditions& conditions, double latest,
                                  std::span<const char> of_velocities);

// Equations whose gaps user functions move in time between `start` and this state, with rates that are always zero.
std::vector<int> equations_without_rates(System& system, const State& state, const Conditions& conditions,
                                         double start);

// "2 constraint equations:", and a line for each of the first ones.
std::string listed(const std::vector<OpenConstraint>& open, const System& system);

}  // namespace dalembert
