// Item types of other extension modules.
#pragma once

#include "dalembert/model/model.hpp"
#include "item_classes.hpp"

namespace dalembert {

// Makes the Python classes of an item type, with the given __module__. In item_classes.cpp.
const ItemClass& make_class(const ItemType& type, const std::string& module);
// Adds the classes of an item type to a module, by their full and short names.
void add_classes(py::module_& module, const ItemClass& item_class);

// The type with this name; installed item packages are imported if no imported one has it. Throws ModelError if there is
// no such type.
const ItemType& require_type_of_any_package(ItemKind kind, std::string_view name, const std::string& where);

// Names of the modules of packages that items of a model are from.
py::list packages_of(const Model& model);
// Imports them. Throws ImportError with the name of a missing one.
void load_packages(const py::handle& names, const std::string& where);

void register_item_packages(py::module_& module);

}  // namespace dalembert
