// Generated from specs/markers/kinematic_tree_rigid.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/kinematic_tree_rigid_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// By hand: it moves with those joints only that lie between its link and the base
const Physics& marker_kinematic_tree_rigid_physics();

// Named, for several of these files may be compiled at once.
namespace marker_kinematic_tree_rigid {

using Record = MarkerKinematicTreeRigidRecord;

constexpr std::array<Row, 6> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "objectNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.objectNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "linkNumber", .storage = Storage::integer, .offset = offsetof(Record, parameters.linkNumber), .role = Role::parameter, .check = Check::non_negative, .named = Named::links, .needs_assemble = true},
    {.name = "localPosition", .storage = Storage::vector3, .offset = offsetof(Record, parameters.localPosition), .role = Role::parameter, .unit = "m"},
    {.name = "localRotation", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.localRotation), .role = Role::parameter, .check = Check::rotation, .needs_assemble = true, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 4> provides{"Object", "Body", "Position", "Orientation"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = marker_kinematic_tree_rigid_physics();

}  // namespace marker_kinematic_tree_rigid

extern const ItemType marker_kinematic_tree_rigid_type;
const ItemType marker_kinematic_tree_rigid_type{
    .kind = ItemKind::marker,
    .name = "MarkerKinematicTreeRigid",
    .type_name = "KinematicTreeRigid",
    .category = "",
    .short_names = marker_kinematic_tree_rigid::short_names,
    .provides = marker_kinematic_tree_rigid::provides,
    .rows = marker_kinematic_tree_rigid::rows,
    .outputs = marker_kinematic_tree_rigid::outputs,
    .record = record_operations<marker_kinematic_tree_rigid::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_kinematic_tree_rigid::physics,
    .spec = "specs/markers/kinematic_tree_rigid.toml",
};

}  // namespace dalembert
