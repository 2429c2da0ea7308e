// ObjectContactCurveCircles, specs/contacts/curve_circles.toml
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "dalembert/contacts/curve_circles_parameters.hpp"
#include "dalembert/contracts/many_ports.hpp"
#include "dalembert/laws/touch.hpp"

namespace dalembert {

struct ObjectContactCurveCircles : AllMarkersAct, NoAlgebraicEquations, SwitchesByUpdate {
  using Parameters = ObjectContactCurveCirclesParameters;

  // Normal force and friction on the circle that the last update has found at a segment.
  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    for (int segment = 0; segment < segments(p); ++segment) {
      const Data at(c.data, segment);
      if (!at.touches(circles(p))) continue;
      const Meeting<S> touch(p, Segment(p, segment), at.circle(), Centre<S>(p, x, at.circle()));
      const Vec3<S> force = touch.direct(-force_on_curve(p, at, touch));
      const Vec3<S> arm = touch.direct(touch.arm), span = touch.span + arm;
      x.apply(1 + at.circle(), Wrench<S>{force, cross(arm, force)});
      x.apply(0, Wrench<S>{-force, -cross(span, force)});
    }
  }

  // A segment contacts the circle with the largest penetration, as long as they are in contact. Opening or closing
  // counts as an error.
  static constexpr bool has_history = true;
  static PostNewton update(const Parameters& p, const Context&, const Exchange<double>& x, const History& h) {
    PostNewton verdict;
    const Centres centres(p, x);
    for (int segment = 0; segment < segments(p); ++segment) {
      Data now(h.data, segment);
      const Segment at(p, segment);
      double* data = h.data + 3 * segment;
      const double before = now.gap();
      data[Data::which] = -1;
      data[Data::distance] = std::numeric_limits<double>::max();
      double error = 0;
      const auto meet = [&](int circle) {
        const Meeting<double> touch(p, at, circle, centres.of(circle));
        data[Data::distance] = touch.gap;
        data[Data::slip] = touch.slip;
        error = std::abs(p.contactDamping * touch.rate - p.contactStiffness * touch.gap);
        if (touch.gap < 0 && touch.normal_force(p) > 0) data[Data::which] = circle;
      };
      int nearest = -1;
      for (int circle = 0; circle < circles(p); ++circle) {
        const double gap = centres.gap(at, circle, data[Data::distance]);
        if (!(gap < data[Data::distance])) continue;
        data[Data::distance] = gap;
        nearest = circle;
        if (gap < 0) meet(circle);
      }
      if (nearest >= 0 && data[Data::distance] >= 0) meet(nearest);
      if ((now.gap() > 0) != (before > 0)) verdict.error = std::max(verdict.error, error);
    }
    return verdict;
  }

