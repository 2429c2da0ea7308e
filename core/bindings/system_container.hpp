// SystemContainer: the systems of a script, and the settings and the renderer that they share.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "main_system.hpp"

namespace dalembert {

// Stands where a renderer would be. Nothing is drawn: its methods accept what scripts pass and do nothing.
class Renderer {
 public:
  py::dict state;  // as SetState left it
  py::object materials;  // made when asked for
};

class SystemContainer : public std::enable_shared_from_this<SystemContainer> {
 public:
  std::vector<std::shared_ptr<MainSystem>> systems;
  py::object visualization_settings;
  std::shared_ptr<Renderer> renderer = std::make_shared<Renderer>();

  void require_idle(const char* call) const;  // of all systems
  void reset();
  std::shared_ptr<MainSystem> add_system();
  int append(const std::shared_ptr<MainSystem>& system);
  std::shared_ptr<MainSystem> system(int number) const;
};

void register_renderer(py::module_& module);
// The methods that containers had before there was SC.renderer.
void register_renderer_shortcuts(py::class_<SystemContainer, std::shared_ptr<SystemContainer>>& container);

}  // namespace dalembert
