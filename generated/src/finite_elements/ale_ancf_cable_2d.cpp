// Generated from specs/finite_elements/ale_ancf_cable_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/ale_ancf_cable_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/ale_ancf_cable_2d.hpp"
#include "dalembert/items/nodes/point_2d_slope1.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ale_ancf_cable_2d {

using Record = ObjectALEANCFCable2DRecord;

constexpr std::array<std::string_view, 1> physicsLength_aliases{"length"};

constexpr std::array<std::string_view, 1> physicsMassPerLength_aliases{"massPerLength"};

constexpr std::array<std::string_view, 1> physicsMovingMassFactor_aliases{"movingMassFactor"};

constexpr std::array<std::string_view, 1> physicsBendingStiffness_aliases{"bendingStiffness"};

constexpr std::array<std::string_view, 1> physicsAxialStiffness_aliases{"axialStiffness"};

constexpr std::array<std::string_view, 1> physicsBendingDamping_aliases{"bendingDamping"};

constexpr std::array<std::string_view, 1> physicsAxialDamping_aliases{"axialDamping"};

constexpr std::array<std::string_view, 1> physicsReferenceAxialStrain_aliases{"referenceAxialStrain"};

constexpr std::array<std::string_view, 1> physicsReferenceCurvature_aliases{"referenceCurvature"};

constexpr std::array<std::string_view, 1> physicsUseCouplingTerms_aliases{"useCouplingTerms"};

constexpr std::array<std::string_view, 1> physicsAddALEvariation_aliases{"addALEvariation"};

constexpr std::array<Row, 18> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m", .aliases = physicsLength_aliases},
    {.name = "physicsMassPerLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMassPerLength), .role = Role::parameter, .check = Check::non_negative, .unit = "kg/m", .aliases = physicsMassPerLength_aliases},
    {.name = "physicsMovingMassFactor", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMovingMassFactor), .role = Role::parameter, .check = Check::non_negative, .unit = "1", .aliases = physicsMovingMassFactor_aliases},
    {.name = "physicsBendingStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2", .aliases = physicsBendingStiffness_aliases},
    {.name = "physicsAxialStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N", .aliases = physicsAxialStiffness_aliases},
    {.name = "physicsBendingDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2 s", .aliases = physicsBendingDamping_aliases},
    {.name = "physicsAxialDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N s", .aliases = physicsAxialDamping_aliases},
    {.name = "physicsReferenceAxialStrain", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsReferenceAxialStrain), .role = Role::parameter, .unit = "1", .aliases = physicsReferenceAxialStrain_aliases},
    {.name = "physicsReferenceCurvature", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsReferenceCurvature), .role = Role::parameter, .unit = "1/m", .aliases = physicsReferenceCurvature_aliases},
    {.name = "physicsUseCouplingTerms", .storage = Storage::boolean, .offset = offsetof(Record, parameters.physicsUseCouplingTerms), .role = Role::parameter, .aliases = physicsUseCouplingTerms_aliases},
    {.name = "physicsAddALEvariation", .storage = Storage::boolean, .offset = offsetof(Record, parameters.physicsAddALEvariation), .role = Role::parameter, .aliases = physicsAddALEvariation_aliases},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .size = 3, .needs_assemble = true},
    {.name = "useReducedOrderIntegration", .storage = Storage::integer, .offset = offsetof(Record, parameters.useReducedOrderIntegration), .role = Role::parameter, .check = Check::non_negative},
    {.name = "strainIsRelativeToReference", .storage = Storage::real, .offset = offsetof(Record, parameters.strainIsRelativeToReference), .role = Role::parameter, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawHeight", .storage = Storage::real, .offset = offsetof(Record, visualization.drawHeight), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"ALECable2D"};
constexpr std::array<std::string_view, 0> provides{};
constexpr std::array<OutputVariableType, 12> outputs{
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
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectALEANCFCable2D, ObjectALEANCFCable2DRecord, NodePoint2DSlope1>{};

}  // namespace object_ale_ancf_cable_2d

extern const ItemType object_ale_ancf_cable_2d_type;
const ItemType object_ale_ancf_cable_2d_type{
    .kind = ItemKind::object,
    .name = "ObjectALEANCFCable2D",
    .type_name = "ALEANCFCable2D",
    .category = "FiniteElement",
    .short_names = object_ale_ancf_cable_2d::short_names,
    .provides = object_ale_ancf_cable_2d::provides,
    .rows = object_ale_ancf_cable_2d::rows,
    .outputs = object_ale_ancf_cable_2d::outputs,
    .record = record_operations<object_ale_ancf_cable_2d::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_ale_ancf_cable_2d::physics,
    .spec = "specs/finite_elements/ale_ancf_cable_2d.toml",
};

}  // namespace dalembert
