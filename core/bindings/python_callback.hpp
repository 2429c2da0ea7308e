// User functions: Python callables behind the Callback interface of the core.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "dalembert/model/item.hpp"
#include "dalembert/reflection/callback.hpp"

namespace dalembert {

namespace py = pybind11;

class MainSystem;

// None and 0 mean no function; all other values must be callable. Throws Refusal.
UserFunction read_user_function(PyObject* value, const Row& row);
PyObject* function_of(const UserFunction& function);  // borrowed
// false if there is no function, or if compiled code evaluates it
bool needs_interpreter(const UserFunction& function);
// Access for the garbage collector: the Python function that this one owns, or nullptr; and its release.
PyObject* owned_function(const UserFunction& function);
void drop_function(const UserFunction& function);

// The record's functions as they must be in a system: they know which system to pass. Returns the record itself if it has
// no functions, else a changed copy.
std::shared_ptr<const void> bind_user_functions(const ItemType& type, std::shared_ptr<const void> record,
                                                MainSystem& main);
UserFunction bind_user_function(const ItemType& type, const UserFunction& function, MainSystem& main);

// Keeps the Python exception as it is and adds a note saying where it was raised and, if the function takes other arguments, how it
// is called; then throws py::error_already_set.
[[noreturn]] void throw_python_error(const std::string& where, const std::string& call = "");

}  // namespace dalembert
