// NodePointSlope1, specs/nodes/point_slope1.toml: position and slope vector; one vector does not define an
// orientation.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/nodes/point_slope1_parameters.hpp"

namespace dalembert {

struct NodePointSlope1 : NoNodeOutputs {
  using Parameters = NodePointSlope1Parameters;
  static constexpr std::string_view item = "NodePointSlope1";
  static constexpr int size = 6;
  static constexpr NodeTraits traits{.translations = 3, .constant_jacobian = true, .oriented = false};

  static void check(const Parameters& p, const ItemLabel& item) {
    Vec3<double> slope = segment<3>(p.referenceCoordinates, 3);
    if (is_zero(slope)) refuse_slope("referenceCoordinates", item);
    slope += segment<3>(p.initialCoordinates, 3);
    if (is_zero(slope)) refuse_slope("initialCoordinates", item);
  }

  template <class S>
  static Motion<S> motion(const Coordinates<S, size>& x) {
    return {.position = segment<3>(x.q, 0), .velocity = segment<3>(x.v, 0), .acceleration = segment<3>(x.a, 0)};
  }
  template <class S>
  static Vec<S, size> pull_back(const Coordinates<S, size>&, const Vec3<S>& force, const Vec3<S>&) {
    return {force[0], force[1], force[2]};
  }

 private:
  [[noreturn]] static void refuse_slope(const char* name, const ItemLabel& item) {
    refuse(ErrorKind::value, {item, name, "the slope vector has no length", "",
                              "a slope vector along the axis, of length 1 if nothing is stretched", ""});
  }
};

}  // namespace dalembert
