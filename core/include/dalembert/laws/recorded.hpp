// Functions of laws that were recorded in Python, for kernels that are generated from them.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <type_traits>

#include "dalembert/math/dual.hpp"
#include "dalembert/math/piecewise_cubic.hpp"

namespace dalembert::recorded {

// Steps, which have no slope.
inline double round(double x) { return std::nearbyint(x); }  // halves to even numbers, as in Python
inline double sign(double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; }
inline double truncated_quotient(double x, double y) { return std::trunc(x / y); }
// The operator // of Python; its operator % is x - floored_quotient(x, y) y.
inline double floored_quotient(double x, double y) {
  const double r = std::fmod(x, y), remainder = r != 0 && (r < 0) != (y < 0) ? r + y : r;
  return std::round((x - remainder) / y);
}

// Returns a function value with its derivative. If x has zero derivatives, the result has zero derivatives, even where the
// slope is infinite, as that of a square root at zero.
template <class S>
S function(const S& x, double value, double slope) {
  if constexpr (std::is_same_v<S, double>) {
    return value;
  } else {
    S r(value);
    for (std::size_t i = 0; i < r.d.size(); ++i) r.d[i] = value_of(x.d[i]) == 0 ? 0.0 : slope * x.d[i];
    return r;
  }
}

#define DALEMBERT_RECORDED(name, slope)             \
  template <class S>                                \
  S name(const S& x) {                              \
    const double a = value_of(x), y = std::name(a); \
    return function(x, y, slope);                   \
  }
DALEMBERT_RECORDED(exp, y)
DALEMBERT_RECORDED(sqrt, 0.5 / y)
DALEMBERT_RECORDED(log, 1 / a)
DALEMBERT_RECORDED(sin, std::cos(a))
DALEMBERT_RECORDED(cos, -std::sin(a))
DALEMBERT_RECORDED(tan, 1 + y * y)
DALEMBERT_RECORDED(asin, 1 / std::sqrt(1 - a * a))
DALEMBERT_RECORDED(acos, -1 / std::sqrt(1 - a * a))
DALEMBERT_RECORDED(atan, 1 / (1 + a * a))
DALEMBERT_RECORDED(sinh, std::cosh(a))
DALEMBERT_RECORDED(cosh, std::sinh(a))
DALEMBERT_RECORDED(tanh, 1 - y * y)
DALEMBERT_RECORDED(asinh, 1 / std::sqrt(a * a + 1))
DALEMBERT_RECORDED(acosh, 1 / std::sqrt(a * a - 1))
DALEMBERT_RECORDED(atanh, 1 / (1 - a * a))
DALEMBERT_RECORDED(abs, a < 0 ? -1.0 : 1.0)
#undef DALEMBERT_RECORDED

template <class S, class E>
auto pow(const S& x, const E& exponent) {
  const double a = value_of(x), e = value_of(exponent), y = std::pow(a, e);
  if constexpr (std::is_same_v<E, double>) {
    return function(x, y, e * std::pow(a, e - 1));
  } else if constexpr (std::is_same_v<S, double>) {
    return function(exponent, y, y == 0 ? 0.0 : std::log(a) * y);
  } else {
    const S by_base = function(x, y, e * std::pow(a, e - 1));
    return by_base + (function(exponent, y, y == 0 ? 0.0 : std::log(a) * y) - y);
  }
}
// Roots of sums of squares: at zero the derivative is taken as zero.
template <class S>
S root_of_squares(const S& sum) {
  return value_of(sum) == 0 ? S(0.0) : sqrt(sum);
}

template <class S>
S table(const S& x, std::span<const double> numbers) {
  const auto [value, slope] = PiecewiseCubic(numbers).at(value_of(x));
  return function(x, value, slope);
}

}  // namespace dalembert::recorded
