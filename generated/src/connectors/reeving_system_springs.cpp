// Generated from specs/connectors/reeving_system_springs.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/reeving_system_springs_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/reeving_system_springs.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_reeving_system_springs {

using Record = ObjectConnectorReevingSystemSpringsRecord;

constexpr std::array<Row, 17> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "hasCoordinateMarkers", .storage = Storage::boolean, .offset = offsetof(Record, parameters.hasCoordinateMarkers), .role = Role::parameter},
    {.name = "turningEnds", .storage = Storage::boolean, .offset = offsetof(Record, parameters.turningEnds), .role = Role::parameter},
    {.name = "coordinateFactors", .storage = Storage::vector2, .offset = offsetof(Record, parameters.coordinateFactors), .role = Role::parameter, .unit = "various"},
    {.name = "stiffnessPerLength", .storage = Storage::real, .offset = offsetof(Record, parameters.stiffnessPerLength), .role = Role::parameter, .check = Check::non_negative, .unit = "N"},
    {.name = "dampingPerLength", .storage = Storage::real, .offset = offsetof(Record, parameters.dampingPerLength), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns"},
    {.name = "dampingTorsional", .storage = Storage::real, .offset = offsetof(Record, parameters.dampingTorsional), .role = Role::parameter, .check = Check::non_negative, .unit = "Nms"},
    {.name = "dampingShear", .storage = Storage::real, .offset = offsetof(Record, parameters.dampingShear), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns"},
    {.name = "regularizationForce", .storage = Storage::real, .offset = offsetof(Record, parameters.regularizationForce), .role = Role::parameter, .unit = "N"},
    {.name = "referenceLength", .storage = Storage::real, .offset = offsetof(Record, parameters.referenceLength), .role = Role::parameter, .unit = "m"},
    {.name = "sheavesAxes", .storage = Storage::vector3s, .offset = offsetof(Record, parameters.sheavesAxes), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "sheavesRadii", .storage = Storage::vector, .offset = offsetof(Record, parameters.sheavesRadii), .role = Role::parameter, .unit = "m"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "ropeRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.ropeRadius), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"ReevingSystemSprings"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 3> outputs{
    OutputVariableType::Distance,
    OutputVariableType::VelocityLocal,
    OutputVariableType::ForceLocal,
};

const auto& physics = ConnectorPhysics<ObjectConnectorReevingSystemSprings, ObjectConnectorReevingSystemSpringsRecord>{};

}  // namespace object_connector_reeving_system_springs

extern const ItemType object_connector_reeving_system_springs_type;
const ItemType object_connector_reeving_system_springs_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorReevingSystemSprings",
    .type_name = "ConnectorReevingSystemSprings",
    .category = "Connector",
    .short_names = object_connector_reeving_system_springs::short_names,
    .provides = object_connector_reeving_system_springs::provides,
    .rows = object_connector_reeving_system_springs::rows,
    .outputs = object_connector_reeving_system_springs::outputs,
    .record = record_operations<object_connector_reeving_system_springs::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_connector_reeving_system_springs::physics,
    .spec = "specs/connectors/reeving_system_springs.toml",
};

}  // namespace dalembert
