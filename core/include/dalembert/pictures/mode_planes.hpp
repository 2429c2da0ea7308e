// Outputs of mesh nodes that are sums of modes, for pictures: copies of which all that is read is used, as reading them takes most of the time.
// Where Number is an integer, a mode is kept in units: its largest number among the nodes of a block, divided by the largest integer. Two bytes are
// enough for points, of which nothing but their place in a picture is seen.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "dalembert/math/large_memory.hpp"

namespace dalembert {

template <class Number>
class ModePlanes {
 public:
  static constexpr std::size_t most_components = 6;

  // rest(node, component) and of_mode(node, component, mode) tell what is summed up; nullptr: there is no rest.
  template <class Rest, class OfMode>
  ModePlanes(std::size_t nodes, std::size_t components, std::size_t modes, const Rest& rest, const OfMode& of_mode)
      : nodes_(nodes), components_(components), modes_(modes), rest_(has_rest<Rest> ? nodes * components : 0), planes_(nodes * components * modes) {
    [[maybe_unused]] float* at_rest = rest_.data();
    Number* to = planes_.data();
    std::array<double, block> plane;
    for (std::size_t first = 0; first < nodes; first += block) {
      const std::size_t count = std::min(block, nodes - first);
      if constexpr (has_rest<Rest>)
        for (std::size_t i = 0; i < components; ++i)
          for (std::size_t k = 0; k < count; ++k) *at_rest++ = static_cast<float>(rest(first + k, i));
      for (std::size_t mode = 0; mode < modes; ++mode)
        for (std::size_t i = 0; i < components; ++i) {
          double largest = 0;
          for (std::size_t k = 0; k < count; ++k) largest = std::max(largest, std::abs(plane[k] = of_mode(first + k, i, mode)));
          const double unit = has_units && largest > 0 ? largest / std::numeric_limits<Number>::max() : 1;
          units_.push_back(unit);
          for (std::size_t k = 0; k < count; ++k) *to++ = static_cast<Number>(has_units ? std::round(plane[k] / unit) : plane[k]);
        }
    }
  }

  // Points, three components, in a frame of rotation and position (rows, 3 x 4): x, y and z of each node.
  void place(std::span<const double> weights, std::span<const double, 12> rows, float* to) const;
  // The only component of each node, or the length of all.
  void numbers(std::span<const double> weights, double* to) const;

 private:
  static constexpr bool has_units = std::is_integral_v<Number>;
  template <class Rest>
  static constexpr bool has_rest = !std::is_null_pointer_v<Rest>;
  static constexpr std::size_t block = 256;  // nodes, whose sums stay in the nearest cache
  using Sums = std::array<std::array<float, block>, most_components>;

  std::size_t sum(std::span<const double> weights, std::size_t first, Sums& sums) const;
  void add(std::span<const double> weights, std::size_t first, std::size_t count, Sums& sums) const;
  void find_lengths(const Sums& sums, std::size_t count, double* to) const;

  std::size_t nodes_ = 0, components_ = 0, modes_ = 0;
  LargeVector<float> rest_;     // of the nodes of a block, one block after the other, by component; empty: zeros
  LargeVector<Number> planes_;  // by block, mode and component
  std::vector<double> units_;   // of each of these
};

extern template class ModePlanes<std::int16_t>;
extern template class ModePlanes<float>;

}  // namespace dalembert
