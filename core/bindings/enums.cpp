// Enumerations: Python's IntEnum, or IntFlag where values are bits, made from the generated tables.
#include <pybind11/pybind11.h>

#include <algorithm>
#include <bit>

#include "dalembert/enums.hpp"
#include "dalembert/reflection/settings_texts.hpp"
#include "module.hpp"

namespace dalembert {

namespace py = pybind11;

namespace {

// Values that may be joined with `|`: more than two single bits and nothing else, except for zero.
bool is_flag(const EnumTable& table) {
  const auto bits =
      std::ranges::count_if(table.entries, [](const EnumEntry& e) { return std::has_single_bit(e.value); });
  const auto zeros = std::ranges::count_if(table.entries, [](const EnumEntry& e) { return e.value == 0; });
  return bits > 2 && bits + zeros == static_cast<std::ptrdiff_t>(table.entries.size());
}

// IntEnum or IntFlag whose str() is 'NodeType.Position' instead of a number.
py::object named_base(const py::module_& enum_module, const char* base) {
  const py::object plain = enum_module.attr("Enum");
  py::dict members;
  members["__str__"] = plain.attr("__str__");
  members["__format__"] = plain.attr("__format__");
  const auto body = py::cpp_function([members](const py::object& names) { names.attr("update")(members); });
  return py::module_::import("types").attr("new_class")(base, py::make_tuple(enum_module.attr(base)), py::dict(), body);
}

// Adds docstrings to the class and to each value.
void document(const py::object& made, const EnumTable& table, const EnumText& text) {
  std::string doc = std::string(text.summary) + "\n\nValues:\n";
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    const std::string name(table.entries[i].name), value(text.values[i]);
    made.attr("__getitem__")(name).attr("__doc__") = value;
    doc += "    " + name + " = " + std::to_string(table.entries[i].value) + "\n        " + value + "\n";
  }
  made.attr("__doc__") = doc;
}

// Attributes of enumerations are those of any class; others are left to __getattr__ of the metaclass. Python itself calls a
// metaclass with a __getattr__ through a bound method, which takes several times as long as the lookup.
PyObject* enum_attribute(PyObject* made, PyObject* name) {
  PyObject* const found = PyType_Type.tp_getattro(made, name);
  if (found != nullptr || PyErr_ExceptionMatches(PyExc_AttributeError) == 0) return found;
  PyErr_Clear();
  const auto explain = py::reinterpret_steal<py::object>(
      PyObject_GetAttrString(reinterpret_cast<PyObject*>(Py_TYPE(made)), "__getattr__"));
  return explain ? PyObject_CallFunctionObjArgs(explain.ptr(), made, name, nullptr) : nullptr;
}

}  // namespace

void register_enums(py::module_& module) {
  const py::module_ enum_module = py::module_::import("enum");
  const py::object numbers = named_base(enum_module, "IntEnum"), flags = named_base(enum_module, "IntFlag");
  auto text = enum_texts().begin();
  for (const EnumTable& table : enum_tables()) {
    py::list members;
    for (const EnumEntry& entry : table.entries) members.append(py::make_tuple(py::str(entry.name), entry.value));
    const py::str name{std::string(table.name)};
    const py::object& base = is_flag(table) ? flags : numbers;
    module.attr(name) = base(name, members, py::arg("module") = module.attr("__name__"));
    document(module.attr(name), table, *text++);
  }
  module.def(
      "_look_up_directly",
      [](const py::type& metaclass) { reinterpret_cast<PyTypeObject*>(metaclass.ptr())->tp_getattro = enum_attribute; },
      py::arg("metaclass"), py::pos_only(),
      "Make attribute lookup of enumerations fast, whose metaclass has a __getattr__.");
}

}  // namespace dalembert
