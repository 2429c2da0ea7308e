// Frames of symbols along an axis: rods, springs, arrows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

// Unit vectors x, y, z: z along the axis; x as near as it can be to `across`, or, without it or along it, to the axis of space that is
// least along z.
inline std::array<Vec3<double>, 3> frame_along(const Vec3<double>& axis,
                                               const std::optional<Vec3<double>>& across = {}) {
  constexpr double alike = 0.999;  // cosine
  const Vec3<double> z = (1 / std::max(std::sqrt(dot(axis, axis)), std::numeric_limits<double>::min())) * axis;
  Vec3<double> x{0, 0, 0};
  if (across && !(std::abs(dot(*across, z)) > alike)) {
    x = *across;
  } else {
    const std::array<double, 3> size{std::abs(z[0]), std::abs(z[1]), std::abs(z[2])};
    x[static_cast<int>(std::ranges::min_element(size) - size.begin())] = 1;
  }
  x = x - dot(x, z) * z;
  x = (1 / std::sqrt(dot(x, x))) * x;
  return {x, cross(z, x), z};
}

}  // namespace dalembert
