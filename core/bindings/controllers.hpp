// Controllers of Python (dalembert.control) in the place of user functions of forces.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>

#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/row.hpp"
#include "dalembert/solvers/schedule.hpp"

namespace dalembert {

namespace py = pybind11;

class MainSystem;

// Returns nullptr if `value` is not a controller. Throws Refusal if the parameter of `row` cannot be a controller.
std::shared_ptr<const Callback> controller_callback(PyObject* value, const Row& row);
bool is_sampled(const Callback& callback);
// Returns the schedule of all sampled controllers in a system, or nullptr if there are none.
std::shared_ptr<Schedule> schedule_of(const std::shared_ptr<MainSystem>& main);

void register_controllers(py::module_& module);

}  // namespace dalembert
