// NodeRigidBody2D, specs/nodes/rigid_body_2d.toml: two displacements and an angle about z.
#pragma once

#include <vector>

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/rigid_body_2d_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct NodeRigidBody2D : NoCheck {
  using Parameters = NodeRigidBody2DParameters;
  static constexpr std::string_view item = "NodeRigidBody2D";
  static constexpr int size = 3;
  static constexpr NodeTraits traits{.translations = 2, .constant_jacobian = true, .planar = true};

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const S o(0);
    return {.position = {x.q[0], x.q[1], o},
            .velocity = {x.v[0], x.v[1], o},
            .acceleration = {x.a[0], x.a[1], o},
            .rotation = planar_rotation(x.q[2]),
            .angular_velocity = {o, o, x.v[2]},
            .angular_acceleration = {o, o, x.a[2]}};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>& moment) {
    return {force[0], force[1], moment[2]};
  }
  // The angle counts full turns.
  static bool output(OutputVariableType variable, const NodeView& view, std::vector<double>& values) {
    if (variable != OutputVariableType::Rotation) return false;
    values = {0, 0, view.q[2]};
    return true;
  }
};

}  // namespace dalembert
