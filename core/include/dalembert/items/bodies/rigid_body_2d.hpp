// ObjectRigidBody2D, specs/bodies/rigid_body_2d.toml
#pragma once

#include "dalembert/bodies/rigid_body_2d_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectRigidBody2D {
  using Parameters = ObjectRigidBody2DParameters;
  static constexpr bool constant_mass = false;  // with an eccentric centre of mass it turns with the body

  // Newton-Euler equations about the node, in the plane.
  template <class S>
  static Wrench<S> residual(const Parameters& p, const Context&, const Motion<S>& node) {
    const Vec3<S> c = centre(p, node);
    const S &w = node.angular_velocity[2], &alpha = node.angular_acceleration[2];
    const Vec3<S>& a = node.acceleration;
    const S o(0);
    return {.force = {p.physicsMass * (a[0] - alpha * c[1] - w * w * c[0]),
                      p.physicsMass * (a[1] + alpha * c[0] - w * w * c[1]), o},
            .moment = {o, o, p.physicsInertia * alpha + p.physicsMass * (c[0] * a[1] - c[1] * a[0])}};
  }
  template <class S>
  static Wrench<S> mass_load(const Parameters& p, const Motion<S>& node, const Vec3<S>& g) {
    const Vec3<S> weight = p.physicsMass * g;
    return {.force = weight, .moment = cross(centre(p, node), weight)};
  }
  // The angle as a coordinate: it counts full turns, from the reference configuration on.
  static bool output(const Parameters&, const Context&, const Coordinates<double, 3>& x, const OutputRequest& request,
                     std::vector<double>& values) {
    if (request.variable != OutputVariableType::Rotation) return false;
    values = {x.q[2] - request.reference[2]};
    return true;
  }

 private:
  template <class S>
  static Vec3<S> centre(const Parameters& p, const Motion<S>& node) {
    return node.rotation * Vec3<double>{p.physicsCenterOfMass[0], p.physicsCenterOfMass[1], 0.0};
  }
};

}  // namespace dalembert
