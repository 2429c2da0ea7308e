// Generated from specs/contacts/sphere_triangle.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/contacts/sphere_triangle_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/contacts/sphere_triangle.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_contact_sphere_triangle {

using Record = ObjectContactSphereTriangleRecord;

constexpr std::array<std::string_view, 1> radiusSphere_aliases{"sphereRadius"};

constexpr std::array<Row, 18> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "radiusSphere", .storage = Storage::real, .offset = offsetof(Record, parameters.radiusSphere), .role = Role::parameter, .check = Check::positive, .unit = "m", .aliases = radiusSphere_aliases},
    {.name = "trianglePoints", .storage = Storage::vector3s, .offset = offsetof(Record, parameters.trianglePoints), .role = Role::parameter, .unit = "m"},
    {.name = "includeEdges", .storage = Storage::integer, .offset = offsetof(Record, parameters.includeEdges), .role = Role::parameter, .check = Check::non_negative},
    {.name = "dynamicFriction", .storage = Storage::real, .offset = offsetof(Record, parameters.dynamicFriction), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "frictionProportionalZone", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionProportionalZone), .role = Role::parameter, .check = Check::non_negative, .unit = "m/s"},
    {.name = "contactStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "N/m^n"},
    {.name = "contactDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.contactDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "Ns/m"},
    {.name = "contactStiffnessExponent", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffnessExponent), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "restitutionCoefficient", .storage = Storage::real, .offset = offsetof(Record, parameters.restitutionCoefficient), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "minimumImpactVelocity", .storage = Storage::real, .offset = offsetof(Record, parameters.minimumImpactVelocity), .role = Role::parameter, .check = Check::non_negative, .unit = "m/s"},
    {.name = "impactModel", .storage = Storage::integer, .offset = offsetof(Record, parameters.impactModel), .role = Role::parameter, .check = Check::non_negative},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "limitDamping", .storage = Storage::boolean, .offset = offsetof(Record, parameters.limitDamping), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 7> outputs{
    OutputVariableType::Position,
    OutputVariableType::Displacement,
    OutputVariableType::DisplacementLocal,
    OutputVariableType::Director1,
    OutputVariableType::Force,
    OutputVariableType::Torque,
    OutputVariableType::Velocity,
};

const auto& physics = ConnectorPhysics<ObjectContactSphereTriangle, ObjectContactSphereTriangleRecord>{};

}  // namespace object_contact_sphere_triangle

extern const ItemType object_contact_sphere_triangle_type;
const ItemType object_contact_sphere_triangle_type{
    .kind = ItemKind::object,
    .name = "ObjectContactSphereTriangle",
    .type_name = "ContactSphereTriangle",
    .category = "Connector",
    .short_names = object_contact_sphere_triangle::short_names,
    .provides = object_contact_sphere_triangle::provides,
    .rows = object_contact_sphere_triangle::rows,
    .outputs = object_contact_sphere_triangle::outputs,
    .record = record_operations<object_contact_sphere_triangle::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::position,
    .physics = &object_contact_sphere_triangle::physics,
    .spec = "specs/contacts/sphere_triangle.toml",
};

}  // namespace dalembert
