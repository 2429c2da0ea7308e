// Bounding volume hierarchy: finds the entries near a point, and those that a line may hit.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "dalembert/math/fixed.hpp"
#include "dalembert/math/pack.hpp"

namespace dalembert {

struct Box {
  Vec3<double> lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                     std::numeric_limits<double>::infinity()};
  Vec3<double> upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()};

  void add(const Vec3<double>& point) {
    for (int i = 0; i < 3; ++i) {
      lower[i] = std::min(lower[i], point[i]);
      upper[i] = std::max(upper[i], point[i]);
    }
  }
  void add_box(const Box& other) {
    add(other.lower);
    add(other.upper);
  }
  bool overlaps(const Box& other) const {
    for (int i = 0; i < 3; ++i)
      if (lower[i] > other.upper[i] || upper[i] < other.lower[i]) return false;
    return true;
  }
  // Argument: a point, or several side by side.
  template <class S>
  DALEMBERT_INLINE S square_distance(const Vec3<S>& point) const {
    S square{};
    for (int i = 0; i < 3; ++i) {
      const S outside = larger(S{}, larger(S(lower[i] - point[i]), S(point[i] - upper[i])));
      square += outside * outside;
    }
    return square;
  }
};

class BoxTree {
 public:
  // Entries are numbers of boxes.
  void build(std::span<const int> entries, std::span<const Box> boxes);
  bool empty() const { return nodes_.empty(); }
  const Box& box() const { return nodes_.front().box; }

  // Calls f(entry) for all with a box within `distance` of the point, in any order.
  template <class F>
  void each_near(const Vec3<double>& point, double distance, F&& f) const {
    each([&](const Box& box) { return box.square_distance(point) <= distance * distance; }, f);
  }
  // The same for four points side by side: calls f(entry) for all with a box that any of them is near.
  template <class F>
  DALEMBERT_INLINE void each_near(const Vec3<Pack<4>>& points, const Pack<4>& distances, F&& f) const {
    using P = Pack<4>;
    const P most = distances * distances;
    const auto wanted = [&](const Box& box) DALEMBERT_INLINE {
      return !is_zero(P(box.square_distance(points).x <= most.x ? 1.0 - P::Register{} : P::Register{}));
    };
    each(wanted, f);
  }
  // Calls f(entry) for all entries whose box may be hit by the line start + s * direction, from <= s <= to(), at this
  // distance; `to` may decrease meanwhile.
  template <class To, class F>
  void each_along(const Vec3<double>& start, const Vec3<double>& direction, double distance, double from, const To& to,
                  F&& f) const {
    each([&](const Box& box) { return passes(box, start, direction, distance, from, to()); }, f);
  }

 private:
  struct Node {
    Box box;
    int first = 0, count = 0;  // leaf: its entries; count 0: the children are the next node and node number `first`
  };
  template <class Wanted, class F>
  DALEMBERT_INLINE void each(const Wanted& wanted, F&& f) const {
    if (nodes_.empty()) return;
    std::array<int, 64> stack;
    int depth = 0;
    stack[0] = 0;
    while (depth >= 0) {
      const int at = stack[static_cast<std::size_t>(depth--)];
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      if (!wanted(node.box)) continue;
      if (node.count == 0) {
        stack[static_cast<std::size_t>(++depth)] = node.first;
        stack[static_cast<std::size_t>(++depth)] = at + 1;
        continue;
      }
      for (int i = node.first; i < node.first + node.count; ++i) f(entries_[static_cast<std::size_t>(i)]);
    }
  }
  static bool passes(const Box& box, const Vec3<double>& start, const Vec3<double>& direction, double distance,
                     double from, double to);
  void split(int first, int count, std::span<const Box> boxes);

  std::vector<Node> nodes_;
  std::vector<int> entries_;
};

}  // namespace dalembert
