// Generated from specs/nodes/point.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/point_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/node.hpp"
#include "dalembert/items/nodes/point.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_point {

using Record = NodePointRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector3, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .needs_assemble = true, .unit = "m"},
    {.name = "initialCoordinates", .storage = Storage::vector3, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "m"},
    {.name = "initialVelocities", .storage = Storage::vector3, .offset = offsetof(Record, parameters.initialVelocities), .role = Role::parameter, .unit = "m/s"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"Point"};
constexpr std::array<std::string_view, 1> provides{"Position"};
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

const auto& physics = NodePhysicsOf<NodePoint, NodePointRecord>{};

}  // namespace node_point

extern const ItemType node_point_type;
const ItemType node_point_type{
    .kind = ItemKind::node,
    .name = "NodePoint",
    .type_name = "Point",
    .category = "",
    .short_names = node_point::short_names,
    .provides = node_point::provides,
    .rows = node_point::rows,
    .outputs = node_point::outputs,
    .record = record_operations<node_point::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_point::physics,
    .spec = "specs/nodes/point.toml",
};

}  // namespace dalembert
