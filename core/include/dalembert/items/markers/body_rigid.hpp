// MarkerBodyRigid, specs/markers/body_rigid.toml
#pragma once

#include "dalembert/markers/body_rigid_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct MarkerBodyRigid {
  using Parameters = MarkerBodyRigidParameters;
  static constexpr FrameShape shape = FrameShape::rigid;

  static Vec3<double> local(const Parameters& p) { return p.localPosition; }
};

}  // namespace dalembert
