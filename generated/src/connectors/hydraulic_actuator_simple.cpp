// Generated from specs/connectors/hydraulic_actuator_simple.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/hydraulic_actuator_simple_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

namespace {

using Record = ObjectConnectorHydraulicActuatorSimpleRecord;

constexpr std::array<Row, 30> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "offsetLength", .storage = Storage::real, .offset = offsetof(Record, parameters.offsetLength), .role = Role::parameter, .check = Check::non_negative},
    {.name = "strokeLength", .storage = Storage::real, .offset = offsetof(Record, parameters.strokeLength), .role = Role::parameter, .check = Check::positive},
    {.name = "chamberCrossSection0", .storage = Storage::real, .offset = offsetof(Record, parameters.chamberCrossSection0), .role = Role::parameter, .check = Check::positive},
    {.name = "chamberCrossSection1", .storage = Storage::real, .offset = offsetof(Record, parameters.chamberCrossSection1), .role = Role::parameter, .check = Check::positive},
    {.name = "hoseVolume0", .storage = Storage::real, .offset = offsetof(Record, parameters.hoseVolume0), .role = Role::parameter, .check = Check::positive},
    {.name = "hoseVolume1", .storage = Storage::real, .offset = offsetof(Record, parameters.hoseVolume1), .role = Role::parameter, .check = Check::positive},
    {.name = "valveOpening0", .storage = Storage::real, .offset = offsetof(Record, parameters.valveOpening0), .role = Role::parameter},
    {.name = "valveOpening1", .storage = Storage::real, .offset = offsetof(Record, parameters.valveOpening1), .role = Role::parameter},
    {.name = "actuatorDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.actuatorDamping), .role = Role::parameter, .check = Check::non_negative},
    {.name = "oilBulkModulus", .storage = Storage::real, .offset = offsetof(Record, parameters.oilBulkModulus), .role = Role::parameter, .check = Check::positive},
    {.name = "cylinderBulkModulus", .storage = Storage::real, .offset = offsetof(Record, parameters.cylinderBulkModulus), .role = Role::parameter, .check = Check::non_negative},
    {.name = "hoseBulkModulus", .storage = Storage::real, .offset = offsetof(Record, parameters.hoseBulkModulus), .role = Role::parameter, .check = Check::non_negative},
    {.name = "nominalFlow", .storage = Storage::real, .offset = offsetof(Record, parameters.nominalFlow), .role = Role::parameter, .check = Check::positive},
    {.name = "systemPressure", .storage = Storage::real, .offset = offsetof(Record, parameters.systemPressure), .role = Role::parameter},
    {.name = "tankPressure", .storage = Storage::real, .offset = offsetof(Record, parameters.tankPressure), .role = Role::parameter},
    {.name = "useChamberVolumeChange", .storage = Storage::boolean, .offset = offsetof(Record, parameters.useChamberVolumeChange), .role = Role::parameter},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "cylinderRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.cylinderRadius), .role = Role::visualization},
    {.name = "rodRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.rodRadius), .role = Role::visualization},
    {.name = "pistonRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.pistonRadius), .role = Role::visualization},
    {.name = "pistonLength", .storage = Storage::real, .offset = offsetof(Record, visualization.pistonLength), .role = Role::visualization},
    {.name = "rodMountRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.rodMountRadius), .role = Role::visualization},
    {.name = "baseMountRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.baseMountRadius), .role = Role::visualization},
    {.name = "baseMountLength", .storage = Storage::real, .offset = offsetof(Record, visualization.baseMountLength), .role = Role::visualization},
    {.name = "colorCylinder", .storage = Storage::vector4, .offset = offsetof(Record, visualization.colorCylinder), .role = Role::visualization},
    {.name = "colorPiston", .storage = Storage::vector4, .offset = offsetof(Record, visualization.colorPiston), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"HydraulicActuatorSimple"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 5> outputs{
    OutputVariableType::Distance,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::VelocityLocal,
    OutputVariableType::Force,
};

}  // namespace

extern const ItemType object_connector_hydraulic_actuator_simple_type;
const ItemType object_connector_hydraulic_actuator_simple_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorHydraulicActuatorSimple",
    .type_name = "ConnectorHydraulicActuatorSimple",
    .category = "Connector",
    .short_names = short_names,
    .provides = provides,
    .rows = rows,
    .outputs = outputs,
    .record = record_operations<Record>(),
    .requested_node = Port::none,
    .requested_marker = Port::position,
    .physics = nullptr,
    .spec = "specs/connectors/hydraulic_actuator_simple.toml",
};

}  // namespace dalembert
