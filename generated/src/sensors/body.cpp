// Generated from specs/sensors/body.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/body_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/body.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_body {

using Record = SensorBodyRecord;

constexpr std::array<Row, 8> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
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

const auto& physics = SensorPhysicsOf<SensorBody, SensorBodyRecord>{};

}  // namespace sensor_body

extern const ItemType sensor_body_type;
const ItemType sensor_body_type{
    .kind = ItemKind::sensor,
    .name = "SensorBody",
    .type_name = "Body",
    .category = "",
    .short_names = sensor_body::short_names,
    .provides = sensor_body::provides,
    .rows = sensor_body::rows,
    .outputs = sensor_body::outputs,
    .record = record_operations<sensor_body::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_body::physics,
    .spec = "specs/sensors/body.toml",
};

}  // namespace dalembert
