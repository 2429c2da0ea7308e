// Generated from specs/markers/super_element_position.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/super_element_position_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// By hand: it rests on any number of mesh nodes of any types
const Physics& marker_super_element_position_physics();

// Named, for several of these files may be compiled at once.
namespace marker_super_element_position {

using Record = MarkerSuperElementPositionRecord;

constexpr std::array<Row, 6> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "meshNodeNumbers", .storage = Storage::integers, .offset = offsetof(Record, parameters.meshNodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "weightingFactors", .storage = Storage::vector, .offset = offsetof(Record, parameters.weightingFactors), .role = Role::parameter, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "showMarkerNodes", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showMarkerNodes), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Object", "Body", "Position"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = marker_super_element_position_physics();

}  // namespace marker_super_element_position

extern const ItemType marker_super_element_position_type;
const ItemType marker_super_element_position_type{
    .kind = ItemKind::marker,
    .name = "MarkerSuperElementPosition",
    .type_name = "SuperElementPosition",
    .category = "",
    .short_names = marker_super_element_position::short_names,
    .provides = marker_super_element_position::provides,
    .rows = marker_super_element_position::rows,
    .outputs = marker_super_element_position::outputs,
    .record = record_operations<marker_super_element_position::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_super_element_position::physics,
    .spec = "specs/markers/super_element_position.toml",
};

}  // namespace dalembert
