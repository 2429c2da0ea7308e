// Generated from specs/finite_elements/ancf_cable_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/ancf_cable_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/ancf_cable_2d.hpp"
#include "dalembert/items/nodes/point_2d_slope1.hpp"
#include "dalembert/reflection/compiled_call.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ancf_cable_2d {

using Record = ObjectANCFCable2DRecord;

constexpr std::array<Signature::Kind, 9> axialForceUserFunction_arguments{
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature axialForceUserFunction_signature{.arguments = axialForceUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<axialForceUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<Signature::Kind, 9> bendingMomentUserFunction_arguments{
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
    Signature::Kind::scalar,
};
constexpr Signature bendingMomentUserFunction_signature{.arguments = bendingMomentUserFunction_arguments, .takes_time = true, .takes_item = true, .result = Signature::Kind::scalar, .compiled = &compiled_call<bendingMomentUserFunction_arguments, true, true, Signature::Kind::scalar>};

constexpr std::array<std::string_view, 1> physicsLength_aliases{"length"};

constexpr std::array<std::string_view, 1> physicsMassPerLength_aliases{"massPerLength"};

constexpr std::array<std::string_view, 1> physicsBendingStiffness_aliases{"bendingStiffness"};

constexpr std::array<std::string_view, 1> physicsAxialStiffness_aliases{"axialStiffness"};

constexpr std::array<std::string_view, 1> physicsBendingDamping_aliases{"bendingDamping"};

constexpr std::array<std::string_view, 1> physicsAxialDamping_aliases{"axialDamping"};

constexpr std::array<std::string_view, 1> physicsReferenceAxialStrain_aliases{"referenceAxialStrain"};

constexpr std::array<std::string_view, 1> physicsReferenceCurvature_aliases{"referenceCurvature"};

constexpr std::array<Row, 17> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m", .aliases = physicsLength_aliases},
    {.name = "physicsMassPerLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMassPerLength), .role = Role::parameter, .check = Check::non_negative, .unit = "kg/m", .aliases = physicsMassPerLength_aliases},
    {.name = "physicsBendingStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2", .aliases = physicsBendingStiffness_aliases},
    {.name = "physicsAxialStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N", .aliases = physicsAxialStiffness_aliases},
    {.name = "physicsBendingDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2 s", .aliases = physicsBendingDamping_aliases},
    {.name = "physicsAxialDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N s", .aliases = physicsAxialDamping_aliases},
    {.name = "physicsReferenceAxialStrain", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsReferenceAxialStrain), .role = Role::parameter, .unit = "1", .aliases = physicsReferenceAxialStrain_aliases},
    {.name = "physicsReferenceCurvature", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsReferenceCurvature), .role = Role::parameter, .unit = "1/m", .aliases = physicsReferenceCurvature_aliases},
    {.name = "strainIsRelativeToReference", .storage = Storage::real, .offset = offsetof(Record, parameters.strainIsRelativeToReference), .role = Role::parameter, .unit = "1"},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "useReducedOrderIntegration", .storage = Storage::integer, .offset = offsetof(Record, parameters.useReducedOrderIntegration), .role = Role::parameter, .check = Check::non_negative},
    {.name = "axialForceUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.axialForceUserFunction), .role = Role::parameter, .signature = &axialForceUserFunction_signature},
    {.name = "bendingMomentUserFunction", .storage = Storage::user_function, .offset = offsetof(Record, parameters.bendingMomentUserFunction), .role = Role::parameter, .signature = &bendingMomentUserFunction_signature},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawHeight", .storage = Storage::real, .offset = offsetof(Record, visualization.drawHeight), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"Cable2D"};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 16> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::VelocityLocal,
    OutputVariableType::Rotation,
    OutputVariableType::Director1,
    OutputVariableType::StrainLocal,
    OutputVariableType::CurvatureLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::Acceleration,
    OutputVariableType::AngularAcceleration,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectANCFCable2D, ObjectANCFCable2DRecord, NodePoint2DSlope1>{};

}  // namespace object_ancf_cable_2d

extern const ItemType object_ancf_cable_2d_type;
const ItemType object_ancf_cable_2d_type{
    .kind = ItemKind::object,
    .name = "ObjectANCFCable2D",
    .type_name = "ANCFCable2D",
    .category = "FiniteElement",
    .short_names = object_ancf_cable_2d::short_names,
    .provides = object_ancf_cable_2d::provides,
    .rows = object_ancf_cable_2d::rows,
    .outputs = object_ancf_cable_2d::outputs,
    .record = record_operations<object_ancf_cable_2d::Record>(),
    .requested_node = Capability::position_2d | Capability::orientation_2d | Capability::position | Capability::orientation,
    .requested_marker = Capability::none,
    .physics = &object_ancf_cable_2d::physics,
    .spec = "specs/finite_elements/ancf_cable_2d.toml",
};

}  // namespace dalembert
