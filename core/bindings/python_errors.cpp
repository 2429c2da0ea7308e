#include "python_errors.hpp"

#include <pybind11/numpy.h>

#include <initializer_list>

#include "dalembert/output/file_error.hpp"
#include "index_types.hpp"

namespace dalembert {
namespace {

constexpr std::size_t longest_shown = 200;

// Exceptions of the module, each also a built-in one; they live as long as the process.
struct ErrorClasses {
  PyObject *model = PyExc_ValueError, *type = PyExc_TypeError, *index = PyExc_IndexError, *name = PyExc_AttributeError,
           *state = PyExc_RuntimeError, *planned = PyExc_NotImplementedError;
} error_classes;

PyObject* exception_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::value: return error_classes.model;
    case ErrorKind::type: return error_classes.type;
    case ErrorKind::index: return error_classes.index;
    case ErrorKind::name: return error_classes.name;
    case ErrorKind::state: return error_classes.state;
    case ErrorKind::planned: return error_classes.planned;
  }
  return PyExc_RuntimeError;
}

PyObject* make_exception(py::module_& module, const char* name, const char* doc,
                         std::initializer_list<PyObject*> bases) {
  py::tuple all(bases.size());
  std::size_t i = 0;
  for (PyObject* base : bases) all[i++] = py::reinterpret_borrow<py::object>(base);
  PyObject* made = PyErr_NewExceptionWithDoc((std::string("dalembert.") + name).c_str(), doc, all.ptr(), nullptr);
  if (made == nullptr) throw py::error_already_set();
  module.add_object(name, py::handle(made));
  return made;
}

void make_exceptions(py::module_& module) {
  PyObject* const base =
      make_exception(module, "ExudynError", "Base of all errors of models, settings and solvers.", {PyExc_Exception});
  PyObject* const value =
      make_exception(module, "ExudynValueError", "A value that is not allowed.", {base, PyExc_ValueError});
  error_classes.model =
      make_exception(module, "ModelError",
                     "An invalid value in a model or in settings; its text has the item and the parameter.", {value});
  error_classes.type = make_exception(module, "ExudynTypeError", "A value of the wrong type, or an unknown argument.",
                                      {base, PyExc_TypeError});
  error_classes.index = make_exception(module, "ExudynIndexError", "The number of an item that does not exist.",
                                       {base, PyExc_IndexError});
  error_classes.name = make_exception(module, "ExudynAttributeError", "An unknown parameter of an item or setting.",
                                      {base, PyExc_AttributeError});
  error_classes.state =
      make_exception(module, "StateError", "A call that is not possible in this state, for instance before Assemble.",
                     {base, PyExc_RuntimeError});
  error_classes.planned = make_exception(module, "NotImplementedFeatureError", "A feature that is planned.",
                                         {base, PyExc_NotImplementedError});
  make_exception(module, "InternalError", "Not raised; for models that catch it.", {base, PyExc_RuntimeError});
  make_exception(module, "ExudynArithmeticError", "Not raised; for models that catch it.",
                 {base, PyExc_ArithmeticError});
}

// An OSError with errno and filename: FileNotFoundError and the like, as Python chooses them.
void set_os_error(const FileError& error) noexcept {
  PyObject* file = PyUnicode_DecodeFSDefault(error.file().c_str());
  PyObject* instance = file == nullptr
                           ? nullptr
                           : PyObject_CallFunction(PyExc_OSError, "isN", error.code(), error.reason().c_str(), file);
  if (instance == nullptr) return;
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(instance)), instance);
  Py_DECREF(instance);
}

void set_memory_error() noexcept {
  PyErr_SetString(PyExc_MemoryError, "there is not enough memory for this call: use smaller sizes, or sparse matrices");
}

}  // namespace

void set_python_error() noexcept {
  try {
    throw;
  } catch (py::error_already_set& error) {
    error.restore();
  } catch (const ModelError& error) {
    PyErr_SetString(exception_of(error.kind()), error.what());
  } catch (const FileError& error) {
    set_os_error(error);
  } catch (const py::builtin_exception& error) {
    error.set_error();
  } catch (const std::bad_alloc&) {
    set_memory_error();
  } catch (const std::length_error&) {
    set_memory_error();
  } catch (const std::invalid_argument& error) {
    PyErr_SetString(PyExc_ValueError, error.what());
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  } catch (...) {
    PyErr_SetString(PyExc_RuntimeError, "unknown error in the compiled core");
  }
}

std::string to_string(PyObject* text) {
  Py_ssize_t size = 0;
  const char* data = PyUnicode_AsUTF8AndSize(text, &size);
  if (data == nullptr) throw py::error_already_set();
  return {data, static_cast<std::size_t>(size)};
}

std::string show(PyObject* value) {
  std::string text;
  ItemKind kind{};
  int number = 0;
  const bool index = read_index(value, kind, number);  // their type follows behind the number
  if (PyObject* shown = index ? PyObject_Str(value) : PyObject_Repr(value); shown != nullptr) {
    const char* data = PyUnicode_AsUTF8(shown);
    text = data != nullptr ? data : "?";
    Py_DECREF(shown);
  }
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    text = "?";
  }
  if (text.size() > longest_shown) {
    std::size_t cut = longest_shown;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;  // not inside a character
    text = text.substr(0, cut) + "...";
  }
  if (value == Py_None) return text;
  std::string_view type = index ? index_name(kind) : std::string_view(Py_TYPE(value)->tp_name);
  constexpr std::string_view own = "dalembert._core.";
  if (type.starts_with(own)) type.remove_prefix(own.size());
  text += " (" + std::string(type);
  if (py::isinstance<py::array>(value)) {
    const auto array = py::reinterpret_borrow<py::array>(value);
    text += " of shape (";
    for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(array.shape(i));
    text += array.ndim() == 1 ? ",)" : ")";
  } else if (PyList_Check(value) || PyTuple_Check(value)) {
    text += " of length " + std::to_string(PySequence_Size(value));
  }
  return text + ")";
}

void register_errors(py::module_& module) {
  make_exceptions(module);
  py::register_local_exception_translator([](std::exception_ptr pointer) {
    try {
      std::rethrow_exception(pointer);
    } catch (const ModelError& error) {
      PyErr_SetString(exception_of(error.kind()), error.what());
    } catch (const FileError& error) {
      set_os_error(error);
    } catch (const std::bad_alloc&) {
      set_memory_error();
    } catch (const std::length_error&) {
      set_memory_error();
    }
  });
}

}  // namespace dalembert
