#include "dalembert/pictures/mode_planes.hpp"

#include <algorithm>
#include <cmath>

#include "dalembert/math/wide_registers.hpp"

namespace dalembert {

// Of the nodes of a block; returns how many there are.
template <class Number>
std::size_t ModePlanes<Number>::sum(std::span<const double> weights, std::size_t first, Sums& sums) const {
  const std::size_t count = std::min(block, nodes_ - first);
  for (std::size_t i = 0; i < components_; ++i) {
    if (rest_.empty())
      std::fill_n(sums[i].data(), count, 0.0f);
    else
      std::copy_n(rest_.data() + first * components_ + i * count, count, sums[i].data());
  }
  in_registers_of_four([this, weights, first, count, &sums] { add(weights, first, count, sums); });
  return count;
}

template <class Number>
void ModePlanes<Number>::add(std::span<const double> weights, std::size_t first, std::size_t count, Sums& sums) const {
  const Number* plane = planes_.data() + first * components_ * modes_;
  const double* unit = units_.data() + first / block * components_ * modes_;
  for (const double weight : weights.first(modes_))
    for (std::size_t i = 0; i < components_; ++i, plane += count) {
      const auto factor = static_cast<float>(weight * *unit++);
      float* const to = sums[i].data();
      for (std::size_t k = 0; k < count; ++k) to[k] += factor * static_cast<float>(plane[k]);
    }
}

template <class Number>
void ModePlanes<Number>::find_lengths(const Sums& sums, std::size_t count, double* to) const {
  std::fill_n(to, count, 0.0);
  for (std::size_t i = 0; i < components_; ++i)
    for (std::size_t k = 0; k < count; ++k) to[k] += static_cast<double>(sums[i][k]) * static_cast<double>(sums[i][k]);
  for (std::size_t k = 0; k < count; ++k) to[k] = std::sqrt(to[k]);
}

template <class Number>
void ModePlanes<Number>::place(std::span<const double> weights, std::span<const double, 12> rows, float* to) const {
  std::array<float, 12> frame;
  std::ranges::transform(rows, frame.begin(), [](double number) { return static_cast<float>(number); });
  Sums sums;
  for (std::size_t first = 0; first < nodes_; first += block) {
    const std::size_t count = sum(weights, first, sums);
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t i = 0; i < 12; i += 4) *to++ = frame[i] * sums[0][k] + frame[i + 1] * sums[1][k] + frame[i + 2] * sums[2][k] + frame[i + 3];
  }
}

template <class Number>
void ModePlanes<Number>::numbers(std::span<const double> weights, double* to) const {
  Sums sums;
  for (std::size_t first = 0; first < nodes_; first += block) {
    const std::size_t count = sum(weights, first, sums);
    if (components_ == 1)
      std::copy_n(sums[0].data(), count, to);
    else
      in_registers_of_four([this, &sums, count, to] { find_lengths(sums, count, to); });
    to += count;
  }
}

template class ModePlanes<std::int16_t>;
template class ModePlanes<float>;

}  // namespace dalembert
