// Constraints that a state does not fulfil.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "dalembert/system/system.hpp"

namespace dalembert {

struct OpenConstraint {
  int row = -1;          // of the AE vector
  bool of_rate = false;  // the velocities contradict the constraint
  double gap = 0;        // or its rate
  double excess = 0;     // in multiples of what is tolerated
  CoordinateUnit unit = CoordinateUnit::unknown;

  std::string text(const System& system) const;  // "object 3 'joint' (JointRevoluteZ), equation 2: gap 0.05 m"
};

struct GapTolerances {
  double position = 0;  // relative to the extent of the model; of angles: in rad
  double velocity = 0;  // relative to the velocities that meet in a constraint
  bool rates = true;    // whether rates are looked at
};

// The worst first. Multipliers do not count. Costs two evaluations as long as all constraints are fulfilled.
std::vector<OpenConstraint> open_constraints(System& system, const State& state, const Conditions& conditions,
                                             const GapTolerances& tolerances);

// What is known of constraint equations besides their gaps, by AE number.
struct ConstraintRates {
  std::vector<double> rates;             // where user functions prescribe gaps in time: by differences of the gaps
  std::vector<double> speeds;            // sums of the magnitudes of the velocities that meet in each of them
  std::vector<char> of_velocities;       // those that constrain velocities already
  std::vector<CoordinateUnit> units;     // of the gaps
};
// User functions are asked a little later, up to the latest time, and near it a little before.
ConstraintRates constraint_rates(System& system, const State& state, const Conditions& conditions, double latest = std::numeric_limits<double>::infinity());

}  // namespace dalembert
