// C functions as user functions: callbacks of numba, function pointers of ctypes, scipy.LowLevelCallable.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

namespace py = pybind11;

// nullptr if `value` is no C function. Throws Refusal if its signature is not that of the user function that `row` describes.
std::shared_ptr<const Callback> compiled_callback(PyObject* value, const Row& row);

// Functions of the main system, by name: "PreStep". An error text and nullptr are as above.
const void* compiled_system_function(PyObject* value, const std::string& name);

void register_compiled_functions(py::module_& module);

}  // namespace dalembert
