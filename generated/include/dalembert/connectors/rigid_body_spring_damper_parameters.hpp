// Generated from specs/connectors/rigid_body_spring_damper.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A spring and damper with six components, against relative translation and rotation of two rigid body markers
struct ObjectConnectorRigidBodySpringDamperParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  Mat<double, 6, 6> stiffness = {};
  Mat<double, 6, 6> damping = {};
  Mat<double, 3, 3> rotationMarker0 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Mat<double, 3, 3> rotationMarker1 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Vec<double, 6> offset = {};
  bool intrinsicFormulation = false;
  bool activeConnector = true;
  UserFunction springForceTorqueUserFunction;
  UserFunction postNewtonStepUserFunction;
};

struct ObjectConnectorRigidBodySpringDamperVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorRigidBodySpringDamperRecord {
  std::string name;
  ObjectConnectorRigidBodySpringDamperParameters parameters;
  ObjectConnectorRigidBodySpringDamperVisualization visualization;
};

}  // namespace dalembert
