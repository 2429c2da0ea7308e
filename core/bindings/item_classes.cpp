#include "item_classes.hpp"

#include <array>
#include <cstdint>
#include <deque>
#include <new>
#include <unordered_map>

#include "call_arguments.hpp"
#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "dalembert/reflection/item_transformations.hpp"
#include "index_lists.hpp"
#include "item_docs.hpp"
#include "item_equality.hpp"
#include "item_packages.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

std::vector<std::unique_ptr<ItemClass>> classes;
std::unordered_map<const PyTypeObject*, const ItemClass*> by_python_type;  // contains items and V classes
std::unordered_map<const ItemType*, const ItemClass*> by_item_type;
std::array<std::unordered_map<const PyObject*, const ItemClass*>, item_kinds> by_type_name;  // interned
PyTypeObject* item_base = nullptr;
PyTypeObject* visualization_base = nullptr;

// Names that CPython keeps pointers to: they live as long as the process.
const char* keep(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text)).c_str();
}

// Python classes may be derived from ours; the nearest of ours counts.
const ItemClass& class_of_python_type(PyTypeObject* type) {
  struct Known {
    const PyTypeObject* type = nullptr;
    const ItemClass* item_class = nullptr;
  };
  static std::array<Known, 64> last_asked{};  // cache by the hash of the type; our types are never freed
  Known& known = last_asked[reinterpret_cast<std::uintptr_t>(type) / 512 % last_asked.size()];
  if (known.type == type) return *known.item_class;
  if (const auto own = by_python_type.find(type); own != by_python_type.end()) {
    known = {type, own->second};
    return *own->second;
  }
  for (PyTypeObject* t = type; t != nullptr; t = t->tp_base)
    if (const auto found = by_python_type.find(t); found != by_python_type.end()) return *found->second;
  throw std::logic_error("not an item class");
}

bool is_view(Storage storage) {
  return (storage >= Storage::vector2 && storage <= Storage::matrix6) || storage == Storage::beam_section;
}

bool is_index_list(Storage storage) { return storage >= Storage::nodes && storage <= Storage::sensors; }

// ---- life of the Python objects ------------------------------------------------------------------------------------

template <class Object>
Object* allocate(PyTypeObject* type, const ItemClass& item_class, std::shared_ptr<void> record) {
  auto* self = reinterpret_cast<Object*>(type->tp_alloc(type, 0));
  if (self == nullptr) throw py::error_already_set();
  self->item_class = &item_class;
  new (&self->record) std::shared_ptr<void>(std::move(record));
  return self;
}

template <class Object>
PyObject* object_new(PyTypeObject* type, PyObject*, PyObject*) {
  return guarded([&] {
    const ItemClass& item_class = class_of_python_type(type);
    return reinterpret_cast<PyObject*>(allocate<Object>(type, item_class, item_class.type->record.create()));
  });
}

template <class Object>
int object_init(PyObject* self, PyObject* args, PyObject* kwargs) {
  return guarded_status([&] {
    auto* object = reinterpret_cast<Object*>(self);
    assign_init_arguments({*object->item_class, object->record.get(), std::is_same_v<Object, VisualizationObject>},
                          args, kwargs);
  });
}

// The way of NodePoint(...): no tuple, no dictionary, and no class that Python code has derived, which may need more memory.
template <class Object>
PyObject* object_call(PyObject* type, PyObject* const* values, std::size_t flags, PyObject* keywords) {
  return guarded([&] {
    auto* python_type = reinterpret_cast<PyTypeObject*>(type);
    const ItemClass& item_class = class_of_python_type(python_type);
    std::shared_ptr<void> record = item_class.type->record.create();
    assign_arguments({item_class, record.get(), std::is_same_v<Object, VisualizationObject>}, values,
                     static_cast<std::size_t>(PyVectorcall_NARGS(flags)), keywords);
    auto* self = PyObject_New(Object, python_type);
    if (self == nullptr) throw py::error_already_set();
    self->item_class = &item_class;
    new (&self->record) std::shared_ptr<void>(std::move(record));
    if constexpr (std::is_same_v<Object, ItemObject>) self->exposed = self->shared = false;
    return reinterpret_cast<PyObject*>(self);
  });
}

template <class Object>
void object_dealloc(PyObject* self) {
  PyTypeObject* type = Py_TYPE(self);
  reinterpret_cast<Object*>(self)->record.~shared_ptr();
  type->tp_free(self);
  Py_DECREF(type);
}

