// Generated from specs/finite_elements/ancf_beam.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/ancf_beam_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/ancf_beam.hpp"
#include "dalembert/items/nodes/point_slope23.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ancf_beam {

using Record = ObjectANCFBeamRecord;

constexpr std::array<std::string_view, 1> physicsLength_aliases{"length"};

constexpr std::array<Row, 9> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "physicsLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsLength), .role = Role::parameter, .check = Check::positive, .unit = "m", .aliases = physicsLength_aliases},
    {.name = "sectionData", .storage = Storage::beam_section, .offset = offsetof(Record, parameters.sectionData), .role = Role::parameter},
    {.name = "crossSectionPenaltyFactor", .storage = Storage::vector3, .offset = offsetof(Record, parameters.crossSectionPenaltyFactor), .role = Role::parameter, .unit = "1"},
    {.name = "crossSectionDamping", .storage = Storage::vector3, .offset = offsetof(Record, parameters.crossSectionDamping), .role = Role::parameter, .unit = "s"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "sectionGeometry", .storage = Storage::opaque, .offset = offsetof(Record, visualization.sectionGeometry), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"ANCFBeam"};
constexpr std::array<std::string_view, 2> provides{"Body", "MultiNoded"};
constexpr std::array<OutputVariableType, 12> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::VelocityLocal,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::Acceleration,
    OutputVariableType::Rotation,
    OutputVariableType::RotationMatrix,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectANCFBeam, ObjectANCFBeamRecord, NodePointSlope23>{};

}  // namespace object_ancf_beam

extern const ItemType object_ancf_beam_type;
const ItemType object_ancf_beam_type{
    .kind = ItemKind::object,
    .name = "ObjectANCFBeam",
    .type_name = "ANCFBeam",
    .category = "FiniteElement",
    .short_names = object_ancf_beam::short_names,
    .provides = object_ancf_beam::provides,
    .rows = object_ancf_beam::rows,
    .outputs = object_ancf_beam::outputs,
    .record = record_operations<object_ancf_beam::Record>(),
    .requested_node = Capability::position | Capability::orientation,
    .requested_marker = Capability::none,
    .physics = &object_ancf_beam::physics,
    .spec = "specs/finite_elements/ancf_beam.toml",
};

}  // namespace dalembert
