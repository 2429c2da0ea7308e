// ObjectContactConvexRoll, specs/contacts/convex_roll.toml
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "dalembert/contacts/convex_roll_parameters.hpp"
#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/laws/friction.hpp"
#include "dalembert/laws/touch.hpp"

namespace dalembert {

struct ObjectContactConvexRoll : AllMarkersAct, NoAlgebraicEquations, SwitchesByUpdate {
  using Parameters = ObjectContactConvexRollParameters;

  // Normal force and friction at the lowest point of the roll, while the gap of the last update is not positive.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    if (!(c.data[gap] <= 0)) return;
    const Touch<S> touch = lowest(p, x.template frame<RigidPort>(ground), x.template frame<RigidPort>(roll));
    const Vec3<S> force = force_on_roll(p, touch);
    x.apply(roll, Wrench<S>{force, cross(touch.arm1, force)});
    x.apply(ground, Wrench<S>{-force, -cross(touch.arm0, force)});
  }

  // Contact that opens or closes is an error.
  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    const Touch<double> touch = lowest(p, x.frame<RigidPort>(ground), x.frame<RigidPort>(roll));
    PostNewton verdict;
    if ((touch.gap > 0) != (h.data[gap] > 0)) {
      verdict.error = std::abs(touch.gap * p.contactStiffness);
      if (touch.penetration_rate != 0 && h.start[gap] > 0)
        verdict.recommended_step_size = std::abs(h.start[gap] / touch.penetration_rate);
    }
    const Vec3<double> slip = transposed_times(x.frame<RigidPort>(ground).rotation, touch.slip);
    h.data[gap] = touch.gap;
    h.data[slip_x] = slip[0];
    h.data[slip_y] = slip[1];
    return verdict;
  }
  static int switch_count(const Parameters&) { return 3; }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    const Touch<double> touch = lowest(p, x.frame<RigidPort>(ground), x.frame<RigidPort>(roll));
    const bool touches = c.data[gap] <= 0;
    switches.holds("contact", touches, touches ? -touch.gap : touch.gap);
    if (!touches) return switches.none(2);
    curve(p).find_kink(norm(touch.slip), switches);
    const double elastic = -p.contactStiffness * touch.gap;
    switches.kink("pull", pull_margin(p.limitDamping, elastic, p.contactDamping * touch.penetration_rate));
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const RigidFrame<double>& m1 = x.frame<RigidPort>(roll);
    const Touch<double> touch = lowest(p, x.frame<RigidPort>(ground), m1);
    const Vec3<double> force = p.activeConnector && c.data[gap] <= 0 ? force_on_roll(p, touch) : Vec3<double>{};
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Position: vector(m1.position + touch.arm1); return true;
      case OutputVariableType::Velocity: vector(touch.slip); return true;
      case OutputVariableType::Force: vector(force); return true;
      case OutputVariableType::Torque: vector(cross(touch.arm1, force)); return true;
      default: return false;
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    on.require_data(3);
    if (!(p.rollLength > 0)) on.refuse("rollLength", std::to_string(p.rollLength), "a positive length");
    const auto profile = [&](double at) { return Profile<double>(p, at); };
    const double end = 0.5 * p.rollLength;
    if (p.coefficientsHull.empty() || !(std::min(profile(-end).radius, profile(end).radius) >= 0) ||
        !(profile(0).radius > 0))
      on.refuse("coefficientsHull", std::to_string(p.coefficientsHull.size()) + " coefficients",
                "a polynomial that is a radius along the whole roll, highest power first");
    constexpr int pieces = 50;
    for (int i = 0; i <= pieces; ++i)
      if (const double at = end * (2.0 * i / pieces - 1); profile(at).curvature > 0)
        on.refuse("coefficientsHull", "a profile that is hollow at x = " + std::to_string(at),
                  "a convex roll: no positive second derivative of the radius");
  }

 private:
  enum Marker { ground = 0, roll = 1 };
  enum Data { gap = 0, slip_x = 1, slip_y = 2 };  // values of the last update; slip in the axes of the ground

  // Radius and its derivatives along the axis.
  template <class S>
  struct Profile {
    S radius{}, slope{}, curvature{};
    Profile(const Parameters& p, const S& x) {
      for (const double k : p.coefficientsHull) {
        curvature = curvature * x + 2.0 * slope;
        slope = slope * x + radius;
        radius = radius * x + k;
      }
    }
  };

  // Position at which the profile has a slope. The slope decreases along the roll, so that bisection is safe if
  // Newton's method fails.
  static double place_of_slope(const Parameters& p, double slope) {
    double low = -0.5 * p.rollLength, high = -low;
    const double steepest = Profile<double>(p, low).slope, flattest = Profile<double>(p, high).slope;
    if (slope == steepest && slope == flattest) return 0;  // constant along a cone
    if (!(slope < steepest)) return low;
    if (!(slope > flattest)) return high;
    double x = 0;
    for (int i = 0; i < 100; ++i) {
      const Profile<double> at(p, x);
      const double excess = at.slope - slope;
      (excess > 0 ? low : high) = x;
      double next = x - excess / at.curvature;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      if (std::abs(next - x) <= 1e-15 * p.rollLength) return next;
      x = next;
    }
    return x;
  }

  // The plane is that of the x and y axes of the ground's marker; the normal leads from it to the roll.
  template <class S>
  static Touch<S> lowest(const Parameters& p, const RigidFrame<S>& m0, const RigidFrame<S>& m1) {
    Touch<S> touch;
    touch.normal = column(m0.rotation, 2);
    const Vec3<S> up = transposed_times(m1.rotation, touch.normal);
    const Vec<S, 2> across{up[1], up[2]}, side = direction(across);
    const double end = 0.5 * p.rollLength;
    S place(value_of(up[0]) > 0 ? -end : end);
    if (const S steepness = dot(side, across); value_of(steepness) > 0) {
      const S slope = up[0] / steepness;
      place = S(place_of_slope(p, value_of(slope)));
      const Profile<S> at(p, place);
      if (std::abs(value_of(place)) < end && value_of(at.curvature) != 0) place -= (at.slope - slope) / at.curvature;
    }
    const S radius = Profile<S>(p, place).radius;
    touch.arm1 = m1.rotation * Vec3<S>{place, -(radius * side[0]), -(radius * side[1])};
    touch.arm0 = m1.position + touch.arm1 - m0.position;
    touch.gap = dot(touch.normal, touch.arm0);
    touch.move(m0, m1);
    return touch;
  }

  static StribeckCurve curve(const Parameters& p) {
    return {p.dynamicFriction, p.staticFrictionOffset, p.viscousFriction, p.exponentialDecayStatic,
            p.frictionProportionalZone};
  }
  template <class S>
  static Vec3<S> force_on_roll(const Parameters& p, const Touch<S>& touch) {
    const S elastic = -(p.contactStiffness * touch.gap);
    const S normal_force = with_losses<S>(p.limitDamping, elastic, p.contactDamping * touch.penetration_rate);
    const Vec3<S> along = direction(touch.slip);
    return normal_force * (touch.normal - curve(p)(dot(along, touch.slip)) * along);
  }
};

}  // namespace dalembert
