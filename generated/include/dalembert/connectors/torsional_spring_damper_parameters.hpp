// Generated from specs/connectors/torsional_spring_damper.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A torsional spring and damper about the z axis of a joint frame
struct ObjectConnectorTorsionalSpringDamperParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  NodeIndex nodeNumber;
  double stiffness = 0.0;
  double damping = 0.0;
  Mat<double, 3, 3> rotationMarker0 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  Mat<double, 3, 3> rotationMarker1 = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  double offset = 0.0;
  double velocityOffset = 0.0;
  double torque = 0.0;
  bool activeConnector = true;
  UserFunction springTorqueUserFunction;
};

struct ObjectConnectorTorsionalSpringDamperVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorTorsionalSpringDamperRecord {
  std::string name;
  ObjectConnectorTorsionalSpringDamperParameters parameters;
  ObjectConnectorTorsionalSpringDamperVisualization visualization;
};

}  // namespace dalembert
