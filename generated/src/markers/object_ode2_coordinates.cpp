// Generated from specs/markers/object_ode2_coordinates.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/object_ode2_coordinates_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/object_ode2_coordinates.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_object_ode2_coordinates {

using Record = MarkerObjectODE2CoordinatesRecord;

constexpr std::array<Row, 3> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "objectNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.objectNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Object", "Body", "Coordinate"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerObjectODE2Coordinates, MarkerObjectODE2CoordinatesRecord>{};

}  // namespace marker_object_ode2_coordinates

extern const ItemType marker_object_ode2_coordinates_type;
const ItemType marker_object_ode2_coordinates_type{
    .kind = ItemKind::marker,
    .name = "MarkerObjectODE2Coordinates",
    .type_name = "ObjectODE2Coordinates",
    .category = "",
    .short_names = marker_object_ode2_coordinates::short_names,
    .provides = marker_object_ode2_coordinates::provides,
    .rows = marker_object_ode2_coordinates::rows,
    .outputs = marker_object_ode2_coordinates::outputs,
    .record = record_operations<marker_object_ode2_coordinates::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_object_ode2_coordinates::physics,
    .spec = "specs/markers/object_ode2_coordinates.toml",
};

}  // namespace dalembert
