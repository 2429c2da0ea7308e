// Access to the members of a record through the rows of its type.
#pragma once

#include <algorithm>
#include <concepts>
#include <stdexcept>
#include <type_traits>

#include "dalembert/enums.hpp"
#include "dalembert/model/item.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

inline void* member(void* record, const Row& row) { return static_cast<char*>(record) + row.offset; }
inline const void* member(const void* record, const Row& row) { return static_cast<const char*>(record) + row.offset; }

// The member of this name; nullptr if the item does not have it.
template <class T>
const T* member_of(const Item& item, std::string_view name) {
  const Row* row = find_row(*item.type, name);
  return row == nullptr ? nullptr : static_cast<const T*>(member(item.record.get(), *row));
}

// The member type of one storage tag, as a value to pass on: type_of<T>.
template <class T>
struct TypeTag {
  using type = T;
};

// Call `f(TypeTag<T>{})` with the type that `storage` stands for. Enumerations of settings are 32-bit numbers here.
template <class F>
decltype(auto) with_type(Storage storage, F&& f) {
  switch (storage) {
    case Storage::boolean: return f(TypeTag<bool>{});
    case Storage::integer: return f(TypeTag<int>{});
    case Storage::real: return f(TypeTag<double>{});
    case Storage::text: return f(TypeTag<std::string>{});
    case Storage::texts: return f(TypeTag<std::vector<std::string>>{});
    case Storage::vector2: return f(TypeTag<Vec<double, 2>>{});
    case Storage::vector3: return f(TypeTag<Vec<double, 3>>{});
    case Storage::vector4: return f(TypeTag<Vec<double, 4>>{});
    case Storage::vector6: return f(TypeTag<Vec<double, 6>>{});
    case Storage::vector7: return f(TypeTag<Vec<double, 7>>{});
    case Storage::vector9: return f(TypeTag<Vec<double, 9>>{});
    case Storage::matrix3: return f(TypeTag<Mat<double, 3, 3>>{});
    case Storage::matrix6: return f(TypeTag<Mat<double, 6, 6>>{});
    case Storage::vector: return f(TypeTag<std::vector<double>>{});
    case Storage::matrix: return f(TypeTag<DynamicMatrix<double>>{});
    case Storage::integer_matrix: return f(TypeTag<DynamicMatrix<int>>{});
    case Storage::matrix_container: return f(TypeTag<MatrixContainer>{});
    case Storage::integers: return f(TypeTag<std::vector<int>>{});
    case Storage::vector3s: return f(TypeTag<std::vector<Vec<double, 3>>>{});
    case Storage::matrix3s: return f(TypeTag<std::vector<Mat<double, 3, 3>>>{});
    case Storage::vector6s: return f(TypeTag<std::vector<Vec<double, 6>>>{});
    case Storage::node: return f(TypeTag<NodeIndex>{});
    case Storage::object: return f(TypeTag<ObjectIndex>{});
    case Storage::marker: return f(TypeTag<MarkerIndex>{});
    case Storage::load: return f(TypeTag<LoadIndex>{});
    case Storage::sensor: return f(TypeTag<SensorIndex>{});
    case Storage::nodes: return f(TypeTag<std::vector<NodeIndex>>{});
    case Storage::objects: return f(TypeTag<std::vector<ObjectIndex>>{});
    case Storage::markers: return f(TypeTag<std::vector<MarkerIndex>>{});
    case Storage::loads: return f(TypeTag<std::vector<LoadIndex>>{});
    case Storage::sensors: return f(TypeTag<std::vector<SensorIndex>>{});
    case Storage::output_variable: return f(TypeTag<OutputVariableType>{});
    case Storage::joint_types: return f(TypeTag<std::vector<JointType>>{});
    case Storage::beam_section: return f(TypeTag<BeamSection>{});
    case Storage::user_function: return f(TypeTag<UserFunction>{});
    case Storage::opaque: return f(TypeTag<Opaque>{});
    case Storage::enumeration: return f(TypeTag<std::uint32_t>{});
  }
  throw std::logic_error("a row names a storage that with_type does not know");
}

// Call `f(member)` with a typed reference to the member.
template <class F>
decltype(auto) visit(const Row& row, void* record, F&& f) {
  return with_type(row.storage,
                   [&]<class T>(TypeTag<T>) -> decltype(auto) { return f(*static_cast<T*>(member(record, row))); });
}
template <class F>
decltype(auto) visit(const Row& row, const void* record, F&& f) {
  return with_type(row.storage, [&]<class T>(TypeTag<T>) -> decltype(auto) {
    return f(*static_cast<const T*>(member(record, row)));
  });
}

// Storages that hold item numbers, and the kind of item they count.
struct IndexStorage {
  bool is_index = false, is_list = false;
  ItemKind kind = ItemKind::node;
};
constexpr IndexStorage index_storage(Storage storage) {
  const int first = static_cast<int>(Storage::node), tag = static_cast<int>(storage) - first;
  if (tag < 0 || tag >= 10) return {};
  return {true, tag >= 5, static_cast<ItemKind>(tag % 5)};
}
static_assert(index_storage(Storage::sensor).kind == ItemKind::sensor && !index_storage(Storage::sensor).is_list);
static_assert(index_storage(Storage::sensors).kind == ItemKind::sensor && index_storage(Storage::sensors).is_list);
static_assert(!index_storage(Storage::output_variable).is_index && !index_storage(Storage::vector6s).is_index);

// All item numbers in a member, as plain integers that may be changed. Every ItemIndex is one int.
std::span<int> index_values(const Row& row, void* record);
std::span<const int> index_values(const Row& row, const void* record);

inline bool has_user_function(const ItemType& type, const void* record) {
  return std::ranges::any_of(type.rows, [&](const Row& row) {
    return row.storage == Storage::user_function && *static_cast<const UserFunction*>(member(record, row));
  });
}

template <class T>
constexpr bool is_vec = false;
template <int N>
constexpr bool is_vec<Vec<double, N>> = true;
template <class T>
constexpr bool is_mat = false;
template <int R, int C>
constexpr bool is_mat<Mat<double, R, C>> = true;
template <class T>
constexpr int row_count = 0;
template <int R, int C>
constexpr int row_count<Mat<double, R, C>> = R;
template <int N>
constexpr int row_count<Vec<double, N>> = N;
template <class T>
constexpr bool is_item_index = false;
template <ItemKind K>
constexpr bool is_item_index<ItemIndex<K>> = true;
template <class T>
constexpr ItemKind kind_of = ItemKind::node;
template <ItemKind K>
constexpr ItemKind kind_of<ItemIndex<K>> = K;

}  // namespace dalembert
