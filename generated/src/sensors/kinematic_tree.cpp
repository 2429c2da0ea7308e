// Generated from specs/sensors/kinematic_tree.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/kinematic_tree_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/kinematic_tree.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_kinematic_tree {

using Record = SensorKinematicTreeRecord;

constexpr std::array<Row, 9> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "objectNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.objectNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "linkNumber", .storage = Storage::integer, .offset = offsetof(Record, parameters.linkNumber), .role = Role::parameter, .check = Check::non_negative, .named = Named::links},
    {.name = "localPosition", .storage = Storage::vector3, .offset = offsetof(Record, parameters.localPosition), .role = Role::parameter, .unit = "m"},
    {.name = "writeToFile", .storage = Storage::boolean, .offset = offsetof(Record, parameters.writeToFile), .role = Role::parameter},
    {.name = "fileName", .storage = Storage::text, .offset = offsetof(Record, parameters.fileName), .role = Role::parameter},
    {.name = "outputVariableType", .storage = Storage::output_variable, .offset = offsetof(Record, parameters.outputVariableType), .role = Role::parameter},
    {.name = "storeInternal", .storage = Storage::boolean, .offset = offsetof(Record, parameters.storeInternal), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = SensorPhysicsOf<SensorKinematicTree, SensorKinematicTreeRecord>{};

}  // namespace sensor_kinematic_tree

extern const ItemType sensor_kinematic_tree_type;
const ItemType sensor_kinematic_tree_type{
    .kind = ItemKind::sensor,
    .name = "SensorKinematicTree",
    .type_name = "KinematicTree",
    .category = "",
    .short_names = sensor_kinematic_tree::short_names,
    .provides = sensor_kinematic_tree::provides,
    .rows = sensor_kinematic_tree::rows,
    .outputs = sensor_kinematic_tree::outputs,
    .record = record_operations<sensor_kinematic_tree::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_kinematic_tree::physics,
    .spec = "specs/sensors/kinematic_tree.toml",
};

}  // namespace dalembert
