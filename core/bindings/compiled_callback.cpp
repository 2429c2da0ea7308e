#include "compiled_callback.hpp"

#include <algorithm>
#include <cmath>

#include "conversion.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/reflection/item_type.hpp"
#include "item_callback.hpp"

namespace dalembert {
namespace {

using Kind = Signature::Kind;

void add_type(std::string& list, const char* type) { list += (list.empty() ? "" : ", ") + std::string(type); }

void add_types(std::string& list, Kind kind) {
  switch (kind) {
    case Kind::scalar: add_type(list, "double"); break;
    case Kind::vector:
    case Kind::matrix: add_type(list, "double*"); break;
    case Kind::open_vector:
    case Kind::open_matrix: add_type(list, "double*"); [[fallthrough]];
    default: add_type(list, "int64");
  }
}

// "double(double, int64, double*)", as dalembert.compiled writes signatures; empty if no C function is possible.
std::string c_signature(const Signature& signature) {
  if (signature.compiled == nullptr) return "";
  std::string parameters;
  if (signature.takes_time) add_type(parameters, "double");
  if (signature.takes_item) add_type(parameters, "int64");
  for (const Kind kind : signature.arguments) add_types(parameters, kind);
  if (signature.result == Kind::scalar) return "double(" + parameters + ")";
  add_types(parameters, signature.result);
  return "void(" + parameters + ")";
}

class CompiledCallback final : public ItemCallback {
 public:
  CompiledCallback(py::object function, const Row& row, const void* address)
      : ItemCallback(std::move(function), row), address_(address) {}

  void call(double time, int item, std::span<const Argument> arguments, std::span<double> results) const override {
    signature().compiled(address_, time, item, arguments, results);
    const auto wrong = std::ranges::find_if_not(results, [](double x) { return std::isfinite(x); });
    if (wrong != results.end()) refuse_result(item, *wrong);
  }
  std::vector<double> call_any(double, int item, std::span<const Argument>) const override {
    refuse(ErrorKind::type, {.item = describe(item), .problem = "cannot be a C function"});
  }

 private:
  std::shared_ptr<ItemCallback> copy() const override {
    return std::make_shared<CompiledCallback>(function(), row(), address_);
  }
  [[noreturn]] void refuse_result(int item, double value) const {
    refuse(ErrorKind::value, {describe(item), "", "", std::to_string(value) + " as result", "finite numbers",
                              "Check the calculation that the value comes from."});
  }

  const void* address_;
};

// Python functions and methods, and "no function", are the usual case and are excluded first.
bool may_be_compiled(PyObject* value) {
  return value != Py_None && !PyFunction_Check(value) && !PyMethod_Check(value) && !PyLong_Check(value) &&
         !PyFloat_Check(value) && !PyUnicode_Check(value);
}

// The address of a C function with this signature; nullptr if `value` is no C function. Throws Refusal.
const void* compiled_function(PyObject* value, const std::string& expected) {
  if (!may_be_compiled(value)) return nullptr;
  const py::object found = py::module_::import("dalembert.compiled").attr("_recognized")(py::handle(value));
  if (found.is_none()) return nullptr;
  const auto [address, signature] = found.cast<std::pair<std::uintptr_t, std::string>>();
  if (expected.empty())
    throw Refusal{ErrorKind::type, "a Python function, or 0 for none", "This user function cannot be a C function."};
  if (signature != expected)
    throw Refusal{ErrorKind::type, "a C function with the signature " + expected,
                  (signature.empty() ? "That of this one is not known, set its argtypes and restype"
                                     : "That of this one is " + signature) +
                      "; dalembert.compiled gives the right one to numba and ctypes."};
  return reinterpret_cast<const void*>(address);
}

// Signatures of those functions of the main system that may be C functions.
std::string system_signature(const std::string& name) {
  if (name == "PreStep" || name == "PostStep") return "int64(double)";
  if (name == "PostNewton") return "void(double, double*)";
  return "";
}

py::object signature_of(const std::string& type_name, const std::string& function_name) {
  constexpr std::string_view ending = "UserFunction";
  if (type_name == "MainSystem" && function_name.ends_with(ending))
    return py::str(system_signature(function_name.substr(0, function_name.size() - ending.size())));
  if (type_name == "Controller" && function_name == "desired")
    return py::str("void(double, int64, double*, double*, double*)");
  for (const ItemType* type : item_types()) {
    if (type->name != type_name) continue;
    for (const Row& row : type->rows)
      if (row.name == function_name && row.signature != nullptr) return py::str(c_signature(*row.signature));
  }
  return py::none();
}

}  // namespace

std::shared_ptr<const Callback> compiled_callback(PyObject* value, const Row& row) {
  const void* address = compiled_function(value, row.signature == nullptr ? "" : c_signature(*row.signature));
  if (address == nullptr) return nullptr;
  return std::make_shared<CompiledCallback>(py::reinterpret_borrow<py::object>(value), row, address);
}

const void* compiled_system_function(PyObject* value, const std::string& name) {
  return compiled_function(value, system_signature(name));
}

void register_compiled_functions(py::module_& module) {
  module.def("_compiled_signature", &signature_of, py::arg("itemTypeName"), py::arg("userFunctionName"));
}

}  // namespace dalembert
