// The metric of constraint equations: how strongly they act on the masses, and what counts as one in their gaps.
#pragma once

#include <span>
#include <vector>

#include "dalembert/math/dual.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

struct ConstraintMetric {
  struct Entry {
    int row;
    double value;
  };
  // By constraint equation. Equations of nodes (unit lengths), and those that define an algebraic coordinate, have no weight: they never depend on
  // others.
  std::vector<double> weights;             // D: one number for all forces of a mechanism, and one for its moments
  std::vector<double> units;               // of gaps: the size of the mechanism in m; 1 for angles
  std::vector<CoordinateUnit> kinds;       // meter: a force, radian: a moment
  std::vector<char> acting;                // the equation acts on a coordinate
  std::vector<std::vector<Entry>> columns; // M^-1/2 G^T of equations with a weight
  bool has_loops = false;                  // equations may depend on others: not each has a coordinate that no other acts on

  // The largest gap relative to the units, of equations with a weight.
  double largest(std::span<const double> gaps) const;
};

double smallest_unit(const System& system);  // no unit of a length is smaller

// Inertia in the metric: the masses, or for the geometry of constraints alone, 1 for translations and the squared size of
// the model for rotations.
enum class Inertia { masses, lengths };

// Metric at a state. `moment_length` is the ratio of the weights of forces and moments; 0 selects the size of the mechanism.
ConstraintMetric constraint_metric(System& system, const State& state, const Conditions& conditions, double moment_length = 0,
                                   Inertia inertia = Inertia::masses);

}  // namespace dalembert
