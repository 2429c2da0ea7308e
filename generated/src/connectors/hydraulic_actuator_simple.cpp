// Generated from specs/connectors/hydraulic_actuator_simple.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/hydraulic_actuator_simple_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/hydraulic_actuator_simple.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_hydraulic_actuator_simple {

using Record = ObjectConnectorHydraulicActuatorSimpleRecord;

constexpr std::array<Row, 30> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "offsetLength", .storage = Storage::real, .offset = offsetof(Record, parameters.offsetLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "strokeLength", .storage = Storage::real, .offset = offsetof(Record, parameters.strokeLength), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "chamberCrossSection0", .storage = Storage::real, .offset = offsetof(Record, parameters.chamberCrossSection0), .role = Role::parameter, .check = Check::positive, .unit = "m^2"},
    {.name = "chamberCrossSection1", .storage = Storage::real, .offset = offsetof(Record, parameters.chamberCrossSection1), .role = Role::parameter, .check = Check::positive, .unit = "m^2"},
    {.name = "hoseVolume0", .storage = Storage::real, .offset = offsetof(Record, parameters.hoseVolume0), .role = Role::parameter, .check = Check::positive, .unit = "m^3"},
    {.name = "hoseVolume1", .storage = Storage::real, .offset = offsetof(Record, parameters.hoseVolume1), .role = Role::parameter, .check = Check::positive, .unit = "m^3"},
    {.name = "valveOpening0", .storage = Storage::real, .offset = offsetof(Record, parameters.valveOpening0), .role = Role::parameter, .unit = "1"},
    {.name = "valveOpening1", .storage = Storage::real, .offset = offsetof(Record, parameters.valveOpening1), .role = Role::parameter, .unit = "1"},
    {.name = "actuatorDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.actuatorDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns/m"},
    {.name = "oilBulkModulus", .storage = Storage::real, .offset = offsetof(Record, parameters.oilBulkModulus), .role = Role::parameter, .check = Check::positive, .unit = "Pa"},
    {.name = "cylinderBulkModulus", .storage = Storage::real, .offset = offsetof(Record, parameters.cylinderBulkModulus), .role = Role::parameter, .check = Check::non_negative, .unit = "Pa"},
    {.name = "hoseBulkModulus", .storage = Storage::real, .offset = offsetof(Record, parameters.hoseBulkModulus), .role = Role::parameter, .check = Check::non_negative, .unit = "Pa"},
    {.name = "nominalFlow", .storage = Storage::real, .offset = offsetof(Record, parameters.nominalFlow), .role = Role::parameter, .check = Check::positive, .unit = "m^3/(s Pa^(1/2))"},
    {.name = "systemPressure", .storage = Storage::real, .offset = offsetof(Record, parameters.systemPressure), .role = Role::parameter, .unit = "Pa"},
    {.name = "tankPressure", .storage = Storage::real, .offset = offsetof(Record, parameters.tankPressure), .role = Role::parameter, .unit = "Pa"},
    {.name = "useChamberVolumeChange", .storage = Storage::boolean, .offset = offsetof(Record, parameters.useChamberVolumeChange), .role = Role::parameter},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "cylinderRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.cylinderRadius), .role = Role::visualization, .unit = "m"},
    {.name = "rodRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.rodRadius), .role = Role::visualization, .unit = "m"},
    {.name = "pistonRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.pistonRadius), .role = Role::visualization, .unit = "m"},
    {.name = "pistonLength", .storage = Storage::real, .offset = offsetof(Record, visualization.pistonLength), .role = Role::visualization, .unit = "m"},
    {.name = "rodMountRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.rodMountRadius), .role = Role::visualization, .unit = "m"},
    {.name = "baseMountRadius", .storage = Storage::real, .offset = offsetof(Record, visualization.baseMountRadius), .role = Role::visualization, .unit = "m"},
    {.name = "baseMountLength", .storage = Storage::real, .offset = offsetof(Record, visualization.baseMountLength), .role = Role::visualization, .unit = "m"},
    {.name = "colorCylinder", .storage = Storage::vector4, .offset = offsetof(Record, visualization.colorCylinder), .role = Role::visualization, .check = Check::color, .unit = "1"},
    {.name = "colorPiston", .storage = Storage::vector4, .offset = offsetof(Record, visualization.colorPiston), .role = Role::visualization, .check = Check::color, .unit = "1"},
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

const auto& physics = ConnectorPhysics<ObjectConnectorHydraulicActuatorSimple, ObjectConnectorHydraulicActuatorSimpleRecord>{};

}  // namespace object_connector_hydraulic_actuator_simple

extern const ItemType object_connector_hydraulic_actuator_simple_type;
const ItemType object_connector_hydraulic_actuator_simple_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorHydraulicActuatorSimple",
    .type_name = "ConnectorHydraulicActuatorSimple",
    .category = "Connector",
    .short_names = object_connector_hydraulic_actuator_simple::short_names,
    .provides = object_connector_hydraulic_actuator_simple::provides,
    .rows = object_connector_hydraulic_actuator_simple::rows,
    .outputs = object_connector_hydraulic_actuator_simple::outputs,
    .record = record_operations<object_connector_hydraulic_actuator_simple::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position,
    .physics = &object_connector_hydraulic_actuator_simple::physics,
    .spec = "specs/connectors/hydraulic_actuator_simple.toml",
};

}  // namespace dalembert
