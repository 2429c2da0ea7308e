// Where all items of a kind are: what pictures of a whole system ask for.
#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void write(const Motion<double>& m, bool is_oriented, double* rows) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) rows[4 * i + k] = is_oriented ? m.rotation.x[3 * i + k] : none;
    rows[4 * i + 3] = m.position.x[i];
  }
}

// A finite element has an orientation if it tells of its rotation.
bool has_orientation(const ItemType& type) {
  return type.category != "FiniteElement" || std::ranges::find(type.outputs, OutputVariableType::Rotation) != type.outputs.end();
}

}  // namespace

void System::poses(ItemKind kind, ConfigurationType configuration, Poses& poses) const {
  SystemParts& parts = *parts_;
  const State& state = parts.state(configuration);
  const State& rest = parts.state(ConfigurationType::Reference);
  const Evaluation e = parts.output_evaluation(state, poses.totals);
  const auto find = [&](const auto& places, auto&& motion_of) {
    poses.rows.assign(12 * places.size(), none);
    for (std::size_t i = 0; i < places.size(); ++i) {
      Motion<double> m;
      bool is_oriented = true;
      if (motion_of(places[i], m, is_oriented)) write(m, is_oriented, poses.rows.data() + 12 * i);
    }
  };
  if (kind == ItemKind::object) {
    find(parts.objects, [&](const ObjectPlace& place, Motion<double>& m, bool& is_oriented) {
      is_oriented = has_orientation(*place.type);
      return place.member.batch->motion(place.member.entry, e, Vec3<double>{0, 0, 0}, m);
    });
  } else if (kind == ItemKind::marker) {
    find(parts.markers, [&](const MarkerPlace& place, Motion<double>& m, bool& is_oriented) {
      is_oriented = place.object < 0 || has_orientation(*parts.objects[static_cast<std::size_t>(place.object)].type);
      return place.member.batch->motion(place.member.entry, e, m);
    });
  } else if (kind == ItemKind::node) {
    std::vector<double> y_total;
    find(parts.nodes, [&](const NodePlace& place, Motion<double>& m, bool&) {
      const Sizes& n = place.sizes;
      const auto part = [](const double* from, int first, int count) {
        return first < 0 ? std::span<const double>{} : std::span(from + first, static_cast<std::size_t>(count));
      };
      const auto y = part(e.y, place.ode1, n.ode1), y_reference = part(rest.y.data(), place.ode1, n.ode1);
      y_total.assign(y.begin(), y.end());
      std::ranges::transform(y_total, y_reference, y_total.begin(), std::plus{});
      const NodeView view{part(e.q, place.ode2, n.ode2),      part(e.u, place.ode2, n.ode2), part(e.v, place.ode2, n.ode2),
                          part(e.a, place.ode2, n.ode2),      y,                             y_total,
                          part(e.y_t, place.ode1, n.ode1),    part(e.lambda, place.ae, n.ae), part(e.data, place.data, n.data)};
      return place.physics->motion(place.record.get(), view, m);
    });
  } else {
    poses.rows.clear();
  }
}

int System::mesh_output(int object, OutputVariableType variable, ConfigurationType configuration, Values& totals, Values& values) const {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  const auto& [batch, entry] = place.member;
  const int count = std::max(batch->mesh_nodes(entry), 0);
  values.clear();
  const Evaluation e = parts.output_evaluation(parts.state(configuration), totals);
  Values one;
  for (int i = 0; i < count; ++i) {
    one.clear();
    if (!batch->mesh_output(entry, i, variable, e, one)) return 0;
    values.insert(values.end(), one.begin(), one.end());
  }
  return count;
}

}  // namespace dalembert
