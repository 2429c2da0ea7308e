// ObjectRigidBody2D, specs/bodies/rigid_body_2d.toml
#pragma once

#include "dalembert/bodies/rigid_body_2d_parameters.hpp"
#include "dalembert/contracts/element.hpp"
#include "dalembert/model/value_checks.hpp"

namespace dalembert {

struct ObjectRigidBody2D : NoDoubt {
  using Parameters = ObjectRigidBody2DParameters;
  // An eccentric center of mass makes the mass matrix depend on the rotation.
  static constexpr BodyTraits traits{.planar_tangent = true};

  static void check(const Parameters& p, const ItemLabel& item) {
    check_planar_inertia(p.physicsMass, p.physicsInertia, p.physicsCenterOfMass, item);
  }

  static double mass(const Parameters& p) { return p.physicsMass; }
  static Vec3<double> centre(const Parameters& p) { return {p.physicsCenterOfMass[0], p.physicsCenterOfMass[1], 0.0}; }

  // Newton-Euler equations about the node, in the plane.
  template <class S>
  static Wrench<S> residual(const Parameters& p, const Context&, const Motion<S>& node) {
    const S o(0), &alpha = node.angular_acceleration[2];
    const Vec3<S>& a = node.acceleration;
    Wrench<S> r{.force = {p.physicsMass * a[0], p.physicsMass * a[1], o}, .moment = {o, o, p.physicsInertia * alpha}};
    if (!eccentric(p)) return r;
    const Vec3<S> c = node.rotation * centre(p);
    const S& w = node.angular_velocity[2];
    r.force[0] -= p.physicsMass * (alpha * c[1] + w * w * c[0]);
    r.force[1] += p.physicsMass * (alpha * c[0] - w * w * c[1]);
    r.moment[2] += p.physicsMass * (c[0] * a[1] - c[1] * a[0]);
    return r;
  }
  template <class S>
  static Mat3<S> planar_tangent(const Parameters& p, const Coordinates<S, 3>& x, const Weights& w) {
    const double m = p.physicsMass, ma = w.a * m;
    Mat3<S> k{ma, 0, 0, 0, ma, 0, 0, 0, w.a * p.physicsInertia};
    if (!eccentric(p)) return k;
    const Arm<S> c = PlanarRotation<S>::by(x.q[2]).arm(centre(p));
    const S &spin = x.v[2], &spin_rate = x.a[2];
    const S along = w.q * spin_rate + 2 * w.v * spin, across = w.q * spin * spin - w.a;
    k(0, 2) = m * (across * c[1] - along * c[0]);
    k(1, 2) = -m * (across * c[0] + along * c[1]);
    k(2, 0) = -ma * c[1];
    k(2, 1) = ma * c[0];
    k(2, 2) -= w.q * m * (c[0] * x.a[0] + c[1] * x.a[1]);
    return k;
  }
  template <class S>
  static Wrench<S> mass_load(const Parameters& p, const Motion<S>& node, const Vec3<S>& g) {
    const Vec3<S> weight = p.physicsMass * g;
    return {.force = weight, .moment = cross(node.rotation * centre(p), weight)};
  }
  // The angle as a coordinate: it counts full turns, from the reference configuration on; there it is that of the reference.
  static bool output(const Parameters&, const Context&, const Coordinates<double, 3>& x, const OutputRequest& request,
                     std::vector<double>& values) {
    if (request.variable != OutputVariableType::Rotation) return false;
    values = {request.of_reference ? request.reference[2] : x.q[2] - request.reference[2]};
    return true;
  }

 private:
  static bool eccentric(const Parameters& p) { return p.physicsCenterOfMass[0] != 0 || p.physicsCenterOfMass[1] != 0; }
};

}  // namespace dalembert