// ---- attributes -----------------------------------------------------------------------------------------------------

// Called before a change: copies a record that is shared with a system.
void detach(ItemObject* item) {
  if (!item->shared) return;
  item->record = item->item_class->type->record.copy(item->record.get());
  item->shared = false;
}
void detach(VisualizationObject*) {}
void expose(ItemObject* item) {
  detach(item);
  item->exposed = true;
}
void expose(VisualizationObject*) {}

template <class Object>
PyObject* get_attribute(PyObject* self, void* closure) {
  return guarded([&] {
    auto* object = reinterpret_cast<Object*>(self);
    const Row& row = *static_cast<const Row*>(closure);
    const bool view = is_view(row.storage);
    if (view) expose(object);
    PyObject* value = to_python(row, member(object->record.get(), row), view ? Form::view : Form::copy, self);
    if (!is_index_list(row.storage)) return value;
    const auto entries = py::reinterpret_steal<py::object>(value);
    return make_index_list(entries.ptr(), self, py::str(std::string(row.name)).ptr());
  });
}

template <class Object>
int set_attribute(PyObject* self, PyObject* value, void* closure) {
  return guarded_status([&] {
    auto* object = reinterpret_cast<Object*>(self);
    const Row& row = *static_cast<const Row*>(closure);
    detach(object);
    const CallTarget target{*object->item_class, object->record.get(), std::is_same_v<Object, VisualizationObject>};
    if (value == nullptr || row.internal) {
      refuse(ErrorKind::name, {target.where(), std::string(row.name),
                               value == nullptr ? "cannot be deleted" : "cannot be set", "", "", ""});
    }
    set_member(*object->item_class, row, value, object->record.get(), [&] { return target.where(); });
  });
}

PyObject* get_transformation_attribute(PyObject* self, void* closure) {
  return guarded([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    return get_transformation(item->item_class->transformations[reinterpret_cast<std::size_t>(closure)],
                              item->record.get())
        .release()
        .ptr();
  });
}
int set_transformation_attribute(PyObject* self, PyObject* value, void* closure) {
  return guarded_status([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    detach(item);
    const CallTarget target{*item->item_class, item->record.get(), false};
    set_transformation(*item->item_class, item->item_class->transformations[reinterpret_cast<std::size_t>(closure)],
                       value == nullptr ? Py_None : value, item->record.get(), [&] { return target.where(); });
  });
}

PyObject* get_visualization(PyObject* self, void*) {
  return guarded([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    expose(item);
    return reinterpret_cast<PyObject*>(
        allocate<VisualizationObject>(item->item_class->visualization_type, *item->item_class, item->record));
  });
}

int assign_visualization(PyObject* self, PyObject* value, void*) {
  return guarded_status([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    detach(item);
    set_visualization(*item->item_class, value == nullptr ? Py_None : value, item->record.get(),
                      [&] { return item->item_class->type->name; });
  });
}

// A misspelt attribute must not vanish silently, nor create a new one.
template <class Object>
int set_any_attribute(PyObject* self, PyObject* name, PyObject* value) {
  const int status = PyObject_GenericSetAttr(self, name, value);
  if (status == 0 || PyErr_ExceptionMatches(PyExc_AttributeError) == 0) return status;
  const ItemType& type = *reinterpret_cast<Object*>(self)->item_class->type;
  return guarded_status([&] {
    const std::string word = to_string(name);
    if (find_row(type, word) != nullptr || word == "visualization") throw py::error_already_set();
    PyErr_Clear();
    refuse(ErrorKind::name, {std::string(type.name), "", "there is no parameter " + in_quotes(word), "", "",
                             suggest_parameter(type, word)});
  });
}

// ---- the rest of the protocol ----------------------------------------------------------------------------------------

PyObject* item_iterate(PyObject* self) {
  return guarded([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    const ItemType& type = *item->item_class->type;
    const py::dict all = item_dictionary(type, item->record.get(), name_in(type, item->record.get()), true);
    return py::iter(all.attr("items")()).release().ptr();
  });
}

py::dict visualization_dictionary(const ItemClass& item_class, const void* record) {
  py::dict all;
  for (const auto& argument : item_class.visualization_arguments)
    all[argument.name] =
        py::reinterpret_steal<py::object>(to_python(*argument.row, member(record, *argument.row), Form::copy, nullptr));
  return all;
}

