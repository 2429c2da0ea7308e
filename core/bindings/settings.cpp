// The Python classes of settings, created at import from the tree of generated groups. They are plain CPython types:
// an attribute is a descriptor with its row, and unknown names are rejected with the nearest known name.
#include "settings.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <new>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "module.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

struct SettingsObject {
  PyObject_HEAD SettingsView view;
};

struct SettingsClass {
  const SettingsTree* tree = nullptr;
  const SettingsGroup* group = nullptr;
  PyTypeObject* type = nullptr;
  std::string path, name;  // path of the first occurrence of the structure; name of the class
  std::size_t offset = 0;  // there
  std::vector<PyGetSetDef> fields;
  std::deque<std::string> texts;  // behind the pointers in `fields`
};

// Built once at import, never freed: types refer to it.
std::deque<SettingsClass>& classes() {
  static auto* list = new std::deque<SettingsClass>;
  return *list;
}

const SettingsClass* class_of(const SettingsGroup* group) {
  for (const SettingsClass& each : classes())
    if (each.group == group) return &each;
  return nullptr;
}

SettingsView& view_of(PyObject* self) { return reinterpret_cast<SettingsObject*>(self)->view; }

const SettingsClass* class_of(PyObject* object) {
  for (const SettingsClass& each : classes())
    if (Py_TYPE(object) == each.type) return &each;
  return nullptr;
}

PyObject* make_object(SettingsView view) {
  PyTypeObject* type = class_of(view.group)->type;
  PyObject* self = type->tp_alloc(type, 0);
  if (self == nullptr) throw py::error_already_set();
  new (&view_of(self)) SettingsView(std::move(view));
  return self;
}

// The folder of files of solvers in new settings, see RequireVersion in python/dalembert/_version.py.
std::string& default_folder() {
  static std::string folder;
  return folder;
}

// A structure of its own, with defaults.
SettingsView fresh(const SettingsClass& settings_class) {
  SettingsView view{settings_class.tree, settings_class.group, settings_class.tree->operations.create(), nullptr,
                    settings_class.path};
  view.data = static_cast<char*>(view.root.get()) + settings_class.offset;
  if (!default_folder().empty() && view.tree->group == &simulation_settings_group()) {
    auto& files = static_cast<SimulationSettings*>(view.root.get())->solutionSettings;
    for (std::string* name :
         {&files.coordinatesSolutionFileName, &files.restartFileName, &files.solverInformationFileName})
      name->insert(0, default_folder());
  }
  return view;
}

SettingsView copy_of(const SettingsView& view) {
  SettingsView copy = view;
  copy.root = view.tree->operations.copy(view.root.get());
  copy.data =
      static_cast<char*>(copy.root.get()) + (static_cast<char*>(view.data) - static_cast<char*>(view.root.get()));
  return copy;
}

// The same structure with the defaults that it has at its place.
SettingsView defaults_of(const SettingsView& view) {
  SettingsView defaults = view;
  defaults.root = view.tree->operations.create();
  defaults.data =
      static_cast<char*>(defaults.root.get()) + (static_cast<char*>(view.data) - static_cast<char*>(view.root.get()));
  return defaults;
}

void set_child(const SettingsView& view, const SettingsChild& child, PyObject* value) {
  const SettingsView target = view.child(child);
  if (PyDict_Check(value)) {
    set_settings_dictionary(target, py::reinterpret_borrow<py::dict>(value));
    return;
  }
  const SettingsClass* given = class_of(value);
  if (given == nullptr || given->group != child.group)
    refuse(ErrorKind::type, {.item = std::string(view.tree->group->name),
                             .parameter = target.path,
                             .received = given != nullptr ? "a " + given->name : show(value),
                             .expected = "a " + class_of(child.group)->name + " or a dictionary"});
  assign_settings(*child.group, target.data, view_of(value).data);
}

// interactive.keyPressUserFunction: the memory of settings cannot store a function, so it is kept separately. It is
// not one of their parameters, so that their dictionaries can be stored.
py::object& function_beside(const SettingsView& view) {
  using Functions = std::map<std::weak_ptr<void>, py::object, std::owner_less<std::weak_ptr<void>>>;
  static auto& functions = *new Functions;  // the interpreter may end before it
  std::erase_if(functions, [](const auto& entry) { return entry.first.expired(); });
  return functions.try_emplace(view.root, py::none()).first->second;
}

