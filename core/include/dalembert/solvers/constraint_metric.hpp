// The metric of constraint equations: their effect on the masses, and the units of their gaps.
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
  // All vectors have one entry per constraint equation. Equations of nodes (unit lengths) and definitions of algebraic
  // coordinates have no weight, because they are never redundant.
  std::vector<double> weights;              // D: one number for all forces of a mechanism, and one for its moments
  std::vector<double> units;                // unit of gaps: the size of the mechanism in m, or 1 for angles
  std::vector<CoordinateUnit> kinds;        // meter for forces, radian for moments
  std::vector<char> acting;                 // true if the equation acts on a coordinate
  std::vector<std::vector<Entry>> columns;  // M^-1/2 G^T of equations with a weight
  bool has_loops = false;  // false if each equation can be assigned a coordinate of its own, so that none is redundant

  // Largest gap relative to the units, for equations with a weight.
  double largest(std::span<const double> gaps) const;
};

double smallest_unit(const System& system);  // lower limit of the units of lengths

// Inertia in the metric: the masses, or for the geometry of constraints alone, 1 for translations and the squared size of
// the model for rotations.
enum class Inertia { masses, lengths };

// Metric at a state. `moment_length` is the ratio of the weights of forces and moments; 0 selects the size of the mechanism.
ConstraintMetric constraint_metric(System& system, const State& state, const Conditions& conditions,
                                   double moment_length = 0, Inertia inertia = Inertia::masses);

}  // namespace dalembert
