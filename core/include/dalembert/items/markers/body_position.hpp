// MarkerBodyPosition, specs/markers/body_position.toml
#pragma once

#include "dalembert/markers/body_position_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct MarkerBodyPosition {
  using Parameters = MarkerBodyPositionParameters;
  static constexpr FrameShape shape = FrameShape::point;

  static Vec3<double> local(const Parameters& p) { return p.localPosition; }
};

}  // namespace dalembert
