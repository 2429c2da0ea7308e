// Generated from specs/bodies/rigid_body.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// rigid body in space with any center of mass, on a node with position and orientation
struct ObjectRigidBodyParameters {
  double physicsMass = 0.0;
  Vec<double, 6> physicsInertia = {};
  Vec<double, 3> physicsCenterOfMass = {};
  NodeIndex nodeNumber;
};

struct ObjectRigidBodyVisualization {
  bool show = true;
  Opaque graphicsDataUserFunction;
  Opaque graphicsData;
};

struct ObjectRigidBodyRecord {
  std::string name;
  ObjectRigidBodyParameters parameters;
  ObjectRigidBodyVisualization visualization;
};

}  // namespace dalembert
