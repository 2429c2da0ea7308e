// ObjectConnectorRollingDiscPenalty, specs/connectors/rolling_disc_penalty.toml
#pragma once

#include <algorithm>
#include <cmath>

#include "dalembert/connectors/rolling_disc_penalty_parameters.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/laws/friction.hpp"
#include "dalembert/laws/rolling_disc.hpp"

namespace dalembert {

struct ObjectConnectorRollingDiscPenalty : HasPairHistory, SwitchesAndSettles, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectConnectorRollingDiscPenaltyParameters;
  using Port = RigidPort;
  static constexpr int data_coordinates = 3;

  // Data coordinates, of the last update: slip velocity in lateral and in forward direction, gap.
  enum Data { lateral = 0, forward = 1, gap = 2 };

  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const Context& c, const RigidFrame<S>& m0,
                                         const RigidFrame<S>& m1) {
    const RollingContact<S> contact(p, m0, m1);
    const Vec3<S> f = contact_force(p, c, contact);
    auto forces = contact.forces(f);
    if (p.rollingFrictionViscous != 0) {
      const Vec3<S> resistance = rolling_resistance(p, f[2], contact, m0, m1);
      forces[0].force -= resistance;
      forces[1].force += resistance;
    }
    return forces;
  }

  // The state of contact and the direction of slip are held fixed in Newton's method: the error is the change of forces.
  static PostNewton update(const Parameters& p, const Context&, const RigidFrame<double>& m0,
                           const RigidFrame<double>& m1, const double*, double* data) {
    const RollingContact<double> contact(p, m0, m1);
    const double now = dot(contact.arm, contact.normal), before = data[gap];
    const Slip<double> slip = slip_of(contact), assumed{data[lateral], data[forward]};
    const double normal_force = now < 0 ? normal_force_of(p, contact) : 0.0;
    const Slip<double> friction = friction_force(p, slip, slip, normal_force);
    PostNewton verdict;
    if ((now > 0) != (before > 0)) {
      verdict.error = std::abs(now * p.contactStiffness) + norm(friction);
    } else if (now < 0) {
      verdict.error = norm(friction - friction_force(p, slip, assumed, normal_force));
    }
    data[lateral] = slip[0];
    data[forward] = slip[1];
    data[gap] = now;
    return verdict;
  }
  // The direction of slip follows by and by; whether it is slip does not.
  static PostNewton settle(const Parameters& p, const Context&, const RigidFrame<double>& m0,
                           const RigidFrame<double>& m1, const double*, double* data) {
    const Slip<double> assumed{data[lateral], data[forward]};
    if (!(data[gap] < 0) || in_zone(norm(assumed), p.dryFrictionProportionalZone)) return {};
    const RollingContact<double> contact(p, m0, m1);
    const Slip<double> slip = slip_of(contact);
    const double speed = norm(slip), normal_force = normal_force_of(p, contact);
    if (speed == 0) return {};
    const Slip<double> next = slip_beyond_zone(p, slip, speed);
    PostNewton verdict;
    verdict.error = norm(friction_force(p, slip, next, normal_force) - friction_force(p, slip, assumed, normal_force));
    data[lateral] = next[0];
    data[forward] = next[1];
    return verdict;
  }

  // Contact, friction that slides, and where the plane would begin to pull.
  static int switch_count(const Parameters&) { return 3; }
  static void find_switches(const Parameters& p, const Context& c, const RigidFrame<double>& m0,
                            const RigidFrame<double>& m1, Switches& switches) {
    const RollingContact<double> contact(p, m0, m1);
    const double now = dot(contact.arm, contact.normal);
    if (!(c.data[gap] < 0)) {
      switches.holds("contact", false, now);
      return switches.none(2);
    }
    switches.holds("contact", true, -now);
    const bool has_friction = p.dryFriction[0] != 0 || p.dryFriction[1] != 0;
    find_coulomb_switch(has_friction, norm(Slip<double>{c.data[lateral], c.data[forward]}), norm(slip_of(contact)),
                        p.dryFrictionProportionalZone, switches);
    switches.kink("pull", normal_force_of(p, contact));
  }

  static bool output(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const RollingContact<double> contact(p, m0, m1);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Position: vector(contact.arm); return true;
      case OutputVariableType::Velocity: vector(trail_velocity(p, m0, m1, contact, contact.arm)); return true;
      case OutputVariableType::VelocityLocal: vector(contact.local(contact.slip)); return true;
      case OutputVariableType::ForceLocal: vector(contact_force(p, c, contact)); return true;
      case OutputVariableType::RotationMatrix: assign_contact_axes(contact, values); return true;
      default: return false;
    }
  }

 private:
  template <class S>
  using Slip = Vec<S, 2>;  // components in the plane: lateral, forward

  template <class S>
  static Slip<S> slip_of(const RollingContact<S>& contact) {
    return {dot(contact.slip, contact.lateral), dot(contact.slip, contact.forward)};
  }
  static Slip<double> slip_beyond_zone(const Parameters& p, const Slip<double>& slip, double speed) {
    constexpr double beyond = 1 + 1e-12;
    return std::max(1.0, beyond * p.dryFrictionProportionalZone / speed) * slip;
  }

  template <class S>
  static S normal_force_of(const Parameters& p, const RollingContact<S>& contact) {
    return -(p.contactStiffness * dot(contact.arm, contact.normal) +
             p.contactDamping * dot(contact.slip, contact.normal));
  }

  // Force on the disc in the contact frame.
  template <class S>
  static Vec3<S> contact_force(const Parameters& p, const Context& c, const RollingContact<S>& contact) {
    if (!(c.data[gap] < 0)) return {};
    const S normal_force = normal_force_of(p, contact);
    const Slip<S> slip = slip_of(contact);
    const Slip<S> friction = friction_force(p, slip, {c.data[lateral], c.data[forward]}, normal_force);
    return {friction[0], friction[1], normal_force};
  }

  // Against the slip; beyond the proportional zone, its direction is the assumed one.
  template <class S>
  static Slip<S> friction_force(const Parameters& p, const Slip<S>& slip, const Slip<double>& assumed,
                                const S& normal_force) {
    using std::abs;
    const double assumed_speed = norm(assumed), zone = p.dryFrictionProportionalZone;
    const bool sticking = in_zone(assumed_speed, zone);
    const S speed = value_of(slip[0]) == 0 && value_of(slip[1]) == 0 ? S(0) : norm(slip);
    if (assumed_speed == 0 || (value_of(speed) == 0 && !sticking)) return {};
    Slip<S> direction;
    if (sticking) {
      direction = coulomb_direction(slip, zone, sticking);
      if (!p.useLinearProportionalZone) direction = (2.0 - (1 / zone) * speed) * direction;
    } else {
      for (int i = 0; i < 2; ++i) direction[i] = S(assumed[i] / assumed_speed);
    }
    const double co = std::cos(p.dryFrictionAngle), si = std::sin(p.dryFrictionAngle);
    const Slip<S> turned{co * direction[0] - si * direction[1], si * direction[0] + co * direction[1]};
    Slip<S> f;
    for (int i = 0; i < 2; ++i)
      f[i] = -abs(normal_force) * (p.dryFriction[i] + p.viscousFriction[i] * speed) * turned[i];
    return {co * f[0] + si * f[1], co * f[1] - si * f[0]};
  }

  // Against the velocity of the centre along the plane, for a disc that stands upright.
  template <class S>
  static Vec3<S> rolling_resistance(const Parameters& p, const S& normal_force, const RollingContact<S>& contact,
                                    const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    using std::abs;
    const Vec3<S> velocity = m1.velocity - m0.velocity - cross(m0.angular_velocity, contact.arm);
    return (-p.rollingFrictionViscous * abs(normal_force)) *
           (velocity - dot(velocity, contact.normal) * contact.normal);
  }
};

}  // namespace dalembert
