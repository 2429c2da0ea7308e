#include "scaling.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {

namespace {

constexpr int largest_exponent = 200;
// Smaller diagonal entries, relative to the largest one, are round-off of zeros.
constexpr double negligible_entry = 1e-14;

// The median of nonzero entries; zero if there are none.
double median(std::vector<double> sizes) {
  std::erase_if(sizes, [](double x) { return !(x > 0) || !std::isfinite(x); });
  if (sizes.empty()) return 0;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

double ratio_as_power_of_two(double a, double b) {
  if (a == 0 || b == 0) return 1;
  return std::ldexp(1.0, std::clamp(std::ilogb(a) - std::ilogb(b), -largest_exponent, largest_exponent));
}

}  // namespace

Scaling balance(const Pattern& pattern, std::span<const double> values) {
  const auto n = static_cast<std::size_t>(pattern.size());
  const auto starts = pattern.column_start(), rows = pattern.row_index();
  std::vector<double> diagonal(n), largest_of_row(n, 0.0), largest_of_column(n, 0.0);
  for (int j = 0; j < pattern.size(); ++j) diagonal[j] = std::abs(values[pattern.slot(j, j)]);
  const double least = n > 0 ? negligible_entry * *std::ranges::max_element(diagonal) : 0;
  for (double& d : diagonal)
    if (d <= least) d = 0;
  for (int j = 0; j < pattern.size(); ++j) {
    for (int k = starts[j]; k < starts[j + 1]; ++k) {
      const int i = rows[k];
      if (diagonal[i] == 0) largest_of_row[i] = std::max(largest_of_row[i], std::abs(values[k]));
      if (diagonal[j] == 0) largest_of_column[j] = std::max(largest_of_column[j], std::abs(values[k]));
    }
  }
  const double size = median(diagonal);
  Scaling scaling;
  for (const double d : diagonal) scaling.multiplier.push_back(d == 0);
  scaling.row_factor = ratio_as_power_of_two(size, median(std::move(largest_of_row)));
  scaling.column_factor = ratio_as_power_of_two(size, median(std::move(largest_of_column)));
  return scaling;
}

}  // namespace dalembert
