#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "dalembert/math/few_numbers.hpp"
#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// Eight independent partial sums, in an order that depends only on the size.
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
  const S* const rest = x.data() + whole;  // all of most systems: the sums stay in registers
  each_of_few(x.size() - whole, [&](std::size_t k) { sums[k] += rest[k] * rest[k]; });
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace dalembert
