// ObjectContactSphereTriangle, specs/contacts/sphere_triangle.toml
#pragma once

#include <string>

#include "dalembert/contacts/sphere_triangle_parameters.hpp"
#include "dalembert/items/contacts/body_port.hpp"
#include "dalembert/laws/touch.hpp"
#include "dalembert/math/triangle.hpp"

namespace dalembert {

struct ObjectContactSphereTriangle : AllMarkersAct, NoAlgebraicEquations, SwitchesByUpdate {
  using Parameters = ObjectContactSphereTriangleParameters;

  // Normal force and friction in the middle of the overlap, with the slip of the nearest point of the triangle, while the gap of the last update is
  // negative.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    if (!(c.data[TouchData::gap] < 0)) return;
    const Nearest<S> touch(p, body_frame(x, 0), x.template frame<RigidPort>(1));
    const Vec3<S> force = force_on_first(p, c.data, touch, normal_force(p, c.data, touch));
    push(x, 0, touch.arm0, force);
    push(x, 1, touch.arm1, -force);
  }

  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    const Nearest<double> touch = nearest(p, x);
    const double speed = h.data[TouchData::speed];
    PostNewton verdict = update_touch(p, touch, h.start, h.data);
    if (touch.gap < 0)
      verdict.error += coulomb_error(p.dynamicFriction * normal_force(p, h.data, touch), p.frictionProportionalZone,
                                     speed, h.data[TouchData::speed]);
    return verdict;
  }
  static int switch_count(const Parameters&) { return touch_switches; }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    const Nearest<double> touch = nearest(p, x);
    find_touch_switches(p, touch, c.data,
                        ImpactLaw(p, c.data[TouchData::impact]).pull_margin(-touch.gap, touch.penetration_rate),
                        switches);
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const RigidFrame<double> sphere = body_frame(x, 0);
    const RigidFrame<double>& carrier = x.frame<RigidPort>(1);
    const Nearest<double> touch(p, sphere, carrier);
    const auto vector = [&](const Vec3<double>& v) { values.assign(v.x.begin(), v.x.end()); };
    switch (variable) {
      case OutputVariableType::Displacement: vector(touch.span); return true;
      case OutputVariableType::Velocity: {
        const Vec3<double> arm = sphere.position + touch.span - carrier.position;
        vector(carrier.velocity + cross(carrier.angular_velocity, arm) - sphere.velocity);
        return true;
      }
      case OutputVariableType::Director1: vector(touch.normal); return true;
      default: break;
    }
    const bool acts = p.activeConnector && c.data[TouchData::gap] < 0;
    const Vec3<double> force = acts ? force_on_first(p, c.data, touch, normal_force(p, c.data, touch)) : Vec3<double>{};
    return touch_output(touch, sphere.position, force, variable, values);
  }

  static void check(const Parameters& p, const Connections& on) {
    require_body_port(on, 0, p.dynamicFriction);
    on.require(on.gives<RigidPort>(1), 1, "markerNumbers", "a marker with an orientation, for the triangle");
    on.require_data(TouchData::count);
    if (!(p.radiusSphere > 0)) on.refuse("radiusSphere", std::to_string(p.radiusSphere), "a positive radius");
    if (p.trianglePoints.size() != 3)
      on.refuse("trianglePoints", std::to_string(p.trianglePoints.size()) + " points", "three points");
    if (is_zero(area_vector(corners(p)))) on.refuse("trianglePoints", "points on one line", "a triangle with an area");
    if (p.includeEdges > 7) on.refuse("includeEdges", std::to_string(p.includeEdges), "a sum of 1, 2 and 4");
    if (p.impactModel > 2) on.refuse("impactModel", std::to_string(p.impactModel), "0, 1 or 2");
  }

 private:
  static Triangle corners(const Parameters& p) {
    return {p.trianglePoints[0], p.trianglePoints[1], p.trianglePoints[2]};
  }

  // The triangle rests in the frame of its marker, where the nearest point is found. Velocities are taken there.
  template <class S>
  struct Nearest : Touch<S> {
    TriangleFeature feature;
    Vec3<S> span;  // from the center of the sphere to the nearest point
    double share = 1;  // fraction of the force: triangles share it at common edges; 0: no contact there

    Nearest(const Parameters& p, const RigidFrame<S>& sphere, const RigidFrame<S>& carrier) {
      const Triangle triangle = corners(p);
      const Vec3<S> centre = transposed_times(carrier.rotation, sphere.position - carrier.position);
      feature = nearest_feature(triangle, vector_of<3>([&](int i) { return value_of(centre[i]); }));
      const Vec3<S> point = nearest_point(triangle, feature, centre), local = point - centre;
      if (!(feature.edges & p.includeEdges)) {
        const double rounding = 1e-12 * p.radiusSphere;
        const int left_out =
            ~p.includeEdges & edges_near(triangle, vector_of<3>([&](int i) { return value_of(point[i]); }), rounding);
        share = feature.is_face() || is_above(triangle, local, rounding) ? share_at(triangle, left_out) : 0;
      }
      span = carrier.rotation * local;
      this->normal = direction(span);
      this->gap = dot(this->normal, span) - p.radiusSphere;
      meet_at(span, sphere, carrier);
      this->move(sphere, carrier);
      meet_at((p.radiusSphere + 0.5 * this->gap) * this->normal, sphere, carrier);
    }

   private:
    void meet_at(const Vec3<S>& from_centre, const RigidFrame<S>& sphere, const RigidFrame<S>& carrier) {
      this->arm0 = from_centre;
      this->arm1 = sphere.position + from_centre - carrier.position;
    }
  };

  // A sphere that is nearest to an edge that is left out does not touch, unless its centre is above that edge, on the border of the face.
  static Nearest<double> nearest(const Parameters& p, const Exchange<double>& x) {
    Nearest<double> touch(p, body_frame(x, 0), x.frame<RigidPort>(1));
    if (touch.share == 0) touch.gap += p.radiusSphere;
    return touch;
  }

  template <class S>
  static bool is_above(const Triangle& triangle, const Vec3<S>& span, double rounding) {
    const Vec3<double> area = area_vector(triangle), to = vector_of<3>([&](int i) { return value_of(span[i]); });
    return norm(cross(area, to)) <= rounding * norm(area);
  }

  // During an iteration, a sphere that touches stays in contact wherever it moves.
  template <class S>
  static S normal_force(const Parameters& p, const double* data, const Nearest<S>& touch) {
    return (touch.share > 0 ? touch.share : 1) *
           ImpactLaw(p, data[TouchData::impact]).normal_force(-touch.gap, touch.penetration_rate);
  }
};

}  // namespace dalembert
