// ObjectConnectorReevingSystemSprings, specs/connectors/reeving_system_springs.toml: a rope over any number of sheaves.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dalembert/connectors/reeving_system_springs_parameters.hpp"
#include "dalembert/contracts/many_ports.hpp"

namespace dalembert {
namespace reeving {

using Parameters = ObjectConnectorReevingSystemSpringsParameters;

template <class S>
Vec3<double> value_of(const Vec3<S>& v) {
  return {dalembert::value_of(v[0]), dalembert::value_of(v[1]), dalembert::value_of(v[2])};
}

// A circle about its axis; a point if its radius is zero.
template <class S>
struct Circle {
  Vec3<S> centre, axis;
  double radius;
};

// The contact vector of a circle as a function of an angle, in a basis made of its axis and the line of centres.
template <class S>
struct Contact {
  Vec3<S> cosine{}, sine{};  // contact vector: cosine * cos(angle) - sine * sin(angle)

  template <class Other>
  Contact(const Contact<Other>& other)
    requires std::is_same_v<S, double>
      : cosine(value_of(other.cosine)), sine(value_of(other.sine)) {}
  Contact(const Circle<S>& circle, const Vec3<S>& normal) : sine(circle.radius * normal) {
    cosine = cross(sine, circle.axis);
  }
  Vec3<S> at(const S& angle) const {
    using std::cos;
    using std::sin;
    return cos(angle) * cosine - sin(angle) * sine;
  }
};

// The common tangent of two circles: its contact points relative to their centers. Both contact vectors are
// determined by the sine between the first axis and the line of centers: the second radius is exact for axes at the
// same angle to that line.
template <class S>
struct Tangent {
  Vec3<S> first{}, second{};
  bool found = true;

  Tangent(const Circle<S>& a, const Circle<S>& b) {
    if (a.radius == 0 && b.radius == 0) return;
    const Vec3<S> centres = b.centre - a.centre;
    const Vec3<S> normal = cross(a.axis, centres);
    const S scale = 1.0 / norm(normal);
    const Contact<S> on_a(a, scale * normal), on_b(b, scale * cross(b.axis, centres));
    found = solve(Contact<double>(on_a), Contact<double>(on_b), value_of(centres), {a.radius, b.radius});
    // One more step of Newton's method, with the derivatives of the residual, gives the derivatives of the angles.
    const Vec3<S> r0 = on_a.at(S(angle_[0])), r1 = on_b.at(S(angle_[1]));
    const S f0 = dot(centres + r1, r0) - a.radius * a.radius, f1 = dot(centres - r0, r1) + b.radius * b.radius;
    first = on_a.at(angle_[0] - (inverse_[0] * f0 + inverse_[1] * f1));
    second = on_b.at(angle_[1] - (inverse_[2] * f0 + inverse_[3] * f1));
  }

 private:
  static constexpr int iterations = 8;

  // Newton's method for the angles at which both contact vectors are normal to the tangent.
  bool solve(const Contact<double>& on_a, const Contact<double>& on_b, const Vec3<double>& centres,
             std::array<double, 2> radii) {
    const double sum = radii[0] + radii[1], tolerance = 1e-12 * sum * (norm(centres) + sum);
    for (int i = 0; i < iterations; ++i) {
      const Vec3<double> r0 = on_a.at(angle_[0]), r1 = on_b.at(angle_[1]);
      const Vec3<double> d0 = on_a.at(angle_[0] + right), d1 = on_b.at(angle_[1] + right);
      const double f0 = dot(centres + r1, r0) - radii[0] * radii[0], f1 = dot(centres - r0, r1) + radii[1] * radii[1];
      double j00 = dot(centres + r1, d0), j01 = dot(d1, r0), j10 = -dot(d0, r1), j11 = dot(centres - r0, d1);
      if (dot(d0, d0) == 0) j00 = 1;
      if (dot(d1, d1) == 0) j11 = 1;
      const double determinant = j00 * j11 - j01 * j10;
      if (!std::isfinite(determinant) || determinant == 0) return false;
      inverse_ = {j11 / determinant, -j01 / determinant, -j10 / determinant, j00 / determinant};
      if (std::hypot(f0, f1) <= tolerance) return true;
      angle_[0] -= inverse_[0] * f0 + inverse_[1] * f1;
      angle_[1] -= inverse_[2] * f0 + inverse_[3] * f1;
    }
    return false;
  }

