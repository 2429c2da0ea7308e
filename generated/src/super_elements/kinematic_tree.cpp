// Generated from specs/super_elements/kinematic_tree.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/super_elements/kinematic_tree_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// By hand: its recursions over links take the place of a residual that is differentiated
const Physics& object_kinematic_tree_physics();

// Named, for several of these files may be compiled at once.
namespace object_kinematic_tree {

using Record = ObjectKinematicTreeRecord;

constexpr std::array<Signature::Kind, 2> forceUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
};
constexpr Signature forceUserFunction_signature{.arguments = forceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<forceUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Row, 26> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "gravity", .storage = Storage::vector3, .offset = offsetof(Record, parameters.gravity), .role = Role::parameter, .unit = "m/s^2"},
    {.name = "baseOffset", .storage = Storage::vector3, .offset = offsetof(Record, parameters.baseOffset), .role = Role::parameter, .unit = "m"},
    {.name = "jointTypes", .storage = Storage::joint_types, .offset = offsetof(Record, parameters.jointTypes), .role = Role::parameter},
    {.name = "linkParents", .storage = Storage::integers, .offset = offsetof(Record, parameters.linkParents), .role = Role::parameter, .needs_assemble = true},
    {.name = "jointTransformations", .storage = Storage::matrix3s, .offset = offsetof(Record, parameters.jointTransformations), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "jointOffsets", .storage = Storage::vector3s, .offset = offsetof(Record, parameters.jointOffsets), .role = Role::parameter, .unit = "m"},
    {.name = "linkInertiasCOM", .storage = Storage::matrix3s, .offset = offsetof(Record, parameters.linkInertiasCOM), .role = Role::parameter, .unit = "kg m^2"},
    {.name = "linkCOMs", .storage = Storage::vector3s, .offset = offsetof(Record, parameters.linkCOMs), .role = Role::parameter, .unit = "m"},
    {.name = "linkMasses", .storage = Storage::vector, .offset = offsetof(Record, parameters.linkMasses), .role = Role::parameter, .unit = "kg"},
    {.name = "linkForces", .storage = Storage::vector3s, .offset = offsetof(Record, parameters.linkForces), .role = Role::parameter, .unit = "N"},
    {.name = "linkTorques", .storage = Storage::vector3s, .offset = offsetof(Record, parameters.linkTorques), .role = Role::parameter, .unit = "Nm"},
    {.name = "jointForceVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.jointForceVector), .role = Role::parameter, .unit = "various"},
    {.name = "jointPositionOffsetVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.jointPositionOffsetVector), .role = Role::parameter, .unit = "various"},
    {.name = "jointVelocityOffsetVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.jointVelocityOffsetVector), .role = Role::parameter, .unit = "various"},
    {.name = "jointPControlVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.jointPControlVector), .role = Role::parameter, .unit = "various"},
    {.name = "jointDControlVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.jointDControlVector), .role = Role::parameter, .unit = "various"},
    {.name = "forceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.forceUserFunction), .role = Role::parameter, .signature = &forceUserFunction_signature},
    {.name = "linkNames", .storage = Storage::texts, .offset = offsetof(Record, parameters.linkNames), .role = Role::parameter},
    {.name = "jointNames", .storage = Storage::texts, .offset = offsetof(Record, parameters.jointNames), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "showLinks", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showLinks), .role = Role::visualization},
    {.name = "showJoints", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showJoints), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
    {.name = "graphicsDataList", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsDataList), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"KinematicTree"};
constexpr std::array<std::string_view, 3> provides{"Body", "MultiNoded", "SuperElement"};
constexpr std::array<OutputVariableType, 6> outputs{
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Coordinates_tt,
    OutputVariableType::Force,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = object_kinematic_tree_physics();

}  // namespace object_kinematic_tree

extern const ItemType object_kinematic_tree_type;
const ItemType object_kinematic_tree_type{
    .kind = ItemKind::object,
    .name = "ObjectKinematicTree",
    .type_name = "KinematicTree",
    .category = "SuperElement",
    .short_names = object_kinematic_tree::short_names,
    .provides = object_kinematic_tree::provides,
    .rows = object_kinematic_tree::rows,
    .outputs = object_kinematic_tree::outputs,
    .record = record_operations<object_kinematic_tree::Record>(),
    .requested_node = Capability::generic_ode2,
    .requested_marker = Capability::none,
    .physics = &object_kinematic_tree::physics,
    .spec = "specs/super_elements/kinematic_tree.toml",
};

}  // namespace dalembert
