// Generated from specs/markers/body_position.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/body_position_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/body_position.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_body_position {

using Record = MarkerBodyPositionRecord;

constexpr std::array<Row, 4> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "localPosition", .storage = Storage::vector3, .offset = offsetof(Record, parameters.localPosition), .role = Role::parameter, .unit = "m"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Object", "Body", "Position"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerBodyPosition, MarkerBodyPositionRecord>{};

}  // namespace marker_body_position

extern const ItemType marker_body_position_type;
const ItemType marker_body_position_type{
    .kind = ItemKind::marker,
    .name = "MarkerBodyPosition",
    .type_name = "BodyPosition",
    .category = "",
    .short_names = marker_body_position::short_names,
    .provides = marker_body_position::provides,
    .rows = marker_body_position::rows,
    .outputs = marker_body_position::outputs,
    .record = record_operations<marker_body_position::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_body_position::physics,
    .spec = "specs/markers/body_position.toml",
};

}  // namespace dalembert
