// Calls with wrong arguments: pybind11 would list signatures in its own words. All functions are wrapped, so that
// dalembert/_tools/wrong_calls.py words the error.
#include <string>
#include <string_view>
#include <type_traits>

#include "module.hpp"

namespace dalembert {
namespace {

// A pybind11 function as Python calls it.
using Call = PyObject* (*)(PyObject* record, PyObject* const* arguments, Py_ssize_t count, PyObject* names);

Call call = nullptr;  // the same for all functions

void explain(PyObject* record, PyObject* const* arguments, Py_ssize_t positional, PyObject* names) {
  py::error_already_set error;  // moves the error
  const py::str text(error.value());
  constexpr const char* mark = "(): incompatible ";
  if (!error.matches(PyExc_TypeError) || !text.contains(py::str(mark))) return error.restore();
  try {
    const auto named = names == nullptr ? py::tuple() : py::reinterpret_borrow<py::tuple>(names);
    py::list given;
    for (Py_ssize_t i = 0; i < positional + static_cast<Py_ssize_t>(named.size()); ++i)
      given.append(py::handle(arguments[i]));
    const py::object words =
        py::module_::import("dalembert._tools.wrong_calls").attr("in_words")(text, given, named, py::handle(record));
    PyErr_SetObject(PyExc_TypeError, words.ptr());
  } catch (py::error_already_set&) {
    error.restore();
  }
}

PyObject* explaining_call(PyObject* record, PyObject* const* arguments, Py_ssize_t count, PyObject* names) {
  PyObject* const result = call(record, arguments, count, names);
  if (result == nullptr) [[unlikely]]
    explain(record, arguments, PyVectorcall_NARGS(static_cast<std::size_t>(count)), names);
  return result;
}

template <class Function>
PyCFunction plain(Function function) {
  return reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(function));
}

void explain_function(PyObject* function) {
  if (PyInstanceMethod_Check(function)) function = PyInstanceMethod_GET_FUNCTION(function);
  if (!PyCFunction_Check(function)) return;
  PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(function)->m_ml;
  if (definition->ml_meth == plain(call)) definition->ml_meth = plain(explaining_call);
}

void explain_functions_of(const py::dict& names) {
  for (const auto& [name, value] : names) {
    if (PyObject_TypeCheck(value.ptr(), &PyProperty_Type))
      explain_function(py::object(value.attr("fset")).ptr());
    else
      explain_function(value.ptr());
  }
}

}  // namespace

void explain_wrong_calls(py::module_& module) {
  const py::object known = module.attr("InvalidIndex");
  const PyMethodDef* definition = reinterpret_cast<PyCFunctionObject*>(known.ptr())->m_ml;
  if (definition->ml_flags != (METH_FASTCALL | METH_KEYWORDS))
    return;  // functions of an earlier pybind11 are called in another way
  call = reinterpret_cast<Call>(reinterpret_cast<void (*)()>(definition->ml_meth));
  explain_functions_of(module.attr("__dict__"));
  const std::string prefix = std::string(py::str(module.attr("__name__"))) + ".";
  py::list classes;
  py::detail::with_internals([&](py::detail::internals& internals) {
    for (const auto& entry : internals.registered_types_py)
      if (std::string_view(entry.first->tp_name).starts_with(prefix))
        classes.append(py::handle(reinterpret_cast<PyObject*>(entry.first)));
  });
  for (const py::handle& type : classes) explain_functions_of(py::dict(type.attr("__dict__")));
}

}  // namespace dalembert
