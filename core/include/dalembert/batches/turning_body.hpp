// Bodies on rotating nodes: they read the motion that the node has found, and leave their inertia forces there.
#pragma once

#include "dalembert/batches/element.hpp"

namespace dalembert {

template <class E, class Record>
class TurningBodyBatch final : public ElementBatch<E, Record> {
  using Base = ElementBatch<E, Record>;
  using typename Base::Entry;
  using Base::entries_, Base::n;
  using Body = typename E::Kernel;
  using Node = typename E::Turning;

 public:
  void residual(const Evaluation&, Ports& ports, double*) const override {
    for (const Entry& e : entries_) {
      const auto w = Body::template inertia<double>(e.parameters, ports.node_motions[e.node].spin_motion);
      NodeLoad& load = ports.node_loads[e.node];
      load.force -= w.force;
      load.own_moment -= w.moment;
    }
  }
  void tangent(const Evaluation&, const Weights& weights, Ports& ports, double* values) const override {
    const int* slot = this->slots.data();
    for (const Entry& e : entries_) {
      const auto& rotation = ports.template rotation<n - 3>(e.node);
      Base::add(inertia_tangent<Body, Node>(e.parameters, ports.node_motions[e.node].spin_motion, rotation, weights), slot, values);
      slot += n * n;
    }
  }
  // Of any state: the nodes need not have been evaluated.
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    constexpr Weights weights{.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0};
    const int* slot = this->slots.data();
    for (const Entry& e : entries_) {
      const auto x = gather<n>(evaluation, e.dofs.data());
      Base::add(inertia_tangent<Body, Node>(e.parameters, Node::template spin_motion<double>(x), Node::rotation_tangent(x, weights), weights),
                slot, values);
      slot += n * n;
    }
  }
};

}  // namespace dalembert
