// What each file of bindings adds to the module.
#pragma once

#include <pybind11/pybind11.h>

namespace dalembert {

void register_enums(pybind11::module_& module);        // enums.cpp
void register_containers(pybind11::module_& module);   // containers.cpp
void register_settings(pybind11::module_& module);     // settings.cpp
void register_system_data(pybind11::module_& module);  // system_data.cpp
void register_solvers(pybind11::module_& module);      // solvers.cpp

}  // namespace dalembert
