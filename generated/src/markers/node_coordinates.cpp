// Generated from specs/markers/node_coordinates.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/node_coordinates_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/node_coordinates.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_node_coordinates {

using Record = MarkerNodeCoordinatesRecord;

constexpr std::array<Row, 3> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 2> provides{"Node", "Coordinate"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerNodeCoordinates, MarkerNodeCoordinatesRecord>{};

}  // namespace marker_node_coordinates

extern const ItemType marker_node_coordinates_type;
const ItemType marker_node_coordinates_type{
    .kind = ItemKind::marker,
    .name = "MarkerNodeCoordinates",
    .type_name = "NodeCoordinates",
    .category = "",
    .short_names = marker_node_coordinates::short_names,
    .provides = marker_node_coordinates::provides,
    .rows = marker_node_coordinates::rows,
    .outputs = marker_node_coordinates::outputs,
    .record = record_operations<marker_node_coordinates::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_node_coordinates::physics,
    .spec = "specs/markers/node_coordinates.toml",
};

}  // namespace dalembert
