// Counters, flags, times and diagnoses of solvers as Python objects.
#pragma once

#include <pybind11/pybind11.h>

#include "dalembert/solvers/error.hpp"
#include "dalembert/solvers/constraint_rank.hpp"

namespace dalembert {

namespace py = pybind11;

void register_solver_data(py::module_& module);

// The keys are the attributes of SolverError.
py::dict diagnosis_dictionary(const Diagnosis& diagnosis);

// Data on redundant constraints.
py::dict redundancy_dictionary(const ConstraintRank& redundant, const System& system);

}  // namespace dalembert
