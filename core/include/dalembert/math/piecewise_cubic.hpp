// Functions that are given by a table: a cubic polynomial between two points, constant beyond the ends.
//
// Layout of n intervals: n + 1 increasing points, then four coefficients of each interval, [c0, c1, c2, c3] of
// c0 + c1 s + c2 s^2 + c3 s^3, where s is the distance from the start of the interval.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

namespace dalembert {

class PiecewiseCubic {
 public:
  struct Result {
    double value, slope;
  };

  explicit PiecewiseCubic(std::span<const double> numbers) : numbers_(numbers), intervals_((numbers.size() - 1) / 5) {}

  Result at(double x) const {
    const std::span<const double> points = numbers_.first(intervals_ + 1);
    if (x <= points.front()) return {coefficients(0)[0], 0};
    if (x >= points.back()) return {polynomial(intervals_ - 1, points.back() - points[intervals_ - 1]).value, 0};
    const auto interval = static_cast<std::size_t>(std::ranges::upper_bound(points, x) - points.begin()) - 1;
    return polynomial(interval, x - points[interval]);
  }

  // The table of the slope. Intervals of any length before and after have no slope.
  std::vector<double> derivative() const {
    std::vector<double> made{numbers_[0] - 1};
    made.insert(made.end(), numbers_.begin(), numbers_.begin() + static_cast<std::ptrdiff_t>(intervals_ + 1));
    made.push_back(numbers_[intervals_] + 1);
    const auto add = [&](double c0, double c1, double c2) { made.insert(made.end(), {c0, c1, c2, 0.0}); };
    add(0, 0, 0);
    for (std::size_t i = 0; i < intervals_; ++i) {
      const double* c = coefficients(i);
      add(c[1], 2 * c[2], 3 * c[3]);
    }
    add(0, 0, 0);
    return made;
  }

  // Throws std::invalid_argument.
  static void check(std::span<const double> numbers) {
    const std::size_t intervals = (numbers.size() - std::min<std::size_t>(numbers.size(), 1)) / 5;
    if (intervals == 0 || numbers.size() != 5 * intervals + 1)
      throw std::invalid_argument("a table needs 5 n + 1 numbers, for n intervals");
    const auto points = numbers.first(intervals + 1);
    for (std::size_t i = 0; i < intervals; ++i)
      if (!(points[i] < points[i + 1])) throw std::invalid_argument("points of a table have to increase");
  }

 private:
  const double* coefficients(std::size_t interval) const { return numbers_.data() + intervals_ + 1 + 4 * interval; }
  Result polynomial(std::size_t interval, double s) const {
    const double* c = coefficients(interval);
    return {c[0] + s * (c[1] + s * (c[2] + s * c[3])), c[1] + s * (2 * c[2] + s * 3 * c[3])};
  }

  std::span<const double> numbers_;
  std::size_t intervals_;
};

}  // namespace dalembert
