#include "python_arguments.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>
#include <vector>

#include "conversion.hpp"

namespace dalembert {
namespace {

// Whether an array is unchanged since it was made for such an argument, and only referenced by its slot (and
// `array`).
bool can_be_filled(const py::array& array, const Argument& argument) {
  static const PyObject* const real = py::dtype::of<double>().release().ptr();
  constexpr int own = py::detail::npy_api::NPY_ARRAY_C_CONTIGUOUS_ | py::detail::npy_api::NPY_ARRAY_OWNDATA_ |
                      py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  if (array.ref_count() != 2 || (array.flags() & own) != own || array.dtype().ptr() != real) return false;
  const bool matrix = argument.columns != 0;
  return array.ndim() == (matrix ? 2 : 1) && array.shape(0) == argument.rows &&
         (!matrix || array.shape(1) == argument.columns);
}

py::list integer_list(const Argument& argument) {
  py::list list;
  for (int i = 0; i < argument.rows; ++i) list.append(static_cast<long>(argument.data[i]));
  return list;
}

}  // namespace

void PythonArguments::clear() {
  for (std::size_t i = first; i < objects_.size(); ++i) Py_CLEAR(objects_[i]);
}

void PythonArguments::fill(const Signature& signature, double time, int item, std::span<const Argument> arguments) {
  if (arguments.size() + 2 > most) throw std::length_error("a user function has too many arguments");
  end_ = first;
  changed_ = false;
  if (signature.takes_time) add(time);
  if (signature.takes_item) add(static_cast<long>(item));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto kind = i < signature.arguments.size() ? signature.arguments[i] : Signature::Kind::scalar;
    kind == Signature::Kind::scalar ? add(*arguments[i].data) : add(kind, arguments[i]);
  }
}

// Whether the next object is there and shows the same number; the number is noted.
bool PythonArguments::repeated(std::uint64_t bits) {
  return std::exchange(bits_[end_], bits) == bits && objects_[end_] != nullptr;
}

void PythonArguments::replace(PyObject* object) {
  if (object == nullptr) throw py::error_already_set();
  changed_ = true;
  PyObject* before = std::exchange(objects_[end_++], object);
  Py_XDECREF(before);
}

void PythonArguments::add(double number) {
  PyObject* const kept = objects_[end_];
  if (repeated(std::bit_cast<std::uint64_t>(number))) {
    ++end_;
  } else if (kept != nullptr && Py_REFCNT(kept) == 1) {
    reinterpret_cast<PyFloatObject*>(kept)->ob_fval = number;
    changed_ = true;
    ++end_;
  } else {
    replace(PyFloat_FromDouble(number));
  }
}

void PythonArguments::add(long number) {
  repeated(static_cast<std::uint64_t>(number)) ? void(++end_) : replace(PyLong_FromLong(number));
}

void PythonArguments::add_array(const Argument& argument) {
  if (PyObject* kept = objects_[end_]; kept != nullptr) {
    auto array = py::reinterpret_borrow<py::array>(kept);
    if (can_be_filled(array, argument)) {
      auto* numbers = static_cast<double*>(array.mutable_data());
      changed_ = changed_ || !std::equal(numbers, numbers + array.size(), argument.data);
      std::copy_n(argument.data, array.size(), numbers);
      ++end_;
      return;
    }
  }
  std::vector<py::ssize_t> shape{argument.rows};
  if (argument.columns != 0) shape.push_back(argument.columns);
  replace(new_array(std::move(shape), argument.data).release().ptr());
}

void PythonArguments::add(Signature::Kind kind, const Argument& argument) {
  using Kind = Signature::Kind;
  switch (kind) {
    case Kind::scalar: return add(*argument.data);
    case Kind::integer: return add(static_cast<long>(*argument.data));
    case Kind::boolean: return replace(PyBool_FromLong(*argument.data != 0));
    case Kind::configuration:
      return replace(enum_member("ConfigurationType", static_cast<std::uint32_t>(*argument.data)).release().ptr());
    case Kind::vector:
    case Kind::matrix:
    case Kind::open_vector:
    case Kind::open_matrix: return add_array(argument);
    case Kind::index_list: return replace(integer_list(argument).release().ptr());
  }
}

PyObject* PythonArguments::call(PyObject* function, PyObject* system) {
  PyObject** const arguments = objects_.data() + first - 1;
  arguments[0] = system;
  return PyObject_Vectorcall(function, arguments, (end_ - first + 1) | PY_VECTORCALL_ARGUMENTS_OFFSET, nullptr);
}

}  // namespace dalembert
