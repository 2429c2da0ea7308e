// Between Python objects and the members of records: one pair of converters per Storage.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

namespace py = pybind11;

// Why a value does not fit; whoever knows item and parameter makes a ModelError of it.
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

// A member of an enumeration that the module exports by that name, e.g. ("OutputVariableType", 2).
py::object enum_member(const char* name, std::uint32_t value);
// The module `_core` itself.
py::handle core_module();
void set_core_module(py::module_& module);

Opaque make_opaque(PyObject* object);         // keeps a reference
PyObject* opaque_object(const Opaque& value);  // borrowed; nullptr if empty

// 1-dimensional numbers, strictly: finite, no strings, no nested sequences. Throws Refusal.
std::vector<double> read_reals(PyObject* value);

}  // namespace dalembert
