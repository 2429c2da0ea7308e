#include "python_callback.hpp"

#include <pybind11/numpy.h>

#include <algorithm>

#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "main_system.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"
#include "symbolic.hpp"

namespace dalembert {
namespace {

using Kind = Signature::Kind;

py::object python_argument(Kind kind, const Argument& argument) {
  switch (kind) {
    case Kind::scalar: return py::float_(*argument.data);
    case Kind::integer: return py::int_(static_cast<long>(*argument.data));
    case Kind::boolean: return py::bool_(*argument.data != 0);
    case Kind::configuration: return enum_member("ConfigurationType", static_cast<std::uint32_t>(*argument.data));
    case Kind::vector: return py::array_t<double>(argument.rows, argument.data);
    case Kind::matrix:
      return py::array_t<double>(std::vector<py::ssize_t>{argument.rows, argument.columns}, argument.data);
    case Kind::index_list: break;
  }
  py::list list;
  for (int i = 0; i < argument.rows; ++i) list.append(static_cast<long>(argument.data[i]));
  return list;
}

std::string entries(std::size_t n) { return std::to_string(n) + (n == 1 ? " number" : " numbers"); }

class PythonCallback final : public Callback {
 public:
  PythonCallback(py::object function, const Row& row) : function_(std::move(function)), row_(row) {}
  ~PythonCallback() override {
    if (Py_IsInitialized() == 0) {
      function_.release();
      return;
    }
    const py::gil_scoped_acquire gil;
    function_ = py::object();
  }
  PythonCallback(const PythonCallback&) = delete;
  PythonCallback& operator=(const PythonCallback&) = delete;

  void call(double time, int item, std::span<const Argument> arguments, std::span<double> results) const override {
    const py::gil_scoped_acquire gil;
    const py::object result = invoke(time, item, arguments);
    try {
      store(result.ptr(), results);
    } catch (const Refusal& refusal) {
      refuse_result(result.ptr(), refusal, item);
    }
  }

  std::vector<double> call_any(double time, int item, std::span<const Argument> arguments) const override {
    const py::gil_scoped_acquire gil;
    const py::object result = invoke(time, item, arguments);
    try {
      if (signature().result == Kind::scalar || PyFloat_Check(result.ptr())) return {read_real(result.ptr())};
      return read_reals(result.ptr());
    } catch (const Refusal& refusal) {
      refuse_result(result.ptr(), refusal, item);
    }
  }

  std::shared_ptr<const Callback> bound_to(const ItemType& type, MainSystem& main) const {
    auto copy = std::make_shared<PythonCallback>(function_, row_);
    copy->type_ = &type;
    copy->main_ = main.weak_from_this();
    return copy;
  }

  PyObject* function() const { return function_.ptr(); }

 private:
  const Signature& signature() const {
    static const Signature none{};
    return row_.signature != nullptr ? *row_.signature : none;
  }

  std::string describe(int item) const {
    std::string text = "user function '" + std::string(row_.name) + "'";
    if (type_ == nullptr) return text;
    if (const auto main = main_.lock()) {
      if (!has_this(*main, item)) item = find_this(*main);
      if (item >= 0) return text + " of " + main->model.describe(type_->kind, item);
    }
    return text + " of a " + std::string(type_->name);
  }

  bool has_this(const MainSystem& main, int number) const {
    const Item* item = main.model.find_item(type_->kind, number);
    return item != nullptr && item->type == type_ &&
           static_cast<const UserFunction*>(member(item->record.get(), row_))->callback.get() == this;
  }
  // Functions of loads are called without their number.
  int find_this(const MainSystem& main) const {
    for (int i = 0; i < main.model.count(type_->kind); ++i)
      if (has_this(main, i)) return i;
    return -1;
  }

  py::object invoke(double time, int item, std::span<const Argument> arguments) const {
    const Signature& shape = signature();
    const auto main = main_.lock();
    constexpr std::size_t most = 24;
    std::array<py::object, most> held;
    std::size_t n = 0;
    held[n++] = main ? py::cast(main) : py::none();
    if (shape.takes_time) held[n++] = py::float_(time);
    if (shape.takes_item) held[n++] = py::int_(item);
    for (std::size_t i = 0; i < arguments.size() && n < most; ++i)
      held[n++] = python_argument(i < shape.arguments.size() ? shape.arguments[i] : Kind::scalar, arguments[i]);
    std::array<PyObject*, most> stack{};
    std::ranges::transform(held, stack.begin(), [](const py::object& object) { return object.ptr(); });
    PyObject* result = PyObject_Vectorcall(function_.ptr(), stack.data(), n, nullptr);
    if (result == nullptr) throw_python_error("in " + describe(item) + ", at time " + std::to_string(time));
    return py::reinterpret_steal<py::object>(result);
  }

