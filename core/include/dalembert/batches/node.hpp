// Nodes: coordinates, outputs, conditions of their own and the markers that sit on them.
#pragma once

#include <memory>

#include "dalembert/batches/frame_marker.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

// The equations that a node imposes on its own coordinates, e.g. unit length of Euler parameters.
template <class Node>
class NodeConditionBatch final : public Term {
 public:
  static constexpr int n = Node::size, m = Node::equations;

  void add(const void*, const Placement& placement, const Ports&) override {
    Entry e;
    for (int i = 0; i < n; ++i) e.dofs[i] = placement.dofs[i];
    for (int k = 0; k < m; ++k) e.rows[k] = placement.ae_offset + placement.first_ae + k;
    e.first_ae = placement.first_ae;
    entries_.push_back(e);
  }
  void refresh(int, const void*) override {}
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) {
      visitor.block(e.rows, e.dofs);
      visitor.block(e.dofs, e.rows);
      visitor.block(e.dofs, e.dofs);
    }
  }
  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    for (const Entry& e : entries_) {
      const auto x = gather<n>(evaluation, e.dofs.data());
      const auto gap = Node::template gap<double>(x.q);
      const auto jacobian = Node::template gap_jacobian<double>(x.q);
      const double* lambda = evaluation.lambda + e.first_ae;
      for (int k = 0; k < m; ++k) {
        double rate = 0;
        for (int j = 0; j < n; ++j) {
          rate += jacobian(k, j) * x.v[j];
          r[e.dofs[j]] += jacobian(k, j) * lambda[k];
        }
        r[e.rows[k]] += evaluation.rate_level ? rate : gap[k];
      }
    }
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    const double row_scale = 1 / (weights.q != 0 ? weights.q : weights.v);
    for (const Entry& e : entries_) {
      const auto x = gather<n>(evaluation, e.dofs.data());
      const auto jacobian = Node::template gap_jacobian<double>(x.q);
      const auto moving = Node::template gap_jacobian<Dual<n>>(seeded<Node>(x, weights).q);
      const double* lambda = evaluation.lambda + e.first_ae;
      for (int k = 0; k < m; ++k)
        for (int j = 0; j < n; ++j) {
          double entry = jacobian(k, j) * (evaluation.rate_level ? weights.v : weights.q);
          if (evaluation.rate_level)
            for (int i = 0; i < n; ++i) entry += moving(k, i).d[j] * x.v[i];
          slot.add(entry * row_scale);
        }
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < m; ++k) slot.add(jacobian(k, j));
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          double entry = 0;
          for (int k = 0; k < m; ++k) entry += moving(k, i).d[j] * lambda[k];
          slot.add(entry);
        }
    }
  }

 private:
  struct Entry {
    std::array<int, n> dofs{};
    std::array<int, m> rows{};
    int first_ae = 0;
  };
  std::vector<Entry> entries_;
};

// A node without coordinates: it rests where its parameters say, and is an element by itself.
template <class Node, class Record>
  requires(Node::size == 0)
struct RestingNodePhysics final : NodePhysics {
  Sizes sizes(const void*) const override { return {}; }
  void values(const void*, NodeValues&) const override {}
  std::unique_ptr<MarkerBatch> make_marker(FrameShape shape) const override { return make_frame_marker<Node, Record>(shape); }
  bool motion(const void* record, const NodeView&, Motion<double>& m) const override {
    m = Node::template motion<double>(static_cast<const Record*>(record)->parameters, {}, {});
    return true;
  }
};

template <class Node, class Record>
struct MovingNodePhysics final : NodePhysics {
  static_assert(NodeKernel<Node>, "see core/include/dalembert/contracts/element.hpp");

  Sizes sizes(const void* record) const override {
    const auto& p = static_cast<const Record*>(record)->parameters;
    if constexpr (requires { p.addConstraintEquation; })
      if (!p.addConstraintEquation) return {.ode2 = Node::size};
    return {.ode2 = Node::size, .ae = equations()};
  }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = static_cast<const Record*>(record)->parameters;
    values.reference = list(p.referenceCoordinates);
    values.displacement = list(p.initialCoordinates);
    values.velocity = list(p.initialVelocities);
    values.algebraic.assign(static_cast<std::size_t>(sizes(record).ae), 0.0);
  }
  int lie_rotation() const override {
    if constexpr (LieKernel<Node>) return Node::lie_rotation;
    return -1;
  }
  int translations() const override { return Node::translations; }
  std::unique_ptr<Term> make_condition() const override {
    if constexpr (equations() > 0) return std::make_unique<NodeConditionBatch<Node>>();
    return nullptr;
  }
  std::unique_ptr<MarkerBatch> make_marker(FrameShape shape) const override {
    return make_frame_marker<AtNode<Node>, void>(shape);
  }
  bool motion(const void*, const NodeView& view, Motion<double>& m) const override {
    Coordinates<double, Node::size> x;
    for (int i = 0; i < Node::size; ++i) x.q[i] = view.q[i], x.v[i] = view.v[i], x.a[i] = view.a[i];
    m = Node::template motion<double>(x);
    return true;
  }
  bool output(const void*, OutputVariableType variable, const NodeView& view, std::vector<double>& values) const override {
    if constexpr (requires { Node::output(variable, view, values); }) return Node::output(variable, view, values);
    return false;
  }

 private:
  template <int N>
  static std::vector<double> list(const Vec<double, N>& v) {
    return {v.x.begin(), v.x.end()};
  }
  // Of any length in the spec; the node has its own.
  static std::vector<double> list(const std::vector<double>& v) {
    std::vector<double> r = v;
    r.resize(Node::size);
    return r;
  }
  static constexpr int equations() {
    if constexpr (requires { Node::equations; }) return Node::equations;
    return 0;
  }
};

namespace detail {
template <class Node, class Record, bool Rests>
struct ChooseNodePhysics {
  using Type = MovingNodePhysics<Node, Record>;
};
template <class Node, class Record>
struct ChooseNodePhysics<Node, Record, true> {
  using Type = RestingNodePhysics<Node, Record>;
};
}  // namespace detail

template <class Node, class Record>
using NodePhysicsOf = typename detail::ChooseNodePhysics<Node, Record, Node::size == 0>::Type;

}  // namespace dalembert
