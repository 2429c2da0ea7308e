// Generated from specs/joints/spherical.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/joints/spherical_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/joints/spherical.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_joint_spherical {

using Record = ObjectJointSphericalRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "constrainedAxes", .storage = Storage::integers, .offset = offsetof(Record, parameters.constrainedAxes), .role = Role::parameter, .size = 3},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "jointRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.jointRadius), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"SphericalJoint"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::Displacement,
    OutputVariableType::Force,
};

const auto& physics = ConstraintPhysics<ObjectJointSpherical, ObjectJointSphericalRecord>{};

}  // namespace object_joint_spherical

extern const ItemType object_joint_spherical_type;
const ItemType object_joint_spherical_type{
    .kind = ItemKind::object,
    .name = "ObjectJointSpherical",
    .type_name = "JointSpherical",
    .category = "Joint",
    .short_names = object_joint_spherical::short_names,
    .provides = object_joint_spherical::provides,
    .rows = object_joint_spherical::rows,
    .outputs = object_joint_spherical::outputs,
    .record = record_operations<object_joint_spherical::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position,
    .physics = &object_joint_spherical::physics,
    .spec = "specs/joints/spherical.toml",
};

}  // namespace dalembert
