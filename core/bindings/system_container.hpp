// SystemContainer: the systems of a script, and the settings and the renderer that they share.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

#include "main_system.hpp"

namespace dalembert {

class SystemContainer;

// State of SC.renderer.
class Renderer {
 public:
  std::weak_ptr<SystemContainer> container;
  py::dict state;  // set by SetState
  py::object materials;  // made when asked for
};

class SystemContainer : public std::enable_shared_from_this<SystemContainer> {
 public:
  std::vector<std::shared_ptr<MainSystem>> systems;
  std::shared_ptr<py::object> visualization_settings;  // its systems have them, too
  std::shared_ptr<Renderer> renderer = std::make_shared<Renderer>();  // its methods are attached in Python

  void require_idle(const char* call) const;  // checks all systems
  void reset();
  std::shared_ptr<MainSystem> add_system();
  int append(const std::shared_ptr<MainSystem>& system);
  std::shared_ptr<MainSystem> system(int number) const;
};

void register_renderer(py::module_& module);
void register_ray_tracer(py::module_& module);
void register_scene_places(py::module_& module);
void register_moving_parts(py::module_& module);
void register_contour(py::module_& module);

}  // namespace dalembert
