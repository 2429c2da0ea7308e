// Generated from specs/nodes/rigid_body_rot_vec_lg.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of a rigid body in space: three displacements and a rotation vector that is integrated by Lie group methods
struct NodeRigidBodyRotVecLGParameters {
  Vec<double, 6> referenceCoordinates = {};
  Vec<double, 6> initialCoordinates = {};
  Vec<double, 6> initialVelocities = {};
};

struct NodeRigidBodyRotVecLGVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodeRigidBodyRotVecLGRecord {
  std::string name;
  NodeRigidBodyRotVecLGParameters parameters;
  NodeRigidBodyRotVecLGVisualization visualization;
};

}  // namespace dalembert
