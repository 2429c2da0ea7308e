// Generated from specs/loads/coordinate.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/loads/coordinate_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/load.hpp"
#include "dalembert/items/loads/coordinate.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace load_coordinate {

using Record = LoadCoordinateRecord;

constexpr std::array<Signature::Kind, 1> loadUserFunction_arguments{
    Signature::Kind::scalar,
};
constexpr Signature loadUserFunction_signature{.arguments = loadUserFunction_arguments, .takes_time = true, .takes_item = false, .result = Signature::Kind::scalar, .compiled = &compiled_call<loadUserFunction_arguments, true, false, Signature::Kind::scalar>};

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumber", .storage = Storage::marker, .offset = offsetof(Record, parameters.markerNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "load", .storage = Storage::real, .offset = offsetof(Record, parameters.load), .role = Role::parameter, .unit = "various"},
    {.name = "loadUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.loadUserFunction), .role = Role::parameter, .signature = &loadUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = LoadPhysicsOf<LoadCoordinate, LoadCoordinateRecord>{};

}  // namespace load_coordinate

extern const ItemType load_coordinate_type;
const ItemType load_coordinate_type{
    .kind = ItemKind::load,
    .name = "LoadCoordinate",
    .type_name = "Coordinate",
    .category = "",
    .short_names = load_coordinate::short_names,
    .provides = load_coordinate::provides,
    .rows = load_coordinate::rows,
    .outputs = load_coordinate::outputs,
    .record = record_operations<load_coordinate::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::coordinate,
    .physics = &load_coordinate::physics,
    .spec = "specs/loads/coordinate.toml",
};

}  // namespace dalembert
