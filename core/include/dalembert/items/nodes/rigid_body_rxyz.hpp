// NodeRigidBodyRxyz, specs/nodes/rigid_body_rxyz.toml: displacements and Tait-Bryan angles.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/rigid_body_rxyz_parameters.hpp"

namespace dalembert {

struct NodeRigidBodyRxyz : NoCheck {
  using Parameters = NodeRigidBodyRxyzParameters;
  static constexpr std::string_view item = "NodeRigidBodyRxyz";
  static constexpr int size = 6;
  static constexpr NodeTraits traits{.translations = 3, .rotation_alone = true};

  template <class S>
  static Mat3<S> rotation(const Coordinates<S, size>& x) {
    return tait_bryan_rotation(segment<3>(x.q, 3));
  }
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const Vec3<S> angle = segment<3>(x.q, 3), rate = segment<3>(x.v, 3);
    const Mat3<S> g = tait_bryan_g(angle);
    return {.position = segment<3>(x.q, 0),
            .velocity = segment<3>(x.v, 0),
            .acceleration = segment<3>(x.a, 0),
            .rotation = rotation(x),
            .angular_velocity = g * rate,
            .angular_acceleration = g * segment<3>(x.a, 3) + tait_bryan_bias(angle, rate)};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>& x, const Vec3<S>& force, const Vec3<S>& moment) {
    const Vec3<S> m = transposed_times(tait_bryan_g(segment<3>(x.q, 3)), moment);
    return {force[0], force[1], force[2], m[0], m[1], m[2]};
  }
  // The angles count full turns.
  static bool output(OutputVariableType variable, const NodeView& view, std::vector<double>& values) {
    if (variable != OutputVariableType::Rotation) return false;
    values.assign(view.q.begin() + 3, view.q.end());
    return true;
  }
};

}  // namespace dalembert
