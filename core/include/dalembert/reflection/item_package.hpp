// Item types of other extension modules: what they pass to the core, and the functions of the core that they call.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "dalembert/math/processor.hpp"
#include "dalembert/math/traced.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/value_checks.hpp"
#include "dalembert/reflection/own_items.hpp"
#include "dalembert/system/system.hpp"

namespace dalembert {

// Functions of the core that kernels and batches call. Extension modules share no symbols, and state such as the trace
// in progress must exist once, so a package calls them through this table. New entries are appended.
struct CoreFunctions {
  std::size_t size;  // bytes, as the core was compiled
  decltype(&dalembert::refuse) refuse;
  std::string (*describe)(const ItemLabel& item);
  decltype(&Traced::note) note;
  decltype(&dalembert::instructions) instructions;
  decltype(&dalembert::check_inertia) check_inertia;
  decltype(&dalembert::judge_inertia) judge_inertia;
  decltype(&dalembert::check_planar_inertia) check_planar_inertia;
  decltype(&dalembert::check_unit_length) check_unit_length;
  decltype(&System::node_output) node_output;
  decltype(&System::object_output) object_output;
  decltype(&System::body_output) body_output;
  decltype(&System::super_element_output) super_element_output;
  decltype(&System::link_output) link_output;
  decltype(&System::marker_output) marker_output;
  decltype(&System::load_values) load_values;
  decltype(&System::state_may_have_changed) state_may_have_changed;
};

// An extension module passes this in a capsule. The texts never change their places: they are read before the stamp is
// compared.
struct ItemPackage {
  static constexpr const char* capsule = "dalembert.item_package";
  std::size_t size;    // bytes, as the package was compiled
  const char* stamp;   // see `stamp_of`
  const char* module;  // 'my_items': pickles import its classes from there
  const char* source;  // directory of its specs and kernels
  const char* rebuild; // command that builds it from there: 'dalembert items build'
  std::span<const ItemType* const> types;
  std::span<const ItemText> texts;  // same order as `types`
  std::span<const ItemTransformation> transformations;
  const CoreFunctions** core;  // set by the core
};

// Layouts on which compilers and standard libraries differ: derived classes may use the tail padding of their base.
struct PaddedBase {
  double a = 0;
  char b = 0;
};
struct PaddedDerived : PaddedBase {
  char c = 0;
};

// Hash of the headers that an item can include (codegen/headers.py), and the binary interface of the compiler.
inline std::string stamp_of(const std::string& headers) {
#if defined(_LIBCPP_ABI_VERSION)
  std::string text = headers + " libc++-" + std::to_string(_LIBCPP_ABI_VERSION);
#elif defined(_GLIBCXX_USE_CXX11_ABI)
  std::string text = headers + " libstdc++-" + std::to_string(_GLIBCXX_USE_CXX11_ABI);
#else
  std::string text = headers + " other";
#endif
  for (const std::size_t size : {sizeof(void*), sizeof(long), sizeof(std::string), sizeof(std::function<void()>),
                                 sizeof(std::shared_ptr<int>), sizeof(PaddedDerived), alignof(std::max_align_t)})
    text += "-" + std::to_string(size);
  return text;
}

// Appends the item types of a package to the registry. Types and texts live as long as the process. The interpreter
// lock is held: nothing reads the registry while a solver runs.
void add_item_types(const ItemPackage& package);

}  // namespace dalembert
