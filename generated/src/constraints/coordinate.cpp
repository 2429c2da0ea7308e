// Generated from specs/constraints/coordinate.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/constraints/coordinate_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/constraints/coordinate.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_coordinate {

using Record = ObjectConnectorCoordinateRecord;

constexpr std::array<Signature::Kind, 1> offsetUserFunction_arguments{
    Signature::Kind::scalar,
};
constexpr Signature offsetUserFunction_signature{.arguments = offsetUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<offsetUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<Signature::Kind, 1> offsetUserFunction_t_arguments{
    Signature::Kind::scalar,
};
constexpr Signature offsetUserFunction_t_signature{.arguments = offsetUserFunction_t_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<offsetUserFunction_t_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<std::string_view, 1> factorValue1_aliases{"factor1"};

constexpr std::array<Row, 11> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "offset", .storage = Storage::real, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "various"},
    {.name = "factorValue1", .storage = Storage::real, .offset = offsetof(Record, parameters.factorValue1), .role = Role::parameter, .unit = "1", .aliases = factorValue1_aliases},
    {.name = "velocityLevel", .storage = Storage::boolean, .offset = offsetof(Record, parameters.velocityLevel), .role = Role::parameter},
    {.name = "offsetUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.offsetUserFunction), .role = Role::parameter, .signature = &offsetUserFunction_signature},
    {.name = "offsetUserFunction_t", .storage = Storage::user_function, .offset = offsetof(Record, parameters.offsetUserFunction_t), .role = Role::parameter, .signature = &offsetUserFunction_t_signature},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"CoordinateConstraint"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::ConstraintEquation,
    OutputVariableType::Force,
};

const auto& physics = ConstraintPhysics<ObjectConnectorCoordinate, ObjectConnectorCoordinateRecord>{};

}  // namespace object_connector_coordinate

extern const ItemType object_connector_coordinate_type;
const ItemType object_connector_coordinate_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorCoordinate",
    .type_name = "ConnectorCoordinate",
    .category = "Constraint",
    .short_names = object_connector_coordinate::short_names,
    .provides = object_connector_coordinate::provides,
    .rows = object_connector_coordinate::rows,
    .outputs = object_connector_coordinate::outputs,
    .record = record_operations<object_connector_coordinate::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::coordinate,
    .physics = &object_connector_coordinate::physics,
    .spec = "specs/constraints/coordinate.toml",
};

}  // namespace dalembert
