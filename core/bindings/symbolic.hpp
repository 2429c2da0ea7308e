// Expressions of exu.symbolic as user functions that need no interpreter.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

namespace py = pybind11;

void register_symbolic(py::module_& module);

// A scalar expression; it converts to the number that it is now.
bool is_symbolic_real(PyObject* value);
// nullptr if `value` is no symbolic.UserFunction. Throws Refusal if it does not fit the user function that `row` describes.
std::shared_ptr<const Callback> symbolic_callback(PyObject* value, const Row& row);
// The symbolic.UserFunction behind a callback (borrowed reference), or nullptr.
PyObject* symbolic_function(const Callback& callback);

}  // namespace dalembert
