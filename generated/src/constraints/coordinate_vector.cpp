// Generated from specs/constraints/coordinate_vector.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/constraints/coordinate_vector_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/constraint.hpp"
#include "dalembert/items/constraints/coordinate_vector.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_connector_coordinate_vector {

using Record = ObjectConnectorCoordinateVectorRecord;

constexpr std::array<Signature::Kind, 3> constraintUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
    Signature::Kind::boolean,
};
constexpr Signature constraintUserFunction_signature{.arguments = constraintUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_vector, .compiled = &compiled_call<constraintUserFunction_arguments, true, true, Signature::Kind::open_vector>};

constexpr std::array<Signature::Kind, 3> jacobianUserFunction_arguments{
    Signature::Kind::open_vector,
    Signature::Kind::open_vector,
    Signature::Kind::boolean,
};
constexpr Signature jacobianUserFunction_signature{.arguments = jacobianUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::open_matrix, .compiled = &compiled_call<jacobianUserFunction_arguments, true, true, Signature::Kind::open_matrix>};

constexpr std::array<Row, 13> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "scalingMarker0", .storage = Storage::matrix, .offset = offsetof(Record, parameters.scalingMarker0), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "scalingMarker1", .storage = Storage::matrix, .offset = offsetof(Record, parameters.scalingMarker1), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "quadraticTermMarker0", .storage = Storage::matrix, .offset = offsetof(Record, parameters.quadraticTermMarker0), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "quadraticTermMarker1", .storage = Storage::matrix, .offset = offsetof(Record, parameters.quadraticTermMarker1), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "offset", .storage = Storage::vector, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "velocityLevel", .storage = Storage::boolean, .offset = offsetof(Record, parameters.velocityLevel), .role = Role::parameter},
    {.name = "constraintUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.constraintUserFunction), .role = Role::parameter, .signature = &constraintUserFunction_signature},
    {.name = "jacobianUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.jacobianUserFunction), .role = Role::parameter, .signature = &jacobianUserFunction_signature},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"CoordinateVectorConstraint"};
constexpr std::array<std::string_view, 2> provides{"Connector", "Constraint"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::ConstraintEquation,
    OutputVariableType::Force,
};

const auto& physics = ConstraintPhysics<ObjectConnectorCoordinateVector, ObjectConnectorCoordinateVectorRecord>{};

}  // namespace object_connector_coordinate_vector

extern const ItemType object_connector_coordinate_vector_type;
const ItemType object_connector_coordinate_vector_type{
    .kind = ItemKind::object,
    .name = "ObjectConnectorCoordinateVector",
    .type_name = "ConnectorCoordinateVector",
    .category = "Constraint",
    .short_names = object_connector_coordinate_vector::short_names,
    .provides = object_connector_coordinate_vector::provides,
    .rows = object_connector_coordinate_vector::rows,
    .outputs = object_connector_coordinate_vector::outputs,
    .record = record_operations<object_connector_coordinate_vector::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::coordinate,
    .physics = &object_connector_coordinate_vector::physics,
    .spec = "specs/constraints/coordinate_vector.toml",
};

}  // namespace dalembert
