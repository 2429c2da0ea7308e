// ObjectRotationalMass1D, specs/bodies/rotational_mass_1d.toml: a rotor about the z-axis of its frame.
#pragma once

#include <vector>

#include "dalembert/bodies/rotational_mass_1d_parameters.hpp"
#include "dalembert/contracts/element.hpp"

namespace dalembert {

struct ObjectRotationalMass1D : NoCheck, NoDoubt, NoLieRotations {
  using Parameters = ObjectRotationalMass1DParameters;
  static constexpr int size = 1;
  static constexpr ElementTraits traits{.constant_mass = true, .pure_inertia = true};

  template <class S>
  static Vec<S, 1> residual(const Parameters& p, const Context&, const Coordinates<S, 1>& x) {
    return {p.physicsInertia * x.a[0]};
  }
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, 1>& x, const Vec3<double>& local) {
    const Vec3<double> axis = column(p.referenceRotation, 2);
    Motion<S> m;
    for (int i = 0; i < 3; ++i) m.position[i] = S(p.referencePosition[i]);
    m.rotation = p.referenceRotation * planar_rotation(x.q[0]);
    m.angular_velocity = x.v[0] * axis;
    m.angular_acceleration = x.a[0] * axis;
    return moved(m, m.rotation * local);
  }
  // Forces have no lever arm on this body: only moments about the axis act.
  template <class S>
  static Vec<S, 1> pull_back(const Parameters& p, const Coordinates<S, 1>&, const Vec3<double>&, const Vec3<S>&,
                             const Vec3<S>& moment) {
    return {dot(column(p.referenceRotation, 2), moment)};
  }
  // Gravity has no lever arm: the centre of mass is on the axis.
  template <class S>
  static Vec<S, 1> mass_load(const Parameters&, const Coordinates<S, 1>&, const Vec3<S>&) {
    return {S(0)};
  }
  static bool output(const Parameters&, const Context&, const Coordinates<double, 1>& x, const OutputRequest& request,
                     std::vector<double>& values) {
    if (request.variable != OutputVariableType::Rotation) return false;
    values = {x.q[0]};
    return true;
  }
};

}  // namespace dalembert
