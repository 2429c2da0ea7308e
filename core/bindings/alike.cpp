#include "alike.hpp"

#include <pybind11/numpy.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "item_equality.hpp"

namespace dalembert {
namespace {

namespace py = pybind11;

constexpr std::size_t remembered = 8;  // looks, the one that was found last in front

bool same_graphics(py::handle a, py::handle b);

bool same_sequence(py::handle a, py::handle b) {
  const py::ssize_t size = PySequence_Fast_GET_SIZE(a.ptr());
  if (size != PySequence_Fast_GET_SIZE(b.ptr())) return false;
  PyObject **x = PySequence_Fast_ITEMS(a.ptr()), **y = PySequence_Fast_ITEMS(b.ptr());
  for (py::ssize_t i = 0; i < size; ++i)
    if (!same_graphics(x[i], y[i])) return false;
  return true;
}

bool same_dictionary(py::handle a, py::handle b) {
  if (PyDict_Size(a.ptr()) != PyDict_Size(b.ptr())) return false;
  PyObject *key = nullptr, *value = nullptr;
  py::ssize_t place = 0;
  while (PyDict_Next(a.ptr(), &place, &key, &value) != 0) {
    PyObject* const other = PyDict_GetItemWithError(b.ptr(), key);
    if (other == nullptr || !same_graphics(value, other)) return false;
  }
  return true;
}

bool same_array(const py::array& a, const py::array& b) {
  const bool comparable = a.dtype().is(b.dtype()) && a.dtype().kind() != 'O' && a.ndim() == b.ndim() &&
                          std::equal(a.shape(), a.shape() + a.ndim(), b.shape());
  constexpr int packed = py::array::c_style;
  return comparable && (a.flags() & b.flags() & packed) != 0 &&
         std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.nbytes())) == 0;
}

// Compares lists, tuples, dictionaries and arrays of numbers by their contents, other objects by ==.
bool same_graphics(py::handle a, py::handle b) {
  if (a.is(b)) return true;
  if (Py_TYPE(a.ptr()) != Py_TYPE(b.ptr())) return false;
  if (PyList_Check(a.ptr()) || PyTuple_Check(a.ptr())) return same_sequence(a, b);
  if (PyDict_Check(a.ptr())) return same_dictionary(a, b);
  if (py::isinstance<py::array>(a))
    return same_array(py::reinterpret_borrow<py::array>(a), py::reinterpret_borrow<py::array>(b));
  const int equal = PyObject_RichCompareBool(a.ptr(), b.ptr(), Py_EQ);
  if (equal < 0) PyErr_Clear();
  return equal == 1;
}

bool look_alike(const Item& a, const Item& b) {
  if (a.type != b.type) return false;
  return std::ranges::all_of(a.type->rows, [&](const Row& row) {
    if (row.role != Role::visualization) return true;
    if (row.storage != Storage::opaque) return equal_members(row, a.record.get(), b.record.get());
    const auto object = [&](const Item& item) {
      return opaque_object(*static_cast<const Opaque*>(member(item.record.get(), row)));
    };
    PyObject *const one = object(a), *const other = object(b);
    return one == other || (one != nullptr && other != nullptr && same_graphics(one, other));
  });
}

}  // namespace

std::vector<std::int32_t> alike(const Model& model, ItemKind kind) {
  std::vector<std::int32_t> first(static_cast<std::size_t>(model.count(kind)));
  std::vector<int> known;
  for (int i = 0; i < model.count(kind); ++i) {
    const Item& item = model.item(kind, i);
    const auto found = std::ranges::find_if(known, [&](int one) { return look_alike(model.item(kind, one), item); });
    const bool is_new = found == known.end();
    first[static_cast<std::size_t>(i)] = is_new ? i : *found;
    if (is_new) {
      if (known.size() == remembered) known.pop_back();
      known.insert(known.begin(), i);
    } else {
      std::rotate(known.begin(), found, found + 1);
    }
  }
  return first;
}

}  // namespace dalembert
