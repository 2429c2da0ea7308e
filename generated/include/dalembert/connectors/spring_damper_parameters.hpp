// Generated from specs/connectors/spring_damper.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A spring and a damper that act along the line between two points
struct ObjectConnectorSpringDamperParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  double referenceLength = 0.0;
  double stiffness = 0.0;
  double damping = 0.0;
  double force = 0.0;
  double velocityOffset = 0.0;
  bool activeConnector = true;
  UserFunction springForceUserFunction;
};

struct ObjectConnectorSpringDamperVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorSpringDamperRecord {
  std::string name;
  ObjectConnectorSpringDamperParameters parameters;
  ObjectConnectorSpringDamperVisualization visualization;
};

}  // namespace dalembert
