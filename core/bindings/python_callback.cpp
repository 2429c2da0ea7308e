#include "python_callback.hpp"

#include <algorithm>

#include "compiled_callback.hpp"
#include "controllers.hpp"
#include "conversion.hpp"
#include "dalembert/model/member.hpp"
#include "interpreter_lock.hpp"
#include "item_callback.hpp"
#include "main_system.hpp"
#include "python_arguments.hpp"
#include "python_errors.hpp"
#include "sequence.hpp"
#include "symbolic.hpp"

namespace dalembert {
namespace {

using Kind = Signature::Kind;

py::object referent(PyObject* reference) {
#if PY_VERSION_HEX >= 0x030D0000
  PyObject* object = nullptr;
  if (PyWeakref_GetRef(reference, &object) < 0) throw py::error_already_set();
  return object == nullptr ? py::none() : py::reinterpret_steal<py::object>(object);
#else
  return py::reinterpret_borrow<py::object>(PyWeakref_GetObject(reference));
#endif
}

int dimensions(Kind kind) { return Signature::is_matrix(kind) ? 2 : Signature::is_vector(kind) ? 1 : 0; }

std::string entries(std::size_t n) { return std::to_string(n) + (n == 1 ? " number" : " numbers"); }

class PythonCallback final : public ItemCallback {
 public:
  PythonCallback(py::object function, const Row& row) : ItemCallback(std::move(function), row) {}
  ~PythonCallback() override {
    if (Py_IsInitialized() == 0) {
      system_.release();
      kept_.abandon();
      return;
    }
    const py::gil_scoped_acquire gil;
    system_ = py::object();
    kept_.clear();
  }
  PythonCallback(const PythonCallback&) = delete;
  PythonCallback& operator=(const PythonCallback&) = delete;

  void call(double time, int item, std::span<const Argument> arguments, std::span<double> results) const override {
    const InterpreterLock lock(InterpreterLock::Afterwards::may_be_kept);
    const py::object result = invoke(time, item, arguments);
    try {
      if (!read_plain_reals(result.ptr(), dimensions_, results)) store(result.ptr(), results);
    } catch (const Refusal& refusal) {
      refuse_result(result.ptr(), refusal, item);
    }
    if (running_) return;
    last_.resize(results.size());
    std::ranges::copy(results, last_.begin());
    last_known_ = true;
  }

  void recall(double time, int item, std::span<const Argument> arguments, std::span<double> results) const override {
    const InterpreterLock lock(InterpreterLock::Afterwards::may_be_kept);
    if (!running_ && last_known_ && last_.size() == results.size()) {
      kept_.fill(shape_, time, item, arguments);
      if (!kept_.changed()) {
        std::ranges::copy(last_, results.begin());
        return;
      }
    }
    call(time, item, arguments, results);
  }

  std::vector<double> call_any(double time, int item, std::span<const Argument> arguments) const override {
    const InterpreterLock lock(InterpreterLock::Afterwards::may_be_kept);
    const py::object result = invoke(time, item, arguments);
    try {
      if (shape_.result == Kind::scalar || PyFloat_Check(result.ptr())) return {read_real(result.ptr())};
      return read_reals(result.ptr());
    } catch (const Refusal& refusal) {
      refuse_result(result.ptr(), refusal, item);
    }
  }

  std::shared_ptr<ItemCallback> copy() const override { return std::make_shared<PythonCallback>(function(), row()); }

 private:
  // A function that is called while it runs, or from another thread, gets objects of its own.
  py::object invoke(double time, int item, std::span<const Argument> arguments) const {
    const RunningFunction known = running(item);
    if (running_) {
      PythonArguments own;
      return invoke(own, time, item, arguments);
    }
    const Running running(running_);
    last_known_ = false;
    return invoke(kept_, time, item, arguments);
  }

  py::object invoke(PythonArguments& objects, double time, int item, std::span<const Argument> arguments) const {
    objects.fill(shape_, time, item, arguments);
    PyObject* result = objects.call(function().ptr(), system().ptr());
    if (result == nullptr) blame(time, item);
    return py::reinterpret_steal<py::object>(result);
  }

