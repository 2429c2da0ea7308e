#include "dalembert/system/regions.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>

namespace dalembert {
namespace {

constexpr int most_regions = 64;

}  // namespace

Regions::Regions(std::span<const int> node_sizes, int coordinates) {
  const std::int64_t total = std::accumulate(node_sizes.begin(), node_sizes.end(), std::int64_t{0});
  while (smallest_ < most_regions && total >= 2 * smallest_ * coordinates) smallest_ *= 2;
  of_node_.reserve(node_sizes.size());
  std::int64_t before = 0;
  for (const int size : node_sizes) {
    of_node_.push_back(size == 0 ? none : smallest_ - 1 + static_cast<int>(before * smallest_ / total));
    before += size;
  }
}

int Regions::around(int a, int b) {
  if (a == none || b == none) return std::max(a, b);
  while (a != b) (a > b ? a : b) = (std::max(a, b) - 1) / 2;
  return a;
}

}  // namespace dalembert
