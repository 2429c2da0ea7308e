// Sine and cosine together, for lane-parallel numbers, accurate to rounding: within an eighth of a turn the
// polynomials of fdlibm (Sun Microsystems, 1993), whose error is below 2^-57, after the nearest quarter turn has been
// subtracted in three parts (W. J. Cody, W. Waite, Software Manual for the Elementary Functions, 1980).
#pragma once

#include <array>
#include <bit>
#include <cmath>

#include "dalembert/math/pack.hpp"

namespace dalembert {

template <class S>
struct SineCosine {
  S sine, cosine;
};

// c0 + x (c1 + x (...)).
template <int N, std::size_t count>
DALEMBERT_INLINE inline Pack<N> polynomial(const std::array<double, count>& coefficients, const Pack<N>& x) {
  Pack<N> sum = x * Pack<N>(coefficients[count - 1]) + coefficients[count - 2];
  for (std::size_t k = count - 2; k-- > 0;) sum = x * sum + coefficients[k];
  return sum;
}

// Returns 1 in lanes whose angle is beyond the range of the series below, or NaN; `others` elsewhere.
template <int N>
DALEMBERT_INLINE inline Pack<N> one_if_large(const Pack<N>& angle, const Pack<N>& others) {
  return Pack<N>::chosen(less(magnitude(angle), Pack<N>(1e5)), others, Pack<N>(1.0));
}
template <int N>
DALEMBERT_INLINE inline SineCosine<Pack<N>> sine_cosine_of_any(const Pack<N>& angle) {
  return {Pack<N>::of_each([&angle](int lane) { return std::sin(angle[lane]); }),
          Pack<N>::of_each([&angle](int lane) { return std::cos(angle[lane]); })};
}
template <int N>
DALEMBERT_INLINE inline typename Pack<N>::Mask has_bit(const typename Pack<N>::Mask& integers, int bit) {
  if constexpr (N == 8)
    return integers << (63 - bit) >> 63;
  else
    return (integers & (1LL << bit)) != 0;
}
template <int N>
DALEMBERT_INLINE inline SineCosine<Pack<N>> sine_cosine_of_moderate(const Pack<N>& angle) {
  using Register = typename Pack<N>::Register;
  using Integers = typename Pack<N>::Mask;
  constexpr double to_integer = 6755399441055744.0;  // 1.5 * 2^52: the last bits of a sum with it are an integer
  // Parts of a quarter turn; products with the first two are exact.
  constexpr double quarter[] = {1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21};
  const Register shifted = angle.x * 0.6366197723675814 + to_integer, quarters = shifted - to_integer;
  const auto turns = std::bit_cast<Integers>(shifted);
  const Pack<N> x(((angle.x - quarters * quarter[0]) - quarters * quarter[1]) - quarters * quarter[2]), square = x * x;
  constexpr std::array sines{-0.166666666666666324348,  8.33333333332248946124e-3,  -1.98412698298579493134e-4,
                             2.75573137070700676789e-6, -2.50507602534068634195e-8, 1.58969099521155010221e-10};
  constexpr std::array cosines{0.0416666666666666019037,   -1.38888888888741095749e-3, 2.48015872894767294178e-5,
                               -2.75573143513906633035e-7, 2.08757232129817482790e-9,  -1.13596475577881948265e-11};
  const Pack<N> sine = x + x * (square * polynomial(sines, square)),
                cosine = (1.0 - 0.5 * square.x) + (square * (square * polynomial(cosines, square))).x;
  const Integers is_odd = has_bit<N>(turns, 0);
  const Pack<N> s = Pack<N>::chosen(is_odd, cosine, sine), c = Pack<N>::chosen(is_odd, sine, cosine);
  return {Pack<N>::chosen(has_bit<N>(turns, 1), -s, s), Pack<N>::chosen(has_bit<N>(turns + 1, 1), -c, c)};
}
// Lanes are independent.
template <int N>
DALEMBERT_INLINE inline SineCosine<Pack<N>> sine_cosine(const Pack<N>& angle) {
  const SineCosine<Pack<N>> moderate = sine_cosine_of_moderate(angle);
  const Pack<N> large = one_if_large(angle, Pack<N>());
  if (is_zero(large)) [[likely]]
    return moderate;
  const SineCosine<Pack<N>> any = sine_cosine_of_any(angle);
  const auto is_moderate = equal(large, Pack<N>());
  return {Pack<N>::chosen(is_moderate, moderate.sine, any.sine),
          Pack<N>::chosen(is_moderate, moderate.cosine, any.cosine)};
}
// Variant for one number, and with derivatives: both are computed once.
template <class S>
SineCosine<S> sine_cosine(const S& angle) {
  using std::cos;
  using std::sin;
  return {sin(angle), cos(angle)};
}
template <int N, class T>
SineCosine<Dual<N, T>> sine_cosine(const Dual<N, T>& angle) {
  const auto [sine, cosine] = sine_cosine(angle.value);
  return {angle.chain(sine, cosine), angle.chain(cosine, -sine)};
}
// The angle for given multiples of sine and cosine; 0 for two zeros. Polynomial of fdlibm's arc tangent (Sun
// Microsystems, 1993) for arguments up to 7/16; an eighth of a turn is subtracted from larger ones.
template <int N>
DALEMBERT_INLINE inline Pack<N> angle_of(const Pack<N>& sine, const Pack<N>& cosine) {
  using P = Pack<N>;
  // an eighth of a turn, and its rounding error
  constexpr double eighth = 7.85398163397448278999e-01, rest = 3.06161699786838301793e-17;
  constexpr std::array arc{3.33333333333329318027e-01,  -1.99999999998764832476e-01, 1.42857142725034663711e-01,
                           -1.11111104054623557880e-01, 9.09088713343650656196e-02,  -7.69187620504482999495e-02,
                           6.66107313738753120669e-02,  -5.83357013379057348645e-02, 4.97687799461593236017e-02,
                           -3.65315727442169155270e-02, 1.62858201153657823623e-02};
  const P a = magnitude(sine), b = magnitude(cosine);
  const auto is_steep = less(b, a);
  const P small = P::chosen(is_steep, b, a), large = P::chosen(is_steep, a, b);
  const auto is_middle = less(0.4375 * large, small);
  const P x = P::chosen(is_middle, small - large, small) / one_for_zero(P::chosen(is_middle, small + large, large)),
          square = x * x;
  P angle = x - x * (square * polynomial(arc, square));
  angle = P::chosen(is_middle, P(eighth) + (angle + rest), angle);
  angle = P::chosen(is_steep, P(2 * eighth) - (angle - 2 * rest), angle);
  angle = P::chosen(less(cosine, P()), P(4 * eighth) - (angle - 4 * rest), angle);
  return P::chosen(less(sine, P()), -angle, angle);
}
inline double angle_of(double sine, double cosine) { return std::atan2(sine, cosine); }
// keep(i, sine, cosine) for `count` angles, which are looked at together.
template <int N, class F>
DALEMBERT_INLINE inline void each_sine_cosine(const Pack<N>* angles, std::size_t count, const F& keep) {
  Pack<N> large;
  for (std::size_t i = 0; i < count; ++i) large = one_if_large(angles[i], large);
  const auto find = [&](const auto& of) DALEMBERT_INLINE {
    for (std::size_t i = 0; i < count; ++i) {
      const auto [sine, cosine] = of(angles[i]);
      keep(i, sine, cosine);
    }
  };
  if (is_zero(large))
    find([](const Pack<N>& angle) DALEMBERT_INLINE { return sine_cosine_of_moderate(angle); });
  else
    find([](const Pack<N>& angle) DALEMBERT_INLINE { return sine_cosine_of_any(angle); });
}

}  // namespace dalembert
