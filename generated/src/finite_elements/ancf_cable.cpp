// Generated from specs/finite_elements/ancf_cable.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/ancf_cable_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/ancf_cable.hpp"
#include "dalembert/items/nodes/point_slope1.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ancf_cable {

using Record = ObjectANCFCableRecord;

constexpr std::array<std::string_view, 1> physicsLength_aliases{"length"};

constexpr std::array<std::string_view, 1> physicsMassPerLength_aliases{"massPerLength"};

constexpr std::array<std::string_view, 1> physicsBendingStiffness_aliases{"bendingStiffness"};

constexpr std::array<std::string_view, 1> physicsAxialStiffness_aliases{"axialStiffness"};

constexpr std::array<std::string_view, 1> physicsBendingDamping_aliases{"bendingDamping"};

constexpr std::array<std::string_view, 1> physicsAxialDamping_aliases{"axialDamping"};

constexpr std::array<std::string_view, 1> physicsReferenceAxialStrain_aliases{"referenceAxialStrain"};

constexpr std::array<Row, 14> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m", .aliases = physicsLength_aliases},
    {.name = "physicsMassPerLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMassPerLength), .role = Role::parameter, .check = Check::non_negative, .unit = "kg/m", .aliases = physicsMassPerLength_aliases},
    {.name = "physicsBendingStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2", .aliases = physicsBendingStiffness_aliases},
    {.name = "physicsAxialStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N", .aliases = physicsAxialStiffness_aliases},
    {.name = "physicsBendingDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsBendingDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N m^2 s", .aliases = physicsBendingDamping_aliases},
    {.name = "physicsAxialDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsAxialDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "N s", .aliases = physicsAxialDamping_aliases},
    {.name = "physicsReferenceAxialStrain", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsReferenceAxialStrain), .role = Role::parameter, .unit = "1", .aliases = physicsReferenceAxialStrain_aliases},
    {.name = "strainIsRelativeToReference", .storage = Storage::real, .offset = offsetof(Record, parameters.strainIsRelativeToReference), .role = Role::parameter, .unit = "1"},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "useReducedOrderIntegration", .storage = Storage::integer, .offset = offsetof(Record, parameters.useReducedOrderIntegration), .role = Role::parameter, .check = Check::non_negative},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "radius", .storage = Storage::real, .offset = offsetof(Record, visualization.radius), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"Cable"};
constexpr std::array<std::string_view, 2> provides{"Body", "MultiNoded"};
constexpr std::array<OutputVariableType, 11> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Director1,
    OutputVariableType::StrainLocal,
    OutputVariableType::CurvatureLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::Acceleration,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectANCFCable, ObjectANCFCableRecord, NodePointSlope1>{};

}  // namespace object_ancf_cable

extern const ItemType object_ancf_cable_type;
const ItemType object_ancf_cable_type{
    .kind = ItemKind::object,
    .name = "ObjectANCFCable",
    .type_name = "ANCFCable",
    .category = "FiniteElement",
    .short_names = object_ancf_cable::short_names,
    .provides = object_ancf_cable::provides,
    .rows = object_ancf_cable::rows,
    .outputs = object_ancf_cable::outputs,
    .record = record_operations<object_ancf_cable::Record>(),
    .requested_node = Capability::position,
    .requested_marker = Capability::none,
    .physics = &object_ancf_cable::physics,
    .spec = "specs/finite_elements/ancf_cable.toml",
};

}  // namespace dalembert
