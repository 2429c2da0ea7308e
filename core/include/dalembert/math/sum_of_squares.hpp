#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace dalembert {

// Eight sums that do not wait for each other, in an order that depends on the size alone.
template <class S>
S sum_of_squares(std::span<const S> x) {
  std::array<S, 8> sums{};
  const std::size_t whole = x.size() - x.size() % sums.size();
  for (std::size_t i = 0; i < whole; i += sums.size())
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += x[i + k] * x[i + k];
  for (std::size_t i = whole; i < x.size(); ++i) sums[i - whole] += x[i] * x[i];
  return ((sums[0] + sums[4]) + (sums[2] + sums[6])) + ((sums[1] + sums[5]) + (sums[3] + sums[7]));
}

}  // namespace dalembert
