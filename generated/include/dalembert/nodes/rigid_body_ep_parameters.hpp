// Generated from specs/nodes/rigid_body_ep.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of a rigid body in space: three displacements and four Euler parameters (unit quaternion)
struct NodeRigidBodyEPParameters {
  Vec<double, 7> referenceCoordinates = {};
  Vec<double, 7> initialCoordinates = {};
  Vec<double, 7> initialVelocities = {};
  bool addConstraintEquation = true;
};

struct NodeRigidBodyEPVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodeRigidBodyEPRecord {
  std::string name;
  NodeRigidBodyEPParameters parameters;
  NodeRigidBodyEPVisualization visualization;
};

}  // namespace dalembert
