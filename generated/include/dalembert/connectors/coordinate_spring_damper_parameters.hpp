// Generated from specs/connectors/coordinate_spring_damper.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A scalar spring and damper between two coordinates
struct ObjectConnectorCoordinateSpringDamperParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  double stiffness = 0.0;
  double damping = 0.0;
  double offset = 0.0;
  bool activeConnector = true;
  UserFunction springForceUserFunction;
};

struct ObjectConnectorCoordinateSpringDamperVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorCoordinateSpringDamperRecord {
  std::string name;
  ObjectConnectorCoordinateSpringDamperParameters parameters;
  ObjectConnectorCoordinateSpringDamperVisualization visualization;
};

}  // namespace dalembert
