// Generated from specs/connectors/linear_spring_damper.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/linear_spring_damper_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/linear_spring_damper.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_linear_spring_damper {

using Record = ObjectConnectorLinearSpringDamperRecord;

constexpr std::array<Signature::Kind, 5> springForceUserFunction_arguments{
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature springForceUserFunction_signature{.arguments = springForceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<springForceUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<Row, 14> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "stiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.stiffness), .role = Role::parameter, .unit = "N/m"},
    {.name = "damping", .storage = Storage::real, .offset = offsetof(Record, parameters.damping), .role = Role::parameter, .unit = "Ns/m"},
    {.name = "axisMarker0", .storage = Storage::vector3, .offset = offsetof(Record, parameters.axisMarker0), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "offset", .storage = Storage::real, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "m"},
    {.name = "velocityOffset", .storage = Storage::real, .offset = offsetof(Record, parameters.velocityOffset), .role = Role::parameter, .unit = "m/s"},
    {.name = "force", .storage = Storage::real, .offset = offsetof(Record, parameters.force), .role = Role::parameter, .unit = "N"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "springForceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.springForceUserFunction), .role = Role::parameter, .signature = &springForceUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "drawAsCylinder", .storage = Storage::boolean, .offset = offsetof(Record, visualization.drawAsCylinder), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"LinearSpringDamper"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 6> outputs{
    OutputVariableType::DisplacementLocal,
    OutputVariableType::VelocityLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::PotentialEnergy,
    OutputVariableType::HomogeneousTransformationLocal,
    OutputVariableType::Displacement,
};

const auto& physics = ConnectorPhysics<ObjectConnectorLinearSpringDamper, ObjectConnectorLinearSpringDamperRecord>{};

}  // namespace object_connector_linear_spring_damper

extern const ItemType object_connector_linear_spring_damper_type;
const ItemType object_connector_linear_spring_damper_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorLinearSpringDamper",
    .type_name = "ConnectorLinearSpringDamper",
    .category = "Connector",
    .short_names = object_connector_linear_spring_damper::short_names,
    .provides = object_connector_linear_spring_damper::provides,
    .rows = object_connector_linear_spring_damper::rows,
    .outputs = object_connector_linear_spring_damper::outputs,
    .record = record_operations<object_connector_linear_spring_damper::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_connector_linear_spring_damper::physics,
    .spec = "specs/connectors/linear_spring_damper.toml",
};

}  // namespace dalembert
