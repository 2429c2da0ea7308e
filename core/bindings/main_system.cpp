#include "main_system.hpp"

#include <cctype>

#include "compiled_callback.hpp"
#include "console.hpp"
#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "garbage.hpp"
#include "item_packages.hpp"
#include "main_system_attributes.hpp"
#include "python_callback.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

using Class = py::class_<MainSystem, std::shared_ptr<MainSystem>>;

// The functions that a solver calls for the whole system, by the names of their setters.
struct SystemFunctionWords {
  const char* name;
  const char* doc;
};
constexpr SystemFunctionWords system_functions[] = {
    {"PreStep",
     "Set the function f(mbs, t) that solvers call before each step, with the time t (s) of its end; it may change "
     "parameters, and returns True to go on, False to stop."},
    {"PostStep",
     "Set the function f(mbs, t) that solvers call after each step; it returns True to go on, False to stop."},
    {"PostNewton",
     "Set the function f(mbs, t) that solvers call after Newton's method; it may switch data coordinates, and returns "
     "[error of the discontinuous "
     "iteration, recommended step size (s) or -1]."},
    {"PreNewtonResidual",
     "Set the function f(mbs, t, newtonIteration, discontinuousIteration) that implicit solvers call before they "
     "compute a residual."},
    {"SystemJacobian",
     "Set the function f(mbs, t, factorODE2, factorODE2_t, factorODE1) that returns a MatrixContainer, which is added "
     "to the system matrix."},
    {"Events",
     "Set the function f(mbs, t) whose values have zeros at events: a list with a number per event, or with pairs of "
     "the number and a direction."},
    {"EventAction",
     "Set the function f(mbs, t, event, direction) that acts when an event has happened; it returns True to go on, "
     "False to stop."},
    {"ItemEventAction",
     "Set the function f(mbs, t, item, event, direction) that acts when an item has switched, with events.ofItems: the "
     "number of the object (in GeneralContact: "
     "the name of the sphere or shape), 'contact', 'friction', 'stop' or the like, and 1 if that begins, -1 if it "
     "ends; it returns True to go on, False to stop."}};

constexpr const char* list_key(ItemKind kind) {
  constexpr const char* keys[] = {"nodeList", "objectList", "markerList", "loadList", "sensorList"};
  return keys[static_cast<std::size_t>(kind)];
}

std::string dictionary_key(std::string name) {
  name[0] = static_cast<char>(std::tolower(name[0]));
  return name + "Function";
}

// Converts a given value to its function: the function itself, the function in a dictionary with its type, or None
// for 0.
py::object function_of(const std::string& name, const py::object& value) {
  if (value.is_none() || (PyLong_Check(value.ptr()) && PyObject_IsTrue(value.ptr()) == 0)) return py::none();
  py::object function = value;
  if (py::isinstance<py::dict>(value) && value.contains("function")) function = value["function"];
  const auto refuse_function = [&](const std::string& expected, const std::string& advice) {
    refuse(ErrorKind::type, {"mbs.Set" + name + "UserFunction(...)", "value", "", show(value.ptr()), expected, advice});
  };
  try {
    if (compiled_system_function(function.ptr(), name) == nullptr && PyCallable_Check(function.ptr()) == 0)
      refuse_function("a function, or 0 for none", "Pass the function itself, without calling it.");
  } catch (const Refusal& refusal) {
    refuse_function(refusal.expected, refusal.advice);
  }
  return function;
}

void register_functions(Class& main_system) {
  for (const auto& [name, doc] : system_functions) {
    const std::string key(name);
    main_system.def(
        ("Set" + key + "UserFunction").c_str(),
        [key](MainSystem& main, const py::object& value) { main.set_user_function(key, function_of(key, value)); },
        py::arg("value"), (std::string(doc) + " 0 removes it.").c_str());
    main_system.def(("Get" + key + "UserFunction").c_str(),
                    [key](const MainSystem& main, bool as_dict) -> py::object {
                      py::object function = main.user_function(key);
                      if (function.is_none()) return py::int_(0);
                      if (!as_dict) return function;
                      py::dict result;
                      result["function"] = function;
                      result["type"] = "Python";
                      return result;
                    },
                    py::arg("asDict") = false, "The function that was set, or 0.");
  }
}

