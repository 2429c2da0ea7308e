// Generated from specs/sensors/user_function.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/sensors/user_function_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sensor.hpp"
#include "dalembert/items/sensors/user_function.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace sensor_user_function {

using Record = SensorUserFunctionRecord;

constexpr std::array<Signature::Kind, 3> sensorUserFunction_arguments{
    Signature::Kind::index_list,
    Signature::Kind::open_vector,
    Signature::Kind::configuration,
};
constexpr Signature sensorUserFunction_signature{.arguments = sensorUserFunction_arguments, .takes_time = true, .takes_item = false, .result = Signature::Kind::open_vector};

constexpr std::array<Row, 8> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "sensorNumbers", .storage = Storage::sensors, .offset = offsetof(Record, parameters.sensorNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "factors", .storage = Storage::vector, .offset = offsetof(Record, parameters.factors), .role = Role::parameter, .unit = "various"},
    {.name = "writeToFile", .storage = Storage::boolean, .offset = offsetof(Record, parameters.writeToFile), .role = Role::parameter},
    {.name = "fileName", .storage = Storage::text, .offset = offsetof(Record, parameters.fileName), .role = Role::parameter},
    {.name = "sensorUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.sensorUserFunction), .role = Role::parameter, .signature = &sensorUserFunction_signature},
    {.name = "storeInternal", .storage = Storage::boolean, .offset = offsetof(Record, parameters.storeInternal), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = SensorPhysicsOf<SensorUserFunction, SensorUserFunctionRecord>{};

}  // namespace sensor_user_function

extern const ItemType sensor_user_function_type;
const ItemType sensor_user_function_type{
    .kind = ItemKind::sensor,
    .name = "SensorUserFunction",
    .type_name = "UserFunction",
    .category = "",
    .short_names = sensor_user_function::short_names,
    .provides = sensor_user_function::provides,
    .rows = sensor_user_function::rows,
    .outputs = sensor_user_function::outputs,
    .record = record_operations<sensor_user_function::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &sensor_user_function::physics,
    .spec = "specs/sensors/user_function.toml",
};

}  // namespace dalembert
