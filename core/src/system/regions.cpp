#include "dalembert/system/regions.hpp"

#include <algorithm>
#include <cstdint>

namespace dalembert {
namespace {

constexpr int most_regions = 64;

}  // namespace

Regions::Regions(std::span<const Sizes> nodes, int coordinates) {
  std::int64_t total = 0, before = 0;
  for (const Sizes& node : nodes) total += node.ode2;
  while (smallest_ < most_regions && total >= 2 * smallest_ * coordinates) smallest_ *= 2;
  of_node_.reserve(nodes.size());
  for (const Sizes& node : nodes) {
    of_node_.push_back(node.ode2 == 0 ? none : smallest_ - 1 + static_cast<int>(before * smallest_ / total));
    before += node.ode2;
  }
}

int Regions::around(int a, int b) {
  if (a == none || b == none) return std::max(a, b);
  while (a != b) (a > b ? a : b) = (std::max(a, b) - 1) / 2;
  return a;
}

}  // namespace dalembert
