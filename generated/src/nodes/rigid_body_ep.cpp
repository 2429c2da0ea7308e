// Generated from specs/nodes/rigid_body_ep.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/rigid_body_ep_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/node.hpp"
#include "dalembert/items/nodes/rigid_body_ep.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_rigid_body_ep {

using Record = NodeRigidBodyEPRecord;

constexpr std::array<Row, 8> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector7, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .needs_assemble = true, .unit = "various"},
    {.name = "initialCoordinates", .storage = Storage::vector7, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "various"},
    {.name = "initialVelocities", .storage = Storage::vector7, .offset = offsetof(Record, parameters.initialVelocities), .role = Role::parameter, .unit = "various"},
    {.name = "addConstraintEquation", .storage = Storage::boolean, .offset = offsetof(Record, parameters.addConstraintEquation), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"RigidEP"};
constexpr std::array<std::string_view, 4> provides{"Position", "Orientation", "RigidBody", "RotationEulerParameters"};
constexpr std::array<OutputVariableType, 14> outputs{
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
    OutputVariableType::AngularAcceleration,
    OutputVariableType::HomogeneousTransformation,
};

const auto& physics = NodePhysicsOf<NodeRigidBodyEP, NodeRigidBodyEPRecord>{};

}  // namespace node_rigid_body_ep

extern const ItemType node_rigid_body_ep_type;
const ItemType node_rigid_body_ep_type{
    .kind = ItemKind::node,
    .name = "NodeRigidBodyEP",
    .type_name = "RigidBodyEP",
    .category = "",
    .short_names = node_rigid_body_ep::short_names,
    .provides = node_rigid_body_ep::provides,
    .rows = node_rigid_body_ep::rows,
    .outputs = node_rigid_body_ep::outputs,
    .record = record_operations<node_rigid_body_ep::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_rigid_body_ep::physics,
    .spec = "specs/nodes/rigid_body_ep.toml",
};

}  // namespace dalembert
