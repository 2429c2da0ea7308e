// Generated from specs/super_elements/ffrf_reduced_order.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/super_elements/ffrf_reduced_order_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/sized_body.hpp"
#include "dalembert/items/nodes/rigid_body_ep.hpp"
#include "dalembert/items/nodes/rigid_body_rot_vec_lg.hpp"
#include "dalembert/items/nodes/rigid_body_rxyz.hpp"
#include "dalembert/items/super_elements/ffrf_reduced_order.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ffrf_reduced_order {

using Record = ObjectFFRFreducedOrderRecord;

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

constexpr std::array<std::string_view, 1> physicsMass_aliases{"mass"};

constexpr std::array<std::string_view, 1> physicsInertia_aliases{"inertia"};

constexpr std::array<std::string_view, 1> physicsCenterOfMass_aliases{"centerOfMass"};

constexpr std::array<std::string_view, 1> physicsCenterOfMassTilde_aliases{"centerOfMassTilde"};

constexpr std::array<Row, 28> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "massMatrixReduced", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.massMatrixReduced), .role = Role::parameter, .unit = "various"},
    {.name = "stiffnessMatrixReduced", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.stiffnessMatrixReduced), .role = Role::parameter, .unit = "various"},
    {.name = "dampingMatrixReduced", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.dampingMatrixReduced), .role = Role::parameter, .unit = "various"},
    {.name = "forceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.forceUserFunction), .role = Role::parameter, .signature = &forceUserFunction_signature},
    {.name = "massMatrixUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.massMatrixUserFunction), .role = Role::parameter, .signature = &massMatrixUserFunction_signature},
    {.name = "computeFFRFterms", .storage = Storage::boolean, .offset = offsetof(Record, parameters.computeFFRFterms), .role = Role::parameter},
    {.name = "modeBasis", .storage = Storage::matrix, .offset = offsetof(Record, parameters.modeBasis), .role = Role::parameter, .takes_number = true, .needs_assemble = true, .unit = "various"},
    {.name = "outputVariableModeBasis", .storage = Storage::matrix, .offset = offsetof(Record, parameters.outputVariableModeBasis), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "outputVariableTypeModeBasis", .storage = Storage::output_variable, .offset = offsetof(Record, parameters.outputVariableTypeModeBasis), .role = Role::parameter},
    {.name = "referencePositions", .storage = Storage::vector, .offset = offsetof(Record, parameters.referencePositions), .role = Role::parameter, .takes_number = true, .needs_assemble = true, .unit = "m"},
    {.name = "objectIsInitialized", .storage = Storage::boolean, .offset = offsetof(Record, parameters.objectIsInitialized), .role = Role::parameter},
    {.name = "physicsMass", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMass), .role = Role::parameter, .check = Check::non_negative, .unit = "kg", .aliases = physicsMass_aliases},
    {.name = "physicsInertia", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.physicsInertia), .role = Role::parameter, .unit = "kg m^2", .aliases = physicsInertia_aliases},
    {.name = "physicsCenterOfMass", .storage = Storage::vector3, .offset = offsetof(Record, parameters.physicsCenterOfMass), .role = Role::parameter, .unit = "m", .aliases = physicsCenterOfMass_aliases},
    {.name = "mPsiTildePsi", .storage = Storage::matrix, .offset = offsetof(Record, parameters.mPsiTildePsi), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "mPsiTildePsiTilde", .storage = Storage::matrix, .offset = offsetof(Record, parameters.mPsiTildePsiTilde), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "mPhitTPsi", .storage = Storage::matrix, .offset = offsetof(Record, parameters.mPhitTPsi), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "mPhitTPsiTilde", .storage = Storage::matrix, .offset = offsetof(Record, parameters.mPhitTPsiTilde), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "mXRefTildePsi", .storage = Storage::matrix, .offset = offsetof(Record, parameters.mXRefTildePsi), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "mXRefTildePsiTilde", .storage = Storage::matrix, .offset = offsetof(Record, parameters.mXRefTildePsiTilde), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "physicsCenterOfMassTilde", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.physicsCenterOfMassTilde), .role = Role::parameter, .unit = "m", .aliases = physicsCenterOfMassTilde_aliases},
    {.name = "tempUserFunctionForce", .storage = Storage::vector, .offset = offsetof(Record, parameters.tempUserFunctionForce), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
    {.name = "triangleMesh", .storage = Storage::integer_matrix, .offset = offsetof(Record, visualization.triangleMesh), .role = Role::visualization},
    {.name = "showNodes", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showNodes), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"CMSobject"};
constexpr std::array<std::string_view, 3> provides{"Body", "MultiNoded", "SuperElement"};
constexpr std::array<OutputVariableType, 5> outputs{
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::Force,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = SizedBodyPhysics<ObjectFFRFreducedOrder, ObjectFFRFreducedOrderRecord, NodeRigidBodyEP, NodeRigidBodyRxyz, NodeRigidBodyRotVecLG>{};

}  // namespace object_ffrf_reduced_order

extern const ItemType object_ffrf_reduced_order_type;
const ItemType object_ffrf_reduced_order_type{
    .kind = ItemKind::object,
    .name = "ObjectFFRFreducedOrder",
    .type_name = "FFRFreducedOrder",
    .category = "SuperElement",
    .short_names = object_ffrf_reduced_order::short_names,
    .provides = object_ffrf_reduced_order::provides,
    .rows = object_ffrf_reduced_order::rows,
    .outputs = object_ffrf_reduced_order::outputs,
    .record = record_operations<object_ffrf_reduced_order::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_ffrf_reduced_order::physics,
    .spec = "specs/super_elements/ffrf_reduced_order.toml",
};

}  // namespace dalembert
