// Generated from specs/contacts/convex_roll.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/contacts/convex_roll_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/contacts/convex_roll.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_contact_convex_roll {

using Record = ObjectContactConvexRollRecord;

constexpr std::array<Row, 20> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "contactStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffness), .role = Role::parameter, .unit = "N/m"},
    {.name = "contactDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.contactDamping), .role = Role::parameter, .unit = "Ns/m"},
    {.name = "dynamicFriction", .storage = Storage::real, .offset = offsetof(Record, parameters.dynamicFriction), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "staticFrictionOffset", .storage = Storage::real, .offset = offsetof(Record, parameters.staticFrictionOffset), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "viscousFriction", .storage = Storage::real, .offset = offsetof(Record, parameters.viscousFriction), .role = Role::parameter, .check = Check::non_negative, .unit = "s/m"},
    {.name = "exponentialDecayStatic", .storage = Storage::real, .offset = offsetof(Record, parameters.exponentialDecayStatic), .role = Role::parameter, .check = Check::positive, .unit = "m/s"},
    {.name = "frictionProportionalZone", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionProportionalZone), .role = Role::parameter, .check = Check::non_negative, .unit = "m/s"},
    {.name = "rollLength", .storage = Storage::real, .offset = offsetof(Record, parameters.rollLength), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "coefficientsHull", .storage = Storage::vector, .offset = offsetof(Record, parameters.coefficientsHull), .role = Role::parameter, .takes_number = true, .unit = "various"},
    {.name = "coefficientsHullDerivative", .storage = Storage::vector, .offset = offsetof(Record, parameters.coefficientsHullDerivative), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "coefficientsHullDDerivative", .storage = Storage::vector, .offset = offsetof(Record, parameters.coefficientsHullDDerivative), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "various"},
    {.name = "rBoundingSphere", .storage = Storage::real, .offset = offsetof(Record, parameters.rBoundingSphere), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "pContact", .storage = Storage::vector3, .offset = offsetof(Record, parameters.pContact), .role = Role::parameter, .internal = true, .unit = "m"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "limitDamping", .storage = Storage::boolean, .offset = offsetof(Record, parameters.limitDamping), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 4> outputs{
    OutputVariableType::Position,
    OutputVariableType::Velocity,
    OutputVariableType::Force,
    OutputVariableType::Torque,
};

const auto& physics = ConnectorPhysics<ObjectContactConvexRoll, ObjectContactConvexRollRecord>{};

}  // namespace object_contact_convex_roll

extern const ItemType object_contact_convex_roll_type;
const ItemType object_contact_convex_roll_type{
    .kind = ItemKind::object,
    .name = "ObjectContactConvexRoll",
    .type_name = "ContactConvexRoll",
    .category = "Connector",
    .short_names = object_contact_convex_roll::short_names,
    .provides = object_contact_convex_roll::provides,
    .rows = object_contact_convex_roll::rows,
    .outputs = object_contact_convex_roll::outputs,
    .record = record_operations<object_contact_convex_roll::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_contact_convex_roll::physics,
    .spec = "specs/contacts/convex_roll.toml",
};

}  // namespace dalembert
