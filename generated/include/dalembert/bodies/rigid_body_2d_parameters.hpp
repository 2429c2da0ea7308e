// Generated from specs/bodies/rigid_body_2d.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// rigid body that moves in the global x-y plane, with any center of mass
struct ObjectRigidBody2DParameters {
  double physicsMass = 0.0;
  double physicsInertia = 0.0;
  Vec<double, 2> physicsCenterOfMass = {};
  NodeIndex nodeNumber;
};

struct ObjectRigidBody2DVisualization {
  bool show = true;
  Opaque graphicsDataUserFunction;
  Opaque graphicsData;
};

struct ObjectRigidBody2DRecord {
  std::string name;
  ObjectRigidBody2DParameters parameters;
  ObjectRigidBody2DVisualization visualization;
};

}  // namespace dalembert
