// Outputs of mesh nodes that are sums of modes, for pictures: copies in single precision, of which all that is read is used.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "dalembert/math/large_memory.hpp"

namespace dalembert {

class ModePlanes {
 public:
  static constexpr std::size_t most_components = 6;

  // rest(node, component) and of_mode(node, component, mode) tell what is summed up.
  template <class Rest, class OfMode>
  ModePlanes(std::size_t nodes, std::size_t components, std::size_t modes, const Rest& rest, const OfMode& of_mode)
      : nodes_(nodes), components_(components), modes_(modes), planes_(nodes * components * (modes + 1)) {
    float* to = planes_.data();
    for (std::size_t first = 0; first < nodes; first += block) {
      const std::size_t end = first + block < nodes ? first + block : nodes;
      for (std::size_t i = 0; i < components; ++i)
        for (std::size_t node = first; node < end; ++node) *to++ = static_cast<float>(rest(node, i));
      for (std::size_t mode = 0; mode < modes; ++mode)
        for (std::size_t i = 0; i < components; ++i)
          for (std::size_t node = first; node < end; ++node) *to++ = static_cast<float>(of_mode(node, i, mode));
    }
  }

  // Points, three components, in a frame of rotation and position (rows, 3 x 4): x, y and z of each node.
  void place(std::span<const double> weights, std::span<const double, 12> rows, float* to) const;
  // The only component of each node, or the length of all.
  void numbers(std::span<const double> weights, double* to) const;

 private:
  static constexpr std::size_t block = 256;  // nodes, whose sums stay in the nearest cache
  using Sums = std::array<std::array<float, block>, most_components>;

  std::size_t sum(std::span<const double> weights, std::size_t first, Sums& sums) const;

  std::size_t nodes_ = 0, components_ = 0, modes_ = 0;
  LargeVector<float> planes_;  // of the nodes of a block, one block after the other: by component at rest, then by mode and component
};

}  // namespace dalembert
