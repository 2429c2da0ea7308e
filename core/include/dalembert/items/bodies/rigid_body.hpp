// ObjectRigidBody, specs/bodies/rigid_body.toml
#pragma once

#include "dalembert/bodies/rigid_body_parameters.hpp"
#include "dalembert/contracts/element.hpp"
#include "dalembert/model/value_checks.hpp"

namespace dalembert {

struct ObjectRigidBody : NoElementOutputs {
  using Parameters = ObjectRigidBodyParameters;
  static constexpr BodyTraits traits{.constant_mass = true};

  static void check(const Parameters& p, const ItemLabel& item) {
    check_inertia(p.physicsMass, inertia_tensor(p), p.physicsCenterOfMass, item);
  }
  static std::string doubt(const Parameters& p) {
    return judge_inertia(p.physicsMass, inertia_tensor(p), p.physicsCenterOfMass).problem;
  }

  static double mass(const Parameters& p) { return p.physicsMass; }
  static const Vec3<double>& centre(const Parameters& p) { return p.physicsCenterOfMass; }
  static MassProperties<double> mass_properties(const Parameters& p) {
    return {p.physicsMass, p.physicsInertia, p.physicsCenterOfMass};
  }

  // Newton-Euler equations about the node, for any rotation coordinates of the node.
  template <class T, class S>
  static SpinWrench<S> inertia(const MassProperties<T>& b, const SpinMotion<S>& node) {
    SpinWrench<S> w{.force = b.mass * node.acceleration,
                    .moment = tensor(b, node.spin_rate) + cross(node.spin, tensor(b, node.spin))};
    if (b.eccentric()) {
      w.force += node.rotation * swing(b, node);
      w.moment += b.mass * cross(b.centre, transposed_times(node.rotation, node.acceleration));
    }
    return w;
  }
  static InertiaTangent inertia_tangent(const MassProperties<double>& b, const SpinMotion<double>& node) {
    const Vec3<double>&w = node.spin, &c = b.centre;
    const auto& j = b.tensor;
    InertiaTangent t{.mass = b.mass, .eccentric = b.eccentric()};
    t.moment_by_spin_rate = {j[0], j[5], j[4], j[5], j[1], j[3], j[4], j[3], j[2]};
    t.moment_by_spin = skew(w) * t.moment_by_spin_rate - skew(tensor(b, w));
    if (t.eccentric) {
      const Mat3<double> lever = b.mass * skew(c);
      t.swing = swing(b, node);
      t.swing_by_spin_rate = -1.0 * lever;
      t.swing_by_spin = -1.0 * (b.mass * skew(cross(w, c)) + skew(w) * lever);
      t.moment_by_acceleration = lever;
    }
    return t;
  }

 private:
  static Mat3<double> inertia_tensor(const Parameters& p) {
    const auto& j = p.physicsInertia;
    return {j[0], j[5], j[4], j[5], j[1], j[3], j[4], j[3], j[2]};
  }

  // Inertia force of an eccentric centre of mass, in own axes, without the acceleration of the node.
  template <class T, class S>
  static Vec3<S> swing(const MassProperties<T>& b, const SpinMotion<S>& node) {
    const Vec3<T>& c = b.centre;
    return b.mass * (cross(node.spin_rate, c) + cross(node.spin, cross(node.spin, c)));
  }
  template <class T, class S>
  static Vec3<S> tensor(const MassProperties<T>& b, const Vec3<S>& x) {
    const auto& j = b.tensor;
    return {j[0] * x[0] + j[5] * x[1] + j[4] * x[2], j[5] * x[0] + j[1] * x[1] + j[3] * x[2],
            j[4] * x[0] + j[3] * x[1] + j[2] * x[2]};
  }
};

}  // namespace dalembert
