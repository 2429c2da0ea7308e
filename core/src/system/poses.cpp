// Poses of all items of a kind, for pictures of a whole system.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void forget(double* rows, std::size_t first, std::size_t step) {
  for (std::size_t i = first; i < 12; i += step) rows[i] = none;
}
void forget_rotation(double* rows) {
  for (std::size_t k = 0; k < 3; ++k) forget(rows, k, 4);
}

// A finite element has an orientation if it has the output Rotation.
bool has_orientation(const ItemType& type) {
  return type.category != "FiniteElement" ||
         std::ranges::find(type.outputs, OutputVariableType::Rotation) != type.outputs.end();
}

void find_objects(const SystemParts& parts, const Evaluation& e, double* rows) {
  std::size_t number = 0;
  for (const auto& [first, count] : parts.object_runs) {
    first.batch->poses(first.entry, count, e, rows);
    if (!has_orientation(*parts.objects[number].type))
      for (int i = 0; i < count; ++i) forget_rotation(rows + 12 * i);
    number += static_cast<std::size_t>(count), rows += 12 * count;
  }
}

void find_markers(const SystemParts& parts, const Evaluation& e, double* rows) {
  for (const MarkerPlace& place : parts.markers) {
    Motion<double> m;
    if (place.member.batch->motion(place.member.entry, e, m)) {
      write_pose(m.position, m.rotation, rows);
      if (place.object >= 0 && !has_orientation(*parts.objects[static_cast<std::size_t>(place.object)].type))
        forget_rotation(rows);
    } else {
      forget(rows, 0, 1);
    }
    rows += 12;
  }
}

void find_nodes(const SystemParts& parts, const Evaluation& e, const State& rest, double* rows) {
  const auto part = [](const double* from, int first, int count) {
    return first < 0 ? std::span<const double>{} : std::span(from + first, static_cast<std::size_t>(count));
  };
  std::vector<double> y_total;
  for (const NodePlace& place : parts.nodes) {
    const Sizes& n = place.sizes;
    const auto y = part(e.y, place.ode1, n.ode1), y_reference = part(rest.y.data(), place.ode1, n.ode1);
    y_total.assign(y.begin(), y.end());
    std::ranges::transform(y_total, y_reference, y_total.begin(), std::plus{});
    const NodeView view{part(e.q, place.ode2, n.ode2),
                        part(e.u, place.ode2, n.ode2),
                        part(e.v, place.ode2, n.ode2),
                        part(e.a, place.ode2, n.ode2),
                        y,
                        y_total,
                        part(e.y_t, place.ode1, n.ode1),
                        part(e.lambda, place.ae, n.ae),
                        part(e.data, place.data, n.data)};
    Motion<double> m;
    if (place.physics->motion(place.record.get(), view, m)) {
      write_pose(m.position, m.rotation, rows);
    } else {
      forget(rows, 0, 1);
    }
    rows += 12;
  }
}

// Nodes of meshes in a floating frame, whose own coordinates are in that frame, and along its axes.
void place_nodes_in_frames(const SystemParts& parts, const Evaluation& e, double* rows) {
  std::size_t number = 0;
  std::vector<double> positions;
  std::array<double, 12> frame;
  for (const auto& [first, count] : parts.object_runs) {
    if (first.batch->has_nodes_in_frame())
      for (int i = 0; i < count; ++i) {
        const auto mesh = parts.objects[number + static_cast<std::size_t>(i)].nodes.of(parts.references).subspan(1);
        if (!first.batch->mesh_outputs(first.entry + i, 0, static_cast<int>(mesh.size()), OutputVariableType::Position,
                                       e, positions))
          continue;
        first.batch->poses(first.entry + i, 1, e, frame.data());
        const double* from = positions.data();
        for (const int node : mesh) {
          for (std::size_t axis = 0; axis < 3; ++axis) frame[4 * axis + 3] = *from++;
          std::ranges::copy(frame, rows + 12 * node);
        }
      }
    number += static_cast<std::size_t>(count);
  }
}

}  // namespace

void System::poses(ItemKind kind, ConfigurationType configuration, Poses& poses) const {
  SystemParts& parts = *parts_;
  const Evaluation e = parts.output_evaluation(parts.state(configuration), poses.totals);
  const auto rows = [&](std::size_t count) {
    poses.rows.resize(12 * count);
    return poses.rows.data();
  };
  if (kind == ItemKind::object) {
    find_objects(parts, e, rows(parts.objects.size()));
  } else if (kind == ItemKind::marker) {
    find_markers(parts, e, rows(parts.markers.size()));
  } else if (kind == ItemKind::node) {
    double* const found = rows(parts.nodes.size());
    find_nodes(parts, e, parts.state(ConfigurationType::Reference), found);
    place_nodes_in_frames(parts, e, found);
  } else {
    poses.rows.clear();
  }
}

std::array<double, 12> System::pose(int object, ConfigurationType configuration, Values& totals) const {
  SystemParts& parts = *parts_;
  const auto& [batch, entry] = parts.objects.at(static_cast<std::size_t>(object)).member;
  std::array<double, 12> rows;
  batch->poses(entry, 1, parts.output_evaluation(parts.state(configuration), totals), rows.data());
  return rows;
}

int System::mesh_outputs(int object, OutputVariableType variable, ConfigurationType configuration, Values& totals,
                         Values& values) const {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  const auto& [batch, entry] = place.member;
  const int count = std::max(batch->mesh_nodes(entry), 0);
  values.clear();
  const Evaluation e = parts.output_evaluation(parts.state(configuration), totals);
  return count > 0 && batch->mesh_outputs(entry, 0, count, variable, e, values) ? count : 0;
}

}  // namespace dalembert
