// One state at a time with its vectors in registers: a number that fills a register of four, so that it multiplies vectors at once.
//
//     Spread a               | a  | a  | a  | a |
//     Vec3<Spread> v         | v0 | v1 | v2 | 0 |
//     a * v                  | a v0 | a v1 | a v2 | 0 |      in one instruction
//
// A matrix is three registers, its columns. Templates over the scalar that take vectors as wholes (sums, products, cross, dot, column)
// need a third of the instructions that they need with double; entries of vectors cannot be told apart. Like packs (math/pack.hpp), these are
// passed between inlined functions only.
#pragma once

#include "dalembert/math/fixed.hpp"
#include "dalembert/math/pack.hpp"

namespace dalembert {

struct Spread {
  Pack<4> x;

  DALEMBERT_INLINE Spread() = default;
  DALEMBERT_INLINE Spread(double all) : x(all) {}
  DALEMBERT_INLINE Spread(const Pack<4>& all) : x(all) {}
  DALEMBERT_INLINE friend Spread operator-(const Spread& a) { return -a.x; }
  DALEMBERT_INLINE friend Spread operator+(const Spread& a, const Spread& b) { return a.x + b.x; }
  DALEMBERT_INLINE friend Spread operator-(const Spread& a, const Spread& b) { return a.x - b.x; }
  DALEMBERT_INLINE friend Spread operator*(const Spread& a, const Spread& b) { return a.x * b.x; }
  DALEMBERT_INLINE friend Spread operator/(const Spread& a, const Spread& b) { return a.x / b.x; }
};

// Types of single numbers in a computation over S, and their conversion.
template <class S>
struct SingleNumber {
  using Type = S;
};
template <>
struct SingleNumber<Spread> {
  using Type = double;
};
template <class S>
using NumberOf = typename SingleNumber<S>::Type;
template <class S>
DALEMBERT_INLINE inline const S& number(const S& a) {
  return a;
}
DALEMBERT_INLINE inline double number(const Spread& a) { return a.x[0]; }

template <>
struct Vec<Spread, 3> {
  Pack<4> x{};

  DALEMBERT_INLINE Vec() = default;
  DALEMBERT_INLINE Vec(const Pack<4>& numbers) : x(numbers) {}
  DALEMBERT_INLINE Vec(const Vec<double, 3>& v) : x(Pack<4>::Register{v[0], v[1], v[2], 0}) {}
};
template <>
struct Mat<Spread, 3, 3> {
  std::array<Vec<Spread, 3>, 3> columns;

