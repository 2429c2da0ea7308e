// Item numbers as arguments of methods.
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "dalembert/model/item.hpp"

namespace dalembert {

class MainSystem;

// The number of an existing item; `method` is named in errors, e.g. "GetNodeOutput".
int item_number_argument(const MainSystem& main, ItemKind kind, PyObject* value, const std::string& method);

}  // namespace dalembert
