// ObjectRigidBody, specs/bodies/rigid_body.toml
#pragma once

#include "dalembert/bodies/rigid_body_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectRigidBody {
  using Parameters = ObjectRigidBodyParameters;
  static constexpr bool constant_mass = true;  // in the body frame; the node decides about its coordinates

  static double mass(const Parameters& p) { return p.physicsMass; }
  static const Vec3<double>& centre(const Parameters& p) { return p.physicsCenterOfMass; }

  // Newton-Euler equations about the node, for any rotation coordinates of the node.
  template <class S>
  static SpinWrench<S> inertia(const Parameters& p, const SpinMotion<S>& node) {
    SpinWrench<S> w{.force = p.physicsMass * node.acceleration,
                    .moment = tensor(p, node.spin_rate) + cross(node.spin, tensor(p, node.spin))};
    if (eccentric(p)) {
      w.force += node.rotation * swing(p, node);
      w.moment += p.physicsMass * cross(centre(p), transposed_times(node.rotation, node.acceleration));
    }
    return w;
  }
  static InertiaTangent inertia_tangent(const Parameters& p, const SpinMotion<double>& node) {
    const Vec3<double>&w = node.spin, &c = centre(p);
    const auto& j = p.physicsInertia;
    InertiaTangent t{.mass = p.physicsMass, .eccentric = eccentric(p)};
    t.moment_by_spin_rate = {j[0], j[5], j[4], j[5], j[1], j[3], j[4], j[3], j[2]};
    t.moment_by_spin = skew(w) * t.moment_by_spin_rate - skew(tensor(p, w));
    if (t.eccentric) {
      const Mat3<double> lever = p.physicsMass * skew(c);
      t.swing = swing(p, node);
      t.swing_by_spin_rate = -1.0 * lever;
      t.swing_by_spin = -1.0 * (p.physicsMass * skew(cross(w, c)) + skew(w) * lever);
      t.moment_by_acceleration = lever;
    }
    return t;
  }

 private:
  static bool eccentric(const Parameters& p) { return dot(centre(p), centre(p)) != 0; }
  // Inertia force of an eccentric centre of mass, in own axes, without the acceleration of the node.
  template <class S>
  static Vec3<S> swing(const Parameters& p, const SpinMotion<S>& node) {
    const Vec3<double>& c = centre(p);
    return p.physicsMass * (cross(node.spin_rate, c) + cross(node.spin, cross(node.spin, c)));
  }
  // The inertia tensor is stored as [Jxx, Jyy, Jzz, Jyz, Jxz, Jxy].
  template <class S>
  static Vec3<S> tensor(const Parameters& p, const Vec3<S>& x) {
    const auto& j = p.physicsInertia;
    return {j[0] * x[0] + j[5] * x[1] + j[4] * x[2], j[5] * x[0] + j[1] * x[1] + j[3] * x[2],
            j[4] * x[0] + j[3] * x[1] + j[2] * x[2]};
  }
};

}  // namespace dalembert
