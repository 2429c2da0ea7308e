// NodePoint2DSlope1, specs/nodes/point_2d_slope1.toml: planar position and slope vector; the frame turns with the slope.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/nodes/point_2d_slope1_parameters.hpp"

namespace dalembert {

struct NodePoint2DSlope1 : NoNodeOutputs {
  using Parameters = NodePoint2DSlope1Parameters;
  static constexpr std::string_view item = "NodePoint2DSlope1";
  static constexpr int size = 4;
  static constexpr NodeTraits traits{.translations = 2};

  static void check(const Parameters& p, const ItemLabel& item) {
    Vec<double, 2> slope = segment<2>(p.referenceCoordinates, 2);
    if (norm(slope) == 0) refuse_slope("referenceCoordinates", item);
    slope += segment<2>(p.initialCoordinates, 2);
    if (norm(slope) == 0) refuse_slope("initialCoordinates", item);
  }

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    using std::sqrt;
    const S o(0);
    const S square = x.q[2] * x.q[2] + x.q[3] * x.q[3];
    const S scale = 1.0 / sqrt(square), c = scale * x.q[2], s = scale * x.q[3];
    const S rate = (x.q[2] * x.v[3] - x.q[3] * x.v[2]) / square;
    const S stretch = (x.q[2] * x.v[2] + x.q[3] * x.v[3]) / square;
    const S acceleration = (x.q[2] * x.a[3] - x.q[3] * x.a[2]) / square - 2.0 * stretch * rate;
    return {.position = {x.q[0], x.q[1], o},
            .velocity = {x.v[0], x.v[1], o},
            .acceleration = {x.a[0], x.a[1], o},
            .rotation = {c, -s, o, s, c, o, o, o, S(1)},
            .angular_velocity = {o, o, rate},
            .angular_acceleration = {o, o, acceleration}};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>& x, const Vec3<S>& force, const Vec3<S>& moment) {
    const S m = moment[2] / (x.q[2] * x.q[2] + x.q[3] * x.q[3]);
    return {force[0], force[1], -(x.q[3] * m), x.q[2] * m};
  }

 private:
  [[noreturn]] static void refuse_slope(const char* name, const ItemLabel& item) {
    refuse(ErrorKind::value, {item, name, "the slope vector has no length", "",
                              "a slope vector along the axis, of length 1 if nothing is stretched", ""});
  }
};

}  // namespace dalembert