py::dict copy_of(const py::dict& entries) { return entries.attr("copy")(); }

void register_state(Class& main_system) {
  main_system.def("GetDictionary", &system_dictionary, "All items, user functions and variables as one dictionary.");
  main_system.def("SetDictionary", &set_system_dictionary, py::arg("systemDict"),
                  "Replace the whole system by a result of GetDictionary().");
  main_system.def(
      "Reset",
      [](MainSystem& main) {
        require_idle(main, "mbs.Reset()");
        main.reset();
      },
      "Delete all items, user functions and variables.");
  main_system.def(
      "_RequireIdle",
      [](const MainSystem& main, const std::string& method) { require_idle(main, "mbs." + method + "(...)"); },
      py::arg("method"), "Refuse a call of the method while the system is being solved.");
  main_system.def(
      "_ConstraintsBetween",
      [](const MainSystem& main, const std::vector<int>& bodies) { return constraints_between(main.model, bodies); },
      py::arg("bodies"), "Numbers of objects with constraints whose markers are on these bodies and no others.");
  main_system.def("__repr__", [](const MainSystem& main) { return system_summary(main); });
}

void register_rendering(Class& main_system) {
  main_system.def(
      "ActivateRendering", [](MainSystem&, bool) {}, py::arg("flag") = true, "Does nothing: pages show all systems.");
  main_system.def(
      "GetRenderEngineStopFlag", [](const MainSystem& main) { return main.stop_requested.load(); },
      "Whether a stop was requested.");
  main_system.def(
      "SetRenderEngineStopFlag", [](MainSystem& main, bool flag) { main.stop_requested = flag; }, py::arg("stopFlag"),
      "Ask the running solver to stop.");
}

}  // namespace

Model& MainSystem::restructure(const Label& call) {
  require_idle(*this, call);
  return model_;
}

void MainSystem::edit(ItemKind kind, int number, const Row& row, const std::function<void(void*)>& write) {
  const auto call = [&] {
    return "mbs.Set" + std::string(kind_title(kind)) + "Parameter(" + std::to_string(number) + ", " +
           in_quotes(row.name) + ", ...)";
  };
  Model::changes_structure(row) ? require_idle(*this, call) : require_own_thread(*this, call);
  model_.edit(kind, number, row, write);
}

// During an evaluation the tables do not change; the next evaluation uses the new dependencies.
void MainSystem::add_load_dependencies(int load, std::span<const int> coordinates) {
  model_.add_load_dependencies(load, coordinates);
  if (RunningFunction::in_evaluation_here(*this)) {
    system.refresh_later(model);
  } else {
    system.add_load_dependencies(load, coordinates);
  }
}

void MainSystem::assemble(const Label& method) {
  require_idle(*this, [&] { return "mbs." + method.text() + "()"; });
  assemble();
  if (const std::string doubt = model.doubt(); !doubt.empty())
    if (PyErr_WarnEx(PyExc_UserWarning, doubt.c_str(), 1) != 0) throw py::error_already_set();
}

void MainSystem::assemble() {
  system.assemble(model);
  take_completed();
  excerpts = {};
  assembled_structure_ = model.structure_changes();
  refreshed_values_ = model.value_changes();
}

void MainSystem::become(Model model, bool assembled) {
  model_.become(std::move(model));
  excerpts = {};
  if (assembled) assemble();
}

// Parameters that assembling finds can be read from the items.
void MainSystem::take_completed() {
  for (auto& [object, record] : system.completed_records()) model_.complete(object, std::move(record));
}