PyObject* get_field(const SettingsField& field) {
  if (field.row != nullptr) return read_setting(field.view, *field.row).release().ptr();
  if (field.child != nullptr) return make_object(field.view.child(*field.child));
  if (field.only_names) return make_object(field.view);
  return py::object(function_beside(field.view)).release().ptr();
}

void set_field(const SettingsField& field, PyObject* value) {
  if (field.without_effect)
    function_beside(field.view) = PyCallable_Check(value) ? py::reinterpret_borrow<py::object>(value) : py::none();
  if (field.row != nullptr) write_setting(field.view, *field.row, value);
  if (field.child != nullptr) set_child(field.view, *field.child, value);
  if (field.only_names)
    refuse(ErrorKind::type, {.item = std::string(field.view.tree->group->name),
                             .parameter = field.view.path,
                             .problem = "is not a structure",
                             .advice = "Set its parameters."});
}

// ---- slots
// -----------------------------------------------------------------------------------------------------------

PyObject* get_row(PyObject* self, void* row) {
  return guarded([&] { return read_setting(view_of(self), *static_cast<const Row*>(row)).release().ptr(); });
}
PyObject* get_child(PyObject* self, void* child) {
  return guarded([&] { return make_object(view_of(self).child(*static_cast<const SettingsChild*>(child))); });
}

bool is_special(PyObject* name) { return to_string(name).starts_with("__"); }

PyObject* get_attribute(PyObject* self, PyObject* name) {
  PyObject* value = PyObject_GenericGetAttr(self, name);
  if (value != nullptr || PyErr_ExceptionMatches(PyExc_AttributeError) == 0) return value;
  return guarded([&]() -> PyObject* {
    if (is_special(name)) return nullptr;
    PyErr_Clear();
    const SettingsField field = find_field(view_of(self), to_string(name));
    if (!field) refuse_unknown(view_of(self), to_string(name));
    return get_field(field);
  });
}

int set_attribute(PyObject* self, PyObject* name, PyObject* value) {
  return guarded_status([&] {
    const SettingsView& view = view_of(self);
    const std::string text = to_string(name);
    const SettingsField field = find_field(view, text);
    if (!field) refuse_unknown(view, text);
    if (value == nullptr)
      refuse(ErrorKind::type, {.item = view.title(), .parameter = text, .problem = "settings cannot be deleted"});
    set_field(field, value);
  });
}

PyObject* make_new(PyTypeObject* type, PyObject* arguments, PyObject* keywords) {
  return guarded([&] {
    const auto found = std::ranges::find_if(classes(), [&](const SettingsClass& each) { return each.type == type; });
    if (PyTuple_GET_SIZE(arguments) != 0)
      refuse(ErrorKind::type,
             {.item = found->name, .problem = "takes keywords only", .advice = "Give settings by their names."});
    py::object made = py::reinterpret_steal<py::object>(make_object(fresh(*found)));
    if (keywords != nullptr)
      for (const auto& [name, value] : py::reinterpret_borrow<py::dict>(keywords))
        made.attr(py::reinterpret_borrow<py::str>(name)) = value;
    return made.release().ptr();
  });
}

void deallocate(PyObject* self) {
  PyTypeObject* type = Py_TYPE(self);
  view_of(self).~SettingsView();
  type->tp_free(self);
  Py_DECREF(type);
}

PyObject* represent(PyObject* self) {
  return guarded([&] {
    const SettingsView& view = view_of(self);
    return py::str(settings_differences(view, defaults_of(view))).release().ptr();
  });
}
PyObject* to_string_of_all(PyObject* self) {
  return guarded([&] { return py::str(settings_text(view_of(self))).release().ptr(); });
}

PyObject* get_dictionary(PyObject* self, PyObject*) {
  return guarded([&] { return settings_dictionary(view_of(self)).release().ptr(); });
}
PyObject* get_dictionary_with_types(PyObject* self, PyObject*) {
  return guarded([&] { return settings_dictionary_with_types(view_of(self)).release().ptr(); });
}
PyObject* set_dictionary(PyObject* self, PyObject* values) {
  return guarded([&]() -> PyObject* {
    if (PyDict_Check(values) == 0)
      refuse(ErrorKind::type, {.item = view_of(self).title(), .received = show(values), .expected = "a dictionary"});
    set_settings_dictionary(view_of(self), py::reinterpret_borrow<py::dict>(values));
    Py_RETURN_NONE;
  });
}
PyObject* copy(PyObject* self, PyObject*) {
  return guarded([&] { return make_object(copy_of(view_of(self))); });
}
PyObject* reduce(PyObject* self, PyObject*) {
  return guarded([&] {
    const auto type = py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(Py_TYPE(self)));
    return py::make_tuple(type, py::tuple(), settings_dictionary(view_of(self))).release().ptr();
  });
}