PyObject* visualization_iterate(PyObject* self) {
  return guarded([&] {
    auto* object = reinterpret_cast<VisualizationObject*>(self);
    return py::iter(visualization_dictionary(*object->item_class, object->record.get()).attr("items")())
        .release()
        .ptr();
  });
}

PyObject* visualization_keys(PyObject* self, PyObject*) {
  return guarded([&] {
    auto* object = reinterpret_cast<VisualizationObject*>(self);
    return PySequence_List(visualization_dictionary(*object->item_class, object->record.get()).ptr());
  });
}

const Row& require_visualization_row(PyObject* self, PyObject* key) {
  const ItemType& type = *reinterpret_cast<VisualizationObject*>(self)->item_class->type;
  const Row* row = PyUnicode_Check(key) ? find_visualization_row(type, to_string(key)) : nullptr;
  if (row == nullptr) throw py::key_error("V" + std::string(type.name) + " has no parameter " + show(key));
  return *row;
}
PyObject* visualization_get_item(PyObject* self, PyObject* key) {
  return guarded([&] {
    const Row& row = require_visualization_row(self, key);
    return get_attribute<VisualizationObject>(self, const_cast<Row*>(&row));
  });
}
int visualization_set_item(PyObject* self, PyObject* key, PyObject* value) {
  return guarded_status([&] {
    const Row& row = require_visualization_row(self, key);
    if (set_attribute<VisualizationObject>(self, value, const_cast<Row*>(&row)) != 0) throw py::error_already_set();
  });
}

py::tuple argument_values(const ItemClass& item_class, const void* record) {
  py::list values;
  for (const auto& argument : item_class.arguments) {
    if (argument.row == nullptr) {
      values.append(visualization_dictionary(item_class, record));
    } else {
      values.append(py::reinterpret_steal<py::object>(
          to_python(*argument.row, member(record, *argument.row), Form::copy, nullptr)));
    }
  }
  return py::tuple(values);
}

PyObject* item_reduce(PyObject* self, PyObject*) {
  return guarded([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    return py::make_tuple(py::handle(reinterpret_cast<PyObject*>(Py_TYPE(self))),
                          argument_values(*item->item_class, item->record.get()))
        .release()
        .ptr();
  });
}
PyObject* visualization_reduce(PyObject* self, PyObject*) {
  return guarded([&] {
    auto* object = reinterpret_cast<VisualizationObject*>(self);
    const py::list values(visualization_dictionary(*object->item_class, object->record.get()).attr("values")());
    return py::make_tuple(py::handle(reinterpret_cast<PyObject*>(Py_TYPE(self))), py::tuple(values)).release().ptr();
  });
}

template <class Object>
PyObject* object_compare(PyObject* self, PyObject* other, int operation) {
  if ((operation != Py_EQ && operation != Py_NE) || PyObject_TypeCheck(other, Py_TYPE(self)) == 0)
    Py_RETURN_NOTIMPLEMENTED;
  return guarded([&] {
    auto* a = reinterpret_cast<Object*>(self);
    auto* b = reinterpret_cast<Object*>(other);
    bool equal = a->item_class == b->item_class;
    for (const Row& row : a->item_class->type->rows) {
      if (!equal) break;
      if (std::is_same_v<Object, VisualizationObject> && row.role != Role::visualization) continue;
      equal = equal_members(row, a->record.get(), b->record.get());
    }
    return PyBool_FromLong(equal == (operation == Py_EQ) ? 1 : 0);
  });
}

template <class Object>
PyObject* object_repr(PyObject* self) {
  return guarded([&] {
    auto* object = reinterpret_cast<Object*>(self);
    const bool visualization = std::is_same_v<Object, VisualizationObject>;
    return py::str(item_repr(*object->item_class, object->record.get(), visualization)).release().ptr();
  });
}

// ---- making the types ----------------------------------------------------------------------------------------------

PyMethodDef item_methods[] = {
    {"__reduce__", item_reduce, METH_NOARGS, nullptr},
    {nullptr, nullptr, 0, nullptr},
};
PyMethodDef visualization_methods[] = {
    {"keys", visualization_keys, METH_NOARGS, "The names of the visualization parameters."},
    {"__reduce__", visualization_reduce, METH_NOARGS, nullptr},
    {nullptr, nullptr, 0, nullptr},
};

