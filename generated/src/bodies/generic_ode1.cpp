// Generated from specs/bodies/generic_ode1.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/bodies/generic_ode1_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sized_body.hpp"
#include "dalembert/items/bodies/generic_ode1.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_generic_ode1 {

using Record = ObjectGenericODE1Record;

constexpr std::array<Signature::Kind, 1> rhsUserFunction_arguments{
    Signature::Kind::open_vector,
};
constexpr Signature rhsUserFunction_signature{.arguments = rhsUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<rhsUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Row, 9> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "systemMatrix", .storage = Storage::matrix, .offset = offsetof(Record, parameters.systemMatrix), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "rhsVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.rhsVector), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "rhsUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.rhsUserFunction), .role = Role::parameter, .signature = &rhsUserFunction_signature},
    {.name = "coordinateIndexPerNode", .storage = Storage::integers, .offset = offsetof(Record, parameters.coordinateIndexPerNode), .role = Role::parameter, .internal = true},
    {.name = "tempCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "tempCoordinates_t", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates_t), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"MultiNoded"};
constexpr std::array<OutputVariableType, 3> outputs{
    OutputVariableType::CoordinatesTotal,
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
};

const auto& physics = SizedBodyPhysics<ObjectGenericODE1, ObjectGenericODE1Record>{};

}  // namespace object_generic_ode1

extern const ItemType object_generic_ode1_type;
const ItemType object_generic_ode1_type{
    .kind = ItemKind::object,
    .name = "ObjectGenericODE1",
    .type_name = "GenericODE1",
    .category = "Object",
    .short_names = object_generic_ode1::short_names,
    .provides = object_generic_ode1::provides,
    .rows = object_generic_ode1::rows,
    .outputs = object_generic_ode1::outputs,
    .record = record_operations<object_generic_ode1::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_generic_ode1::physics,
    .spec = "specs/bodies/generic_ode1.toml",
};

}  // namespace dalembert