PyObject* equals(PyObject* self, PyObject* other) {
  return guarded([&] {
    const SettingsClass* given = class_of(other);
    if (given == nullptr || given->group != view_of(self).group)
      refuse(ErrorKind::type,
             {.item = view_of(self).title(), .received = show(other), .expected = "settings of the same class"});
    return PyBool_FromLong(equal_settings(*given->group, view_of(self).data, view_of(other).data) ? 1 : 0);
  });
}

PyMethodDef methods[] = {
    {"GetDictionary", get_dictionary, METH_NOARGS, "All settings as nested dictionaries."},
    {"GetDictionaryWithTypeInfo", get_dictionary_with_types, METH_NOARGS,
     "As GetDictionary, but each value is a dictionary with 'value', 'type', 'size' and 'description'."},
    {"SetDictionary", set_dictionary, METH_O,
     "Set the settings that a dictionary names; the others stay. An error changes nothing."},
    {"_equals", equals, METH_O, "Whether other settings of this class have the same values."},
    {"__copy__", copy, METH_NOARGS, nullptr},
    {"__deepcopy__", copy, METH_O, nullptr},
    {"__reduce__", reduce, METH_NOARGS, nullptr},
    {"__setstate__", set_dictionary, METH_O, nullptr},
    {nullptr, nullptr, 0, nullptr},
};

// ---- classes
// ---------------------------------------------------------------------------------------------------------

void add_field(SettingsClass& settings_class, std::string_view name, std::string doc, getter get, const void* closure) {
  settings_class.texts.emplace_back(name);
  const char* stable_name = settings_class.texts.back().c_str();
  settings_class.texts.push_back(std::move(doc));
  settings_class.fields.push_back(
      {stable_name, get, nullptr, settings_class.texts.back().c_str(), const_cast<void*>(closure)});
}

void make_class(SettingsClass& settings_class, const py::module_& module) {
  settings_class.name = std::string(settings_class.group->name);
  const SettingsView defaults = fresh(settings_class);
  std::string parameters;
  for (const SettingsChild& child : settings_class.group->children) {
    add_field(settings_class, child.name, settings_summary(*child.group), get_child, &child);
    parameters += "    " + std::string(child.name) + ": " + std::string(child.group->name) + "\n        " +
                  settings_summary(*child.group) + "\n";
  }
  for (const Row& row : settings_class.group->rows) {
    const std::string text = setting_text(*settings_class.group, row), facts = setting_doc(*settings_class.group, row);
    add_field(settings_class, row.name, facts + "\n" + text, get_row, &row);
    parameters += "    " + std::string(row.name) + ": " + facts + "; default " +
                  std::string(py::repr(read_setting(defaults, row))) + "\n        " + text + "\n";
  }
  settings_class.fields.push_back({});
  settings_class.texts.push_back(module.attr("__name__").cast<std::string>() + "." + settings_class.name);
  const char* full_name = settings_class.texts.back().c_str();
  settings_class.texts.push_back(settings_class.name + "(**settings)\n--\n\n" +
                                 settings_summary(*settings_class.group) +
                                 (settings_class.path.empty() ? "" : "; first found at " + settings_class.path) +
                                 "\n\nParameters:\n" + parameters);
  PyType_Slot slots[] = {
      {Py_tp_new, reinterpret_cast<void*>(make_new)},
      {Py_tp_dealloc, reinterpret_cast<void*>(deallocate)},
      {Py_tp_repr, reinterpret_cast<void*>(represent)},
      {Py_tp_str, reinterpret_cast<void*>(to_string_of_all)},
      {Py_tp_getattro, reinterpret_cast<void*>(get_attribute)},
      {Py_tp_setattro, reinterpret_cast<void*>(set_attribute)},
      {Py_tp_methods, methods},
      {Py_tp_getset, settings_class.fields.data()},
      {Py_tp_doc, const_cast<char*>(settings_class.texts.back().c_str())},
      {0, nullptr},
  };
  PyType_Spec spec{full_name, sizeof(SettingsObject), 0, Py_TPFLAGS_DEFAULT, slots};
  PyObject* type = PyType_FromSpec(&spec);
  if (type == nullptr) throw py::error_already_set();
  settings_class.type = reinterpret_cast<PyTypeObject*>(type);
}

