// Generated from specs/sensors/object.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/object_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/object.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_object {

using Record = SensorObjectRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "objectNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.objectNumber), .role = Role::parameter, .needs_assemble = true},
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

const auto& physics = SensorPhysicsOf<SensorObject, SensorObjectRecord>{};

}  // namespace sensor_object

extern const ItemType sensor_object_type;
const ItemType sensor_object_type{
    .kind = ItemKind::sensor,
    .name = "SensorObject",
    .type_name = "Object",
    .category = "",
    .short_names = sensor_object::short_names,
    .provides = sensor_object::provides,
    .rows = sensor_object::rows,
    .outputs = sensor_object::outputs,
    .record = record_operations<sensor_object::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_object::physics,
    .spec = "specs/sensors/object.toml",
};

}  // namespace dalembert
