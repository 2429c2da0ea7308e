// ObjectJointRollingDisc, specs/joints/rolling_disc.toml
#pragma once

#include "dalembert/contracts/pair.hpp"
#include "dalembert/laws/rolling_disc.hpp"
#include "dalembert/joints/rolling_disc_parameters.hpp"

namespace dalembert {

struct ObjectJointRollingDisc : VaryingDirections, NoConstraintForms {
  using Parameters = ObjectJointRollingDiscParameters;
  using Port = RigidPort;
  static constexpr int equations = 3;
  static constexpr bool nonholonomic = true;

  static bool constrains(const Parameters& p, int k) { return p.constrainedAxes[static_cast<std::size_t>(k)] != 0; }

  // The lowest point of the disc does not slip on the plane.
  template <class S>
  static Vec3<S> gap_rate(const Parameters& p, const Context&, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const RollingContact<S> contact(p, m0, m1);
    return contact.local(contact.slip);
  }
  template <class S>
  static std::array<Wrench<S>, 2> reaction(const Parameters& p, const Context&, const RigidFrame<S>& m0,
                                           const RigidFrame<S>& m1, const Vec3<double>& lambda) {
    return RollingContact<S>(p, m0, m1).forces({S(lambda[0]), S(lambda[1]), S(lambda[2])});
  }

  static bool output(const Parameters& p, const Context&, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     const Vec3<double>& lambda, OutputVariableType variable, std::vector<double>& values) {
    const RollingContact<double> contact(p, m0, m1);
    const Vec3<double> point = m1.position + contact.radius;
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Position: vector(point); return true;
      case OutputVariableType::Velocity: vector(trail_velocity(p, m0, m1, contact, contact.arm)); return true;
      case OutputVariableType::ForceLocal: vector(-lambda); return true;
      case OutputVariableType::RotationMatrix: assign_contact_axes(contact, values); return true;
      default: return false;
    }
  }
};

}  // namespace dalembert
