// Generated from specs/contacts/curve_circles.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/contacts/curve_circles_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/contacts/curve_circles.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_contact_curve_circles {

using Record = ObjectContactCurveCirclesRecord;

constexpr std::array<Row, 19> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "circlesRadii", .storage = Storage::vector, .offset = offsetof(Record, parameters.circlesRadii), .role = Role::parameter, .takes_number = true, .unit = "m"},
    {.name = "segmentsData", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.segmentsData), .role = Role::parameter, .unit = "m"},
    {.name = "polynomialData", .storage = Storage::matrix_container, .offset = offsetof(Record, parameters.polynomialData), .role = Role::parameter, .unit = "various"},
    {.name = "rotationMarker0", .storage = Storage::matrix3, .offset = offsetof(Record, parameters.rotationMarker0), .role = Role::parameter, .check = Check::rotation, .unit = "1"},
    {.name = "dynamicFriction", .storage = Storage::real, .offset = offsetof(Record, parameters.dynamicFriction), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "frictionProportionalZone", .storage = Storage::real, .offset = offsetof(Record, parameters.frictionProportionalZone), .role = Role::parameter, .check = Check::non_negative, .unit = "m/s"},
    {.name = "contactStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffness), .role = Role::parameter, .unit = "N/m^2"},
    {.name = "contactDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.contactDamping), .role = Role::parameter, .unit = "Ns/m^2"},
    {.name = "contactModel", .storage = Storage::integer, .offset = offsetof(Record, parameters.contactModel), .role = Role::parameter, .check = Check::non_negative},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "gapPerSegment", .storage = Storage::vector, .offset = offsetof(Record, parameters.gapPerSegment), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m"},
    {.name = "gapPerSegment_t", .storage = Storage::vector, .offset = offsetof(Record, parameters.gapPerSegment_t), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "m/s"},
    {.name = "segmentsForceLocalX", .storage = Storage::vector, .offset = offsetof(Record, parameters.segmentsForceLocalX), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "N"},
    {.name = "segmentsForceLocalY", .storage = Storage::vector, .offset = offsetof(Record, parameters.segmentsForceLocalY), .role = Role::parameter, .takes_number = true, .internal = true, .unit = "N"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 1> short_names{"CamFollowerContactPlanar"};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 3> outputs{
    OutputVariableType::DisplacementLocal,
    OutputVariableType::VelocityLocal,
    OutputVariableType::ForceLocal,
};

const auto& physics = ConnectorPhysics<ObjectContactCurveCircles, ObjectContactCurveCirclesRecord>{};

}  // namespace object_contact_curve_circles

extern const ItemType object_contact_curve_circles_type;
const ItemType object_contact_curve_circles_type{
    .kind = ItemKind::object,
    .name = "ObjectContactCurveCircles",
    .type_name = "ContactCurveCircles",
    .category = "Connector",
    .short_names = object_contact_curve_circles::short_names,
    .provides = object_contact_curve_circles::provides,
    .rows = object_contact_curve_circles::rows,
    .outputs = object_contact_curve_circles::outputs,
    .record = record_operations<object_contact_curve_circles::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::position | Capability::orientation,
    .physics = &object_contact_curve_circles::physics,
    .spec = "specs/contacts/curve_circles.toml",
};

}  // namespace dalembert
