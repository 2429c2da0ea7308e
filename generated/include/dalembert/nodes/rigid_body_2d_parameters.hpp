// Generated from specs/nodes/rigid_body_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// node of a rigid body that moves in the global x-y plane: two displacements and the angle about z
struct NodeRigidBody2DParameters {
  Vec<double, 3> referenceCoordinates = {};
  Vec<double, 3> initialCoordinates = {};
  Vec<double, 3> initialVelocities = {};
};

struct NodeRigidBody2DVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct NodeRigidBody2DRecord {
  std::string name;
  NodeRigidBody2DParameters parameters;
  NodeRigidBody2DVisualization visualization;
};

}  // namespace dalembert
