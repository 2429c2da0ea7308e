// Generated from specs/connectors/reeving_system_springs.toml by codegen/templates/parameters.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// A massless elastic rope that runs without friction over sheaves and joins two end points
struct ObjectConnectorReevingSystemSpringsParameters {
  std::vector<MarkerIndex> markerNumbers = std::vector<MarkerIndex>(2);
  bool hasCoordinateMarkers = false;
  bool turningEnds = false;
  Vec<double, 2> coordinateFactors = {1.0, 1.0};
  double stiffnessPerLength = 0.0;
  double dampingPerLength = 0.0;
  double dampingTorsional = 0.0;
  double dampingShear = 0.0;
  double regularizationForce = 0.1;
  double referenceLength = 0.0;
  std::vector<Vec<double, 3>> sheavesAxes;
  std::vector<double> sheavesRadii;
  bool activeConnector = true;
};

struct ObjectConnectorReevingSystemSpringsVisualization {
  bool show = true;
  double ropeRadius = 0.001;
  Vec<double, 4> color = {-1.0, -1.0, -1.0, -1.0};
};

struct ObjectConnectorReevingSystemSpringsRecord {
  std::string name;
  ObjectConnectorReevingSystemSpringsParameters parameters;
  ObjectConnectorReevingSystemSpringsVisualization visualization;
};

}  // namespace dalembert
