// Expressions of exu.symbolic as user functions that need no interpreter.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dalembert/model/model.hpp"
#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

namespace py = pybind11;

void register_symbolic(py::module_& module);

// A scalar expression; it converts to the number that it is now.
bool is_symbolic_real(PyObject* value);
// nullptr if `value` is no symbolic.UserFunction. Throws Refusal if it does not fit the user function that `row` describes.
std::shared_ptr<const Callback> symbolic_callback(PyObject* value, const Row& row);
// A constant of a recorded function of an item, which 'springForceUserFunction.stiffness' names.
struct RecordedConstant {
  const Row& row;
  std::shared_ptr<const Callback> function;
  std::string name;
};
// The named constant, then those of the same name of other functions of the item, which belong to one law. Empty: the
// name has no dot. Throws ModelError if there is no such constant.
std::vector<RecordedConstant> constants_named(const Model& model, ItemKind kind, int number, std::string_view name);
// The name with its function of a constant that a function of the item has itself, unlike a variable of the program;
// empty: there is none.
std::string own_constant(const Model& model, ItemKind kind, int number, std::string_view name);
double constant_of(const Callback& function, const std::string& name);
// The function with another value of the constant.
py::object with_constant(const Callback& function, const std::string& name, double value);
// The symbolic.UserFunction behind a callback (borrowed reference), or nullptr.
PyObject* symbolic_function(const Callback& callback);

}  // namespace dalembert
