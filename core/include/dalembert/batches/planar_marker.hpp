// Markers on planar nodes and bodies: a sine and a cosine per evaluation, and closed forms.
#pragma once

#include "dalembert/batches/frame_marker.hpp"
#include "dalembert/contracts/planar_node.hpp"

namespace dalembert {

template <class E, class OwnerRecord, template <class> class ShapeOf>
class PlanarMarkerBatch final : public FrameMarkerBatch<E, OwnerRecord, ShapeOf> {
  using Base = FrameMarkerBatch<E, OwnerRecord, ShapeOf>;
  using typename Base::Entry, typename Base::Shape;
  using Base::entries_, Base::n;

 public:
  void visit(BlockVisitor& visitor, const Ports&) const override {
    if constexpr (turns)
      for (const Entry& e : entries_) visitor.entry(e.dofs[2], e.dofs[2]);
  }
  void evaluate(const Evaluation& evaluation, Ports& ports) const override {
    if constexpr (Shape::values > 0) {
      int angle = -1;  // of the marker before: several on one body follow each other
      PlanarRotation r;
      for (const Entry& e : entries_) {
        Coordinates<double, n> x;  // accelerations play no part
        for (int i = 0; i < n; ++i) {
          x.q[i] = evaluation.q[e.dofs[i]];
          x.v[i] = evaluation.v[e.dofs[i]];
        }
        const Vec3<double> local = point(e);
        auto* frame = reinterpret_cast<typename Shape::template Frame<double>*>(ports.values.data() + e.port.value);
        if constexpr (Shape::values == 6) {
          *frame = planar_point(x, arm(e, evaluation, ports), local[2]);
        } else {
          if constexpr (n == 3)
            if (angle != e.dofs[2]) {
              angle = e.dofs[2];
              r = PlanarRotation::by(x.q[2]);
            }
          *frame = planar_frame(x, r, r.arm(local), local[2]);
        }
      }
    }
  }
  void evaluate_tangent(const Evaluation& evaluation, const Weights& weights, Ports& ports) const override {
    for (const Entry& e : entries_) {
      const Arm a = arm(e, evaluation, ports);
      if constexpr (Shape::values > 0) {
        const auto x = gather<n>(evaluation, e.dofs.data());
        PlanarRotation r;
        if constexpr (keeps_rotation) r = kept_rotation(e, ports);
        write_planar_frame_tangent<Shape::values>(x, r, a, weights, ports.derivative(e.marker));
      }
      write_planar_force_map<Shape::forces, n>(a, Shape::scale(e.parameters), ports.jacobian(e.marker));
    }
  }
  void pull_back(const Evaluation& evaluation, Ports& ports, double* r) const override {
    for (const Entry& e : entries_) {
      const Arm f = force(e, ports);
      r[e.dofs[0]] -= f[0];
      r[e.dofs[1]] -= f[1];
      if constexpr (n == 3) {
        double moment = 0;
        if constexpr (Shape::forces == 6) moment = ports.forces[static_cast<std::size_t>(e.port.force) + 5];
        if constexpr (turns) {
          const Arm a = arm(e, evaluation, ports);
          moment += a[0] * f[1] - a[1] * f[0];
        }
        r[e.dofs[2]] -= moment;
      }
    }
  }
  void geometric(const Evaluation& evaluation, const Weights& weights, const Ports& ports, double* values) const override {
    if constexpr (turns) {
      SlotCursor slot(this->slots.data(), values);
      for (const Entry& e : entries_) slot.add(weights.q * dot(arm(e, evaluation, ports), force(e, ports)));
    }
  }

 private:
  static constexpr bool on_node = requires { requires E::constant_jacobian; };  // without an arm
  static constexpr bool turns = n == 3 && !on_node;
  static constexpr bool keeps_rotation = Shape::values == 18;  // in the port

  static Vec3<double> point(const Entry& e) {
    if constexpr (on_node) return {};
    else return Shape::point(e.parameters, e.local);
  }
  static Arm force(const Entry& e, const Ports& ports) {
    const double* f = ports.forces.data() + e.port.force;
    return Shape::scale(e.parameters) * Arm{f[0], f[1]};
  }
  static PlanarRotation kept_rotation(const Entry& e, const Ports& ports) {
    return PlanarRotation::of(*reinterpret_cast<const RigidFrame<double>*>(ports.values.data() + e.port.value));
  }
  static Arm arm(const Entry& e, const Evaluation& evaluation, const Ports& ports) {
    const Vec3<double> local = point(e);
    if constexpr (!turns) return {local[0], local[1]};
    else if (local[0] == 0 && local[1] == 0) return {};
    else if constexpr (keeps_rotation) return kept_rotation(e, ports).arm(local);
    else return PlanarRotation::by(evaluation.q[e.dofs[2]]).arm(local);
  }
};

}  // namespace dalembert
