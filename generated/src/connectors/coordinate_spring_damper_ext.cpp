// Generated from specs/connectors/coordinate_spring_damper_ext.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/coordinate_spring_damper_ext_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/coordinate_spring_damper_ext.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_coordinate_spring_damper_ext {

using Record = ObjectConnectorCoordinateSpringDamperExtRecord;

constexpr std::array<Signature::Kind, 11> springForceUserFunction_arguments{
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature springForceUserFunction_signature{.arguments = springForceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<springForceUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<std::string_view, 1> fDynamicFriction_aliases{"dynamicFrictionForce"};

constexpr std::array<std::string_view, 1> fStaticFrictionOffset_aliases{"staticFrictionOffsetForce"};

constexpr std::array<std::string_view, 1> fViscousFriction_aliases{"viscousFrictionFactor"};

constexpr std::array<Row, 26> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "stiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.stiffness), .role = Role::parameter, .unit = "various"},
    {.name = "damping", .storage = Storage::real, .offset = offsetof(Record, parameters.damping), .role = Role::parameter, .unit = "various"},
    {.name = "offset", .storage = Storage::real, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "various"},
    {.name = "velocityOffset", .storage = Storage::real, .offset = offsetof(Record, parameters.velocityOffset), .role = Role::parameter, .unit = "various"},
    {.name = "factor0", .storage = Storage::real, .offset = offsetof(Record, parameters.factor0), .role = Role::parameter, .unit = "1"},
    {.name = "factor1", .storage = Storage::real, .offset = offsetof(Record, parameters.factor1), .role = Role::parameter, .unit = "1"},
    {.name = "fDynamicFriction", .storage = Storage::real, .offset = offsetof(Record, parameters.fDynamicFriction), .role = Role::parameter, .check = Check::non_negative, .unit = "various", .aliases = fDynamicFriction_aliases},
    {.name = "fStaticFrictionOffset", .storage = Storage::real, .offset = offsetof(Record, parameters.fStaticFrictionOffset), .role = Role::parameter, .check = Check::non_negative, .unit = "various", .aliases = fStaticFrictionOffset_aliases},
    {.name = "stickingStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.stickingStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "stickingDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.stickingDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "exponentialDecayStatic", .storage = Storage::real, .offset = offsetof(Record, parameters.exponentialDecayStatic), .role = Role::parameter, .check = Check::positive, .unit = "various"},
    {.name = "fViscousFriction", .storage = Storage::real, .offset = offsetof(Record, parameters.fViscousFriction), .role = Role::parameter, .unit = "various", .aliases = fViscousFriction_aliases},
    {.name = "frictionProportionalZone", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionProportionalZone), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "limitStopsUpper", .storage = Storage::real, .offset = offsetof(Record, parameters.limitStopsUpper), .role = Role::parameter, .unit = "various"},
    {.name = "limitStopsLower", .storage = Storage::real, .offset = offsetof(Record, parameters.limitStopsLower), .role = Role::parameter, .unit = "various"},
    {.name = "limitStopsStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.limitStopsStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "limitStopsDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.limitStopsDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "useLimitStops", .storage = Storage::boolean, .offset = offsetof(Record, parameters.useLimitStops), .role = Role::parameter},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "springForceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.springForceUserFunction), .role = Role::parameter, .signature = &springForceUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"CoordinateSpringDamperExt"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 3> outputs{
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Force,
};

const auto& physics = ConnectorPhysics<ObjectConnectorCoordinateSpringDamperExt, ObjectConnectorCoordinateSpringDamperExtRecord>{};

}  // namespace object_connector_coordinate_spring_damper_ext

extern const ItemType object_connector_coordinate_spring_damper_ext_type;
const ItemType object_connector_coordinate_spring_damper_ext_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorCoordinateSpringDamperExt",
    .type_name = "ConnectorCoordinateSpringDamperExt",
    .category = "Connector",
    .short_names = object_connector_coordinate_spring_damper_ext::short_names,
    .provides = object_connector_coordinate_spring_damper_ext::provides,
    .rows = object_connector_coordinate_spring_damper_ext::rows,
    .outputs = object_connector_coordinate_spring_damper_ext::outputs,
    .record = record_operations<object_connector_coordinate_spring_damper_ext::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::coordinate,
    .physics = &object_connector_coordinate_spring_damper_ext::physics,
    .spec = "specs/connectors/coordinate_spring_damper_ext.toml",
};

}  // namespace dalembert
