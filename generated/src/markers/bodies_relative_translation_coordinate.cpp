// Generated from specs/markers/bodies_relative_translation_coordinate.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/bodies_relative_translation_coordinate_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/bodies_relative_translation_coordinate.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_bodies_relative_translation_coordinate {

using Record = MarkerBodiesRelativeTranslationCoordinateRecord;

constexpr std::array<Row, 7> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumbers", .storage = Storage::objects, .offset = offsetof(Record, parameters.bodyNumbers), .role = Role::parameter, .size = 2, .needs_assemble = true},
    {.name = "localPosition0", .storage = Storage::vector3, .offset = offsetof(Record, parameters.localPosition0), .role = Role::parameter, .unit = "m"},
    {.name = "localPosition1", .storage = Storage::vector3, .offset = offsetof(Record, parameters.localPosition1), .role = Role::parameter, .unit = "m"},
    {.name = "axis0", .storage = Storage::vector3, .offset = offsetof(Record, parameters.axis0), .role = Role::parameter, .check = Check::unit_vector, .unit = "1"},
    {.name = "offset", .storage = Storage::real, .offset = offsetof(Record, parameters.offset), .role = Role::parameter, .unit = "m"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 3> provides{"Object", "Body", "Coordinate"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerBodiesRelativeTranslationCoordinate, MarkerBodiesRelativeTranslationCoordinateRecord>{};

}  // namespace marker_bodies_relative_translation_coordinate

extern const ItemType marker_bodies_relative_translation_coordinate_type;
const ItemType marker_bodies_relative_translation_coordinate_type{
    .kind = ItemKind::marker,
    .name = "MarkerBodiesRelativeTranslationCoordinate",
    .type_name = "BodiesRelativeTranslationCoordinate",
    .category = "",
    .short_names = marker_bodies_relative_translation_coordinate::short_names,
    .provides = marker_bodies_relative_translation_coordinate::provides,
    .rows = marker_bodies_relative_translation_coordinate::rows,
    .outputs = marker_bodies_relative_translation_coordinate::outputs,
    .record = record_operations<marker_bodies_relative_translation_coordinate::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_bodies_relative_translation_coordinate::physics,
    .spec = "specs/markers/bodies_relative_translation_coordinate.toml",
};

}  // namespace dalembert
