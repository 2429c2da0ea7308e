// The C++ types that a parameter can have, and the tag by which rows name them.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dalembert/math/fixed.hpp"
#include "dalembert/reflection/beam_section.hpp"
#include "dalembert/reflection/shared_list.hpp"

namespace dalembert {

enum class ItemKind : std::uint8_t { node, object, marker, load, sensor };

// The number of an item among its kind; -1: not set.
template <ItemKind K>
struct ItemIndex {
  int value = -1;
  constexpr bool valid() const { return value >= 0; }
  constexpr auto operator<=>(const ItemIndex&) const = default;
};
using NodeIndex = ItemIndex<ItemKind::node>;
using ObjectIndex = ItemIndex<ItemKind::object>;
using MarkerIndex = ItemIndex<ItemKind::marker>;
using LoadIndex = ItemIndex<ItemKind::load>;
using SensorIndex = ItemIndex<ItemKind::sensor>;

// A dense matrix of run-time size, row by row.
template <class T>
struct DynamicMatrix {
  int rows = 0, columns = 0;
  SharedList<T> values;
  const T& operator()(int i, int j) const { return values[static_cast<std::size_t>(i) * columns + j]; }
  T& operator()(int i, int j) { return values.edit()[static_cast<std::size_t>(i) * columns + j]; }
};

// A matrix that is stored dense or as triplets, as the user gave it. Triplets may repeat: they add up.
struct MatrixContainer {
  struct Triplet {
    int row = 0, column = 0;
    double value = 0;
  };
  int rows = 0, columns = 0;
  bool dense = true;
  SharedList<double> values;     // dense: row by row
  SharedList<Triplet> triplets;  // sparse
  bool empty() const { return rows == 0 || columns == 0; }
};

// Something that lives outside the core (graphics data, the outline of a section): kept, copied, never looked into.
struct Opaque {
  std::shared_ptr<void> object;
};

class Callback;  // core/include/dalembert/reflection/callback.hpp

// A user function; empty: none.
struct UserFunction {
  std::shared_ptr<const Callback> callback;
  explicit operator bool() const { return callback != nullptr; }
};

// Member type of a row. Each entry has one converter to and from Python.
enum class Storage : std::uint8_t {
  boolean,       // bool
  integer,       // int
  real,          // double
  text,          // std::string
  texts,         // std::vector<std::string>
  vector2,
  vector3,
  vector4,
  vector6,
  vector7,
  vector9,  // Vec<double, N>
  matrix3,
  matrix6,                                      // Mat<double, N, N>
  vector,          // std::vector<double>
  matrix,          // DynamicMatrix<double>
  integer_matrix,  // DynamicMatrix<int>
  matrix_container,
  integers,    // std::vector<int>
  vector3s,    // std::vector<Vec<double, 3>>
  matrix3s,    // std::vector<Mat<double, 3, 3>>
  vector6s,    // std::vector<Vec<double, 6>>
  node,
  object,
  marker,
  load,
  sensor,        // ItemIndex<kind>
  nodes,
  objects,
  markers,
  loads,
  sensors,   // std::vector<ItemIndex<kind>>
  output_variable,  // OutputVariableType
  joint_types,      // std::vector<JointType>
  beam_section,     // BeamSection
  user_function,    // UserFunction
  opaque,           // Opaque
  enumeration,      // any other generated enumeration (settings)
};

}  // namespace dalembert
