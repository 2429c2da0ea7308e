// Generated from specs/constraints/distance.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// Keeps the distance of two points constant, like a massless rigid rod between two ball joints
struct ObjectConnectorDistanceParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  double distance = 0.0;
  bool activeConnector = true;
};

struct ObjectConnectorDistanceVisualization {
  bool show = true;
  double drawSize = -1.0;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorDistanceRecord {
  std::string name;
  ObjectConnectorDistanceParameters parameters;
  ObjectConnectorDistanceVisualization visualization;
};

}  // namespace dalembert
