// NodeIndex, ObjectIndex, ...: item numbers with the kind of the item.
#pragma once

#include <pybind11/pybind11.h>

#include "dalembert/model/item.hpp"

namespace dalembert {

namespace py = pybind11;

PyObject* make_index(ItemKind kind, int number);  // new reference
// True if `value` is one of the index types; then kind and number are set.
bool read_index(PyObject* value, ItemKind& kind, int& number);

void register_index_types(py::module_& module);

}  // namespace dalembert
