#include "item_classes.hpp"

#include <deque>
#include <new>
#include <unordered_map>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/member.hpp"
#include "item_docs.hpp"
#include "item_equality.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

std::vector<std::unique_ptr<ItemClass>> classes;
std::unordered_map<const PyTypeObject*, const ItemClass*> by_python_type;  // items and V classes alike
std::unordered_map<const ItemType*, const ItemClass*> by_item_type;
PyTypeObject* item_base = nullptr;
PyTypeObject* visualization_base = nullptr;

// Names that CPython keeps pointers to: they live as long as the process.
const char* keep(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text)).c_str();
}

// Python classes may be derived from ours; the nearest of ours counts.
const ItemClass& class_of_python_type(PyTypeObject* type) {
  for (PyTypeObject* t = type; t != nullptr; t = t->tp_base)
    if (const auto found = by_python_type.find(t); found != by_python_type.end()) return *found->second;
  throw std::logic_error("not an item class");
}

bool is_view(Storage storage) { return storage >= Storage::vector2 && storage <= Storage::matrix6; }

// ---- arguments -----------------------------------------------------------------------------------------------------

// What a call of a class assigns: items and V classes differ only in this.
struct Target {
  const ItemClass& item_class;
  void* record;
  bool visualization;  // a V class

  const std::vector<ItemClass::Argument>& arguments() const {
    return visualization ? item_class.visualization_arguments : item_class.arguments;
  }
  std::string where() const {
    const std::string name(item_class.type->name);
    if (visualization) return "V" + name;
    for (const Row& row : item_class.type->rows) {
      if (row.role != Role::name) continue;
      const auto& own = *static_cast<const std::string*>(member(record, row));
      return own.empty() ? name : name + " " + quoted(own);
    }
    return name;
  }
  void assign(std::size_t position, PyObject* value) const {
    const Row* row = arguments()[position].row;
    if (row == nullptr) {
      set_visualization(item_class, value, record, where());
    } else {
      set_member(item_class, *row, value, record, where());
    }
  }
};

std::size_t find_argument(const Target& target, PyObject* name) {
  const auto& arguments = target.arguments();
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (arguments[i].name == name) return i;  // keywords are interned
  const std::string word = to_string(name);
  const ItemType& type = *target.item_class.type;
  const Row* row = target.visualization ? find_visualization_row(type, word) : find_row(type, word);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (row != nullptr && arguments[i].row == row && (target.visualization || row->role != Role::visualization)) return i;
    if (row == nullptr && to_string(arguments[i].name) == word) return i;
  }
  std::vector<std::string> names;
  for (const auto& argument : arguments) names.push_back(to_string(argument.name));
  refuse(ErrorKind::type, {target.where(), "", "there is no parameter " + quoted(word), "", "",
                           suggestion(word, {names.begin(), names.end()})});
}

void assign_arguments(const Target& target, PyObject* const* values, std::size_t positional, PyObject* keywords) {
  const std::size_t most = target.arguments().size();
  if (positional > most) {
    refuse(ErrorKind::type, {target.where(), "", "", std::to_string(positional) + " positional arguments",
                             "at most " + std::to_string(most), "Name the parameters: " + std::string(target.item_class.type->name) +
                             "(" + to_string(target.arguments()[0].name) + "=...)"});
  }
  for (std::size_t i = 0; i < positional; ++i) target.assign(i, values[i]);
  const Py_ssize_t named = keywords == nullptr ? 0 : PyTuple_GET_SIZE(keywords);
  for (Py_ssize_t k = 0; k < named; ++k) {
    const std::size_t i = find_argument(target, PyTuple_GET_ITEM(keywords, k));
    if (i < positional)
      refuse(ErrorKind::type, {target.where(), to_string(target.arguments()[i].name), "given by position and by name", "", "", ""});
    target.assign(i, values[positional + static_cast<std::size_t>(k)]);
  }
}

