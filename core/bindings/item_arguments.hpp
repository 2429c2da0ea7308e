// Item numbers and configurations as arguments of methods.
#pragma once

#include <pybind11/pybind11.h>

#include "dalembert/model/item.hpp"
#include "label.hpp"

namespace dalembert {

class MainSystem;

// The number of an existing item; `method` is named in errors, e.g. "GetNodeOutput".
int item_number_argument(const MainSystem& main, ItemKind kind, PyObject* value, const Label& method);

// Converts a configuration that has a state; numbers are rejected. `where` is the start of error texts, e.g.
// "mbs.GetNodeOutput(...)".
ConfigurationType configuration_argument(const py::object& value, const Label& where);

}  // namespace dalembert
