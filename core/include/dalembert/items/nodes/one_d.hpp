// Node1D, specs/nodes/one_d.toml: one coordinate, whose meaning depends on the body.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/one_d_parameters.hpp"

namespace dalembert {

struct Node1D : NoCheck, NoNodeOutputs {
  using Parameters = Node1DParameters;
  static constexpr std::string_view item = "Node1D";
  static constexpr int size = 1;
  static constexpr NodeTraits traits{.translations = 1, .constant_jacobian = true};

  // The coordinate moves the point along global x.
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const S o(0);
    return {.position = {x.q[0], o, o}, .velocity = {x.v[0], o, o}, .acceleration = {x.a[0], o, o}};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>&) {
    return {force[0]};
  }
};

}  // namespace dalembert
