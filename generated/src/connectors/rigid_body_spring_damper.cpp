// Generated from specs/connectors/rigid_body_spring_damper.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/rigid_body_spring_damper_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/rigid_body_spring_damper.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_rigid_body_spring_damper {

using Record = ObjectConnectorRigidBodySpringDamperRecord;

constexpr std::array<Signature::Kind, 9> springForceTorqueUserFunction_arguments{
    Signature::Kind::vector,
    Signature::Kind::vector,
    Signature::Kind::vector,
    Signature::Kind::vector,
    Signature::Kind::matrix,
    Signature::Kind::matrix,
    Signature::Kind::matrix,
    Signature::Kind::matrix,
    Signature::Kind::vector,
};
constexpr Signature springForceTorqueUserFunction_signature{.arguments = springForceTorqueUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::vector, .compiled = &compiled_call<springForceTorqueUserFunction_arguments, true, true, Signature::Kind::vector>};

constexpr std::array<Signature::Kind, 10> postNewtonStepUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::vector,
    Signature::Kind::vector,
    Signature::Kind::vector,
    Signature::Kind::vector,
    Signature::Kind::matrix,
    Signature::Kind::matrix,
    Signature::Kind::matrix,
    Signature::Kind::matrix,
    Signature::Kind::vector,
};
constexpr Signature postNewtonStepUserFunction_signature{.arguments = postNewtonStepUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<postNewtonStepUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<std::string_view, 1> intrinsicFormulation_aliases{"useIntrinsicFormulation"};

constexpr std::array<Row, 15> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .optional = true, .needs_assemble = true},
    {.name = "stiffness", .storage = Storage::matrix6, .offset = offsetof(Record, parameters.stiffness), .role = Role::parameter, .unit = "various"},
    {.name = "damping", .storage = Storage::matrix6, .offset = offsetof(Record, parameters.damping), .role = Role::parameter, .unit = "various"},
    {.name = "rotationMarker0", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker0), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "rotationMarker1", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker1), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "offset", .storage = Storage::vector6, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "various"},
    {.name = "intrinsicFormulation", .storage = Storage::boolean, .offset = offsetof(Record, parameters.intrinsicFormulation), .role = Role::parameter, .aliases = intrinsicFormulation_aliases},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "springForceTorqueUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.springForceTorqueUserFunction), .role = Role::parameter, .signature = &springForceTorqueUserFunction_signature},
    {.name = "postNewtonStepUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.postNewtonStepUserFunction), .role = Role::parameter, .signature = &postNewtonStepUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"RigidBodySpringDamper"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 9> outputs{
    OutputVariableType::DisplacementLocal,
    OutputVariableType::VelocityLocal,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::PotentialEnergy,
    OutputVariableType::HomogeneousTransformationLocal,
    OutputVariableType::Displacement,
};

const auto& physics = ConnectorPhysics<ObjectConnectorRigidBodySpringDamper, ObjectConnectorRigidBodySpringDamperRecord>{};

}  // namespace object_connector_rigid_body_spring_damper

extern const ItemType object_connector_rigid_body_spring_damper_type;
const ItemType object_connector_rigid_body_spring_damper_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorRigidBodySpringDamper",
    .type_name = "ConnectorRigidBodySpringDamper",
    .category = "Connector",
    .short_names = object_connector_rigid_body_spring_damper::short_names,
    .provides = object_connector_rigid_body_spring_damper::provides,
    .rows = object_connector_rigid_body_spring_damper::rows,
    .outputs = object_connector_rigid_body_spring_damper::outputs,
    .record = record_operations<object_connector_rigid_body_spring_damper::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_connector_rigid_body_spring_damper::physics,
    .spec = "specs/connectors/rigid_body_spring_damper.toml",
};

}  // namespace dalembert
