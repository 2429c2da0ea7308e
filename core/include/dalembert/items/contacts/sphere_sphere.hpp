// ObjectContactSphereSphere, specs/contacts/sphere_sphere.toml
#pragma once

#include <algorithm>
#include <string>

#include "dalembert/contacts/sphere_sphere_parameters.hpp"
#include "dalembert/items/contacts/body_port.hpp"
#include "dalembert/laws/adhesion.hpp"
#include "dalembert/laws/touch.hpp"

namespace dalembert {

struct ObjectContactSphereSphere : AllMarkersAct, NoAlgebraicEquations, SwitchesByUpdate {
  using Parameters = ObjectContactSphereSphereParameters;

  // Normal force and friction at the middle of the overlap, while the gap of the last update is negative.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    if (!(c.data[TouchData::gap] < 0)) return;
    const Touch<S> touch = closest(p, body_frame(x, 0), body_frame(x, 1));
    const Vec3<S> force = force_on_first(p, c.data, touch, normal_force(p, c.data, touch));
    push(x, 0, touch.arm0, force);
    push(x, 1, touch.arm1, -force);
  }

  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    const Touch<double> touch = closest(p, body_frame(x, 0), body_frame(x, 1));
    const double speed = h.data[TouchData::speed];
    PostNewton verdict = update_touch(p, touch, h.start, h.data);
    h.data[TouchData::overlap] =
        touch.gap < 0 ? std::max(h.start[TouchData::overlap], AdhesiveLaw(p).plastic_overlap(-touch.gap)) : 0.0;
    if (touch.gap < 0)
      verdict.error += coulomb_error(p.dynamicFriction * normal_force(p, h.data, touch), p.frictionProportionalZone,
                                     speed, h.data[TouchData::speed]);
    return verdict;
  }
  static int switch_count(const Parameters&) { return touch_switches; }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    const Touch<double> touch = closest(p, body_frame(x, 0), body_frame(x, 1));
    find_touch_switches(p, touch, c.data, pull_margin(p, c.data, touch), switches);
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const RigidFrame<double> m0 = body_frame(x, 0), m1 = body_frame(x, 1);
    const Touch<double> touch = closest(p, m0, m1);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Displacement: vector(m1.position - m0.position); return true;
      case OutputVariableType::Velocity: vector(touch.velocity); return true;
      case OutputVariableType::Director1: vector(touch.normal); return true;
      default: break;
    }
    const bool acts = p.activeConnector && c.data[TouchData::gap] < 0;
    const Vec3<double> force = acts ? force_on_first(p, c.data, touch, normal_force(p, c.data, touch)) : Vec3<double>{};
    return touch_output(touch, m0.position, force, variable, values);
  }

  static void check(const Parameters& p, const Connections& on) {
    for (int marker = 0; marker < 2; ++marker) require_body_port(on, marker, p.dynamicFriction);
    on.require_data(TouchData::count);
    const double r0 = p.spheresRadii[0], r1 = p.spheresRadii[1];
    const std::string received = "[" + std::to_string(r0) + ", " + std::to_string(r1) + "]";
    if (!(r0 > 0 && r1 > 0))
      on.refuse("spheresRadii", received, "two positive radii, of the spheres at markers m0 and m1");
    if (p.isHollowSphere1 && !(r0 < r1))
      on.refuse("spheresRadii", received, "a hollow sphere 1 that is larger than sphere 0");
    if (p.impactModel > 2) on.refuse("impactModel", std::to_string(p.impactModel), "0, 1 or 2");
    if (!(p.contactPlasticityRatio < 1))
      on.refuse("contactPlasticityRatio", std::to_string(p.contactPlasticityRatio), "0 or more, and less than 1");
  }

 private:
  template <class S>
  static Touch<S> closest(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    const double side = p.isHollowSphere1 ? -1 : 1;
    const Vec3<S> span = m1.position - m0.position;
    Touch<S> touch;
    touch.normal = side * direction(span);
    touch.gap = dot(touch.normal, span) - p.spheresRadii[0] - side * p.spheresRadii[1];
    touch.arm0 = (p.spheresRadii[0] + 0.5 * touch.gap) * touch.normal;
    touch.arm1 = touch.arm0 - span;
    touch.move(m0, m1);
    return touch;
  }
  template <class S>
  static S normal_force(const Parameters& p, const double* data, const Touch<S>& touch) {
    if (p.impactModel != 0)
      return ImpactLaw(p, data[TouchData::impact]).normal_force(-touch.gap, touch.penetration_rate);
    const S lossless = AdhesiveLaw(p).normal_force(-touch.gap, data[TouchData::overlap]);
    return with_losses<S>(p.limitDamping, lossless, p.contactDamping * touch.penetration_rate);
  }
  static double pull_margin(const Parameters& p, const double* data, const Touch<double>& touch) {
    if (p.impactModel != 0)
      return ImpactLaw(p, data[TouchData::impact]).pull_margin(-touch.gap, touch.penetration_rate);
    const double lossless = AdhesiveLaw(p).normal_force(-touch.gap, data[TouchData::overlap]);
    return dalembert::pull_margin(p.limitDamping, lossless, p.contactDamping * touch.penetration_rate);
  }
};

}  // namespace dalembert
