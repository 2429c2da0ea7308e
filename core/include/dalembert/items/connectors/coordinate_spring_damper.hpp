// ObjectConnectorCoordinateSpringDamper, specs/connectors/coordinate_spring_damper.toml
#pragma once

#include "dalembert/connectors/coordinate_spring_damper_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/span_forces.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorCoordinateSpringDamper : NoPairHistory {
  using Parameters = ObjectConnectorCoordinateSpringDamperParameters;
  using Port = ScalarPort;
  static constexpr ConnectorForms closed_forms{.tangent = true};

  template <class S>
  static std::array<ScalarForce<S>, 2> forces(const Parameters& p, const Context& c, const ScalarFrame<S>& m0,
                                              const ScalarFrame<S>& m1) {
    const S f = tension<S>(p, c, m1.value - m0.value, m1.rate - m0.rate);
    return {ScalarForce<S>{f}, ScalarForce<S>{-f}};
  }
  static bool has_tangent(const Parameters& p) { return !p.springForceUserFunction; }
  template <class S>
  static SpanTangent<1> tangent(const Parameters& p, const ScalarFrame<S>&, const ScalarFrame<S>&) {
    return {{p.stiffness}, {p.damping}};
  }

  static bool output(const Parameters& p, const Context& c, const ScalarFrame<double>& m0,
                     const ScalarFrame<double>& m1, OutputVariableType variable, std::vector<double>& values) {
    const double span = m1.value - m0.value, rate = m1.rate - m0.rate;
    switch (variable) {
      case OutputVariableType::Displacement: values = {span}; return true;
      case OutputVariableType::Velocity: values = {rate}; return true;
      case OutputVariableType::Force: values = {p.activeConnector ? tension(p, c, span, rate) : 0.0}; return true;
      case OutputVariableType::PotentialEnergy:
        values = {p.activeConnector ? 0.5 * p.stiffness * (span - p.offset) * (span - p.offset) : 0.0};
        return !p.springForceUserFunction;
      default: return false;
    }
  }

 private:
  template <class S>
  static S tension(const Parameters& p, const Context& c, const S& span, const S& rate) {
    if (p.springForceUserFunction)
      return call_scalar(p.springForceUserFunction, c, span, rate, p.stiffness, p.damping, p.offset);
    return p.stiffness * (span - p.offset) + p.damping * rate;
  }
};

}  // namespace dalembert
