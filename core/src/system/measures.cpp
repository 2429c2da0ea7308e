// What coordinates measure, and the size of the model in space.
#include <algorithm>
#include <cmath>
#include <limits>

#include "dalembert/system/parts.hpp"

namespace dalembert {
namespace {

// A single coordinate may be anything.
bool is_in_space(const NodePlace& node) { return node.ode2 >= 0 && node.translations > 1; }

// Points that are closer together (in m) than this are one point and round-off.
constexpr double smallest_extent = 1e-12;

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

double System::extent() const {
  SystemParts& parts = *parts_;
  const Ports& ports = parts.ports;
  Vec3<double> low, high;
  low.x.fill(std::numeric_limits<double>::infinity());
  high.x.fill(-std::numeric_limits<double>::infinity());
  const auto include = [&](const double* point, int components) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], i < components ? point[i] : 0.0);
      high[i] = std::max(high[i], i < components ? point[i] : 0.0);
    }
  };
  for (const PortLayout& port : ports.ports)
    if (port.values == PointPort::values || port.values == RigidPort::values) include(ports.values.data() + port.first_value, 3);
  for (const NodePlace& node : parts.nodes)
    if (is_in_space(node)) include(parts.total.data() + node.ode2, node.translations);
  std::vector<int> coordinates;
  std::vector<double> points;
  for (const ObjectPlace& object : parts.objects) {
    const auto& [batch, entry] = object.member;
    const int count = batch == nullptr ? 0 : batch->mesh_nodes(entry);
    if (count <= 0) continue;
    coordinates.clear();
    parts.list_coordinates(object, Coordinates::ode2, coordinates);
    const Evaluation now = parts.output_evaluation(parts.state(ConfigurationType::Current), coordinates);
    if (batch->mesh_outputs(entry, 0, count, OutputVariableType::Position, now, points))
      for (int i = 0; i < count; ++i) include(points.data() + 3 * i, 3);
  }
  const Vec3<double> span = high - low;
  const double diagonal = std::sqrt(dot(span, span));
  return std::isfinite(diagonal) && diagonal > smallest_extent ? diagonal : 1;
}

}  // namespace dalembert
