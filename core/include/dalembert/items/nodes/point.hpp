// NodePoint, specs/nodes/point.toml
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/point_parameters.hpp"

namespace dalembert {

struct NodePoint {
  using Parameters = NodePointParameters;
  static constexpr std::string_view item = "NodePoint";
  static constexpr int size = 3;
  static constexpr bool constant_jacobian = true;
  static constexpr int translations = 3;

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    return {.position = x.q, .velocity = x.v, .acceleration = x.a};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>&) {
    return force;
  }
};

}  // namespace dalembert
