// Common part of NodePointSlope12 and NodePointSlope23, specs/nodes/point_slope12.toml and point_slope23.toml:
// position and two slope vectors, which define the frame of the node.
#pragma once

#include <string>

#include "dalembert/contracts/element.hpp"
#include "dalembert/math/slope_frame.hpp"
#include "dalembert/model/errors.hpp"

namespace dalembert {

// Three axes as columns of a rotation.
template <class S>
Mat3<S> from_axes(const Vec3<S>& x, const Vec3<S>& y, const Vec3<S>& z) {
  return {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
}

// x along the first slope, z normal to both.
struct AxesOfPlate {
  template <class S>
  static SlopeFrame<S> frame(const Vec3<S>& slope_x, const Vec3<S>& slope_y) {
    return {slope_x, -slope_y};
  }
  template <class S>
  static Mat3<S> rotation(const SlopeFrame<S>& f) {
    return from_axes(f.lead, Vec3<S>(-f.side), f.normal);
  }
  template <class S>
  static Vec3<S> spin(const SlopeFrame<S>& f, const Vec3<S>& rate_x, const Vec3<S>& rate_y) {
    return f.spin(rate_x, -rate_y);
  }
  template <class S>
  static std::array<Vec3<S>, 2> pull_back(const SlopeFrame<S>& f, const Vec3<S>& moment) {
    const auto [x, y] = f.pull_back(moment);
    return {x, -y};
  }
};

// z along the second slope, x normal to both.
struct AxesOfSection {
  template <class S>
  static SlopeFrame<S> frame(const Vec3<S>& slope_y, const Vec3<S>& slope_z) {
    return {slope_z, slope_y};
  }
  template <class S>
  static Mat3<S> rotation(const SlopeFrame<S>& f) {
    return from_axes(f.normal, f.side, f.lead);
  }
  template <class S>
  static Vec3<S> spin(const SlopeFrame<S>& f, const Vec3<S>& rate_y, const Vec3<S>& rate_z) {
    return f.spin(rate_z, rate_y);
  }
  template <class S>
  static std::array<Vec3<S>, 2> pull_back(const SlopeFrame<S>& f, const Vec3<S>& moment) {
    const auto [z, y] = f.pull_back(moment);
    return {y, z};
  }
  template <class S>
  static std::array<Vec3<S>, 2> pull_back_rate(const SlopeFrame<S>& f, const Vec3<S>& moment, const Vec3<S>& rate_y,
                                               const Vec3<S>& rate_z) {
    const auto [z, y] = f.pull_back_rate(moment, rate_z, rate_y);
    return {y, z};
  }
};

// Rotation, angular velocity and acceleration of the frame that slopes a and b span, with their rates.
template <class Axes, class S>
void turn_with_slopes(Motion<S>& m, const std::array<Vec3<S>, 3>& a, const std::array<Vec3<S>, 3>& b) {
  const auto frame = Axes::frame(a[0], b[0]);
  m.rotation = Axes::rotation(frame);
  m.angular_velocity = Axes::spin(frame, a[1], b[1]);
  if constexpr (std::is_same_v<S, double>)  // only outputs ask for it
    m.angular_acceleration = rate_of(
        Axes::spin(Axes::frame(moving(a[0], a[1]), moving(b[0], b[1])), moving(a[1], a[2]), moving(b[1], b[2])));
}

template <class Axes>
struct NodeWithSlopes : NoNodeOutputs {
  static constexpr int size = 9;
  static constexpr NodeTraits traits{.translations = 3};

  static void check_slopes(const Vec<double, size>& reference, const Vec<double, size>& initial,
                           const ItemLabel& item) {
    check_slopes(reference, "referenceCoordinates", item);
    check_slopes(reference + initial, "initialCoordinates", item);
  }
  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    const auto slope = [&x](int first) {
      return std::array{segment<3>(x.q, first), segment<3>(x.v, first), segment<3>(x.a, first)};
    };
    Motion<S> m{.position = segment<3>(x.q, 0), .velocity = segment<3>(x.v, 0), .acceleration = segment<3>(x.a, 0)};
    turn_with_slopes<Axes>(m, slope(3), slope(6));
    return m;
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>& x, const Vec3<S>& force, const Vec3<S>& moment) {
    const auto couple = Axes::pull_back(Axes::frame(segment<3>(x.q, 3), segment<3>(x.q, 6)), moment);
    return joined(joined(force, couple[0]), couple[1]);
  }

 private:
  static void check_slopes(const Vec<double, size>& total, const char* name, const ItemLabel& item) {
    const Vec3<double> a = segment<3>(total, 3), b = segment<3>(total, 6);
    if (!(norm(cross(a, b)) > 1e-10 * norm(a) * norm(b)))
      refuse(ErrorKind::value, {item, name, "the slope vectors are parallel, or have no length", "",
                                "two independent slope vectors; unit vectors if nothing is deformed", ""});
  }
};

}  // namespace dalembert
