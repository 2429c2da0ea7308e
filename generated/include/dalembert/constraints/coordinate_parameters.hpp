// Generated from specs/constraints/coordinate.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Couples two coordinates, or fixes one of them to a value or to a function of time
struct ObjectConnectorCoordinateParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  double offset = 0.0;
  double factorValue1 = 1.0;
  bool velocityLevel = false;
  UserFunction offsetUserFunction;
  UserFunction offsetUserFunction_t;
  bool activeConnector = true;
};

struct ObjectConnectorCoordinateVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorCoordinateRecord {
  std::string name;
  ObjectConnectorCoordinateParameters parameters;
  ObjectConnectorCoordinateVisualization visualization;
};

}  // namespace dalembert