  static constexpr double right = std::numbers::pi / 2;
  std::array<double, 2> angle_{right, right};
  std::array<double, 4> inverse_{1, 0, 0, 1};  // inverse of the Jacobian, row by row
};

// One free span: unit direction, length, and its contribution to the rate of the rope's length.
template <class S>
struct Span {
  Vec3<S> direction{}, velocity{};  // velocity of its end relative to its start
  S length{}, rate{};

  Span(const RigidFrame<S>& a, const RigidFrame<S>& b, const Tangent<S>& touch) {
    const Vec3<S> line = b.position + touch.second - a.position - touch.first;
    velocity =
        b.velocity + cross(b.angular_velocity, touch.second) - a.velocity - cross(a.angular_velocity, touch.first);
    if (dot(value_of(line), value_of(line)) == 0) return;
    length = norm(line);
    direction = (1.0 / length) * line;
    rate = dot(velocity, direction);
  }
};

inline double saturated(double x) { return std::tanh(x); }
template <int N>
Dual<N> saturated(const Dual<N>& x) {
  const double t = std::tanh(x.value);
  return x.chain(t, 1 - t * t);
}

// Markers of one rope: rigid ones along it, and the two coordinates that add rope at its ends.
template <class S>
struct Rope {
  std::vector<RigidFrame<S>> frames;
  std::array<ScalarFrame<S>, 2> ends{};
  std::vector<Tangent<S>> touches;
  std::vector<Span<S>> spans;
  S length{}, rate{}, force{};

  Rope(const Parameters& p, const Context& c, const Exchange<S>& x) {
    const int n = rigid_markers(p, x.markers());
    for (int i = 0; i < n; ++i) frames.push_back(x.template frame<RigidPort>(i));
    for (int i = n; i < x.markers(); ++i) ends[static_cast<std::size_t>(i - n)] = x.template frame<ScalarPort>(i);
    const auto circle = [&](int i) {
      return Circle<S>{frames[i].position, frames[i].rotation * p.sheavesAxes[i], p.sheavesRadii[i]};
    };
    for (int i = 0; i + 1 < n; ++i) {
      const Circle<S> a = circle(i);
      touches.emplace_back(a, circle(i + 1));
      if (!touches[i].found) refuse_geometry(c, i);
      spans.emplace_back(frames[i], frames[i + 1], touches[i]);
      length += spans[i].length;
      rate += spans[i].rate;
      if (i > 0 && a.radius != 0) length += arc(a, touches[i - 1].second, touches[i].first);
    }
    force = tension(p);
  }

  static int rigid_markers(const Parameters& p, int markers) { return markers - (p.hasCoordinateMarkers ? 2 : 0); }

  // Tension at both ends of every span, at the points where it touches the sheaves.
  std::vector<Wrench<S>> wrenches(const Parameters& p) const {
    std::vector<Wrench<S>> w(frames.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const Span<S>& span = spans[i];
      Vec3<S> f = force * span.direction, moment{};
      if (p.dampingShear != 0 && dalembert::value_of(span.length) != 0)
        f += (p.dampingShear / span.length) * (span.velocity - span.rate * span.direction);
      if (p.dampingTorsional != 0)
        moment =
            (p.dampingTorsional * dot(frames[i + 1].angular_velocity - frames[i].angular_velocity, span.direction)) *
            span.direction;
      w[i].force += f;
      w[i].moment += moment + cross(touches[i].first, f);
      w[i + 1].force -= f;
      w[i + 1].moment -= moment + cross(touches[i].second, f);
    }
    return w;
  }

 private:
  // Length of rope on a sheave, in the sense of rotation of its axis, less than a full turn.
  static S arc(const Circle<S>& sheave, const Vec3<S>& from, const Vec3<S>& to) {
    using std::atan2;
    S angle = atan2(dot(cross(sheave.axis, from), to), dot(from, to));
    if (angle < 0.0) angle += S(2 * std::numbers::pi);
    return sheave.radius * angle;
  }

