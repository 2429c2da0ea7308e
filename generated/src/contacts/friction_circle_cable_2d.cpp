// Generated from specs/contacts/friction_circle_cable_2d.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/contacts/friction_circle_cable_2d_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/contacts/friction_circle_cable_2d.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_contact_friction_circle_cable_2d {

using Record = ObjectContactFrictionCircleCable2DRecord;

constexpr std::array<Row, 17> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "numberOfContactSegments", .storage = Storage::integer, .offset = offsetof(Record, parameters.numberOfContactSegments), .role = Role::parameter, .check = Check::positive},
    {.name = "contactStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N/m"},
    {.name = "contactDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.contactDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns/m"},
    {.name = "frictionVelocityPenalty", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionVelocityPenalty), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns/m"},
    {.name = "frictionStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N/m"},
    {.name = "frictionCoefficient", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionCoefficient), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "circleRadius", .storage = Storage::real, .offset = offsetof(Record, parameters.circleRadius), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "useSegmentNormals", .storage = Storage::boolean, .offset = offsetof(Record, parameters.useSegmentNormals), .role = Role::parameter},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "limitDamping", .storage = Storage::boolean, .offset = offsetof(Record, parameters.limitDamping), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "showContactCircle", .storage = Storage::boolean, .offset = offsetof(Record, visualization.showContactCircle), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 3> outputs{
    OutputVariableType::Coordinates,
    OutputVariableType::Coordinates_t,
    OutputVariableType::ForceLocal,
};

const auto& physics = ConnectorPhysics<ObjectContactFrictionCircleCable2D, ObjectContactFrictionCircleCable2DRecord>{};

}  // namespace object_contact_friction_circle_cable_2d

extern const ItemType object_contact_friction_circle_cable_2d_type;
const ItemType object_contact_friction_circle_cable_2d_type{
    .kind = ItemKind::object,
    .name = "ObjectContactFrictionCircleCable2D",
    .type_name = "ContactFrictionCircleCable2D",
    .category = "Connector",
    .short_names = object_contact_friction_circle_cable_2d::short_names,
    .provides = object_contact_friction_circle_cable_2d::provides,
    .rows = object_contact_friction_circle_cable_2d::rows,
    .outputs = object_contact_friction_circle_cable_2d::outputs,
    .record = record_operations<object_contact_friction_circle_cable_2d::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::none,
    .physics = &object_contact_friction_circle_cable_2d::physics,
    .spec = "specs/contacts/friction_circle_cable_2d.toml",
};

}  // namespace dalembert
