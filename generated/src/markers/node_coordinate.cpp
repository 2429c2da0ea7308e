// Generated from specs/markers/node_coordinate.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/node_coordinate_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/node_coordinate.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_node_coordinate {

using Record = MarkerNodeCoordinateRecord;

constexpr std::array<Row, 4> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "coordinate", .storage = Storage::integer, .offset = offsetof(Record, parameters.coordinate), .role = Role::parameter, .check = Check::non_negative, .named = Named::joints, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 2> provides{"Node", "Coordinate"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerNodeCoordinate, MarkerNodeCoordinateRecord>{};

}  // namespace marker_node_coordinate

extern const ItemType marker_node_coordinate_type;
const ItemType marker_node_coordinate_type{
    .kind = ItemKind::marker,
    .name = "MarkerNodeCoordinate",
    .type_name = "NodeCoordinate",
    .category = "",
    .short_names = marker_node_coordinate::short_names,
    .provides = marker_node_coordinate::provides,
    .rows = marker_node_coordinate::rows,
    .outputs = marker_node_coordinate::outputs,
    .record = record_operations<marker_node_coordinate::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_node_coordinate::physics,
    .spec = "specs/markers/node_coordinate.toml",
};

}  // namespace dalembert
