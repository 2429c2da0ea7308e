// Dual numbers: derivatives by forward automatic differentiation. They are exact up to round-off and need no heap.
//
// A Dual<N> is a value with its derivatives along N directions s_0, ..., s_(N-1):
//
//      x = (x.value; x.d[0], ..., x.d[N-1])             x.d[i] = dx/ds_i
//
// Each operation computes the value and, by the rules of differentiation, the derivatives; Dual::chain is the rule for functions of one variable:
//
//      x + y = (x + y; dx + dy)        x y = (x y; dx y + x dy)        f(x) = (f(x); f'(x) dx)
//
// A formula that is a template over its scalar S therefore differentiates itself: with S = double it gives the value, with S = Dual<N> also N columns
// of its Jacobian. seed(x, i) is a variable, with dx/ds_i = 1. A Dual made of a double is a constant, with derivatives of zero; operations with a plain
// double skip them.
//
// Example: the force f = t n of a spring between the origin and the point x = (3, 4), with the tension t = k (l - l_0), the length l = |x|, the
// direction n = x / l, the stiffness k = 10, and the length l_0 = 4 at rest (tests/core/dual.cpp compares these numbers with the closed form):
//
//      using S = Dual<2>;                                      //  value     d/dx_0   d/dx_1
//      const S x0 = S::seed(3, 0), x1 = S::seed(4, 1);         // (3; 1, 0)  and  (4; 0, 1)
//      const S l = sqrt(x0 * x0 + x1 * x1);                    //  5         0.6      0.8        the direction n: dl/dx = n^T
//      const S t = 10 * (l - 4);                               // 10         6        8          k n^T
//      const S f0 = t / l * x0, f1 = t / l * x1;               //  6         4.88     3.84       row 0 of df/dx
//                                                              //  8         3.84     7.12       row 1
//
// The rows are df/dx = k n n^T + (t / l) (I - n n^T): material and geometric stiffness, which nobody has written down.
//
// The tangent of the system is made in the same way (batches/port_sweep.hpp). Markers give the numbers of their frames with derivatives along the
// unknowns, 8 of them at a time (SweepDual), weighted as system/evaluation.hpp says; the kernel of a connector computes its forces f with these; and -J^T df
// is added to the matrix, as -J^T f is to the residual, with the Jacobian J of the markers.
//
// Rules for formulas:
// - Comparisons look at values alone, so a branch has the derivatives of that branch. At a kink they are those of one side.
// - sqrt and log have no derivative at zero: ask value_of(x) first, and give the limit there, as math/direction.hpp does.
// - Functions are found by their arguments: `using std::sqrt;` and then `sqrt(x)` works for double and Dual.
// - T is double, or again a Dual for derivatives of derivatives: contracts/variation.hpp takes the rate of a gap as Dual<1, S>.
//
// Griewank, Walther: Evaluating Derivatives, 2nd edition, SIAM 2008.
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
  friend constexpr Dual operator+(const Dual& a, double b) {
    Dual r = a;
    r.value = r.value + b;
    return r;
  }
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
