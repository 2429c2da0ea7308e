// Rotation parameters and their kinematics. Angular velocities are global unless a name says local.
//
// Shabana, Dynamics of Multibody Systems, chapter 2; Euler parameters: Nikravesh, Computer-Aided Analysis of Mechanical
// Systems, chapter 6; tangent of the exponential map: Bruels, Cardona & Arnold, Mech. Mach. Theory 48 (2012).
#pragma once

#include <array>
#include <cmath>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/fixed.hpp"
#include "dalembert/math/pack_functions.hpp"

namespace dalembert {

template <class S>
Mat3<S> skew(const Vec3<S>& v) {
  const S o(0);
  return {o, -v[2], v[1], v[2], o, -v[0], -v[1], v[0], o};
}

// ---- Euler parameters -----------------------------------------------------------------------------------------------
// Formulas for unit length. If the length drifts, as with velocity level constraints, the form of the diagonal
// matters.
template <class S>
Mat3<S> euler_parameters_rotation(const Vec<S, 4>& e) {
  const S &a = e[0], &b = e[1], &c = e[2], &d = e[3];
  return {1.0 - 2.0 * (c * c + d * d), 2.0 * (b * c - a * d),       2.0 * (b * d + a * c),
          2.0 * (b * c + a * d),       1.0 - 2.0 * (b * b + d * d), 2.0 * (c * d - a * b),
          2.0 * (b * d - a * c),       2.0 * (c * d + a * b),       1.0 - 2.0 * (b * b + c * c)};
}
// Derivatives of that matrix by the four parameters.
inline std::array<Mat3<double>, 4> euler_parameters_turn(const Vec<double, 4>& e) {
  const double a = 2 * e[0], b = 2 * e[1], c = 2 * e[2], d = 2 * e[3];
  return {Mat3<double>{0, -d, c, d, 0, -b, -c, b, 0}, Mat3<double>{0, c, d, c, -2 * b, -a, d, a, -2 * b},
          Mat3<double>{-2 * c, b, a, b, 0, d, -a, d, -2 * c}, Mat3<double>{-2 * d, -a, b, a, -2 * d, c, b, c, 0}};
}
// Angular velocity = G(e) de/dt.
template <class S>
Mat<S, 3, 4> euler_parameters_g(const Vec<S, 4>& e) {
  return {-2.0 * e[1], 2.0 * e[0],  -2.0 * e[3], 2.0 * e[2],  -2.0 * e[2], 2.0 * e[3],
          2.0 * e[0],  -2.0 * e[1], -2.0 * e[3], -2.0 * e[2], 2.0 * e[1],  2.0 * e[0]};
}
// The same in local axes.
template <class S>
Mat<S, 3, 4> euler_parameters_local_g(const Vec<S, 4>& e) {
  return {-2.0 * e[1], 2.0 * e[0], 2.0 * e[3],  -2.0 * e[2], -2.0 * e[2], -2.0 * e[3],
          2.0 * e[0],  2.0 * e[1], -2.0 * e[3], 2.0 * e[2],  -2.0 * e[1], 2.0 * e[0]};
}

// ---- Tait-Bryan angles, R = Rx(a) Ry(b) Rz(c) ----------------------------------------------------------------------
template <class S>
Mat3<S> tait_bryan_rotation(const Vec3<S>& angle) {
  using std::cos;
  using std::sin;
  const S s0 = sin(angle[0]), c0 = cos(angle[0]), s1 = sin(angle[1]), c1 = cos(angle[1]), s2 = sin(angle[2]),
          c2 = cos(angle[2]);
  return {c1 * c2,
          -(c1 * s2),
          s1,
          c0 * s2 + s0 * s1 * c2,
          c0 * c2 - s0 * s1 * s2,
          -(s0 * c1),
          s0 * s2 - c0 * s1 * c2,
          s0 * c2 + c0 * s1 * s2,
          c0 * c1};
}
// Angular velocity = G d(angle)/dt: columns are the axes of the three elementary rotations.
template <class S>
Mat3<S> tait_bryan_g(const Vec3<S>& angle) {
  using std::cos;
  using std::sin;
  const S s0 = sin(angle[0]), c0 = cos(angle[0]), s1 = sin(angle[1]), c1 = cos(angle[1]);
  const S o(0);
  return {S(1), o, s1, o, c0, -(s0 * c1), o, s0, c0 * c1};
}
// dG/dt d(angle)/dt, the part of the angular acceleration that is quadratic in the rates.
template <class S>
Vec3<S> tait_bryan_bias(const Vec3<S>& angle, const Vec3<S>& rate) {
  using std::cos;
  using std::sin;
  const S s0 = sin(angle[0]), c0 = cos(angle[0]), s1 = sin(angle[1]), c1 = cos(angle[1]);
  return {c1 * rate[1] * rate[2], -(s0 * rate[0] * rate[1]) + (s0 * s1 * rate[1] - c0 * c1 * rate[0]) * rate[2],
          c0 * rate[0] * rate[1] - (s0 * c1 * rate[0] + c0 * s1 * rate[1]) * rate[2]};
}
template <class S>
Vec3<S> tait_bryan_angles(const Mat3<S>& r) {
  using std::atan2;
  using std::sqrt;
  return {atan2(-r(1, 2), r(2, 2)), atan2(r(0, 2), sqrt(r(0, 0) * r(0, 0) + r(0, 1) * r(0, 1))),
          atan2(-r(0, 1), r(0, 0))};
}

// ---- rotation vectors ----------------------------------------------------------------------------------------------
// Even functions of the angle, as functions of its square, so that duals pass through zero: sin(x)/x,
// (1 - cos(x))/x^2 and (x - sin(x))/x^3.
struct RodriguesSeries {
  static constexpr double small = 1e-3;