// The same from what __init__ receives.
void assign_init_arguments(const Target& target, PyObject* args, PyObject* kwargs) {
  std::vector<PyObject*> values;
  for (Py_ssize_t i = 0; i < PyTuple_GET_SIZE(args); ++i) values.push_back(PyTuple_GET_ITEM(args, i));
  py::object names;
  if (kwargs != nullptr) {
    names = py::reinterpret_steal<py::object>(PySequence_Tuple(kwargs));
    for (Py_ssize_t k = 0; k < PyTuple_GET_SIZE(names.ptr()); ++k)
      values.push_back(PyDict_GetItem(kwargs, PyTuple_GET_ITEM(names.ptr(), k)));
  }
  assign_arguments(target, values.data(), static_cast<std::size_t>(PyTuple_GET_SIZE(args)), names.ptr());
}

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
    assign_init_arguments({*object->item_class, object->record.get(), std::is_same_v<Object, VisualizationObject>}, args, kwargs);
  });
}

// The way of NodePoint(...): no tuple, no dictionary.
template <class Object>
PyObject* object_call(PyObject* type, PyObject* const* values, std::size_t flags, PyObject* keywords) {
  return guarded([&] {
    auto* python_type = reinterpret_cast<PyTypeObject*>(type);
    const ItemClass& item_class = class_of_python_type(python_type);
    std::shared_ptr<void> record = item_class.type->record.create();
    assign_arguments({item_class, record.get(), std::is_same_v<Object, VisualizationObject>}, values,
                     static_cast<std::size_t>(PyVectorcall_NARGS(flags)), keywords);
    return reinterpret_cast<PyObject*>(allocate<Object>(python_type, item_class, std::move(record)));
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

// Before a change: a record that a system shares is copied.
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
    return to_python(row, member(object->record.get(), row), view ? Form::view : Form::copy, self);
  });
}

template <class Object>
int set_attribute(PyObject* self, PyObject* value, void* closure) {
  return guarded_status([&] {
    auto* object = reinterpret_cast<Object*>(self);
    const Row& row = *static_cast<const Row*>(closure);
    detach(object);
    const Target target{*object->item_class, object->record.get(), std::is_same_v<Object, VisualizationObject>};
    if (value == nullptr || row.internal) {
      refuse(ErrorKind::name, {target.where(), std::string(row.name), value == nullptr ? "cannot be deleted" : "cannot be set", "",
                               "", ""});
    }
    set_member(*object->item_class, row, value, object->record.get(), target.where());
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
                      std::string(item->item_class->type->name));
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
    refuse(ErrorKind::name, {std::string(type.name), "", "there is no parameter " + quoted(word), "", "", suggest_parameter(type, word)});
  });
}

// ---- the rest of the protocol ----------------------------------------------------------------------------------------

PyObject* item_iterate(PyObject* self) {
  return guarded([&] {
    auto* item = reinterpret_cast<ItemObject*>(self);
    const py::dict all = item_dictionary(*item->item_class->type, item->record.get(), item_name(*item), true);
    return py::iter(all.attr("items")()).release().ptr();
  });
}

py::dict visualization_dictionary(const ItemClass& item_class, const void* record) {
  py::dict all;
  for (const auto& argument : item_class.visualization_arguments)
    all[argument.name] = py::reinterpret_steal<py::object>(
        to_python(*argument.row, member(record, *argument.row), Form::copy, nullptr));
  return all;
}

