// Cubic polynomials on an interval of given length by values and slopes at its ends.
#pragma once

#include <array>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

// Weights of value and slope at the begin, value and slope at the end, at one place; and their derivatives by the place.
template <class S>
struct CubicHermite {
  std::array<S, 4> value, slope, bend;

  CubicHermite(const S& place, double length) {
    const double l = length;
    const S x = (1 / l) * place, y = 1.0 - x;
    value = {y * y * (1.0 + 2.0 * x), l * x * y * y, x * x * (3.0 - 2.0 * x), -l * x * x * y};
    const S by_ends = (6 / l) * x * y;
    slope = {-by_ends, y * (1.0 - 3.0 * x), by_ends, x * (3.0 * x - 2.0)};
    const S turn = (6 / (l * l)) * (2.0 * x - 1.0);
    bend = {turn, (1 / l) * (6.0 * x - 4.0), -turn, (1 / l) * (6.0 * x - 2.0)};
  }
};

// A curve in D dimensions: weights times [r0, r0', r1, r1'].
template <int D, class W, class S>
Vec<S, D> curve(const std::array<W, 4>& weights, const S* coordinates) {
  Vec<S, D> r;
  for (int i = 0; i < 4; ++i)
    for (int d = 0; d < D; ++d) r[d] += weights[i] * coordinates[D * i + d];
  return r;
}

}  // namespace dalembert
