// Generated from specs/finite_elements/ancf_thin_plate.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/ancf_thin_plate_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/ancf_thin_plate.hpp"
#include "dalembert/items/nodes/point_slope12.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ancf_thin_plate {

using Record = ObjectANCFThinPlateRecord;

constexpr std::array<std::string_view, 1> physicsThickness_aliases{"thickness"};

constexpr std::array<std::string_view, 1> physicsDensity_aliases{"density"};

constexpr std::array<std::string_view, 1> physicsMassProportionalDamping_aliases{"massProportionalDamping"};

constexpr std::array<std::string_view, 1> physicsStrainCoefficients_aliases{"strainCoefficients"};

constexpr std::array<std::string_view, 1> physicsCurvatureCoefficients_aliases{"curvatureCoefficients"};

constexpr std::array<Row, 15> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsThickness", .storage = Storage::vector, .offset = offsetof(Record, parameters.physicsThickness), .role = Role::parameter, .takes_number = true, .unit = "m", .aliases = physicsThickness_aliases},
    {.name = "physicsDensity", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsDensity), .role = Role::parameter, .check = Check::non_negative, .unit = "kg/m^3", .aliases = physicsDensity_aliases},
    {.name = "physicsMassProportionalDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMassProportionalDamping), .role = Role::parameter, .unit = "1/s", .aliases = physicsMassProportionalDamping_aliases},
    {.name = "physicsStrainCoefficients", .storage = Storage::matrix3s, .offset = offsetof(Record, parameters.physicsStrainCoefficients), .role = Role::parameter, .unit = "N/m", .aliases = physicsStrainCoefficients_aliases},
    {.name = "physicsCurvatureCoefficients", .storage = Storage::matrix3s, .offset = offsetof(Record, parameters.physicsCurvatureCoefficients), .role = Role::parameter, .unit = "Nm", .aliases = physicsCurvatureCoefficients_aliases},
    {.name = "strainIsRelativeToReference", .storage = Storage::real, .offset = offsetof(Record, parameters.strainIsRelativeToReference), .role = Role::parameter, .unit = "1"},
    {.name = "slopesScalingX", .storage = Storage::vector4, .offset = offsetof(Record, parameters.slopesScalingX), .role = Role::parameter, .unit = "m"},
    {.name = "slopesScalingY", .storage = Storage::vector4, .offset = offsetof(Record, parameters.slopesScalingY), .role = Role::parameter, .unit = "m"},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .size = 4, .needs_assemble = true},
    {.name = "useReducedOrderIntegration", .storage = Storage::integer, .offset = offsetof(Record, parameters.useReducedOrderIntegration), .role = Role::parameter, .check = Check::non_negative},
    {.name = "stiffnessProportionalDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.stiffnessProportionalDamping), .role = Role::parameter, .unit = "s"},
    {.name = "bendingStiffnessProportionalDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.bendingStiffnessProportionalDamping), .role = Role::parameter, .unit = "s"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 2> provides{"Body", "MultiNoded"};
constexpr std::array<OutputVariableType, 13> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Director1,
    OutputVariableType::Director2,
    OutputVariableType::StrainLocal,
    OutputVariableType::CurvatureLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::StressLocal,
    OutputVariableType::Acceleration,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectANCFThinPlate, ObjectANCFThinPlateRecord, NodePointSlope12>{};

}  // namespace object_ancf_thin_plate

extern const ItemType object_ancf_thin_plate_type;
const ItemType object_ancf_thin_plate_type{
    .kind = ItemKind::object,
    .name = "ObjectANCFThinPlate",
    .type_name = "ANCFThinPlate",
    .category = "FiniteElement",
    .short_names = object_ancf_thin_plate::short_names,
    .provides = object_ancf_thin_plate::provides,
    .rows = object_ancf_thin_plate::rows,
    .outputs = object_ancf_thin_plate::outputs,
    .record = record_operations<object_ancf_thin_plate::Record>(),
    .requested_node = Capability::position,
    .requested_marker = Capability::none,
    .physics = &object_ancf_thin_plate::physics,
    .spec = "specs/finite_elements/ancf_thin_plate.toml",
};

}  // namespace dalembert
