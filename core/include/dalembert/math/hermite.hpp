// Cubic interpolation of a curve r(x), x = L xi, between two points with given slopes r'.
#pragma once

#include <array>

namespace dalembert::hermite {

// Shares of r0, r0', r1, r1' in r.
constexpr std::array<double, 4> values(double xi, double length) {
  const double rest = 1 - xi;
  return {rest * rest * (1 + 2 * xi), length * xi * rest * rest, xi * xi * (3 - 2 * xi), -length * xi * xi * rest};
}
// Shares of the chord (r1 - r0) / L and of both slopes in r' and in L r''.
constexpr std::array<double, 3> slope(double xi) {
  return {6 * xi * (1 - xi), (1 - xi) * (1 - 3 * xi), xi * (3 * xi - 2)};
}
constexpr std::array<double, 3> bend(double xi) { return {6 - 12 * xi, 6 * xi - 4, 6 * xi - 2}; }
// Shares of r0, r0', r1, r1' in r'.
constexpr std::array<double, 4> slopes(double xi, double length) {
  const auto h = slope(xi);
  return {-h[0] / length, h[1], h[0] / length, h[2]};
}

// Integrals of the shares in r along the curve, and of their products.
constexpr std::array<double, 4> integrals(double length) {
  return {length / 2, length * length / 12, length / 2, -length * length / 12};
}
constexpr std::array<std::array<double, 4>, 4> products(double length) {
  const double l = length, l2 = l * l;
  std::array<std::array<double, 4>, 4> m{{{156, 22 * l, 54, -13 * l},
                                          {22 * l, 4 * l2, 13 * l, -3 * l2},
                                          {54, 13 * l, 156, -22 * l},
                                          {-13 * l, -3 * l2, -22 * l, 4 * l2}}};
  for (auto& row : m)
    for (double& entry : row) entry *= l / 420;
  return m;
}

}  // namespace dalembert::hermite
