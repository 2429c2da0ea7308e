// Generated from specs/joints/prismatic_x.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/joints/prismatic_x_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/joints/prismatic_x.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_joint_prismatic_x {

using Record = ObjectJointPrismaticXRecord;

constexpr std::array<Row, 9> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "rotationMarker0", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker0), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "rotationMarker1", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker1), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "axisRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.axisRadius), .role = Role::visualization, .unit = "m"},
    {.name = "axisLength", .storage = Storage::real, .offset = offsetof(Record, visualization.axisLength), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"PrismaticJointX"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 10> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::DisplacementLocal,
    OutputVariableType::VelocityLocal,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::HomogeneousTransformationLocal,
};

const auto& physics = ConstraintPhysics<ObjectJointPrismaticX, ObjectJointPrismaticXRecord>{};

}  // namespace object_joint_prismatic_x

extern const ItemType object_joint_prismatic_x_type;
const ItemType object_joint_prismatic_x_type{
    .kind = ItemKind::object,
    .name = "ObjectJointPrismaticX",
    .type_name = "JointPrismaticX",
    .category = "Joint",
    .short_names = object_joint_prismatic_x::short_names,
    .provides = object_joint_prismatic_x::provides,
    .rows = object_joint_prismatic_x::rows,
    .outputs = object_joint_prismatic_x::outputs,
    .record = record_operations<object_joint_prismatic_x::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_joint_prismatic_x::physics,
    .spec = "specs/joints/prismatic_x.toml",
};

}  // namespace dalembert
