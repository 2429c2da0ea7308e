#include "index_lists.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace py = pybind11;

namespace dalembert {
namespace {

struct IndexList {
  PyListObject list;
  PyObject* owner;
  PyObject* name;
};

// Undoes the change if the item rejects it.
template <class Act>
bool change(PyObject* self, Act&& act) {
  const auto before = py::reinterpret_steal<py::object>(PyList_GetSlice(self, 0, PY_SSIZE_T_MAX));
  if (!before || !act()) return false;
  const auto* list = reinterpret_cast<IndexList*>(self);
  if (PyObject_SetAttr(list->owner, list->name, self) == 0) return true;
  const py::error_scope refusal;
  PyList_SetSlice(self, 0, PY_SSIZE_T_MAX, before.ptr());
  return false;
}

int assign_subscript(PyObject* self, PyObject* key, PyObject* value) {
  return change(self, [&] { return PyList_Type.tp_as_mapping->mp_ass_subscript(self, key, value) == 0; }) ? 0 : -1;
}
int assign_item(PyObject* self, Py_ssize_t i, PyObject* value) {
  return change(self, [&] { return PyList_Type.tp_as_sequence->sq_ass_item(self, i, value) == 0; }) ? 0 : -1;
}
PyObject* add_in_place(PyObject* self, PyObject* more) {
  const auto add = [&] {
    return py::reinterpret_steal<py::object>(PyList_Type.tp_as_sequence->sq_inplace_concat(self, more)).ptr() !=
           nullptr;
  };
  return change(self, add) ? Py_NewRef(self) : nullptr;
}

// The names of those methods of a list that change it.
constexpr std::array names{"append", "extend", "insert", "pop", "remove", "clear", "reverse", "sort"};

template <std::size_t method>
PyObject* changing_method(PyObject* self, PyObject* arguments, PyObject* keywords) {
  const auto of_list = py::reinterpret_steal<py::object>(
      PyObject_GetAttrString(reinterpret_cast<PyObject*>(&PyList_Type), names[method]));
  const auto first = py::reinterpret_steal<py::object>(PyTuple_Pack(1, self));
  if (!of_list || !first) return nullptr;
  const auto all = py::reinterpret_steal<py::object>(PySequence_Concat(first.ptr(), arguments));
  PyObject* result = nullptr;
  const bool done =
      all && change(self, [&] { return (result = PyObject_Call(of_list.ptr(), all.ptr(), keywords)) != nullptr; });
  if (done) return result;
  Py_XDECREF(result);
  return nullptr;
}

// Copies are lists of their own.
PyObject* reduce(PyObject* self, PyObject*) {
  PyObject* entries = PyList_GetSlice(self, 0, PY_SSIZE_T_MAX);
  return entries == nullptr ? nullptr : Py_BuildValue("O(N)", &PyList_Type, entries);
}

void deallocate(PyObject* self) {
  PyObject_GC_UnTrack(self);
  auto* list = reinterpret_cast<IndexList*>(self);
  Py_CLEAR(list->owner);
  Py_CLEAR(list->name);
  PyTypeObject* type = Py_TYPE(self);
  PyList_Type.tp_dealloc(self);
  Py_DECREF(type);
}

PyTypeObject* make_list_type() {
  static std::array<PyMethodDef, names.size() + 2> methods{};
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((methods[i] = {names[i], reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(changing_method<i>)),
                    METH_VARARGS | METH_KEYWORDS, "As that of list."}),
     ...);
  }(std::make_index_sequence<names.size()>{});
  methods[names.size()] = {"__reduce__", reduce, METH_NOARGS, "A list."};
  PyType_Slot slots[] = {
      {Py_tp_doc, const_cast<char*>("Numbers of items that an item refers to.")},
      {Py_tp_dealloc, reinterpret_cast<void*>(deallocate)},
      {Py_mp_ass_subscript, reinterpret_cast<void*>(assign_subscript)},
      {Py_sq_ass_item, reinterpret_cast<void*>(assign_item)},
      {Py_sq_inplace_concat, reinterpret_cast<void*>(add_in_place)},
      {Py_tp_methods, methods.data()},
      {0, nullptr},
  };
  PyType_Spec spec{"dalembert._core.IndexList", sizeof(IndexList), 0, Py_TPFLAGS_DEFAULT, slots};
  PyObject* type = PyType_FromSpecWithBases(&spec, reinterpret_cast<PyObject*>(&PyList_Type));
  if (type == nullptr) throw py::error_already_set();
  return reinterpret_cast<PyTypeObject*>(type);
}

}  // namespace

PyObject* make_index_list(PyObject* entries, PyObject* owner, PyObject* name) {
  static PyTypeObject* type = make_list_type();
  PyObject* list = type->tp_alloc(type, 0);
  if (list == nullptr) return nullptr;
  reinterpret_cast<IndexList*>(list)->owner = Py_NewRef(owner);
  reinterpret_cast<IndexList*>(list)->name = Py_NewRef(name);
  if (PyList_SetSlice(list, 0, 0, entries) == 0) return list;
  Py_DECREF(list);
  return nullptr;
}

}  // namespace dalembert
