// Generated from specs/nodes/one_d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/nodes/one_d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/node.hpp"
#include "dalembert/items/nodes/one_d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace node_1d {

using Record = Node1DRecord;

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referenceCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.referenceCoordinates), .role = Role::parameter, .needs_assemble = true, .unit = "various"},
    {.name = "initialCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.initialCoordinates), .role = Role::parameter, .unit = "various"},
    {.name = "initialVelocities", .storage = Storage::vector, .offset = offsetof(Record, parameters.initialVelocities), .role = Role::parameter, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"GenericODE2"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::CoordinatesTotal,
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Coordinates_tt,
};

const auto& physics = NodePhysicsOf<Node1D, Node1DRecord>{};

}  // namespace node_1d

extern const ItemType node_1d_type;
const ItemType node_1d_type{
    .kind = ItemKind::node,
    .name = "Node1D",
    .type_name = "1D",
    .category = "",
    .short_names = node_1d::short_names,
    .provides = node_1d::provides,
    .rows = node_1d::rows,
    .outputs = node_1d::outputs,
    .record = record_operations<node_1d::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &node_1d::physics,
    .spec = "specs/nodes/one_d.toml",
};

}  // namespace dalembert
