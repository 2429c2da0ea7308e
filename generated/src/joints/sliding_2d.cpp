// Generated from specs/joints/sliding_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/joints/sliding_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/joints/sliding_2d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_joint_sliding_2d {

using Record = ObjectJointSliding2DRecord;

constexpr std::array<std::string_view, 1> classicalFormulation_aliases{"useClassicalFormulation"};

constexpr std::array<Row, 12> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "slidingMarkerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.slidingMarkerNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "slidingMarkerOffsets", .storage = Storage::vector, .offset = offsetof(Record, parameters.slidingMarkerOffsets), .role = Role::parameter, .unit = "m"},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "classicalFormulation", .storage = Storage::boolean, .offset = offsetof(Record, parameters.classicalFormulation), .role = Role::parameter, .aliases = classicalFormulation_aliases},
    {.name = "constrainRotation", .storage = Storage::boolean, .offset = offsetof(Record, parameters.constrainRotation), .role = Role::parameter, .needs_assemble = true},
    {.name = "axialForce", .storage = Storage::real, .offset = offsetof(Record, parameters.axialForce), .role = Role::parameter, .unit = "N"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"SlidingJoint2D"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 5> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::SlidingCoordinate,
    OutputVariableType::Force,
    OutputVariableType::DisplacementLocal,
};

const auto& physics = ConstraintPhysics<ObjectJointSliding2D, ObjectJointSliding2DRecord>{};

}  // namespace object_joint_sliding_2d

extern const ItemType object_joint_sliding_2d_type;
const ItemType object_joint_sliding_2d_type{
    .kind = ItemKind::object,
    .name = "ObjectJointSliding2D",
    .type_name = "JointSliding2D",
    .category = "Joint",
    .short_names = object_joint_sliding_2d::short_names,
    .provides = object_joint_sliding_2d::provides,
    .rows = object_joint_sliding_2d::rows,
    .outputs = object_joint_sliding_2d::outputs,
    .record = record_operations<object_joint_sliding_2d::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::none,
    .physics = &object_joint_sliding_2d::physics,
    .spec = "specs/joints/sliding_2d.toml",
};

}  // namespace dalembert
