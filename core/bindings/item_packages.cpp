#include "item_packages.hpp"

#include <filesystem>
#include <set>

#include "dalembert/reflection/item_package.hpp"

namespace dalembert {

extern const char* const header_hash;  // written by codegen/headers.py

namespace {

const std::string& own_stamp() {
  static const std::string stamp = stamp_of(header_hash);
  return stamp;
}

constexpr CoreFunctions core_functions{
    sizeof(CoreFunctions),
    &refuse,
    [](const ItemLabel& item) { return std::string(item); },
    &Traced::note,
    &instructions,
    &check_inertia,
    &judge_inertia,
    &check_planar_inertia,
    &check_unit_length,
    &System::node_output,
    &System::object_output,
    &System::body_output,
    &System::super_element_output,
    &System::link_output,
    &System::marker_output,
    &System::load_values,
    &System::state_may_have_changed,
};

void require_stamp(const ItemPackage& package) {
  if (own_stamp() == package.stamp) return;
  const bool has_source = std::filesystem::exists(std::filesystem::path(package.source) / "pyproject.toml");
  const std::string rebuild =
      has_source ? std::string(package.rebuild) + " \"" + package.source + "\""
                 : "pip install --force-reinstall --no-deps --no-cache-dir " + std::string(package.module);
  throw py::import_error("the item package '" + std::string(package.module) +
                         "' was built for another dalembert or compiler: its stamp is " + package.stamp +
                         ", but this core has " + own_stamp() + ". Build it again: " + rebuild);
}

// All names of the classes of an item type: full and short ones, of items and of their visualization.
template <class Use>
void for_names(const ItemType& type, const Use& use) {
  const auto both = [&](std::string_view name) {
    use(std::string(name), false);
    use("V" + std::string(name), true);
  };
  both(type.name);
  for (const std::string_view name : type.short_names) both(name);
}

PyTypeObject* class_of_name(const ItemClass& item_class, bool visualization) {
  return visualization ? item_class.visualization_type : item_class.python_type;
}

py::dict classes_by_name() {
  py::dict all;
  for (const auto& item_class : item_classes())
    for_names(*item_class->type, [&](const std::string& name, bool visualization) {
      all[py::str(name)] =
          py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(class_of_name(*item_class, visualization)));
    });
  return all;
}

void require_new_names(const ItemPackage& package) {
  const py::dict known = classes_by_name();
  const auto complain = [&](const std::string& name, const py::handle& owner) {
    throw py::import_error("the item package '" + std::string(package.module) + "' defines the item '" + name +
                           "', which exists already in '" + py::str(owner.attr("__module__")).cast<std::string>() +
                           "'. Give it another name, or import one of both packages only.");
  };
  for (const ItemType* type : package.types) {
    for_names(*type, [&](const std::string& name, bool) {
      if (known.contains(name)) complain(name, known[py::str(name)]);
    });
    for (const std::string_view name : {type->type_name, type->name})
      if (const ItemType* other = find_type(type->kind, name))
        complain(std::string(name), py::handle(reinterpret_cast<PyObject*>(class_of(*other).python_type)));
  }
}

void add_item_package(const py::capsule& capsule, py::module_ module) {
  if (capsule.name() == nullptr || std::string_view(capsule.name()) != ItemPackage::capsule)
    throw py::type_error("_add_item_package: expected the capsule of an item package");
  const auto& package = *capsule.get_pointer<const ItemPackage>();
  require_stamp(package);
  require_new_names(package);
  *package.core = &core_functions;
  add_item_types(package);
  for (const ItemType* type : package.types) add_classes(module, make_class(*type, package.module));
}

}  // namespace

void add_classes(py::module_& module, const ItemClass& item_class) {
  for_names(*item_class.type, [&](const std::string& name, bool visualization) {
    PyTypeObject* const made = class_of_name(item_class, visualization);
    module.add_object(name.c_str(), py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(made)), true);
  });
}

const ItemType& require_type_of_any_package(ItemKind kind, std::string_view name, const std::string& where) {
  if (find_type(kind, name) == nullptr) py::module_::import("dalembert._tools.item_packages").attr("load_installed")();
  return require_type(kind, name, where);
}

py::list packages_of(const Model& model) {
  std::set<std::string> modules;
  const ItemType* last = nullptr;
  for (int k = 0; k < item_kinds; ++k)
    for (int i = 0; i < model.count(static_cast<ItemKind>(k)); ++i) {
      const ItemType* type = model.item(static_cast<ItemKind>(k), i).type;
      if (type == last) continue;
      last = type;
      const py::handle cls(reinterpret_cast<PyObject*>(class_of(*type).python_type));
      if (std::string module = cls.attr("__module__").cast<std::string>(); module != "dalembert._core")
        modules.insert(std::move(module));
    }
  py::list names;
  for (const std::string& module : modules) names.append(module);
  return names;
}

void load_packages(const py::handle& names, const std::string& where) {
  py::module_::import("dalembert._tools.item_packages").attr("load")(names, where);
}

void register_item_packages(py::module_& module) {
  module.def("_add_item_package", &add_item_package, py::arg("package"), py::arg("module"), py::pos_only(),
             "Take over the item types of an extension module, and add their classes to it.");
  module.def("_item_classes", &classes_by_name,
             "The classes of items and of their visualization, of packages too, by full and short names.");
  module.def("_item_stamp", [] { return own_stamp(); }, "The binary interface that item packages must be built for.");
}

}  // namespace dalembert
