// Generated from specs/bodies/rigid_body.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/bodies/rigid_body_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/bodies/rigid_body.hpp"
#include "dalembert/items/nodes/rigid_body_ep.hpp"
#include "dalembert/items/nodes/rigid_body_rot_vec_lg.hpp"
#include "dalembert/items/nodes/rigid_body_rxyz.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_rigid_body {

using Record = ObjectRigidBodyRecord;

constexpr std::array<std::string_view, 1> physicsMass_aliases{"mass"};

constexpr std::array<std::string_view, 1> physicsInertia_aliases{"inertia"};

constexpr std::array<std::string_view, 1> physicsCenterOfMass_aliases{"centerOfMass"};

constexpr std::array<Row, 8> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "physicsMass", .storage = Storage::real, .offset = offsetof(Record, parameters.physicsMass), .role = Role::parameter, .check = Check::non_negative, .unit = "kg", .aliases = physicsMass_aliases},
    {.name = "physicsInertia", .storage = Storage::vector6, .offset = offsetof(Record, parameters.physicsInertia), .role = Role::parameter, .unit = "kg m^2", .aliases = physicsInertia_aliases},
    {.name = "physicsCenterOfMass", .storage = Storage::vector3, .offset = offsetof(Record, parameters.physicsCenterOfMass), .role = Role::parameter, .unit = "m", .aliases = physicsCenterOfMass_aliases},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "graphicsDataUserFunction", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsDataUserFunction), .role = Role::visualization},
    {.name = "graphicsData", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsData), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 1> short_names{"RigidBody"};
constexpr std::array<std::string_view, 2> provides{"Body", "SingleNoded"};
constexpr std::array<OutputVariableType, 15> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::VelocityLocal,
    OutputVariableType::RotationMatrix,
    OutputVariableType::Rotation,
    OutputVariableType::AngularVelocity,
    OutputVariableType::AngularVelocityLocal,
    OutputVariableType::Acceleration,
    OutputVariableType::AccelerationLocal,
    OutputVariableType::AngularAcceleration,
    OutputVariableType::AngularAccelerationLocal,
    OutputVariableType::HomogeneousTransformation,
    OutputVariableType::KineticEnergy,
    OutputVariableType::PotentialEnergy,
};

const auto& physics = BodyPhysics<ObjectRigidBody, ObjectRigidBodyRecord, NodeRigidBodyEP, NodeRigidBodyRxyz, NodeRigidBodyRotVecLG>{};

}  // namespace object_rigid_body

extern const ItemType object_rigid_body_type;
const ItemType object_rigid_body_type{
    .kind = ItemKind::object,
    .name = "ObjectRigidBody",
    .type_name = "RigidBody",
    .category = "Body",
    .short_names = object_rigid_body::short_names,
    .provides = object_rigid_body::provides,
    .rows = object_rigid_body::rows,
    .outputs = object_rigid_body::outputs,
    .record = record_operations<object_rigid_body::Record>(),
    .requested_node = Capability::position | Capability::orientation,
    .requested_marker = Capability::none,
    .physics = &object_rigid_body::physics,
    .spec = "specs/bodies/rigid_body.toml",
};

}  // namespace dalembert
