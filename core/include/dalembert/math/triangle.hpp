// The nearest point of a triangle to a given point: on its face, on an edge, or a corner. Ericson: Real-time
// collision detection, chapter 5, Morgan Kaufmann 2005.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/fixed.hpp"

namespace dalembert {

using Triangle = std::array<Vec3<double>, 3>;

// Edge i leads from corner i to the next one.
struct TriangleFeature {
  int edges = 0;  // bits 1, 2, 4: the edge, or both edges at the corner; 0: the face
  int first = 0;  // start of the edge; the corner
  bool is_face() const { return edges == 0; }
  bool is_edge() const { return edges == 1 || edges == 2 || edges == 4; }
};

inline TriangleFeature nearest_feature(const Triangle& t, const Vec3<double>& point) {
  const auto edge = [](int i) { return TriangleFeature{1 << i, i}; };
  const auto corner = [](int i) { return TriangleFeature{(1 << i) | (1 << (i + 2) % 3), i}; };
  const Vec3<double> ab = t[1] - t[0], ac = t[2] - t[0];
  const double d1 = dot(ab, point - t[0]), d2 = dot(ac, point - t[0]);
  if (d1 <= 0 && d2 <= 0) return corner(0);
  const double d3 = dot(ab, point - t[1]), d4 = dot(ac, point - t[1]);
  if (d3 >= 0 && d4 <= d3) return corner(1);
  if (d1 * d4 - d3 * d2 <= 0 && d1 >= 0 && d3 <= 0) return edge(0);
  const double d5 = dot(ab, point - t[2]), d6 = dot(ac, point - t[2]);
  if (d6 >= 0 && d5 <= d6) return corner(2);
  if (d5 * d2 - d1 * d6 <= 0 && d2 >= 0 && d6 <= 0) return edge(2);
  if (d3 * d6 - d5 * d4 <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return edge(1);
  return {};
}

// The edges whose lines are so near to a point, as bits.
inline int edges_near(const Triangle& t, const Vec3<double>& point, double distance) {
  int edges = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> line = t[(i + 1) % 3] - t[i];
    if (norm(cross(line, point - t[i])) <= distance * norm(line)) edges |= 1 << i;
  }
  return edges;
}

// Fraction of a small circle in the plane of a triangle, around a point on these edges, that is inside of the
// triangle.
inline double share_at(const Triangle& t, int edges) {
  if (edges == 0) return 1;
  if (edges == 1 || edges == 2 || edges == 4) return 0.5;
  const std::size_t corner = edges == 3 ? 1 : edges == 6 ? 2 : 0;
  const Vec3<double> ab = t[(corner + 1) % 3] - t[corner], ac = t[(corner + 2) % 3] - t[corner];
  return std::atan2(norm(cross(ab, ac)), dot(ab, ac)) / (2 * std::numbers::pi);
}

// Twice the area, as a vector along the normal.
inline Vec3<double> area_vector(const Triangle& t) { return cross(t[1] - t[0], t[2] - t[0]); }

// The nearest point on a feature, whose plane or line goes on.
template <class S>
Vec3<S> nearest_point(const Triangle& t, const TriangleFeature& on, const Vec3<S>& point) {
  const auto constant = [](const Vec3<double>& v) { return vector_of<3>([&](int i) { return S(v[i]); }); };
  const Vec3<double>& begin = t[static_cast<std::size_t>(on.first)];
  if (on.is_face()) {
    const Vec3<double> area = area_vector(t);
    return point - (dot(area, point - begin) / dot(area, area)) * area;
  }
  if (!on.is_edge()) return constant(begin);
  const Vec3<double> line = t[static_cast<std::size_t>((on.first + 1) % 3)] - begin;
  return constant(begin) + (dot(line, point - begin) / dot(line, line)) * line;
}

}  // namespace dalembert
