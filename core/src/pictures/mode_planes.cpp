#include "dalembert/pictures/mode_planes.hpp"

#include <algorithm>
#include <cmath>

namespace dalembert {

// Of the nodes of a block; returns how many there are.
std::size_t ModePlanes::sum(std::span<const double> weights, std::size_t first, Sums& sums) const {
  const std::size_t count = std::min(block, nodes_ - first);
  const float* plane = planes_.data() + first * components_ * (modes_ + 1);
  for (std::size_t i = 0; i < components_; ++i, plane += count) std::copy_n(plane, count, sums[i].data());
  for (const double weight : weights.first(modes_)) {
    const auto factor = static_cast<float>(weight);
    for (std::size_t i = 0; i < components_; ++i, plane += count) {
      float* const to = sums[i].data();
      for (std::size_t k = 0; k < count; ++k) to[k] += factor * plane[k];
    }
  }
  return count;
}

void ModePlanes::place(std::span<const double> weights, std::span<const double, 12> rows, float* to) const {
  std::array<float, 12> frame;
  std::ranges::transform(rows, frame.begin(), [](double number) { return static_cast<float>(number); });
  Sums sums;
  for (std::size_t first = 0; first < nodes_; first += block) {
    const std::size_t count = sum(weights, first, sums);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < 12; i += 4) *to++ = frame[i] * sums[0][k] + frame[i + 1] * sums[1][k] + frame[i + 2] * sums[2][k] + frame[i + 3];
  }
}

void ModePlanes::numbers(std::span<const double> weights, double* to) const {
  Sums sums;
  for (std::size_t first = 0; first < nodes_; first += block) {
    const std::size_t count = sum(weights, first, sums);
    if (components_ == 1)
      std::copy_n(sums[0].data(), count, to);
    else
      for (std::size_t k = 0; k < count; ++k) {
        double squares = 0;
        for (std::size_t i = 0; i < components_; ++i) squares += static_cast<double>(sums[i][k]) * static_cast<double>(sums[i][k]);
        to[k] = std::sqrt(squares);
      }
    to += count;
  }
}

}  // namespace dalembert
