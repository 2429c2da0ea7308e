// Generated from specs/connectors/law.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/connectors/law_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/connectors/law.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_law {

using Record = ObjectConnectorLawRecord;

constexpr std::array<Signature::Kind, 3> forceUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
};
constexpr Signature forceUserFunction_signature{.arguments = forceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<forceUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Signature::Kind, 3> stateRateUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
};
constexpr Signature stateRateUserFunction_signature{.arguments = stateRateUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<stateRateUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Signature::Kind, 3> historyUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
};
constexpr Signature historyUserFunction_signature{.arguments = historyUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<historyUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Row, 13> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "numberOfCoordinates", .storage = Storage::integer, .offset = offsetof(Record, parameters.numberOfCoordinates), .role = Role::parameter, .check = Check::positive},
    {.name = "rotationMarker0", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker0), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "rotationMarker1", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker1), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "forceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.forceUserFunction), .role = Role::parameter, .signature = &forceUserFunction_signature},
    {.name = "stateRateUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.stateRateUserFunction), .role = Role::parameter, .signature = &stateRateUserFunction_signature},
    {.name = "historyUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.historyUserFunction), .role = Role::parameter, .signature = &historyUserFunction_signature},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"ConnectorLaw"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 3> outputs{
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Force,
};

const auto& physics = ConnectorPhysics<ObjectConnectorLaw, ObjectConnectorLawRecord>{};

}  // namespace object_connector_law

extern const ItemType object_connector_law_type;
const ItemType object_connector_law_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorLaw",
    .type_name = "ConnectorLaw",
    .category = "Connector",
    .short_names = object_connector_law::short_names,
    .provides = object_connector_law::provides,
    .rows = object_connector_law::rows,
    .outputs = object_connector_law::outputs,
    .record = record_operations<object_connector_law::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_connector_law::physics,
    .spec = "specs/connectors/law.toml",
};

}  // namespace dalembert
