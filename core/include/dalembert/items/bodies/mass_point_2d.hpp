// ObjectMassPoint2D, specs/bodies/mass_point_2d.toml
#pragma once

#include "dalembert/bodies/mass_point_2d_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectMassPoint2D : NoCheck, NoDoubt, NoElementOutputs {
  using Parameters = ObjectMassPoint2DParameters;
  static constexpr BodyTraits traits{.constant_mass = true, .pure_inertia = true, .planar_tangent = true};

  static double mass(const Parameters& p) { return p.physicsMass; }
  static Vec3<double> centre(const Parameters&) { return {}; }

  // Newton's second law in the plane; applied forces are added by the assembler.
  template <class S>
  static Wrench<S> residual(const Parameters& p, const Context&, const Motion<S>& node) {
    return {.force = p.physicsMass * node.acceleration};
  }
  template <class S>
  static Mat<S, 2, 2> planar_tangent(const Parameters& p, const Coordinates<S, 2>&, const Weights& w) {
    return {w.a * p.physicsMass, 0, 0, w.a * p.physicsMass};
  }
  template <class S>
  static Wrench<S> mass_load(const Parameters& p, const Motion<S>&, const Vec3<S>& g) {
    return {.force = p.physicsMass * g};
  }
};

}  // namespace dalembert
