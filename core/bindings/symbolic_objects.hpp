// The objects of exu.symbolic in Python, for the sources of this module.
#pragma once

#include <pybind11/pybind11.h>

#include <vector>

#include "dalembert/symbolic/expression.hpp"

namespace dalembert::symbolic {

namespace py = pybind11;

// Each object has an expression, which operators in place replace by another one.
struct Symbol {
  Node node;
};
struct Real : Symbol {};
struct Vector : Symbol {};
struct Matrix : Symbol {};

// The object of an expression. If nothing is recorded, it has only the value.
py::object wrap(Node node);
// nullptr if the value is no such object.
const Symbol* as_symbol(py::handle value);
// Converts the return value of a recorded function.
Node result_of(py::handle value);
// A number or an array.
py::object python_value(Shape shape, const std::vector<double>& values);

void register_user_functions(py::module_& module);

}  // namespace dalembert::symbolic
