// Bodies on rotating nodes: they read the motion that the node has found, and leave their inertia forces there.
#pragma once

#include "dalembert/batches/element.hpp"

namespace dalembert {

// Adds the derivative of the inertia forces by values[slot[row * n + column]]. The wrench is held fixed in the maps to
// coordinates: that part is the node's.
template <SpinBody Body, RotatingNode Node>
void add_inertia_tangent(const typename Body::Parameters& p, const SpinMotion<double>& motion, const RotationTangent<Node::size - 3>& t,
                         const Weights& w, const int* slot, double* values) {
  constexpr int n = Node::size, r = n - 3;
  const InertiaTangent b = Body::inertia_tangent(p, motion);
  const auto add = [&](int row, int column, double x) { values[slot[row * n + column]] += x; };
  for (int i = 0; i < 3; ++i) add(i, i, w.a * b.mass);
  Mat<double, 3, r> moment = b.moment_by_spin * t.spin_tangent + b.moment_by_spin_rate * t.spin_rate_tangent;  // in own axes
  if (b.eccentric) {
    const Mat<double, 3, r> swing = t.rotation * (b.swing_by_spin * t.spin_tangent + b.swing_by_spin_rate * t.spin_rate_tangent);
    for (int j = 0; j < r; ++j) {
      const Vec3<double> turned = t.turn[j] * b.swing;
      const Vec3<double> lever = b.moment_by_acceleration * transposed_times(t.turn[j], motion.acceleration);
      for (int i = 0; i < 3; ++i) {
        add(i, 3 + j, turned[i] + swing(i, j));
        moment(i, j) += lever[i];
      }
    }
    const Mat<double, r, 3> by_acceleration = transpose(t.spin_map) * (b.moment_by_acceleration * transpose(t.rotation));
    for (int i = 0; i < r; ++i)
      for (int j = 0; j < 3; ++j) add(3 + i, j, w.a * by_acceleration(i, j));
  }
  const Mat<double, r, r> turning = transpose(t.spin_map) * moment;
  for (int i = 0; i < r; ++i)
    for (int j = 0; j < r; ++j) add(3 + i, 3 + j, turning(i, j));
}

template <class E, class Record>
class TurningBodyBatch final : public ElementBatch<E, Record> {
  using Base = ElementBatch<E, Record>;
  using typename Base::Entry;
  using Base::entries_, Base::n;
  using Body = typename E::Kernel;
  using Node = typename E::Turning;

 public:
  void residual(const Evaluation&, Ports& ports, double*) const override {
    in_widest_registers([&] {
      for (const Entry& e : entries_) {
        const auto w = Body::template inertia<double>(e.parameters, ports.node_motions[e.node].spin_motion);
        NodeLoad& load = ports.node_loads[e.node];
        load.force -= w.force;
        load.own_moment -= w.moment;
      }
    });
  }
  void tangent(const Evaluation&, const Weights& weights, Ports& ports, double* values) const override {
    const int* slot = this->slots.data();
    in_widest_registers([&] {
      for (const Entry& e : entries_) {
        add_inertia_tangent<Body, Node>(e.parameters, ports.node_motions[e.node].spin_motion, ports.template rotation<n - 3>(e.node),
                                        weights, slot, values);
        slot += n * n;
      }
    });
  }
  // Of any state: the nodes need not have been evaluated.
  void mass(const Evaluation& evaluation, Ports&, double* values) const override {
    constexpr Weights weights{.q = 0, .v = 0, .a = 1, .y = 0, .y_t = 0};
    const int* slot = this->slots.data();
    for (const Entry& e : entries_) {
      const auto x = gather<n>(evaluation, e.dofs.data());
      add_inertia_tangent<Body, Node>(e.parameters, Node::template spin_motion<double>(x), Node::rotation_tangent(x, weights), weights, slot,
                                      values);
      slot += n * n;
    }
  }
};

}  // namespace dalembert
