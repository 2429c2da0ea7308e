// Rotation vectors of increments: operators between increments and angular velocities.
#pragma once

#include <cmath>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

// x := (I + factor * skew(omega)) x
inline void rotate_by_half_step(double* x, const double* omega, double factor) {
  const double a = x[0], b = x[1], c = x[2];
  x[0] = a + factor * (omega[1] * c - omega[2] * b);
  x[1] = b + factor * (omega[2] * a - omega[0] * c);
  x[2] = c + factor * (omega[0] * b - omega[1] * a);
}

// p I + q skew(x) + r skew(x)^2
inline Mat<double, 3, 3> skew_polynomial(const double* x, double p, double q, double r) {
  const double n2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  const double skew[3][3] = {{0, -x[2], x[1]}, {x[2], 0, -x[0]}, {-x[1], x[0], 0}};
  Mat<double, 3, 3> m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      m(i, j) = (i == j ? p - r * n2 : 0.0) + q * skew[i][j] + r * x[i] * x[j];
    }
  }
  return m;
}

// Tangent operator of the exponential map of SO(3): angular velocity in the body frame = T(x) dx/dt.
inline Mat<double, 3, 3> tangent_operator(const double* x) {
  const double n2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], n = std::sqrt(n2);
  if (n < 1e-2) return skew_polynomial(x, 1, -0.5 + n2 / 24 - n2 * n2 / 720, 1.0 / 6 - n2 / 120 + n2 * n2 / 5040);
  return skew_polynomial(x, 1, (std::cos(n) - 1) / n2, (1 - std::sin(n) / n) / n2);
}

// Inverse of the tangent operator.
inline Mat<double, 3, 3> inverse_tangent_operator(const double* x) {
  const double n2 = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], n = std::sqrt(n2);
  if (n < 2e-2) return skew_polynomial(x, 1, 0.5, 1.0 / 12 + n2 / 720 + n2 * n2 / 30240);
  return skew_polynomial(x, 1, 0.5, (1 - 0.5 * n / std::tan(0.5 * n)) / n2);
}

}  // namespace dalembert
