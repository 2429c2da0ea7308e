// ObjectMassPoint, specs/bodies/mass_point.toml
#pragma once

#include "dalembert/bodies/mass_point_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectMassPoint : NoCheck, NoDoubt, NoElementOutputs {
  using Parameters = ObjectMassPointParameters;
  static constexpr BodyTraits traits{.constant_mass = true, .pure_inertia = true};

  // Newton's second law; applied forces are added by the assembler.
  template <class S>
  static Wrench<S> residual(const Parameters& p, const Context&, const Motion<S>& node) {
    return {.force = p.physicsMass * node.acceleration};
  }
  template <class S>
  static Wrench<S> mass_load(const Parameters& p, const Motion<S>&, const Vec3<S>& g) {
    return {.force = p.physicsMass * g};
  }
};

}  // namespace dalembert
