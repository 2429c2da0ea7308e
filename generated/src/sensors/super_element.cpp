// Generated from specs/sensors/super_element.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/super_element_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/super_element.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_super_element {

using Record = SensorSuperElementRecord;

constexpr std::array<Row, 8> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "meshNodeNumber", .storage = Storage::integer, .offset = offsetof(Record, parameters.meshNodeNumber), .role = Role::parameter, .check = Check::non_negative, .named = Named::links},
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

const auto& physics = SensorPhysicsOf<SensorSuperElement, SensorSuperElementRecord>{};

}  // namespace sensor_super_element

extern const ItemType sensor_super_element_type;
const ItemType sensor_super_element_type{
    .kind = ItemKind::sensor,
    .name = "SensorSuperElement",
    .type_name = "SuperElement",
    .category = "",
    .short_names = sensor_super_element::short_names,
    .provides = sensor_super_element::provides,
    .rows = sensor_super_element::rows,
    .outputs = sensor_super_element::outputs,
    .record = record_operations<sensor_super_element::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_super_element::physics,
    .spec = "specs/sensors/super_element.toml",
};

}  // namespace dalembert
