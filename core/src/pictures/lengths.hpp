// Lengths of vectors of which one component of all comes after the other.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "dalembert/math/inline.hpp"

namespace dalembert {

DALEMBERT_INLINE inline void find_lengths(const float* components, std::size_t size, std::size_t count, double* to) {
  std::fill_n(to, count, 0.0);
  for (std::size_t i = 0; i < size; ++i, components += count)
    for (std::size_t k = 0; k < count; ++k)
      to[k] += static_cast<double>(components[k]) * static_cast<double>(components[k]);
  for (std::size_t k = 0; k < count; ++k) to[k] = std::sqrt(to[k]);
}

}  // namespace dalembert