// Sensors that were added or deleted have no part in the equations: the system takes them over. Other changes need Assemble().
void MainSystem::set_consistent(bool flag) {
  if (flag == consistent()) return;
  constexpr const char* call = "mbs.systemIsConsistent";
  require_idle(*this, call);
  if (flag && !system.renew_sensors(model)) {
    refuse(ErrorKind::state, {.item = call,
                              .problem = "it cannot be set: the equations are not those of the items",
                              .received = "True",
                              .advice = "Call mbs.Assemble(), which makes the system consistent."});
  }
  assembled_structure_ = flag ? model.structure_changes() : ~std::uint64_t{0};
}

void MainSystem::require_consistent(const Label& method) const {
  if (consistent()) return;
  Complaint complaint;
  complaint.item = "mbs." + method.text() + "(...)";
  complaint.problem = system.assembled() ? "items were added, deleted or connected differently since mbs.Assemble()"
                                         : "the system is not assembled";
  complaint.advice = "Call mbs.Assemble() after the last change of items and before this call.";
  refuse(ErrorKind::state, complaint);
}

System& MainSystem::assembled(const Label& method) {
  require_own_thread(*this, [&] { return "mbs." + method.text() + "(...)"; });
  require_consistent(method);
  if (refreshed_values_ != model.value_changes()) {
    if (RunningFunction::in_evaluation_here(*this)) {  // batches are in use
      system.refresh_later(model);
    } else {
      system.refresh(model);
      take_completed();
      refreshed_values_ = model.value_changes();
    }
  }
  return system;
}

const System& MainSystem::at_rest(const Label& method) const {
  require_consistent(method);
  return system;
}

void MainSystem::show_current() {
  look_wanted = always_looked_at;
  system.state(ConfigurationType::Visualization) = system.state(ConfigurationType::Current);
}

void MainSystem::reset() { reset_to({}); }

void MainSystem::reset_to(Model model) {
  model_.become(std::move(model));
  variables = py::dict();
  sys = py::dict();
  user_functions.clear();
  sensor_storage.clear();
  excerpts = {};
  assembled_structure_ = ~std::uint64_t{0};
}

py::object MainSystem::user_function(const std::string& name) const {
  const auto found = user_functions.find(name);
  return found == user_functions.end() ? py::object(py::none()) : found->second;
}

void MainSystem::set_user_function(const std::string& name, const py::object& function) {
  if (function.is_none()) {
    user_functions.erase(name);
  } else {
    user_functions[name] = function;
  }
}

py::dict system_dictionary(const MainSystem& main) {
  py::dict result;
  result["__version__"] = DALEMBERT_VERSION;
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    py::list list;
    for (int i = 0; i < main.model.count(kind); ++i) {
      const Item& item = main.model.item(kind, i);
      list.append(item_dictionary(*item.type, item.record.get(), main.model.name(kind, i), true));
    }
    result[list_key(kind)] = list;
  }
  if (const py::list packages = packages_of(main.model); !packages.empty()) result["itemPackages"] = packages;
  if (!main.model.term_sources().empty()) result["generalContactList"] = general_contact_dictionaries(main);
  py::dict functions, settings;
  for (const auto& words : system_functions) {
    const std::string name(words.name);
    const py::object function = main.user_function(name);
    functions[dictionary_key(name).c_str()] = function.is_none() ? py::object(py::int_(0)) : function;
  }
  result["userFunctions"] = functions;
  settings["interactiveMode"] = main.interactive;
  result["settings"] = settings;
  result["variables"] = copy_of(main.variables);
  result["systemVariables"] = copy_of(main.sys);
  return result;
}

