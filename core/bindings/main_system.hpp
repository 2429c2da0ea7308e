// What Python calls MainSystem: model, assembled system and the Python objects that belong to them.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <map>
#include <memory>
#include <string>

#include "dalembert/model/model.hpp"
#include "dalembert/output/sensor_recorder.hpp"
#include "dalembert/system/excerpt.hpp"
#include "dalembert/system/system.hpp"
#include "label.hpp"
#include "occupation.hpp"
#include "tap.hpp"

namespace dalembert {

namespace py = pybind11;

class SystemContainer;

// Held by shared_ptr: user functions and solvers may outlive the Python variable.
class MainSystem : public std::enable_shared_from_this<MainSystem> {
 public:
  const Model& model = model_;
  System system;
  Excerpts excerpts;  // of the model, as long as it is not assembled

  py::dict variables, sys;  // free for the user; kept for utilities
  std::map<std::string, py::object> user_functions;  // PreStep, PostStep, PostNewton, PreNewtonResidual, SystemJacobian, Events, EventAction, ItemEventAction
  SensorStorage sensor_storage;                      // sensors with storeInternal
  bool interactive = false;
  std::atomic<bool> stop_requested = false, jacobian_update_requested = false;  // also by other threads than the solver's
  std::weak_ptr<SystemContainer> container;
  std::shared_ptr<py::object> visualization_settings;  // of its container, which may be gone
  // Whoever reads the configuration Visualization wishes that a solver renews it; nobody pays for what nobody looks at.
  std::atomic<bool> look_wanted = false;
  Tap tap;  // of viewers
  bool always_looked_at = false;  // arrays that are views of it were given away
  const Work* work = nullptr;  // of the solver that is running

  // Assembled, and the model has the same items since.
  bool consistent() const { return system.assembled() && assembled_structure_ == model.structure_changes(); }
  void set_consistent(bool flag);
  void assemble(const Label& method);
  // The system with all changed parameters taken over; refuses, naming `method`, if Assemble() is due, or if another thread uses it.
  System& assembled(const Label& method);
  // The same for reading what a solver leaves alone: tables, the configurations Reference and Visualization. Any thread may.
  const System& at_rest(const Label& method) const;

  // Let the configuration Visualization be the current one.
  void show_current();

  // ---- changes of the model: there are no others ---------------------------------------------------------------------
  // What changes its structure is refused while the system is in use; `call`: "mbs.AddNode(...)".
  Model& restructure(const Label& call);
  void edit(ItemKind kind, int number, const Row& row, const std::function<void(void*)>& write);
  void add_load_dependencies(int load, std::span<const int> coordinates);
  void reset();
  void reset_to(Model model);
  // Of a copy for viewers (Shadow), which is in nobody else's use: other items, and other values of the same ones.
  void become(Model model, bool assembled);
  void renew(ItemKind kind, int number, std::shared_ptr<const void> record) { model_.renew(kind, number, std::move(record)); }

  // None if no function was set.
  py::object user_function(const std::string& name) const;
  void set_user_function(const std::string& name, const py::object& function);  // None removes it

 private:
  void require_consistent(const Label& method) const;
  void assemble();
  void take_completed();

  Model model_;
  std::uint64_t assembled_structure_ = ~std::uint64_t{0}, refreshed_values_ = 0;
};

// What Python calls mbs.systemData; keeps its system alive. Bound in system_data.cpp.
struct SystemData {
  std::shared_ptr<MainSystem> main;
};

void register_main_system(py::module_& module);
void register_main_system_items(py::module_& module, py::class_<MainSystem, std::shared_ptr<MainSystem>>& main_system);
void register_main_system_assembled(py::class_<MainSystem, std::shared_ptr<MainSystem>>& main_system);
void register_system_container(py::module_& module);

// Bound in general_contact.cpp and general_contact_dictionary.cpp.
void register_general_contact(py::module_& module);
py::list general_contact_dictionaries(const MainSystem& main);
std::shared_ptr<SystemTermSource> general_contact_from(const py::handle& data, const std::string& where);

py::dict system_dictionary(const MainSystem& main);                  // GetDictionary
void set_system_dictionary(MainSystem& main, const py::dict& data);  // SetDictionary; on an error the system is left as it was
std::string system_summary(const MainSystem& main);                  // counts per kind, for repr

}  // namespace dalembert
