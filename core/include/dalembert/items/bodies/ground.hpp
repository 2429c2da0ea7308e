// ObjectGround, specs/bodies/ground.toml: a frame that rests.
#pragma once

#include "dalembert/bodies/ground_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectGround : NoCheck, NoDoubt, NoElementOutputs, NoLieRotations {
  using Parameters = ObjectGroundParameters;
  static constexpr int size = 0;
  static constexpr ElementTraits traits{.constant_mass = true};

  template <class S>
  static Vec<S, 0> residual(const Parameters&, const Context&, const Coordinates<S, 0>&) {
    return {};
  }
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, 0>&, const Vec3<double>& local) {
    return {.position = p.referencePosition + p.referenceRotation * local, .rotation = p.referenceRotation};
  }
  template <class S>
  static Vec<S, 0> pull_back(const Parameters&, const Coordinates<S, 0>&, const Vec3<double>&, const Vec3<S>&,
                             const Vec3<S>&) {
    return {};
  }
  template <class S>
  static Vec<S, 0> mass_load(const Parameters&, const Coordinates<S, 0>&, const Vec3<S>&) {
    return {};
  }
};

}  // namespace dalembert
