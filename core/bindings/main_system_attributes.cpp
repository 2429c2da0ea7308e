// Attribute lookup of MainSystem: it explains missing names, and finds mbs.AddNode and similar methods fast. Up to
// Python 3.11, classes that explain attributes get no method caches, and each lookup makes a new bound method; models
// add very many items. From Python 3.12 on, classes with a __getattr__ have caches, and this file does nothing.
#include "main_system_attributes.hpp"

#include <structmember.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include "index_types.hpp"

namespace dalembert {

namespace {
constexpr const char* explaining =
    "Let a function of a MainSystem and a name raise the error for an attribute that the system has not.";
}

#if PY_VERSION_HEX >= 0x030c0000

void explain_attributes_of(PyHeapTypeObject*) {}

py::object class_of_main_system() {
  return py::reinterpret_borrow<py::object>(reinterpret_cast<PyObject*>(py::detail::get_internals().default_metaclass));
}

void register_main_system_attributes(py::module_& module, const py::object& main_system,
                                     const std::array<AddItem, item_kinds>&) {
  module.def(
      "_explain_missing_attributes",
      [main_system](const py::function& function) { main_system.attr("__getattr__") = function; }, py::arg("function"),
      py::pos_only(), explaining);
}

#else

namespace {

// Replaces the bound method, to which it delegates everything but the call.
struct Adder {
  PyObject_HEAD vectorcallfunc call;
  PyObject* main;
  AddItem add;
  std::size_t kind;
};

struct Method {
  PyObject* name;
  PyObject* descriptor;  // descriptor of the class
  AddItem add;
};

std::array<Method, item_kinds> adders{};
PyTypeObject* adder_type = nullptr;
PyTypeObject* system_type = nullptr;
bool has_adders = false;  // the methods of the class have not been replaced
PyObject* explainer = nullptr;  // function(object, name), which raises
Adder* spare = nullptr;  // one unused object without a system

Adder* as_adder(PyObject* object) { return reinterpret_cast<Adder*>(object); }

PyObject* bound_method(PyObject* self) {
  return PyObject_GenericGetAttr(as_adder(self)->main, adders[as_adder(self)->kind].name);
}

PyObject* call_adder(PyObject* self, PyObject* const* arguments, std::size_t flags, PyObject* names) {
  const Adder* adder = as_adder(self);
  if (PyVectorcall_NARGS(flags) == 1 && names == nullptr) [[likely]]
    return adder->add(adder->main, arguments[0]);
  const auto method = py::reinterpret_steal<py::object>(bound_method(self));
  return method ? PyObject_Vectorcall(method.ptr(), arguments, flags & ~PY_VECTORCALL_ARGUMENTS_OFFSET, names)
                : nullptr;
}

PyObject* make_adder(PyObject* main, std::size_t kind) {
  Adder* adder = std::exchange(spare, nullptr);
  if (adder == nullptr) [[unlikely]] {
    adder = PyObject_GC_New(Adder, adder_type);
    if (adder == nullptr) return nullptr;
    adder->call = call_adder;
    adder->main = nullptr;
    PyObject_GC_Track(reinterpret_cast<PyObject*>(adder));
  }
  adder->main = Py_NewRef(main);
  adder->add = adders[kind].add;
  adder->kind = kind;
  return reinterpret_cast<PyObject*>(adder);
}

// An unused object is kept alive for the next lookup.
void adder_dealloc(PyObject* self) {
  PyObject* main = std::exchange(as_adder(self)->main, nullptr);
  if (spare == nullptr) [[likely]] {
    Py_SET_REFCNT(self, 1);
    spare = as_adder(self);
  } else {
    PyObject_GC_UnTrack(self);
    PyTypeObject* type = Py_TYPE(self);
    PyObject_GC_Del(self);
    Py_DECREF(type);
  }
  Py_XDECREF(main);
}

int adder_traverse(PyObject* self, visitproc visit, void* arg) {
  Py_VISIT(Py_TYPE(self));
  Py_VISIT(as_adder(self)->main);
  return 0;
}

template <class Ask>
PyObject* ask_method(PyObject* self, Ask&& ask) {
  const auto method = py::reinterpret_steal<py::object>(bound_method(self));
  return method ? ask(method.ptr()) : nullptr;
}

PyObject* adder_attribute(PyObject* self, PyObject* name) {
  return ask_method(self, [&](PyObject* method) { return PyObject_GetAttr(method, name); });
}
PyObject* adder_repr(PyObject* self) { return ask_method(self, PyObject_Repr); }
Py_hash_t adder_hash(PyObject* self) {
  const auto method = py::reinterpret_steal<py::object>(bound_method(self));
  return method ? PyObject_Hash(method.ptr()) : -1;
}
PyObject* adder_compare(PyObject* self, PyObject* other, int operation) {
  if (Py_TYPE(other) != adder_type) Py_RETURN_NOTIMPLEMENTED;
  return ask_method(self, [&](PyObject* method) {
    return ask_method(other, [&](PyObject* with) { return PyObject_RichCompare(method, with, operation); });
  });
}

PyTypeObject* make_adder_type() {
  static PyMemberDef members[] = {{"__vectorcalloffset__", T_PYSSIZET, offsetof(Adder, call), READONLY, nullptr},
                                  {nullptr, 0, 0, 0, nullptr}};
  PyType_Slot slots[] = {
      {Py_tp_doc, const_cast<char*>("A method of a system that adds items.")},
      {Py_tp_dealloc, reinterpret_cast<void*>(adder_dealloc)},
      {Py_tp_traverse, reinterpret_cast<void*>(adder_traverse)},
      {Py_tp_call, reinterpret_cast<void*>(PyVectorcall_Call)},
      {Py_tp_getattro, reinterpret_cast<void*>(adder_attribute)},
      {Py_tp_repr, reinterpret_cast<void*>(adder_repr)},
      {Py_tp_hash, reinterpret_cast<void*>(adder_hash)},
      {Py_tp_richcompare, reinterpret_cast<void*>(adder_compare)},
      {Py_tp_members, members},
      {0, nullptr},
  };
  PyType_Spec spec{
      "dalembert._core._Adder", sizeof(Adder), 0,
      Py_TPFLAGS_DEFAULT | Py_TPFLAGS_HAVE_GC | Py_TPFLAGS_HAVE_VECTORCALL | Py_TPFLAGS_DISALLOW_INSTANTIATION, slots};
  PyObject* type = PyType_FromSpec(&spec);
  if (type == nullptr) throw py::error_already_set();
  return reinterpret_cast<PyTypeObject*>(type);
}

void look_for_adders() {
  has_adders = std::ranges::all_of(adders, [](const Method& each) {
    const auto found =
        py::reinterpret_steal<py::object>(PyObject_GetAttr(reinterpret_cast<PyObject*>(system_type), each.name));
    return found.ptr() == each.descriptor;
  });
  PyErr_Clear();
}

// Methods are replaced through the metaclass.
int set_class_attribute(PyObject* type, PyObject* name, PyObject* value) {
  const int result = py::detail::get_internals().default_metaclass->tp_setattro(type, name, value);
  if (result == 0 && type == reinterpret_cast<PyObject*>(system_type)) look_for_adders();
  return result;
}

PyObject* system_attribute(PyObject* self, PyObject* name) {
  if (Py_TYPE(self) == system_type && has_adders) [[likely]] {
    for (std::size_t k = 0; k < adders.size(); ++k)
      if (name == adders[k].name) return make_adder(self, k);
  }
  PyObject* value = PyObject_GenericGetAttr(self, name);
  if (value != nullptr || explainer == nullptr || PyErr_ExceptionMatches(PyExc_AttributeError) == 0) return value;
  PyErr_Clear();
  return PyObject_CallFunctionObjArgs(explainer, self, name, nullptr);
}

}  // namespace

void explain_attributes_of(PyHeapTypeObject* type) { type->ht_type.tp_getattro = system_attribute; }

py::object class_of_main_system() {
  PyType_Slot slots[] = {{Py_tp_setattro, reinterpret_cast<void*>(set_class_attribute)}, {0, nullptr}};
  PyType_Spec spec{"dalembert._core._SystemType", 0, 0, Py_TPFLAGS_DEFAULT, slots};
  const py::tuple bases =
      py::make_tuple(py::handle(reinterpret_cast<PyObject*>(py::detail::get_internals().default_metaclass)));
  auto made = py::reinterpret_steal<py::object>(PyType_FromSpecWithBases(&spec, bases.ptr()));
  if (!made) throw py::error_already_set();
  return made;
}

void register_main_system_attributes(py::module_& module, const py::object& main_system,
                                     const std::array<AddItem, item_kinds>& add) {
  adder_type = make_adder_type();
  system_type = reinterpret_cast<PyTypeObject*>(main_system.ptr());
  for (std::size_t k = 0; k < adders.size(); ++k) {
    const std::string name = "Add" + std::string(kind_title(static_cast<ItemKind>(k)));
    adders[k] = {PyUnicode_InternFromString(name.c_str()), py::object(main_system.attr(name.c_str())).release().ptr(),
                 add[k]};
  }
  look_for_adders();
  module.def(
      "_explain_missing_attributes",
      [](const py::function& function) {
        Py_XDECREF(explainer);
        explainer = Py_NewRef(function.ptr());
      },
      py::arg("function"), py::pos_only(), explaining);
}

#endif

}  // namespace dalembert
