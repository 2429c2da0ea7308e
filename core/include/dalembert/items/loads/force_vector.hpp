// LoadForceVector, specs/loads/force_vector.toml
#pragma once

#include "dalembert/contracts/load_value.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/loads/force_vector_parameters.hpp"

namespace dalembert {

struct LoadForceVector : ReadsNoMarker {
  using Parameters = LoadForceVectorParameters;
  using Port = PointPort;

  template <class S>
  static Force<S> force(const Parameters& p, const Context& c, const PointFrame<S>&) {
    const Vec3<double> f = load_factor(p.loadVectorUserFunction, c) * value(p, c);
    return {.force = {S(f[0]), S(f[1]), S(f[2])}};
  }
  static Vec3<double> value(const Parameters& p, const Context& c) {
    return load_value(p.loadVectorUserFunction, c, p.loadVector);
  }

  // A follower force turns with the marker.
  struct BodyFixed : ReadsMarker {
    using Parameters = LoadForceVectorParameters;
    using Port = RigidPort;
    static bool applies(const Parameters& p) { return p.bodyFixed; }

    template <class S>
    static Wrench<S> force(const Parameters& p, const Context& c, const RigidFrame<S>& m0) {
      return {.force = m0.rotation * (load_factor(p.loadVectorUserFunction, c) * value(p, c))};
    }
  };
};

}  // namespace dalembert
