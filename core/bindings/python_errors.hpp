// Conversion of core errors to Python exceptions, and formatting of values in error texts.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "dalembert/model/errors.hpp"

namespace dalembert {

namespace py = pybind11;

// Set the Python error that belongs to the C++ exception being handled; call inside catch (...).
void set_python_error() noexcept;

// Runs `f`, which returns a new reference; a C++ exception sets the Python error and returns nullptr.
template <class F>
PyObject* guarded(F&& f) noexcept {
  try {
    return f();
  } catch (...) {
    set_python_error();
    return nullptr;
  }
}
// The same for slots that return 0 or -1.
template <class F>
int guarded_status(F&& f) noexcept {
  try {
    f();
    return 0;
  } catch (...) {
    set_python_error();
    return -1;
  }
}

// "[1, 2] (list of length 2)", shortened when long.
std::string show(PyObject* value);
std::string to_string(PyObject* text);  // argument: a str

void register_errors(py::module_& module);

}  // namespace dalembert
