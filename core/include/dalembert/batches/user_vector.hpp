// User functions of whole coordinate vectors, for items of run-time size: derivatives by central differences.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "dalembert/reflection/callback.hpp"

namespace dalembert {

inline Argument as_argument(const std::vector<double>& x) { return {x.data(), static_cast<int>(x.size()), 0}; }

// matrix(i, j) += factor * d f_i / d x_j for all x_j; `evaluate(f)` reads x, which is left as it was. Row by row.
template <class Evaluate>
void add_differences(std::vector<double>& x, double factor, std::span<double> matrix, Evaluate&& evaluate) {
  if (factor == 0 || x.empty()) return;
  const std::size_t columns = x.size(), rows = matrix.size() / columns;
  std::vector<double> up(rows), down(rows);
  for (std::size_t j = 0; j < columns; ++j) {
    const double at = x[j], h = 1e-6 * std::max(1e-2, std::abs(at));
    x[j] = at + h;
    evaluate(std::span(up));
    x[j] = at - h;
    evaluate(std::span(down));
    x[j] = at;
    for (std::size_t i = 0; i < rows; ++i) matrix[i * columns + j] += factor * (up[i] - down[i]) / (2 * h);
  }
}

}  // namespace dalembert
