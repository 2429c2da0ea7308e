// Small vectors and matrices of fixed size, over any scalar.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace dalembert {

template <class S, int N>
struct Vec {
  std::array<S, N> x{};
  constexpr S& operator[](int i) { return x[i]; }
  constexpr const S& operator[](int i) const { return x[i]; }
  bool operator==(const Vec&) const = default;
};
template <class S>
using Vec3 = Vec<S, 3>;

template <class S, int R, int C>
struct Mat {
  std::array<S, R * C> x{};
  constexpr S& operator()(int i, int j) { return x[i * C + j]; }
  constexpr const S& operator()(int i, int j) const { return x[i * C + j]; }
  bool operator==(const Mat&) const = default;
};
template <class S>
using Mat3 = Mat<S, 3, 3>;

// Constructs entries f(i) and f(i, j) without initializing zeros first.
template <int N, class F>
constexpr auto vector_of(const F& f) {
  return [&f]<int... I>(std::integer_sequence<int, I...>) {
    return Vec<decltype(f(0)), N>{f(I)...};
  }(std::make_integer_sequence<int, N>{});
}
template <int R, int C, class F>
constexpr auto matrix_of(const F& f) {
  return [&f]<int... I>(std::integer_sequence<int, I...>) {
    return Mat<decltype(f(0, 0)), R, C>{f(I / C, I % C)...};
  }(std::make_integer_sequence<int, R * C>{});
}

// The scalar of a mixed expression, e.g. double * Dual<3> -> Dual<3>.
template <class A, class B>
using Mixed = decltype(std::declval<A>() * std::declval<B>());

