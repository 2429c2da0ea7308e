// ObjectConnectorHertzSpring, specs/connectors/hertz_spring.toml
#pragma once

#include "dalembert/connectors/hertz_spring_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorHertzSpring : NoPairHistory {
  using Parameters = ObjectConnectorHertzSpringParameters;
  using Port = PointPort;

  // Forces on both markers along the line between them, by Hertz' law of the penetration.
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context&, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    using std::sqrt;
    const Vec3<S> span = m1.position - m0.position;
    const S square = dot(span, span);
    if (value_of(square) == 0 || value_of(square) >= p.radius * p.radius) return {};
    const S length = sqrt(square);
    const S penetration = p.radius - length;
    const Vec3<S> f = (p.stiffness * penetration * sqrt(penetration) / length) * span;
    return {Force<S>{-f}, Force<S>{f}};
  }

  static bool output(const Parameters& p, const Context& c, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Vec3<double> span = m1.position - m0.position;
    switch (variable) {
      case OutputVariableType::Distance: values = {std::sqrt(dot(span, span))}; return true;
      case OutputVariableType::Force: {
        const Vec3<double> f = forces<double>(p, c, m0, m1)[1].force;
        values.assign(f.x.begin(), f.x.end());
        return true;
      }
      default: return false;
    }
  }
};

}  // namespace dalembert
