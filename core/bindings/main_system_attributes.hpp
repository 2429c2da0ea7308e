// How attributes of a MainSystem are found. Bound in main_system_attributes.cpp.
#pragma once

#include <pybind11/pybind11.h>

#include <array>

#include "dalembert/model/item.hpp"

namespace dalembert {

namespace py = pybind11;

using AddItem = PyObject* (*)(PyObject* main_system, PyObject* item);  // Python calling convention

// Must be called before the class is ready: derived Python classes inherit the attribute lookup.
void explain_attributes_of(PyHeapTypeObject* type);
// The metaclass, which notices when a method is replaced.
py::object class_of_main_system();
// `add` by kind, as the class has them.
void register_main_system_attributes(py::module_& module, const py::object& main_system,
                                     const std::array<AddItem, item_kinds>& add);

}  // namespace dalembert
