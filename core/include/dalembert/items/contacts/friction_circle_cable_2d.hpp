// ObjectContactFrictionCircleCable2D, specs/contacts/friction_circle_cable_2d.toml
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "dalembert/contacts/friction_circle_cable_2d_parameters.hpp"
#include "dalembert/items/contacts/circle_on_cable.hpp"
#include "dalembert/laws/friction.hpp"

namespace dalembert {

struct ObjectContactFrictionCircleCable2D : AllMarkersAct, NoAlgebraicEquations, SwitchesByItself {
  using Parameters = ObjectContactFrictionCircleCable2DParameters;

  // Normal and tangential force per segment while the gap of the last update is not positive, shared by the ends of the segment.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      if (c.data[i] > 0) continue;
      const Touching<S> touch(p, x, i);
      const S normal = normal_force(p, touch), tangential = tangential_force(p, c.data, i, touch, normal);
      const CablePoints<S> points(x.values(cable));
      const RigidFrame<S>& centre = x.template frame<RigidPort>(circle);
      for (int end = 0; end < 2; ++end) {
        const Vec<S, 2> from_centre = points.position(i + end) - Vec<S, 2>{centre.position[0], centre.position[1]};
        const Vec<S, 2> n = p.useSegmentNormals ? touch.direction : direction(from_centre);
        const S share = end == 0 ? 1.0 - touch.place : touch.place;
        const Vec<S, 2> friction = (share * tangential) * turned(n), force = (share * normal) * n + friction;
        const std::span<S> on_cable = x.forces(cable);
        for (int d = 0; d < 2; ++d) on_cable[2 * (i + end) + d] -= force[d];
        on_cable[points.way_at()] -= dot(friction, points.along(i + end));
        const S moment = from_centre[0] * force[1] - from_centre[1] * force[0];
        x.apply(circle, Wrench<S>{{force[0], force[1], S(0)}, {S(0), S(0), moment}});
      }
    }
  }

  // Contact that opens or closes is an error, and so is sticking that slides.
  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    PostNewton verdict;
    const int segments = p.numberOfContactSegments;
    for (int i = 0; i < segments; ++i) {
      const Touching<double> touch(p, x, i);
      if ((touch.gap > 0) != (h.data[i] > 0)) verdict.error += std::abs((touch.gap - h.data[i]) * p.contactStiffness);
      h.data[i] = touch.gap;
      double& state = h.data[segments + i];
      if (!(touch.gap <= 0) || (p.frictionStiffness == 0 && p.frictionVelocityPenalty == 0)) {
        state = undefined;
        continue;
      }
      verdict.error += update_friction(p, touch, h.start[segments + i] == undefined, h.start[2 * segments + i], state,
                                       h.data[2 * segments + i]);
    }
    return verdict;
  }

  // A segment has four switches: contact; tensile damping force; sliding that ends or reverses; and a normal force
  // that is large enough for springs to hold a sliding point.
  static int switch_count(const Parameters& p) { return 4 * p.numberOfContactSegments; }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      const Touching<double> touch(p, x, i);
      if (c.data[i] > 0) {
        switches.holds("contact", false, touch.gap);
        switches.none(3);
        continue;
      }
      switches.holds("contact", true, -touch.gap);
      const double elastic = -p.contactStiffness * touch.gap;
      switches.kink("pull", pull_margin(p.limitDamping, elastic, -p.contactDamping * touch.away));
      find_friction_switches(p, c.data, i, touch, switches);
    }
  }
  // A point that stops sliding sticks at its position, with the same force.
  static void switch_over(const Parameters& p, const Context& c, const Exchange<double>& x, const History& h) {
    update(p, c, x, h);
    const int segments = p.numberOfContactSegments;
    for (int i = 0; i < segments; ++i) {
      const double before = h.start[segments + i];
      if (!(h.data[i] <= 0) || std::abs(before) != 1 || p.frictionStiffness == 0) continue;
      const Touching<double> touch(p, x, i);
      if (before * touch.along >= 0) continue;
      h.data[segments + i] = stick;
      h.data[2 * segments + i] = law(p).anchor(touch.way, touch.along, before * bound(p, touch));
    }
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    using enum OutputVariableType;
    if (variable != Coordinates && variable != Coordinates_t && variable != ForceLocal) return false;
    values.assign(2 * static_cast<std::size_t>(p.numberOfContactSegments), 0.0);
    for (int i = 0; i < p.numberOfContactSegments; ++i) {
      if (c.data[i] > 0) continue;
      const Touching<double> touch(p, x, i);
      const double normal = normal_force(p, touch);
      double &along = values[2 * static_cast<std::size_t>(i)], &across = values[2 * static_cast<std::size_t>(i) + 1];
      switch (variable) {
        case Coordinates:
          along = sticks(p, c.data, i) ? way_from(p, touch, c.data[2 * p.numberOfContactSegments + i]) : 0,
          across = touch.gap;
          break;
        case Coordinates_t: along = touch.along, across = touch.away; break;
        default: along = tangential_force(p, c.data, i, touch, normal), across = normal;
      }
    }
    return true;
  }

  static void check(const Parameters& p, const Connections& on) {
    on.require(on.gives<RigidPort>(circle), circle, "markerNumbers", "a marker with an orientation for the circle");
    check_circle_on_cable(on, cable, p.numberOfContactSegments);
    on.require_data(3 * p.numberOfContactSegments);
  }

 private:
  enum Marker { circle = 0, cable = 1 };
  static constexpr double stick = 0, undefined = -2;  // states; or slip, by the sign of the tangential force

  template <class S>
  static Vec<S, 2> turned(const Vec<S, 2>& n) {
    return {-n[1], n[0]};
  }

  // How a segment moves along the circle, and where the two lie against each other.
  template <class S>
  struct Touching : CircleOnCable<S> {
    S away, along;  // velocities of the segment against the surface of the circle
    S way;  // displacement of circumference and material

    Touching(const Parameters& p, const Exchange<S>& x, int segment)
        : CircleOnCable<S>(PointFrame<S>{frame(x).position, frame(x).velocity}, CablePoints<S>(x.values(cable)),
                           segment, p.circleRadius) {
      const RigidFrame<S>& centre = frame(x);
      const CablePoints<S> points(x.values(cable));
      const Vec<S, 2>&n = this->direction, t = turned(n);
      away = dot(n, this->velocity);
      const Vec<S, 2> material =
          this->velocity + points.way_rate() * (points.along(segment) +
                                                this->place * (points.along(segment + 1) - points.along(segment)));
      along = dot(t, material) - p.circleRadius * centre.angular_velocity[2];
      const Vec3<S> on_circle = transposed_times(centre.rotation, Vec3<S>{n[0], n[1], S(0)});
      using std::atan2;
      const S round = value_of(dot(n, n)) > 0 ? S(p.circleRadius * atan2(on_circle[1], on_circle[0])) : S(0);
      const S way_of_material = this->place * points.segment_length() - points.way();
      const bool alike = dot(t, points.position(segment + 1) - points.position(segment)) > 0.0;
      way = alike ? round - way_of_material : round + way_of_material;
    }

   private:
    static const RigidFrame<S>& frame(const Exchange<S>& x) { return x.template frame<RigidPort>(circle); }
  };

  template <class S>
  static S normal_force(const Parameters& p, const Touching<S>& touch) {
    const S elastic = -(p.contactStiffness * touch.gap);
    return -with_losses<S>(p.limitDamping, elastic, -p.contactDamping * touch.away);
  }
  static double bound(const Parameters& p, const Touching<double>& touch) {
    return p.frictionCoefficient * std::abs(normal_force(p, touch));
  }
  static void find_friction_switches(const Parameters& p, const double* data, int i, const Touching<double>& touch,
                                     Switches& switches) {
    const double state = data[p.numberOfContactSegments + i], limit = bound(p, touch),
                 noise = StickSlip::rounding * limit;
    if (state == undefined) return switches.none(2);
    const double held = holding_force(p, touch, data[2 * p.numberOfContactSegments + i]);
    if (state != stick && p.frictionStiffness == 0)
      switches.holds("friction", true, std::abs(held) - limit, noise);
    else
      law(p).find_switch(state, held, touch.along, limit, switches);
    if (state == stick || p.frictionStiffness == 0)
      switches.none();
    else
      switches.holds("grip", false, state * held - limit, noise);
  }

  // Displacement since the last sticking position, modulo whole turns.
  template <class S>
  static S way_from(const Parameters& p, const Touching<S>& touch, double last) {
    const double turn = 2 * std::numbers::pi * p.circleRadius;
    const S way = touch.way - last;
    return way - std::floor(value_of(way) / turn + 0.5) * turn;
  }
  static StickSlip law(const Parameters& p) { return {p.frictionStiffness, p.frictionVelocityPenalty}; }
  // Force of spring and damper, or of the damper only.
  template <class S>
  static S holding_force(const Parameters& p, const Touching<S>& touch, double last) {
    return p.frictionStiffness == 0 ? p.frictionVelocityPenalty * touch.along
                                    : law(p).holding_force(way_from(p, touch, last), touch.along);
  }
  static bool sticks(const Parameters& p, const double* data, int i) {
    return p.frictionStiffness != 0 && data[p.numberOfContactSegments + i] == stick;
  }
  template <class S>
  static S tangential_force(const Parameters& p, const double* data, int i, const Touching<S>& touch, const S& normal) {
    using std::abs;
    const double state = data[p.numberOfContactSegments + i];
    if (std::abs(state) == 1) return (state * p.frictionCoefficient) * abs(normal);
    if (!sticks(p, data, i)) return p.frictionVelocityPenalty * touch.along;
    return law(p).holding_force(way_from(p, touch, data[2 * p.numberOfContactSegments + i]), touch.along);
  }

  // Sticking ends when the force of spring and damper exceeds the limit; during sliding, the sticking position
  // follows at the limit.
  static double update_friction(const Parameters& p, const Touching<double>& touch, bool begins, double last,
                                double& state, double& position) {
    if (begins && p.frictionStiffness != 0) last = touch.way;
    const double displacement = p.frictionStiffness != 0 ? way_from(p, touch, last) : touch.along;
    const double limit = bound(p, touch), excess = std::abs(holding_force(p, touch, last)) - limit;
    const double sign = displacement > 0 ? 1 : displacement < 0 ? -1 : 0;
    const double next = excess > 0 ? sign : stick;
    if (excess <= 0)
      position = last;
    else if (p.frictionStiffness != 0)
      position = law(p).anchor(touch.way, 0, sign < 0 ? -limit : limit);
    else
      position = last;
    const double error = state == next ? 0 : std::abs(excess);
    state = next;
    return error;
  }
};

}  // namespace dalembert
