// Generated from specs/sensors/load.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/load_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/load.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_load {

using Record = SensorLoadRecord;

constexpr std::array<Row, 6> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "loadNumber", .storage = Storage::load, .offset = offsetof(Record, parameters.loadNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "writeToFile", .storage = Storage::boolean, .offset = offsetof(Record, parameters.writeToFile), .role = Role::parameter},
    {.name = "fileName", .storage = Storage::text, .offset = offsetof(Record, parameters.fileName), .role = Role::parameter},
    {.name = "storeInternal", .storage = Storage::boolean, .offset = offsetof(Record, parameters.storeInternal), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = SensorPhysicsOf<SensorLoad, SensorLoadRecord>{};

}  // namespace sensor_load

extern const ItemType sensor_load_type;
const ItemType sensor_load_type{
    .kind = ItemKind::sensor,
    .name = "SensorLoad",
    .type_name = "Load",
    .category = "",
    .short_names = sensor_load::short_names,
    .provides = sensor_load::provides,
    .rows = sensor_load::rows,
    .outputs = sensor_load::outputs,
    .record = record_operations<sensor_load::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_load::physics,
    .spec = "specs/sensors/load.toml",
};

}  // namespace dalembert
