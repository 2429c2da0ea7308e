// The class behind Python's MainSystem: model, assembled system and related Python objects.
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
  Excerpts excerpts;  // excerpts of the model while it is not assembled

  py::dict variables, sys;  // free for the user; kept for utilities
  std::map<std::string, py::object>
      user_functions;  // PreStep, PostStep, PostNewton, PreNewtonResidual, SystemJacobian, Events, EventAction, ItemEventAction
  SensorStorage sensor_storage;  // sensors with storeInternal
  bool interactive = false;
  std::atomic<bool> stop_requested = false,
                    jacobian_update_requested = false;  // also by other threads than the solver's
  std::weak_ptr<SystemContainer> container;
  std::shared_ptr<py::object> visualization_settings;  // settings of its container, which may have been deleted
  // Set when the configuration Visualization is read: a solver then updates it. Otherwise it saves the time.
  std::atomic<bool> look_wanted = false;
  Tap tap;  // of viewers
  bool always_looked_at = false;  // arrays that are views of it were given away
  const Work* work = nullptr;  // set by the running solver

  // Assembled, and the model has the same items since.
  bool consistent() const { return system.assembled() && assembled_structure_ == model.structure_changes(); }
  void set_consistent(bool flag);
  void assemble(const Label& method);
  // The system with all changed parameters taken over; refuses, naming `method`, if Assemble() is due, or if another thread uses it.
  System& assembled(const Label& method);
  // The assembled system for reading data that a solver does not change: tables, the configurations Reference and
  // Visualization. Allowed for any thread.
  const System& at_rest(const Label& method) const;

  // Let the configuration Visualization be the current one.
  void show_current();

  // ---- changes of the model: only these functions change it ---------------------------------------------------------
  // Structural changes are rejected while the system is in use; `call` is for example "mbs.AddNode(...)".
  Model& restructure(const Label& call);
  void edit(ItemKind kind, int number, const Row& row, const std::function<void(void*)>& write);
  void add_load_dependencies(int load, std::span<const int> coordinates);
  void reset();
  void reset_to(Model model);
  // Replaces the items, or their values, of a copy for viewers (Shadow), which has no other user.
  void become(Model model, bool assembled);
  void renew(ItemKind kind, int number, std::shared_ptr<const void> record) {
    model_.renew(kind, number, std::move(record));
  }

  // Returns None if no function was set.
  py::object user_function(const std::string& name) const;
  void set_user_function(const std::string& name, const py::object& function);  // None removes the function

 private:
  void require_consistent(const Label& method) const;
  void assemble();
  void take_completed();

  Model model_;
  std::uint64_t assembled_structure_ = ~std::uint64_t{0}, refreshed_values_ = 0;
};

// The class behind Python's mbs.systemData; it keeps its system alive. Bound in system_data.cpp.
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

py::dict system_dictionary(const MainSystem& main);  // GetDictionary
// implements SetDictionary; after an error the system is unchanged
void set_system_dictionary(MainSystem& main, const py::dict& data);
std::string system_summary(const MainSystem& main);  // counts per kind, for repr

}  // namespace dalembert
