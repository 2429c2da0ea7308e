// NodePointGround, specs/nodes/point_ground.toml: a point that rests.
#pragma once

#include "dalembert/contracts/element.hpp"
#include "dalembert/nodes/point_ground_parameters.hpp"

namespace dalembert {

struct NodePointGround : NoLieRotations {
  using Parameters = NodePointGroundParameters;
  using Record = NodePointGroundRecord;
  static constexpr std::string_view item = "NodePointGround";
  static constexpr int size = 0;
  static constexpr ElementTraits traits{};

  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, 0>&, const Vec3<double>&) {
    return {.position = p.referenceCoordinates};
  }
  template <class S>
  static Vec<S, 0> pull_back(const Parameters&, const Coordinates<S, 0>&, const Vec3<double>&, const Vec3<S>&,
                             const Vec3<S>&) {
    return {};
  }
};

}  // namespace dalembert
