// The polynomials of ObjectANCFThinPlate: cubic along one direction, linear across. A. Adini, R. W. Clough, Analysis of plate
// bending by the finite element method, University of California, Berkeley, 1961.
#pragma once

#include <array>

#include "dalembert/math/hermite.hpp"

namespace dalembert {

// Shape functions on the square from -1 to 1, with corners in the order (-1, -1), (1, -1), (1, 1), (-1, 1).
struct PlateShape {
  using Shares = std::array<double, 12>;  // shares of position, slope in x and slope in y, node by node

  static constexpr std::array<double, 4> bilinear(double xi, double eta) {
    const auto x = linear(xi, 0), y = linear(eta, 0);
    return {x[0] * y[0], x[1] * y[0], x[1] * y[1], x[0] * y[1]};
  }
  // Derivatives of these orders by the coordinates; `x`, `y`: lengths that belong to unit slopes at the nodes.
  static constexpr Shares shares(double xi, double eta, const std::array<double, 4>& x, const std::array<double, 4>& y,
                                 int by_xi, int by_eta) {
    const auto line_x = linear(xi, by_xi), line_y = linear(eta, by_eta);
    const auto cubic_x = cubic(xi, by_xi), cubic_y = cubic(eta, by_eta);
    constexpr std::array right{0, 1, 1, 0}, upper{0, 0, 1, 1};
    Shares s{};
    for (int n = 0; n < 4; ++n) {
      const int i = right[n], j = upper[n];
      s[3 * n] = cubic_x[2 * i] * line_y[j] + cubic_y[2 * j] * line_x[i] - line_x[i] * line_y[j];
      s[3 * n + 1] = x[n] * cubic_x[2 * i + 1] * line_y[j];
      s[3 * n + 2] = y[n] * cubic_y[2 * j + 1] * line_x[i];
    }
    return s;
  }

 private:
  static constexpr std::array<double, 2> linear(double t, int derivative) {
    if (derivative == 0) return {0.5 * (1 - t), 0.5 * (1 + t)};
    if (derivative == 1) return {-0.5, 0.5};
    return {0, 0};
  }
  // Cubic polynomials for value and slope at both ends of a side of unit length.
  static constexpr std::array<double, 4> cubic(double t, int derivative) {
    const double s = 0.5 * (1 + t);
    if (derivative == 0) return hermite::values(s, 1);
    if (derivative == 1) {
      const auto h = hermite::slopes(s, 1);
      return {0.5 * h[0], 0.5 * h[1], 0.5 * h[2], 0.5 * h[3]};
    }
    const auto h = hermite::bend(s);
    return {-0.25 * h[0], 0.25 * h[1], 0.25 * h[0], 0.25 * h[2]};
  }
};

}  // namespace dalembert
