// Generated from specs/sensors/marker.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/marker_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/marker.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_marker {

using Record = SensorMarkerRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumber", .storage = Storage::marker, .offset = offsetof(Record, parameters.markerNumber), .role = Role::parameter, .needs_assemble = true},
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

const auto& physics = SensorPhysicsOf<SensorMarker, SensorMarkerRecord>{};

}  // namespace sensor_marker

extern const ItemType sensor_marker_type;
const ItemType sensor_marker_type{
    .kind = ItemKind::sensor,
    .name = "SensorMarker",
    .type_name = "Marker",
    .category = "",
    .short_names = sensor_marker::short_names,
    .provides = sensor_marker::provides,
    .rows = sensor_marker::rows,
    .outputs = sensor_marker::outputs,
    .record = record_operations<sensor_marker::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_marker::physics,
    .spec = "specs/sensors/marker.toml",
};

}  // namespace dalembert
