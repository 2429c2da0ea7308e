// Generated from specs/nodes/rigid_body_rxyz.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of a rigid body in space: three displacements and three Tait-Bryan angles about x, y and z in turn
struct NodeRigidBodyRxyzParameters {
  Vec<double, 6> referenceCoordinates = {};
  Vec<double, 6> initialCoordinates = {};
  Vec<double, 6> initialVelocities = {};
};

struct NodeRigidBodyRxyzVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodeRigidBodyRxyzRecord {
  std::string name;
  NodeRigidBodyRxyzParameters parameters;
  NodeRigidBodyRxyzVisualization visualization;
};

}  // namespace dalembert
