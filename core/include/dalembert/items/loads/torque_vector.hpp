// LoadTorqueVector, specs/loads/torque_vector.toml
#pragma once

#include "dalembert/contracts/load_value.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/loads/torque_vector_parameters.hpp"

namespace dalembert {

struct LoadTorqueVector : NoFollower {
  using Parameters = LoadTorqueVectorParameters;
  using Port = RigidPort;
  static constexpr bool is_constant = false;
  static bool reads_marker(const Parameters& p) { return p.bodyFixed; }

  template <class S>
  static Wrench<S> force(const Parameters& p, const Context& c, const RigidFrame<S>& m0) {
    const Vec3<double> m = load_factor(p.loadVectorUserFunction, c) * value(p, c);
    if (p.bodyFixed) return {.moment = m0.rotation * m};
    return {.moment = {S(m[0]), S(m[1]), S(m[2])}};
  }
  static Vec3<double> value(const Parameters& p, const Context& c) {
    return load_value(p.loadVectorUserFunction, c, p.loadVector);
  }
};

}  // namespace dalembert
