// NodeRigidBodyRotVecLG, specs/nodes/rigid_body_rot_vec_lg.toml: displacements and a rotation vector on the group; the
// rates of the rotation are the local angular velocity.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/rigid_body_rot_vec_lg_parameters.hpp"

namespace dalembert {

struct NodeRigidBodyRotVecLG : NoCheck, NoNodeOutputs {
  using Parameters = NodeRigidBodyRotVecLGParameters;
  static constexpr std::string_view item = "NodeRigidBodyRotVecLG";
  static constexpr int size = 6;
  static constexpr NodeTraits traits{
      .translations = 3, .lie_rotation = 3, .rotation_alone = true, .rotation_tangent = true, .in_packs = true};

  template <class S>
  static Mat3<S> rotation(const Coordinates<S, size>& x) {
    return rotation_vector_rotation(segment<3>(x.q, 3));
  }
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const Mat3<S> r = rotation(x);
    return {.position = segment<3>(x.q, 0),
            .velocity = segment<3>(x.v, 0),
            .acceleration = segment<3>(x.a, 0),
            .rotation = r,
            .angular_velocity = r * segment<3>(x.v, 3),
            .angular_acceleration = r * segment<3>(x.a, 3)};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>& x, const Vec3<S>& force, const Vec3<S>& moment) {
    const Vec3<S> m = transposed_times(rotation_vector_rotation(segment<3>(x.q, 3)), moment);
    return {force[0], force[1], force[2], m[0], m[1], m[2]};
  }
  template <class S>
  static SpinMotion<S> spin_motion(const Coordinates<S, size>& x) {
    return {.acceleration = segment<3>(x.a, 0),
            .rotation = rotation(x),
            .spin = segment<3>(x.v, 3),
            .spin_rate = segment<3>(x.a, 3)};
  }
  template <class S>
  static Vec3<S> pull_back_spin(const Coordinates<S, size>&, const Vec3<S>& moment) {
    return moment;
  }

  // Derivatives with respect to increments on the group: rotation exp(increment).
  static RotationTangent<3> rotation_tangent(const Coordinates<double, size>& x, const Weights& w) {
    const Vec3<double> spin = segment<3>(x.v, 3);
    RotationTangent<3> t{.rotation = rotation(x), .spin = spin, .spin_map = identity()};
    t.angular_map = t.rotation;
    for (int j = 0; j < 3; ++j) {
      Vec3<double> axis;
      axis[j] = w.q;
      t.turn[j] = t.rotation * skew(axis);
    }
    t.spin_tangent = w.v * identity();
    t.spin_rate_tangent = w.a * identity();
    t.angular_tangent = t.rotation * (w.v * identity() - w.q * skew(spin));
    return t;
  }
  static Mat3<double> moment_tangent(const Coordinates<double, size>& x, const Vec3<double>&,
                                     const Vec3<double>& global, const Weights& w) {
    return w.q * skew(transposed_times(rotation_vector_rotation(segment<3>(x.q, 3)), global));
  }
};

}  // namespace dalembert
