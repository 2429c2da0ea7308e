// ObjectMass1D, specs/bodies/mass_1d.toml: a mass that slides along the x-axis of its frame.
#pragma once

#include "dalembert/bodies/mass_1d_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectMass1D : NoCheck, NoDoubt, NoElementOutputs, NoLieRotations {
  using Parameters = ObjectMass1DParameters;
  static constexpr int size = 1;
  static constexpr ElementTraits traits{.constant_mass = true, .pure_inertia = true};

  template <class S>
  static Vec<S, 1> residual(const Parameters& p, const Context&, const Coordinates<S, 1>& x) {
    return {p.physicsMass * x.a[0]};
  }
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, 1>& x, const Vec3<double>& local) {
    const Vec3<double> direction = column(p.referenceRotation, 0);
    Motion<S> m;
    m.position = p.referencePosition + p.referenceRotation * local + x.q[0] * direction;
    m.velocity = x.v[0] * direction;
    m.acceleration = x.a[0] * direction;
    for (int i = 0; i < 9; ++i) m.rotation.x[i] = S(p.referenceRotation.x[i]);
    return m;
  }
  template <class S>
  static Vec<S, 1> pull_back(const Parameters& p, const Coordinates<S, 1>&, const Vec3<double>&, const Vec3<S>& force,
                             const Vec3<S>&) {
    return {dot(column(p.referenceRotation, 0), force)};
  }
  template <class S>
  static Vec<S, 1> mass_load(const Parameters& p, const Coordinates<S, 1>&, const Vec3<S>& g) {
    return {p.physicsMass * dot(column(p.referenceRotation, 0), g)};
  }
};

}  // namespace dalembert