  DALEMBERT_INLINE Vec<Spread, 3>& operator[](std::size_t j) { return columns[j]; }
  DALEMBERT_INLINE const Vec<Spread, 3>& operator[](std::size_t j) const { return columns[j]; }
};

namespace spreads {

using Vector = Vec<Spread, 3>;
using Matrix = Mat<Spread, 3, 3>;

template <int... Lane>
DALEMBERT_INLINE inline Pack<4> shuffled(const Pack<4>& a) {
  return Pack<4>(__builtin_shufflevector(a.x, a.x, Lane...));
}
// Component k of a vector.
template <int k>
DALEMBERT_INLINE inline Spread component(const Vector& a) {
  return shuffled<k, k, k, k>(a.x);
}
DALEMBERT_INLINE inline Vector unit(std::size_t j) {
  return Pack<4>(Pack<4>::Register{j == 0 ? 1.0 : 0.0, j == 1 ? 1.0 : 0.0, j == 2 ? 1.0 : 0.0, 0});
}
template <class F>
DALEMBERT_INLINE inline Matrix each_column(const F& f) {
  return {{f(0), f(1), f(2)}};
}

}  // namespace spreads

DALEMBERT_INLINE inline Vec3<Spread> operator+(const Vec3<Spread>& a, const Vec3<Spread>& b) { return a.x + b.x; }
DALEMBERT_INLINE inline Vec3<Spread> operator+(const Vec3<Spread>& a, const Vec3<double>& b) {
  return a + Vec3<Spread>(b);
}
DALEMBERT_INLINE inline Vec3<Spread> operator-(const Vec3<Spread>& a, const Vec3<Spread>& b) { return a.x - b.x; }
DALEMBERT_INLINE inline Vec3<Spread>& operator+=(Vec3<Spread>& a, const Vec3<Spread>& b) { return a = a + b; }
DALEMBERT_INLINE inline Vec3<Spread>& operator-=(Vec3<Spread>& a, const Vec3<Spread>& b) { return a = a - b; }
DALEMBERT_INLINE inline Vec3<Spread>& operator-=(Vec3<Spread>& a, const Vec3<double>& b) {
  return a = a - Vec3<Spread>(b);
}
DALEMBERT_INLINE inline Vec3<Spread> operator*(const Spread& k, const Vec3<Spread>& a) { return k.x * a.x; }
DALEMBERT_INLINE inline Vec3<Spread> operator*(double k, const Vec3<Spread>& a) { return k * a.x; }
DALEMBERT_INLINE inline Spread dot(const Vec3<Spread>& a, const Vec3<Spread>& b) {
  using namespace spreads;
  const spreads::Vector products(a.x * b.x);
  return component<0>(products) + component<1>(products) + component<2>(products);
}
// Component i of the difference is component i + 2 of the product.
DALEMBERT_INLINE inline Vec3<Spread> cross(const Vec3<Spread>& a, const Vec3<Spread>& b) {
  using spreads::shuffled;
  return shuffled<1, 2, 0, 3>(a.x * shuffled<1, 2, 0, 3>(b.x) - b.x * shuffled<1, 2, 0, 3>(a.x));
}
DALEMBERT_INLINE inline Vec3<Spread> crosses(const Vec3<Spread>& a, const Vec3<Spread>& b, const Vec3<Spread>& c,
                                             const Vec3<Spread>& d) {
  using spreads::shuffled;
  const Pack<4> first = a.x * shuffled<1, 2, 0, 3>(b.x) - b.x * shuffled<1, 2, 0, 3>(a.x);
  return shuffled<1, 2, 0, 3>(first + (c.x * shuffled<1, 2, 0, 3>(d.x) - d.x * shuffled<1, 2, 0, 3>(c.x)));
}

DALEMBERT_INLINE inline Mat3<Spread> operator+(const Mat3<Spread>& a, const Mat3<Spread>& b) {
  return spreads::each_column([&](std::size_t j) { return a[j] + b[j]; });
}
DALEMBERT_INLINE inline Mat3<Spread> operator+(const Mat3<Spread>& a, const Mat3<double>& b) {
  return spreads::each_column([&](std::size_t j) { return a[j] + column(b, static_cast<int>(j)); });
}
DALEMBERT_INLINE inline Mat3<Spread> operator*(double k, const Mat3<Spread>& m) {
  return spreads::each_column([&](std::size_t j) { return k * m[j]; });
}
DALEMBERT_INLINE inline Vec3<Spread> operator*(const Mat3<Spread>& m, const Vec3<Spread>& v) {
  using namespace spreads;
  return component<0>(v) * m[0] + component<1>(v) * m[1] + component<2>(v) * m[2];
}
DALEMBERT_INLINE inline Vec3<Spread> operator*(const Mat3<Spread>& m, const Vec3<double>& v) {
  return v[0] * m[0] + v[1] * m[1] + v[2] * m[2];
}
DALEMBERT_INLINE inline Mat3<Spread> operator*(const Mat3<Spread>& a, const Mat3<double>& b) {
  return spreads::each_column([&](std::size_t j) { return a * column(b, static_cast<int>(j)); });
}
DALEMBERT_INLINE inline Mat3<Spread> operator*(const Mat3<Spread>& a, const Mat3<Spread>& b) {
  return spreads::each_column([&](std::size_t j) { return a * b[j]; });
}
DALEMBERT_INLINE inline Mat3<Spread> transpose(const Mat3<Spread>& m) {
  using Register = Pack<4>::Register;
  const Register none{}, a = m[0].x.x, b = m[1].x.x, c = m[2].x.x;
  const Register even = __builtin_shufflevector(a, b, 0, 4, 2, 6), odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Register even_c = __builtin_shufflevector(c, none, 0, 4, 2, 6),
                 odd_c = __builtin_shufflevector(c, none, 1, 5, 3, 7);
  return {{Pack<4>(__builtin_shufflevector(even, even_c, 0, 1, 4, 5)),
           Pack<4>(__builtin_shufflevector(odd, odd_c, 0, 1, 4, 5)),
           Pack<4>(__builtin_shufflevector(even, even_c, 2, 3, 6, 7))}};
}
DALEMBERT_INLINE inline Vec3<Spread> transposed_times(const Mat3<Spread>& m, const Vec3<Spread>& v) {
  return transpose(m) * v;
}
DALEMBERT_INLINE inline Vec3<Spread> column(const Mat3<Spread>& m, int j) { return m[static_cast<std::size_t>(j)]; }
DALEMBERT_INLINE inline void set_column(Mat3<Spread>& m, int j, const Vec3<Spread>& v) {
  m[static_cast<std::size_t>(j)] = v;
}

// r m r^T, m - a b^T, a x m, diag(a, a, a), (a . b) I - a b^T and the matrix of v x, as math/tensors.hpp has them for other scalars.
DALEMBERT_INLINE inline Mat3<Spread> turned(const Mat3<Spread>& r, const Mat3<double>& symmetric) {
  using namespace spreads;
  const Mat3<Spread> m = r * symmetric;
  return {{component<0>(r[0]) * m[0] + component<0>(r[1]) * m[1] + component<0>(r[2]) * m[2],
           component<1>(r[0]) * m[0] + component<1>(r[1]) * m[1] + component<1>(r[2]) * m[2],
           component<2>(r[0]) * m[0] + component<2>(r[1]) * m[1] + component<2>(r[2]) * m[2]}};
}
DALEMBERT_INLINE inline Mat3<Spread> without_product(const Mat3<Spread>& m, const Vec3<Spread>& a,
                                                     const Vec3<Spread>& b) {
  using namespace spreads;
  return {{m[0] - component<0>(b) * a, m[1] - component<1>(b) * a, m[2] - component<2>(b) * a}};
}
DALEMBERT_INLINE inline Mat3<Spread> crossed(const Vec3<Spread>& v, const Mat3<Spread>& m) {
  return spreads::each_column([&](std::size_t j) { return cross(v, m[j]); });
}
DALEMBERT_INLINE inline Mat3<Spread> crossed(const Vec3<Spread>& v) {
  return spreads::each_column([&](std::size_t j) { return cross(v, spreads::unit(j)); });
}
DALEMBERT_INLINE inline Mat3<Spread> diagonal(const Spread& a) {
  return spreads::each_column([&](std::size_t j) { return a * spreads::unit(j); });
}

DALEMBERT_INLINE inline Mat3<Spread> projection(const Vec3<Spread>& a, const Vec3<Spread>& b) {
  return without_product(diagonal(dot(a, b)), a, b);
}

}  // namespace dalembert
