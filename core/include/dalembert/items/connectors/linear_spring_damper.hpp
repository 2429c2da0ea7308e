// ObjectConnectorLinearSpringDamper, specs/connectors/linear_spring_damper.toml
#pragma once

#include "dalembert/connectors/linear_spring_damper_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/user_function.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"

namespace dalembert {

struct ObjectConnectorLinearSpringDamper : NoPairHistory, NoConnectorForms {
  using Parameters = ObjectConnectorLinearSpringDamperParameters;
  using Port = RigidPort;

  // A pair of opposite forces in the direction of an axis that turns with the first marker.
  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const Context& c, const RigidFrame<S>& m0,
                                         const RigidFrame<S>& m1) {
    const Slide<S> slide(p, m0, m1);
    const Vec3<S> f = tension(p, c, slide) * slide.axis;
    return {Wrench<S>{.force = f}, Wrench<S>{.force = -f}};
  }

  static bool output(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Slide<double> slide(p, m0, m1);
    switch (variable) {
      case OutputVariableType::Displacement: {
        const Vec3<double> span = m1.position - m0.position;
        values.assign(span.x.begin(), span.x.end());
        return true;
      }
      case OutputVariableType::DisplacementLocal: values = {slide.displacement}; return true;
      case OutputVariableType::VelocityLocal: values = {slide.velocity}; return true;
      case OutputVariableType::ForceLocal: values = {p.activeConnector ? tension(p, c, slide) : 0.0}; return true;
      case OutputVariableType::PotentialEnergy: {
        const double stretch = slide.displacement - p.offset;
        values = {p.activeConnector ? 0.5 * p.stiffness * stretch * stretch + p.force * stretch : 0.0};
        return !p.springForceUserFunction;
      }
      default: return false;
    }
  }

 private:
  template <class S>
  struct Slide {
    Vec3<S> axis;
    S displacement, velocity;

    Slide(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1)
        : axis(m0.rotation * p.axisMarker0),
          displacement(dot(axis, m1.position - m0.position)),
          velocity(dot(axis, m1.velocity - m0.velocity)) {}
  };

  template <class S>
  static S tension(const Parameters& p, const Context& c, const Slide<S>& slide) {
    if (p.springForceUserFunction)
      return call_scalar(p.springForceUserFunction, c, slide.displacement, slide.velocity, p.stiffness, p.damping,
                         p.offset);
    return p.stiffness * (slide.displacement - p.offset) + p.damping * (slide.velocity - p.velocityOffset) + p.force;
  }
};

}  // namespace dalembert
