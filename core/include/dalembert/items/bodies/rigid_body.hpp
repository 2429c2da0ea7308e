// ObjectRigidBody, specs/bodies/rigid_body.toml
#pragma once

#include "dalembert/bodies/rigid_body_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectRigidBody {
  using Parameters = ObjectRigidBodyParameters;
  static constexpr bool constant_mass = true;  // in the body frame; the node decides about its coordinates

  // Newton-Euler equations about the node, for any rotation parameters of the node.
  template <class S>
  static Wrench<S> residual(const Parameters& p, const Context&, const Motion<S>& node) {
    const Vec3<S> w = transposed_times(node.rotation, node.angular_velocity);
    const Vec3<S> alpha = transposed_times(node.rotation, node.angular_acceleration);
    const Vec3<S> a = transposed_times(node.rotation, node.acceleration);
    const Vec3<double>& c = p.physicsCenterOfMass;
    const Vec3<S> force = p.physicsMass * (a + cross(alpha, c) + cross(w, cross(w, c)));
    const Vec3<S> moment = inertia(p, alpha) + cross(w, inertia(p, w)) + p.physicsMass * cross(c, a);
    return {.force = node.rotation * force, .moment = node.rotation * moment};
  }
  template <class S>
  static Wrench<S> mass_load(const Parameters& p, const Motion<S>& node, const Vec3<S>& g) {
    const Vec3<S> weight = p.physicsMass * g;
    return {.force = weight, .moment = cross(node.rotation * p.physicsCenterOfMass, weight)};
  }

 private:
  // The inertia tensor is stored as [Jxx, Jyy, Jzz, Jyz, Jxz, Jxy].
  template <class S>
  static Vec3<S> inertia(const Parameters& p, const Vec3<S>& x) {
    const auto& j = p.physicsInertia;
    return {j[0] * x[0] + j[5] * x[1] + j[4] * x[2], j[5] * x[0] + j[1] * x[1] + j[3] * x[2],
            j[4] * x[0] + j[3] * x[1] + j[2] * x[2]};
  }
};

}  // namespace dalembert
