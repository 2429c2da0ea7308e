// Dense output: interpolation within a step.
#pragma once

#include <vector>

#include "dalembert/system/system.hpp"

namespace dalembert {

// Hermite interpolation of a step: of fifth order through positions, velocities and accelerations at both ends, or of
// third order without accelerations. Rotations of Lie-group nodes are interpolated as rotation vectors relative to the
// start of the step.
class StepInterpolation {
 public:
  // Both states must exist until the next call. The flags state whether accelerations at both ends, and rates of first-
  // order coordinates at the start, are those of the motion.
  void prepare(System& system, const State& start, const State& end, bool accelerations_known, bool rates_known);
  // Interpolates at a time within the step: multipliers linearly; data are the values at the end of the step.
  void evaluate(double time, State& state) const;

 private:
  struct Ends {
    std::vector<double> q, v, a;  // increments since the start, and their derivatives by the part of the step
  };
  void turn_ends();
  void turn_back(const Ends& now, double h, State& state) const;

  System* system_ = nullptr;
  const State *start_ = nullptr, *end_ = nullptr;
  Ends first_, last_;
  std::vector<double> y0_, y1_;  // rates of ODE1 coordinates
  mutable Ends now_;             // at the requested time
};

}  // namespace dalembert
