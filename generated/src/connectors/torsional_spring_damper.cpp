// Generated from specs/connectors/torsional_spring_damper.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/torsional_spring_damper_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/torsional_spring_damper.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_torsional_spring_damper {

using Record = ObjectConnectorTorsionalSpringDamperRecord;

constexpr std::array<Signature::Kind, 5> springTorqueUserFunction_arguments{
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature springTorqueUserFunction_signature{.arguments = springTorqueUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<springTorqueUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<Row, 15> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .optional = true, .needs_assemble = true},
    {.name = "stiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.stiffness), .role = Role::parameter, .unit = "Nm/rad"},
    {.name = "damping", .storage = Storage::real, .offset = offsetof(Record, parameters.damping), .role = Role::parameter, .unit = "Nms/rad"},
    {.name = "rotationMarker0", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker0), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "rotationMarker1", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker1), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "offset", .storage = Storage::real, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "rad"},
    {.name = "velocityOffset", .storage = Storage::real, .offset = offsetof(Record, parameters.velocityOffset), .role = Role::parameter, .unit = "rad/s"},
    {.name = "torque", .storage = Storage::real, .offset = offsetof(Record, parameters.torque), .role = Role::parameter, .unit = "Nm"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "springTorqueUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.springTorqueUserFunction), .role = Role::parameter, .signature = &springTorqueUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"TorsionalSpringDamper"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = ConnectorPhysics<ObjectConnectorTorsionalSpringDamper, ObjectConnectorTorsionalSpringDamperRecord>{};

}  // namespace object_connector_torsional_spring_damper

extern const ItemType object_connector_torsional_spring_damper_type;
const ItemType object_connector_torsional_spring_damper_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorTorsionalSpringDamper",
    .type_name = "ConnectorTorsionalSpringDamper",
    .category = "Connector",
    .short_names = object_connector_torsional_spring_damper::short_names,
    .provides = object_connector_torsional_spring_damper::provides,
    .rows = object_connector_torsional_spring_damper::rows,
    .outputs = object_connector_torsional_spring_damper::outputs,
    .record = record_operations<object_connector_torsional_spring_damper::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::orientation,
    .physics = &object_connector_torsional_spring_damper::physics,
    .spec = "specs/connectors/torsional_spring_damper.toml",
};

}  // namespace dalembert
