// ObjectConnectorCartesianSpringDamper, specs/connectors/cartesian_spring_damper.toml
#pragma once

#include "dalembert/connectors/cartesian_spring_damper_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/span_forces.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorCartesianSpringDamper : NoPairHistory {
  using Parameters = ObjectConnectorCartesianSpringDamperParameters;
  using Port = PointPort;
  static constexpr ConnectorForms closed_forms{.tangent = true};

  // Each global axis has one spring.
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context& c, const PointFrame<S>& m0,
                                        const PointFrame<S>& m1) {
    const Vec3<S> f = tension<S>(p, c, elongation(p, m0, m1), m1.velocity - m0.velocity);
    return {Force<S>{f}, Force<S>{-f}};
  }
  static bool has_tangent(const Parameters& p) { return !p.springForceUserFunction; }
  template <class S>
  static SpanTangent<3> tangent(const Parameters& p, const PointFrame<S>&, const PointFrame<S>&) {
    SpanTangent<3> t;
    for (int i = 0; i < 3; ++i) t.by_span(i, i) = p.stiffness[i], t.by_rate(i, i) = p.damping[i];
    return t;
  }

  static bool output(const Parameters& p, const Context& c, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Vec3<double> span = elongation(p, m0, m1), rate = m1.velocity - m0.velocity;
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Displacement: vector(span); return true;
      case OutputVariableType::Distance: values = {norm(span)}; return true;
      case OutputVariableType::Velocity: vector(rate); return true;
      case OutputVariableType::Force:
        vector(p.activeConnector ? tension<double>(p, c, span, rate) : Vec3<double>{});
        return true;
      case OutputVariableType::PotentialEnergy: {
        double energy = 0;
        for (int i = 0; i < 3; ++i) energy += 0.5 * p.stiffness[i] * span[i] * span[i];
        values = {p.activeConnector ? energy : 0.0};
        return !p.springForceUserFunction;
      }
      default: return false;
    }
  }

 private:
  template <class S>
  static Vec3<S> elongation(const Parameters& p, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    return m1.position - m0.position - p.offset;
  }

  template <class S>
  static Vec3<S> tension(const Parameters& p, const Context& c, const Vec3<S>& span, const Vec3<S>& rate) {
    if (p.springForceUserFunction) {
      CallArguments<S, 15> arguments;
      arguments.vector(span).vector(rate).vector(p.stiffness).vector(p.damping).vector(p.offset);
      return evaluate<3>(p.springForceUserFunction, c, arguments);
    }
    Vec3<S> f;
    for (int i = 0; i < 3; ++i) f[i] = p.stiffness[i] * span[i] + p.damping[i] * rate[i];
    return f;
  }
};

}  // namespace dalembert
