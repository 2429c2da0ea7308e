// Generated from specs/joints/generic.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/joints/generic_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/joints/generic.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_joint_generic {

using Record = ObjectJointGenericRecord;

constexpr std::array<Signature::Kind, 1> offsetUserFunction_arguments{
    Signature::Kind::vector,
};
constexpr Signature offsetUserFunction_signature{.arguments = offsetUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::vector, .compiled = &compiled_call<offsetUserFunction_arguments, true, true, Signature::Kind::vector>};

constexpr std::array<Signature::Kind, 1> offsetUserFunction_t_arguments{
    Signature::Kind::vector,
};
constexpr Signature offsetUserFunction_t_signature{.arguments = offsetUserFunction_t_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::vector, .compiled = &compiled_call<offsetUserFunction_t_arguments, true, true, Signature::Kind::vector>};

constexpr std::array<Row, 14> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "constrainedAxes", .storage = Storage::integers, .offset = offsetof(Record, parameters.constrainedAxes), .role = Role::parameter, .size = 6},
    {.name = "rotationMarker0", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker0), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "rotationMarker1", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker1), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "offsetUserFunctionParameters", .storage = Storage::vector6, .offset = offsetof(Record, parameters.offsetUserFunctionParameters), .role = Role::parameter, .unit = "various"},
    {.name = "offsetUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.offsetUserFunction), .role = Role::parameter, .signature = &offsetUserFunction_signature},
    {.name = "offsetUserFunction_t", .storage = Storage::user_function, .offset = offsetof(Record, parameters.offsetUserFunction_t), .role = Role::parameter, .signature = &offsetUserFunction_t_signature},
    {.name = "alternativeConstraints", .storage = Storage::boolean, .offset = offsetof(Record, parameters.alternativeConstraints), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "axesRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.axesRadius), .role = Role::visualization, .unit = "m"},
    {.name = "axesLength", .storage = Storage::real, .offset = offsetof(Record, visualization.axesLength), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"GenericJoint"};
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

const auto& physics = ConstraintPhysics<ObjectJointGeneric, ObjectJointGenericRecord>{};

}  // namespace object_joint_generic

extern const ItemType object_joint_generic_type;
const ItemType object_joint_generic_type{
    .kind = ItemKind::object,
    .name = "ObjectJointGeneric",
    .type_name = "JointGeneric",
    .category = "Joint",
    .short_names = object_joint_generic::short_names,
    .provides = object_joint_generic::provides,
    .rows = object_joint_generic::rows,
    .outputs = object_joint_generic::outputs,
    .record = record_operations<object_joint_generic::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_joint_generic::physics,
    .spec = "specs/joints/generic.toml",
};

}  // namespace dalembert
