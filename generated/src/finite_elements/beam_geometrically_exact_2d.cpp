// Generated from specs/finite_elements/beam_geometrically_exact_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/beam_geometrically_exact_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/beam_geometrically_exact_2d.hpp"
#include "dalembert/items/nodes/rigid_body_2d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_beam_geometrically_exact_2d {

using Record = ObjectBeamGeometricallyExact2DRecord;

constexpr std::array<std::string_view, 1> physicsLength_aliases{"length"};

constexpr std::array<std::string_view, 1> physicsMassPerLength_aliases{"massPerLength"};

constexpr std::array<std::string_view, 1> physicsCrossSectionInertia_aliases{"crossSectionInertia"};

constexpr std::array<std::string_view, 1> physicsBendingStiffness_aliases{"bendingStiffness"};

constexpr std::array<std::string_view, 1> physicsAxialStiffness_aliases{"axialStiffness"};

constexpr std::array<std::string_view, 1> physicsShearStiffness_aliases{"shearStiffness"};

constexpr std::array<std::string_view, 1> physicsBendingDamping_aliases{"bendingDamping"};

constexpr std::array<std::string_view, 1> physicsAxialDamping_aliases{"axialDamping"};

constexpr std::array<std::string_view, 1> physicsShearDamping_aliases{"shearDamping"};

constexpr std::array<std::string_view, 1> physicsReferenceCurvature_aliases{"referenceCurvature"};

constexpr std::array<Row, 16> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "physicsLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m", .aliases = physicsLength_aliases},
    {.name = "physicsMassPerLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMassPerLength), .role = Role::parameter, .check = Check::non_negative, .unit = "kg/m", .aliases = physicsMassPerLength_aliases},
    {.name = "physicsCrossSectionInertia", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsCrossSectionInertia), .role = Role::parameter, .check = Check::non_negative, .unit = "kg m", .aliases = physicsCrossSectionInertia_aliases},
    {.name = "physicsBendingStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2", .aliases = physicsBendingStiffness_aliases},
    {.name = "physicsAxialStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N", .aliases = physicsAxialStiffness_aliases},
    {.name = "physicsShearStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsShearStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N", .aliases = physicsShearStiffness_aliases},
    {.name = "physicsBendingDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2 s", .aliases = physicsBendingDamping_aliases},
    {.name = "physicsAxialDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N s", .aliases = physicsAxialDamping_aliases},
    {.name = "physicsShearDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsShearDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N s", .aliases = physicsShearDamping_aliases},
    {.name = "physicsReferenceCurvature", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsReferenceCurvature), .role = Role::parameter, .unit = "1/m", .aliases = physicsReferenceCurvature_aliases},
    {.name = "includeReferenceRotations", .storage = Storage::boolean, .offset = offsetof(Record, parameters.includeReferenceRotations), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawHeight", .storage = Storage::real, .offset = offsetof(Record, visualization.drawHeight), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"Beam2D"};
constexpr std::array<std::string_view, 2> provides{"Body", "MultiNoded"};
constexpr std::array<OutputVariableType, 10> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Rotation,
    OutputVariableType::StrainLocal,
    OutputVariableType::CurvatureLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectBeamGeometricallyExact2D, ObjectBeamGeometricallyExact2DRecord, NodeRigidBody2D>{};

}  // namespace object_beam_geometrically_exact_2d

extern const ItemType object_beam_geometrically_exact_2d_type;
const ItemType object_beam_geometrically_exact_2d_type{
    .kind = ItemKind::object,
    .name = "ObjectBeamGeometricallyExact2D",
    .type_name = "BeamGeometricallyExact2D",
    .category = "FiniteElement",
    .short_names = object_beam_geometrically_exact_2d::short_names,
    .provides = object_beam_geometrically_exact_2d::provides,
    .rows = object_beam_geometrically_exact_2d::rows,
    .outputs = object_beam_geometrically_exact_2d::outputs,
    .record = record_operations<object_beam_geometrically_exact_2d::Record>(),
    .requested_node = Capability::position_2d | Capability::orientation_2d | Capability::position | Capability::orientation,
    .requested_marker = Capability::none,
    .physics = &object_beam_geometrically_exact_2d::physics,
    .spec = "specs/finite_elements/beam_geometrically_exact_2d.toml",
};

}  // namespace dalembert