PyTypeObject* make_type(const std::string& name, const std::string& doc, std::size_t size,
                        std::vector<PyType_Slot> slots, PyTypeObject* base) {
  slots.push_back({Py_tp_doc, const_cast<char*>(keep(doc))});
  slots.push_back({0, nullptr});
  PyType_Spec spec{keep(name), static_cast<int>(size), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, slots.data()};
  PyObject* type = PyType_FromSpecWithBases(&spec, reinterpret_cast<PyObject*>(base));
  if (type == nullptr) throw py::error_already_set();
  return reinterpret_cast<PyTypeObject*>(type);
}

template <class Object>
std::vector<PyType_Slot> common_slots() {
  return {
      {Py_tp_new, reinterpret_cast<void*>(object_new<Object>)},
      {Py_tp_init, reinterpret_cast<void*>(object_init<Object>)},
      {Py_tp_dealloc, reinterpret_cast<void*>(object_dealloc<Object>)},
      {Py_tp_repr, reinterpret_cast<void*>(object_repr<Object>)},
      {Py_tp_richcompare, reinterpret_cast<void*>(object_compare<Object>)},
      {Py_tp_hash, reinterpret_cast<void*>(PyObject_HashNotImplemented)},
      {Py_tp_setattro, reinterpret_cast<void*>(set_any_attribute<Object>)},
  };
}

template <class Object>
PyGetSetDef* make_attributes(const ItemClass& item_class, bool visualization) {
  const ItemType& type = *item_class.type;
  static std::deque<std::vector<PyGetSetDef>> kept;
  auto& attributes = kept.emplace_back();
  for (const Row& row : type.rows) {
    if ((row.role == Role::visualization) != visualization) continue;
    const auto add = [&](std::string_view name) {
      attributes.push_back({keep(std::string(name)), get_attribute<Object>, set_attribute<Object>,
                            keep(row_doc(type, row)), const_cast<Row*>(&row)});
    };
    add(row.name);
    for (const std::string_view alias : row.aliases) add(alias);
  }
  if (!visualization)
    for (std::size_t i = 0; i < item_class.transformations.size(); ++i)
      attributes.push_back({PyUnicode_AsUTF8(item_class.transformations[i].name), get_transformation_attribute,
                            set_transformation_attribute, "Position and rotation as exu.HT.",
                            reinterpret_cast<void*>(i)});
  if (!visualization)
    attributes.push_back({"visualization", get_visualization, assign_visualization, "How the item is drawn.", nullptr});
  attributes.push_back({nullptr, nullptr, nullptr, nullptr, nullptr});
  return attributes.data();
}

PyObject* interned(const std::string& name) { return PyUnicode_InternFromString(name.c_str()); }

// The names of an item type and of its parameters, as programs spell them.
void add_names(ItemClass& item_class) {
  const ItemType& type = *item_class.type;
  for (const Row& row : type.rows) {
    const bool visualization = row.role == Role::visualization;
    const std::string prefix = visualization ? "V" : "", name(row.name);
    item_class.entries.push_back({&row, interned(prefix + name)});
    for (const std::string_view alias : row.aliases)
      item_class.entries.push_back({&row, interned(prefix + std::string(alias))});
    if (row.internal) continue;
    (visualization ? item_class.visualization_arguments : item_class.arguments).push_back({&row, interned(name)});
  }
  for (const ItemTransformation& each : item_transformations())
    if (each.item == type.name)
      item_class.transformations.push_back({interned(std::string(each.name)),
                                            each.position.empty() ? nullptr : find_row(type, each.position),
                                            find_row(type, each.rotation)});
  item_class.arguments.push_back({nullptr, interned("visualization")});
  item_class.entries.push_back({nullptr, interned("visualization")});
  for (const std::string_view name : {type.type_name, type.name})
    by_type_name[static_cast<std::size_t>(type.kind)][interned(std::string(name))] = &item_class;
}

PyTypeObject* make_base(const char* name, const char* doc, std::size_t size) {
  PyType_Slot slots[] = {{Py_tp_doc, const_cast<char*>(doc)}, {0, nullptr}};
  PyType_Spec spec{name, static_cast<int>(size), 0,
                   Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE | Py_TPFLAGS_DISALLOW_INSTANTIATION, slots};
  auto* type = reinterpret_cast<PyTypeObject*>(PyType_FromSpec(&spec));
  if (type == nullptr) throw py::error_already_set();
  return type;
}

}  // namespace

