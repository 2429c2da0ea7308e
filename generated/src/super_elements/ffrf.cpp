// Generated from specs/super_elements/ffrf.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/super_elements/ffrf_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sized_body.hpp"
#include "dalembert/items/nodes/rigid_body_ep.hpp"
#include "dalembert/items/nodes/rigid_body_rot_vec_lg.hpp"
#include "dalembert/items/nodes/rigid_body_rxyz.hpp"
#include "dalembert/items/super_elements/ffrf.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ffrf {

using Record = ObjectFFRFRecord;

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

constexpr std::array<Row, 25> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "massMatrixFF", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.massMatrixFF), .role = Role::parameter, .unit = "various"},
    {.name = "stiffnessMatrixFF", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.stiffnessMatrixFF), .role = Role::parameter, .unit = "various"},
    {.name = "dampingMatrixFF", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.dampingMatrixFF), .role = Role::parameter, .unit = "various"},
    {.name = "forceVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.forceVector), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "forceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.forceUserFunction), .role = Role::parameter, .signature = &forceUserFunction_signature},
    {.name = "massMatrixUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.massMatrixUserFunction), .role = Role::parameter, .signature = &massMatrixUserFunction_signature},
    {.name = "computeFFRFterms", .storage = Storage::boolean, .offset = offsetof(Record, parameters.computeFFRFterms), .role = Role::parameter},
    {.name = "coordinateIndexPerNode", .storage = Storage::integers, .offset = offsetof(Record, parameters.coordinateIndexPerNode), .role = Role::parameter, .internal = true},
    {.name = "objectIsInitialized", .storage = Storage::boolean, .offset = offsetof(Record, parameters.objectIsInitialized), .role = Role::parameter},
    {.name = "physicsMass", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMass), .role = Role::parameter, .check = Check::non_negative, .internal = true, .unit = "kg"},
    {.name = "physicsInertia", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.physicsInertia), .role = Role::parameter, .internal = true, .unit = "kg m^2"},
    {.name = "physicsCenterOfMass", .storage = Storage::vector3, .offset = offsetof(Record, parameters.physicsCenterOfMass), .role = Role::parameter, .internal = true, .unit = "m"},
    {.name = "PHItTM", .storage = Storage::matrix, .offset = offsetof(Record, parameters.PHItTM), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "referencePositions", .storage = Storage::vector, .offset = offsetof(Record, parameters.referencePositions), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m"},
    {.name = "tempVector", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempVector), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "tempCoordinates", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m"},
    {.name = "tempCoordinates_t", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempCoordinates_t), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m/s"},
    {.name = "tempRefPosSkew", .storage = Storage::matrix, .offset = offsetof(Record, parameters.tempRefPosSkew), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m"},
    {.name = "tempVelSkew", .storage = Storage::matrix, .offset = offsetof(Record, parameters.tempVelSkew), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m/s"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
    {.name = "triangleMesh", .storage = Storage::integer_matrix, .offset = offsetof(Record, visualization.triangleMesh), .role = Role::visualization},
    {.name = "showNodes", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showNodes), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Body", "MultiNoded", "SuperElement"};
constexpr std::array<OutputVariableType, 6> outputs{
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Coordinates_tt,
    OutputVariableType::Force,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = SizedBodyPhysics<ObjectFFRF, ObjectFFRFRecord, NodeRigidBodyEP, NodeRigidBodyRxyz, NodeRigidBodyRotVecLG>{};

}  // namespace object_ffrf

extern const ItemType object_ffrf_type;
const ItemType object_ffrf_type{
    .kind = ItemKind::object,
    .name = "ObjectFFRF",
    .type_name = "FFRF",
    .category = "SuperElement",
    .short_names = object_ffrf::short_names,
    .provides = object_ffrf::provides,
    .rows = object_ffrf::rows,
    .outputs = object_ffrf::outputs,
    .record = record_operations<object_ffrf::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_ffrf::physics,
    .spec = "specs/super_elements/ffrf.toml",
};

}  // namespace dalembert
