// Generated from specs/nodes/generic_data.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/generic_data_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// By hand: it has as many coordinates as its parameters say
const Physics& node_generic_data_physics();

// Named, for several of these files may be compiled at once.
namespace node_generic_data {

using Record = NodeGenericDataRecord;

constexpr std::array<Row, 4> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "initialCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "various"},
    {.name = "numberOfDataCoordinates", .storage = Storage::integer, .offset = offsetof(Record, parameters.numberOfDataCoordinates), .role = Role::parameter, .check = Check::non_negative, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"GenericData"};
constexpr std::array<OutputVariableType, 1> outputs{
    OutputVariableType::Coordinates,
};

const auto& physics = node_generic_data_physics();

}  // namespace node_generic_data

extern const ItemType node_generic_data_type;
const ItemType node_generic_data_type{
    .kind = ItemKind::node,
    .name = "NodeGenericData",
    .type_name = "GenericData",
    .category = "",
    .short_names = node_generic_data::short_names,
    .provides = node_generic_data::provides,
    .rows = node_generic_data::rows,
    .outputs = node_generic_data::outputs,
    .record = record_operations<node_generic_data::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_generic_data::physics,
    .spec = "specs/nodes/generic_data.toml",
};

}  // namespace dalembert
