#include "sequence.hpp"

#include <algorithm>
#include <array>

#include "index_types.hpp"
#include "python_errors.hpp"
#include "symbolic.hpp"

namespace dalembert {
namespace {

[[noreturn]] void refuse_type(std::string expected, std::string advice = {}) {
  throw Refusal{ErrorKind::type, std::move(expected), std::move(advice)};
}

double finite(double value) {
  if (!std::isfinite(value))
    throw Refusal{ErrorKind::value, "a finite number", "Check the calculation that the value comes from."};
  return value;
}

bool is_array(PyObject* value) { return py::isinstance<py::array>(value); }

bool is_numpy_scalar(PyObject* value) {
  return std::string_view(Py_TYPE(value)->tp_name).starts_with("numpy.") && !is_array(value);
}

bool is_scalar_array(PyObject* value) {
  return is_array(value) && py::reinterpret_borrow<py::array>(value).ndim() == 0;
}

// Number-like objects that are not Python numbers.
bool is_other_number(PyObject* value) {
  return is_numpy_scalar(value) || is_scalar_array(value) || is_symbolic_real(value);
}

double slow_real(PyObject* value) {
  ItemKind kind{};
  int number = 0;
  if (read_index(value, kind, number) || !is_other_number(value) || PyComplex_Check(value) ||
      PyNumber_Check(value) == 0)
    refuse_type("a number");
  PyObject* converted = PyNumber_Float(value);
  if (converted == nullptr) {
    PyErr_Clear();
    refuse_type("a number");
  }
  const double real = PyFloat_AS_DOUBLE(converted);
  Py_DECREF(converted);
  return finite(real);
}

bool read_plain_list(PyObject* const* items, std::span<double> out) {
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (PyFloat_CheckExact(items[i])) {
      out[i] = PyFloat_AS_DOUBLE(items[i]);
      continue;
    }
    int overflow = 0;
    const long long whole = PyLong_CheckExact(items[i]) ? PyLong_AsLongLongAndOverflow(items[i], &overflow) : 0;
    if (!PyLong_CheckExact(items[i]) || overflow != 0) return false;
    out[i] = static_cast<double>(whole);
  }
  return true;
}

bool read_plain_array(PyObject* value, int dimensions, std::span<double> out) {
  const auto array = py::reinterpret_borrow<py::array>(value);
  const bool plain = array.ndim() == dimensions && static_cast<std::size_t>(array.size()) == out.size() &&
                     (array.flags() & py::array::c_style) != 0 && array.dtype().is(py::dtype::of<double>());
  if (plain) std::copy_n(static_cast<const double*>(array.data()), out.size(), out.begin());
  return plain;
}

constexpr Py_ssize_t largest_plain = 16;

PyObject* is_plain_vector(PyObject* size, PyObject* value) {
  std::array<double, largest_plain> numbers{};
  return guarded([&] {
    const auto count = static_cast<std::size_t>(PyLong_AsSsize_t(size));
    return PyBool_FromLong(read_plain_reals(value, 1, {numbers.data(), count}) ? 1 : 0);
  });
}

PyObject* plain_vectors(PyObject*, PyObject* size) {
  static PyMethodDef definition{
      "plain_vector", is_plain_vector, METH_O,
      "Whether the value is a list or tuple of so many finite floats or integers, or an array of floats."};
  const Py_ssize_t count = PyLong_AsSsize_t(size);
  if (PyErr_Occurred() != nullptr) return nullptr;
  if (count < 0 || count > largest_plain)
    return PyErr_Format(PyExc_TypeError, "_plain_vectors(size) takes sizes from 0 to %zd", largest_plain);
  return PyCFunction_New(&definition, size);
}

// Check for the most frequent types of numbers.
template <bool (*holds)(double)>
PyObject* is_plain_number(PyObject*, PyObject* value) {
  if (PyFloat_CheckExact(value)) {
    const double number = PyFloat_AS_DOUBLE(value);
    return PyBool_FromLong(std::isfinite(number) && holds(number) ? 1 : 0);
  }
  int overflow = 1;
  const long long whole = PyLong_CheckExact(value) ? PyLong_AsLongLongAndOverflow(value, &overflow) : 0;
  return PyBool_FromLong(overflow == 0 && holds(static_cast<double>(whole)) ? 1 : 0);
}

bool any_number(double) { return true; }
bool no_negative_number(double number) { return number >= 0; }
bool positive_number(double number) { return number > 0; }

}  // namespace

void register_plain_vectors(py::module_& module) {
  static PyMethodDef definitions[] = {
      {"_plain_vectors", plain_vectors, METH_O,
       "_plain_vectors(size, /)\n--\n\nA function that tells at once whether a value is a vector; if not, it may be "
       "one of another type."},
      {"_is_plain_number", is_plain_number<any_number>, METH_O,
       "_is_plain_number(value, /)\n--\n\nWhether a float or int is finite."},
      {"_is_plain_not_negative", is_plain_number<no_negative_number>, METH_O,
       "_is_plain_not_negative(value, /)\n--\n\nThe same, and not negative."},
      {"_is_plain_positive", is_plain_number<positive_number>, METH_O,
       "_is_plain_positive(value, /)\n--\n\nThe same, and positive."},
  };
  for (PyMethodDef& definition : definitions)
    module.add_object(definition.ml_name, py::reinterpret_steal<py::object>(PyCFunction_New(&definition, nullptr)));
}

