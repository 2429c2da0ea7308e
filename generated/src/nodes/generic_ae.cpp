// Generated from specs/nodes/generic_ae.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/generic_ae_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_generic_ae {

using Record = NodeGenericAERecord;

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .needs_assemble = true, .unit = "various"},
    {.name = "initialCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "various"},
    {.name = "numberOfAECoordinates", .storage = Storage::integer, .offset = offsetof(Record, parameters.numberOfAECoordinates), .role = Role::parameter, .check = Check::positive, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 1> outputs{
    OutputVariableType::Coordinates,
};

}  // namespace node_generic_ae

extern const ItemType node_generic_ae_type;
const ItemType node_generic_ae_type{
    .kind = ItemKind::node,
    .name = "NodeGenericAE",
    .type_name = "GenericAE",
    .category = "",
    .short_names = node_generic_ae::short_names,
    .provides = node_generic_ae::provides,
    .rows = node_generic_ae::rows,
    .outputs = node_generic_ae::outputs,
    .record = record_operations<node_generic_ae::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = nullptr,
    .spec = "specs/nodes/generic_ae.toml",
};

}  // namespace dalembert
