#include "dalembert/contact/box_tree.hpp"

#include <algorithm>

namespace dalembert {
namespace {

constexpr int leaf_size = 4;

}  // namespace

void BoxTree::build(std::span<const int> entries, std::span<const Box> boxes) {
  entries_.assign(entries.begin(), entries.end());
  nodes_.clear();
  if (entries_.empty()) return;
  nodes_.reserve(entries_.size());
  split(0, static_cast<int>(entries_.size()), boxes);
}

// Splits into halves along the longest side of the box around the centers.
void BoxTree::split(int first, int count, std::span<const Box> boxes) {
  const auto sum = [&](int entry) {
    const Box& box = boxes[static_cast<std::size_t>(entry)];
    return box.lower + box.upper;
  };
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  Box box, centres;
  for (int i = first; i < first + count; ++i) {
    const int entry = entries_[static_cast<std::size_t>(i)];
    box.add_box(boxes[static_cast<std::size_t>(entry)]);
    centres.add(sum(entry));
  }
  nodes_[at].box = box;
  if (count <= leaf_size) {
    nodes_[at].first = first;
    nodes_[at].count = count;
    return;
  }
  int axis = 0;
  for (int i = 1; i < 3; ++i)
    if (centres.upper[i] - centres.lower[i] > centres.upper[axis] - centres.lower[axis]) axis = i;
  const auto begin = entries_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count, [&](int a, int b) {
    const double x = sum(a)[axis], y = sum(b)[axis];
    return x < y || (x == y && a < b);
  });
  split(first, count / 2, boxes);
  nodes_[at].first = static_cast<int>(nodes_.size());
  split(first + count / 2, count - count / 2, boxes);
}

// Slightly larger than the box: lines along its side still hit.
bool BoxTree::passes(const Box& box, const Vec3<double>& start, const Vec3<double>& direction, double distance,
                     double from, double to) {
  for (int i = 0; i < 3; ++i) {
    const double hair =
        1e-9 * (box.upper[i] - box.lower[i]) + 1e-14 * (std::abs(box.upper[i]) + std::abs(box.lower[i])) + distance;
    const double lower = box.lower[i] - hair - start[i], upper = box.upper[i] + hair - start[i];
    if (direction[i] == 0) {
      if (lower > 0 || upper < 0) return false;
      continue;
    }
    const double a = lower / direction[i], b = upper / direction[i];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from <= to;
}

}  // namespace dalembert
