#include "ray_tree.hpp"

#include <algorithm>
#include <numeric>

namespace dalembert {
namespace {

// Boxes along an axis, sorted into slices by their centers: the cut minimizes the sum of surfaces times counts.
struct Cut {
  static constexpr int slices = 16;

  int after = -1;  // the last slice on the near side; -1: nothing to cut
  double cost = never;

  Cut(const std::array<Box, slices>& boxes, const std::array<std::uint32_t, slices>& counts) {
    std::array<double, slices> beyond{};
    Box box;
    std::uint32_t count = 0;
    for (int i = slices - 1; i > 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      if (counts[k] > 0) box.add(boxes[k]);
      count += counts[k];
      beyond[k] = count == 0 ? never : count * box.surface();
    }
    box = {}, count = 0;
    for (int i = 0; i + 1 < slices; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (counts[k] > 0) box.add(boxes[k]);
      count += counts[k];
      if (count == 0) continue;
      const double sum = count * box.surface() + beyond[k + 1];
      if (sum < cost) cost = sum, after = i;
    }
  }
};

}  // namespace

void RayTree::build(const std::vector<Box>& boxes) {
  nodes_.clear();
  shapes_.resize(boxes.size());
  std::iota(shapes_.begin(), shapes_.end(), 0u);
  if (!boxes.empty()) grow(boxes, 0, static_cast<std::uint32_t>(boxes.size()), 0);
}

std::uint32_t RayTree::grow(const std::vector<Box>& boxes, std::uint32_t first, std::uint32_t count, int level) {
  const auto number = static_cast<std::uint32_t>(nodes_.size());
  nodes_.emplace_back();
  Box all, middles;
  const auto begin = shapes_.begin() + first, end = begin + count;
  std::for_each(begin, end, [&](std::uint32_t shape) { all.add(boxes[shape]), middles.add(boxes[shape].middle()); });
  nodes_[number].box = all;
  const auto rest = [&] {
    nodes_[number].first = first, nodes_[number].count = count;
    return number;
  };
  if (count <= few || level + 2 >= depth) return rest();
  const Vec3<double> size = middles.high - middles.low;
  const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
  if (!(size[axis] > 0)) return rest();  // all in one place
  const auto slice = [&](std::uint32_t shape) {
    const double part = (boxes[shape].middle()[axis] - middles.low[axis]) / size[axis];
    return std::min(static_cast<int>(part * Cut::slices), Cut::slices - 1);
  };
  std::array<Box, Cut::slices> of_slice;
  std::array<std::uint32_t, Cut::slices> counts{};
  std::for_each(begin, end, [&](std::uint32_t shape) {
    const auto k = static_cast<std::size_t>(slice(shape));
    of_slice[k].add(boxes[shape]), ++counts[k];
  });
  const Cut cut(of_slice, counts);
  const auto middle = std::stable_partition(begin, end, [&](std::uint32_t shape) { return slice(shape) <= cut.after; });
  const auto near = static_cast<std::uint32_t>(middle - begin);
  if (near == 0 || near == count) return rest();
  nodes_[number].axis = axis;
  grow(boxes, first, near, level + 1);
  const std::uint32_t second = grow(boxes, first + near, count - near, level + 1);
  nodes_[number].first = second;
  return number;
}

}  // namespace dalembert
