// Operations on 3 x 3 matrices for bodies, over any scalar. Variants for registers: math/spread.hpp.
#pragma once

#include "dalembert/math/fixed.hpp"

namespace dalembert {

template <class S>
void set_column(Mat3<S>& m, int j, const Vec3<S>& v) {
  for (int i = 0; i < 3; ++i) m(i, j) = v[i];
}

// r m r^T of a symmetric matrix m.
template <class S>
Mat3<S> turned(const Mat3<S>& r, const Mat3<double>& symmetric) {
  const Mat3<S> m = r * symmetric;
  Mat3<S> result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column <= row; ++column)
      result(column, row) = result(row, column) =
          m(row, 0) * r(column, 0) + m(row, 1) * r(column, 1) + m(row, 2) * r(column, 2);
  return result;
}

// a x b + c x d.
template <class S>
Vec3<S> crosses(const Vec3<S>& a, const Vec3<S>& b, const Vec3<S>& c, const Vec3<S>& d) {
  return cross(a, b) + cross(c, d);
}

// m - a b^T.
template <class S>
Mat3<S> without_product(const Mat3<S>& m, const Vec3<S>& a, const Vec3<S>& b) {
  Mat3<S> result;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) result(row, column) = m(row, column) - a[row] * b[column];
  return result;
}

// The cross product of v with each column.
template <class S>
Mat3<S> crossed(const Vec3<S>& v, const Mat3<S>& m) {
  return {m(2, 0) * v[1] - m(1, 0) * v[2], m(2, 1) * v[1] - m(1, 1) * v[2], m(2, 2) * v[1] - m(1, 2) * v[2],
          m(0, 0) * v[2] - m(2, 0) * v[0], m(0, 1) * v[2] - m(2, 1) * v[0], m(0, 2) * v[2] - m(2, 2) * v[0],
          m(1, 0) * v[0] - m(0, 0) * v[1], m(1, 1) * v[0] - m(0, 1) * v[1], m(1, 2) * v[0] - m(0, 2) * v[1]};
}
// The matrix whose product with a vector is the cross product of v with it.
template <class S>
Mat3<S> crossed(const Vec3<S>& v) {
  const S none(0.0);
  return {none, -v[2], v[1], v[2], none, -v[0], -v[1], v[0], none};
}
// (a . b) I - a b^T.
template <class S>
Mat3<S> projection(const Vec3<S>& a, const Vec3<S>& b) {
  const S product = dot(a, b);
  return matrix_of<3, 3>([&](int i, int j) { return i == j ? product - a[i] * b[j] : -(a[i] * b[j]); });
}
template <class S>
Mat3<S> diagonal(const S& a) {
  const S none(0.0);
  return {a, none, none, none, a, none, none, none, a};
}

}  // namespace dalembert
