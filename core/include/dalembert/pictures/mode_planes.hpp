// Outputs of mesh nodes as sums of modes, for pictures: compact copies, because reading memory takes most of the
// time. A mode is stored as integers of two bytes, in units of its largest number in a block of nodes divided by the
// largest integer: sufficient for positions and colors in pictures. Modes of zeros, such as in-plane modes of plates,
// are not stored.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "dalembert/math/large_memory.hpp"

namespace dalembert {

class ModePlanes {
 public:
  static constexpr std::size_t most_components = 6;
  static constexpr std::size_t block = 256;  // nodes, whose sums stay in the nearest cache

  // of_mode(node, component, mode) returns the mode values.
  template <class OfMode>
  ModePlanes(std::size_t nodes, std::size_t components, std::size_t modes, const OfMode& of_mode)
      : nodes_(nodes), components_(components), modes_(modes), planes_(nodes * components * modes) {
    std::int16_t* to = planes_.data();
    std::array<double, block> plane;
    for (std::size_t first = 0; first < nodes; first += block) {
      starts_.push_back(to - planes_.data());
      const std::size_t count = size_of_block(first);
      for (std::size_t mode = 0; mode < modes; ++mode)
        for (std::size_t i = 0; i < components; ++i) {
          double largest = 0;
          for (std::size_t k = 0; k < count; ++k)
            largest = std::max(largest, std::abs(plane[k] = of_mode(first + k, i, mode)));
          const double unit = largest / std::numeric_limits<std::int16_t>::max();
          units_.push_back(unit);
          if (unit == 0) continue;
          for (std::size_t k = 0; k < count; ++k) *to++ = static_cast<std::int16_t>(std::round(plane[k] / unit));
        }
    }
    planes_.resize(static_cast<std::size_t>(to - planes_.data()));
  }

  std::size_t nodes() const { return nodes_; }
  std::size_t modes() const { return modes_; }
  // How many nodes there are in the block that begins with this one.
  std::size_t size_of_block(std::size_t first) const { return std::min(block, nodes_ - first); }
  // The sums of a block: the first component of all of its nodes, then the next one.
  void sum(std::span<const double> weights, std::size_t first, float* sums) const;
  // The only component of each node, or the length of all.
  void numbers(std::span<const double> weights, double* to) const;

 private:
  void add(std::span<const double> weights, std::size_t first, float* sums) const;

  std::size_t nodes_ = 0, components_ = 0, modes_ = 0;
  LargeVector<std::int16_t> planes_;  // by block, mode and component; without those of zeros
  std::vector<std::ptrdiff_t> starts_;  // of blocks
  std::vector<double> units_;  // unit of each plane, including those of zeros
};

}  // namespace dalembert
