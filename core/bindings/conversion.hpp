// Conversion between Python objects and the members of records: one pair of converters per Storage.
#pragma once

#include <pybind11/numpy.h>

#include <string>
#include <vector>

#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

namespace py = pybind11;

// The reason why a value is rejected; the caller adds item and parameter and throws a ModelError.
struct Refusal {
  ErrorKind kind;
  std::string expected;
  std::string advice;
};

// Write `value` to the member that `row` describes. Throws Refusal; the member is unchanged then.
void from_python(PyObject* value, const Row& row, void* member);

// How a member comes out: fixed-size arrays of attributes are views that write through and keep `owner` alive.
enum class Form { copy, view };
PyObject* to_python(const Row& row, const void* member, Form form, PyObject* owner);  // new reference

// An enumeration that the module exports by that name, for arguments; kept for as long as the process lives.
class Enumeration {
 public:
  explicit Enumeration(const char* name);
  bool has(PyObject* value) const { return Py_TYPE(value) == type_ || PyObject_TypeCheck(value, type_); }
  static std::uint64_t number(PyObject* member) { return static_cast<std::uint64_t>(PyLong_AsLongLong(member)); }
  const char* const name;

 private:
  PyTypeObject* type_;
};

// A member of an enumeration, e.g. ("OutputVariableType", 2).
py::object enum_member(const char* name, std::uint64_t value);
// Suggests the enumeration member that a text probably means.
std::string member_advice(const std::string& enumeration, PyObject* value);
// The module `_core` itself.
py::handle core_module();
void set_core_module(py::module_& module);

// A new array of these numbers, by rows. The constructor of array_t makes a second one to copy from.
py::array_t<double> new_array(std::vector<py::ssize_t> shape, const double* numbers);

Opaque make_opaque(PyObject* object);         // keeps a reference
PyObject* opaque_object(const Opaque& value);  // borrowed; nullptr if empty

// 1-dimensional numbers, strictly: finite, no strings, no nested sequences. Throws Refusal.
std::vector<double> read_reals(PyObject* value);

}  // namespace dalembert
