#include "index_types.hpp"

#include <array>
#include <string>

#include "dalembert/model/errors.hpp"
#include "python_errors.hpp"

namespace dalembert {
namespace {

struct IndexObject {
  PyObject_HEAD int number;
};

std::array<PyTypeObject*, item_kinds> types{};

int& number_of(PyObject* self) { return reinterpret_cast<IndexObject*>(self)->number; }

// The kind of an index object, or -1.
int kind_of_object(PyObject* value) {
  for (int k = 0; k < item_kinds; ++k)
    if (Py_TYPE(value) == types[static_cast<std::size_t>(k)]) return k;
  for (int k = 0; k < item_kinds; ++k)
    if (types[static_cast<std::size_t>(k)] != nullptr && PyObject_TypeCheck(value, types[static_cast<std::size_t>(k)]))
      return k;
  return -1;
}

ItemKind kind_of_type(PyTypeObject* type) {
  for (std::size_t k = 0; k < item_kinds; ++k)
    if (type == types[k] || PyType_IsSubtype(type, types[k])) return static_cast<ItemKind>(k);
  return ItemKind::node;
}

[[noreturn]] void refuse_value(ItemKind kind, PyObject* value) {
  Complaint complaint;
  complaint.item = std::string(index_name(kind));
  complaint.received = show(value);
  complaint.expected = "an integer";
  complaint.advice = "Pass the number of " + with_article(kind_name(kind)) + ", or nothing for an invalid index.";
  refuse(ErrorKind::type, complaint);
}

int read_number(ItemKind kind, PyObject* value) {
  ItemKind given{};
  int number = -1;
  if (read_index(value, given, number)) return number;  // an explicit conversion is meant
  if (PyFloat_Check(value) || !PyIndex_Check(value)) refuse_value(kind, value);
  const Py_ssize_t wide = PyNumber_AsSsize_t(value, PyExc_OverflowError);
  if (wide == -1 && PyErr_Occurred() != nullptr) throw py::error_already_set();
  if (wide < -1 || wide > 0x7fffffff) refuse_value(kind, value);
  return static_cast<int>(wide);
}

PyObject* index_new(PyTypeObject* type, PyObject* args, PyObject* kwargs) {
  return guarded([&]() -> PyObject* {
    static const char* names[] = {"index", nullptr};
    PyObject* value = nullptr;
    if (PyArg_ParseTupleAndKeywords(args, kwargs, "|O", const_cast<char**>(names), &value) == 0)
      throw py::error_already_set();
    const int number = value == nullptr ? -1 : read_number(kind_of_type(type), value);
    PyObject* self = type->tp_alloc(type, 0);
    if (self == nullptr) throw py::error_already_set();
    number_of(self) = number;
    return self;
  });
}

void index_dealloc(PyObject* self) {
  PyTypeObject* type = Py_TYPE(self);
  type->tp_free(self);
  Py_DECREF(type);
}

PyObject* index_repr(PyObject* self) {
  return PyUnicode_FromFormat("%s(%d)", std::string(index_name(kind_of_type(Py_TYPE(self)))).c_str(), number_of(self));
}
PyObject* index_str(PyObject* self) { return PyUnicode_FromFormat("%d", number_of(self)); }
PyObject* index_int(PyObject* self) { return PyLong_FromLong(number_of(self)); }
PyObject* index_float(PyObject* self) { return PyFloat_FromDouble(number_of(self)); }
Py_hash_t index_hash(PyObject* self) { return number_of(self) == -1 ? -2 : number_of(self); }
int index_bool(PyObject* self) { return number_of(self) != 0; }

// Two indices are comparable only if they have the same kind; comparison with integers compares the numbers.
PyObject* index_compare(PyObject* self, PyObject* other, int operation) {
  const int kind = kind_of_object(self), other_kind = kind_of_object(other);
  if (other_kind >= 0 && other_kind != kind) {
    if (operation == Py_EQ) Py_RETURN_FALSE;
    if (operation == Py_NE) Py_RETURN_TRUE;
    Py_RETURN_NOTIMPLEMENTED;
  }
  if (other_kind < 0 && !PyLong_Check(other)) Py_RETURN_NOTIMPLEMENTED;
  PyObject* left = index_int(self);
  PyObject* right = other_kind >= 0 ? index_int(other) : Py_NewRef(other);
  PyObject* result = left != nullptr && right != nullptr ? PyObject_RichCompare(left, right, operation) : nullptr;
  Py_XDECREF(left);
  Py_XDECREF(right);
  return result;
}

// Arithmetic leaves the index types: the result is an integer, which fits every kind again.
template <PyObject* (*Operation)(PyObject*, PyObject*)>
PyObject* index_binary(PyObject* a, PyObject* b) {
  const auto plain = [](PyObject* value) -> PyObject* {
    if (kind_of_object(value) >= 0) return index_int(value);
    return PyLong_Check(value) ? Py_NewRef(value) : nullptr;
  };
  PyObject* left = plain(a);
  PyObject* right = plain(b);
  PyObject* result = nullptr;
  if (left != nullptr && right != nullptr) {
    result = Operation(left, right);
  } else if (PyErr_Occurred() == nullptr) {
    result = Py_NewRef(Py_NotImplemented);
  }
  Py_XDECREF(left);
  Py_XDECREF(right);
  return result;
}

PyObject* index_negative(PyObject* self) { return PyLong_FromLong(-number_of(self)); }

PyObject* index_type_string(PyObject* self, PyObject*) {
  const std::string_view name = index_name(kind_of_type(Py_TYPE(self)));
  return PyUnicode_FromStringAndSize(name.data(), static_cast<Py_ssize_t>(name.size()));
}
PyObject* index_get(PyObject* self, PyObject*) { return index_int(self); }
PyObject* index_set(PyObject* self, PyObject* value) {
  return guarded([&] {
    number_of(self) = read_number(kind_of_type(Py_TYPE(self)), value);
    return Py_NewRef(Py_None);
  });
}
PyObject* index_reduce(PyObject* self, PyObject*) {
  return Py_BuildValue("O(i)", reinterpret_cast<PyObject*>(Py_TYPE(self)), number_of(self));
}
PyObject* index_format(PyObject* self, PyObject* specification) {
  PyObject* number = index_int(self);
  PyObject* text = number == nullptr ? nullptr : PyObject_Format(number, specification);
  Py_XDECREF(number);
  return text;
}

PyMethodDef methods[] = {
    {"GetTypeString", index_type_string, METH_NOARGS, "The name of the index type, e.g. 'NodeIndex'."},
    {"GetIndex", index_get, METH_NOARGS, "The number as an int."},
    {"SetIndex", index_set, METH_O, "Set the number."},
    {"__reduce__", index_reduce, METH_NOARGS, nullptr},
    {"__format__", index_format, METH_O, nullptr},
    {nullptr, nullptr, 0, nullptr},
};

PyTypeObject* make_type(ItemKind kind) {
  static std::array<std::string, item_kinds> names, docs;
  std::string& name = names[static_cast<std::size_t>(kind)];
  std::string& doc = docs[static_cast<std::size_t>(kind)];
  name = "dalembert._core." + std::string(index_name(kind));
  doc = std::string(index_name(kind)) + "(index=-1)\n--\n\nThe number of " + with_article(kind_name(kind)) +
        " in its system; refused where another kind of item is wanted.";
  PyType_Slot slots[] = {
      {Py_tp_new, reinterpret_cast<void*>(index_new)},
      {Py_tp_dealloc, reinterpret_cast<void*>(index_dealloc)},
      {Py_tp_repr, reinterpret_cast<void*>(index_repr)},
      {Py_tp_str, reinterpret_cast<void*>(index_str)},
      {Py_tp_hash, reinterpret_cast<void*>(index_hash)},
      {Py_tp_richcompare, reinterpret_cast<void*>(index_compare)},
      {Py_tp_methods, methods},
      {Py_tp_doc, const_cast<char*>(doc.c_str())},
      {Py_nb_int, reinterpret_cast<void*>(index_int)},
      {Py_nb_index, reinterpret_cast<void*>(index_int)},
      {Py_nb_float, reinterpret_cast<void*>(index_float)},
      {Py_nb_bool, reinterpret_cast<void*>(index_bool)},
      {Py_nb_negative, reinterpret_cast<void*>(index_negative)},
      {Py_nb_add, reinterpret_cast<void*>(index_binary<PyNumber_Add>)},
      {Py_nb_subtract, reinterpret_cast<void*>(index_binary<PyNumber_Subtract>)},
      {Py_nb_multiply, reinterpret_cast<void*>(index_binary<PyNumber_Multiply>)},
      {Py_nb_floor_divide, reinterpret_cast<void*>(index_binary<PyNumber_FloorDivide>)},
      {Py_nb_remainder, reinterpret_cast<void*>(index_binary<PyNumber_Remainder>)},
      {0, nullptr},
  };
  PyType_Spec spec{name.c_str(), sizeof(IndexObject), 0, Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE, slots};
  auto* type = reinterpret_cast<PyTypeObject*>(PyType_FromSpec(&spec));
  if (type == nullptr) throw py::error_already_set();
  return type;
}

// _created(cls, mbs, index): the return value of Create functions, which for an ObjectIndex also stores the system.
PyObject* created(PyObject*, PyObject* const* arguments, Py_ssize_t count) {
  static PyObject* owner = PyUnicode_InternFromString("_mbs");
  PyTypeObject* object_index = types[static_cast<std::size_t>(ItemKind::object)];
  if (count != 3 || !PyType_Check(arguments[0]) ||
      !PyType_IsSubtype(reinterpret_cast<PyTypeObject*>(arguments[0]), object_index))
    return PyErr_Format(PyExc_TypeError, "_created(cls, mbs, index) takes a class of ObjectIndex");
  if (Py_TYPE(arguments[2]) != object_index) return Py_NewRef(arguments[2]);
  auto* type = reinterpret_cast<PyTypeObject*>(arguments[0]);
  PyObject* made = type->tp_alloc(type, 0);
  if (made == nullptr) return nullptr;
  number_of(made) = number_of(arguments[2]);
  if (PyObject_SetAttr(made, owner, arguments[1]) == 0) return made;
  Py_DECREF(made);
  return nullptr;
}

}  // namespace

PyObject* make_index(ItemKind kind, int number) {
  auto* self = PyObject_New(IndexObject, types[static_cast<std::size_t>(kind)]);
  if (self == nullptr) throw py::error_already_set();
  self->number = number;
  return reinterpret_cast<PyObject*>(self);
}

bool read_index(PyObject* value, ItemKind& kind, int& number) {
  const int found = kind_of_object(value);
  if (found < 0) return false;
  kind = static_cast<ItemKind>(found);
  number = number_of(value);
  return true;
}

void register_index_types(py::module_& module) {
  for (int k = 0; k < item_kinds; ++k) {
    const ItemKind kind = static_cast<ItemKind>(k);
    types[static_cast<std::size_t>(k)] = make_type(kind);
    module.add_object(
        std::string(index_name(kind)).c_str(),
        py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(types[static_cast<std::size_t>(k)])));
  }
  static PyMethodDef definition{
      "_created", reinterpret_cast<PyCFunction>(reinterpret_cast<void*>(created)), METH_FASTCALL,
      "_created(cls, mbs, index, /)\n--\n\nThe index as one of the class, with the attribute _mbs; what is no "
      "ObjectIndex, as it is."};
  module.add_object("_created", py::reinterpret_steal<py::object>(PyCFunction_New(&definition, nullptr)));
}

}  // namespace dalembert
