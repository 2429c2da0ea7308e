// User functions of whole coordinate vectors, for items of run-time size.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "dalembert/reflection/callback.hpp"

namespace dalembert {

inline Argument as_argument(const std::vector<double>& x) { return {x.data(), static_cast<int>(x.size()), 0}; }

// matrix(i, j) += factor * d f_i / d x_j for all x_j, row by row. `at` is f(x), `evaluate(f)` reads x, which is left as it was.
// `derivative(j, f)` gives df/dx_j or returns false; forward differences are used then.
template <class Evaluate, class Derivative>
void add_derivatives(std::vector<double>& x, double factor, std::span<const double> at, std::span<double> matrix, Evaluate&& evaluate,
                     Derivative&& derivative) {
  if (factor == 0 || x.empty()) return;
  const std::size_t columns = x.size();
  std::vector<double> slopes(at.size());
  for (std::size_t j = 0; j < columns; ++j) {
    if (!derivative(static_cast<int>(j), std::span(slopes))) {
      const double here = x[j];
      x[j] = here + 1e-7 * std::max(1e-2, std::abs(here));
      const double step = x[j] - here;  // as rounded
      evaluate(std::span(slopes));
      x[j] = here;
      for (std::size_t i = 0; i < slopes.size(); ++i) slopes[i] = (slopes[i] - at[i]) / step;
    }
    for (std::size_t i = 0; i < slopes.size(); ++i) matrix[i * columns + j] += factor * slopes[i];
  }
}

}  // namespace dalembert
