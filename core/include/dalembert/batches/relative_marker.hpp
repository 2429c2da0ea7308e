// Markers on a relative coordinate between two bodies: a translation or a rotation between two frames. A kernel
// defines the measured coordinate and the wrenches on both frames for a force on the coordinate. With a data node,
// the coordinate is a continued angle that counts full turns.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <string>
#include <vector>

#include "dalembert/batches/inner_markers.hpp"
#include "dalembert/batches/port_sweep.hpp"
#include "dalembert/contracts/data_node.hpp"
#include "dalembert/math/rotations.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

template <class K>
concept RelativeMarkerKernel = requires(const typename K::Parameters& p, const RigidFrame<double>& m) {
  { K::template measure<double>(p, m, m) } -> std::same_as<ScalarFrame<double>>;
  { K::template forces<double>(p, m, m, 1.0) } -> std::same_as<std::array<Wrench<double>, 2>>;
};

template <class Parameters>
void check_relative_marker(const Parameters& p, const Placement& on, const ItemLabel& item) {
  if constexpr (requires { p.nodeNumber; })
    if (p.nodeNumber.valid() && on.data_count != 1)
      refuse(ErrorKind::value,
             {item, "nodeNumber", "", "a node with " + std::to_string(on.data_count) + " data coordinates",
              data_node_of(1), ""});
}

template <class K, class Record>
class RelativeMarkerBatch final : public MarkerBatch {
 public:
  int value_count(const void*, const Placement&) const override { return ScalarPort::values; }
  int force_count(const void*, const Placement&) const override { return ScalarPort::forces; }

