// Read-only view of array-like arguments: lists, tuples, numpy arrays and list-like objects of the module.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>

#include "conversion.hpp"

namespace dalembert {

// Numbers as Python users write them. The result is finite. Throws Refusal.
double read_real(PyObject* value);
int read_integer(PyObject* value);

// Whether the value is a number of Python or numpy, and no array.
bool is_number(PyObject* value);

// Whether the value is True or False, of Python or numpy, or a list, tuple or array that has one in it.
bool holds_truth_values(PyObject* value);

// The usual cases without a detour: a float (no dimension), a list or tuple of floats (one), an array of float64 (one or two).
// False, with `out` undefined, if `value` is anything else, has another size or a number that is not finite.
bool read_plain_reals(PyObject* value, int dimensions, std::span<double> out);

// _is_plain_vector(value, size): the same for one dimension, as a function of the module.
void register_plain_vectors(py::module_& module);

// The objects in a list, a tuple, an array of objects or another sequence.
class Items {
 public:
  // The text describes the expectation, e.g. "3 numbers".
  Items(PyObject* value, const std::string& what);
  Py_ssize_t size() const { return PySequence_Fast_GET_SIZE(fast_.ptr()); }
  PyObject* operator[](Py_ssize_t i) const { return PySequence_Fast_GET_ITEM(fast_.ptr(), i); }

 private:
  py::object fast_;
};

// Numbers in one dimension. Arrays of numpy are read without making Python objects of their entries.
class Reals {
 public:
  Reals(PyObject* value, const std::string& what);
  Py_ssize_t size() const { return array_ ? array_->size() : items_->size(); }
  void copy_to(double* out, const std::string& what) const;

 private:
  std::optional<py::array_t<double>> array_;
  std::optional<Items> items_;
};

// A numpy array of numbers (booleans, integers, floating point), not of objects, strings or complex numbers.
bool is_number_array(PyObject* value);

}  // namespace dalembert
