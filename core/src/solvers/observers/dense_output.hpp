// What happens between the ends of a step.
#pragma once

#include <vector>

#include "dalembert/system/system.hpp"

namespace dalembert {

// Hermite polynomials through positions, velocities and accelerations at both ends of a step, of fifth order; without accelerations
// through positions and velocities alone, of third order. Rotations of Lie-group nodes are those from the start of the step, as vectors.
class StepInterpolation {
 public:
  // Both states must live until the next call. Tells whether accelerations at both ends, and rates of first-order coordinates at the
  // start, are those of the motion.
  void prepare(System& system, const State& start, const State& end, bool accelerations_known, bool rates_known);
  // At a time of the step. Multipliers are interpolated linearly, data are those of the end of the step.
  void evaluate(double time, State& state) const;

 private:
  struct Ends {
    std::vector<double> q, v, a;  // increments from the start, and their derivatives by the part of the step that is over
  };
  void turn_ends();
  void turn_back(const Ends& now, double h, State& state) const;

  System* system_ = nullptr;
  const State *start_ = nullptr, *end_ = nullptr;
  Ends first_, last_;
  std::vector<double> y0_, y1_;  // rates of ODE1 coordinates
  mutable Ends now_;             // at the time that is asked for
};

}  // namespace dalembert
