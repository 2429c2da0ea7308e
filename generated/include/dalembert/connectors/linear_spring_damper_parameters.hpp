// Generated from specs/connectors/linear_spring_damper.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A spring and damper along an axis that is fixed to the first marker, as in a prismatic joint
struct ObjectConnectorLinearSpringDamperParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  double stiffness = 0.0;
  double damping = 0.0;
  Vec<double, 3> axisMarker0 = {1.0, 0.0, 0.0};
  double offset = 0.0;
  double velocityOffset = 0.0;
  double force = 0.0;
  bool activeConnector = true;
  UserFunction springForceUserFunction;
};

struct ObjectConnectorLinearSpringDamperVisualization {
  bool show = true;
  double drawSize = -1.0;
  bool drawAsCylinder = false;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorLinearSpringDamperRecord {
  std::string name;
  ObjectConnectorLinearSpringDamperParameters parameters;
  ObjectConnectorLinearSpringDamperVisualization visualization;
};

}  // namespace dalembert
