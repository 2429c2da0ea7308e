// The Python classes of items: compiled types that hold a record, made at import from the reflection rows.
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

#include "dalembert/model/item.hpp"
#include "label.hpp"

namespace dalembert {

namespace py = pybind11;

struct ItemClass {
  const ItemType* type = nullptr;
  PyTypeObject* python_type = nullptr;          // NodePoint
  PyTypeObject* visualization_type = nullptr;   // VNodePoint
  struct Argument {
    const Row* row = nullptr;    // nullptr: the argument `visualization`
    PyObject* name = nullptr;    // interned
  };
  std::vector<Argument> arguments;  // arguments of NodePoint(...), by position
  std::vector<Argument> visualization_arguments;  // of VNodePoint(...)
  // A rigid transformation as another way to give a position and a rotation, or lists of them; null: only a rotation.
  struct Transformation {
    PyObject* name = nullptr;  // interned
    const Row *position = nullptr, *rotation = nullptr;
  };
  std::vector<Transformation> transformations;
  std::vector<Argument> entries;  // entries of dictionaries, with aliases; visualization parameters begin with 'V'
  std::shared_ptr<const void> defaults;  // a record as the spec gives it
};

// A Python item. Its record is either used only by Python, or shared with a system and then never written.
struct ItemObject {
  PyObject_HEAD const ItemClass* item_class;
  std::shared_ptr<void> record;
  bool exposed;  // numpy views or V objects write to the record: systems must copy it
  bool shared;  // a system has it: Python must copy it before a change
};

// VNodePoint(...), or the attribute `visualization` of an item, whose record it then shares.
struct VisualizationObject {
  PyObject_HEAD const ItemClass* item_class;
  std::shared_ptr<void> record;
};

const std::vector<std::unique_ptr<ItemClass>>& item_classes();
const ItemClass& class_of(const ItemType& type);
// lookup by type name; nullptr if it does not exist or is not interned
const ItemClass* find_class(ItemKind kind, PyObject* name);
const ItemClass::Argument* find_interned(const std::vector<ItemClass::Argument>& arguments,
                                         PyObject* name);  // nullptr: as before
ItemObject* as_item(PyObject* value);  // nullptr: not an item
VisualizationObject* as_visualization(PyObject* value);  // nullptr: not a V object

// The item for a model; a planned or changed record is not looked at here.
Item take_item(ItemObject* object);

// Sets one member; errors name item and parameter. `where` describes the item.
void set_member(const ItemClass& item_class, const Row& row, PyObject* value, void* record, const Label& where);
// A transformation sets position and rotation together. The value None leaves both unchanged.
const ItemClass::Transformation* find_transformation(const ItemClass& item_class,
                                                     PyObject* name);  // nullptr: there is none
void set_transformation(const ItemClass& item_class, const ItemClass::Transformation& transformation, PyObject* value,
                        void* record, const Label& where);
py::object get_transformation(const ItemClass::Transformation& transformation, const void* record);
// Set visualization parameters from a V object, a dictionary or another mapping.
void set_visualization(const ItemClass& item_class, PyObject* value, void* record, const Label& where);

// {'nodeType': 'Point', 'name': ..., ..., 'Vshow': ...}
py::dict item_dictionary(const ItemType& type, const void* record, const std::string& name, bool graphics);
// The reverse. The item's kind must be `kind`.
Item item_from_dictionary(ItemKind kind, const py::dict& dictionary, const Label& where);

// Overwrites parameters of `record`. A dictionary of GetObject has the canonical names, and users may add entries by other
// names: if a parameter is named twice, the later entry is used.
void update_from_dictionary(const ItemClass& item_class, const py::dict& dictionary, void* record, const Label& where);

void register_items(py::module_& module);

}  // namespace dalembert
