// Generated from specs/markers/super_element_rigid.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/super_element_rigid_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// By hand: it rests on any number of mesh nodes of any types
const Physics& marker_super_element_rigid_physics();

// Named, for several of these files may be compiled at once.
namespace marker_super_element_rigid {

using Record = MarkerSuperElementRigidRecord;

constexpr std::array<Row, 10> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "offset", .storage = Storage::vector3, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "m"},
    {.name = "meshNodeNumbers", .storage = Storage::integers, .offset = offsetof(Record, parameters.meshNodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "weightingFactors", .storage = Storage::vector, .offset = offsetof(Record, parameters.weightingFactors), .role = Role::parameter, .unit = "1"},
    {.name = "useAlternativeApproach", .storage = Storage::boolean, .offset = offsetof(Record, parameters.useAlternativeApproach), .role = Role::parameter},
    {.name = "rotationsExponentialMap", .storage = Storage::integer, .offset = offsetof(Record, parameters.rotationsExponentialMap), .role = Role::parameter, .check = Check::non_negative},
    {.name = "localRotation", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.localRotation), .role = Role::parameter, .check = Check::rotation, .needs_assemble = true, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "showMarkerNodes", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showMarkerNodes), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 4> provides{"Object", "Body", "Position", "Orientation"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = marker_super_element_rigid_physics();

}  // namespace marker_super_element_rigid

extern const ItemType marker_super_element_rigid_type;
const ItemType marker_super_element_rigid_type{
    .kind = ItemKind::marker,
    .name = "MarkerSuperElementRigid",
    .type_name = "SuperElementRigid",
    .category = "",
    .short_names = marker_super_element_rigid::short_names,
    .provides = marker_super_element_rigid::provides,
    .rows = marker_super_element_rigid::rows,
    .outputs = marker_super_element_rigid::outputs,
    .record = record_operations<marker_super_element_rigid::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_super_element_rigid::physics,
    .spec = "specs/markers/super_element_rigid.toml",
};

}  // namespace dalembert
