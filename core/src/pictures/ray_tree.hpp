// A bounding volume hierarchy: candidates of many shapes for a ray.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ray_shapes.hpp"

namespace dalembert {

struct Box {
  Vec3<double> low{never, never, never}, high{-never, -never, -never};

  void add(const Vec3<double>& p, double around = 0) {
    for (int i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i] - around), high[i] = std::max(high[i], p[i] + around);
  }
  void add(const Box& b) { add(b.low), add(b.high); }
  Vec3<double> middle() const { return 0.5 * (low + high); }
  double surface() const {
    const Vec3<double> d = high - low;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

class RayTree {
 public:
  // Builds the hierarchy from the boxes of shapes only, so that the same scene has the same hierarchy.
  void build(const std::vector<Box>& boxes);
  // Calls meet(shape) for those whose boxes the ray passes between its begin and its end, near ones rather first; `meet` may bring the
  // end of the ray nearer, and returns whether enough is known.
  template <class Meet>
  void pass(Ray& ray, const Meet& meet) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0,
                  count = 0;  // count > 0: shapes; otherwise the second child, the first one is the next node
    int axis = 0;
  };
  static constexpr std::uint32_t few = 4;
  static constexpr int depth = 64;  // halves of a list of 2^32 shapes

  std::uint32_t grow(const std::vector<Box>& boxes, std::uint32_t first, std::uint32_t count, int level);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> shapes_;
};

// Whether a ray passes a box; not-a-number, from a ray in the plane of a side, counts as passing.
inline bool passes(const Ray& ray, const Vec3<double>& inverse, const Box& box) {
  double begin = ray.begin, end = ray.end;
  for (int i = 0; i < 3; ++i) {
    const double a = (box.low[i] - ray.origin[i]) * inverse[i], b = (box.high[i] - ray.origin[i]) * inverse[i];
    const double near = inverse[i] < 0 ? b : a, far = inverse[i] < 0 ? a : b;
    if (near > begin) begin = near;
    if (far < end) end = far;
  }
  return begin <= end;
}

template <class Meet>
void RayTree::pass(Ray& ray, const Meet& meet) const {
  if (nodes_.empty()) return;
  const Vec3<double> inverse{1 / ray.direction[0], 1 / ray.direction[1], 1 / ray.direction[2]};
  std::array<std::uint32_t, depth> waiting;
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const std::uint32_t number = waiting[--count];
    const Node& node = nodes_[number];
    if (!passes(ray, inverse, node.box)) continue;
    if (node.count == 0) {
      const std::array<std::uint32_t, 2> children{number + 1, node.first};
      const bool from_behind = inverse[node.axis] < 0;
      waiting[count++] = children[from_behind ? 0 : 1], waiting[count++] = children[from_behind ? 1 : 0];
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (meet(shapes_[i])) return;
  }
}

}  // namespace dalembert
