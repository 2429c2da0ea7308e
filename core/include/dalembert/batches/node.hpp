// Nodes: coordinates, outputs, conditions of their own and the markers that sit on them.
#pragma once

#include <memory>

#include "dalembert/batches/make_frame_marker.hpp"
#include "dalembert/batches/rotating_node.hpp"
#include "dalembert/system/physics.hpp"
#include "dalembert/system/unit_vectors.hpp"

namespace dalembert {

// Constraint of a node on its own coordinates: those from `unit_from` on are a unit vector x, x x - 1 = 0.
template <class Node>
class UnitLengthBatch final : public Term, public UnitVectors {
 public:
  static constexpr int n = Node::size - Node::traits.unit_from;

  void add(const void*, const Placement& placement, const Ports&) override {
    Entry e;
    for (int i = 0; i < n; ++i) e.dofs[i] = placement.dofs[Node::traits.unit_from + i];
    e.row = placement.ae_offset + placement.first_ae;
    e.first_ae = placement.first_ae;
    entries_.push_back(e);
  }
  void refresh(int, const void*) override {}
  void visit(BlockVisitor& visitor, const Ports&) const override {
    for (const Entry& e : entries_) {
      visitor.block({&e.row, 1}, e.dofs);
      visitor.mirror({&e.row, 1}, e.dofs);
      for (const int dof : e.dofs) visitor.entry(dof, dof);
    }
  }
  void residual(const Evaluation& evaluation, Ports&, double* r) const override {
    each_group(0, entries_.size(), [&]<int L>(const Group<L>& group) {
      using S = Numbers<L>;
      const auto of_node = [&](auto* list) {
        return group.each([&, list](std::size_t i) { return list + entries_[i].dofs[0]; });
      };
      const auto x = gathered<n>(of_node(evaluation.q));
      const S lambda = group.numbers([&](std::size_t i) { return evaluation.lambda[entries_[i].first_ae]; });
      const Vec<S, n> reaction = (2.0 * lambda) * x;
      add_numbers(reaction, of_node(r), group.count);
      const S gap = evaluation.rate_level ? 2.0 * dot(x, gathered<n>(of_node(evaluation.v))) : dot(x, x) - 1.0;
      add_numbers(Vec<S, 1>{gap}, group.each([&](std::size_t i) { return r + entries_[i].row; }), group.count);
    });
  }
  void tangent(const Evaluation& evaluation, const Weights& weights, Ports&, double* values) const override {
    SlotCursor slot(slots.data(), values);
    const double row_scale = 1 / (weights.q != 0 ? weights.q : weights.v);
    for (const Entry& e : entries_) {
      for (const int dof : e.dofs) {
        const double x = evaluation.q[dof], rate = evaluation.v[dof];
        slot.add(2 * row_scale * (evaluation.rate_level ? weights.v * x + weights.q * rate : weights.q * x));
      }
      for (const int dof : e.dofs) slot.add(2 * evaluation.q[dof]);
      for (int i = 0; i < n; ++i) slot.add(2 * weights.q * evaluation.lambda[e.first_ae]);
    }
  }
  void list(std::vector<UnitVector>& vectors) const override {
    for (const Entry& e : entries_) vectors.push_back({e.dofs[0], n});
  }

 private:
  struct Entry {
    std::array<int, n> dofs{};  // follow each other
    int row = 0;
    int first_ae = 0;
  };
  std::vector<Entry> entries_;
};

// A node without coordinates: it is fixed at the position of its parameters, and is an element of its own.
template <class Node, class Record>
  requires(Node::size == 0)
struct RestingNodePhysics final : NodePhysics {
  Sizes sizes(const void*) const override { return {}; }
  void values(const void*, NodeValues&) const override {}
  std::unique_ptr<MarkerBatch> make_marker(FrameShape shape) const override {
    return make_frame_marker<Node, Record>(shape);
  }
  bool motion(const void* record, const NodeView&, Motion<double>& m) const override {
    m = Node::template motion<double>(static_cast<const Record*>(record)->parameters, {}, {});
    return true;
  }
};

template <class Node, class Record>
struct MovingNodePhysics final : NodePhysics {
  static_assert(NodeKernel<Node>, "see core/include/dalembert/contracts/element.hpp");

  void check_values(const void* record, const ItemLabel& item) const override {
    const auto& p = static_cast<const Record*>(record)->parameters;
    if constexpr (requires { p.referenceCoordinates.size(); }) {
      check_length(p.referenceCoordinates.size(), "referenceCoordinates", item);
      check_length(p.initialCoordinates.size(), "initialCoordinates", item);
      check_length(p.initialVelocities.size(), "initialVelocities", item);
    }
    Node::check(p, item);
  }
  Sizes sizes(const void* record) const override {
    const auto& p = static_cast<const Record*>(record)->parameters;
    if constexpr (requires { p.addConstraintEquation; })
      if (!p.addConstraintEquation) return {.ode2 = Node::size};
    return {.ode2 = Node::size, .ae = equations()};
  }
  void values(const void* record, NodeValues& values) const override {
    const auto& p = static_cast<const Record*>(record)->parameters;
    take(values.reference, p.referenceCoordinates);
    take(values.displacement, p.initialCoordinates);
    take(values.velocity, p.initialVelocities);
    values.algebraic.assign(static_cast<std::size_t>(sizes(record).ae), 0.0);
  }
  int lie_rotation() const override { return Node::traits.lie_rotation; }
  int translations() const override { return Node::traits.translations; }
  std::unique_ptr<Term> make_condition() const override {
    if constexpr (equations() > 0) return std::make_unique<UnitLengthBatch<Node>>();
    return nullptr;
  }
  std::unique_ptr<RotatingNodeBatch> make_rotating() const override {
    if constexpr (RotatingNode<Node>) return std::make_unique<RotatingNodes<Node>>();
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
  bool output(const void*, OutputVariableType variable, const NodeView& view,
              std::vector<double>& values) const override {
    return Node::output(variable, view, values);
  }

 private:
  template <int N>
  static void take(std::vector<double>& values, const Vec<double, N>& given) {
    values.assign(given.x.begin(), given.x.end());
  }
  // The spec allows any length; the node requires its own length, and replaces an empty vector by zeros.
  static void check_length(std::size_t given, const char* name, const ItemLabel& item) {
    if (given != 0 && given != Node::size)
      refuse(ErrorKind::value, {item, name, "", std::to_string(given) + " values", std::to_string(Node::size), ""});
  }
  static void take(std::vector<double>& values, const std::vector<double>& given) {
    values.assign(given.begin(), given.end());
    values.resize(Node::size);
  }
  static constexpr int equations() { return Node::traits.unit_from >= 0 ? 1 : 0; }
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
