// LoadMassProportional, specs/loads/mass_proportional.toml: an acceleration field on a whole body, e.g. gravity.
#pragma once

#include "dalembert/contracts/load_value.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/loads/mass_proportional_parameters.hpp"

namespace dalembert {

struct LoadMassProportional : ReadsNoMarker, NoFollower {
  using Parameters = LoadMassProportionalParameters;
  using Port = MassPort;

  template <class S>
  static Force<S> force(const Parameters& p, const Context& c, const MassFrame<S>&) {
    const Vec3<double> g = load_factor(p.loadVectorUserFunction, c) * value(p, c);
    return {.force = {S(g[0]), S(g[1]), S(g[2])}};
  }
  static Vec3<double> value(const Parameters& p, const Context& c) {
    return load_value(p.loadVectorUserFunction, c, p.loadVector);
  }
};

}  // namespace dalembert
