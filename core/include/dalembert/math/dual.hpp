// Dual<N, T>: a value and its N first derivatives. Forward mode, exact, no heap. T is double, or a dual for second derivatives.
#pragma once

#include <array>
#include <cmath>

namespace dalembert {

template <int N, class T = double>
struct Dual {
  T value{};
  std::array<T, N> d{};

  constexpr Dual() = default;
  constexpr Dual(double v) : value(v) {}
  constexpr Dual(const T& v)
    requires(!std::is_same_v<T, double>)
      : value(v) {}
  static constexpr Dual seed(const T& v, int i, double rate = 1) {
    Dual r(v);
    r.d[i] = T(rate);
    return r;
  }

  // f(value) with derivative df; the chain rule in one place.
  constexpr Dual chain(const T& f, const T& df) const {
    Dual r;
    r.value = f;
    for (int i = 0; i < N; ++i) r.d[i] = df * d[i];
    return r;
  }
  friend constexpr Dual operator-(const Dual& a) {
    Dual r;
    r.value = -a.value;
    for (int i = 0; i < N; ++i) r.d[i] = -a.d[i];
    return r;
  }
  friend constexpr Dual operator+(const Dual& a, const Dual& b) {
    Dual r;
    r.value = a.value + b.value;
    for (int i = 0; i < N; ++i) r.d[i] = a.d[i] + b.d[i];
    return r;
  }
  friend constexpr Dual operator-(const Dual& a, const Dual& b) {
    Dual r;
    r.value = a.value - b.value;
    for (int i = 0; i < N; ++i) r.d[i] = a.d[i] - b.d[i];
    return r;
  }
  friend constexpr Dual operator*(const Dual& a, const Dual& b) {
    Dual r;
    r.value = a.value * b.value;
    for (int i = 0; i < N; ++i) r.d[i] = a.d[i] * b.value + a.value * b.d[i];
    return r;
  }
  // Constants carry no derivatives: half the work.
  friend constexpr Dual operator+(const Dual& a, double b) { Dual r = a; r.value = r.value + b; return r; }
  friend constexpr Dual operator+(double a, const Dual& b) { return b + a; }
  friend constexpr Dual operator-(const Dual& a, double b) { return a + (-b); }
  friend constexpr Dual operator-(double a, const Dual& b) { return -b + a; }
  friend constexpr Dual operator*(const Dual& a, double b) {
    Dual r;
    r.value = a.value * b;
    for (int i = 0; i < N; ++i) r.d[i] = a.d[i] * b;
    return r;
  }
  friend constexpr Dual operator*(double a, const Dual& b) { return b * a; }
  friend constexpr Dual operator/(const Dual& a, double b) { return a * (1.0 / b); }
  friend constexpr Dual operator/(double a, const Dual& b) { return a * reciprocal(b); }
  friend constexpr Dual operator/(const Dual& a, const Dual& b) { return a * reciprocal(b); }
  friend constexpr Dual reciprocal(const Dual& a) {
    const T inverse = 1.0 / a.value;
    return a.chain(inverse, -(inverse * inverse));
  }
  constexpr Dual& operator+=(const Dual& b) { return *this = *this + b; }
  constexpr Dual& operator-=(const Dual& b) { return *this = *this - b; }
  constexpr Dual& operator*=(const Dual& b) { return *this = *this * b; }

  friend constexpr bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend constexpr bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend constexpr bool operator<(const Dual& a, double b) { return a.value < b; }
  friend constexpr bool operator>(const Dual& a, double b) { return a.value > b; }

  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const T r = sqrt(a.value);
    return a.chain(r, 0.5 / r);
  }
  friend Dual sin(const Dual& a) {
    using std::cos;
    using std::sin;
    return a.chain(sin(a.value), cos(a.value));
  }
  friend Dual cos(const Dual& a) {
    using std::cos;
    using std::sin;
    return a.chain(cos(a.value), -sin(a.value));
  }
  friend Dual exp(const Dual& a) {
    using std::exp;
    const T r = exp(a.value);
    return a.chain(r, r);
  }
  friend Dual log(const Dual& a) {
    using std::log;
    return a.chain(log(a.value), 1.0 / a.value);
  }
  friend Dual abs(const Dual& a) { return a < 0.0 ? -a : a; }
  friend Dual atan2(const Dual& y, const Dual& x) {
    using std::atan2;
    const T scale = 1.0 / (x.value * x.value + y.value * y.value);
    Dual r;
    r.value = atan2(y.value, x.value);
    for (int i = 0; i < N; ++i) r.d[i] = scale * (x.value * y.d[i] - y.value * x.d[i]);
    return r;
  }
};

inline double value_of(double x) { return x; }
template <int N, class T>
double value_of(const Dual<N, T>& x) {
  return value_of(x.value);
}

}  // namespace dalembert
