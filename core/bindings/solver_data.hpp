// Counters, flags and times of solvers as Python objects.
#pragma once

#include <pybind11/pybind11.h>

namespace dalembert {

namespace py = pybind11;

void register_solver_data(py::module_& module);

}  // namespace dalembert
