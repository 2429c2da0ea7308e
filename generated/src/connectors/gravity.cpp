// Generated from specs/connectors/gravity.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/gravity_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/gravity.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_gravity {

using Record = ObjectConnectorGravityRecord;

constexpr std::array<Row, 10> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "gravitationalConstant", .storage = Storage::real, .offset = offsetof(Record, parameters.gravitationalConstant), .role = Role::parameter, .unit = "m^3/(kg s^2)"},
    {.name = "mass0", .storage = Storage::real, .offset = offsetof(Record, parameters.mass0), .role = Role::parameter, .check = Check::non_negative, .unit = "kg"},
    {.name = "mass1", .storage = Storage::real, .offset = offsetof(Record, parameters.mass1), .role = Role::parameter, .check = Check::non_negative, .unit = "kg"},
    {.name = "minDistanceRegularization", .storage = Storage::real, .offset = offsetof(Record, parameters.minDistanceRegularization), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"ConnectorGravity"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Distance,
    OutputVariableType::Displacement,
    OutputVariableType::Force,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = ConnectorPhysics<ObjectConnectorGravity, ObjectConnectorGravityRecord>{};

}  // namespace object_connector_gravity

extern const ItemType object_connector_gravity_type;
const ItemType object_connector_gravity_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorGravity",
    .type_name = "ConnectorGravity",
    .category = "Connector",
    .short_names = object_connector_gravity::short_names,
    .provides = object_connector_gravity::provides,
    .rows = object_connector_gravity::rows,
    .outputs = object_connector_gravity::outputs,
    .record = record_operations<object_connector_gravity::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position,
    .physics = &object_connector_gravity::physics,
    .spec = "specs/connectors/gravity.toml",
};

}  // namespace dalembert
