// Generated from specs/markers/body_rigid.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/body_rigid_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/body_rigid.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_body_rigid {

using Record = MarkerBodyRigidRecord;

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "localPosition", .storage = Storage::vector3, .offset = offsetof(Record, parameters.localPosition), .role = Role::parameter, .unit = "m"},
    {.name = "localRotation", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.localRotation), .role = Role::parameter, .check = Check::rotation, .needs_assemble = true, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 4> provides{"Object", "Body", "Position", "Orientation"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerBodyRigid, MarkerBodyRigidRecord>{};

}  // namespace marker_body_rigid

extern const ItemType marker_body_rigid_type;
const ItemType marker_body_rigid_type{
    .kind = ItemKind::marker,
    .name = "MarkerBodyRigid",
    .type_name = "BodyRigid",
    .category = "",
    .short_names = marker_body_rigid::short_names,
    .provides = marker_body_rigid::provides,
    .rows = marker_body_rigid::rows,
    .outputs = marker_body_rigid::outputs,
    .record = record_operations<marker_body_rigid::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_body_rigid::physics,
    .spec = "specs/markers/body_rigid.toml",
};

}  // namespace dalembert
