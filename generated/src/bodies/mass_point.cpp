// Generated from specs/bodies/mass_point.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/bodies/mass_point_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/bodies/mass_point.hpp"
#include "dalembert/items/nodes/point.hpp"
#include "dalembert/items/nodes/point_ground.hpp"
#include "dalembert/items/nodes/point_slope1.hpp"
#include "dalembert/items/nodes/point_slope12.hpp"
#include "dalembert/items/nodes/point_slope23.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_mass_point {

using Record = ObjectMassPointRecord;

constexpr std::array<std::string_view, 1> physicsMass_aliases{"mass"};

constexpr std::array<Row, 5> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsMass", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMass), .role = Role::parameter, .check = Check::non_negative, .unit = "kg", .aliases = physicsMass_aliases},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "graphicsData", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsData), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"MassPoint"};
constexpr std::array<std::string_view, 2> provides{"Body", "SingleNoded"};
constexpr std::array<OutputVariableType, 11> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::Acceleration,
    OutputVariableType::RotationMatrix,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectMassPoint, ObjectMassPointRecord, NodePoint, NodePointGround, NodePointSlope1, NodePointSlope12, NodePointSlope23>{};

}  // namespace object_mass_point

extern const ItemType object_mass_point_type;
const ItemType object_mass_point_type{
    .kind = ItemKind::object,
    .name = "ObjectMassPoint",
    .type_name = "MassPoint",
    .category = "Body",
    .short_names = object_mass_point::short_names,
    .provides = object_mass_point::provides,
    .rows = object_mass_point::rows,
    .outputs = object_mass_point::outputs,
    .record = record_operations<object_mass_point::Record>(),
    .requested_node = Capability::position,
    .requested_marker = Capability::none,
    .physics = &object_mass_point::physics,
    .spec = "specs/bodies/mass_point.toml",
};

}  // namespace dalembert