  S tension(const Parameters& p) {
    S own(p.referenceLength), own_rate(0);
    for (int k = 0; k < 2; ++k) {
      own += p.coordinateFactors[k] * ends[k].value;
      own_rate += p.coordinateFactors[k] * ends[k].rate;
    }
    // Points of pulleys move with the rope that they add: their velocities contain its rate.
    const S stretch_rate = p.turningEnds ? rate : rate - own_rate;
    if (p.turningEnds) rate += own_rate;
    const S stretch = p.stiffnessPerLength * (length - own) + p.dampingPerLength * stretch_rate;
    const S f = dalembert::value_of(own) == 0 ? 1e3 * stretch : stretch / own;
    const double limit = p.regularizationForce;
    return limit > 0 && f < 0.0 ? limit * saturated((1 / limit) * f) : f;
  }

  [[noreturn]] static void refuse_geometry(const Context& c, int i) {
    refuse(ErrorKind::value,
           {"object " + std::to_string(c.item) + " (ObjectConnectorReevingSystemSprings)", "sheavesAxes",
            "the sheaves " + std::to_string(i) + " and " + std::to_string(i + 1) + " have no common tangent at time " +
                std::to_string(c.time),
            "", "sheaves that do not overlap, and axes that are not parallel to the line between their centres", ""});
  }
};

}  // namespace reeving

struct ObjectConnectorReevingSystemSprings : AllMarkersAct, NoAlgebraicEquations, NoHistory {
  using Parameters = ObjectConnectorReevingSystemSpringsParameters;

  template <class S>
  static void evaluate(const Parameters& p, const Context& c, Exchange<S>& x) {
    const reeving::Rope<S> rope(p, c, x);
    const auto wrenches = rope.wrenches(p);
    const int n = static_cast<int>(wrenches.size());
    for (int i = 0; i < n; ++i) x.apply(i, wrenches[static_cast<std::size_t>(i)]);
    for (int i = n; i < x.markers(); ++i)
      x.apply(i, S((p.turningEnds ? 0.0 : p.coordinateFactors[i - n]) * rope.force));
  }

  static bool output(const Parameters& p, const Context& c, const Exchange<double>& x, OutputVariableType variable,
                     std::vector<double>& values) {
    const reeving::Rope<double> rope(p, c, x);
    switch (variable) {
      case OutputVariableType::Distance: values = {rope.length}; return true;
      case OutputVariableType::VelocityLocal: values = {rope.rate}; return true;
      case OutputVariableType::ForceLocal: values = {p.activeConnector ? rope.force : 0.0}; return true;
      default: return false;
    }
  }

  static void check(const Parameters& p, const Connections& on) {
    const int count = on.markers(), n = reeving::Rope<double>::rigid_markers(p, count);
    const std::string also = n == count ? "" : " and two coordinate markers";
    if (n < 2) on.refuse("markerNumbers", std::to_string(count) + " markers", "at least two rigid body markers" + also);
    for (int i = 0; i < count; ++i)
      on.require(i < n ? on.gives<RigidPort>(i) : on.gives<ScalarPort>(i), i, "markerNumbers",
                 i < n ? "a rigid body marker" : "a marker of a single coordinate");
    const std::string each = ", one for each of the " + std::to_string(n) + " rigid body markers";
    if (static_cast<int>(p.sheavesAxes.size()) != n)
      on.refuse("sheavesAxes", std::to_string(p.sheavesAxes.size()) + " axes", std::to_string(n) + " axes" + each);
    if (static_cast<int>(p.sheavesRadii.size()) != n)
      on.refuse("sheavesRadii", std::to_string(p.sheavesRadii.size()) + " radii", std::to_string(n) + " radii" + each);
    if (p.turningEnds && n == count)
      on.refuse("turningEnds", "True, without coordinate markers",
                "hasCoordinateMarkers=True: they measure the rotations");
    if (p.regularizationForce == 0) on.refuse("regularizationForce", "0", "a positive or a negative force");
  }
};

}  // namespace dalembert
