// Whether numbers are such that a solver may go on with them.
#pragma once

#include <span>

#include "dalembert/system/state.hpp"

namespace dalembert {

// Beyond every physical quantity, whatever its unit: the universe measures 1e62 Planck lengths. Squares of such numbers can still be added.
constexpr double unbounded = 1e100;

inline bool all_finite(std::span<const double> numbers) {
  double sum = 0;
  for (const double x : numbers) sum += 0 * x;
  return sum == 0;
}
inline bool all_finite(const State& s) {
  return all_finite(s.q) && all_finite(s.v) && all_finite(s.a) && all_finite(s.y) && all_finite(s.y_t) && all_finite(s.lambda) && all_finite(s.data);
}

}  // namespace dalembert
