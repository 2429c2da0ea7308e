// Generated from specs/contacts/coordinate.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/contacts/coordinate_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/connector.hpp"
#include "dalembert/items/contacts/coordinate.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace object_contact_coordinate {

using Record = ObjectContactCoordinateRecord;

constexpr std::array<Row, 14> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "markerNumbers", .storage = Storage::markers, .offset = offsetof(Record, parameters.markerNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "nodeNumber", .storage = Storage::node, .offset = offsetof(Record, parameters.nodeNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "contactStiffness", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffness), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "contactDamping", .storage = Storage::real, .offset = offsetof(Record, parameters.contactDamping), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "offset", .storage = Storage::real, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "various"},
    {.name = "activeConnector", .storage = Storage::boolean, .offset = offsetof(Record, parameters.activeConnector), .role = Role::parameter},
    {.name = "contactStiffnessExponent", .storage = Storage::real, .offset = offsetof(Record, parameters.contactStiffnessExponent), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "restitutionCoefficient", .storage = Storage::real, .offset = offsetof(Record, parameters.restitutionCoefficient), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "minimumImpactVelocity", .storage = Storage::real, .offset = offsetof(Record, parameters.minimumImpactVelocity), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "impactModel", .storage = Storage::integer, .offset = offsetof(Record, parameters.impactModel), .role = Role::parameter, .check = Check::non_negative},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
    {.name = "drawSize", .storage = Storage::real, .offset = offsetof(Record, visualization.drawSize), .role = Role::visualization, .unit = "m"},
    {.name = "color", .storage = Storage::vector4, .offset = offsetof(Record, visualization.color), .role = Role::visualization, .check = Check::color, .unit = "1"},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 1> provides{"Connector"};
constexpr std::array<OutputVariableType, 1> outputs{
    OutputVariableType::Distance,
};

const auto& physics = ConnectorPhysics<ObjectContactCoordinate, ObjectContactCoordinateRecord>{};

}  // namespace object_contact_coordinate

extern const ItemType object_contact_coordinate_type;
const ItemType object_contact_coordinate_type{
    .kind = ItemKind::object,
    .name = "ObjectContactCoordinate",
    .type_name = "ContactCoordinate",
    .category = "Connector",
    .short_names = object_contact_coordinate::short_names,
    .provides = object_contact_coordinate::provides,
    .rows = object_contact_coordinate::rows,
    .outputs = object_contact_coordinate::outputs,
    .record = record_operations<object_contact_coordinate::Record>(),
    .requested_node = Capability::generic_data,
    .requested_marker = Capability::coordinate,
    .physics = &object_contact_coordinate::physics,
    .spec = "specs/contacts/coordinate.toml",
};

}  // namespace dalembert
