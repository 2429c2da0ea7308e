// The exponential map of rotations and its derivatives, for dual numbers. Let T(v) be the tangent map: the spin of
// exp(v) in body axes is T(v) dv/dt. T(-v) is the transpose of T(v), and gives the angular velocity in the axes
// before the rotation. Bruels, Cardona & Arnold, Mech. Mach. Theory 48 (2012).
#pragma once

#include <array>

#include "dalembert/math/rotations.hpp"

namespace dalembert {

// T(v) w
template <class S, class W>
auto tangent_map(const Vec3<S>& v, const Vec3<W>& w) {
  S sinc, versine, residue;
  RodriguesSeries::terms(dot(v, v), sinc, versine, residue);
  const auto c = cross(v, w);
  return w - versine * c + residue * cross(v, c);
}

// The factor f(x) in T(v)^-1 w = w + v x w / 2 + f(v v) v x (v x w), which is (1 - a/2 cot(a/2)) / a^2 for the angle a, and df/dx.
template <class S>
struct InverseTangentFactor {
  S value, slope;

  explicit InverseTangentFactor(const S& x) {
    if (x < 1.0) {  // coefficients by Bernoulli numbers: the first omitted term is 1e-16
      constexpr std::array<double, 10> c{1. / 12,
                                         1. / 720,
                                         1. / 30240,
                                         1. / 1209600,
                                         1. / 47900160,
                                         691. / 1307674368000.,
                                         1. / 74724249600.,
                                         3617. / 10670622842880000.,
                                         43867. / 5109094217170944000.,
                                         174611. / 802857662698291200000.};
      value = S(c[9]);
      slope = S(9 * c[9]);
      for (int n = 8; n >= 0; --n) value = c[n] + x * value;
      for (int n = 8; n >= 1; --n) slope = n * c[n] + x * slope;
    } else {
      S sinc, versine, residue;
      RodriguesSeries::terms(x, sinc, versine, residue);
      const S scale = 1.0 / (x * versine), half = 0.5 / x;
      const S by_sinc = half * (1.0 - x * versine - sinc), by_versine = half * (sinc - 2.0 * versine);
      value = scale * (versine - 0.5 * sinc);
      slope = scale * (by_versine - 0.5 * by_sinc - value * (versine + x * by_versine));
    }
  }
};
// T(v)^-1 w
template <class S>
Vec3<S> inverse_tangent_map(const Vec3<S>& v, const Vec3<S>& w) {
  const Vec3<S> c = cross(v, w);
  return w + 0.5 * c + InverseTangentFactor<S>(dot(v, v)).value * cross(v, c);
}
// The gradient of n . T(v)^-1 w by v.
template <class S>
Vec3<S> inverse_tangent_gradient(const Vec3<S>& v, const Vec3<S>& w, const Vec3<S>& n) {
  const S x = dot(v, v), vw = dot(v, w), vn = dot(v, n), wn = dot(w, n);
  const InverseTangentFactor<S> f(x);
  const S along = 2.0 * (f.slope * (vw * vn - x * wn) - f.value * wn);
  return 0.5 * cross(w, n) + along * v + f.value * (vn * w + vw * n);
}

}  // namespace dalembert
