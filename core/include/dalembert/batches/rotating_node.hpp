// Rotating nodes: they find their motion for the bodies and markers on them, and map the sum of their forces to coordinates.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "dalembert/batches/groups.hpp"
#include "dalembert/contracts/element.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

template <RotatingNode Node, class S>
NodeMotionOf<S> node_motion(const Coordinates<S, Node::size>& x) {
  const SpinMotion<S> own = Node::template spin_motion<S>(x);
  // also computed by `motion`
  if constexpr (LieKernel<Node>)
    return {own.spin, own.spin_rate, own.rotation, own.rotation * own.spin};
  else
    return {own.spin, own.spin_rate, own.rotation, Node::template motion<S>(x).angular_velocity};
}
// Derivative of the generalised forces of a fixed load with respect to the rotation coordinates, in their rows.
template <RotatingNode Node>
Mat<double, Node::size - 3, Node::size - 3> load_tangent(const NodeLoad& load, const PointForces& beside,
                                                         const Coordinates<double, Node::size>& x,
                                                         const RotationTangent<Node::size - 3>& t, const Weights& w) {
  constexpr int r = Node::size - 3;
  const Vec3<double> moment = load.beside == 0 ? load.own_moment : load.own_moment + beside.moment(t.rotation);
  Mat<double, r, r> k = Node::moment_tangent(x, moment, load.moment, w);
  for (int j = 0; j < r && load.beside != 0; ++j) {
    const Vec3<double> turned = beside.moment(t.turn[j]);
    for (int i = 0; i < r; ++i)
      k(i, j) += t.spin_map(0, i) * turned[0] + t.spin_map(1, i) * turned[1] + t.spin_map(2, i) * turned[2];
  }
  return k;
}

// Nodes that bodies and markers turn with.
template <RotatingNode Node>
class RotatingNodes final : public RotatingNodeBatch {
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
    each_group<NodeInPacks<Node>>(0, entries_.size(), [&]<int L>(const Group<L>& group) {
      const auto places =
          group.each([&](std::size_t i) { return reinterpret_cast<double*>(&ports.node_motions[entries_[i].node]); });
      store_numbers(node_motion<Node>(coordinates(evaluation, group)).numbers(), places);
    });
  }
  bool reads_totals() const override { return !LieKernel<Node>; }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    in_wide_registers([&] {
      for (const Entry& e : entries_)
        ports.template rotation<turns>(e.node) = Node::rotation_tangent(gather<n>(evaluation, e.dofs.data()), weights);
    });
  }
  void pull_back(const Evaluation& evaluation, const Ports& ports, double* r) const override {
    each_group<NodeInPacks<Node>>(0, entries_.size(), [&]<int L>(const Group<L>& group) {
      using S = Numbers<L>;
      const auto load =
          gathered<NodeLoadOf>(group.each([&](std::size_t i) { return &ports.node_loads[entries_[i].node]; }));
      const auto rotation = gathered<9>(
          group.each([&](std::size_t i) { return ports.node_motions[entries_[i].node].rotation.x.data(); }));
      Vec3<S> own_moment = load.own_moment;
      if (!is_zero(load.beside)) {
        const auto beside = gathered<PointForcesOf>(
            group.each([&](std::size_t i) { return &std::as_const(ports.point_forces[entries_[i].node]); }));
        const Vec3<S> moment = beside.moment({rotation.x});
        for (int i = 0; i < 3; ++i) own_moment[i] = own_moment[i] + only_where(load.beside, moment[i]);
      }
      Vec<S, n> change;
      if constexpr (LieKernel<Node>) {  // the rates of its rotation are the spin
        change = joined(-load.force, -(own_moment + transposed_times(Mat3<S>{rotation.x}, load.moment)));
      } else {
        const Coordinates<S, n> x = coordinates(evaluation, group);
        const Vec<S, n> q = Node::template pull_back<S>(x, load.force, load.moment);
        const auto turn = Node::template pull_back_spin<S>(x, own_moment);
        change = vector_of<n>([&](int i) { return i < 3 ? -q[i] : -(q[i] + turn[std::max(i - 3, 0)]); });
      }
      add_numbers(change, group.each([&](std::size_t i) { return r + entries_[i].dofs[0]; }), group.count);
    });
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, Ports& ports, double* values) const override {
    SlotCursor slot(slots.data(), values);
    in_wide_registers([&] {
      for (const Entry& e : entries_) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        const auto k = load_tangent<Node>(ports.node_loads[e.node], ports.point_forces[e.node], x,
                                          ports.template rotation<turns>(e.node), weights);
        for (const double entry : k.x) slot.add(-entry);
      }
    });
  }

 private:
  struct Entry {
    int node = 0;
    std::array<int, n> dofs{};  // follow each other
  };
  template <int L>
  Coordinates<Numbers<L>, n> coordinates(const Evaluation& evaluation, const Group<L>& group) const {
    const auto of = [&](const double* from) {
      return gathered<n>(group.each([&](std::size_t i) { return from + entries_[i].dofs[0]; }));
    };
    const bool adds_up = evaluation.reads_nodes && !reads_totals();
    auto totals = of(adds_up ? evaluation.reference : evaluation.q);
    if (adds_up) totals += of(evaluation.u);
    return {totals, of(evaluation.v), evaluation.inertia ? of(evaluation.a) : Vec<Numbers<L>, n>{}};
  }

  std::vector<Entry> entries_;
};

}  // namespace dalembert
