// Checks for finite numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "dalembert/system/state.hpp"

namespace dalembert {

// A bound above all physical quantities, independent of units: the universe measures 1e62 Planck lengths. The sum of
// squares of such numbers does not overflow.
constexpr double unbounded = 1e100;

inline bool all_finite(std::span<const double> numbers) {
  constexpr std::size_t lanes = 8;  // independent partial sums, which hide the latency of additions
  std::array<double, lanes> sums{};
  const std::size_t whole = numbers.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += 0 * numbers[i + lane];
  for (std::size_t i = whole; i < numbers.size(); ++i) sums[0] += 0 * numbers[i];
  return std::ranges::all_of(sums, [](double sum) { return sum == 0; });
}
inline bool all_finite(const State& s) {
  return all_finite(s.q) && all_finite(s.v) && all_finite(s.a) && all_finite(s.y) && all_finite(s.y_t) &&
         all_finite(s.lambda) && all_finite(s.data);
}

}  // namespace dalembert
