// MarkerBodiesRelativeRotationCoordinate, specs/markers/bodies_relative_rotation_coordinate.toml
#pragma once

#include "dalembert/frames.hpp"
#include "dalembert/markers/bodies_relative_rotation_coordinate_parameters.hpp"
#include "dalembert/math/rotations.hpp"

namespace dalembert {

struct MarkerBodiesRelativeRotationCoordinate {
  using Parameters = MarkerBodiesRelativeRotationCoordinateParameters;

  // Angle of the second body about an axis that turns with the first one.
  template <class S>
  static ScalarFrame<S> measure(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    using std::atan2;
    const Vec3<double> x = across(p.axis0), y = cross(p.axis0, x);
    const Vec3<S> turned = transposed_times(m0.rotation, m1.rotation * x);
    const S rate = dot(m0.rotation * p.axis0, m1.angular_velocity - m0.angular_velocity);
    return {atan2(dot(y, turned), dot(x, turned)) - p.offset, rate};
  }
  // A pair of opposite moments about the axis.
  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>&,
                                         const S& force) {
    const Vec3<S> moment = force * (m0.rotation * p.axis0);
    return {Wrench<S>{.moment = -moment}, Wrench<S>{.moment = moment}};
  }

 private:
  // A unit vector normal to the axis: the projection of x, or of y for an axis close to x.
  static Vec3<double> across(const Vec3<double>& axis) {
    const bool along_x = std::abs(axis[0]) > 0.5 && std::abs(axis[1]) < 0.1 && std::abs(axis[2]) < 0.1;
    Vec3<double> v;
    v[along_x ? 1 : 0] = 1;
    v -= dot(v, axis) * axis;
    return (1 / norm(v)) * v;
  }
};

}  // namespace dalembert