const ItemClass& make_class(const ItemType& type, const std::string& module) {
  auto item_class = std::make_unique<ItemClass>();
  item_class->type = &type;
  item_class->defaults = type.record.create();
  add_names(*item_class);

  const std::string name(type.name);
  auto slots = common_slots<ItemObject>();
  slots.push_back({Py_tp_iter, reinterpret_cast<void*>(item_iterate)});
  slots.push_back({Py_tp_methods, item_methods});
  slots.push_back({Py_tp_getset, make_attributes<ItemObject>(*item_class, false)});
  item_class->python_type =
      make_type(module + "." + name, class_doc(*item_class, false), sizeof(ItemObject), slots, item_base);
  item_class->python_type->tp_vectorcall = object_call<ItemObject>;

  slots = common_slots<VisualizationObject>();
  slots.push_back({Py_tp_iter, reinterpret_cast<void*>(visualization_iterate)});
  slots.push_back({Py_mp_subscript, reinterpret_cast<void*>(visualization_get_item)});
  slots.push_back({Py_mp_ass_subscript, reinterpret_cast<void*>(visualization_set_item)});
  slots.push_back({Py_tp_methods, visualization_methods});
  slots.push_back({Py_tp_getset, make_attributes<VisualizationObject>(*item_class, true)});
  item_class->visualization_type = make_type(module + ".V" + name, class_doc(*item_class, true),
                                             sizeof(VisualizationObject), slots, visualization_base);
  item_class->visualization_type->tp_vectorcall = object_call<VisualizationObject>;

  by_python_type[item_class->python_type] = by_python_type[item_class->visualization_type] = item_class.get();
  by_item_type[&type] = item_class.get();
  return *classes.emplace_back(std::move(item_class));
}

const std::vector<std::unique_ptr<ItemClass>>& item_classes() { return classes; }
const ItemClass& class_of(const ItemType& type) { return *by_item_type.at(&type); }

const ItemClass* find_class(ItemKind kind, PyObject* name) {
  const auto& names = by_type_name[static_cast<std::size_t>(kind)];
  const auto found = names.find(name);
  return found == names.end() ? nullptr : found->second;
}

ItemObject* as_item(PyObject* value) {
  return PyObject_TypeCheck(value, item_base) ? reinterpret_cast<ItemObject*>(value) : nullptr;
}
VisualizationObject* as_visualization(PyObject* value) {
  return PyObject_TypeCheck(value, visualization_base) ? reinterpret_cast<VisualizationObject*>(value) : nullptr;
}

Item take_item(ItemObject* object) {
  const ItemType& type = *object->item_class->type;
  if (object->exposed) return {&type, type.record.copy(object->record.get())};
  object->shared = true;
  return {&type, object->record};
}

void register_items(py::module_& module) {
  item_base = make_base("dalembert._core.Item", "Base of all item classes.", sizeof(ItemObject));
  visualization_base =
      make_base("dalembert._core.Visualization", "Base of all visualization classes.", sizeof(VisualizationObject));
  const auto add = [&](const std::string& name, PyTypeObject* type) {
    module.add_object(name.c_str(), py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(type)), true);
  };
  module.def(
      "_parameters_of",
      [](const py::type& cls) {
        const auto found = by_python_type.find(reinterpret_cast<const PyTypeObject*>(cls.ptr()));
        if (found == by_python_type.end())
          throw py::type_error("_parameters_of: " + py::repr(cls).cast<std::string>() + " is no item class");
        return described_parameters(*found->second, found->first == found->second->visualization_type);
      },
      py::arg("cls"), py::pos_only(),
      "(name, type, check, facts, text, other names) of the parameters of an item class or a visualization class.");
  module.def(
      "_outputs_of",
      [](const py::type& cls) {
        const auto found = by_python_type.find(reinterpret_cast<const PyTypeObject*>(cls.ptr()));
        if (found == by_python_type.end())
          throw py::type_error("_outputs_of: " + py::repr(cls).cast<std::string>() + " is no item class");
        return described_outputs(*found->second);
      },
      py::arg("cls"), py::pos_only(),
      "(name, size, unit, text) of the output variables of an item class; size 0: it depends on the item.");
  add("Item", item_base);
  add("Visualization", visualization_base);
  for (const ItemType* type : item_types()) add_classes(module, make_class(*type, "dalembert._core"));
  register_item_packages(module);
}

}  // namespace dalembert