  void add(const void* record, const Placement& placement, const Ports&) override {
    Entry e;
    e.parameters = static_cast<const Record*>(record)->parameters;
    e.marker = placement.item;
    e.first_data = data_of(e.parameters, placement);
    const Vec3<double> locals[] = {e.parameters.localPosition0, e.parameters.localPosition1};
    std::span<const int> dofs = placement.dofs;
    for (int m = 0; m < 2; ++m) {
      const MarkerOwner& owner = placement.owners[m];
      const auto own = dofs.first(static_cast<std::size_t>(owner.dofs));
      dofs = dofs.subspan(own.size());
      e.bodies[m] = bodies_.add(owner, FrameShape::rigid, own, locals[m]);
      if (e.bodies[m] < 0)
        refuse(ErrorKind::value,
               {"marker " + std::to_string(e.marker), "bodyNumbers", "",
                "a " + std::string(owner.type->name) + ", which has no rigid frame", "two rigid bodies", ""});
    }
    entries_.push_back(std::move(e));
  }
  void refresh(int entry, const void* record) override {
    Entry& e = entries_[entry];
    e.parameters = static_cast<const Record*>(record)->parameters;
    bodies_.refresh(e.bodies[0], e.parameters.localPosition0);
    bodies_.refresh(e.bodies[1], e.parameters.localPosition1);
  }
  void refresh_owners(int entry, int which, const void* record) override {
    bodies_.refresh_owner(entries_[entry].bodies[which], record);
  }
  // The frames' part of each marker, then the parts of the bodies.
  void visit(BlockVisitor& visitor, const Ports& ports) const override {
    for (const Entry& e : entries_) visitor.block(ports.marker_dofs(e.marker), ports.marker_dofs(e.marker));
    bodies_.visit(visitor);
  }

  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    bodies_.evaluate(evaluation);
    for (const Entry& e : entries_) {
      const auto m = e.frames(bodies_.ports);
      const ScalarFrame<double> measured = K::template measure<double>(e.parameters, m[0], m[1]);
      ports.frame(e.marker)[0] = e.continued(evaluation, measured.value);
      ports.frame(e.marker)[1] = measured.rate;
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    bodies_.evaluate_tangent(evaluation, weights);
    for (const Entry& e : entries_) {
      const Columns<2> columns(bodies_.ports, e.bodies);
      double* derivative = ports.derivative(e.marker);
      for (int first = 0; first < columns.total; first += sweep_width) {
        const auto m = e.moving_frames(bodies_.ports, columns, first);
        const auto measured = K::template measure<SweepDual>(e.parameters, m[0], m[1]);
        for (int j = first; j < std::min(columns.total, first + sweep_width); ++j) {
          derivative[j] = measured.value.d[j - first];
          derivative[columns.total + j] = measured.rate.d[j - first];
        }
      }
      set_jacobian(e, columns, ports.jacobian(e.marker));
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    set_wrenches(ports);
    bodies_.pull_back(evaluation, r);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    set_wrenches(ports);
    std::span<const int> slot = slots;
    for (const Entry& e : entries_) {
      const Columns<2> columns(bodies_.ports, e.bodies);
      const SweepDual force(*ports.force(e.marker));
      for (int first = 0; first < columns.total; first += sweep_width) {
        const auto m = e.moving_frames(bodies_.ports, columns, first);
        scatter_forces<RigidPort, 2>(bodies_.ports, e.bodies, columns, first, -1.0,
                                     K::template forces<SweepDual>(e.parameters, m[0], m[1], force), slot.data(),
                                     values);
      }
      slot = slot.subspan(static_cast<std::size_t>(columns.total * columns.total));
    }
    bodies_.geometric(evaluation, weights, slot, values);
  }

  void post_newton(const Evaluation&, const Ports& ports, double* data) const override {
    for (const Entry& e : entries_)
      if (e.first_data >= 0) data[e.first_data] = ports.frame(e.marker)[0];
  }
  bool has_history() const override {
    return std::ranges::any_of(entries_, [](const Entry& e) { return e.first_data >= 0; });
  }
  // The motion of the first body.
  bool motion(int entry, const Evaluation& evaluation, Motion<double>& m) const override {
    return bodies_.motion(entries_[entry].bodies[0], evaluation, m);
  }

 private:
  struct Entry {
    typename K::Parameters parameters;
    std::array<int, 2> bodies{};  // ports of the bodies' frames
    int marker = -1, first_data = -1;

    std::array<RigidFrame<double>, 2> frames(const Ports& ports) const {
      return {read_frame<RigidPort>(ports, bodies[0]), read_frame<RigidPort>(ports, bodies[1])};
    }
    std::array<RigidFrame<SweepDual>, 2> moving_frames(const Ports& ports, const Columns<2>& columns, int first) const {
      return {read_moving_frame<RigidPort>(ports, bodies[0], columns.offset[0], first),
              read_moving_frame<RigidPort>(ports, bodies[1], columns.offset[1], first)};
    }
    // The angle next to the last one.
    double continued(const Evaluation& evaluation, double angle) const {
      if (first_data < 0) return angle;
      const double turn = 2 * std::numbers::pi;
      return angle - turn * std::round((angle - evaluation.data[first_data]) / turn);
    }
  };

  static int data_of(const typename K::Parameters& p, const Placement& placement) {
    if constexpr (requires { p.nodeNumber; })
      if (p.nodeNumber.valid()) return placement.first_data;
    return -1;
  }

  void set_wrenches(const Ports& ports) const {
    bodies_.clear_forces();
    for (const Entry& e : entries_) {
      const auto m = e.frames(bodies_.ports);
      add_forces<RigidPort, 2>(bodies_.ports, e.bodies, 1.0,
                               K::template forces<double>(e.parameters, m[0], m[1], *ports.force(e.marker)));
    }
  }
  void set_jacobian(const Entry& e, const Columns<2>& columns, double* jacobian) const {
    const auto m = e.frames(bodies_.ports);
    const auto unit = K::template forces<double>(e.parameters, m[0], m[1], 1.0);
    for (int k = 0; k < 2; ++k) {
      const int n = bodies_.ports.ports[e.bodies[k]].n;
      const double* of_body = bodies_.ports.jacobian(e.bodies[k]);
      const double* wrench = reinterpret_cast<const double*>(&unit[k]);
      for (int j = 0; j < n; ++j) {
        double sum = 0;
        for (int f = 0; f < RigidPort::forces; ++f) sum += of_body[f * n + j] * wrench[f];
        jacobian[columns.offset[k] + j] = sum;
      }
    }
  }

  std::vector<Entry> entries_;
  mutable InnerMarkers bodies_;  // its ports are work space
};

}  // namespace dalembert