  [[noreturn]] void blame(double time, int item) const {
    throw_python_error("in " + describe(item) + ", at time " + std::to_string(time), expected_call());
  }

  // The Python object of the system, which owns this callback: only a weak reference to it is kept.
  py::object system() const {
    if (system_) {
      if (py::object alive = referent(system_.ptr()); !alive.is_none()) return alive;
    }
    const auto main = this->main();
    if (!main) return py::none();
    py::object object = py::cast(main);
    system_ = py::weakref(object);
    return object;
  }

  // Converts all other numeric types.
  void store(PyObject* result, std::span<double> results) const {
    switch (shape_.result) {
      case Kind::scalar:
      case Kind::integer:
      case Kind::boolean: results[0] = read_real(result); return;
      case Kind::matrix:
      case Kind::open_matrix: store_matrix(result, results); return;
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

  struct Running {
    explicit Running(bool& flag) : flag(flag) { flag = true; }
    ~Running() { flag = false; }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    bool& flag;
  };

  const Signature& shape_ = signature();
  const int dimensions_ = dimensions(shape_.result);
  mutable py::object system_;  // weak reference
  mutable PythonArguments kept_;
  mutable std::vector<double> last_;  // results of the call with these, if known
  mutable bool running_ = false, last_known_ = false;
};

}  // namespace

UserFunction read_user_function(PyObject* value, const Row& row) {
  if (value == Py_None) return {};
  if (PyLong_Check(value) && PyObject_IsTrue(value) == 0) return {};
  // GetObjectParameter of Exudyn returns a dictionary; such a dictionary must be accepted as an input.
  if (PyDict_Check(value)) {
    if (PyObject* function = PyDict_GetItemString(value, "function"); function != nullptr) value = function;
  }
  if (auto callback = symbolic_callback(value, row)) return {std::move(callback)};
  if (auto callback = controller_callback(value, row)) return {std::move(callback)};
  if (auto callback = compiled_callback(value, row)) return {std::move(callback)};
  if (PyCallable_Check(value) == 0)
    throw Refusal{ErrorKind::type, "a function, or 0 for none", "Pass the function itself, without calling it."};
  return {std::make_shared<PythonCallback>(py::reinterpret_borrow<py::object>(value), row)};
}

PyObject* function_of(const UserFunction& function) {
  if (!function) return Py_None;
  if (const auto* callback = dynamic_cast<const ItemCallback*>(function.callback.get()))
    return callback->function().ptr();
  PyObject* symbolic = symbolic_function(*function.callback);
  return symbolic == nullptr ? Py_None : symbolic;
}

bool needs_interpreter(const UserFunction& function) {
  return dynamic_cast<const PythonCallback*>(function.callback.get()) != nullptr;
}

PyObject* owned_function(const UserFunction& function) {
  const auto* callback = dynamic_cast<const ItemCallback*>(function.callback.get());
  return callback == nullptr ? nullptr : callback->function().ptr();
}

void drop_function(const UserFunction& function) {
  if (const auto* callback = dynamic_cast<const ItemCallback*>(function.callback.get())) callback->drop();
}

UserFunction bind_user_function(const ItemType& type, const UserFunction& function, MainSystem& main) {
  const auto* callback = dynamic_cast<const ItemCallback*>(function.callback.get());
  return callback == nullptr ? function : UserFunction{callback->bound_to(type, main)};
}

std::shared_ptr<const void> bind_user_functions(const ItemType& type, std::shared_ptr<const void> record,
                                                MainSystem& main) {
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

void throw_python_error(const std::string& where, const std::string& call) {
  py::error_already_set error;
  const bool miscalled = error.matches(PyExc_TypeError) &&
                         std::string_view(error.what()).find("positional argument") != std::string_view::npos;
  const std::string note = where + (miscalled && !call.empty() ? "; it is called as " + call : "");
  // Notes exist since Python 3.11; an exception type may still refuse them.
  PyObject* added = PyObject_CallMethod(error.value().ptr(), "add_note", "s", note.c_str());
  if (added == nullptr) PyErr_Clear();
  Py_XDECREF(added);
  throw error;
}

}  // namespace dalembert
