// The Python objects that a user function is called with.
#pragma once

#include <pybind11/numpy.h>

#include <array>
#include <cstdint>

#include "dalembert/reflection/callback.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

namespace py = pybind11;

// They are kept from call to call: numbers that have not changed are passed again, floats and arrays are filled again unless
// the function has kept them. The lock of the interpreter is held.
class PythonArguments {
 public:
  static constexpr std::size_t most = 24;

  PythonArguments() = default;
  ~PythonArguments() { clear(); }
  PythonArguments(const PythonArguments&) = delete;
  PythonArguments& operator=(const PythonArguments&) = delete;

  void clear();

  // Time and item number are left out where the signature does.
  void fill(const Signature& signature, double time, int item, std::span<const Argument> arguments);
  // Whether they differ from those before, or were not kept.
  bool changed() const { return changed_; }
  // Calls the function with the system and the arguments; nullptr if it has raised an exception.
  PyObject* call(PyObject* function, PyObject* system);
  // Forgets the objects without giving them back: there is no interpreter any more.
  void abandon() { objects_ = {}; }

 private:
  void add(double number);
  void add(long number);
  void add(Signature::Kind kind, const Argument& argument);
  void add_array(const Argument& argument);
  bool repeated(std::uint64_t bits);
  void replace(PyObject* object);  // stolen

  static constexpr std::size_t first = 2;  // the place before belongs to the system, and one to the call itself
  std::array<PyObject*, first + most> objects_{};
  std::array<std::uint64_t, first + most> bits_{};  // of numbers
  std::size_t end_ = first;
  bool changed_ = false;
};

}  // namespace dalembert
