#include "dalembert/contact/triangle_tree.hpp"

#include <algorithm>

namespace dalembert {
namespace {

constexpr int leaf_size = 4;

}  // namespace

void TriangleTree::build(std::span<const int> entries, const std::vector<Triangle>& all) {
  entries_.assign(entries.begin(), entries.end());
  nodes_.clear();
  if (entries_.empty()) return;
  nodes_.reserve(entries_.size());
  split(0, static_cast<int>(entries_.size()), all);
}

// In halves along the longest side of the box around the centres.
void TriangleTree::split(int first, int count, const std::vector<Triangle>& all) {
  const auto sum = [&](int entry) {
    const Triangle& t = all[static_cast<std::size_t>(entry)];
    return t[0] + t[1] + t[2];
  };
  const std::size_t at = nodes_.size();
  nodes_.emplace_back();
  Box box, centres;
  for (int i = first; i < first + count; ++i) {
    const int entry = entries_[static_cast<std::size_t>(i)];
    for (const Vec3<double>& point : all[static_cast<std::size_t>(entry)]) box.add(point);
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
  split(first, count / 2, all);
  nodes_[at].first = static_cast<int>(nodes_.size());
  split(first + count / 2, count - count / 2, all);
}

// A hair wider than the box: a line along its side meets what lies there.
bool TriangleTree::passes(const Box& box, const Vec3<double>& start, const Vec3<double>& direction, double from, double to) {
  for (int i = 0; i < 3; ++i) {
    const double hair = 1e-9 * (box.upper[i] - box.lower[i]) + 1e-14 * (std::abs(box.upper[i]) + std::abs(box.lower[i]));
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
