// Generated from specs/connectors/rolling_disc_penalty.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/rolling_disc_penalty_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/rolling_disc_penalty.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_rolling_disc_penalty {

using Record = ObjectConnectorRollingDiscPenaltyRecord;

constexpr std::array<std::string_view, 1> rollingFrictionViscous_aliases{"rollingViscousFriction"};

constexpr std::array<Row, 18> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "discRadius", .storage = Storage::real, .offset = offsetof(Record, parameters.discRadius), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "discAxis", .storage = Storage::vector3, .offset = offsetof(Record, parameters.discAxis), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "planeNormal", .storage = Storage::vector3, .offset = offsetof(Record, parameters.planeNormal), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "dryFrictionAngle", .storage = Storage::real, .offset = offsetof(Record, parameters.dryFrictionAngle), .role = Role::parameter, .unit = "rad"},
    {.name = "contactStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N/m"},
    {.name = "contactDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.contactDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns/m"},
    {.name = "dryFriction", .storage = Storage::vector2, .offset = offsetof(Record, parameters.dryFriction), .role = Role::parameter, .unit = "1"},
    {.name = "dryFrictionProportionalZone", .storage = Storage::real, .offset = offsetof(Record, parameters.dryFrictionProportionalZone), .role = Role::parameter, .unit = "m/s"},
    {.name = "viscousFriction", .storage = Storage::vector2, .offset = offsetof(Record, parameters.viscousFriction), .role = Role::parameter, .unit = "s/m"},
    {.name = "rollingFrictionViscous", .storage = Storage::real, .offset = offsetof(Record, parameters.rollingFrictionViscous), .role = Role::parameter, .unit = "s/m", .aliases = rollingFrictionViscous_aliases},
    {.name = "useLinearProportionalZone", .storage = Storage::boolean, .offset = offsetof(Record, parameters.useLinearProportionalZone), .role = Role::parameter},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "discWidth", .storage = Storage::real, .offset = offsetof(Record, visualization.discWidth), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"RollingDiscPenalty"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 5> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::VelocityLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::RotationMatrix,
};

const auto& physics = ConnectorPhysics<ObjectConnectorRollingDiscPenalty, ObjectConnectorRollingDiscPenaltyRecord>{};

}  // namespace object_connector_rolling_disc_penalty

extern const ItemType object_connector_rolling_disc_penalty_type;
const ItemType object_connector_rolling_disc_penalty_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorRollingDiscPenalty",
    .type_name = "ConnectorRollingDiscPenalty",
    .category = "Connector",
    .short_names = object_connector_rolling_disc_penalty::short_names,
    .provides = object_connector_rolling_disc_penalty::provides,
    .rows = object_connector_rolling_disc_penalty::rows,
    .outputs = object_connector_rolling_disc_penalty::outputs,
    .record = record_operations<object_connector_rolling_disc_penalty::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_connector_rolling_disc_penalty::physics,
    .spec = "specs/connectors/rolling_disc_penalty.toml",
};

}  // namespace dalembert
