#include "containers.hpp"

#include "module.hpp"

namespace dalembert {

void register_containers(py::module_& module) {
  register_entry_lists(module);
  register_matrix_container(module);
  register_beam_sections(module);
  register_materials(module);
}

}  // namespace dalembert