  template <class S>
  static void terms(const S& angle_squared, S& sinc, S& versine, S& residue) {
    if (angle_squared < small)
      of_small(angle_squared, sinc, versine, residue);
    else
      of_others(angle_squared, sinc, versine, residue);
  }
  template <int N>
  DALEMBERT_INLINE static void terms(const Pack<N>& angle_squared, Pack<N>& sinc, Pack<N>& versine, Pack<N>& residue) {
    of_small(angle_squared, sinc, versine, residue);
    const auto is_small = less(angle_squared, Pack<N>(small));
    const Pack<N> others = Pack<N>::chosen(is_small, Pack<N>(), angle_squared);
    if (is_zero(others)) return;
    Pack<N> s, v, r;
    of_others(one_for_zero(others), s, v, r);
    sinc = Pack<N>::chosen(is_small, sinc, s);
    versine = Pack<N>::chosen(is_small, versine, v);
    residue = Pack<N>::chosen(is_small, residue, r);
  }

 private:
  template <class S>
  DALEMBERT_INLINE static void of_small(const S& x, S& sinc, S& versine, S& residue) {
    sinc = 1.0 + x * (-1.0 / 6 + x * (1.0 / 120 + x * (-1.0 / 5040 + x * (1.0 / 362880))));
    versine = 0.5 + x * (-1.0 / 24 + x * (1.0 / 720 + x * (-1.0 / 40320 + x * (1.0 / 3628800))));
    residue = 1.0 / 6 + x * (-1.0 / 120 + x * (1.0 / 5040 + x * (-1.0 / 362880 + x * (1.0 / 39916800))));
  }
  // Uses half the angle: 1 - cos(x) would lose digits.
  template <class S>
  DALEMBERT_INLINE static void of_others(const S& angle_squared, S& sinc, S& versine, S& residue) {
    using std::sqrt;
    const S half = 0.5 * sqrt(angle_squared);
    const auto [sine, cosine] = sine_cosine(half);
    const S sine_by_half = sine / half;
    sinc = sine_by_half * cosine;
    versine = 0.5 * (sine_by_half * sine_by_half);
    residue = (1.0 - sinc) / angle_squared;
  }
};
template <class S>
Mat3<S> rotation_vector_rotation(const Vec3<S>& v) {
  S sinc, versine, residue;
  RodriguesSeries::terms(dot(v, v), sinc, versine, residue);
  Mat3<S> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) r(i, j) = versine * v[i] * v[j];
  const S diagonal = 1.0 - versine * dot(v, v);
  for (int i = 0; i < 3; ++i) r(i, i) += diagonal;
  const Mat3<S> k = skew(v);
  for (int i = 0; i < 9; ++i) r.x[i] += sinc * k.x[i];
  return r;
}
// Inverse of the tangent of the exponential map: d(v)/dt for a local angular velocity w.
template <class S>
Vec3<S> rotation_vector_rate(const Vec3<S>& v, const Vec3<S>& w) {
  S sinc, versine, residue;
  const S square = dot(v, v);
  RodriguesSeries::terms(square, sinc, versine, residue);
  // (1 - (x/2) cot(x/2)) / x^2 = (versine - sinc/2) / (x^2 versine): the series avoids the cancellation near zero.
  S factor;
  if (square < 1e-3) {
    factor = 1.0 / 12 + square * (1.0 / 720 + square * (1.0 / 30240 + square * (1.0 / 1209600)));
  } else {
    factor = (versine - 0.5 * sinc) / (square * versine);
  }
  const Vec3<S> vw = cross(v, w);
  return w + 0.5 * vw + factor * cross(v, vw);
}
// An angle from its sine, asin(x)/x in powers of x^2: accurate to rounding for squared sines below 0.01.
template <class S>
DALEMBERT_INLINE inline S small_angle_by_sine(const S& x) {
  const S x2 = x * x, x4 = x2 * x2;
  return (1.0 + x * (1.0 / 6) + x2 * (3.0 / 40 + x * (15.0 / 336))) +
         x4 * (105.0 / 3456 + x * (945.0 / 42240) + x2 * (10395.0 / 599040 + x * (135135.0 / 9676800)));
}
// Rotation vector of a rotation matrix, angle below pi: series near zero, where the angle itself has no derivative.
template <class S>
Vec3<S> rotation_vector_of(const Mat3<S>& r) {
  using std::atan2;
  using std::sqrt;
  const Vec3<S> sine_axis{0.5 * (r(2, 1) - r(1, 2)), 0.5 * (r(0, 2) - r(2, 0)), 0.5 * (r(1, 0) - r(0, 1))};
  const S square = dot(sine_axis, sine_axis), cosine = 0.5 * (r(0, 0) + r(1, 1) + r(2, 2) - 1.0);
  if (square < 1e-4 && cosine > 0.0) return small_angle_by_sine(square) * sine_axis;
  const S sine = sqrt(square);
  return (atan2(sine, cosine) / sine) * sine_axis;
}

// Rotation about z.
template <class S>
Mat3<S> planar_rotation(const S& angle) {
  using std::cos;
  using std::sin;
  const S s = sin(angle), c = cos(angle), o(0);
  return {c, -s, o, s, c, o, o, o, S(1)};
}

}  // namespace dalembert
