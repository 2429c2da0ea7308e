// Vectors of length one.
#pragma once

#include <cmath>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/fixed.hpp"

namespace dalembert {

// A unit vector, or zero if there is no direction.
template <class S, int N>
Vec<S, N> direction(const Vec<S, N>& v) {
  const S square = dot(v, v);
  if (value_of(square) == 0) return {};
  using std::sqrt;
  return (1.0 / sqrt(square)) * v;
}

}  // namespace dalembert
