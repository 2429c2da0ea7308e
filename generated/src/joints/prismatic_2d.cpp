// Generated from specs/joints/prismatic_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/joints/prismatic_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/joints/prismatic_2d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_joint_prismatic_2d {

using Record = ObjectJointPrismatic2DRecord;

constexpr std::array<Row, 9> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "axisMarker0", .storage = Storage::vector3, .offset = offsetof(Record, parameters.axisMarker0), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "normalMarker1", .storage = Storage::vector3, .offset = offsetof(Record, parameters.normalMarker1), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "constrainRotation", .storage = Storage::boolean, .offset = offsetof(Record, parameters.constrainRotation), .role = Role::parameter},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"PrismaticJoint2D"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 8> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::DisplacementLocal,
    OutputVariableType::Distance,
    OutputVariableType::Rotation,
    OutputVariableType::ForceLocal,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::HomogeneousTransformationLocal,
};

const auto& physics = ConstraintPhysics<ObjectJointPrismatic2D, ObjectJointPrismatic2DRecord>{};

}  // namespace object_joint_prismatic_2d

extern const ItemType object_joint_prismatic_2d_type;
const ItemType object_joint_prismatic_2d_type{
    .kind = ItemKind::object,
    .name = "ObjectJointPrismatic2D",
    .type_name = "JointPrismatic2D",
    .category = "Joint",
    .short_names = object_joint_prismatic_2d::short_names,
    .provides = object_joint_prismatic_2d::provides,
    .rows = object_joint_prismatic_2d::rows,
    .outputs = object_joint_prismatic_2d::outputs,
    .record = record_operations<object_joint_prismatic_2d::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_joint_prismatic_2d::physics,
    .spec = "specs/joints/prismatic_2d.toml",
};

}  // namespace dalembert
