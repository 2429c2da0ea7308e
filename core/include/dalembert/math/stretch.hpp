// A part of a list of numbers that many share.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace dalembert {

struct Stretch {
  std::uint32_t first = 0, count = 0;
  std::span<const int> of(const std::vector<int>& numbers) const { return {numbers.data() + first, count}; }
};

}  // namespace dalembert
