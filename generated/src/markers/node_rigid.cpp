// Generated from specs/markers/node_rigid.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/node_rigid_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/node_rigid.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_node_rigid {

using Record = MarkerNodeRigidRecord;

constexpr std::array<Row, 4> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "localRotation", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.localRotation), .role = Role::parameter, .check = Check::rotation, .needs_assemble = true, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Node", "Position", "Orientation"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerNodeRigid, MarkerNodeRigidRecord>{};

}  // namespace marker_node_rigid

extern const ItemType marker_node_rigid_type;
const ItemType marker_node_rigid_type{
    .kind = ItemKind::marker,
    .name = "MarkerNodeRigid",
    .type_name = "NodeRigid",
    .category = "",
    .short_names = marker_node_rigid::short_names,
    .provides = marker_node_rigid::provides,
    .rows = marker_node_rigid::rows,
    .outputs = marker_node_rigid::outputs,
    .record = record_operations<marker_node_rigid::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_node_rigid::physics,
    .spec = "specs/markers/node_rigid.toml",
};

}  // namespace dalembert
