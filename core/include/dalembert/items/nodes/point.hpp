// NodePoint, specs/nodes/point.toml
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/point_parameters.hpp"

namespace dalembert {

struct NodePoint : NoCheck, NoNodeOutputs {
  using Parameters = NodePointParameters;
  static constexpr std::string_view item = "NodePoint";
  static constexpr int size = 3;
  static constexpr NodeTraits traits{.translations = 3, .constant_jacobian = true};

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
