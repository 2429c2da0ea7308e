// Guards against two gaps of pybind11 classes by which Python code could crash the process: objects created by
// __new__ only, and copying by early pickle protocols.
#include <string>
#include <string_view>

#include "dalembert/model/errors.hpp"
#include "module.hpp"

namespace dalembert {
namespace {

// pybind11 asks for memory when a method finds no C++ object behind self; it would stay without a value.
void* refuse_unmade(std::size_t) {
  refuse(ErrorKind::state, {.item = "a method of an object",
                            .problem = "the object is empty, because its __init__ was not called",
                            .advice = "Make objects by calling their class, not its __new__."});
}

// Uses protocol 2. The method of `object` would call the common base class, which has no C++ objects and throws
// through C code.
py::tuple reduced(const py::object& self) {
  const py::object type = py::type::of(self);
  if (!py::hasattr(type, "__setstate__"))
    throw py::type_error("cannot pickle '" + std::string(py::str(type.attr("__name__"))) + "' object");
  return py::make_tuple(py::module_::import("copyreg").attr("__newobj__"), py::make_tuple(type),
                        self.attr("__getstate__")());
}

}  // namespace

void guard_objects(py::module_& module) {
  const std::string prefix = std::string(py::str(module.attr("__name__"))) + ".";
  py::list classes;
  py::detail::with_internals([&](py::detail::internals& internals) {
    for (const auto& [type, bases] : internals.registered_types_py) {
      if (!std::string_view(type->tp_name).starts_with(prefix)) continue;
      for (py::detail::type_info* base : bases) base->operator_new = &refuse_unmade;
      classes.append(py::handle(reinterpret_cast<PyObject*>(type)));
    }
  });
  for (const py::handle& known : classes) {
    const auto type = py::reinterpret_borrow<py::object>(known);
    if (!type.attr("__dict__").contains("__reduce__"))
      type.attr("__reduce__") = py::cpp_function(&reduced, py::is_method(type), py::name("__reduce__"));
  }
}

}  // namespace dalembert
