// Generated from specs/bodies/mass_1d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/bodies/mass_1d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/bodies/mass_1d.hpp"
#include "dalembert/items/nodes/generic_ode2.hpp"
#include "dalembert/items/nodes/one_d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_mass_1d {

using Record = ObjectMass1DRecord;

constexpr std::array<std::string_view, 1> physicsMass_aliases{"mass"};

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsMass", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMass), .role = Role::parameter, .check = Check::non_negative, .unit = "kg", .aliases = physicsMass_aliases},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "referencePosition", .storage = Storage::vector3, .offset = offsetof(Record, parameters.referencePosition), .role = Role::parameter, .unit = "m"},
    {.name = "referenceRotation", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.referenceRotation), .role = Role::parameter, .check = Check::orthogonal, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "graphicsData", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsData), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"Mass1D"};
constexpr std::array<std::string_view, 2> provides{"Body", "SingleNoded"};
constexpr std::array<OutputVariableType, 10> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::RotationMatrix,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectMass1D, ObjectMass1DRecord, Node1D, NodeGenericODE2>{};

}  // namespace object_mass_1d

extern const ItemType object_mass_1d_type;
const ItemType object_mass_1d_type{
    .kind = ItemKind::object,
    .name = "ObjectMass1D",
    .type_name = "Mass1D",
    .category = "Body",
    .short_names = object_mass_1d::short_names,
    .provides = object_mass_1d::provides,
    .rows = object_mass_1d::rows,
    .outputs = object_mass_1d::outputs,
    .record = record_operations<object_mass_1d::Record>(),
    .requested_node = Capability::generic_ode2,
    .requested_marker = Capability::none,
    .physics = &object_mass_1d::physics,
    .spec = "specs/bodies/mass_1d.toml",
};

}  // namespace dalembert
