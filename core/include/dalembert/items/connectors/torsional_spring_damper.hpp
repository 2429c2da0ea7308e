// ObjectConnectorTorsionalSpringDamper, specs/connectors/torsional_spring_damper.toml
#pragma once

#include <numbers>

#include "dalembert/connectors/torsional_spring_damper_parameters.hpp"
#include "dalembert/contracts/joint_frames.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/contracts/user_function.hpp"

namespace dalembert {

struct ObjectConnectorTorsionalSpringDamper : HasPairHistory, NoSwitches, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectConnectorTorsionalSpringDamperParameters;
  using Port = RigidPort;
  static constexpr int data_coordinates = 1;

  // A torque about the z-axis of the first joint frame.
  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const Context& c, const RigidFrame<S>& m0,
                                         const RigidFrame<S>& m1) {
    const Rotation<S> r(p, c, m0, m1);
    const Vec3<S> moment = torque(p, c, r) * r.axis;
    return {Wrench<S>{.moment = moment}, Wrench<S>{.moment = -moment}};
  }

  // The data coordinate follows the angle, so that it counts full turns.
  static PostNewton update(const Parameters& p, const Context& c, const RigidFrame<double>& m0,
                           const RigidFrame<double>& m1, const double*, double* data) {
    data[0] = Rotation<double>(p, c, m0, m1).angle;
    return {};
  }

  static bool output(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Rotation<double> r(p, c, m0, m1);
    switch (variable) {
      case OutputVariableType::Rotation: values = {r.angle}; return true;
      case OutputVariableType::AngularVelocityLocal: values = {r.rate}; return true;
      case OutputVariableType::TorqueLocal: values = {p.activeConnector ? torque(p, c, r) : 0.0}; return true;
      case OutputVariableType::PotentialEnergy: {
        const double turn = r.angle - p.offset;
        values = {p.activeConnector ? 0.5 * p.stiffness * turn * turn + p.torque * turn : 0.0};
        return !p.springTorqueUserFunction;
      }
      default: return false;
    }
  }

 private:
  template <class S>
  struct Rotation {
    Vec3<S> axis;
    S angle, rate;

    Rotation(const Parameters& p, const Context& c, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
      using std::atan2;
      const JointAxes<S> axes(p, m0, m1);
      axis = column(axes.A_0i, 2);
      rate = dot(axis, m1.angular_velocity - m0.angular_velocity);
      const Vec3<S> x1 = column(axes.A_0j, 0), y1 = column(axes.A_0j, 1), x0 = column(axes.A_0i, 0);
      angle = atan2(-dot(x0, y1), dot(x0, x1));  // third Tait-Bryan angle of the relative rotation
      if (c.data != nullptr) angle = angle + 2 * std::numbers::pi * turns(c.data[0] - value_of(angle));
    }
    static double turns(double difference) {
      return std::abs(difference) > std::numbers::pi ? std::round(difference / (2 * std::numbers::pi)) : 0.0;
    }
  };

  template <class S>
  static S torque(const Parameters& p, const Context& c, const Rotation<S>& r) {
    if (p.springTorqueUserFunction)
      return call_scalar(p.springTorqueUserFunction, c, r.angle, r.rate, p.stiffness, p.damping, p.offset);
    return p.stiffness * (r.angle - p.offset) + p.damping * (r.rate - p.velocityOffset) + p.torque;
  }
};

}  // namespace dalembert
