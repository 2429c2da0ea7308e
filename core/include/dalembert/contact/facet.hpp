// A triangle with derived data: its normal, and the side of its edges on which a point is.
#pragma once

#include <algorithm>

#include "dalembert/math/pack.hpp"
#include "dalembert/math/triangle.hpp"

namespace dalembert {

struct Facet {
  Vec3<double> corner, normal;  // unit normal
  std::array<Vec3<double>, 3> inward;  // unit vectors in the plane, perpendicular to the edges
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
  // Argument: a point, or several side by side.
  template <class S>
  DALEMBERT_INLINE S height(const Vec3<S>& point) const {
    return dot(normal, point - corner);
  }
  // How far a point is within the edge that it is nearest to, or outside of the one that it is farthest from, which is negative.
  double within_edges(const Vec3<double>& point) const {
    return std::min(dot(inward[0], point) - at_edge[0],
                    std::min(dot(inward[1], point) - at_edge[1], dot(inward[2], point) - at_edge[2]));
  }
};

}  // namespace dalembert
