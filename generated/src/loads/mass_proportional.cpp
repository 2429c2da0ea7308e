// Generated from specs/loads/mass_proportional.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/loads/mass_proportional_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/load.hpp"
#include "dalembert/items/loads/mass_proportional.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace load_mass_proportional {

using Record = LoadMassProportionalRecord;

constexpr std::array<Signature::Kind, 1> loadVectorUserFunction_arguments{
    Signature::Kind::vector,
};
constexpr Signature loadVectorUserFunction_signature{.arguments = loadVectorUserFunction_arguments, .takes_time = true, .takes_item = false, .result = Signature::Kind::vector, .compiled = &compiled_call<loadVectorUserFunction_arguments, true, false, Signature::Kind::vector>};

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumber", .storage = Storage::marker, .offset = offsetof(Record, parameters.markerNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "loadVector", .storage = Storage::vector3, .offset = offsetof(Record, parameters.loadVector), .role = Role::parameter, .unit = "m/s^2"},
    {.name = "loadVectorUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.loadVectorUserFunction), .role = Role::parameter, .signature = &loadVectorUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"Gravity"};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = LoadPhysicsOf<LoadMassProportional, LoadMassProportionalRecord>{};

}  // namespace load_mass_proportional

extern const ItemType load_mass_proportional_type;
const ItemType load_mass_proportional_type{
    .kind = ItemKind::load,
    .name = "LoadMassProportional",
    .type_name = "MassProportional",
    .category = "",
    .short_names = load_mass_proportional::short_names,
    .provides = load_mass_proportional::provides,
    .rows = load_mass_proportional::rows,
    .outputs = load_mass_proportional::outputs,
    .record = record_operations<load_mass_proportional::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::body_mass,
    .physics = &load_mass_proportional::physics,
    .spec = "specs/loads/mass_proportional.toml",
};

}  // namespace dalembert
