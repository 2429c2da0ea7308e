// Generated from specs/super_elements/generic_ode2.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/super_elements/generic_ode2_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sized_body.hpp"
#include "dalembert/items/super_elements/generic_ode2.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_generic_ode2 {

using Record = ObjectGenericODE2Record;

constexpr std::array<Signature::Kind, 2> forceUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
};
constexpr Signature forceUserFunction_signature{.arguments = forceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<forceUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Signature::Kind, 2> massMatrixUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
};
constexpr Signature massMatrixUserFunction_signature{.arguments = massMatrixUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_matrix, .compiled = &compiled_call<massMatrixUserFunction_arguments, true, true, Signature::Kind::open_matrix>};

constexpr std::array<Signature::Kind, 4> jacobianUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature jacobianUserFunction_signature{.arguments = jacobianUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_matrix, .compiled = &compiled_call<jacobianUserFunction_arguments, true, true, Signature::Kind::open_matrix>};

constexpr std::array<Row, 18> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "massMatrix", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.massMatrix), .role = Role::parameter, .unit = "various"},
    {.name = "stiffnessMatrix", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.stiffnessMatrix), .role = Role::parameter, .unit = "various"},
    {.name = "dampingMatrix", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.dampingMatrix), .role = Role::parameter, .unit = "various"},
    {.name = "forceVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.forceVector), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "forceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.forceUserFunction), .role = Role::parameter, .signature = &forceUserFunction_signature},
    {.name = "massMatrixUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.massMatrixUserFunction), .role = Role::parameter, .signature = &massMatrixUserFunction_signature},
    {.name = "jacobianUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.jacobianUserFunction), .role = Role::parameter, .signature = &jacobianUserFunction_signature},
    {.name = "coordinateIndexPerNode", .storage = Storage::integers, .offset = offsetof(Record, parameters.coordinateIndexPerNode), .role = Role::parameter, .internal = true},
    {.name = "tempCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "tempCoordinates_t", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates_t), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "tempCoordinates_tt", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates_tt), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
    {.name = "triangleMesh", .storage = Storage::integer_matrix, .offset = offsetof(Record, visualization.triangleMesh), .role = Role::visualization},
    {.name = "showNodes", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showNodes), .role = Role::visualization},
    {.name = "graphicsDataUserFunction", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsDataUserFunction), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Body", "MultiNoded", "SuperElement"};
constexpr std::array<OutputVariableType, 7> outputs{
    OutputVariableType::CoordinatesTotal,
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Coordinates_tt,
    OutputVariableType::Force,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = SizedBodyPhysics<ObjectGenericODE2, ObjectGenericODE2Record>{};

}  // namespace object_generic_ode2

extern const ItemType object_generic_ode2_type;
const ItemType object_generic_ode2_type{
    .kind = ItemKind::object,
    .name = "ObjectGenericODE2",
    .type_name = "GenericODE2",
    .category = "SuperElement",
    .short_names = object_generic_ode2::short_names,
    .provides = object_generic_ode2::provides,
    .rows = object_generic_ode2::rows,
    .outputs = object_generic_ode2::outputs,
    .record = record_operations<object_generic_ode2::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_generic_ode2::physics,
    .spec = "specs/super_elements/generic_ode2.toml",
};

}  // namespace dalembert
