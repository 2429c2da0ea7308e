#pragma once

#include <cmath>

namespace dalembert {

// x_tt + damping x_t + frequency^2 x = 0
struct Vibration {
  double frequency = 0;  // rad/s
  double damping = 0;    // 1/s
  int coordinate = -1;   // the coordinate with the largest amplitude

  bool creeps() const { return damping > 2 * frequency; }
  // Returns the magnitude of the largest root of s^2 + damping s + frequency^2, in 1/s; 0: there is no vibration.
  double rate() const {
    const double half = 0.5 * damping;
    return creeps() ? half + std::sqrt(half * half - frequency * frequency) : frequency;
  }
};

}  // namespace dalembert
