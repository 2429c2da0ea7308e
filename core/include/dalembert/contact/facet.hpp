// A triangle and what is often asked of it: its normal, and on which side of its edges a point is.
#pragma once

#include <algorithm>

#include "dalembert/math/pack.hpp"
#include "dalembert/math/triangle.hpp"

namespace dalembert {

struct Facet {
  Vec3<double> corner, normal;             // of length one
  std::array<Vec3<double>, 3> inward;      // in the plane, across the edges, of length one
  std::array<double, 3> at_edge{};         // their products with points of the edges

  Facet() = default;
  explicit Facet(const Triangle& t) : corner(t[0]) {
    const Vec3<double> area = area_vector(t);
    normal = (1 / norm(area)) * area;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3<double> across = cross(normal, t[(k + 1) % 3] - t[k]);
      inward[k] = (1 / norm(across)) * across;
      at_edge[k] = dot(inward[k], t[k]);
    }
  }
  // Of a point, or of several side by side.
  template <class S>
  DALEMBERT_INLINE S height(const Vec3<S>& point) const {
    return dot(normal, point - corner);
  }
  // How far a point is within the edge that it is nearest to, or outside of the one that it is farthest from, which is negative.
  double within_edges(const Vec3<double>& point) const {
    return std::min(dot(inward[0], point) - at_edge[0], std::min(dot(inward[1], point) - at_edge[1], dot(inward[2], point) - at_edge[2]));
  }
};

}  // namespace dalembert
