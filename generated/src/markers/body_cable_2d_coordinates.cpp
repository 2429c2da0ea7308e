// Generated from specs/markers/body_cable_2d_coordinates.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/body_cable_2d_coordinates_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/body_cable_2d_coordinates.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_body_cable_2d_coordinates {

using Record = MarkerBodyCable2DCoordinatesRecord;

constexpr std::array<Row, 3> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Object", "Body", "Coordinate"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerBodyCable2DCoordinates, MarkerBodyCable2DCoordinatesRecord>{};

}  // namespace marker_body_cable_2d_coordinates

extern const ItemType marker_body_cable_2d_coordinates_type;
const ItemType marker_body_cable_2d_coordinates_type{
    .kind = ItemKind::marker,
    .name = "MarkerBodyCable2DCoordinates",
    .type_name = "BodyCable2DCoordinates",
    .category = "",
    .short_names = marker_body_cable_2d_coordinates::short_names,
    .provides = marker_body_cable_2d_coordinates::provides,
    .rows = marker_body_cable_2d_coordinates::rows,
    .outputs = marker_body_cable_2d_coordinates::outputs,
    .record = record_operations<marker_body_cable_2d_coordinates::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_body_cable_2d_coordinates::physics,
    .spec = "specs/markers/body_cable_2d_coordinates.toml",
};

}  // namespace dalembert
