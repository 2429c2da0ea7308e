// NodePoint2D, specs/nodes/point_2d.toml
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/point_2d_parameters.hpp"

namespace dalembert {

struct NodePoint2D : NoCheck, NoNodeOutputs {
  using Parameters = NodePoint2DParameters;
  static constexpr std::string_view item = "NodePoint2D";
  static constexpr int size = 2;
  static constexpr NodeTraits traits{.translations = 2, .constant_jacobian = true, .planar = true};

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const S o(0);
    return {.position = {x.q[0], x.q[1], o}, .velocity = {x.v[0], x.v[1], o}, .acceleration = {x.a[0], x.a[1], o}};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>&) {
    return {force[0], force[1]};
  }
};

}  // namespace dalembert
