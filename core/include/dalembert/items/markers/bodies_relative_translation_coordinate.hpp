// MarkerBodiesRelativeTranslationCoordinate, specs/markers/bodies_relative_translation_coordinate.toml
#pragma once

#include "dalembert/frames.hpp"
#include "dalembert/markers/bodies_relative_translation_coordinate_parameters.hpp"

namespace dalembert {

struct MarkerBodiesRelativeTranslationCoordinate {
  using Parameters = MarkerBodiesRelativeTranslationCoordinateParameters;

  // Displacement of the second point along an axis that turns with the first body.
  template <class S>
  static ScalarFrame<S> measure(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const Vec3<S> axis = m0.rotation * p.axis0, span = m1.position - m0.position;
    return {dot(axis, span) - p.offset,
            dot(axis, m1.velocity - m0.velocity) + dot(cross(m0.angular_velocity, axis), span)};
  }
  // A pair of opposite forces along the axis.
  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>&,
                                         const S& force) {
    const Vec3<S> f = force * (m0.rotation * p.axis0);
    return {Wrench<S>{.force = -f}, Wrench<S>{.force = f}};
  }
};

}  // namespace dalembert
