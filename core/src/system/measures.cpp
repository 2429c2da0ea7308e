// Units of coordinates, and the extent of the model.
#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/math/disjoint_sets.hpp"
#include "dalembert/system/parts.hpp"
#include "dalembert/system/tree_term.hpp"

namespace dalembert {
namespace {

// A single coordinate may be anything.
bool is_in_space(const NodePlace& node) { return node.ode2 >= 0 && node.translations > 1; }

// Points that are closer together (in m) than this are one point and round-off.
constexpr double smallest_extent = 1e-12;

// Meshes with more nodes than that for each of their coordinates: few nodes stand for all, as looking at all would take longer than a step.
constexpr std::size_t many_nodes = 8;

// The outermost points in 26 directions of the reference configuration: the selection must not depend on the time of
// the call.
const std::vector<int>& outermost_nodes(SystemParts& parts, ObjectPlace& object, int count) {
  OutermostNodes& outermost = object.outermost;
  if (outermost.record == object.record) return outermost.nodes;
  outermost = {object.record, {}};
  const std::vector<double> zero(parts.total.size());
  Evaluation rest{};
  rest.q = parts.state(ConfigurationType::Reference).q.data();
  rest.u = rest.v = rest.a = zero.data();
  std::vector<double> points;
  if (!object.member.batch->mesh_outputs(object.member.entry, 0, count, OutputVariableType::Position, rest, points))
    return outermost.nodes;
  for (int direction = 0; direction < 27; ++direction) {
    const Vec3<double> along{direction % 3 - 1.0, direction / 3 % 3 - 1.0, direction / 9 - 1.0};
    int farthest = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < count; ++i) {
      const double far = dot(along, load<double, 3>(points.data() + 3 * i));
      if (far > most) most = far, farthest = i;
    }
    outermost.nodes.push_back(farthest);
  }
  std::ranges::sort(outermost.nodes);
  const auto rest_of_them = std::ranges::unique(outermost.nodes);
  outermost.nodes.erase(rest_of_them.begin(), rest_of_them.end());
  return outermost.nodes;
}

}  // namespace

std::vector<CoordinateUnit> System::coordinate_units() const {
  std::vector<CoordinateUnit> units(static_cast<std::size_t>(sizes_.ode2), CoordinateUnit::unknown);
  for (const NodePlace& node : parts_->nodes) {
    if (!is_in_space(node)) continue;
    const auto first = units.begin() + node.ode2;
    std::fill(first, first + node.translations, CoordinateUnit::meter);
    std::fill(first + node.translations, first + node.sizes.ode2, CoordinateUnit::radian);
  }
  return units;
}

std::vector<int> System::nodes_of_coordinates() const {
  std::vector<int> nodes(static_cast<std::size_t>(sizes_.ode2), -1);
  for (std::size_t i = 0; i < parts_->nodes.size(); ++i) {
    const NodePlace& node = parts_->nodes[i];
    if (node.sizes.ode2 > 0) std::fill_n(nodes.begin() + node.ode2, node.sizes.ode2, static_cast<int>(i));
  }
  return nodes;
}

std::vector<int> System::bodies_of_coordinates() const {
  DisjointSets joined(static_cast<int>(parts_->nodes.size()));
  for (const ObjectPlace& object : parts_->objects) {
    int before = -1;
    for (const int node : object.nodes.of(parts_->references)) {
      if (parts_->nodes[static_cast<std::size_t>(node)].sizes.ode2 == 0) continue;
      if (before >= 0) joined.join(before, node);
      before = node;
    }
  }
  std::vector<int> bodies = nodes_of_coordinates();
  for (int& body : bodies)
    if (body >= 0) body = joined.of(body);
  return bodies;
}

namespace {

// Bounding box of points, and of lengths around one of them.
class Box {
 public:
  Box() {
    low_.x.fill(std::numeric_limits<double>::infinity());
    high_.x.fill(-std::numeric_limits<double>::infinity());
  }
  void include(const double* point, int components) {
    for (int i = 0; i < 3; ++i) {
      low_[i] = std::min(low_[i], i < components ? point[i] : 0.0);
      high_[i] = std::max(high_[i], i < components ? point[i] : 0.0);
    }
  }
  void include_reach(double reach) { reach_ = std::max(reach_, reach); }
  // Zero: all is one point.
  double size() const {
    const Vec3<double> span = high_ - low_;
    const double diagonal = std::sqrt(dot(span, span)),
                 size = std::isfinite(diagonal) ? std::max(diagonal, reach_) : reach_;
    return size > smallest_extent ? size : 0;
  }

 private:
  Vec3<double> low_, high_;
  double reach_ = 0;
};

// box(coordinate) contains the parts that move with an ODE2 coordinate; -1: none.
template <class F>
void fill_boxes(SystemParts& parts, F&& box) {
  const Ports& ports = parts.ports;
  for (const PortLayout& port : ports.ports)
    if (port.values == PointPort::values || port.values == RigidPort::values)
      box(port.n > 0 ? ports.dofs[static_cast<std::size_t>(port.first_dof)] : -1)
          .include(ports.values.data() + port.first_value, 3);
  for (const NodePlace& node : parts.nodes)
    if (is_in_space(node)) box(node.ode2).include(parts.total.data() + node.ode2, node.translations);
  std::vector<int> coordinates;
  std::vector<double> points;
  for (ObjectPlace& object : parts.objects) {
    const auto& [batch, entry] = object.member;
    const auto* bodies = dynamic_cast<const LinkedBodies*>(batch);
    const int count = batch == nullptr ? 0 : batch->mesh_nodes(entry);
    if (count <= 0 && bodies == nullptr) continue;
    coordinates.clear();
    parts.list_coordinates(object, System::Coordinates::ode2, coordinates);
    auto& around = box(coordinates.empty() ? -1 : coordinates.front());
    if (bodies != nullptr) around.include_reach(bodies->reach(entry));
    if (count <= 0) continue;
    const Evaluation now = parts.output_evaluation(parts.state(ConfigurationType::Current), coordinates);
    const auto look = [&](int first, int number) {
      if (batch->mesh_outputs(entry, first, number, OutputVariableType::Position, now, points))
        for (int i = 0; i < number; ++i) around.include(points.data() + 3 * i, 3);
    };
    if (static_cast<std::size_t>(count) <= many_nodes * coordinates.size())
      look(0, count);
    else
      for (const int node : outermost_nodes(parts, object, count)) look(node, 1);
  }
}

}  // namespace

double System::extent() const {
  Box all;
  fill_boxes(*parts_, [&](int) -> Box& { return all; });
  const double size = all.size();
  return size > 0 ? size : 1;
}

std::vector<double> System::extents(std::span<const int> groups, int count) const {
  std::vector<Box> boxes(static_cast<std::size_t>(count) + 1);
  fill_boxes(*parts_, [&](int coordinate) -> Box& {
    const int group = coordinate < 0 ? -1 : groups[static_cast<std::size_t>(coordinate)];
    return group < 0 ? boxes.back() : boxes[static_cast<std::size_t>(group)];
  });
  std::vector<double> sizes;
  for (int i = 0; i < count; ++i) sizes.push_back(boxes[static_cast<std::size_t>(i)].size());
  return sizes;
}

}  // namespace dalembert
