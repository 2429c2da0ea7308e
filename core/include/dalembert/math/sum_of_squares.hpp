#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// Eight sums that do not wait for each other, in an order that depends on the size alone.
template <class S>
S sum_of_squares(std::span<const S> x) {
  std::array<S, 8> sums{};
  const std::size_t whole = x.size() - x.size() % sums.size();
  if (whole > 0) {
    std::array<S, 8> of_whole{};
    in_registers_of_four([&of_whole, from = x.data(), whole] {
      std::array<S, 8> sum{};
      for (std::size_t i = 0; i < whole; i += sum.size())
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += from[i + k] * from[i + k];
      of_whole = sum;
    });
    sums = of_whole;
  }
  // Spelt out, so that the sums stay in registers: most systems have few numbers.
  const S* const rest = x.data() + whole;
  const auto add = [&](std::size_t k) { sums[k] += rest[k] * rest[k]; };
  switch (x.size() - whole) {
    case 7: add(6); [[fallthrough]];
    case 6: add(5); [[fallthrough]];
    case 5: add(4); [[fallthrough]];
    case 4: add(3); [[fallthrough]];
    case 3: add(2); [[fallthrough]];
    case 2: add(1); [[fallthrough]];
    case 1: add(0); [[fallthrough]];
    default: break;
  }
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace dalembert
