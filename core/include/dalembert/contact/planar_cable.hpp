// An element of a planar cable as contact sees it: a cubic curve, and where it lies in a circle.
#pragma once

#include <array>
#include <span>

#include "dalembert/math/fixed.hpp"

namespace dalembert {

// A stretch of the axis, by material coordinates (m).
struct Stretch1D {
  double begin = 0, end = 0;
};

struct CableShape {
  std::array<int, 8> dofs{};  // global coordinates: position and slope at both ends
  double length = 0;

  // Weights of the coordinates of position and slope at both ends, for a point of the axis.
  template <class S>
  std::array<S, 4> weights(const S& x) const {
    const S s = (1 / length) * x, s2 = s * s, s3 = s2 * s;
    return {1.0 - 3.0 * s2 + 2.0 * s3, length * (s - 2.0 * s2 + s3), 3.0 * s2 - 2.0 * s3, length * (s3 - s2)};
  }
  std::array<double, 4> slope_weights(double x) const {
    const double s = x / length, s2 = s * s;
    return {6 * (s2 - s) / length, 1 - 4 * s + 3 * s2, 6 * (s - s2) / length, 3 * s2 - 2 * s};
  }
  // The component of a vector of all coordinates, or of their rates, at a place.
  template <class S, class W>
  Vec<S, 2> at(const std::array<W, 4>& weights, const std::array<S, 8>& numbers) const {
    const auto component = [&](std::size_t i) {
      return weights[0] * numbers[i] + weights[1] * numbers[i + 2] + weights[2] * numbers[i + 4] +
             weights[3] * numbers[i + 6];
    };
    return {component(0), component(1)};
  }
  std::array<double, 8> numbers(const double* of_all) const;

  // Polynomials of the two components in x, lowest power first.
  std::array<std::array<double, 4>, 2> polynomials(const std::array<double, 8>& q) const;
};

// Zeros of a polynomial, lowest power first, of degree 6 at most, in [from, to], ascending; returns how many.
int real_zeros(std::span<const double> polynomial, double from, double to, std::array<double, 6>& zeros);

// Stretches of the axis that are nearer to a point than `radius`; returns how many, of three at most.
int stretches_within(const CableShape& cable, const std::array<double, 8>& q, const Vec<double, 2>& centre,
                     double radius, std::array<Stretch1D, 4>& stretches);

}  // namespace dalembert
