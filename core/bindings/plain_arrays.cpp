// Small arrays to floats and back, in a tenth of the time that numpy takes for its many other cases.
#include <pybind11/numpy.h>

#include <array>
#include <cmath>

#include "dalembert/model/value_checks.hpp"
#include "module.hpp"
#include "python_errors.hpp"

namespace dalembert::plain {
namespace {

constexpr std::size_t most_numbers = 36;  // 6 x 6

// A float, or an integer, which is exact below 2^53; nullptr: look closer.
PyObject* float_of(PyObject* number) {
  if (PyFloat_CheckExact(number)) return Py_NewRef(number);
  if (!PyLong_CheckExact(number)) return nullptr;
  int overflow = 0;
  const long long whole = PyLong_AsLongLongAndOverflow(number, &overflow);
  constexpr long long exact = 1LL << 53;
  return overflow == 0 && whole <= exact && whole >= -exact ? PyFloat_FromDouble(static_cast<double>(whole)) : nullptr;
}

PyObject* floats_of_list(PyObject* const* items, Py_ssize_t size) {
  PyObject* result = PyTuple_New(size);
  for (Py_ssize_t i = 0; i < size; ++i) {
    PyObject* number = float_of(items[i]);
    if (number == nullptr) {
      Py_DECREF(result);
      return PyErr_Occurred() != nullptr ? nullptr : Py_NewRef(Py_None);
    }
    PyTuple_SET_ITEM(result, i, number);
  }
  return result;
}

PyObject* floats_of_array(const py::array& array, const std::array<Py_ssize_t, 2>& shape, std::size_t dimensions) {
  bool fits = static_cast<std::size_t>(array.ndim()) == dimensions && array.dtype().is(py::dtype::of<double>());
  for (std::size_t i = 0; fits && i < dimensions; ++i) fits = array.shape(static_cast<py::ssize_t>(i)) == shape[i];
  if (!fits) return Py_NewRef(Py_None);
  const Py_ssize_t columns = dimensions == 2 ? shape[1] : 1, row_step = array.strides(0),
                   column_step = dimensions == 2 ? array.strides(1) : 0;
  const char* data = static_cast<const char*>(array.data());
  PyObject* result = PyTuple_New(shape[0] * columns);
  for (Py_ssize_t i = 0; i < shape[0]; ++i)
    for (Py_ssize_t j = 0; j < columns; ++j)
      PyTuple_SET_ITEM(result, i * columns + j,
                       PyFloat_FromDouble(*reinterpret_cast<const double*>(data + i * row_step + j * column_step)));
  return result;
}

PyObject* floats(PyObject*, PyObject* const* arguments, Py_ssize_t count) {
  return guarded([&]() -> PyObject* {
    if (count < 2 || count > 3)
      return PyErr_Format(PyExc_TypeError, "_floats(value, size) or _floats(value, rows, columns)");
    std::array<Py_ssize_t, 2> shape{};
    for (Py_ssize_t i = 1; i < count; ++i) shape[static_cast<std::size_t>(i - 1)] = PyLong_AsSsize_t(arguments[i]);
    if (PyErr_Occurred() != nullptr) return nullptr;
    PyObject* value = arguments[0];
    if (PyList_CheckExact(value) || PyTuple_CheckExact(value)) {
      if (count == 3 || PySequence_Fast_GET_SIZE(value) != shape[0]) return Py_NewRef(Py_None);
      return floats_of_list(PySequence_Fast_ITEMS(value), shape[0]);
    }
    if (!py::isinstance<py::array>(value)) return Py_NewRef(Py_None);
    return floats_of_array(py::reinterpret_borrow<py::array>(value), shape, static_cast<std::size_t>(count - 1));
  });
}

PyObject* array(PyObject*, PyObject* const* arguments, Py_ssize_t count) {
  return guarded([&]() -> PyObject* {
    const Py_ssize_t rows = count > 0 ? PyLong_AsSsize_t(arguments[0]) : -1;
    if (rows < 1 || count - 1 > static_cast<Py_ssize_t>(most_numbers) || (count - 1) % rows != 0)
      return PyErr_Occurred() != nullptr
                 ? nullptr
                 : PyErr_Format(PyExc_TypeError, "_array(rows, *numbers) takes as many numbers for each row");
    py::array_t<double> result =
        rows == 1 ? py::array_t<double>(count - 1) : py::array_t<double>({rows, (count - 1) / rows});
    double* to = result.mutable_data();
    for (Py_ssize_t i = 1; i < count; ++i) {
      *to = PyFloat_AsDouble(arguments[i]);
      if (*to++ == -1.0 && PyErr_Occurred() != nullptr) return nullptr;
    }
    return result.release().ptr();
  });
}

// An array of floats with so many rows and columns whose upper left part is a rotation matrix.
template <int n>
PyObject* is_rotation(PyObject*, PyObject* value) {
  return guarded([&]() -> PyObject* {
    if (!py::isinstance<py::array>(value)) return PyBool_FromLong(0);
    const auto array = py::reinterpret_borrow<py::array>(value);
    if (array.ndim() != 2 || array.shape(0) != n || array.shape(1) != n || !array.dtype().is(py::dtype::of<double>()))
      return PyBool_FromLong(0);
    const auto entry = [&, row_step = array.strides(0), column_step = array.strides(1)](int i, int j) {
      return *reinterpret_cast<const double*>(static_cast<const char*>(array.data()) + i * row_step + j * column_step);
    };
    Mat3<double> matrix;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        matrix(i, j) = entry(i, j);
        if (!std::isfinite(matrix(i, j))) return PyBool_FromLong(0);
      }
    for (int j = 0; n == 4 && j < 4; ++j)
      if (!(std::abs(entry(n - 1, j) - (j == 3 ? 1 : 0)) <= 1e-8)) return PyBool_FromLong(0);
    return PyBool_FromLong(judge_rotation(matrix).fit == Fit::right ? 1 : 0);
  });
}

template <class Function>
PyCFunction fast(Function function) {
  return reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(function));
}

}  // namespace
}  // namespace dalembert::plain

namespace dalembert {

void register_plain_arrays(py::module_& module) {
  static PyMethodDef definitions[] = {
      {"_floats", plain::fast(plain::floats), METH_FASTCALL,
       "_floats(value, /, *shape)\n--\n\nThe numbers of a vector, or of a matrix row by row, as a tuple; None: look "
       "closer, it may be one of another type."},
      {"_array", plain::fast(plain::array), METH_FASTCALL,
       "_array(rows, /, *numbers)\n--\n\nAn array of numbers: a vector, or, of more than one row, a matrix row by "
       "row."},
      {"_is_rotation", plain::is_rotation<3>, METH_O,
       "_is_rotation(value, /)\n--\n\nWhether a value is an array of floats with a rotation matrix."},
      {"_is_transformation", plain::is_rotation<4>, METH_O,
       "_is_transformation(value, /)\n--\n\nWhether a value is an array of floats with a homogeneous transformation."},
  };
  for (PyMethodDef& definition : definitions)
    module.add_object(definition.ml_name, py::reinterpret_steal<py::object>(PyCFunction_New(&definition, nullptr)));
}

}  // namespace dalembert
