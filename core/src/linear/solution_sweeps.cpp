#include "solution_sweeps.hpp"

#include <algorithm>

#include "front_kernels.hpp"

namespace dalembert {

StreamSizes stream_sizes(const FrontSize& front) {
  StreamSizes sizes{};
  for (int k = 0; k < front.pivots; k += pivot_group) {
    const int left = front.pivots - k, group = std::min(left, pivot_group), height = group_slots(group);
    const auto rows_below = static_cast<std::size_t>(slots(left - pivot_group) + padded(front.updates));
    const auto columns_right = static_cast<std::size_t>(left - group + front.updates);
    sizes.lower += static_cast<std::size_t>(lower_column(group, height)) + static_cast<std::size_t>(group) * rows_below;
    sizes.upper += static_cast<std::size_t>(upper_column(group)) + static_cast<std::size_t>(height) * columns_right;
  }
  return sizes;
}

}  // namespace dalembert