void collect_classes(const SettingsTree& tree, const SettingsGroup& group, const std::string& path,
                     std::size_t offset) {
  if (class_of(&group) != nullptr) return;
  SettingsClass& settings_class = classes().emplace_back();
  settings_class.tree = &tree;
  settings_class.group = &group;
  settings_class.path = path;
  settings_class.offset = offset;
  for (const SettingsChild& child : group.children)
    collect_classes(tree, *child.group, path.empty() ? std::string(child.name) : path + "." + std::string(child.name),
                    offset + child.offset);
}

const SettingsTree& simulation_tree() {
  static const SettingsTree tree{&simulation_settings_group(), record_operations<SimulationSettings>(),
                                 simulation_aliases()};
  return tree;
}
const SettingsTree& visualization_tree() {
  static const SettingsTree tree{&visualization_settings_group(), record_operations<VisualizationSettings>(),
                                 visualization_aliases()};
  return tree;
}

template <class Settings>
std::shared_ptr<Settings> settings_of(py::handle object, const SettingsGroup& group) {
  const SettingsClass* given = class_of(object.ptr());
  if (given == nullptr || given->group != &group)
    refuse(ErrorKind::type, {.received = show(object.ptr()), .expected = "exu." + std::string(group.name) + "()"});
  return std::static_pointer_cast<Settings>(view_of(object.ptr()).root);
}

// Names of classes in the interface that differ from those of the structures.
constexpr std::pair<const char*, const char*> class_names[] = {
    {"NumericalDifferentiationSettings", "NewtonNumericalDifferentiationSettings"},
    {"Parallel", "ParallelSettings"},
    {"ExplicitIntegrationSettings", "TimeIntegrationExplicitIntegrationSettings"},
    {"GeneralizedAlphaSettings", "TimeIntegrationGeneralizedAlphaSettings"},
    {"VSettingsBeams", "VSettingsBodiesBeams"},
    {"VSettingsCamera", "VSettingsViewCamera"},
    {"VSettingsKinematicTree", "VSettingsBodiesKinematicTree"},
    {"VSettingsOpenVR", "VSettingsInteractiveOpenVR"},
    {"VSettingsScene", "VSettingsViewScene"},
    {"VSettingsShells", "VSettingsBodiesShells"},
    {"VSettingsTraces", "VSettingsSensorsTraces"},
    {"VSettingsWindow", "VSettingsViewWindow"},
};

}  // namespace

std::shared_ptr<SimulationSettings> simulation_settings_of(py::handle object) {
  return settings_of<SimulationSettings>(object, simulation_settings_group());
}
std::shared_ptr<VisualizationSettings> visualization_settings_of(py::handle object) {
  return settings_of<VisualizationSettings>(object, visualization_settings_group());
}

void register_settings(py::module_& module) {
  for (const SettingsTree* tree : {&simulation_tree(), &visualization_tree()})
    collect_classes(*tree, *tree->group, "", 0);
  SettingsClass& names = classes().emplace_back();
  names.tree = &simulation_tree();
  names.group = &names_group();
  for (SettingsClass& settings_class : classes()) {
    make_class(settings_class, module);
    module.attr(settings_class.name.c_str()) = py::handle(reinterpret_cast<PyObject*>(settings_class.type));
  }
  for (const auto& [name, structure] : class_names)
    if (py::hasattr(module, structure)) module.attr(name) = module.attr(structure);
  module.def(
      "_set_default_folder", [](const std::string& folder) { default_folder() = folder; }, py::arg("folder"),
      "Set the folder of solution, restart and solver information file in new SimulationSettings.");
  module.def(
      "_visualization_settings_without_effect",
      [] {
        const auto reasons = [](std::string_view SettingRule::* reason) {
          py::dict found;
          find_settings_without_effect(visualization_settings_group(), reason, "", found);
          return found;
        };
        return py::make_tuple(reasons(&SettingRule::no_effect), reasons(&SettingRule::no_effect_on_pages),
                              reasons(&SettingRule::no_effect_without_rays));
      },
      "Why visualization settings have no effect, by their paths: nowhere, on pages, and in pictures without the ray "
      "tracer.");
}

}  // namespace dalembert