void set_system_dictionary(MainSystem& main, const py::dict& data) {
  require_idle(main, "mbs.SetDictionary(...)");
  check_version(data, "mbs.SetDictionary(...)");
  if (data.contains("itemPackages")) load_packages(data["itemPackages"], "mbs.SetDictionary(...): the dictionary");
  Model model;
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    if (!data.contains(list_key(kind))) continue;
    for (const py::handle entry : data[list_key(kind)]) {
      const std::string where =
          "SetDictionary(...), " + std::string(list_key(kind)) + "[" + std::to_string(model.count(kind)) + "]";
      if (!py::isinstance<py::dict>(entry))
        refuse(ErrorKind::type, {where, "", "", show(entry.ptr()), "a dictionary", ""});
      Item item = item_from_dictionary(kind, py::reinterpret_borrow<py::dict>(entry), where);
      item.record = bind_user_functions(*item.type, std::move(item.record), main);
      model.add(std::move(item));
    }
  }
  if (data.contains("generalContactList")) {
    for (const py::handle entry : data["generalContactList"])
      model.add(general_contact_from(
          entry, "SetDictionary(...), generalContactList[" + std::to_string(model.term_sources().size()) + "]"));
  }
  const auto entries = [&](const char* key) {
    return data.contains(key) && py::isinstance<py::dict>(data[key]) ? copy_of(data[key]) : py::dict();
  };
  const py::dict functions = entries("userFunctions"), settings = entries("settings");
  std::map<std::string, py::object> user_functions;
  for (const auto& words : system_functions)
    if (const std::string name(words.name), key = dictionary_key(name); functions.contains(key))
      user_functions[name] = function_of(name, functions[key.c_str()]);
  const bool interactive = settings.contains("interactiveMode") && settings["interactiveMode"].cast<bool>();
  const py::dict variables = entries("variables"), sys = entries("systemVariables");
  main.reset_to(std::move(model));
  main.variables = variables;
  main.sys = sys;
  for (const auto& [name, function] : user_functions) main.set_user_function(name, function);
  main.interactive = interactive;
}

std::string system_summary(const MainSystem& main) {
  std::string text = "<MainSystem:";
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    const int n = main.model.count(kind);
    text += (k == 0 ? " " : ", ") + std::to_string(n) + " " + std::string(kind_name(kind)) + (n == 1 ? "" : "s");
  }
  if (!main.consistent()) return text + "; not assembled>";
  const Sizes& sizes = main.system.sizes();
  return text + "; coordinates: " + std::to_string(sizes.ode2) + " ODE2, " + std::to_string(sizes.ode1) + " ODE1, " +
         std::to_string(sizes.ae) + " AE, " + std::to_string(sizes.data) + " data>";
}

void register_main_system(py::module_& module) {
  Class main_system(module, "MainSystem", "One multibody system: items, their states, and derived quantities.",
                    py::custom_type_setup([](PyHeapTypeObject* type) {
                      collect_main_systems(type);
                      explain_attributes_of(type);
                    }),
                    py::metaclass(class_of_main_system()));
  main_system.def(py::init([] { return std::make_shared<MainSystem>(); }));
  main_system.def_readwrite("variables", &MainSystem::variables, "A dictionary that is free for the user.");
  main_system.def_readwrite("sys", &MainSystem::sys, "A dictionary in which utilities keep their data.");
  main_system.def_readwrite("interactiveMode", &MainSystem::interactive,
                            "Kept, without effect: items are added, changed and looked at in any order.");
  main_system.def_property(
      "solverSignalJacobianUpdate", [](const MainSystem& main) { return main.jacobian_update_requested.load(); },
      [](MainSystem& main, bool flag) { main.jacobian_update_requested = flag; },
      "Set by user functions to ask for a new Jacobian.");
  main_system.def_property("systemIsConsistent", &MainSystem::consistent, &MainSystem::set_consistent,
                           "Whether the system is assembled and has the same items since.");
  main_system.def_property_readonly(
      "systemData", [](MainSystem& main) { return SystemData{main.shared_from_this()}; },
      "Coordinates and index tables.");
  register_functions(main_system);
  register_state(main_system);
  register_rendering(main_system);
  register_main_system_items(module, main_system);
  register_main_system_assembled(main_system);
}

}  // namespace dalembert
