// Symmetric 3 x 3 matrices with six entries.
#pragma once

#include "dalembert/math/fixed.hpp"

namespace dalembert {

template <class S>
struct Symmetric {
  std::array<S, 6> x{};  // xx, xy, xz, yy, yz, zz

  static constexpr std::size_t place(int i, int j) {
    const int low = i < j ? i : j, high = i < j ? j : i;
    return static_cast<std::size_t>(low == 0 ? high : low + high + 1);
  }
  constexpr S& operator()(int i, int j) { return x[place(i, j)]; }
  constexpr const S& operator()(int i, int j) const { return x[place(i, j)]; }
  constexpr Symmetric& operator+=(const Symmetric& m) {
    for (std::size_t k = 0; k < 6; ++k) x[k] = x[k] + m.x[k];
    return *this;
  }
};

template <class S>
constexpr Vec3<S> column(const Symmetric<S>& m, int j) {
  return {m(0, j), m(1, j), m(2, j)};
}
template <class S>
constexpr Vec3<S> operator*(const Symmetric<S>& m, const Vec3<S>& v) {
  return {m.x[0] * v[0] + m.x[1] * v[1] + m.x[2] * v[2], m.x[1] * v[0] + m.x[3] * v[1] + m.x[4] * v[2],
          m.x[2] * v[0] + m.x[4] * v[1] + m.x[5] * v[2]};
}
// m - a b^T, for vectors that are parallel.
template <class S>
constexpr void subtract_product(Symmetric<S>& m, const Vec3<S>& a, const Vec3<S>& b) {
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) m(i, j) = m(i, j) - a[i] * b[j];
}
// r m r^T of a rotation with these columns.
template <class S>
constexpr Symmetric<S> turned(const std::array<Vec3<S>, 3>& columns, const Symmetric<double>& m) {
  Symmetric<S> result;
  for (int k = 0; k < 3; ++k) {
    const Vec3<S>& column = columns[static_cast<std::size_t>(k)];
    const Vec3<S> product = m(0, k) * columns[0] + m(1, k) * columns[1] + m(2, k) * columns[2];
    for (int i = 0; i < 3; ++i)
      for (int j = i; j < 3; ++j)
        result(i, j) = k == 0 ? product[i] * column[j] : result(i, j) + product[i] * column[j];
  }
  return result;
}

}  // namespace dalembert
