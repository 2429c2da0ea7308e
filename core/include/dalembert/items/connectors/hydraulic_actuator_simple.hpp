// ObjectConnectorHydraulicActuatorSimple, specs/connectors/hydraulic_actuator_simple.toml: forces on two points, and the
// pressures in its chambers as first order coordinates.
#pragma once

#include <array>
#include <string>

#include "dalembert/connectors/hydraulic_actuator_simple_parameters.hpp"
#include "dalembert/contracts/line_of_action.hpp"
#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/nodes/generic_ode1_parameters.hpp"

namespace dalembert {

struct ObjectConnectorHydraulicActuatorSimple : AllMarkersAct, NoAlgebraicEquations, NoHistory {
  using Parameters = ObjectConnectorHydraulicActuatorSimpleParameters;

  // The pressures are the unknowns, their rates the equations.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    const LineOfAction<S> line = line_of(c, x);
    const Vec3<S> f = tension(p, line, x) * line.axis;
    x.apply(0, f);
    x.apply(1, -f);
    for (int k = 0; k < 2; ++k) x.equations[k] = pressure_rate(p, c, Chamber(p, k), line, x.unknowns[k]);
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const LineOfAction<double> line = line_of(c, x);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Distance: values = {line.length}; return true;
      case OutputVariableType::Displacement: vector(line.span); return true;
      case OutputVariableType::Velocity:
        vector(x.frame<PointPort>(1).velocity - x.frame<PointPort>(0).velocity);
        return true;
      case OutputVariableType::VelocityLocal: values = {line.rate}; return true;
      case OutputVariableType::Force: vector((p.activeConnector ? tension(p, line, x) : 0.0) * line.axis); return true;
      default: return false;
    }
  }

  static void check(const Parameters&, const Connections& connections) {
    const Placement& on = connections.placement();
    const std::string expected = "a list with one NodeGenericODE1 of two coordinates, the pressures";
    if (on.nodes.size() != 1) connections.refuse("nodeNumbers", std::to_string(on.nodes.size()) + " nodes", expected);
    if (on.ode1.size() != 2)
      connections.refuse("nodeNumbers", "a node with " + std::to_string(on.ode1.size()) + " ODE1 coordinates",
                         expected);
    for (const double x :
         static_cast<const NodeGenericODE1Record*>(on.node_records[0])->parameters.referenceCoordinates)
      if (x != 0)
        refuse(ErrorKind::value,
               {connections.item(), "nodeNumbers", "a reference coordinate of the node is " + std::to_string(x), "",
                "reference coordinates that are zero", "State the pressures at the start as initialCoordinates"});
  }

 private:
  template <class S>
  static LineOfAction<S> line_of(const Context& c, const Exchange<S>& x) {
    const PointFrame<S>&m0 = x.template frame<PointPort>(0), &m1 = x.template frame<PointPort>(1);
    if (coincide(m0, m1))
      refuse_coinciding(c, "ObjectConnectorHydraulicActuatorSimple", "Keep the length of the actuator above zero");
    return {m0, m1};
  }

  // Tension along the line between the points.
  template <class S>
  static S tension(const Parameters& p, const LineOfAction<S>& line, const Exchange<S>& x) {
    return p.chamberCrossSection1 * x.unknowns[1] - p.chamberCrossSection0 * x.unknowns[0] +
           p.actuatorDamping * line.rate;
  }

  template <class S>
  static S signed_root(const S& x) {
    using std::sqrt;
    if (value_of(x) == 0) return S(0);
    return x < 0.0 ? -sqrt(-x) : sqrt(x);
  }

  struct Chamber {
    double area, sign, hose_volume, valve;  // sign: change of its volume with the stroke

    Chamber(const Parameters& p, int k)
        : area(k == 0 ? p.chamberCrossSection0 : p.chamberCrossSection1),
          sign(k == 0 ? 1 : -1),
          hose_volume(k == 0 ? p.hoseVolume0 : p.hoseVolume1),
          valve(k == 0 ? p.valveOpening0 : p.valveOpening1) {}
  };

  // Rate of the pressure in one chamber, from the motion of the piston and the flow through its valve.
  template <class S>
  static S pressure_rate(const Parameters& p, const Context& c, const Chamber& chamber, const LineOfAction<S>& line,
                         const S& pressure) {
    S volume(chamber.hose_volume), compliance(1 / p.oilBulkModulus);
    if (p.useChamberVolumeChange) {
      const S stroke = line.length - p.offsetLength;
      const S swept = chamber.area * (chamber.sign > 0 ? stroke : p.strokeLength - stroke);
      volume += swept;
      if (value_of(volume) == 0)
        refuse(ErrorKind::value,
               {"object " + std::to_string(c.item) + " (ObjectConnectorHydraulicActuatorSimple)", "hoseVolume0",
                "the volume of a chamber vanishes at time " + std::to_string(c.time), "", "",
                "Increase hoseVolume0 and hoseVolume1, or keep the stroke within its limits"});
      if (p.cylinderBulkModulus != 0) compliance += swept / (volume * p.cylinderBulkModulus);
      if (p.hoseBulkModulus != 0) compliance += chamber.hose_volume / (volume * p.hoseBulkModulus);
    }
    const S drop = chamber.valve >= 0 ? p.systemPressure - pressure : pressure - p.tankPressure;
    const S flow = chamber.valve * p.nominalFlow * signed_root(drop);
    return (flow - chamber.sign * chamber.area * line.rate) / (compliance * volume);
  }
};

}  // namespace dalembert
