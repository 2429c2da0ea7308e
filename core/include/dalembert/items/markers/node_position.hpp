// MarkerNodePosition, specs/markers/node_position.toml
#pragma once

#include "dalembert/markers/node_position_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct MarkerNodePosition {
  using Parameters = MarkerNodePositionParameters;
  static constexpr FrameShape shape = FrameShape::point;

  static Vec3<double> local(const Parameters&) { return {}; }
};

}  // namespace dalembert
