// Generated from specs/nodes/point_slope23.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/point_slope23_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/node.hpp"
#include "dalembert/items/nodes/point_slope23.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_point_slope23 {

using Record = NodePointSlope23Record;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector9, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .needs_assemble = true, .unit = "various"},
    {.name = "initialCoordinates", .storage = Storage::vector9, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "various"},
    {.name = "initialVelocities", .storage = Storage::vector9, .offset = offsetof(Record, parameters.initialVelocities), .role = Role::parameter, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 2> provides{"Position", "Orientation"};
constexpr std::array<OutputVariableType, 13> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Acceleration,
    OutputVariableType::CoordinatesTotal,
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Coordinates_tt,
    OutputVariableType::RotationMatrix,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::HomogeneousTransformation,
};

const auto& physics = NodePhysicsOf<NodePointSlope23, NodePointSlope23Record>{};

}  // namespace node_point_slope23

extern const ItemType node_point_slope23_type;
const ItemType node_point_slope23_type{
    .kind = ItemKind::node,
    .name = "NodePointSlope23",
    .type_name = "PointSlope23",
    .category = "",
    .short_names = node_point_slope23::short_names,
    .provides = node_point_slope23::provides,
    .rows = node_point_slope23::rows,
    .outputs = node_point_slope23::outputs,
    .record = record_operations<node_point_slope23::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_point_slope23::physics,
    .spec = "specs/nodes/point_slope23.toml",
};

}  // namespace dalembert