template <class A, class B, int N>
constexpr auto operator+(const Vec<A, N>& a, const Vec<B, N>& b) {
  Vec<Mixed<A, B>, N> r;
  for (int i = 0; i < N; ++i) r[i] = a[i] + b[i];
  return r;
}
template <class A, class B, int N>
constexpr auto operator-(const Vec<A, N>& a, const Vec<B, N>& b) {
  Vec<Mixed<A, B>, N> r;
  for (int i = 0; i < N; ++i) r[i] = a[i] - b[i];
  return r;
}
template <class S, int N>
constexpr auto operator-(const Vec<S, N>& a) {
  Vec<S, N> r;
  for (int i = 0; i < N; ++i) r[i] = -a[i];
  return r;
}
template <class A, class B, int N>
constexpr auto& operator+=(Vec<A, N>& a, const Vec<B, N>& b) {
  for (int i = 0; i < N; ++i) a[i] = a[i] + b[i];
  return a;
}
template <class A, class B, int N>
constexpr auto& operator-=(Vec<A, N>& a, const Vec<B, N>& b) {
  for (int i = 0; i < N; ++i) a[i] = a[i] - b[i];
  return a;
}
template <class K, class S, int N>
constexpr auto operator*(const K& k, const Vec<S, N>& a) {
  Vec<Mixed<K, S>, N> r;
  for (int i = 0; i < N; ++i) r[i] = k * a[i];
  return r;
}
template <class A, class B, int N>
constexpr auto dot(const Vec<A, N>& a, const Vec<B, N>& b) {
  Mixed<A, B> r = a[0] * b[0];
  for (int i = 1; i < N; ++i) r = r + a[i] * b[i];
  return r;
}
template <class S, int N>
constexpr S norm(const Vec<S, N>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}
constexpr bool is_zero(double x) { return x == 0; }
constexpr bool is_zero(const Vec3<double>& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }
template <class A, class B>
constexpr auto cross(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<Mixed<A, B>>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class A, class B, int R, int C>
constexpr auto operator*(const Mat<A, R, C>& m, const Vec<B, C>& v) {
  Vec<Mixed<A, B>, R> r;
  for (int i = 0; i < R; ++i) {
    r[i] = m(i, 0) * v[0];
    for (int j = 1; j < C; ++j) r[i] = r[i] + m(i, j) * v[j];
  }
  return r;
}
// m^T v without forming the transpose.
template <class A, class B, int R, int C>
constexpr auto transposed_times(const Mat<A, R, C>& m, const Vec<B, R>& v) {
  Vec<Mixed<A, B>, C> r;
  for (int j = 0; j < C; ++j) {
    r[j] = m(0, j) * v[0];
    for (int i = 1; i < R; ++i) r[j] = r[j] + m(i, j) * v[i];
  }
  return r;
}
template <class A, class B, int R, int K, int C>
constexpr auto operator*(const Mat<A, R, K>& a, const Mat<B, K, C>& b) {
  Mat<Mixed<A, B>, R, C> r;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) {
      r(i, j) = a(i, 0) * b(0, j);
      for (int k = 1; k < K; ++k) r(i, j) = r(i, j) + a(i, k) * b(k, j);
    }
  return r;
}
template <class S, int R, int C>
constexpr auto transpose(const Mat<S, R, C>& m) {
  Mat<S, C, R> r;
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) r(j, i) = m(i, j);
  return r;
}
template <class A, class B, int R, int C>
constexpr auto operator+(const Mat<A, R, C>& a, const Mat<B, R, C>& b) {
  Mat<Mixed<A, B>, R, C> r;
  for (int i = 0; i < R * C; ++i) r.x[i] = a.x[i] + b.x[i];
  return r;
}
template <class A, class B, int R, int C>
constexpr auto operator-(const Mat<A, R, C>& a, const Mat<B, R, C>& b) {
  Mat<Mixed<A, B>, R, C> r;
  for (int i = 0; i < R * C; ++i) r.x[i] = a.x[i] - b.x[i];
  return r;
}
template <class S, int R, int C>
constexpr auto operator*(double k, const Mat<S, R, C>& m) {
  Mat<S, R, C> r;
  for (int i = 0; i < R * C; ++i) r.x[i] = k * m.x[i];
  return r;
}
template <class S, int R, int C>
constexpr Vec<S, R> column(const Mat<S, R, C>& m, int j) {
  Vec<S, R> r;
  for (int i = 0; i < R; ++i) r[i] = m(i, j);
  return r;
}
template <class S = double, int N = 3>
constexpr Mat<S, N, N> identity() {
  Mat<S, N, N> r;
  for (int i = 0; i < N; ++i) r(i, i) = S(1);
  return r;
}

// `size` entries of v from `start`.
template <int Size, class S, int N>
constexpr Vec<S, Size> segment(const Vec<S, N>& v, int start) {
  Vec<S, Size> r;
  for (int i = 0; i < Size; ++i) r[i] = v[start + i];
  return r;
}

// R x C entries of v from `start`, row by row.
template <int R, int C, class S, int N>
constexpr Mat<S, R, C> matrix_segment(const Vec<S, N>& v, int start) {
  return matrix_of<R, C>([&](int i, int j) { return v[start + i * C + j]; });
}
namespace detail {
template <class First, class... Rest>
constexpr auto entry_of(int i, const First& first, const Rest&... rest) {
  constexpr int size = static_cast<int>(std::tuple_size_v<std::remove_cvref_t<decltype(first.x)>>);
  if constexpr (sizeof...(Rest) > 0)
    if (i >= size) return entry_of(i - size, rest...);
  return first.x[static_cast<std::size_t>(i)];
}
}  // namespace detail
// The entries of vectors and matrices, one after the other.
template <class... Parts>
constexpr auto joined(const Parts&... parts) {
  return vector_of<(static_cast<int>(std::tuple_size_v<std::remove_cvref_t<decltype(parts.x)>>) + ...)>(
      [&](int i) { return detail::entry_of(i, parts...); });
}

template <class S, int N>
Vec<S, N> load(const S* from) {
  Vec<S, N> r;
  for (int i = 0; i < N; ++i) r[i] = from[i];
  return r;
}

}  // namespace dalembert
