// MarkerBodyMass, specs/markers/body_mass.toml
#pragma once

#include "dalembert/markers/body_mass_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct MarkerBodyMass {
  using Parameters = MarkerBodyMassParameters;
  static constexpr FrameShape shape = FrameShape::mass;

  static Vec3<double> local(const Parameters&) { return {}; }
};

}  // namespace dalembert
