// Register functions of the files of bindings.
#pragma once

#include <pybind11/pybind11.h>

namespace dalembert {

namespace py = pybind11;

void register_enums(py::module_& module);        // enums.cpp
void register_module_functions(py::module_& module);  // module_functions.cpp
void register_containers(py::module_& module);   // containers.cpp
void register_settings(py::module_& module);     // settings.cpp
void register_system_data(py::module_& module);  // system_data.cpp
void register_solvers(py::module_& module);      // solvers.cpp
void register_ensemble(py::module_& module);     // ensemble.cpp
void register_evaluation(py::module_& module);   // evaluation.cpp: the submodule `testing`
void register_tree_functions(py::module_& module);  // tree_functions.cpp
void register_robot_kinematics(py::module_& module);  // robot_kinematics.cpp
void register_plain_arrays(py::module_& module);      // plain_arrays.cpp
void register_linear_solver(py::module_& module);  // linear_solver.cpp: in `testing`
void guard_objects(py::module_& module);           // object_guards.cpp: when all classes are there
void explain_wrong_calls(py::module_& module);     // wrong_calls.cpp: when all functions are there

}  // namespace dalembert
