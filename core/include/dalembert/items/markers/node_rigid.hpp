// MarkerNodeRigid, specs/markers/node_rigid.toml
#pragma once

#include "dalembert/markers/node_rigid_parameters.hpp"
#include "dalembert/system/physics.hpp"

namespace dalembert {

struct MarkerNodeRigid {
  using Parameters = MarkerNodeRigidParameters;
  static constexpr FrameShape shape = FrameShape::rigid;

  static Vec3<double> local(const Parameters&) { return {}; }
};

}  // namespace dalembert
