// NodeRigidBodyEP, specs/nodes/rigid_body_ep.toml: displacements and Euler parameters.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/model/value_checks.hpp"
#include "dalembert/nodes/rigid_body_ep_parameters.hpp"

namespace dalembert {

struct NodeRigidBodyEP : NoNodeOutputs {
  using Parameters = NodeRigidBodyEPParameters;
  static constexpr std::string_view item = "NodeRigidBodyEP";
  static constexpr int size = 7;
  static constexpr NodeTraits traits{
      .translations = 3, .unit_from = 3, .rotation_alone = true, .rotation_tangent = true, .in_packs = true};

  static void check(const Parameters& p, const ItemLabel& item) {
    Vec<double, 4> e = segment<4>(p.referenceCoordinates, traits.unit_from);
    check_unit_length(e.x, "referenceCoordinates", "four Euler parameters, from the fourth value on", item);
    e += segment<4>(p.initialCoordinates, traits.unit_from);
    check_unit_length(e.x, "initialCoordinates",
                      "values that, added to referenceCoordinates, give four Euler parameters", item);
  }

  template <class S>
  static Mat3<S> rotation(const Coordinates<S, size>& x) {
    return euler_parameters_rotation(segment<4>(x.q, 3));
  }
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const Vec<S, 4> e = segment<4>(x.q, 3);
    const Mat<S, 3, 4> g = euler_parameters_g(e);
    return {.position = segment<3>(x.q, 0),
            .velocity = segment<3>(x.v, 0),
            .acceleration = segment<3>(x.a, 0),
            .rotation = rotation(x),
            .angular_velocity = g * segment<4>(x.v, 3),
            .angular_acceleration = g * segment<4>(x.a, 3)};  // dG/dt de/dt = 0 for Euler parameters
  }
  template <class S>
  static SpinMotion<S> spin_motion(const Coordinates<S, size>& x) {
    const Vec<S, 4> e = segment<4>(x.q, 3);
    const Mat<S, 3, 4> g = euler_parameters_local_g(e);
    return {.acceleration = segment<3>(x.a, 0),
            .rotation = rotation(x),
            .spin = g * segment<4>(x.v, 3),
            .spin_rate = g * segment<4>(x.a, 3)};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>& x, const Vec3<S>& force, const Vec3<S>& moment) {
    const Vec<S, 4> m = transposed_times(euler_parameters_g(segment<4>(x.q, 3)), moment);
    return {force[0], force[1], force[2], m[0], m[1], m[2], m[3]};
  }
  template <class S>
  static Vec<S, 4> pull_back_spin(const Coordinates<S, size>& x, const Vec3<S>& moment) {
    return transposed_times(euler_parameters_local_g(segment<4>(x.q, 3)), moment);
  }

  // Both G are linear and antisymmetric: G(e) f = -G(f) e.
  static RotationTangent<4> rotation_tangent(const Coordinates<double, size>& x, const Weights& w) {
    const Vec<double, 4> e = segment<4>(x.q, 3), rate = segment<4>(x.v, 3);
    RotationTangent<4> t{.rotation = euler_parameters_rotation(e),
                         .turn = euler_parameters_turn(e),
                         .spin_map = euler_parameters_local_g(e),
                         .angular_map = euler_parameters_g(e)};
    for (Mat3<double>& turn : t.turn) turn = w.q * turn;
    t.spin = t.spin_map * rate;
    t.spin_tangent = w.v * t.spin_map - w.q * euler_parameters_local_g(rate);
    t.spin_rate_tangent = w.a * t.spin_map - w.q * euler_parameters_local_g(segment<4>(x.a, 3));
    t.angular_tangent = w.v * t.angular_map - w.q * euler_parameters_g(rate);
    return t;
  }
  static Mat<double, 4, 4> moment_tangent(const Coordinates<double, size>&, const Vec3<double>& local,
                                          const Vec3<double>& global, const Weights& w) {
    const Vec3<double> s = (2 * w.q) * (local + global), d = (2 * w.q) * (local - global);
    return {0, -s[0], -s[1], -s[2], s[0], 0, d[2], -d[1], s[1], -d[2], 0, d[0], s[2], d[1], -d[0], 0};
  }
};

}  // namespace dalembert
