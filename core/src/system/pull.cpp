// Pulls: the point that a user grips, and the generalised forces on it.
#include "dalembert/system/pull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/model/errors.hpp"
#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

struct Point {
  Vec3<double> position{}, velocity{};
};

bool find_mesh_node(const ObjectPlace& object, int node, const Evaluation& e, Point& point) {
  const auto& [batch, entry] = object.member;
  std::vector<double> values;
  if (!batch->mesh_outputs(entry, node, 1, OutputVariableType::Position, e, values)) return false;
  point.position = load<double, 3>(values.data());
  if (!batch->mesh_outputs(entry, node, 1, OutputVariableType::Velocity, e, values)) return false;
  point.velocity = load<double, 3>(values.data());
  return true;
}

// Returns false if the object has no such point.
bool find_point(const SystemParts& parts, const Grip& grip, const Evaluation& e, Point& point) {
  const ObjectPlace& object = parts.objects[static_cast<std::size_t>(grip.object)];
  const auto& [batch, entry] = object.member;
  if (grip.node >= 0) {
    const NodePlace& node = parts.nodes[static_cast<std::size_t>(grip.node)];
    for (int i = 0; i < node.translations; ++i) {
      point.position[i] = e.q[node.ode2 + i];
      point.velocity[i] = e.v[node.ode2 + i];
    }
    return true;
  }
  Motion<double> motion;
  if (const auto* linked = dynamic_cast<const LinkedBodies*>(batch))
    motion = linked->link_motion(entry, grip.part, grip.local, e);
  else if (grip.part >= 0)
    return find_mesh_node(object, grip.part, e, point);
  else if (!batch->motion(entry, e, grip.local, motion))
    return false;
  point = {motion.position, motion.velocity};
  return true;
}

// The coordinates of an object, each once.
std::vector<int> coordinates_of(const SystemParts& parts, int object) {
  std::vector<int> rows;
  parts.list_coordinates(parts.objects[static_cast<std::size_t>(object)], System::Coordinates::ode2, rows);
  std::ranges::sort(rows);
  const auto repeated = std::ranges::unique(rows);
  rows.erase(repeated.begin(), repeated.end());
  return rows;
}

// Velocity of the point for a unit rate of each coordinate. Virtual power gives the generalised forces from it.
std::vector<Vec3<double>> velocities_of(const SystemParts& parts, const Grip& grip, std::span<const int> rows,
                                        Evaluation e) {
  std::vector<double> v(parts.total.size());
  e.v = v.data();
  std::vector<Vec3<double>> velocities;
  for (const int row : rows) {
    Point point;
    v[static_cast<std::size_t>(row)] = 1;
    find_point(parts, grip, e, point);
    v[static_cast<std::size_t>(row)] = 0;
    velocities.push_back(point.velocity);
  }
  return velocities;
}

// The mass that resists at the point, without joints: twice the kinetic energy by the square of the point's velocity, for motions J^T d
// along the axes d; the smallest one. 0: the point does not move, or has no mass.
double mass_at(const SystemParts& parts, const Grip& grip, std::span<const int> rows,
               std::span<const Vec3<double>> velocities, Evaluation e) {
  const auto& [batch, entry] = parts.objects[static_cast<std::size_t>(grip.object)].member;
  std::vector<double> v(parts.total.size());
  e.v = v.data();
  double mass = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    double speed = 0, energy = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double part = velocities[i][axis];
      v[static_cast<std::size_t>(rows[i])] = part;
      speed += part * part;
    }
    if (speed > 0 && batch->energy(entry, Energy::kinetic, e, energy))
      mass = std::min(mass, 2 * energy / (speed * speed));
  }
  return std::isfinite(mass) ? mass : 0;
}

}  // namespace

Grip System::grip(int object, const Vec3<double>& point, int link, ConfigurationType configuration) {
  SystemParts& parts = *parts_;
  const ObjectPlace& place = parts.objects.at(static_cast<std::size_t>(object));
  const auto& [batch, entry] = place.member;
  const auto refuse_grip = [&](const char* problem) {
    refuse(ErrorKind::value, {.item = parts.describe(ItemKind::object, object), .problem = problem});
  };
  const std::vector<int> rows = coordinates_of(parts, object);
  if (rows.empty()) refuse_grip("cannot be pulled, because it does not move");
  const Evaluation e = parts.output_evaluation(parts.state(configuration));
  Grip grip{.object = object};
  double distance = std::numeric_limits<double>::infinity();
  const auto take_nearest = [&](const Grip& candidate) {
    Point found;
    if (!find_point(parts, candidate, e, found)) return;
    const Vec3<double> apart = found.position - point;
    if (dot(apart, apart) < distance) grip = candidate, distance = dot(apart, apart);
  };
  Motion<double> frame;
  if (const auto* linked = dynamic_cast<const LinkedBodies*>(batch)) {
    if (link < 0 || link >= linked->links(entry))
      refuse_grip("cannot be pulled, because the point is on none of its links");
    frame = linked->link_motion(entry, link, {}, e);
    take_nearest({.object = object, .part = link, .local = transposed_times(frame.rotation, point - frame.position)});
  } else if (const int count = batch == nullptr ? 0 : batch->mesh_nodes(entry); count > 0) {
    for (int node = 0; node < count; ++node) take_nearest({.object = object, .part = node});
  } else if (place.type->category == "Body" && batch->motion(entry, e, {}, frame)) {
    take_nearest({.object = object, .local = transposed_times(frame.rotation, point - frame.position)});
  } else if (place.markers.count == 0) {
    for (const int node : place.nodes.of(parts.references))
      if (parts.nodes[static_cast<std::size_t>(node)].translations > 1) take_nearest({.object = object, .node = node});
  }
  if (!std::isfinite(distance)) refuse_grip("cannot be pulled, because it has no position");
  if (mass_at(parts, grip, rows, velocities_of(parts, grip, rows, e), e) == 0)
    refuse_grip("cannot be pulled, because it has no mass at this point");
  return grip;
}

Vec3<double> System::position_of(const Grip& grip, ConfigurationType configuration) {
  Point point;
  find_point(*parts_, grip, parts_->output_evaluation(parts_->state(configuration)), point);
  return point.position;
}

void System::pull(const std::optional<Pull>& pull) {
  parts_->pull = pull;
  parts_->pull_forces.clear();
  pulled_ = pull.has_value();
  parts_->is_pulled = false;
}

void System::renew_pull(const State& state, double step_size) {
  SystemParts& parts = *parts_;
  const auto& [grip, target, strength] = *parts.pull;
  const Evaluation e = parts.output_evaluation(state);
  const std::vector<int> rows = coordinates_of(parts, grip.object);
  const std::vector<Vec3<double>> velocities = velocities_of(parts, grip, rows, e);
  const double mass = mass_at(parts, grip, rows, velocities, e);
  Point point;
  find_point(parts, grip, e, point);
  // Forces that are held for a step are stable for small products of frequency and step only.
  constexpr double largest_product = 0.25;
  const double frequency = std::min(std::sqrt(strength), largest_product / step_size);
  const Vec3<double> force = mass * frequency * (frequency * (target - point.position) - 2.0 * point.velocity);
  parts.pull_forces.clear();
  parts.is_pulled = true;
  for (std::size_t i = 0; i < rows.size(); ++i) parts.pull_forces.push_back({rows[i], dot(velocities[i], force)});
}

}  // namespace dalembert
