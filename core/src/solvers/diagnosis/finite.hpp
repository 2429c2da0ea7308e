// Whether numbers are such that a solver may go on with them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "dalembert/system/state.hpp"

namespace dalembert {

// Beyond every physical quantity, whatever its unit: the universe measures 1e62 Planck lengths. Squares of such numbers can still be added.
constexpr double unbounded = 1e100;

inline bool all_finite(std::span<const double> numbers) {
  constexpr std::size_t lanes = 8;  // sums beside each other: one alone would wait for itself
  std::array<double, lanes> sums{};
  const std::size_t whole = numbers.size() / lanes * lanes;
  for (std::size_t i = 0; i < whole; i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) sums[lane] += 0 * numbers[i + lane];
  for (std::size_t i = whole; i < numbers.size(); ++i) sums[0] += 0 * numbers[i];
  return std::ranges::all_of(sums, [](double sum) { return sum == 0; });
}
inline bool all_finite(const State& s) {
  return all_finite(s.q) && all_finite(s.v) && all_finite(s.a) && all_finite(s.y) && all_finite(s.y_t) && all_finite(s.lambda) && all_finite(s.data);
}

}  // namespace dalembert
