// MarkerNodeRotationCoordinate, specs/markers/node_rotation_coordinate.toml: it reads the rotation of any node.
#include <algorithm>

#include "dalembert/batches/inner_markers.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/markers/node_rotation_coordinate_parameters.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/model/item.hpp"

namespace dalembert {
namespace {

int axis_of(const void* record) {
  return static_cast<const MarkerNodeRotationCoordinateRecord*>(record)->parameters.rotationCoordinate;
}

// Value: a Tait-Bryan angle of the node; rate: a component of its angular velocity; force: a moment about that axis.
class RotationCoordinateBatch final : public MarkerBatch {
 public:
  int value_count(const void*, const Placement&) const override { return ScalarPort::values; }
  int force_count(const void*, const Placement&) const override { return ScalarPort::forces; }

  void add(const void* record, const Placement& placement, const Ports&) override {
    nodes_.add(*placement.owner_type, FrameShape::rigid, placement.owner, placement.dofs);
    entries_.push_back({placement.item, axis_of(record)});
  }
  void refresh(int entry, const void* record) override { entries_[entry].axis = axis_of(record); }
  void visit(BlockVisitor& visitor, const Ports&) const override { nodes_.visit(visitor); }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    nodes_.evaluate(evaluation);
    for (int k = 0; k < static_cast<int>(entries_.size()); ++k) {
      const Entry& e = entries_[k];
      const auto node = read_frame<RigidPort>(nodes_.ports, k);
      ports.frame(e.marker)[0] = tait_bryan_angles(node.rotation)[e.axis];
      ports.frame(e.marker)[1] = node.angular_velocity[e.axis];
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    nodes_.evaluate_tangent(evaluation, weights);
    for (int k = 0; k < static_cast<int>(entries_.size()); ++k) {
      const Entry& e = entries_[k];
      const int n = ports.ports[e.marker].n;
      double* derivative = ports.derivative(e.marker);
      for (int first = 0; first < n; first += sweep_width) {
        const auto node = read_moving_frame<RigidPort>(nodes_.ports, k, 0, first);
        const SweepDual angle = tait_bryan_angles(node.rotation)[e.axis];
        for (int j = first; j < std::min(n, first + sweep_width); ++j) {
          derivative[j] = angle.d[j - first];
          derivative[n + j] = node.angular_velocity[e.axis].d[j - first];
        }
      }
      std::copy_n(nodes_.ports.jacobian(k) + (3 + e.axis) * n, n, ports.jacobian(e.marker));
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    set_moments(ports);
    nodes_.pull_back(evaluation, r);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    set_moments(ports);
    nodes_.geometric(evaluation, weights, slots, values);
  }

 private:
  struct Entry {
    int marker = -1, axis = 0;
  };

  void set_moments(const Ports& ports) const {
    nodes_.clear_forces();
    for (int k = 0; k < static_cast<int>(entries_.size()); ++k)
      nodes_.ports.force(k)[3 + entries_[k].axis] = *ports.force(entries_[k].marker);
  }

  std::vector<Entry> entries_;
  mutable InnerMarkers nodes_;  // its ports are work space
};

struct NodeRotationCoordinate final : MarkerPhysics {
  void check(const void* record, const Placement& on, const Ports&, const ItemLabel& item) const override {
    const int axis = axis_of(record);
    if (axis < 0 || axis > 2)
      refuse(ErrorKind::value,
             {item, "rotationCoordinate", "", std::to_string(axis), "0, 1 or 2, for the axes x, y and z", ""});
    const bool planar = provides(*on.owner_type, "Orientation2D"), turns = provides(*on.owner_type, "Orientation");
    if (planar || !turns)
      refuse(ErrorKind::value,
             {item, "nodeNumber", "", "a " + std::string(on.owner_type->name), "a node with an orientation in space",
              planar ? "Use MarkerNodeCoordinate with the rotation coordinate of the node" : ""});
  }
  std::unique_ptr<MarkerBatch> make_batch(const ItemType&, std::span<const ItemType* const>) const override {
    return std::make_unique<RotationCoordinateBatch>();
  }
};

}  // namespace

const Physics& marker_node_rotation_coordinate_physics() {
  static const NodeRotationCoordinate physics;
  return physics;
}

}  // namespace dalembert
