// Generated from specs/joints/rolling_disc.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/joints/rolling_disc_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/joints/rolling_disc.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_joint_rolling_disc {

using Record = ObjectJointRollingDiscRecord;

constexpr std::array<Row, 10> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "constrainedAxes", .storage = Storage::integers, .offset = offsetof(Record, parameters.constrainedAxes), .role = Role::parameter, .size = 3},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "discRadius", .storage = Storage::real, .offset = offsetof(Record, parameters.discRadius), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "discAxis", .storage = Storage::vector3, .offset = offsetof(Record, parameters.discAxis), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "planeNormal", .storage = Storage::vector3, .offset = offsetof(Record, parameters.planeNormal), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "discWidth", .storage = Storage::real, .offset = offsetof(Record, visualization.discWidth), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"RollingDiscJoint"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::ForceLocal,
    OutputVariableType::RotationMatrix,
};

const auto& physics = ConstraintPhysics<ObjectJointRollingDisc, ObjectJointRollingDiscRecord>{};

}  // namespace object_joint_rolling_disc

extern const ItemType object_joint_rolling_disc_type;
const ItemType object_joint_rolling_disc_type{
    .kind = ItemKind::object,
    .name = "ObjectJointRollingDisc",
    .type_name = "JointRollingDisc",
    .category = "Joint",
    .short_names = object_joint_rolling_disc::short_names,
    .provides = object_joint_rolling_disc::provides,
    .rows = object_joint_rolling_disc::rows,
    .outputs = object_joint_rolling_disc::outputs,
    .record = record_operations<object_joint_rolling_disc::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_joint_rolling_disc::physics,
    .spec = "specs/joints/rolling_disc.toml",
};

}  // namespace dalembert
