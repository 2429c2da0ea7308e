// Rotating nodes: they find their motion for the bodies and markers on them, and map the sum of their forces to coordinates.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "dalembert/contracts/element.hpp"
#include "dalembert/math/wide_registers.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

template <RotatingNode Node>
NodeMotion node_motion(const Coordinates<double, Node::size>& x) {
  return {.position = segment<3>(x.q, 0),
          .velocity = segment<3>(x.v, 0),
          .spin_motion = Node::template spin_motion<double>(x),
          .angular_velocity = Node::template motion<double>(x).angular_velocity};
}
// Of the generalised forces of a load that is held fixed: by the rotation coordinates, in their rows.
template <RotatingNode Node>
Mat<double, Node::size - 3, Node::size - 3> load_tangent(const NodeLoad& load, const Coordinates<double, Node::size>& x,
                                                         const RotationTangent<Node::size - 3>& t, const Weights& w) {
  constexpr int r = Node::size - 3;
  Mat<double, r, r> k = Node::moment_tangent(x, load.own_moment + load.moment_of_forces(t.rotation), load.moment, w);
  for (int j = 0; j < r; ++j) {
    const Vec3<double> turned = load.moment_of_forces(t.turn[j]);
    for (int i = 0; i < r; ++i) k(i, j) += t.spin_map(0, i) * turned[0] + t.spin_map(1, i) * turned[1] + t.spin_map(2, i) * turned[2];
  }
  return k;
}

// Nodes that bodies and markers turn with.
template <RotatingNode Node>
class TurningNodeBatch final : public RotatingNodeBatch {
 public:
  static constexpr int n = Node::size, turns = n - 3;

  void add(const void*, const Placement& placement, const Ports&) override {
    Entry e{placement.rotating_node, {}};
    std::copy_n(placement.dofs.begin(), n, e.dofs.begin());
    entries_.push_back(e);
  }
  void refresh(int, const void*) override {}
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) {
      const auto rotation = std::span(e.dofs).template last<turns>();
      visitor.block(rotation, rotation);
    }
  }
  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    in_widest_registers([&] {
      for (const Entry& e : entries_) ports.node_motions[e.node] = node_motion<Node>(gather<n>(evaluation, e.dofs.data()));
    });
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    in_widest_registers([&] {
      for (const Entry& e : entries_)
        ports.template rotation<turns>(e.node) = Node::rotation_tangent(gather<n>(evaluation, e.dofs.data()), weights);
    });
  }
  void pull_back(const Evaluation& evaluation, const Ports& ports, double* r) const override {
    in_widest_registers([&] {
      for (const Entry& e : entries_) {
        const NodeLoad& load = ports.node_loads[e.node];
        const auto x = gather<n>(evaluation, e.dofs.data());
        const Vec3<double> own = load.own_moment + load.moment_of_forces(ports.node_motions[e.node].spin_motion.rotation);
        const auto q = Node::template pull_back<double>(x, load.force, load.moment);
        const auto turn = Node::template pull_back_spin<double>(x, own);
        for (int i = 0; i < 3; ++i) r[e.dofs[i]] -= q[i];
        for (int i = 3; i < n; ++i) r[e.dofs[i]] -= q[i] + turn[i - 3];
      }
    });
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override {
    SlotCursor slot(slots.data(), values);
    in_widest_registers([&] {
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        const auto k = load_tangent<Node>(ports.node_loads[e.node], x, ports.template rotation<turns>(e.node), weights);
        for (const double entry : k.x) slot.add(-entry);
      }
    });
  }

 private:
  struct Entry {
    int node = 0;
    std::array<int, n> dofs{};
  };
  std::vector<Entry> entries_;
};

}  // namespace dalembert
