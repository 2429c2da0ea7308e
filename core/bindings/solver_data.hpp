// Counters, flags, times and diagnoses of solvers as Python objects.
#pragma once

#include <pybind11/pybind11.h>

#include "dalembert/solvers/error.hpp"

namespace dalembert {

namespace py = pybind11;

void register_solver_data(py::module_& module);

// With the names of the attributes of SolverError.
py::dict diagnosis_dictionary(const Diagnosis& diagnosis);

}  // namespace dalembert
