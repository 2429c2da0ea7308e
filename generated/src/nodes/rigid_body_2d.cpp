// Generated from specs/nodes/rigid_body_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/rigid_body_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/node.hpp"
#include "dalembert/items/nodes/rigid_body_2d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_rigid_body_2d {

using Record = NodeRigidBody2DRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector3, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .needs_assemble = true, .unit = "various"},
    {.name = "initialCoordinates", .storage = Storage::vector3, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "various"},
    {.name = "initialVelocities", .storage = Storage::vector3, .offset = offsetof(Record, parameters.initialVelocities), .role = Role::parameter, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"Rigid2D"};
constexpr std::array<std::string_view, 5> provides{"Position2D", "Orientation2D", "Position", "Orientation", "RigidBody"};
constexpr std::array<OutputVariableType, 14> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Acceleration,
    OutputVariableType::AngularVelocity,
    OutputVariableType::CoordinatesTotal,
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Coordinates_tt,
    OutputVariableType::RotationMatrix,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::AngularAcceleration,
    OutputVariableType::HomogeneousTransformation,
};

const auto& physics = NodePhysicsOf<NodeRigidBody2D, NodeRigidBody2DRecord>{};

}  // namespace node_rigid_body_2d

extern const ItemType node_rigid_body_2d_type;
const ItemType node_rigid_body_2d_type{
    .kind = ItemKind::node,
    .name = "NodeRigidBody2D",
    .type_name = "RigidBody2D",
    .category = "",
    .short_names = node_rigid_body_2d::short_names,
    .provides = node_rigid_body_2d::provides,
    .rows = node_rigid_body_2d::rows,
    .outputs = node_rigid_body_2d::outputs,
    .record = record_operations<node_rigid_body_2d::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_rigid_body_2d::physics,
    .spec = "specs/nodes/rigid_body_2d.toml",
};

}  // namespace dalembert
