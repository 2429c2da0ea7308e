// ObjectConnectorGravity, specs/connectors/gravity.toml
#pragma once

#include <cmath>

#include "dalembert/connectors/gravity_parameters.hpp"
#include "dalembert/contracts/line_of_action.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"

namespace dalembert {

struct ObjectConnectorGravity : NoPairHistory, NoConnectorForms {
  using Parameters = ObjectConnectorGravityParameters;
  using Port = PointPort;

  // Attraction along the line between the points.
  template <class S>
  static std::array<Force<S>, 2> forces(const Parameters& p, const Context& c, const PointFrame<S>& m0,
                                        const PointFrame<S>& m1) {
    const Vec3<S> f = attraction(p, c, m0, m1);
    return {Force<S>{f}, Force<S>{-f}};
  }

  static bool output(const Parameters& p, const Context& c, const PointFrame<double>& m0, const PointFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Vec3<double> span = m1.position - m0.position;
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Distance: values = {norm(span)}; return true;
      case OutputVariableType::Displacement: vector(span); return true;
      case OutputVariableType::PotentialEnergy:
        values = {p.activeConnector ? potential(p, norm(span)) : 0.0};
        return true;
      case OutputVariableType::Force:
        vector(p.activeConnector ? attraction(p, c, m0, m1) : Vec3<double>{});
        return true;
      default: return false;
    }
  }

 private:
  // Integral of the force from infinity; closer than r, it is c/(d^2 + (r - d)^2).
  static double potential(const Parameters& p, double distance) {
    const double near = p.minDistanceRegularization, c = p.gravitationalConstant * p.mass0 * p.mass1;
    if (distance >= near) return -c / distance;
    return -c / near * (1 + std::atan(1.0) - std::atan(2 * distance / near - 1));
  }

  // Points that coincide do not attract each other if the force is regularized.
  template <class S>
  static Vec3<S> attraction(const Parameters& p, const Context& c, const PointFrame<S>& m0, const PointFrame<S>& m1) {
    const double near = p.minDistanceRegularization;
    if (coincide(m0, m1)) {
      if (near == 0)
        refuse_coinciding(c, "ObjectConnectorGravity", "Keep the masses apart or set minDistanceRegularization");
      return {};
    }
    const LineOfAction<S> line(m0, m1);
    S square = dot(line.span, line.span);
    if (line.length < near) square += (near - line.length) * (near - line.length);
    return (p.gravitationalConstant * p.mass0 * p.mass1 / square) * line.axis;
  }
};

}  // namespace dalembert
