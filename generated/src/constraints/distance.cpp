// Generated from specs/constraints/distance.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/constraints/distance_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/constraints/distance.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_distance {

using Record = ObjectConnectorDistanceRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "distance", .storage = Storage::real, .offset = offsetof(Record, parameters.distance), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"DistanceConstraint"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Distance,
    OutputVariableType::Force,
};

const auto& physics = ConstraintPhysics<ObjectConnectorDistance, ObjectConnectorDistanceRecord>{};

}  // namespace object_connector_distance

extern const ItemType object_connector_distance_type;
const ItemType object_connector_distance_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorDistance",
    .type_name = "ConnectorDistance",
    .category = "Constraint",
    .short_names = object_connector_distance::short_names,
    .provides = object_connector_distance::provides,
    .rows = object_connector_distance::rows,
    .outputs = object_connector_distance::outputs,
    .record = record_operations<object_connector_distance::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::position,
    .physics = &object_connector_distance::physics,
    .spec = "specs/constraints/distance.toml",
};

}  // namespace dalembert
