#include "system_container.hpp"

#include "console.hpp"
#include "conversion.hpp"
#include "python_errors.hpp"
#include "shadow.hpp"

namespace dalembert {
namespace {

using ContainerClass = py::class_<SystemContainer, std::shared_ptr<SystemContainer>>;

py::object new_visualization_settings() {
  return py::hasattr(core_module(), "VisualizationSettings") ? core_module().attr("VisualizationSettings")()
                                                             : py::object(py::none());
}

std::shared_ptr<SystemContainer> new_container() {
  auto container = std::make_shared<SystemContainer>();
  container->visualization_settings = std::make_shared<py::object>(new_visualization_settings());
  container->renderer->container = container;
  return container;
}

py::dict container_dictionary(const SystemContainer& container) {
  py::dict result;
  result["__version__"] = DALEMBERT_VERSION;
  py::list systems;
  for (const auto& system : container.systems) systems.append(py::cast(system).attr("GetDictionary")());
  result["systems"] = systems;
  const py::object& settings = *container.visualization_settings;
  if (py::hasattr(settings, "GetDictionary")) result["visualizationSettings"] = settings.attr("GetDictionary")();
  result["renderState"] = container.renderer->state.attr("copy")();
  return result;
}

void set_container_dictionary(SystemContainer& container, const py::dict& data) {
  container.require_idle("SC.SetDictionary(...)");
  if (!data.contains("systems"))
    refuse(ErrorKind::value, {"SC.SetDictionary(...)", "systemDict", "there is no key 'systems'", show(data.ptr()),
                              "a result of SC.GetDictionary()", ""});
  check_version(data, "SC.SetDictionary(...)");
  std::vector<std::shared_ptr<MainSystem>> systems;
  for (const py::handle entry : data["systems"]) {
    auto system = std::make_shared<MainSystem>();
    set_system_dictionary(*system, entry.cast<py::dict>());
    systems.push_back(std::move(system));
  }
  container.reset();
  for (const auto& system : systems) container.append(system);
  const py::object& settings = *container.visualization_settings;
  if (data.contains("visualizationSettings") && py::hasattr(settings, "SetDictionary"))
    settings.attr("SetDictionary")(data["visualizationSettings"]);
  if (data.contains("renderState")) container.renderer->state = data["renderState"].attr("copy")();
}

std::string container_repr(const SystemContainer& container) {
  std::string text = "<SystemContainer: " + std::to_string(container.systems.size()) + " systems";
  for (std::size_t i = 0; i < container.systems.size(); ++i)
    text += "\n  " + std::to_string(i) + ": " + system_summary(*container.systems[i]);
  return text + ">";
}

}  // namespace

void SystemContainer::require_idle(const char* call) const {
  for (const auto& system : systems) dalembert::require_idle(*system, call);
}

void SystemContainer::reset() {
  systems.clear();
  visualization_settings = std::make_shared<py::object>(new_visualization_settings());
  renderer->state = py::dict();
}

std::shared_ptr<MainSystem> SystemContainer::add_system() {
  auto system = std::make_shared<MainSystem>();
  append(system);
  return system;
}

int SystemContainer::append(const std::shared_ptr<MainSystem>& system) {
  if (const auto owner = system->container.lock()) {
    refuse(ErrorKind::value, {"SC.Append(...)", "mainSystem", "the system already belongs to a SystemContainer", "", "",
                              "Append a new MainSystem(), or a copy of this one made by copy.copy(mbs)."});
  }
  system->container = weak_from_this();
  system->visualization_settings = visualization_settings;
  systems.push_back(system);
  return static_cast<int>(systems.size()) - 1;
}

std::shared_ptr<MainSystem> SystemContainer::system(int number) const {
  if (number >= 0 && number < static_cast<int>(systems.size())) return systems[static_cast<std::size_t>(number)];
  const std::string expected = systems.empty() ? "nothing: the container has no systems yet"
                                               : "a number from 0 to " + std::to_string(systems.size() - 1);
  refuse(ErrorKind::index, {"SC.GetSystem(...)", "systemNumber", "", std::to_string(number), expected,
                            "Add a system by SC.AddSystem()."});
}

void register_system_container(py::module_& module) {
  register_renderer(module);
  register_ray_tracer(module);
  register_shadow(module);
  register_scene_places(module);
  register_moving_parts(module);
  register_contour(module);
  ContainerClass container(module, "SystemContainer", "The systems of a script and their common settings.");
  container.def(py::init(&new_container));
  container.def(
      "Reset",
      [](SystemContainer& c) {
        c.require_idle("SC.Reset()");
        c.reset();
      },
      "Remove all systems and restore the default settings.");
  container.def("AddSystem", &SystemContainer::add_system, "Add a new system and return it.");
  container.def("Append", &SystemContainer::append, py::arg("mainSystem"),
                "Add an existing system and return its number.");
  container.def("AppendSystem", &SystemContainer::append, py::arg("mainSystem"), "Earlier name of Append.");
  container.def(
      "NumberOfSystems", [](const SystemContainer& c) { return c.systems.size(); }, "How many systems there are.");
  container.def("GetSystem", &SystemContainer::system, py::arg("systemNumber"), "The system with that number.");
  container.def("GetDictionary", &container_dictionary, "All systems and settings as one dictionary.");
  container.def("SetDictionary", &set_container_dictionary, py::arg("systemDict"),
                "Replace everything by a result of GetDictionary().");
  container.def_property(
      "visualizationSettings", [](const SystemContainer& c) { return *c.visualization_settings; },
      [](SystemContainer& c, py::object settings) { *c.visualization_settings = std::move(settings); },
      "How systems are drawn.");
  container.def_readonly("renderer", &SystemContainer::renderer, "Makes pictures of the systems.");
  container.def("__repr__", &container_repr);
  container.def(py::pickle([](const SystemContainer& c) { return container_dictionary(c); },
                           [](const py::dict& state) {
                             auto made = new_container();
                             set_container_dictionary(*made, state);
                             return made;
                           }));

  py::object main_system = module.attr("MainSystem");
  main_system.attr("GetSystemContainer") = py::cpp_function(
      [](MainSystem& main) {
        if (auto owner = main.container.lock()) return owner;
        auto made = new_container();  // the system was made without one, or its container is gone
        if (main.visualization_settings) made->visualization_settings = main.visualization_settings;
        made->append(main.shared_from_this());
        return made;
      },
      py::is_method(main_system), py::name("GetSystemContainer"),
      "The container that has the system, and with it the settings of pictures.");
}

}  // namespace dalembert
