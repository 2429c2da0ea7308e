// Markers on planar nodes and bodies: a sine and a cosine per evaluation, and closed forms.
#pragma once

#include "dalembert/batches/frame_marker.hpp"
#include "dalembert/contracts/planar_node.hpp"

namespace dalembert {

template <class E, class OwnerRecord, template <class> class ShapeOf>
class PlanarMarkerBatch final : public FrameMarkerBatch<E, OwnerRecord, ShapeOf> {
  using Base = FrameMarkerBatch<E, OwnerRecord, ShapeOf>;
  using Base::entries_, Base::n;
  using typename Base::Entry, typename Base::Shape;

 public:
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (turns)
      for (const Entry& e : entries_) visitor.entry(e.dofs[2], e.dofs[2]);
  }
  void evaluate(const Evaluation& evaluation, Ports& ports) const override { find_frames(evaluation, ports); }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    differentiate(evaluation, weights, ports);
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    subtract_forces(evaluation, ports, r);
  }
  bool constant_pull_back(bool) const override {
    return !turns || std::ranges::all_of(entries_, [this](const Entry& e) { return at_node(e); });
  }
  bool passes_constantly(int entry, bool) const override {
    return !turns || at_node(entries_[static_cast<std::size_t>(entry)]);
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports,
                 double* values) const override {
    add_geometric(evaluation, weights, ports, values);
  }
  bool traceable() const override { return true; }
  void trace(const TracedCall& call) const override {
    const auto& [function, evaluation, weights, ports, sums] = call;
    switch (function) {
      case TracedCall::Function::evaluate: return find_frames(evaluation, ports);
      case TracedCall::Function::evaluate_tangent: return differentiate(evaluation, weights, ports);
      case TracedCall::Function::pull_back: return subtract_forces(evaluation, ports, sums);
      default: return add_geometric(evaluation, weights, ports, sums);
    }
  }

 private:
  bool at_node(const Entry& e) const { return point(e)[0] == 0 && point(e)[1] == 0; }

  template <class S>
  void find_frames(const EvaluationOf<S>& evaluation, PortsOf<S>& ports) const {
    if constexpr (Shape::values > 0) {
      int angle = -1;  // angle of the previous marker: several markers on one body are consecutive
      PlanarRotation<S> r;
      for (const Entry& e : entries_) {
        Coordinates<S, n> x;  // accelerations play no part
        for (int i = 0; i < n; ++i) {
          x.q[i] = evaluation.q[e.dofs[i]];
          x.v[i] = evaluation.v[e.dofs[i]];
        }
        const Vec3<double> local = point(e);
        auto* frame = reinterpret_cast<typename Shape::template Frame<S>*>(ports.values.data() + e.port.value);
        if constexpr (Shape::values == 6) {
          *frame = planar_point(x, arm(e, evaluation, ports), local[2]);
        } else {
          if constexpr (n == 3)
            if (angle != e.dofs[2]) {
              angle = e.dofs[2];
              r = PlanarRotation<S>::by(x.q[2]);
            }
          *frame = planar_frame(x, r, r.arm(local), local[2]);
        }
      }
    }
  }
  template <class S>
  void differentiate(const EvaluationOf<S>& evaluation, const Weights& weights, PortsOf<S>& ports) const {
    for (const Entry& e : entries_) {
      const Arm<S> a = arm(e, evaluation, ports);
      if constexpr (Shape::values > 0) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        PlanarRotation<S> r;
        if constexpr (keeps_rotation) r = kept_rotation(e, ports);
        write_planar_frame_tangent<Shape::values>(x, r, a, weights, ports.derivative(e.marker));
      }
      write_planar_force_map<Shape::forces, n>(a, Shape::scale(this->parameters(e)), ports.jacobian(e.marker));
    }
  }
  template <class S>
  void subtract_forces(const EvaluationOf<S>& evaluation, const PortsOf<S>& ports, S* r) const {
    for (const Entry& e : entries_) {
      const Arm<S> f = force(e, ports);
      r[e.dofs[0]] -= f[0];
      r[e.dofs[1]] -= f[1];
      if constexpr (n == 3) {
        S moment = 0;
        if constexpr (Shape::forces == 6) moment = ports.forces[static_cast<std::size_t>(e.port.force) + 5];
        if constexpr (turns) {
          const Arm<S> a = arm(e, evaluation, ports);
          moment += a[0] * f[1] - a[1] * f[0];
        }
        r[e.dofs[2]] -= moment;
      }
    }
  }
  template <class S>
  void add_geometric(const EvaluationOf<S>& evaluation, const Weights& weights, const PortsOf<S>& ports,
                     S* values) const {
    if constexpr (turns) {
      SlotCursorOf slot(this->slots.data(), values);
      for (const Entry& e : entries_) slot.add(weights.q * dot(arm(e, evaluation, ports), force(e, ports)));
    }
  }

  static constexpr bool on_node = E::traits.constant_jacobian;  // no lever arm
  static constexpr bool turns = n == 3 && !on_node;
  static constexpr bool keeps_rotation = Shape::values == 18;  // stored in the port

  Vec3<double> point(const Entry& e) const {
    if constexpr (on_node)
      return {};
    else
      return Shape::point(this->parameters(e), e.local);
  }
  template <class S>
  Arm<S> force(const Entry& e, const PortsOf<S>& ports) const {
    const S* f = ports.forces.data() + e.port.force;
    return Shape::scale(this->parameters(e)) * Arm<S>{f[0], f[1]};
  }
  template <class S>
  static PlanarRotation<S> kept_rotation(const Entry& e, const PortsOf<S>& ports) {
    return PlanarRotation<S>::of(*reinterpret_cast<const RigidFrame<S>*>(ports.values.data() + e.port.value));
  }
  template <class S>
  Arm<S> arm(const Entry& e, const EvaluationOf<S>& evaluation, const PortsOf<S>& ports) const {
    const Vec3<double> local = point(e);
    if constexpr (!turns)
      return {local[0], local[1]};
    else if (local[0] == 0 && local[1] == 0)
      return {};
    else if constexpr (keeps_rotation)
      return kept_rotation(e, ports).arm(local);
    else
      return PlanarRotation<S>::by(evaluation.q[e.dofs[2]]).arm(local);
  }
};

}  // namespace dalembert
