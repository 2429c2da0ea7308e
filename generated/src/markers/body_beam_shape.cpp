// Generated from specs/markers/body_beam_shape.toml by codegen/templates/item.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/markers/body_beam_shape_parameters.hpp"

#include <array>
#include <cstddef>

#include "dalembert/batches/marker.hpp"
#include "dalembert/items/markers/body_beam_shape.hpp"
#include "dalembert/reflection/item_type.hpp"

namespace dalembert {

// Named, for several of these files may be compiled at once.
namespace marker_body_beam_shape {

using Record = MarkerBodyBeamShapeRecord;

constexpr std::array<Row, 3> rows{{
    {.name = "name", .storage = Storage::text, .offset = offsetof(Record, name), .role = Role::name},
    {.name = "bodyNumber", .storage = Storage::object, .offset = offsetof(Record, parameters.bodyNumber), .role = Role::parameter, .needs_assemble = true},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(Record, visualization.show), .role = Role::visualization},
}};

constexpr std::array<std::string_view, 0> short_names{};
constexpr std::array<std::string_view, 2> provides{"Object", "Body"};
constexpr std::array<OutputVariableType, 0> outputs{
};

const auto& physics = MarkerPhysicsOf<MarkerBodyBeamShape, MarkerBodyBeamShapeRecord>{};

}  // namespace marker_body_beam_shape

extern const ItemType marker_body_beam_shape_type;
const ItemType marker_body_beam_shape_type{
    .kind = ItemKind::marker,
    .name = "MarkerBodyBeamShape",
    .type_name = "BodyBeamShape",
    .category = "",
    .short_names = marker_body_beam_shape::short_names,
    .provides = marker_body_beam_shape::provides,
    .rows = marker_body_beam_shape::rows,
    .outputs = marker_body_beam_shape::outputs,
    .record = record_operations<marker_body_beam_shape::Record>(),
    .requested_node = Capability::none,
    .requested_marker = Capability::none,
    .physics = &marker_body_beam_shape::physics,
    .spec = "specs/markers/body_beam_shape.toml",
};

}  // namespace dalembert
