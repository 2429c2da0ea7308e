// Generated from specs/connectors/spring_damper.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/spring_damper_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/spring_damper.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_spring_damper {

using Record = ObjectConnectorSpringDamperRecord;

constexpr std::array<Signature::Kind, 5> springForceUserFunction_arguments{
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature springForceUserFunction_signature{.arguments = springForceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<springForceUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<Row, 12> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "referenceLength", .storage = Storage::real, .offset = offsetof(Record, parameters.referenceLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "stiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.stiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N/m"},
    {.name = "damping", .storage = Storage::real, .offset = offsetof(Record, parameters.damping), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns/m"},
    {.name = "force", .storage = Storage::real, .offset = offsetof(Record, parameters.force), .role = Role::parameter, .unit = "N"},
    {.name = "velocityOffset", .storage = Storage::real, .offset = offsetof(Record, parameters.velocityOffset), .role = Role::parameter, .unit = "m/s"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "springForceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.springForceUserFunction), .role = Role::parameter, .signature = &springForceUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"SpringDamper"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 6> outputs{
    OutputVariableType::Distance,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Force,
    OutputVariableType::ForceLocal,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = ConnectorPhysics<ObjectConnectorSpringDamper, ObjectConnectorSpringDamperRecord>{};

}  // namespace object_connector_spring_damper

extern const ItemType object_connector_spring_damper_type;
const ItemType object_connector_spring_damper_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorSpringDamper",
    .type_name = "ConnectorSpringDamper",
    .category = "Connector",
    .short_names = object_connector_spring_damper::short_names,
    .provides = object_connector_spring_damper::provides,
    .rows = object_connector_spring_damper::rows,
    .outputs = object_connector_spring_damper::outputs,
    .record = record_operations<object_connector_spring_damper::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position,
    .physics = &object_connector_spring_damper::physics,
    .spec = "specs/connectors/spring_damper.toml",
};

}  // namespace dalembert
