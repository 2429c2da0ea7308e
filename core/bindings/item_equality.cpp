#include "item_equality.hpp"

#include <algorithm>

#include <pybind11/pybind11.h>

#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "python_callback.hpp"

namespace dalembert {
namespace {

template <class T>
bool same(const T& a, const T& b) {
  return a == b;
}
template <int N>
bool same(const Vec<double, N>& a, const Vec<double, N>& b) {
  return a.x == b.x;
}
template <int R, int C>
bool same(const Mat<double, R, C>& a, const Mat<double, R, C>& b) {
  return a.x == b.x;
}
template <class T>
bool same(const DynamicMatrix<T>& a, const DynamicMatrix<T>& b) {
  return a.rows == b.rows && a.columns == b.columns && std::ranges::equal(a.values, b.values);
}
template <class T>
  requires(is_vec<T> || is_mat<T>)
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const T& x, const T& y) { return x.x == y.x; });
}
bool same(const MatrixContainer& a, const MatrixContainer& b) {
  const auto equal = [](const MatrixContainer::Triplet& x, const MatrixContainer::Triplet& y) {
    return x.row == y.row && x.column == y.column && x.value == y.value;
  };
  return a.rows == b.rows && a.columns == b.columns && a.dense == b.dense && std::ranges::equal(a.values, b.values) &&
         std::ranges::equal(a.triplets, b.triplets, equal);
}
bool same(const UserFunction& a, const UserFunction& b) {
  return a.callback == b.callback || (a && b && function_of(a) == function_of(b));
}

// Numpy arrays in it make == ambiguous; then only the same object is equal. Objects of this module (beam sections) do
// not define ==; their texts show all that they hold.
bool same_python(PyObject* a, PyObject* b) {
  const int equal = a == b ? 1 : PyObject_RichCompareBool(a, b, Py_EQ);
  if (equal < 0) PyErr_Clear();
  if (equal == 1) return true;
  const bool own = Py_TYPE(a) == Py_TYPE(b) && PyObject_HasAttrString(a, "GetDictionary") != 0;
  return own && py::repr(a).equal(py::repr(b));
}

}  // namespace

bool equal_members(const Row& row, const void* record_a, const void* record_b) {
  if (row.storage == Storage::opaque) {
    const auto a = py::reinterpret_steal<py::object>(to_python(row, member(record_a, row), Form::copy, nullptr));
    const auto b = py::reinterpret_steal<py::object>(to_python(row, member(record_b, row), Form::copy, nullptr));
    return same_python(a.ptr(), b.ptr());
  }
  return with_type(row.storage, [&]<class T>(TypeTag<T>) {
    if constexpr (std::is_same_v<T, Opaque>) {
      return false;
    } else {
      return same(*static_cast<const T*>(member(record_a, row)), *static_cast<const T*>(member(record_b, row)));
    }
  });
}

}  // namespace dalembert