  // The contact of a segment ends if the normal force vanishes, or if another circle has a larger penetration.
  static int switch_count(const Parameters& p) { return 3 * segments(p); }
  static void find_switches(const Parameters& p, const Context& c, const Exchange<double>& x, Switches& switches) {
    const Centres centres(p, x);
    for (int segment = 0; segment < segments(p); ++segment) {
      const Segment line(p, segment);
      const Data at(c.data, segment);
      const int touched = at.touches(circles(p)) ? at.circle() : -1;
      double own = 0, nearest = std::numeric_limits<double>::max(), pressed = 0, slip = 0;
      int tested = touched;  // without a contact: the nearest circle
      for (int circle = 0; circle < circles(p); ++circle) {
        if (circle == touched) continue;
        const double gap = centres.gap(line, circle, nearest);
        if (!(gap < nearest)) continue;
        nearest = gap;
        if (touched < 0) tested = circle;
      }
      if (tested >= 0) {
        const Meeting<double> touch(p, line, tested, centres.of(tested));
        pressed = touch.normal_force(p, false);
        if (touched >= 0) own = touch.gap, slip = touch.slip;
      }
      if (touched < 0) {
        switches.holds("contact", false, std::max(nearest, -pressed));
        switches.none(2);
        continue;
      }
      switches.holds("contact", true, std::min(-own, pressed));
      switches.passes("circle", nearest - own);
      find_coulomb_switch(p.dynamicFriction != 0, at.speed(), std::abs(slip), p.frictionProportionalZone, switches);
    }
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const std::size_t count = static_cast<std::size_t>(circles(p));
    std::vector<double> gaps(count, std::numeric_limits<double>::max()), rates(count), forces(2 * count);
    const Centres centres(p, x);
    for (int segment = 0; segment < segments(p); ++segment)
      for (int circle = 0; circle < circles(p); ++circle) {
        const std::size_t i = static_cast<std::size_t>(circle);
        const Data at(c.data, segment);
        const bool acts = p.activeConnector && at.touches(circles(p)) && at.circle() == circle;
        const Segment line(p, segment);
        const bool is_nearest = centres.gap(line, circle, gaps[i]) < gaps[i];
        if (!acts && !is_nearest) continue;
        const Meeting<double> touch(p, line, circle, centres.of(circle));
        if (is_nearest) gaps[i] = touch.gap, rates[i] = -touch.rate;
        if (!acts) continue;
        const Vec<double, 2> force = force_on_curve(p, at, touch);
        forces[2 * i] -= dot(touch.normal, force);
        forces[2 * i + 1] -= dot(touch.tangent(), force);
      }
    switch (variable) {
      case OutputVariableType::DisplacementLocal: values = gaps; return true;
      case OutputVariableType::VelocityLocal: values = rates; return true;
      case OutputVariableType::ForceLocal: values = forces; return true;
      default: return false;
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    if (on.markers() < 2)
      on.refuse("markerNumbers", std::to_string(on.markers()) + " markers",
                "a marker for the curve, and one for every circle");
    if (circles(p) != on.markers() - 1)
      on.refuse("circlesRadii", std::to_string(circles(p)) + " radii",
                std::to_string(on.markers() - 1) + ", one for every circle marker");
    for (const double radius : p.circlesRadii)
      if (!(radius > 0)) on.refuse("circlesRadii", std::to_string(radius), "positive radii");
    if (!p.segmentsData.dense || p.segmentsData.columns != 4 || p.segmentsData.rows == 0)
      on.refuse("segmentsData", size(p.segmentsData), "a dense matrix with a row [x0, y0, x1, y1] per segment");
    for (int i = 0; i < segments(p); ++i)
      if (!(Segment(p, i).length > 0))
        on.refuse("segmentsData", "row " + std::to_string(i) + " without length", "segments between different points");
    if (!p.polynomialData.empty())
      on.refuse("polynomialData", size(p.polynomialData),
                "an empty matrix: segments are straight, divide the curve into more of them");
    if (p.contactModel > 1) on.refuse("contactModel", std::to_string(p.contactModel), "0 or 1");
    on.require_data(3 * segments(p));
  }

 private:
  static int segments(const Parameters& p) { return p.segmentsData.rows; }
  static int circles(const Parameters& p) { return static_cast<int>(p.circlesRadii.size()); }
  static std::string size(const MatrixContainer& m) {
    return std::string(m.dense ? "a matrix" : "a sparse matrix") + " of " + std::to_string(m.rows) + " x " +
           std::to_string(m.columns);
  }

  // Data of one segment, from the last update.
  struct Data {
    enum { which = 0, distance = 1, slip = 2 };
    const double* values;
    Data(const double* data, int segment) : values(data + 3 * segment) {}
    int circle() const { return static_cast<int>(std::lround(values[which])); }  // -1: none
    double gap() const { return values[distance]; }
    double speed() const { return std::abs(values[slip]); }
    // Users write data coordinates, too, also of circles that are not there.
    bool touches(int circles) const { return gap() < 0 && circle() >= 0 && circle() < circles; }
  };

  struct Segment {
    Vec<double, 2> begin, along;  // along: a unit vector
    double length;
    Segment(const Parameters& p, int i) {
      const double* row = p.segmentsData.values.data() + 4 * i;
      begin = {row[0], row[1]};
      along = {row[2] - row[0], row[3] - row[1]};
      length = norm(along);
      if (length > 0) along = (1 / length) * along;
    }
    Vec<double, 2> outward() const { return {along[1], -along[0]}; }
    // From its nearest point.
    template <class S>
    Vec<S, 2> distance_to(const Vec<S, 2>& from_begin) const {
      const S place = dot(along, from_begin);
      return from_begin - (place < 0.0 ? S(0) : place > length ? S(length) : place) * along;
    }
  };

  // A circle and its motion in the axes of the curve.
  template <class S>
  struct Centre {
    Mat3<S> axes;
    Vec3<S> span;             // from the marker of the curve to the centre, in global axes
    Vec<S, 2> place, motion;  // of the centre; velocity relative to the curve
    S spin;                   // angular velocity relative to the curve, about its axis
    Centre(const Parameters& p, const Exchange<S>& x, int circle)
        : Centre(x.template frame<RigidPort>(0).rotation * p.rotationMarker0, x, circle) {}
    Centre(const Mat3<S>& axes_of_curve, const Exchange<S>& x, int circle) : axes(axes_of_curve) {
      const RigidFrame<S>&m0 = x.template frame<RigidPort>(0), &m1 = x.template frame<RigidPort>(1 + circle);
      span = m1.position - m0.position;
      const Vec3<S> at = transposed_times(axes, span);
      const Vec3<S> moves = transposed_times(axes, m1.velocity - m0.velocity - cross(m0.angular_velocity, span));
      place = {at[0], at[1]};
      motion = {moves[0], moves[1]};
      spin = transposed_times(axes, m1.angular_velocity - m0.angular_velocity)[2];
    }
  };

  // All circles: they are the same for all segments.
  class Centres {
   public:
    Centres(const Parameters& p, const Exchange<double>& x) : radii_(p.circlesRadii) {
      const Mat3<double> axes = x.frame<RigidPort>(0).rotation * p.rotationMarker0;
      for (int circle = 0; circle < circles(p); ++circle) centres_.emplace_back(axes, x, circle);
    }
    const Centre<double>& of(int circle) const { return centres_[static_cast<std::size_t>(circle)]; }
    // The gap of a circle if it is below the limit, and the limit otherwise.
    double gap(const Segment& at, int circle, double limit) const {
      const double radius = radii_[static_cast<std::size_t>(circle)], reach = limit + radius;
      const Vec<double, 2> distance = at.distance_to(of(circle).place - at.begin);
      const double square = dot(distance, distance);
      return reach > 0 && square < reach * reach ? std::sqrt(square) - radius : limit;
    }

   private:
    std::vector<Centre<double>> centres_;
    const std::vector<double>& radii_;
  };

  template <class S>
  static S norm_or_zero(const Vec<S, 2>& v) {
    using std::sqrt;
    const S square = dot(v, v);
    return value_of(square) > 0 ? sqrt(square) : S(0);
  }

  // A circle at a segment, in the axes of the curve.
  template <class S>
  struct Meeting {
    Mat3<S> axes;
    Vec3<S> span;  // from the marker of the curve to the center of the circle
    Vec<S, 2> normal{}, arm{};  // normal: from the segment to the circle; arm: from its center to the contact point
    S gap, rate, slip;  // rate: of penetration; slip: of the circle relative to the curve, along the tangent
    S extent{}, extent_rate{};  // length times penetration, or the area that both share

    Meeting(const Parameters& p, const Segment& at, int circle, const Centre<S>& centre)
        : axes(centre.axes), span(centre.span) {
      const double radius = p.circlesRadii[static_cast<std::size_t>(circle)];
      const Vec<S, 2> from_begin{centre.place[0] - at.begin[0], centre.place[1] - at.begin[1]};
      const Vec<S, 2> distance = at.distance_to(from_begin);
      const S length = norm_or_zero(distance);
      gap = length - radius;
      S depth = gap;
      if (p.contactModel == 0) {
        if (value_of(length) > 0) normal = (1.0 / length) * distance;
      } else {
        normal = {S(at.outward()[0]), S(at.outward()[1])};
        depth = dot(normal, from_begin) - radius;
      }
      arm = -(radius + 0.5 * depth) * normal;
      const Vec<S, 2> velocity{centre.motion[0] - centre.spin * arm[1], centre.motion[1] + centre.spin * arm[0]};
      rate = -dot(normal, velocity);
      slip = dot(tangent(), velocity);
      if (p.contactModel == 0) {
        extent = -(at.length * gap);
        extent_rate = at.length * rate;
      } else {
        const S along = dot(at.along, from_begin);
        share(radius, depth + radius, -along, at.length - along);
      }
    }
    Vec<S, 2> tangent() const { return {-normal[1], normal[0]}; }
    Vec3<S> direct(const Vec<S, 2>& v) const { return axes * Vec3<S>{v[0], v[1], S(0)}; }
    S normal_force(const Parameters& p, bool limited = true) const {
      return with_losses<S>(limited, p.contactStiffness * extent, p.contactDamping * extent_rate);
    }

   private:
    // The area between the circle and the segment: the line is at `height` from the center, and goes from `begin` to
    // `end`.
    void share(double radius, const S& height, S begin, S end) {
      using std::atan2;
      using std::sqrt;
      const S square = radius * radius - height * height;
      if (!(value_of(square) > 0)) return;
      const S half = sqrt(square);
      if (begin < -half) begin = -half;
      if (end > half) end = half;
      if (!(begin < end)) return;
      const auto under = [&](const S& s) {
        const S rest = radius * radius - s * s;
        const S side = value_of(rest) > 0 ? sqrt(rest) : S(0);
        return 0.5 * (s * side + radius * radius * atan2(s, side));
      };
      extent = under(end) - under(begin) - height * (end - begin);
      extent_rate = (end - begin) * rate;
    }
  };

  // The speed of the last update decides whether it sticks.
  template <class S>
  static Vec<S, 2> force_on_curve(const Parameters& p, const Data& data, const Meeting<S>& touch) {
    const S normal_force = touch.normal_force(p);
    const double zone = p.frictionProportionalZone;
    const S along = coulomb_direction(touch.slip, zone, in_zone(data.speed(), zone));
    return (p.dynamicFriction * normal_force * along) * touch.tangent() - normal_force * touch.normal;
  }
};

}  // namespace dalembert
