// NodeRigidBodyEP, specs/nodes/rigid_body_ep.toml: displacements and Euler parameters.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/rigid_body_ep_parameters.hpp"

namespace dalembert {

struct NodeRigidBodyEP {
  using Parameters = NodeRigidBodyEPParameters;
  static constexpr std::string_view item = "NodeRigidBodyEP";
  static constexpr int size = 7;
  static constexpr bool constant_jacobian = false;
  static constexpr int equations = 1;

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const Vec<S, 4> e = segment<4>(x.q, 3);
    const Mat<S, 3, 4> g = euler_parameters_g(e);
    return {.position = segment<3>(x.q, 0),
            .velocity = segment<3>(x.v, 0),
            .acceleration = segment<3>(x.a, 0),
            .rotation = euler_parameters_rotation(e),
            .angular_velocity = g * segment<4>(x.v, 3),
            .angular_acceleration = g * segment<4>(x.a, 3)};  // dG/dt de/dt = 0 for Euler parameters
  }
  // With a proper rotation even if the parameters have drifted from unit length, so that the angular velocity in the body
  // frame is bilinear in parameters and rates.
  template <class S>
  static Motion<S> inertial_motion(const Coordinates<S, size>& x) {
    Motion<S> m = motion(x);
    const Vec<S, 4> e = segment<4>(x.q, 3);
    const S square = dot(e, e), inverse = 1.0 / square;
    for (int i = 0; i < 3; ++i) {
      m.rotation(i, i) = m.rotation(i, i) + (square - 1.0);
      for (int j = 0; j < 3; ++j) m.rotation(i, j) = inverse * m.rotation(i, j);
    }
    return m;
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>& x, const Vec3<S>& force, const Vec3<S>& moment) {
    const Vec<S, 4> m = transposed_times(euler_parameters_g(segment<4>(x.q, 3)), moment);
    return {force[0], force[1], force[2], m[0], m[1], m[2], m[3]};
  }

  // Unit length.
  template <class S>
  static Vec<S, 1> gap(const Vec<S, size>& q) {
    const Vec<S, 4> e = segment<4>(q, 3);
    return {dot(e, e) - 1.0};
  }
  template <class S>
  static Mat<S, 1, size> gap_jacobian(const Vec<S, size>& q) {
    const S o(0);
    return {o, o, o, 2.0 * q[3], 2.0 * q[4], 2.0 * q[5], 2.0 * q[6]};
  }
};

}  // namespace dalembert
