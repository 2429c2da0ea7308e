// Run-time description of an item type. One constant per spec, written by the generator.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "dalembert/enums.hpp"
#include "dalembert/reflection/row.hpp"

namespace dalembert {

// The parameters of one item, type-erased: the struct that the generator wrote.
struct RecordOperations {
  std::shared_ptr<void> (*create)();  // has the spec's defaults
  std::shared_ptr<void> (*copy)(const void*);
};

template <class Record>
constexpr RecordOperations record_operations() {
  return {[]() -> std::shared_ptr<void> { return std::make_shared<Record>(); },
          [](const void* other) -> std::shared_ptr<void> {
            return std::make_shared<Record>(*static_cast<const Record*>(other));
          }};
}

// Capabilities of an item for other items, as bits: a request is met if all of its bits are provided.
enum class Capability : std::uint32_t {
  none = 0,
  position = 1,
  orientation = 2,
  coordinate = 4,
  body_mass = 8,
  generic_ode2 = 16,
  generic_data = 32,
  position_2d = 64,
  orientation_2d = 128,
};
constexpr Capability operator|(Capability a, Capability b) {
  return static_cast<Capability>(static_cast<std::uint32_t>(a) | static_cast<std::uint32_t>(b));
}
constexpr bool meets(Capability provided, Capability requested) {
  return (static_cast<std::uint32_t>(provided) & static_cast<std::uint32_t>(requested)) ==
         static_cast<std::uint32_t>(requested);
}

struct Physics;  // dalembert/system/physics.hpp: how items of this type enter a system

struct ItemType {
  ItemKind kind;
  std::string_view name;                             // 'ObjectMassPoint'
  std::string_view type_name;                        // 'MassPoint'
  std::string_view category;                         // objects: 'Body', 'Joint', ...
  std::span<const std::string_view> short_names;
  std::span<const std::string_view> provides;  // listed in the reference documentation
  std::span<const Row> rows;                         // name, parameters, visualization, in the order of the spec
  std::span<const OutputVariableType> outputs;
  RecordOperations record;
  Capability requested_node = Capability::none;  // required of its nodes
  Capability requested_marker = Capability::none;  // required of its markers
  const Physics* physics = nullptr;                  // null: planned
  std::string_view spec;                             // 'specs/bodies/mass_point.toml'
};

// All item types, in the order of the reference.
std::span<const ItemType* const> item_types();

}  // namespace dalembert
