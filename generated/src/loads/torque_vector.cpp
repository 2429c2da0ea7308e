// Generated from specs/loads/torque_vector.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/loads/torque_vector_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/load.hpp"
#include "dalembert/items/loads/torque_vector.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace load_torque_vector {

using Record = LoadTorqueVectorRecord;

constexpr std::array<Signature::Kind, 1> loadVectorUserFunction_arguments{
    Signature::Kind::vector,
};
constexpr Signature loadVectorUserFunction_signature{.arguments = loadVectorUserFunction_arguments, .takes_time = true, .takes_item = false, .result = Signature::Kind::vector, .compiled = &compiled_call<loadVectorUserFunction_arguments, true, false, Signature::Kind::vector>};

constexpr std::array<Row, 6> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumber", .storage = Storage::marker, .offset = offsetof(Record, parameters.markerNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "loadVector", .storage = Storage::vector3, .offset = offsetof(Record, parameters.loadVector), .role = Role::parameter, .unit = "Nm"},
    {.name = "bodyFixed", .storage = Storage::boolean, .offset = offsetof(Record, parameters.bodyFixed), .role = Role::parameter, .needs_assemble = true},
    {.name = "loadVectorUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.loadVectorUserFunction), .role = Role::parameter, .signature = &loadVectorUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"Torque"};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = LoadPhysicsOf<LoadTorqueVector, LoadTorqueVectorRecord>{};

}  // namespace load_torque_vector

extern const ItemType load_torque_vector_type;
const ItemType load_torque_vector_type{
    .kind = ItemKind::load,
    .name = "LoadTorqueVector",
    .type_name = "TorqueVector",
    .category = "",
    .short_names = load_torque_vector::short_names,
    .provides = load_torque_vector::provides,
    .rows = load_torque_vector::rows,
    .outputs = load_torque_vector::outputs,
    .record = record_operations<load_torque_vector::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::orientation,
    .physics = &load_torque_vector::physics,
    .spec = "specs/loads/torque_vector.toml",
};

}  // namespace dalembert
