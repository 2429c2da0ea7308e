// The compiled module; each file of bindings has one register function.
#include "module.hpp"

#include "compiled_callback.hpp"
#include "controllers.hpp"
#include "conversion.hpp"
#include "index_types.hpp"
#include "item_classes.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"
#include "symbolic.hpp"

namespace {

// The module creates thousands of objects and no garbage. Garbage collection would take a tenth of the time.
struct CollectorPause {
  const bool was_on = PyGC_Disable() != 0;
  ~CollectorPause() {
    if (was_on) PyGC_Enable();
  }
};

}  // namespace

PYBIND11_MODULE(_core, module) {
  using namespace dalembert;
  const CollectorPause pause;
  module.doc() = "Compiled part of dalembert: items, systems, settings and solvers.";
  module.attr("__version__") = DALEMBERT_VERSION;
  module.def("InvalidIndex", [] { return -1; }, "The value of an index that is not set.");

  set_core_module(module);
  register_errors(module);
  register_enums(module);  // comes first: enumerations are defaults of other functions
  register_module_functions(module);
  register_plain_vectors(module);
  register_containers(module);
  register_settings(module);
  register_index_types(module);
  register_items(module);
  register_main_system(module);
  register_system_data(module);
  register_general_contact(module);
  register_system_container(module);
  register_solvers(module);
  register_ensemble(module);
  register_evaluation(module);
  register_tree_functions(module);
  register_robot_kinematics(module);
  register_plain_arrays(module);
  register_linear_solver(module);
  register_symbolic(module);
  register_compiled_functions(module);
  register_controllers(module);
  guard_objects(module);  // applies to all classes
  explain_wrong_calls(module);  // applies to all functions
}
