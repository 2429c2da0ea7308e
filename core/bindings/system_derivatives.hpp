// Derivatives of the equations of an assembled system, for exact sensitivities: testing.SystemDerivatives.
#pragma once

#include <pybind11/pybind11.h>

namespace dalembert {

namespace py = pybind11;

void register_system_derivatives(py::module_& testing);

}  // namespace dalembert
