// ObjectContactSphereTorus, specs/contacts/sphere_torus.toml
#pragma once

#include <cmath>
#include <string>

#include "dalembert/contacts/sphere_torus_parameters.hpp"
#include "dalembert/laws/impact.hpp"
#include "dalembert/contracts/pair.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

struct ObjectContactSphereTorus : HasPairHistory, AlwaysNeedsData, NoConnectorForms {
  using Parameters = ObjectContactSphereTorusParameters;
  using Port = RigidPort;
  static constexpr int data_coordinates = 4;

  // Data coordinates, of the last update: gap, tangential speed, rate of penetration when the contact closed; the last is free.
  enum Data { gap = 0, speed = 1, impact = 2 };

  template <class S>
  static std::array<Wrench<S>, 2> forces(const Parameters& p, const Context& c, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    if (!(c.data[gap] < 0)) return {};
    const Touch<S> touch(p, c, m0, m1);
    const Vec3<S> force = force_on_sphere(p, c.data, touch);
    return {Wrench<S>{force, cross(touch.sphere_arm, force)}, Wrench<S>{-force, -cross(touch.torus_arm, force)}};
  }

  // Contact that opens or closes is an error; the recommended step ends when that happens. Sticking and sliding change from one
  // step to the next.
  static PostNewton update(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                           const double* start, double* data) {
    const Touch<double> touch(p, c, m0, m1);
    PostNewton verdict;
    if ((touch.gap > 0) != (data[gap] > 0)) {
      verdict.error = std::abs(touch.gap * p.contactStiffness);
      if (touch.penetration_rate != 0 && start[gap] > 0)
        verdict.recommended_step_size = std::abs(start[gap] / touch.penetration_rate);
    }
    data[gap] = touch.gap;
    data[speed] = norm(touch.slip);
    data[impact] = start[gap] > 0 && touch.gap <= 0 ? touch.penetration_rate : start[impact];
    return verdict;
  }

  static bool output(const Parameters& p, const Context& c, const RigidFrame<double>& m0, const RigidFrame<double>& m1,
                     OutputVariableType variable, std::vector<double>& values) {
    const Touch<double> touch(p, c, m0, m1);
    const Vec3<double> span = m1.position - m0.position;
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    const auto force = [&] {
      return p.activeConnector && c.data[gap] < 0 ? force_on_sphere(p, c.data, touch) : Vec3<double>{};
    };
    switch (variable) {
      case OutputVariableType::Position: vector(m0.position + touch.sphere_arm); return true;
      case OutputVariableType::Displacement: vector(span); return true;
      case OutputVariableType::DisplacementLocal: values = {touch.gap}; return true;
      case OutputVariableType::Director1: vector(direction(span)); return true;
      case OutputVariableType::Director2: vector(touch.radial); return true;
      case OutputVariableType::Director3: vector(touch.normal); return true;
      case OutputVariableType::Force: vector(force()); return true;
      case OutputVariableType::Torque: vector(-cross(touch.sphere_arm, force())); return true;
      default: return false;
    }
  }

 private:
  // A unit vector, or zero if there is no direction.
  template <class S>
  static Vec3<S> direction(const Vec3<S>& v) {
    const S square = dot(v, v);
    if (value_of(square) == 0) return {};
    using std::sqrt;
    return (1.0 / sqrt(square)) * v;
  }

  // Where sphere and torus are closest, and how they move there.
  template <class S>
  struct Touch {
    Vec3<S> radial, normal;         // from the centre of the torus to its centre line; from there to the sphere
    Vec3<S> sphere_arm, torus_arm;  // from the markers to the point in the middle of the overlap
    Vec3<S> slip;                   // tangential velocity of the torus against the sphere
    S gap, penetration_rate;

    Touch(const Parameters& p, const Context& c, const RigidFrame<S>& sphere, const RigidFrame<S>& torus) {
      const Vec3<S> axis = torus.rotation * p.torusAxis, span = sphere.position - torus.position;
      radial = direction(span - dot(axis, span) * axis);
      if (value_of(dot(radial, radial)) == 0)
        refuse(ErrorKind::value, {"object " + std::to_string(c.item) + " (ObjectContactSphereTorus)", "markerNumbers",
                                  "the centre of the sphere lies on the axis of the torus at time " + std::to_string(c.time), "", "",
                                  "The sphere has to be inside the tube of the torus"});
      const Vec3<S> line = p.torusMajorRadius * radial, offset = span - line;
      normal = direction(offset);
      gap = p.torusMinorRadius - p.radiusSphere - dot(normal, offset);
      sphere_arm = (p.radiusSphere + 0.5 * gap) * normal;
      torus_arm = line + (p.torusMinorRadius - 0.5 * gap) * normal;
      const Vec3<S> velocity = torus.velocity + cross(torus.angular_velocity, torus_arm) - sphere.velocity -
                               cross(sphere.angular_velocity, sphere_arm);
      penetration_rate = -dot(normal, velocity);
      slip = velocity + penetration_rate * normal;
    }
  };

  // Friction grows with the slip while the speed of the last update lies in the proportional zone.
  template <class S>
  static Vec3<S> force_on_sphere(const Parameters& p, const double* data, const Touch<S>& touch) {
    const S f = ImpactLaw(p, data[impact]).pressure(-touch.gap, touch.penetration_rate);
    const bool sticking = p.frictionProportionalZone != 0 && data[speed] < p.frictionProportionalZone;
    const Vec3<S> against = sticking ? (1 / p.frictionProportionalZone) * touch.slip : direction(touch.slip);
    return (p.dynamicFriction * f) * against - f * touch.normal;
  }
};

}  // namespace dalembert
