// Generated from specs/bodies/ground.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/bodies/ground_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/body.hpp"
#include "dalembert/items/bodies/ground.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_ground {

using Record = ObjectGroundRecord;

constexpr std::array<Row, 6> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "referencePosition", .storage = Storage::vector3, .offset = offsetof(Record, parameters.referencePosition), .role = Role::parameter, .unit = "m"},
    {.name = "referenceRotation", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.referenceRotation), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "graphicsDataUserFunction", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsDataUserFunction), .role = Role::visualization},
    {.name = "graphicsData", .storage = Storage::opaque, .offset = offsetof(Record, visualization.graphicsData), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 2> provides{"Ground", "Body"};
constexpr std::array<OutputVariableType, 6> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::Velocity,
    OutputVariableType::AngularVelocity,
    OutputVariableType::RotationMatrix,
    OutputVariableType::HomogeneousTransformation,
};

const auto& physics = BodyPhysics<ObjectGround, ObjectGroundRecord>{};

}  // namespace object_ground

extern const ItemType object_ground_type;
const ItemType object_ground_type{
    .kind = ItemKind::object,
    .name = "ObjectGround",
    .type_name = "Ground",
    .category = "Body",
    .short_names = object_ground::short_names,
    .provides = object_ground::provides,
    .rows = object_ground::rows,
    .outputs = object_ground::outputs,
    .record = record_operations<object_ground::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &object_ground::physics,
    .spec = "specs/bodies/ground.toml",
};

}  // namespace dalembert