PyObject* visualization_iterate(PyObject* self) {
  return guarded([&] {
    auto* object = reinterpret_cast<VisualizationObject*>(self);
    return py::iter(visualization_dictionary(*object->item_class, object->record.get()).attr("items")()).release().ptr();
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
                          argument_values(*item->item_class, item->record.get())).release().ptr();
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
  if ((operation != Py_EQ && operation != Py_NE) || PyObject_TypeCheck(other, Py_TYPE(self)) == 0) Py_RETURN_NOTIMPLEMENTED;
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

PyTypeObject* make_type(const std::string& name, const std::string& doc, std::size_t size, std::vector<PyType_Slot> slots,
                        PyTypeObject* base) {
  slots.push_back({Py_tp_doc, const_cast<char*>(keep(doc))});
  slots.push_back({0, nullptr});
  PyType_Spec spec{keep("dalembert._core." + name), static_cast<int>(size), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE,
                   slots.data()};
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
PyGetSetDef* make_attributes(const ItemType& type, bool visualization) {
  static std::deque<std::vector<PyGetSetDef>> kept;
  auto& attributes = kept.emplace_back();
  for (const Row& row : type.rows) {
    if ((row.role == Role::visualization) != visualization) continue;
    const auto add = [&](std::string_view name) {
      attributes.push_back({keep(std::string(name)), get_attribute<Object>, set_attribute<Object>,
                            keep(row_doc(row)), const_cast<Row*>(&row)});
    };
    add(row.name);
    for (const std::string_view alias : row.aliases) add(alias);
  }
  if (!visualization) attributes.push_back({"visualization", get_visualization, assign_visualization, "How the item is drawn.", nullptr});
  attributes.push_back({nullptr, nullptr, nullptr, nullptr, nullptr});
  return attributes.data();
}

ItemClass::Argument argument(const Row* row, std::string_view name) {
  return {row, PyUnicode_InternFromString(std::string(name).c_str())};
}

void make_class(const ItemType& type) {
  auto item_class = std::make_unique<ItemClass>();
  item_class->type = &type;
  item_class->defaults = type.record.create();
  for (const Row& row : type.rows) {
    if (row.internal) continue;
    auto& list = row.role == Role::visualization ? item_class->visualization_arguments : item_class->arguments;
    list.push_back(argument(&row, row.name));
  }
  item_class->arguments.push_back(argument(nullptr, "visualization"));

  const std::string name(type.name);
  auto slots = common_slots<ItemObject>();
  slots.push_back({Py_tp_iter, reinterpret_cast<void*>(item_iterate)});
  slots.push_back({Py_tp_methods, item_methods});
  slots.push_back({Py_tp_getset, make_attributes<ItemObject>(type, false)});
  item_class->python_type = make_type(name, class_doc(*item_class, false), sizeof(ItemObject), slots, item_base);
  item_class->python_type->tp_vectorcall = object_call<ItemObject>;

  slots = common_slots<VisualizationObject>();
  slots.push_back({Py_tp_iter, reinterpret_cast<void*>(visualization_iterate)});
  slots.push_back({Py_mp_subscript, reinterpret_cast<void*>(visualization_get_item)});
  slots.push_back({Py_mp_ass_subscript, reinterpret_cast<void*>(visualization_set_item)});
  slots.push_back({Py_tp_methods, visualization_methods});
  slots.push_back({Py_tp_getset, make_attributes<VisualizationObject>(type, true)});
  item_class->visualization_type =
      make_type("V" + name, class_doc(*item_class, true), sizeof(VisualizationObject), slots, visualization_base);
  item_class->visualization_type->tp_vectorcall = object_call<VisualizationObject>;

  by_python_type[item_class->python_type] = by_python_type[item_class->visualization_type] = item_class.get();
  by_item_type[&type] = item_class.get();
  classes.push_back(std::move(item_class));
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

const std::vector<std::unique_ptr<ItemClass>>& item_classes() { return classes; }
const ItemClass& class_of(const ItemType& type) { return *by_item_type.at(&type); }

ItemObject* as_item(PyObject* value) {
  return PyObject_TypeCheck(value, item_base) ? reinterpret_cast<ItemObject*>(value) : nullptr;
}
VisualizationObject* as_visualization(PyObject* value) {
  return PyObject_TypeCheck(value, visualization_base) ? reinterpret_cast<VisualizationObject*>(value) : nullptr;
}

std::string item_name(const ItemObject& item) {
  for (const Row& row : item.item_class->type->rows)
    if (row.role == Role::name) return *static_cast<const std::string*>(member(item.record.get(), row));
  return {};
}

Item take_item(ItemObject* object) {
  const ItemType& type = *object->item_class->type;
  Item item{&type, object->record, item_name(*object)};
  if (object->exposed) {
    item.record = type.record.copy(object->record.get());
  } else {
    object->shared = true;
  }
  return item;
}

void register_items(py::module_& module) {
  item_base = make_base("dalembert._core.Item", "Base of all item classes.", sizeof(ItemObject));
  visualization_base = make_base("dalembert._core.Visualization", "Base of all visualization classes.", sizeof(VisualizationObject));
  const auto add = [&](const std::string& name, PyTypeObject* type) {
    module.add_object(name.c_str(), py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(type)), true);
  };
  add("Item", item_base);
  add("Visualization", visualization_base);
  for (const ItemType* type : item_types()) {
    make_class(*type);
    const ItemClass& item_class = *classes.back();
    add(std::string(type->name), item_class.python_type);
    add("V" + std::string(type->name), item_class.visualization_type);
    for (const std::string_view name : type->short_names) {
      add(std::string(name), item_class.python_type);
      add("V" + std::string(name), item_class.visualization_type);
    }
  }
}

}  // namespace dalembert
