// Generated from specs/finite_elements/beam_geometrically_exact.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/finite_elements/beam_geometrically_exact_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/finite_elements/beam_geometrically_exact.hpp"
#include "dalembert/items/nodes/rigid_body_ep.hpp"
#include "dalembert/items/nodes/rigid_body_rot_vec_lg.hpp"
#include "dalembert/items/nodes/rigid_body_rxyz.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_beam_geometrically_exact {

using Record = ObjectBeamGeometricallyExactRecord;

constexpr std::array<std::string_view, 1> physicsLength_aliases{"length"};

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "nodeNumbers", .storage = Storage::nodes, .offset = offsetof(Record, parameters.nodeNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "physicsLength", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsLength), .role = Role::parameter, .check = Check::positive, .unit = "m", .aliases = physicsLength_aliases},
    {.name = "sectionData", .storage = Storage::beam_section, .offset = offsetof(Record, parameters.sectionData), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "sectionGeometry", .storage = Storage::opaque, .offset = offsetof(Record, visualization.sectionGeometry), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"Beam3D"};
constexpr std::array<std::string_view, 2> provides{"Body", "MultiNoded"};
constexpr std::array<OutputVariableType, 14> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Rotation,
    OutputVariableType::StrainLocal,
    OutputVariableType::CurvatureLocal,
    OutputVariableType::RotationMatrix,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::ForceLocal,
    OutputVariableType::TorqueLocal,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectBeamGeometricallyExact, ObjectBeamGeometricallyExactRecord, NodeRigidBodyEP, NodeRigidBodyRxyz, NodeRigidBodyRotVecLG>{};

}  // namespace object_beam_geometrically_exact

extern const ItemType object_beam_geometrically_exact_type;
const ItemType object_beam_geometrically_exact_type{
    .kind = ItemKind::object,
    .name = "ObjectBeamGeometricallyExact",
    .type_name = "BeamGeometricallyExact",
    .category = "FiniteElement",
    .short_names = object_beam_geometrically_exact::short_names,
    .provides = object_beam_geometrically_exact::provides,
    .rows = object_beam_geometrically_exact::rows,
    .outputs = object_beam_geometrically_exact::outputs,
    .record = record_operations<object_beam_geometrically_exact::Record>(),
    .requested_node = Capability::position | Capability::orientation,
    .requested_marker = Capability::none,
    .physics = &object_beam_geometrically_exact::physics,
    .spec = "specs/finite_elements/beam_geometrically_exact.toml",
};

}  // namespace dalembert
