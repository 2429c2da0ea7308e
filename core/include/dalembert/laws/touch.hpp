// Contact of two bodies at one common point: normal force by an impact law, dry friction, and history.
#pragma once

#include <cmath>
#include <vector>

#include "dalembert/contracts/switches.hpp"
#include "dalembert/enums.hpp"
#include "dalembert/frames.hpp"
#include "dalembert/laws/friction.hpp"
#include "dalembert/laws/impact.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

// Nearest points of two surfaces, and their relative motion.
template <class S>
struct Touch {
  Vec3<S> normal;      // out of body 0, towards body 1
  Vec3<S> arm0, arm1;  // from the markers to the point in the middle of overlap or gap
  Vec3<S> velocity;  // velocity of body 1 relative to body 0, at that point
  Vec3<S> slip;        // its tangential part
  S gap, penetration_rate;

  void move(const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    velocity = m1.velocity + cross(m1.angular_velocity, arm1) - m0.velocity - cross(m0.angular_velocity, arm0);
    penetration_rate = -dot(normal, velocity);
    slip = velocity + penetration_rate * normal;
  }
};

// Data coordinates of a contact, of the last update.
struct TouchData {
  enum {
    gap = 0,
    speed = 1,
    impact = 2,
    overlap = 3,
    count = 4
  };  // impact: rate of penetration when the contact closed; overlap: plastic
};

// The speed of the last update decides whether it sticks.
template <class Parameters, class S>
Vec3<S> force_on_first(const Parameters& p, const double* data, const Touch<S>& touch, const S& normal_force) {
  const double zone = p.frictionProportionalZone;
  const Vec3<S> along = coulomb_direction(touch.slip, zone, in_zone(data[TouchData::speed], zone));
  return (p.dynamicFriction * normal_force) * along - normal_force * touch.normal;
}

// Contact that opens or closes is an error; the recommended step ends when that happens.
template <class Parameters>
PostNewton update_touch(const Parameters& p, const Touch<double>& touch, const double* start, double* data) {
  PostNewton verdict;
  if ((touch.gap > 0) != (data[TouchData::gap] > 0)) {
    verdict.error = std::abs(touch.gap * p.contactStiffness);
    if (touch.penetration_rate != 0 && start[TouchData::gap] > 0)
      verdict.recommended_step_size = std::abs(start[TouchData::gap] / touch.penetration_rate);
  }
  data[TouchData::gap] = touch.gap;
  data[TouchData::speed] = norm(touch.slip);
  data[TouchData::impact] =
      start[TouchData::gap] > 0 && touch.gap <= 0 ? touch.penetration_rate : start[TouchData::impact];
  return verdict;
}

// Contact that opens or closes; friction that begins to slide or to stick; and where losses would begin to pull.
constexpr int touch_switches = 3;
template <class Parameters>
void find_touch_switches(const Parameters& p, const Touch<double>& touch, const double* data, double pull_margin,
                         Switches& switches) {
  const bool touches = data[TouchData::gap] < 0;
  switches.holds("contact", touches, touches ? -touch.gap : touch.gap);
  if (!touches) return switches.none(touch_switches - 1);
  find_coulomb_switch(p.dynamicFriction != 0, data[TouchData::speed], norm(touch.slip), p.frictionProportionalZone,
                      switches);
  switches.kink("pull", pull_margin);
}

// Outputs that all contacts at one point share; `force` acts on body 0.
inline bool touch_output(const Touch<double>& touch, const Vec3<double>& position0, const Vec3<double>& force,
                         OutputVariableType variable, std::vector<double>& values) {
  const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
  switch (variable) {
    case OutputVariableType::Position: vector(position0 + touch.arm0); return true;
    case OutputVariableType::DisplacementLocal: values = {touch.gap}; return true;
    case OutputVariableType::Force: vector(force); return true;
    case OutputVariableType::Torque: vector(-cross(touch.arm0, force)); return true;
    default: return false;
  }
}

}  // namespace dalembert
