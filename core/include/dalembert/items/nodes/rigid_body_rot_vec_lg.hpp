// NodeRigidBodyRotVecLG, specs/nodes/rigid_body_rot_vec_lg.toml: displacements and a rotation vector on the group; the
// rates of the rotation are the local angular velocity.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/rigid_body_rot_vec_lg_parameters.hpp"

namespace dalembert {

struct NodeRigidBodyRotVecLG {
  using Parameters = NodeRigidBodyRotVecLGParameters;
  static constexpr std::string_view item = "NodeRigidBodyRotVecLG";
  static constexpr int size = 6;
  static constexpr bool constant_jacobian = false;
  static constexpr int lie_rotation = 3;

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const Mat3<S> r = rotation_vector_rotation(segment<3>(x.q, 3));
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
};

}  // namespace dalembert
