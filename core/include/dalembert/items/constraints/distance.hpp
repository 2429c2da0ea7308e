// ObjectConnectorDistance, specs/constraints/distance.toml
#pragma once

#include "dalembert/constraints/distance_parameters.hpp"
#include "dalembert/contracts/line_of_action.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorDistance : ConstrainsAll, Holonomic, VaryingDirections {
  using Parameters = ObjectConnectorDistanceParameters;
  using Port = PointPort;
  static constexpr ConstraintForms closed_forms{.reaction = true};
  static constexpr int equations = 1;

  template <class S>
  static Vec<S, 1> gap(const Parameters& p, const Context& c, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    if (coincide(m0, m1))
      refuse_coinciding(c, "ObjectConnectorDistance",
                        "Keep the points apart, or use ObjectJointSpherical for points that stay together");
    return {norm(m1.position - m0.position) - p.distance};
  }
  template <class S>
  static std::array<Force<S>, 2> reaction(const Parameters&, const Context&, const PointFrame<S>& m0,
                                          const PointFrame<S>& m1, const Vec<double, 1>& lambda) {
    const Vec3<S> span = m1.position - m0.position;
    const Vec3<S> f = (lambda[0] / norm(span)) * span;
    return {Force<S>{-f}, Force<S>{f}};
  }

  static bool output(const Parameters&, const Context&, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     const Vec<double, 1>& lambda, OutputVariableType variable, std::vector<double>& values) {
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Displacement: vector(m1.position - m0.position); return true;
      case OutputVariableType::Velocity: vector(m1.velocity - m0.velocity); return true;
      case OutputVariableType::Distance: values = {norm(m1.position - m0.position)}; return true;
      case OutputVariableType::Force: values = {lambda[0]}; return true;
      default: return false;
    }
  }
};

}  // namespace dalembert
