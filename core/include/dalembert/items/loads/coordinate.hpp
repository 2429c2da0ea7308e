// LoadCoordinate, specs/loads/coordinate.toml: a generalised force on one coordinate.
#pragma once

#include "dalembert/contracts/load_value.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/loads/coordinate_parameters.hpp"

namespace dalembert {

struct LoadCoordinate : ReadsNoMarker, NoFollower {
  using Parameters = LoadCoordinateParameters;
  using Port = ScalarPort;

  template <class S>
  static ScalarForce<S> force(const Parameters& p, const Context& c, const ScalarFrame<S>&) {
    return {S(load_factor(p.loadUserFunction, c) * value(p, c)[0])};
  }
  static Vec<double, 1> value(const Parameters& p, const Context& c) {
    return load_value(p.loadUserFunction, c, Vec<double, 1>{p.load});
  }
};

}  // namespace dalembert
