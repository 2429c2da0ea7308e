// Generated from specs/nodes/point_ground.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/point_ground_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/node.hpp"
#include "dalembert/items/nodes/point_ground.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_point_ground {

using Record = NodePointGroundRecord;

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector3, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .unit = "m"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"PointGround"};
constexpr std::array<std::string_view, 5> provides{"Ground", "Position2D", "Position", "Orientation", "GenericODE2"};
constexpr std::array<OutputVariableType, 11> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::CoordinatesTotal,
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::RotationMatrix,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::HomogeneousTransformation,
};

const auto& physics = NodePhysicsOf<NodePointGround, NodePointGroundRecord>{};

}  // namespace node_point_ground

extern const ItemType node_point_ground_type;
const ItemType node_point_ground_type{
    .kind = ItemKind::node,
    .name = "NodePointGround",
    .type_name = "PointGround",
    .category = "",
    .short_names = node_point_ground::short_names,
    .provides = node_point_ground::provides,
    .rows = node_point_ground::rows,
    .outputs = node_point_ground::outputs,
    .record = record_operations<node_point_ground::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_point_ground::physics,
    .spec = "specs/nodes/point_ground.toml",
};

}  // namespace dalembert
