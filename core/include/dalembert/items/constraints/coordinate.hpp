// ObjectConnectorCoordinate, specs/constraints/coordinate.toml
#pragma once

#include "dalembert/constraints/coordinate_parameters.hpp"
#include "dalembert/contracts/linear_equations.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorCoordinate : ConstrainsAll, Holonomic, VaryingDirections {
  using Parameters = ObjectConnectorCoordinateParameters;
  using Port = ScalarPort;
  static constexpr ConstraintForms closed_forms{.gap_rate = true, .reaction = true, .linear = true};
  static constexpr int equations = 1;

  // The gap is factor q1 - q0 - offset; at velocity level the offset is a velocity.
  template <class S>
  static Vec<S, 1> gap(const Parameters& p, const Context& c, const ScalarFrame<S>& m0, const ScalarFrame<S>& m1) {
    const double offset = p.offsetUserFunction ? call_scalar(p.offsetUserFunction, c, p.offset) : p.offset;
    return {p.factorValue1 * m1.value - m0.value - offset};
  }
  template <class S>
  static Vec<S, 1> gap_rate(const Parameters& p, const Context& c, const ScalarFrame<S>& m0, const ScalarFrame<S>& m1) {
    double speed = p.velocityLevel ? p.offset : 0.0;
    if (p.offsetUserFunction_t) speed = call_scalar(p.offsetUserFunction_t, c, p.offset);
    return {p.factorValue1 * m1.rate - m0.rate - speed};
  }
  template <class S, class L>
  static std::array<ScalarForce<S>, 2> reaction(const Parameters& p, const Context&, const ScalarFrame<S>&,
                                                const ScalarFrame<S>&, const Vec<L, 1>& lambda) {
    return {ScalarForce<S>{S(-lambda[0])}, ScalarForce<S>{S(p.factorValue1 * lambda[0])}};
  }
  static std::array<LinearEquation, 1> linear(const Parameters& p) { return {LinearEquation{0, {-1, p.factorValue1}}}; }
  static bool is_homogeneous(const Parameters& p) {
    return p.offset == 0 && !p.offsetUserFunction && !p.offsetUserFunction_t;
  }

  static bool output(const Parameters&, const Context&, const ScalarFrame<double>& m0, const ScalarFrame<double>& m1,
                     const Vec<double, 1>& lambda, OutputVariableType variable, std::vector<double>& values) {
    switch (variable) {
      case OutputVariableType::Displacement: values = {m1.value - m0.value}; return true;
      case OutputVariableType::Velocity: values = {m1.rate - m0.rate}; return true;
      case OutputVariableType::Force: values = {lambda[0]}; return true;
      default: return false;
    }
  }
};

}  // namespace dalembert