  void store(PyObject* result, std::span<double> results) const {
    switch (signature().result) {
      case Kind::scalar:
      case Kind::integer:
      case Kind::boolean: results[0] = read_real(result); return;
      case Kind::matrix: store_matrix(result, results); return;
      default: break;
    }
    const std::string what = "a list or array of " + entries(results.size());
    const Reals reals(result, what);
    if (static_cast<std::size_t>(reals.size()) != results.size())
      throw Refusal{ErrorKind::value, what, "The length is " + std::to_string(reals.size()) + "."};
    reals.copy_to(results.data(), what);
  }

  // Matrices may come as arrays, lists of lists, sparse matrices or a MatrixContainer.
  void store_matrix(PyObject* result, std::span<double> results) const {
    MatrixContainer matrix;
    Row row{};
    row.storage = Storage::matrix_container;
    from_python(result, row, &matrix);
    if (static_cast<std::size_t>(matrix.rows) * static_cast<std::size_t>(matrix.columns) != results.size())
      throw Refusal{ErrorKind::value, "a matrix of " + entries(results.size()),
                    "It is " + std::to_string(matrix.rows) + " x " + std::to_string(matrix.columns) + "."};
    if (matrix.dense) {
      std::ranges::copy(matrix.values, results.begin());
      return;
    }
    std::ranges::fill(results, 0.0);
    for (const auto& entry : matrix.triplets)
      results[static_cast<std::size_t>(entry.row) * static_cast<std::size_t>(matrix.columns) +
              static_cast<std::size_t>(entry.column)] += entry.value;
  }

  [[noreturn]] void refuse_result(PyObject* result, const Refusal& refusal, int item) const {
    refuse(refusal.kind, {describe(item), "", "", show(result) + " as result", refusal.expected, refusal.advice});
  }

  py::object function_;
  const Row& row_;
  const ItemType* type_ = nullptr;
  std::weak_ptr<MainSystem> main_;
};

}  // namespace

UserFunction read_user_function(PyObject* value, const Row& row) {
  if (value == Py_None) return {};
  if (PyLong_Check(value) && PyObject_IsTrue(value) == 0) return {};
  // GetObjectParameter of the interface's origin gives a dictionary; what it gives must be accepted again.
  if (PyDict_Check(value)) {
    if (PyObject* function = PyDict_GetItemString(value, "function"); function != nullptr) value = function;
  }
  if (auto callback = symbolic_callback(value, row)) return {std::move(callback)};
  if (PyCallable_Check(value) == 0)
    throw Refusal{ErrorKind::type, "a function, or 0 for none", "Pass the function itself, without calling it."};
  return {std::make_shared<PythonCallback>(py::reinterpret_borrow<py::object>(value), row)};
}

PyObject* function_of(const UserFunction& function) {
  if (!function) return Py_None;
  if (const auto* callback = dynamic_cast<const PythonCallback*>(function.callback.get())) return callback->function();
  PyObject* symbolic = symbolic_function(*function.callback);
  return symbolic == nullptr ? Py_None : symbolic;
}

UserFunction bind_user_function(const ItemType& type, const UserFunction& function, MainSystem& main) {
  const auto* callback = dynamic_cast<const PythonCallback*>(function.callback.get());
  return callback == nullptr ? function : UserFunction{callback->bound_to(type, main)};
}

std::shared_ptr<const void> bind_user_functions(const ItemType& type, std::shared_ptr<const void> record, MainSystem& main) {
  std::shared_ptr<void> copy;
  for (const Row& row : type.rows) {
    if (row.storage != Storage::user_function) continue;
    const auto& function = *static_cast<const UserFunction*>(member(record.get(), row));
    if (!function) continue;
    if (!copy) copy = type.record.copy(record.get());
    *static_cast<UserFunction*>(member(copy.get(), row)) = bind_user_function(type, function, main);
  }
  return copy ? std::shared_ptr<const void>(std::move(copy)) : record;
}

void throw_python_error(const std::string& note) {
  py::error_already_set error;
  // Notes exist since Python 3.11; an exception type may still refuse them.
  PyObject* added = PyObject_CallMethod(error.value().ptr(), "add_note", "s", note.c_str());
  if (added == nullptr) PyErr_Clear();
  Py_XDECREF(added);
  throw error;
}

}  // namespace dalembert