bool read_plain_reals(PyObject* value, int dimensions, std::span<double> out) {
  if (out.empty()) return false;
  if (PyFloat_CheckExact(value)) {
    out[0] = PyFloat_AS_DOUBLE(value);
    return dimensions == 0 && std::isfinite(out[0]);
  }
  bool plain = false;
  if (PyList_CheckExact(value) || PyTuple_CheckExact(value)) {
    plain = dimensions == 1 && static_cast<std::size_t>(Py_SIZE(value)) == out.size() &&
            read_plain_list(PySequence_Fast_ITEMS(value), out);
  } else if (dimensions > 0 && is_array(value)) {
    plain = read_plain_array(value, dimensions, out);
  }
  return plain && std::ranges::all_of(out, [](double x) { return std::isfinite(x); });
}

bool is_number(PyObject* value) { return PyFloat_Check(value) || PyLong_Check(value) || is_other_number(value); }

double read_real(PyObject* value) {
  if (PyFloat_Check(value)) return finite(PyFloat_AS_DOUBLE(value));
  if (PyLong_Check(value)) {
    const double real = PyLong_AsDouble(value);
    if (real == -1.0 && PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw Refusal{ErrorKind::value, "a number that double precision can hold", ""};
    }
    return real;
  }
  return slow_real(value);
}

int read_integer(PyObject* value) {
  ItemKind kind{};
  int number = 0;
  if (!PyLong_Check(value)) {
    if (read_index(value, kind, number)) refuse_type("an integer", "Item numbers do not belong here.");
    if (std::string_view(Py_TYPE(value)->tp_name).starts_with("numpy.bool")) return PyObject_IsTrue(value);
    if (PyIndex_Check(value) == 0 || (is_array(value) && !is_scalar_array(value)))
      refuse_type("an integer",
                  PyFloat_Check(value) ? "Write it without a decimal point, or convert it with int(...)." : "");
  }
  const Py_ssize_t wide = PyNumber_AsSsize_t(value, PyExc_OverflowError);
  if (wide == -1 && PyErr_Occurred() != nullptr) {
    const bool overflow = PyErr_ExceptionMatches(PyExc_OverflowError) != 0;
    PyErr_Clear();
    if (!overflow) refuse_type("an integer");
    throw Refusal{ErrorKind::value, "an integer of 32 bits", ""};
  }
  if (wide > 0x7fffffff || wide < -0x7fffffff) throw Refusal{ErrorKind::value, "an integer of 32 bits", ""};
  return static_cast<int>(wide);
}

bool holds_truth_values(PyObject* value) {
  if (PyBool_Check(value)) return true;
  if (is_array(value)) return py::reinterpret_borrow<py::array>(value).dtype().kind() == 'b';
  if (PyList_Check(value) || PyTuple_Check(value)) {
    const std::span<PyObject* const> items(PySequence_Fast_ITEMS(value),
                                           static_cast<std::size_t>(PySequence_Fast_GET_SIZE(value)));
    return std::ranges::any_of(items, holds_truth_values);
  }
  return std::string_view(Py_TYPE(value)->tp_name).starts_with("numpy.bool");
}

bool is_number_array(PyObject* value) {
  if (!is_array(value)) return false;
  const char kind = py::reinterpret_borrow<py::array>(value).dtype().kind();
  return kind == 'f' || kind == 'i' || kind == 'u' || kind == 'b';
}

Items::Items(PyObject* value, const std::string& what) {
  if (PyList_CheckExact(value) || PyTuple_CheckExact(value)) {
    fast_ = py::reinterpret_borrow<py::object>(value);
    return;
  }
  if (PyUnicode_Check(value) || PyBytes_Check(value) || PyDict_Check(value) || PyAnySet_Check(value) ||
      value == Py_None)
    refuse_type(what);
  if (is_scalar_array(value)) refuse_type(what);
  py::object source = py::reinterpret_borrow<py::object>(value);
  // Vector3DList and its relatives give their content this way.
  if (!is_array(value) && PyObject_HasAttrString(value, "GetPythonObject") != 0)
    source = source.attr("GetPythonObject")();
  PyObject* fast = PySequence_Fast(source.ptr(), "");
  if (fast == nullptr) {
    PyErr_Clear();
    refuse_type(what);
  }
  fast_ = py::reinterpret_steal<py::object>(fast);
}

Reals::Reals(PyObject* value, const std::string& what) {
  if (!is_number_array(value)) {
    items_.emplace(value, what);
    return;
  }
  const auto array = py::reinterpret_borrow<py::array>(value);
  if (array.ndim() != 1)
    throw Refusal{ErrorKind::value, what, "Pass an array with one dimension, e.g. by its method flatten()."};
  array_ = py::array_t<double, py::array::forcecast>::ensure(value);
}

void Reals::copy_to(double* out, const std::string& what) const {
  const Py_ssize_t n = size();
  if (array_) {
    const auto view = array_->unchecked<1>();
    for (Py_ssize_t i = 0; i < n; ++i) out[i] = view(i);
    for (Py_ssize_t i = 0; i < n; ++i)
      if (!std::isfinite(out[i]))
        throw Refusal{ErrorKind::value, what, "Entry " + std::to_string(i) + " is not finite."};
    return;
  }
  for (Py_ssize_t i = 0; i < n; ++i) {
    try {
      out[i] = read_real((*items_)[i]);
    } catch (Refusal& refusal) {
      throw Refusal{refusal.kind, what,
                    "Entry " + std::to_string(i) + " is " + show((*items_)[i]) + ", not " + refusal.expected + "."};
    }
  }
}

}  // namespace dalembert
